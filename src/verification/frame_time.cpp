#include "frame_time.hpp"

#include <algorithm>

#include "boxbeam/core/units.hpp"

namespace boxbeam {
namespace {

std::vector<const frame::Wheels*> wheels_in(const frame::Structure& structure) {
  std::vector<const frame::Wheels*> all;
  for (std::size_t k = 0; k < structure.cases.size(); ++k) {
    if (structure.factors[k] == 0.0) continue;
    for (const frame::Action& action : structure.cases[k].actions) {
      if (const auto* wheels = std::get_if<frame::Wheels>(&action.kind)) all.push_back(wheels);
    }
  }
  return all;
}

}  // namespace

std::optional<TimeSpan> time_of_loads(const frame::Structure& structure) {
  std::optional<TimeSpan> time;
  const std::vector<DriverUse> functions = functions_of(structure);
  if (!functions.empty()) time = time_span_of(functions, structure.duration);
  for (const frame::Wheels* wheels : wheels_in(structure)) {
    if (!time) time.emplace();
    time->length = std::max(time->length, wheels->duration());
    time->closed = false;
  }
  return time;
}

std::vector<Time> passages_of(const frame::Structure& structure) {
  std::vector<Time> times;
  for (const frame::Wheels* of : wheels_in(structure)) {
    const frame::Member& member = structure.members[static_cast<std::size_t>(of->member)];
    std::vector<double> places{0.0};
    for (const Segment& segment : member.beam.segments) places.push_back(segment.end().value());
    for (const frame::Joint& joint : structure.joints) {
      for (const frame::Place* at : {&joint.a, &joint.b}) {
        if (at->member == of->member) places.push_back(at->p.x());
      }
    }
    for (const frame::Wheels::Wheel& wheel : of->wheels) {
      for (const double place : places) {
        const double time = (place + wheel.behind - of->from) / of->speed;
        if (time > 0.0 && time < of->duration()) times.push_back(si<Time>(time));
      }
    }
  }
  std::sort(times.begin(), times.end());
  const auto close = [](Time a, Time b) { return b - a < 1e-9 * second; };
  times.erase(std::unique(times.begin(), times.end(), close), times.end());
  return times;
}

frame::Structure acting_part_of(const frame::Structure& structure, bool that_changes) {
  frame::Structure of = structure;
  for (frame::LoadCase& in : of.cases) {
    std::erase_if(in.actions, [&](const frame::Action& action) {
      return changes_over_time(action) != that_changes;
    });
  }
  return of;
}

}  // namespace boxbeam
