#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/beam_shift.hpp"

namespace boxbeam {

/// How a piece of the beam bends and shears under its cut forces, at the nodes of Gauss' rule.
struct FlexibilityPiece {
  static constexpr std::size_t nodes = 5;

  Length start, length;
  /// Curvatures of the axis along y and z, a row each, per N, M_y and M_z [1/(N m), 1/(N m^2)].
  std::array<Eigen::Matrix<double, 2, 3>, nodes> curvature;
  std::array<Eigen::Vector2d, nodes> shear;  ///< 1/(G A_v) along y and z [1/N]
};

/// The beam as it bends: a sixteenth of a segment each piece, in order.
///
/// kappa is the slope of the normal stress along an axis over E: in unsymmetric sections it depends
/// on both moments, where the centroid lies off the axis on N too (normal_stress_plane). A_v: EN
/// 1993-1-1 6.2.6 (webs of boxes along z, flanges along y, 2 A/pi of round tubes, 5/6 of solid
/// plates). Holes are left out.
struct DeflectionModel {
  std::vector<FlexibilityPiece> pieces;
  MeasuredFrom against;
  bool in_space = false;  ///< the axis bends along y as well
};

DeflectionModel deflection_model_of(const Project& project);

/// The bent axis, along y and z, from the line that it is measured from. Between the ends of a
/// stretch it is the cubic of both places and slopes.
struct DeflectedLine {
  struct Stretch {
    Length from, to;
    Eigen::Vector2d at_from, at_to;  ///< [m]
    Eigen::Vector2d slope_from, slope_to;
  };
  std::vector<Stretch> stretches;  ///< in order, from the start of the beam to its end

  Eigen::Vector2d at(Length s) const;  ///< along y and z [m]
};

/// A place of a line and how far it lies off, without sign.
struct LargestDeflection {
  Length at, size;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< y and z [m]
};

LargestDeflection largest_of(const DeflectedLine& line);

/// Timoshenko's beam, integrated along the axis (Gauss' rule on every stretch between loads, ends
/// of segments and ends of the line that is measured from):
///
///     theta' = -kappa,  w' = theta + V/(G A_v),  kappa = M/(E I)
///
/// along z, and along y in space. The rotation theta is that of the sections. From a chord: w less
/// the straight line through both ends; from a tangent at a: w less w(a) + theta(a) (s - a), as of
/// a beam clamped there; from the unloaded axis: w with the shift and the turn of the beam's start.
/// Heat bends it besides.
/// Source: Timoshenko, Strength of Materials I, articles 38 and 39.
///
/// It is divided where its cut forces jump or the line is measured from: once for all instants at
/// which they do so at the same places.
class DividedBeam {
 public:
  /// The model stays.
  explicit DividedBeam(const DeflectionModel& model) : model_(&model) {}

  DeflectedLine line_under(const CutForceDiagram& diagram, const BeamShift& shift = {});

  /// Bends and shears of a piece at any place of it, by the polynomial through its nodes.
  struct Flexibility {
    Eigen::Matrix<double, 2, 3> curvature = Eigen::Matrix<double, 2, 3>::Zero();
    Eigen::Vector2d shear = Eigen::Vector2d::Zero();
  };
  /// A stretch of a piece without a jump of cut forces inside: its flexibility where it is asked
  /// for.
  struct Part {
    double from = 0.0, to = 0.0;
    Flexibility at_from, at_to;
    std::array<Flexibility, FlexibilityPiece::nodes> at;  ///< of Gauss' rule
  };

 private:
  const std::vector<Part>& parts_under(const CutForceDiagram& diagram);
  /// The ends of a piece and the borders within it.
  std::vector<double> borders_in(const FlexibilityPiece& piece) const;

  const DeflectionModel* model_;
  std::vector<double> jumps_;
  std::vector<Part> parts_;
};

}  // namespace boxbeam
