#include "boxbeam/mechanism/planar/branch.hpp"

#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

/// The measure where `place` gives the place of an attachment.
template <class Place>
struct Measure {
  const Place& place;

  double operator()(const TurnSign& turn) const {
    const Eigen::Vector2d from = place(turn.from);
    const Eigen::Vector2d u = place(turn.via) - from;
    const Eigen::Vector2d w = place(turn.to) - from;
    return u.x() * w.y() - u.y() * w.x();
  }

  double operator()(const AlongSign& along) const {
    const Eigen::Vector2d vector = place(along.to) - place(along.from);
    return vector.x() * std::cos(along.direction) + vector.y() * std::sin(along.direction);
  }
};

template <class Place>
bool all_on_branch(const Mechanism& mechanism, const Place& place) {
  for (const Loop& loop : mechanism.loops) {
    if (!(std::visit(Measure<Place>{place}, loop.measure) * loop.sign > 0.0)) return false;
  }
  return true;
}

int sign_of(double x) { return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0); }

}  // namespace

double measure_of(const Loop& loop, const Eigen::VectorXd& q) {
  const auto place = [&](const Attachment& point) { return position_of(point, q); };
  return std::visit(Measure<decltype(place)>{place}, loop.measure);
}

std::vector<int> branch_of(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::vector<int> signs;
  for (const Loop& loop : mechanism.loops) {
    signs.push_back(sign_of(measure_of(loop, q)));
  }
  return signs;
}

bool on_branch(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  return all_on_branch(mechanism, [&](const Attachment& point) { return position_of(point, q); });
}

bool on_branch(const Mechanism& mechanism, const ConstraintEquations& at) {
  return all_on_branch(mechanism, [&](const Attachment& point) { return at.place_of(point); });
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
