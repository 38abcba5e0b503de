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
  std::vector<double> borders = motion_.borders;
  const double end = borders.back();
  const ChebyshevCurve forces = curve_.mapped(work);
  const Eigen::VectorXd behind = behind_ ? work * *behind_ : Eigen::VectorXd();
  const auto force_at = [&](double time) { return time <= end ? forces.at(time) : behind; };
  if (behind_) borders.push_back(borders.back() + watched_periods / frequencies.minCoeff());
  const double length = borders.back() - borders.front();
  const double step =
      std::max(1.0 / (steps_to_a_period * frequencies.maxCoeff()), length / most_steps);
  UncoupledResponse response = uncoupled_response(
      force_at, damping, squares, borders,
      {(work * before_.eta).cwiseQuotient(squares), (work * before_.speed).cwiseQuotient(squares)},
      step);
  Eigen::MatrixXd parts = std::move(response.eta);
  for (Eigen::Index i = 0; i < parts.rows(); ++i) {
    const Eigen::VectorXd speed = response.speed.row(i);
    const Eigen::VectorXd beyond =
        damping.cwiseProduct(speed) - force_at(response.times[static_cast<std::size_t>(i)]);
    parts.row(i) += beyond.cwiseQuotient(squares).transpose();
  }
  return parts;
}

}  // namespace boxbeam
