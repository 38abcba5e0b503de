#include "boxbeam/verification/verify.hpp"

#include <algorithm>
#include <utility>

#include "boxbeam/core/append.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/numerics/nine_digits.hpp"
#include "boxbeam/verification/deflection.hpp"
#include "boxbeam/verification/distortion_checks.hpp"
#include "boxbeam/verification/drawn_histories.hpp"
#include "boxbeam/verification/hole_gates.hpp"
#include "boxbeam/verification/member_checks.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/recorded_notes.hpp"
#include "boxbeam/verification/slow_friction.hpp"
#include "boxbeam/verification/twisting.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "boxbeam/verification/unseen_time.hpp"
#include "boxbeam/verification/warping_notes.hpp"
#include "verdict_notes.hpp"
#include "verify_each.hpp"

namespace boxbeam {
namespace {

std::vector<CheckResult> all_checks(std::vector<CheckResult> of_beam,
                                    const NeighbourChecks& neighbours,
                                    std::vector<CheckResult> of_member,
                                    const std::optional<CheckResult>& deflection) {
  std::vector<CheckResult> checks = std::move(of_beam);
  for (const NeighbourResult& neighbour : neighbours.results) checks.emplace_back(neighbour.check);
  append(std::move(of_member), checks);
  if (deflection) checks.push_back(*deflection);
  return checks;
}

/// What is used as much as another but for round-off stands behind it as along the beam, on every
/// computer.
void sort_worst_first(std::vector<CheckResult>& checks) {
  // Results are large: their order is found first, then each is moved once.
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(checks.size());
  for (const CheckResult& result : checks)
    order.emplace_back(nine_digits(result.check.utilisation()), order.size());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<CheckResult> sorted;
  sorted.reserve(checks.size());
  for (const auto& [use, i] : order) sorted.push_back(std::move(checks[i]));
  checks = std::move(sorted);
}

std::vector<Gate> all_gates(std::vector<Gate> of_beam, std::vector<Gate> of_neighbours,
                            std::vector<Gate> of_model) {
  append(std::move(of_neighbours), of_beam);
  append(std::move(of_model), of_beam);
  return of_beam;
}

/// What was asked for and has no check.
std::vector<NotJudged> not_judged_in(const Project& project, const std::vector<CheckResult>& checks,
                                     std::vector<NotJudged> neighbours) {
  const auto is_checked = [&](Criterion criterion) {
    return governing_of(checks, criterion) != nullptr;
  };
  std::vector<NotJudged> not_judged;
  if (project.fatigue.asked && !judged_in_fatigue(checks))
    not_judged.push_back({Criterion::fatigue, "fatigue", "no stress range"});
  append(std::move(neighbours), not_judged);
  if (project.deflection && !is_checked(Criterion::deflection))
    not_judged.push_back({Criterion::deflection, "deflection", "the beam never bends"});
  return not_judged;
}

bool all_pass(const std::vector<CheckResult>& checks) {
  return std::all_of(checks.begin(), checks.end(),
                     [](const CheckResult& result) { return result.check.passes(); });
}

Verdict verdict_of(const std::vector<CheckResult>& checks, const std::vector<Gate>& gates) {
  if (!all_pass(checks)) return Verdict::fail;
  const bool blocked =
      std::any_of(gates.begin(), gates.end(), [](const Gate& gate) { return gate.blocks; });
  return blocked ? Verdict::not_applicable : Verdict::pass;
}

std::optional<planar::EquivalentMass> equivalent_mass_in(const Project& project,
                                                         const SituationRun& run) {
  if (!project.equivalent_mass) return std::nullopt;
  const EquivalentMassDemand& demand = *project.equivalent_mass;
  return planar::equivalent_mass_of(planar_in(project, *run.situation), planar_motion_of(run),
                                    demand.joint, demand.on, demand.adjust, demand.wanted.value());
}

/// What the stresses along the beam come to.
struct StressStage {
  std::vector<BendingZone> zones;
  std::vector<Station> stations;
  SearchSummary search;
  BeamChecks beam;
};

StressStage judge_along(const Project& project, const std::deque<SituationRun>& runs,
                        const ModelChoice& model, StationMemory* memory) {
  std::vector<BendingZone> zones = bending_zones_of(project, runs);
  VerifiedStations verified = search_stations(project, runs, zones, memory);
  BeamChecks beam = check_beam(project, runs, zones, verified, model, memory);
  if (const WholeLife* const whole = whole_life_of(runs)) {
    // Where estimates were far off, the places were looked for by them: once more by better ones.
    constexpr double far = 2e-3;
    if (whole->summary.estimate_error > far) {
      verified = search_stations(project, runs, zones);
      beam = {};  // both at a time are many
      beam = check_beam(project, runs, zones, verified, model);
    }
    SearchSummary& search = verified.search;
    search.whole = whole->summary;
    search.tolerance = std::max(search.tolerance, search.whole.estimate_error);
  }
  return {std::move(zones), std::move(verified.stations), verified.search, std::move(beam)};
}

/// What no stage finds for itself: of motions, records, models and what holds the beam.
std::vector<NotJudged> unjudged_beside(const Project& project, const std::deque<SituationRun>& runs,
                                       const ModelChoice& model,
                                       const std::vector<CheckResult>& checks) {
  std::vector<NotJudged> not_judged = unsaid_joints_of(project);
  append(unfinished_motion_of(project, runs, checks), not_judged);
  append(unseen_time_of(project, runs), not_judged);
  append(slow_friction_of(project, runs), not_judged);
  append(not_judged_of_records(project), not_judged);
  append(unestimated_vibration_of(project, model, runs), not_judged);
  append(assumed_holds_not_judged(project, model.second_order), not_judged);
  append(impacts_not_judged(project), not_judged);
  return not_judged;
}

/// What forces do that come into walls, and what racks them.
struct WallChecks {
  PatchChecks patches;
  DistortionChecks distortion;
};

/// Their checks, and the gates of forces, join those of the beam.
WallChecks check_walls(const Project& project, const std::deque<SituationRun>& runs,
                       StressStage& along, BeamMemory* memory) {
  auto& [zones, stations, search, beam] = along;
  WallChecks of;
  auto& [patches, distortion] = of;
  if (project.given_stresses.empty()) {
    patches = memory != nullptr ? memory->patches.of(project, *memory->runs)
                                : check_patches(project, runs, zones);
  }
  append(std::move(patches.checks), beam.checks);
  append(std::move(patches.gates), beam.gates);
  if (project.given_stresses.empty()) distortion = check_distortion(project, runs, zones, stations);
  append(std::move(distortion.checks), beam.checks);
  leave_out_without_effect(beam.checks);
  // Forces that hold each other in balance at one place may press and rack it all the same.
  if (beam.checks.empty() && project.given_stresses.empty()) {
    throw AnalysisError(
        {"nothing to verify: no point of the beam is ever stressed" +
             (distortion.gates.empty() ? "" : ", but " + distortion.gates.front().finding),
         "beam",
         {},
         {},
         {}});
  }
  return of;
}

Verification judge_further(const Project& project, const std::deque<SituationRun>& runs,
                           ModelChoice model, StressStage along, Figures figures,
                           BeamMemory* memory) {
  auto& [zones, stations, search, beam] = along;
  auto [patches, distortion] = check_walls(project, runs, along, memory);
  NeighbourChecks neighbours = check_neighbours(project, runs);

  model.second_order.twisting = twisting_load_of(project, runs, model.second_order);
  std::vector<CheckResult> checks = all_checks(
      std::move(beam.checks), neighbours, check_member(project, zones, model.second_order),
      check_deflection(project, runs, model.counts_second_order));
  require_numbers(beam.stations, checks, model);
  sort_worst_first(checks);
  find_drawn_histories(project, runs, checks);
  sort_worst_first(beam.beside);
  std::vector<Gate> gates =
      all_gates(std::move(beam.gates), std::move(neighbours.gates), model_gates_of(project, model));
  append(second_order_gates_of(project, model, checks), gates);
  append(material_gates_of(project), gates);
  append(weld_gates_of(project), gates);
  WarpingFound warping =
      project.given_stresses.empty() ? look_at_warping(project, runs) : WarpingFound{};
  append(std::move(warping.gates), gates);
  GivenCutsFound given_cuts = look_at_given_cuts(project, runs, checks);
  append(std::move(given_cuts.gates), gates);
  append(stability_gates_of(project, runs), gates);
  if (project.given_stresses.empty()) append(hole_gates_of(project, runs), gates);
  append(distortion_gates_of(project, distortion.estimates, checks), gates);
  append(shared_diaphragm_gates_of(project, distortion.estimates, patches.into_diaphragms, checks),
         gates);
  append(std::move(distortion.gates), gates);
  std::vector<NotJudged> not_judged =
      not_judged_in(project, checks, std::move(neighbours.not_judged));
  append(std::move(distortion.not_judged), not_judged);
  append(std::move(patches.not_judged), not_judged);
  append(unjudged_beside(project, runs, model, checks), not_judged);
  append(std::move(given_cuts.not_judged), not_judged);
  append(std::move(warping.not_judged), not_judged);
  if (project.given_stresses.empty()) append(axial_forces_not_judged(project, runs), not_judged);

  std::vector<MotionSummary> motions = motion_summaries_of(project, runs);
  append(lifted_supports_of(project, motions), not_judged);
  std::vector<CriticalInstant> instants = critical_instants_of(project, beam.stations, checks);
  Pictures pictures =
      pictures_of(project, runs, model.chosen, checks, instants, motions, figures, memory);
  std::optional<ChainComparison> chain = chain_comparison_of(project, runs, instants);
  require_numbers(chain);
  std::vector<CodeResult> codes = compare_codes(project, checks);
  const Verdict verdict = verdict_of(checks, gates);
  return {.verdict = verdict,
          .model = std::move(model),
          .search = search,
          .motions = std::move(motions),
          .stations = std::move(beam.stations),
          .checks = std::move(checks),
          .beside = std::move(beam.beside),
          .routes = std::move(beam.routes),
          .neighbours = std::move(neighbours.results),
          .gates = std::move(gates),
          .not_judged = std::move(not_judged),
          .unsaid_welds = std::move(patches.unsaid_welds),
          .critical_instants = std::move(instants),
          .codes = std::move(codes),
          .equivalent_mass = equivalent_mass_in(project, runs.front()),
          .chain = std::move(chain),
          .beam_mass = mass_properties_of(project.beam),
          .tapers = taper_slopes_of(project.beam),
          .published_concentrations = published_concentrations_of(project),
          .pictures = std::move(pictures),
          .remedies = {}};
}

}  // namespace

const char* to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::not_applicable: return "not applicable";
  }
  return "";
}

