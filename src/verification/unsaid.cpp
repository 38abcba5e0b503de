#include "boxbeam/verification/unsaid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "boxbeam/fatigue/size_effect.hpp"
#include "boxbeam/project/attachment_welds.hpp"
#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/section/outline.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/unseen_time.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "fast_loads.hpp"
#include "open_motion.hpp"
#include "plate_steps.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

/// A plate of a profile, by which two are compared at a border.
struct PlateThickness {
  const char* name;
  Length of;
  DetailPlace on;  ///< details of which hold in it
};

struct PlatesOf {
  std::vector<PlateThickness> operator()(const Box& box) const {
    using enum DetailPlace;
    return {{"top flange", box.top_flange, fibres},
            {"bottom flange", box.bottom_flange, fibres},
            {"left web", box.left_web, webs},
            {"right web", box.right_web, webs}};
  }
  std::vector<PlateThickness> operator()(const RectangularTube& tube) const {
    return {{"wall", tube.wall, DetailPlace::fibres}};
  }
  std::vector<PlateThickness> operator()(const RoundTube& tube) const {
    return {{"wall", tube.wall, DetailPlace::fibres}};
  }
  /// Full sections have no plate that is joined; walls of paths are found by where they lie.
  template <class Other>
  std::vector<PlateThickness> operator()(const Other&) const {
    return {};
  }
};

/// The splice of two thicknesses.
BeamDetail splice_of(Length a, Length b) {
  BeamDetail splice;
  splice.detail = detail_of_row("8.3/17", "splice of two thicknesses");
  const Length thinner = std::min(a, b), thicker = std::max(a, b);
  splice.detail.size_factor =
      size_factor_of_eccentric_butt_weld(thinner, thicker, 0.5 * (thicker - thinner));
  return splice;
}

/// Whether a plate at a station is judged by a detail of that place, no longer than the section is
/// deep, or by one so weak, or weaker.
bool is_judged_by(const Project& project, Length s, DetailPlace on, const BeamDetail& splice) {
  const Length near = 1e-9 * project.beam.length();
  const auto is_so_weak = [&](const BeamDetail& of) {
    return !of.detail.in_plates && is_nowhere_stronger(of, splice);
  };
  const Extent extent = extent_of(section_at(project.beam, {s, Side::behind}).outer);
  const Length short_one = std::max(extent.z_high - extent.z_low, extent.y_high - extent.y_low);
  bool held = false;
  for (const BeamDetail& of : project.fatigue.details) {
    if (of.from > s + near || of.to < s - near) continue;
    if (of.on != DetailPlace::section && of.on != on) continue;
    held = true;
    if (of.to - of.from <= short_one || is_so_weak(of)) return true;
  }
  return !held && is_so_weak(project.fatigue.beam);
}

std::string text_of_step(const std::string& name, Length from, Length to) {
  return fmt::format("{}, {:.4g} and {:.4g} mm", name, 1e3 * from.value(), 1e3 * to.value());
}

/// The same where walls of paths go on, or profiles of unlike kinds: by where plates lie.
std::string step_of_plates_at(const Project& project, std::size_t segment) {
  const Length s = project.beam.segments[segment].end();
  for (const PlateStep& of : plate_steps_at(project, segment)) {
    const BeamDetail splice = splice_of(of.from, of.to);
    const auto judged = [&](DetailPlace on) { return is_judged_by(project, s, on, splice); };
    // Walls of paths are fibres, and webs besides.
    const bool fibre = !of.web || of.in_path;
    if ((fibre && judged(DetailPlace::fibres)) || (of.web && judged(DetailPlace::webs))) continue;
    return text_of_step(of.name, of.from, of.to);
  }
  return "";
}

/// "top flange, 20 and 40 mm", of the first plate whose thickness steps unsaid; "" where none does.
std::string step_at(const Project& project, std::size_t segment) {
  const Segment &behind = project.beam.segments[segment],
                &ahead = project.beam.segments[segment + 1];
  if (behind.to.outer.index() != ahead.from.outer.index() ||
      std::holds_alternative<ThinWalled>(behind.to.outer))
    return step_of_plates_at(project, segment);
  const std::vector<PlateThickness> from = std::visit(PlatesOf{}, behind.to.outer);
  const std::vector<PlateThickness> to = std::visit(PlatesOf{}, ahead.from.outer);
  // What rounding of units makes is no step.
  const Length least = si<Length>(1e-6);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (abs(from[i].of - to[i].of) <= least) continue;
    if (is_judged_by(project, ahead.start, from[i].on, splice_of(from[i].of, to[i].of))) continue;
    return text_of_step(from[i].name, from[i].of, to[i].of);
  }
  return "";
}

bool has_weld_at(const Project& project, Length s) {
  const Length near = 1e-9 * project.beam.length();
  return std::any_of(project.welds.begin(), project.welds.end(),
                     [&](const WeldInput& of) { return abs(of.s - s) <= near; });
}

