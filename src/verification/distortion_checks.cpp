#include "boxbeam/verification/distortion_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "boxbeam/verification/distorted_stretch.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "distorted_paths.hpp"
#include "distortion_search.hpp"
#include "holding_diaphragm.hpp"

namespace boxbeam {
namespace {

/// Segments of boxes in a row.
std::vector<BoxStretch> box_stretches_of(const TaperedBeam& beam) {
  std::vector<BoxStretch> stretches;
  bool before = false;
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const bool box = has_cell(beam.segments[i]);
    if (box && before) stretches.back().last = i;
    if (box && !before) stretches.push_back({i, i});
    before = box;
  }
  return stretches;
}

/// Whether any segment keeps its shape as cells do not.
bool has_cells(const TaperedBeam& beam) {
  return std::any_of(beam.segments.begin(), beam.segments.end(),
                     [](const Segment& of) { return has_cell(of) || is_closed_path(of); });
}

/// Whether anything twists the beam at any instant, or torques that cancel come into it.
bool is_twisted(const std::deque<SituationRun>& runs,
                const std::vector<std::vector<TorquesIn>>& torques) {
  for (const std::vector<TorquesIn>& of_run : torques)
    for (const TorquesIn& at : of_run)
      if (!at.empty()) return true;
  for (const SituationRun& run : runs) {
    const double least = least_torque(run);
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      for (const CutForcePiece& piece : run.loads.diagram(i).pieces) {
        for (const double part : {0.0, 0.5, 1.0})
          if (std::abs(piece.T(part * piece.length.value())) > least) return true;
      }
    }
  }
  return false;
}

/// What of a diaphragm's fatigue is in no check, nor stops the verdict.
void note_life(const DistortionEstimate& estimate, const DistortionEstimate::Holding& of,
               std::vector<NotJudged>& not_judged) {
  // Judged and below one it is said where little is left for what forces put there as well.
  const double hardly = estimate.ranges_judged ? 0.5 : 0.1;
  if (!(of.life > hardly) || (estimate.ranges_judged && of.life > 1.0)) return;
  not_judged.push_back(
      {Criterion::distortion_fatigue,
       fmt::format("welds of the diaphragm at s = {} m", to_text(Station{of.s, Side::both})),
       fmt::format("so that the box keeps its shape sheared anew by up to {:.3g} MPa at every "
                   "cycle, they or its plate {} (EN 1993-1-9, table 8.5, row 8), in no check",
                   1e-6 * of.range.value(),
                   estimate.ranges_judged ? fmt::format("used by {:.2g} in fatigue", of.life)
                                          : "in a long record")});
}

/// A couple that all plates of a box are said to bear though nothing spreads it there.
NotJudged spread_by_nothing(const DistortedStretch::Torque& of) {
  return {Criterion::distortion,
          fmt::format("torque at s = {} m", to_text(Station{of.s, Side::both})),
          fmt::format("{:.4g} kN m taken to come by all plates (torque_by = \"flow\") where no "
                      "diaphragm stands that spreads it",
                      1e-3 * of.torque.value())};
}

}  // namespace

DistortionChecks check_distortion(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<BendingZone>& zones,
                                  const std::vector<Station>& stations) {
  DistortionChecks found;
  if (!project.in_space || !has_cells(project.beam)) return found;
  const std::vector<std::vector<TorquesIn>> torques = torques_in(project, runs);
  if (!is_twisted(runs, torques)) return found;
  for (const BoxStretch& segments : box_stretches_of(project.beam)) {
    const DistortedStretch stretch(project, runs, torques, segments, stations);
    if (stretch.spread_by_nothing().torque > Moment{})
      found.not_judged.push_back(spread_by_nothing(stretch.spread_by_nothing()));
    if (!stretch.is_distorted()) continue;
    DistortionSearch search(project, runs, zones, stretch, segments);
    for (CheckResult& check : search.checks()) found.checks.push_back(std::move(check));
    found.estimates.push_back(search.estimate());
    const DistortionEstimate& estimate = found.estimates.back();
    for (const DistortionEstimate::Holding& of : estimate.held)
      note_life(estimate, of, found.not_judged);
    const auto& holding = estimate.holding;
    if (!holding || !(project.strength.required * holding->needed > least_throat())) continue;
    found.not_judged.push_back(unsaid_welds(project, *holding));
  }
  look_at_other_cells(project, runs, torques, found);
  return found;
}

void leave_out_without_effect(std::vector<CheckResult>& checks) {
  const auto leave_out = [&](Criterion criterion, std::initializer_list<Criterion> without) {
    double most = 0.0;
    for (const CheckResult& of : checks) {
      if (!of.patch &&
          std::find(without.begin(), without.end(), of.check.criterion) != without.end())
        most = std::max(most, of.check.utilisation());
    }
    constexpr double close = 1e-6;
    std::erase_if(checks, [&](const CheckResult& of) {
      return of.check.criterion == criterion &&
             std::abs(of.check.utilisation() - most) <= close * most;
    });
  };
  leave_out(Criterion::distortion, {Criterion::yield, Criterion::weld});
  leave_out(Criterion::distortion_fatigue,
            {Criterion::fatigue, Criterion::shear_fatigue, Criterion::combined_fatigue});
}

}  // namespace boxbeam