Verification verify(const Project& project, Figures figures, Advice advice,
                    const SharedMotions& shared) {
  auto [model, runs] = run_by_chosen_model(project, shared);
  Verification verification = judge(project, runs, std::move(model), figures);
  if (advice == Advice::with) verification.remedies = remedies_of(project, runs, verification);
  return verification;
}

Verification judge(const Project& project, const std::deque<SituationRun>& runs, ModelChoice model,
                   Figures figures, BeamMemory* memory) {
  StressStage along =
      judge_along(project, runs, model, memory != nullptr ? &memory->stations : nullptr);
  return judge_further(project, runs, std::move(model), std::move(along), figures, memory);
}

std::optional<double> utilisation_if_it_passes(const Project& project) {
  auto [model, runs] = run_by_chosen_model(project, {});
  return utilisation_if_it_passes(project, runs, std::move(model));
}

std::optional<double> utilisation_if_it_passes(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               ModelChoice model) {
  StressStage along = judge_along(project, runs, model, nullptr);
  if (!all_pass(along.beam.checks)) return std::nullopt;
  const Verification of =
      judge_further(project, runs, std::move(model), std::move(along), Figures::without, nullptr);
  if (of.verdict != Verdict::pass) return std::nullopt;
  return of.checks.front().check.utilisation();
}

std::vector<VerifiedBeam> verify_beams(std::vector<Project> beams, Figures figures, Advice advice) {
  const SharedMotions shared;
  return verify_each(std::move(beams), [&](const Project& project, std::size_t) {
    return verify(project, figures, advice, shared);
  });
}

const VerifiedBeam& worst_of(const std::vector<VerifiedBeam>& beams) {
  const auto rank = [](const VerifiedBeam& beam) {
    constexpr auto severity = [](Verdict verdict) {
      switch (verdict) {
        case Verdict::fail: return 2;
        case Verdict::not_applicable: return 1;
        case Verdict::pass: break;
      }
      return 0;
    };
    const std::vector<CheckResult>& checks = beam.verification.checks;
    return std::pair(severity(beam.verification.verdict),
                     checks.empty() ? 0.0 : checks.front().check.utilisation());
  };
  return *std::max_element(
      beams.begin(), beams.end(),
      [&](const VerifiedBeam& a, const VerifiedBeam& b) { return rank(a) < rank(b); });
}

}  // namespace boxbeam