/// Whether forces move what carries the beam.
bool forces_move(const Project& project, const SituationRun& run) {
  if (const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism))
    return std::any_of(space->joints.begin(), space->joints.end(), spatial::is_forced);
  return std::holds_alternative<planar::Mechanism>(project.mechanism) &&
         planar_motion_of(run).freedom.undriven > 0;
}

/// Whether how it goes on after the time looked at is not known: forces move what carries the beam,
/// elastic links vibrate after a sudden start, or a rate or a polynomial has not come to its end.
bool goes_on(const Project& project, const SituationRun& run) {
  if (run.loads.closed() || run.loads.is_recorded()) return false;
  return run.situation->sudden_start || changes_at_end(project, run) || forces_move(project, run);
}

/// What of the vibration in a motion that does not repeat is not looked at: before it, where the
/// motion has a speed at once, and behind what the vibrating model looks at.
std::vector<NotJudged> vibration_beside_of(const Project& project, const ModelChoice& model,
                                           const SituationRun& run) {
  const std::optional<OpenMotion> motion = open_motion_of(project, run);
  if (!motion) return {};
  std::vector<NotJudged> beside;
  if (!motion->rests_before) {
    const bool forced = forces_move(project, run);
    beside.push_back(
        {Criterion::yield, "vibration at the beginning",
         fmt::format("at {:.6g} s {}: the beam follows its loads without a free vibration then, "
                     "and what a blow or a motion before leaves in it is not looked at{}",
                     motion->begin, forced ? "forces move bodies" : "bodies move already",
                     forced ? "" : "; let drivers begin with a step or a table from rest")});
  }
  const Time end = si<Time>(motion->end());
  const Time last = run.loads.begin() + run.loads.period();
  if (!project.fatigue.asked || !(last > end) || model.frequencies.empty()) return beside;
  const Eigen::MatrixXd stresses =
      project.in_space ? stress_history_in_space(run.loads, project.beam)
                       : stress_history(run.loads, compared_places_of(project.beam));
  const double step = run.loads.period().value() / static_cast<double>(run.loads.span().instants);
  const auto rows = static_cast<Eigen::Index>(std::ceil(1.0 / (model.frequencies.front() * step)));
  constexpr double gone = 0.1;
  const double left =
      largest_range(stresses.bottomRows(std::min(rows, stresses.rows()))) / largest_range(stresses);
  if (left > gone) {
    beside.push_back({Criterion::fatigue, "vibration behind the motion",
                      fmt::format("after {:.4g} s it still has {} of the largest range, and its "
                                  "further cycles are not counted{}",
                                  (last - end).value(), percent_text(left),
                                  project.model.retardation > 0.0
                                      ? ""
                                      : "; without damping ([model] damping) it does not die "
                                        "out")});
  }
  return beside;
}

/// The same of the first of the runs of which there is something to say, of those that are looked
/// at.
std::vector<NotJudged> vibration_beside_of(const Project& project, const ModelChoice& model,
                                           const std::deque<SituationRun>& runs,
                                           const std::function<bool(const SituationRun&)>& looked) {
  for (const SituationRun& run : runs) {
    std::vector<NotJudged> beside = vibration_beside_of(project, model, run);
    if (!beside.empty() && looked(run)) return beside;
  }
  return {};
}

bool has_functions_of_time(const frame::Structure& structure) {
  for (const DriverUse& of : functions_of(structure)) {
    const auto* const series = std::get_if<PolynomialDriver>(of.driver);
    if (series == nullptr || series->c.size() > 1) return true;
  }
  return false;
}

/// Whether a joint leaves a body free to shift across some axis or to turn about some: the one that
/// carries it, unless it is a weld or driven, or one that closes a loop, which may hold it by what
/// it carries.
bool leaves_beam_free(const spatial::Mechanism& mechanism, int body) {
  const spatial::Joint& carrying = mechanism.joints[static_cast<std::size_t>(body)];
  if (carrying.kind != spatial::JointKind::fixed && !spatial::is_driven(carrying)) return true;
  return std::any_of(mechanism.closing.begin(), mechanism.closing.end(),
                     [](const auto& of) { return of.kind != spatial::ClosingKind::fixed; });
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
    const std::string step = step_at(project, i - 1);
    if (step.empty() || has_weld_at(project, s)) continue;
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
  constexpr double counts = 0.5;  // of the largest use
  if (checks.empty()) return {};
  const double least = counts * checks.front().check.utilisation();
  for (const SituationRun& run : runs) {
    if (!goes_on(project, run)) continue;
    const Time end = run.loads.begin() + si<Time>(length_of_motion(project, run));
    const auto at_end = std::find_if(checks.begin(), checks.end(), [&](const CheckResult& of) {
      const Check& check = of.check;
      const bool here = check.situation.empty() || check.situation == run.situation->name;
      return here && check.on_beam && check.utilisation() >= least &&
             check.time >= end - 1e-6 * run.loads.period();
    });
    if (at_end == checks.end()) continue;
    return {{at_end->check.criterion, "the motion",
             fmt::format("{} is used most at its last instant, {:.6g} s; what follows is not "
                         "looked at{}",
                         at_end->check.point, end.value(),
                         run.situation->sudden_start ? "" : " ([motion] duration)")}};
  }
  return {};
}

