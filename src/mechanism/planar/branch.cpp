#include "boxbeam/mechanism/planar/branch.hpp"

#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

double measure(const TurnSign& turn, const Eigen::VectorXd& q) {
  const Eigen::Vector2d from = position_of(turn.from, q);
  const Eigen::Vector2d u = position_of(turn.via, q) - from;
  const Eigen::Vector2d w = position_of(turn.to, q) - from;
  return u.x() * w.y() - u.y() * w.x();
}

double measure(const AlongSign& along, const Eigen::VectorXd& q) {
  const Eigen::Vector2d vector = position_of(along.to, q) - position_of(along.from, q);
  return vector.x() * std::cos(along.direction) + vector.y() * std::sin(along.direction);
}

int sign_of(double x) { return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0); }

}  // namespace

double measure_of(const Loop& loop, const Eigen::VectorXd& q) {
  return std::visit([&](const auto& kind) { return measure(kind, q); }, loop.measure);
}

std::vector<int> branch_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::vector<int> signs;
  for (const Loop& loop : mechanism.loops) {
    signs.push_back(sign_of(measure_of(loop, q)));
  }
  return signs;
}

bool on_branch(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  for (const Loop& loop : mechanism.loops) {
    if (!(measure_of(loop, q) * loop.sign > 0.0)) return false;
  }
  return true;
}

std::string loops_off_branch(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::string names;
  for (const Loop& loop : mechanism.loops) {
    const double value = measure_of(loop, q);
    if (value * loop.sign > 0.0) continue;
    names += (names.empty() ? "loop " : ", loop ") + loop.name;
  }
  return names;
}

}  // namespace boxbeam::planar
