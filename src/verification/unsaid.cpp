#include "boxbeam/verification/unsaid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/verification/front_end.hpp"

namespace boxbeam {
namespace {

/// A plate of a profile, by which two are compared at a border.
struct PlateThickness {
  const char* name;
  Length of;
};

struct PlatesOf {
  std::vector<PlateThickness> operator()(const Box& box) const {
    return {{"top flange", box.top_flange},
            {"bottom flange", box.bottom_flange},
            {"left web", box.left_web},
            {"right web", box.right_web}};
  }
  std::vector<PlateThickness> operator()(const RectangularTube& tube) const {
    return {{"wall", tube.wall}};
  }
  std::vector<PlateThickness> operator()(const RoundTube& tube) const {
    return {{"wall", tube.wall}};
  }
  /// Full sections have no plate that is joined, walls of paths no names.
  template <class Other>
  std::vector<PlateThickness> operator()(const Other&) const {
    return {};
  }
};

/// "top flange 20 and 40 mm", of the first plate whose thickness steps; "" where none does.
std::string step_between(const Profile& behind, const Profile& ahead) {
  if (behind.index() != ahead.index()) return "";
  const std::vector<PlateThickness> from = std::visit(PlatesOf{}, behind);
  const std::vector<PlateThickness> to = std::visit(PlatesOf{}, ahead);
  // What rounding of units makes is no step.
  const Length least = si<Length>(1e-6);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (abs(from[i].of - to[i].of) <= least) continue;
    return fmt::format("{}, {:.4g} and {:.4g} mm", from[i].name, 1e3 * from[i].of.value(),
                       1e3 * to[i].of.value());
  }
  return "";
}

bool is_said(const Project& project, Length s) {
  const Length near = 1e-9 * project.beam.length();
  const auto lies_there = [&](const BeamDetail& of) {
    return of.from <= s + near && of.to >= s - near;
  };
  const auto stands_there = [&](const WeldInput& of) { return abs(of.s - s) <= near; };
  return std::any_of(project.fatigue.details.begin(), project.fatigue.details.end(), lies_there) ||
         std::any_of(project.welds.begin(), project.welds.end(), stands_there);
}

/// Whether forces move what carries the beam: how it goes on after the time looked at is not known.
bool forces_move(const Project& project, const SituationRun& run) {
  if (run.loads.closed() || run.loads.is_recorded()) return false;
  if (const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism))
    return std::any_of(space->joints.begin(), space->joints.end(), spatial::is_forced);
  return std::holds_alternative<planar::Mechanism>(project.mechanism) &&
         planar_motion_of(run).freedom.undriven > 0;
}

}  // namespace

bool judged_in_fatigue(const std::vector<CheckResult>& checks) {
  using enum Criterion;
  return std::any_of(checks.begin(), checks.end(), [](const CheckResult& of) {
    return of.check.criterion == fatigue || of.check.criterion == shear_fatigue ||
           of.check.criterion == combined_fatigue;
  });
}

std::vector<NotJudged> unsaid_joints_of(const Project& project) {
  std::vector<NotJudged> unsaid;
  const std::vector<Segment>& segments = project.beam.segments;
  if (!project.fatigue.asked || !project.given_stresses.empty()) return unsaid;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Length s = segments[i].start;
    const std::string step = step_between(segments[i - 1].to.outer, segments[i].from.outer);
    if (step.empty() || is_said(project, s)) continue;
    unsaid.push_back({Criterion::fatigue,
                      fmt::format("joint at s = {:.6g} m in fatigue", s.value()),
                      fmt::format("the weld of plates of unlike thickness ({}) is not said: a "
                                  "detail of EN 1993-1-9, table 8.3, in [[fatigue.details]]",
                                  step)});
  }
  return unsaid;
}

std::vector<NotJudged> unfinished_motion_of(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            const std::vector<CheckResult>& checks) {
  const auto worst = std::find_if(checks.begin(), checks.end(), [](const CheckResult& of) {
    return of.check.on_beam && of.check.criterion != Criterion::deflection;
  });
  if (worst == checks.end()) return {};
  const Check& check = worst->check;
  for (const SituationRun& run : runs) {
    if (!check.situation.empty() && check.situation != run.situation->name) continue;
    const Time end = run.loads.begin() + run.loads.period();
    if (!forces_move(project, run) || check.time < end - 1e-6 * run.loads.period()) continue;
    return {{check.criterion, "the motion",
             fmt::format("its last instant, {:.6g} s, is that of the largest use; what follows is "
                         "not looked at ([motion] duration)",
                         end.value())}};
  }
  return {};
}

std::vector<Gate> weld_gates_of(const Project& project) {
  std::vector<Gate> gates;
  for (const WeldInput& weld : project.welds) {
    const Extent of = extent_of(weld.around);
    const auto holds = [&](Side side) {
      const Extent beam = extent_of(section_at(project.beam, {weld.s, side}).outer);
      constexpr double slack = 1.01;
      return of.y_high - of.y_low <= slack * (beam.y_high - beam.y_low) &&
             of.z_high - of.z_low <= slack * (beam.z_high - beam.z_low);
    };
    if (holds(Side::before) || holds(Side::behind)) continue;
    gates.push_back({"", "",
                     fmt::format("weld \"{}\" at s = {:.6g} m goes around a profile that is larger "
                                 "than the beam on either side: it is no weld of the beam",
                                 weld.name, weld.s.value()),
                     true});
  }
  return gates;
}

}  // namespace boxbeam
