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
    const double first = of.from + of.speed * time;
    for (const Wheels::Wheel& wheel : of.wheels) {
      const double s = first - wheel.behind;
      // What stands on an end is on the member; round-off of the time must not lift it off.
      const double rounding = 1e-12 * length;
      if (s < -rounding || s > length + rounding) continue;
      const Place at{of.member, {std::clamp(s, 0.0, length), of.y, of.z}};
      loads.points.push_back({action.name, {at, factor * wheel.force, Eigen::Vector3d::Zero()}});
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
