#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/planar_links.hpp"

namespace boxbeam {

/// A bent beam: nodes and the middles of its elements in the axes of its body, a column each, and
/// how far their sections are turned against these.
struct BentAxis {
  Eigen::Matrix2Xd node, middle;
  Eigen::VectorXd angle, middle_angle;
};

/// The elastic beam of a planar mechanism divided into elements that strain evenly, with nodes
/// where joints and forces take hold of it, and how the mechanism meets it when it is bent, however
/// far. Source: Reissner, ZAMP 23 (1972), for the strains.
class DividedAxis {
 public:
  /// With the strains of its middle.
  struct Element {
    double length = 0.0, EA = 0.0, GA = 0.0, EI = 0.0, mass = 0.0, rotary = 0.0;  ///< SI
  };
  /// Stretch, shear and curvature, a column for each element.
  using Strains = Eigen::Matrix3Xd;

  /// Precondition: no obstacle.
  DividedAxis(const planar::Mechanism& mechanism, const ElasticBody& elastic);

  const std::vector<double>& nodes() const { return s_; }  ///< s of each [m]
  const std::vector<Element>& elements() const { return elements_; }
  /// Nodes at which groups of elements begin and end: everything that takes hold is at one.
  const std::vector<std::size_t>& groups() const { return groups_; }
  /// The node of an attachment of the straight beam.
  Eigen::Index node_of(const planar::Attachment& at) const;
  /// Nodes of the outermost attachments.
  const std::pair<Eigen::Index, Eigen::Index>& held() const { return held_; }

  /// The axis with these strains. Its body's frame is that of the section whose angle a joint
  /// holds, or of the first attachment.
  BentAxis bent(const Strains& strains) const;
  const BentAxis& straight() const { return straight_; }
  /// The mechanism whose beam is so bent: its attachments are moved.
  planar::Mechanism with(const BentAxis& axis) const;

 private:
  Eigen::Index node_at(double s) const;

  const planar::Mechanism* mechanism_;
  const ElasticBody* elastic_;
  std::vector<double> s_;
  std::vector<Element> elements_;
  std::vector<std::size_t> groups_;
  std::pair<Eigen::Index, Eigen::Index> held_;
  Eigen::Index reference_ = 0;  ///< node whose section is the body's frame
  BentAxis straight_;
};

/// Why the mechanism is not known when its beam is bent: bodies that move along it, or its angle
/// held at two places; "" where it is.
std::string obstacle_to_bent_axis(const planar::Mechanism& mechanism, int beam);

}  // namespace boxbeam
