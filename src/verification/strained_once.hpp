#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "boxbeam/numerics/chebyshev_curve.hpp"
#include "open_motion.hpp"

namespace boxbeam {

/// What strains elastic bodies in a motion that does not repeat, cut forces as one column, and what
/// modes do that are taken for all of it: each follows it from its beginning and, where the motion
/// ends at rest, a period and a half of the slowest behind it.
class StrainedOnce {
 public:
  using StrainingAt = std::function<Eigen::VectorXd(double time)>;

  /// `accuracy`: of the column, between the instants. Asks at construction only.
  StrainedOnce(OpenMotion motion, const StrainingAt& straining,
               const ChebyshevCurve::Accuracy& accuracy);

  /// eta + (C eta' - p)/omega^2 of each mode at the ends of steps, a column each. `work`: what the
  /// column of cut forces does on the modes, a row each; frequencies [Hz]; damping [1/s].
  Eigen::MatrixXd dynamic_parts(const Eigen::MatrixXd& work, const Eigen::VectorXd& frequencies,
                                const Eigen::VectorXd& damping) const;

 private:
  OpenMotion motion_;
  ChebyshevCurve curve_;
  ModalState before_;  ///< the column and its rate, which modes follow statically
  std::optional<Eigen::VectorXd> behind_;  ///< where the motion ends at rest
};

}  // namespace boxbeam
