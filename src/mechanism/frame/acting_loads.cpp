#include <algorithm>

#include "boxbeam/mechanism/frame/statics.hpp"

namespace boxbeam::frame {
namespace {

/// Adds an action so many times, as it acts at a time.
struct AddAction {
  const Structure& structure;
  const Action& action;
  double factor, time;
  ActingLoads& loads;

  void operator()(const OwnWeight&) const { loads.weight += factor; }
  void operator()(const PointAction& of) const {
    loads.points.push_back({action.name, {of.at, factor * of.force, factor * of.moment}});
  }
  void operator()(const DrivenAction& of) const {
    const Eigen::Vector3d load = factor * driver_at(of.size, time).value * of.direction;
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    loads.points.push_back(
        {action.name, {of.at, of.couple ? none : load, of.couple ? load : none}});
  }
  void operator()(const LineAction& of) const {
    loads.lines.push_back({of.member, of.from, of.to, factor * of.at_from, factor * of.at_to});
  }
  void operator()(const HeatAction& of) const {
    loads.heat.push_back({of.member, factor * of.mean, factor * of.along_y, factor * of.along_z});
  }
  void operator()(const Settlement& of) const {
    loads.settlements.push_back({of.joint, factor * of.shift, factor * of.turn});
  }
  void operator()(const Wheels& of) const {
    const Member& member = structure.members[static_cast<std::size_t>(of.member)];
    const double length = member.beam.length().value();
    // Beside the places that they start from, run over and end at, never on one: what stands on a
    // support or another load cannot be told from it, and where it goes on from there, neither.
    // What reaches the end of the member stands on it.
    const double beside = 1e-10 * length;
    const double first = std::min(of.from + of.speed * time, of.to - 2.0 * beside);
    std::size_t part = 0;
    for (const Wheels::Wheel& wheel : of.wheels) {
      ++part;
      const double s = first - wheel.behind + beside;
      if (s < 0.0 || s > length + 2.0 * beside) continue;
      const Place at{of.member, {std::min(s, length - beside), of.y, of.z}};
      loads.points.push_back(
          {action.name, {at, factor * wheel.force, Eigen::Vector3d::Zero()}, part});
    }
  }
};

}  // namespace

ActingLoads acting_at(const Structure& structure, double time) {
  ActingLoads loads;
  for (std::size_t k = 0; k < structure.cases.size(); ++k) {
    const double factor = structure.factors[k];
    if (factor == 0.0) continue;
    for (const Action& action : structure.cases[k].actions)
      std::visit(AddAction{structure, action, factor, time, loads}, action.kind);
  }
  return loads;
}

}  // namespace boxbeam::frame