std::vector<NotJudged> unestimated_vibration_of(const Project& project, const ModelChoice& model,
                                                const std::deque<SituationRun>& runs) {
  if (project.model.measured_loads) return {};
  const auto* const frame = std::get_if<frame::Structure>(&project.mechanism);
  if (!model.bends_rigid_motion && frame == nullptr) return {};
  const bool planar = std::holds_alternative<planar::Mechanism>(project.mechanism);
  const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism);
  if (model.chosen.level == ModelLevel::modal)
    return vibration_beside_of(project, model, runs, [](const SituationRun&) { return true; });
  if (frame != nullptr && !model.frequencies.empty()) {
    const double missed = vibration_missed_in_space(project, model);
    if (missed <= model.tolerance) return {};
    return {{Criterion::yield, "vibration",
             fmt::format("estimated to change the governing stress by {}, tolerance {}, and loads "
                         "act slowly; the lowest natural frequency of the frame is {:.4g} Hz",
                         percent_text(missed), percent_text(model.tolerance),
                         model.frequencies.front())}};
  }
  const auto changes = [&](const SituationRun& run) {
    if (run.motion->stands_still()) return false;
    if (frame != nullptr && !has_functions_of_time(frame_in(project, *run.situation))) return false;
    if (space != nullptr) return may_vibrate(project, *space, run.loads);
    const Eigen::MatrixXd stresses = stress_history(run.loads, compared_places_of(project.beam));
    return largest_range(stresses) > model.tolerance * stresses.cwiseAbs().maxCoeff();
  };
  std::string obstacle = front_end_of(project)->obstacle_to_vibration(runs);
  if (space != nullptr && obstacle.empty() && !model.frequencies.empty()) {
    const double missed = vibration_missed_in_space(project, model);
    if (missed <= model.tolerance) return vibration_beside_of(project, model, runs, changes);
    return {{Criterion::yield, "vibration",
             fmt::format("estimated to change the governing stress by {}, tolerance {}, and bodies "
                         "are rigid; the lowest natural frequency of the beam in its "
                         "mechanism is {:.4g} Hz",
                         percent_text(missed), percent_text(model.tolerance),
                         model.frequencies.front())}};
  }
  // Of what forces move the estimate itself may find why there is none.
  const bool unknown =
      planar && obstacle.empty() && model.weighed.empty() && model.frequencies.empty() &&
      std::any_of(runs.begin(), runs.end(),
                  [&](const SituationRun& run) { return forces_move(project, run); });
  if (unknown) obstacle = model.reason;
  if (planar && obstacle.empty()) return vibration_beside_of(project, model, runs, changes);
  if (std::none_of(runs.begin(), runs.end(), changes)) return {};
  if (obstacle.empty() && space != nullptr)
    obstacle = "the stopped mechanism does not hold the beam";
  if (obstacle.empty()) return {};
  return {
      {Criterion::yield, "vibration",
       fmt::format("what it adds is not estimated: {}",
                   frame != nullptr ? "a frame at rest bears each instant's loads" : obstacle)}};
}

std::vector<NotJudged> assumed_holds_not_judged(const Project& project,
                                                const SecondOrderEstimate& estimate) {
  const auto* const mechanism = std::get_if<spatial::Mechanism>(&project.mechanism);
  if (mechanism == nullptr || !leaves_beam_free(*mechanism, placement_in(project, *mechanism).body))
    return {};
  const std::vector<std::string> assumed = assumed_holds_of(estimate, true);
  if (assumed.empty()) return {};
  return {
      {Criterion::member, "how joints hold the beam", fmt::format("{}", fmt::join(assumed, "; "))}};
}

std::vector<NotJudged> impacts_not_judged(const Project& project) {
  std::vector<std::string> names;
  if (const auto* const plane = std::get_if<planar::Mechanism>(&project.mechanism)) {
    for (const planar::AppliedForce& force : plane->forces) {
      const auto* const spring = std::get_if<planar::Spring>(&force.kind);
      const bool loose = std::holds_alternative<planar::PinWithClearance>(force.kind);
      if (loose || (spring != nullptr && spring->impact)) names.push_back(force.name);
    }
  } else if (const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism)) {
    for (const spatial::Spring& spring : space->springs)
      if (spring.impact) names.push_back(spring.name);
  }
  if (names.empty()) return {};
  return {{Criterion::yield, fmt::format("impacts in {}", fmt::join(names, ", ")),
           "bodies are rigid: waves and vibration that an impact leaves in them, the pressure "
           "where they touch, friction there and wear"}};
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
