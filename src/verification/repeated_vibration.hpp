#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/verification/elastic_motion.hpp"
#include "modal_motion.hpp"

namespace boxbeam {

/// What elasticity adds to the loads of a rigid beam at an instant: by static bending, by each mode
/// of the basis per unit, and by dampers, whose gaps are by this basis.
struct AddedLoads {
  double time = 0.0;      ///< [s]
  double to_rigid = 0.0;  ///< the size of those of the rigid beam [N]
  BeamLoads bent;
  std::vector<BeamLoads> modes;
  std::vector<JointDamper> dampers;
};

/// How large loads are: the largest force of all that is in them, moments over a length [N].
double size_of_loads(const BeamLoads& loads, double length);

/// Of each mode of a basis, from those of a posture's own. `turn`: as of `ModalPosture`.
std::vector<BeamLoads> in_basis(const std::vector<BeamLoads>& modes, const Eigen::MatrixXd& turn);

/// Vibration over a planar motion that repeats, and the loads of the beam by it between the
/// instants at which they are known.
class RepeatedVibration {
 public:
  /// `length`: of the beam [m]; `added`: at equal steps of the motion, or nothing.
  RepeatedVibration(const RigidMotion& rigid, double length, ModalMotion solved,
                    std::vector<AddedLoads> added);

  const Eigen::MatrixXd& coordinates() const { return solved_.eta; }
  /// `ModalMotion::dynamic` and `speed` at any time.
  Eigen::VectorXd dynamic_at(double time) const { return between(solved_.dynamic, time); }
  Eigen::VectorXd speed_at(double time) const { return between(solved_.speed, time); }

  /// At an instant that is known as it was found; between them by the polynomial through what
  /// elasticity adds at twelve of them around, where one through ten says the same. Nothing where
  /// it does not, as beside a jump of the loads.
  std::optional<BeamLoads> loads_at(Time time) const;

 private:
  Eigen::VectorXd between(const Eigen::MatrixXd& values, double time) const;
  /// Those of the rigid beam at a time, on the pieces of what is added.
  BeamLoads rigid_at(Time time, const AddedLoads& on) const;

  LoadsAt rigid_;
  double begin_, period_, length_;
  ModalMotion solved_;
  std::vector<AddedLoads> added_;
  double largest_ = 0.0;  ///< of the rigid beam's loads [N]
};

}  // namespace boxbeam
