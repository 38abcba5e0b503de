#include "repeated_vibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace boxbeam {
namespace {

bool act_at_same_places(const BeamLoads& a, const BeamLoads& b) {
  return a.lines.size() == b.lines.size() &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const PointLoad& one, const PointLoad& other) { return one.s == other.s; });
}

}  // namespace

double size_of_loads(const BeamLoads& loads, double length) {
  double size = 0.0;
  for (const PointLoad& load : loads.points)
    size = std::max({size, load.force.norm(), load.moment.norm() / length});
  double along = 0.0;
  for (const LineLoad& line : loads.lines) {
    const double part = line.length.value();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along += part * std::abs(line.force[axis](0.0)) + part * std::abs(line.force[axis](part)) +
               part / length * std::abs(line.couple[axis](0.0)) +
               part / length * std::abs(line.couple[axis](part));
    }
  }
  return std::max(size, along);
}

std::vector<BeamLoads> in_basis(const std::vector<BeamLoads>& modes, const Eigen::MatrixXd& turn) {
  std::vector<BeamLoads> turned;
  for (Eigen::Index m = 0; m < turn.cols(); ++m) {
    BeamLoads& of = turned.emplace_back(modes.front());
    unload(of);
    add(of, turn(0, m), modes.front());
    for (Eigen::Index j = 1; j < turn.rows(); ++j)
      add_mode(of, turn(j, m), modes[static_cast<std::size_t>(j)]);
  }
  return turned;
}

RepeatedVibration::RepeatedVibration(const RigidMotion& rigid, double length, ModalMotion solved,
                                     std::vector<AddedLoads> added)
    : rigid_(rigid.loads),
      begin_(rigid.motion->begin),
      period_(rigid.motion->period),
      length_(length),
      solved_(std::move(solved)),
      added_(std::move(added)) {
  for (const AddedLoads& of : added_) largest_ = std::max(largest_, of.to_rigid);
}

Eigen::VectorXd RepeatedVibration::between(const Eigen::MatrixXd& values, double time) const {
  return trigonometric_at(values, (time - begin_) / period_);
}

BeamLoads RepeatedVibration::rigid_at(Time time, const AddedLoads& on) const {
  BeamLoads loads = rigid_(time);
  loads.lines = on_stretches_of(loads.lines, on.bent.lines);
  return loads;
}

std::optional<BeamLoads> RepeatedVibration::loads_at(Time time) const {
  constexpr std::size_t nodes = 12, before = nodes / 2 - 1;
  constexpr double same = 1e-7, beside = 1e-3;
  const std::size_t n = added_.size();
  if (n < 2 * nodes) return std::nullopt;
  const auto count = static_cast<double>(n);
  double place = (time.value() - begin_) / period_ * count;
  place -= count * std::floor(place / count);
  const auto nearest = static_cast<std::size_t>(std::lround(place)) % n;
  const Eigen::VectorXd dynamic = dynamic_at(time.value());
  Eigen::VectorXd speed;
  if (!added_.front().dampers.empty()) speed = speed_at(time.value());
  const auto add_to = [&](BeamLoads& sum, double factor, const AddedLoads& of) {
    add_mode(sum, factor, of.bent);
    for (std::size_t m = 0; m < of.modes.size(); ++m)
      add_mode(sum, factor * dynamic[static_cast<Eigen::Index>(m)], of.modes[m]);
    for (const JointDamper& damper : of.dampers)
      add_mode(sum, factor * damper.damping * damper.gaps.dot(speed), damper.loads);
  };
  if (time.value() == added_[nearest].time) {
    BeamLoads loads = rigid_at(time, added_[nearest]);
    add_to(loads, 1.0, added_[nearest]);
    return loads;
  }
  const double within = place - std::floor(place);
  if (std::min(within, 1.0 - within) < beside) return std::nullopt;
  const std::size_t first = static_cast<std::size_t>(std::floor(place)) + n - before;
  const double u = static_cast<double>(before) + within;
  std::array<double, nodes> whole{};
  std::array<double, nodes - 2> part{};
  std::iota(whole.begin(), whole.end(), 0.0);
  std::iota(part.begin(), part.end(), 0.0);
  const auto weights = lagrange_weights(whole, u);
  const auto fewer = lagrange_weights(part, u - 1.0);
  const AddedLoads& reference = added_[first % n];
  BeamLoads loads = rigid_at(time, reference), apart;
  apart.lines = loads.lines;
  unload(apart);
  for (std::size_t i = 0; i < nodes; ++i) {
    const AddedLoads& at = added_[(first + i) % n];
    if (!act_at_same_places(at.bent, reference.bent)) return std::nullopt;
    const bool among_fewer = i > 0 && i + 1 < nodes;
    add_to(loads, weights[i], at);
    add_to(apart, weights[i] - (among_fewer ? fewer[i - 1] : 0.0), at);
  }
  if (!(size_of_loads(apart, length_) <= same * largest_)) return std::nullopt;
  return loads;
}

}  // namespace boxbeam
