#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/elastic_joint.hpp"
#include "boxbeam/project/project.hpp"

/// What is elastic of a mechanism in space: its beams, rods that are bodies, rods without mass and
/// joints that give way.
namespace boxbeam {

/// An elastic beam, or a rod that is a body.
struct ElasticMember {
  const TaperedBeam* beam = nullptr;
  spatial::BeamPlacement placement;
  double youngs_modulus = 0.0, shear_modulus = 0.0;  ///< [Pa]
  /// Of a rod, along it: it has the mass, the centre and all moments of inertia of its body. Of a
  /// beam nothing: those of its sections.
  std::vector<SegmentMass> masses = {};
  /// A rod that turns freely about two axes at either end and that nothing loads between these:
  /// pressed, it bows by itself.
  bool bows_alone = false;

  /// As the loads on it have it.
  spatial::BeamBody body_in(const spatial::Mechanism& mechanism) const;
};

/// Those of a case in a mechanism of one of its situations, the verified beam first; without rods
/// that count as rigid. `project` stays.
std::vector<ElasticMember> elastic_members(const Project& project,
                                           const spatial::Mechanism& mechanism);

/// Why a rod that is a body in space counts as rigid; "" where it is elastic.
std::string obstacle_to_rod(const Project& project, const ElasticBeside& of, const RodBody& rod);

/// A spring with a damper beside it [N/m, N s/m or N m/rad, N m s/rad].
struct Give {
  double stiffness = std::numeric_limits<double>::infinity(), damping = 0.0;
};

/// How the ways of a joint give: along its axis, across it, about it, and about two directions
/// across it, of which the first is the first axis of a universal joint.
struct WaysToGive {
  Give along = {}, across = {}, about = {}, first_tilt = {}, second_tilt = {};
};

/// Whether any does.
bool gives_way(const WaysToGive& ways);

/// Joints and rods without mass that give way.
class GivingWay {
 public:
  GivingWay() = default;
  explicit GivingWay(const Project& project);

  bool empty() const { return joints_.empty() && lines_.empty(); }
  bool is_damped() const;  ///< whether any is

  /// Of a joint of several movements the last of them gives way.
  WaysToGive of(const spatial::Joint& joint) const;
  /// Of a distance along its line, at its length then [m].
  WaysToGive of(const spatial::ClosingJoint& joint, double length) const;

 private:
  struct NamedJoint {
    std::string name;
    spatial::ElasticJoint of;
  };
  struct Line {
    std::string joint;
    double EA = 0.0;           ///< [N]
    double retardation = 0.0;  ///< [s]
  };
  std::vector<NamedJoint> joints_;
  std::vector<Line> lines_;
};

/// Whether springs may take loads over from a beam that bends: all else is held in one way, and
/// bears what balance says.
bool has_springs(const spatial::Mechanism& mechanism);

}  // namespace boxbeam
