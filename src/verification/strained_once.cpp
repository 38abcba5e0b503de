#include "strained_once.hpp"

#include <algorithm>

#include "boxbeam/core/angle.hpp"

namespace boxbeam {

StrainedOnce::StrainedOnce(OpenMotion motion, const StrainingAt& straining,
                           const ChebyshevCurve::Accuracy& accuracy)
    : motion_(std::move(motion)),
      curve_(straining, {motion_.borders, 8.0 * motion_.step(), motion_.step()}, accuracy),
      before_(state_at_begin(motion_, straining)) {
  if (motion_.rests_behind) behind_ = straining(motion_.behind());
}

Eigen::MatrixXd StrainedOnce::dynamic_parts(const Eigen::MatrixXd& work,
                                            const Eigen::VectorXd& frequencies,
                                            const Eigen::VectorXd& damping) const {
  constexpr double steps_to_a_period = 20.0, most_steps = 4000.0, watched_periods = 1.5;
  const Eigen::VectorXd squares = (full_turn * frequencies).array().square();
  const Eigen::MatrixXd stiffness = squares.asDiagonal(), viscous = damping.asDiagonal();
  std::vector<double> borders = motion_.borders;
  const double end = borders.back();
  const auto force_at = [&](double time) -> Eigen::VectorXd {
    return work * (time <= end ? curve_.at(time) : *behind_);
  };
  const auto equations = [&](double time) -> ModalEquations {
    return {viscous, stiffness, force_at(time)};
  };
  if (behind_) borders.push_back(borders.back() + watched_periods / frequencies.minCoeff());
  const double length = borders.back() - borders.front();
  const double step =
      std::max(1.0 / (steps_to_a_period * frequencies.maxCoeff()), length / most_steps);
  const TransientResponse response(equations, borders,
                                   ModalState{(work * before_.eta).cwiseQuotient(squares),
                                              (work * before_.speed).cwiseQuotient(squares)},
                                   step);
  const std::vector<double>& times = response.times();
  Eigen::MatrixXd parts(static_cast<Eigen::Index>(times.size()), work.rows());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const ModalState& at = response.states()[i];
    const Eigen::VectorXd beyond = viscous * at.speed - force_at(times[i]);
    parts.row(static_cast<Eigen::Index>(i)) = (at.eta + beyond.cwiseQuotient(squares)).transpose();
  }
  return parts;
}

}  // namespace boxbeam
