#include "boxbeam/verification/verify.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/verification/critical_instants.hpp"
#include "boxbeam/verification/deflection.hpp"
#include "boxbeam/verification/pictures.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/weld_checks.hpp"
#include "planar_pictures.hpp"

namespace boxbeam {
namespace {

Envelope envelope_of(const Project& project, const std::vector<SituationHistory>& histories,
                     const CutForceFunction& f) {
  Envelope envelope;
  for (const SituationHistory& at : histories) {
    const std::size_t situation = index_of(project, *at.situation);
    const TurningPoint low = at.history.largest([&](const CutForces& cut) { return -f(cut); });
    const TurningPoint high = at.history.largest(f);
    const bool first = &at == &histories.front();
    if (first || -low.value < envelope.smallest.value)
      envelope.smallest = {low.time, -low.value, situation};
    if (first || high.value > envelope.largest.value)
      envelope.largest = {high.time, high.value, situation};
  }
  return envelope;
}

std::vector<StationEnvelope> cut_force_envelopes(const Project& project,
                                                 const std::deque<SituationRun>& runs,
                                                 const std::vector<Station>& stations) {
  std::vector<StationEnvelope> envelopes;
  const auto add = [&](const Station& station) {
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    StationEnvelope& envelope = envelopes.emplace_back();
    envelope.station = station;
    for (const auto& [which, name] : cut_forces_looked_at(project)) {
      envelope.of[which] = envelope_of(project, histories, [which = which](const CutForces& cut) {
        return value_of(cut, which);
      });
    }
  };
  // Outside the two ends nothing is cut: the jump to zero there is part of the diagram.
  add({Length{}, Side::before});
  for (const Station& station : stations) add(station);
  add({project.beam.length(), Side::behind});
  return envelopes;
}

void sort_worst_first(std::vector<CheckResult>& checks) {
  std::stable_sort(checks.begin(), checks.end(), [](const CheckResult& a, const CheckResult& b) {
    return a.check.utilisation() > b.check.utilisation();
  });
}

ChainComparison compare_chain(const Project& project, const planar::State& state) {
  const planar::NewtonChain& chain = *project.chain;
  ChainComparison comparison;
  comparison.time = si<Time>(state.time);
  const planar::ChainForces forces = planar::chain_at(chain, state);
  comparison.chain_first = forces.g[chain.first_end];
  comparison.chain_second = forces.g[chain.second_end];
  comparison.chain_mass = si<Mass>(forces.sought_mass);
  const BeamLoads loads = planar::beam_loads_of(
      chain, project.beam, mass_distribution_of(project.beam), planar_of(project).gravity, state);
  comparison.moment_gap = si<Moment>(loads.points.back().moment.y());
  comparison.rigorous_first.setZero();
  comparison.rigorous_second.setZero();
  if (project.beam_body == planar::ground) return comparison;
  const auto body = planar::beam_body_of(project.beam, project.beam_body);
  const BeamLoads rigorous = planar::beam_loads_of(planar_of(project), state, body);
  for (const BeamLoadRow& row : load_rows(project, rigorous, state)) {
    if (row.s == chain.first_station) comparison.rigorous_first += row.world.head<2>();
    if (row.s == chain.second_station) comparison.rigorous_second += row.world.head<2>();
  }
  return comparison;
}

/// The published chain beside the rigorous loads, at the instant of the largest M.
ChainComparison chain_comparison_of(const Project& project, const std::deque<SituationRun>& runs,
                                    const std::vector<CriticalInstant>& instants) {
  const auto largest_M = std::find_if(
      instants.begin(), instants.end(),
      [](const CriticalInstant& instant) { return instant.force && instant.force->bends(); });
  const SituationRun& run = run_of(runs, project.situations[largest_M->situation]);
  planar::StateFinder finder(planar_in(project, *run.situation), planar_motion_of(run));
  return compare_chain(project, finder.at(largest_M->time.value()));
}

MotionSummary summary_of(const Project& project, const SituationRun& run) {
  MotionSummary summary;
  summary.situation = index_of(project, *run.situation);
  // Of a history that stays open, its end is an instant of its own.
  summary.instants = run.loads.even_instants() - (run.loads.closed() ? 0 : 1);
  summary.begin = run.loads.begin();
  summary.period = run.loads.period();
  summary.closed = run.loads.closed();
  summary.stands_still = run.motion->stands_still();
  summary.imbalance = run.imbalance;
  summary.closure = run.motion->closure();
  return summary;
}

void describe_mechanism(const Project& project, const std::deque<SituationRun>& runs,
                        Verification& result) {
  for (const SituationRun& run : runs) result.motions.push_back(summary_of(project, run));
  result.beam_mass = mass_properties_of(project.beam);
  if (project.equivalent_mass) {
    const EquivalentMassDemand& demand = *project.equivalent_mass;
    const SituationRun& run = runs.front();
    result.equivalent_mass =
        planar::equivalent_mass_of(planar_in(project, *run.situation), planar_motion_of(run),
                                   demand.joint, demand.on, demand.adjust, demand.wanted.value());
  }
}

/// The checks beside the stresses of the beam, which the case asks for, and what they cannot judge.
void check_neighbours(const Project& project, const std::deque<SituationRun>& runs,
                      Verification& result) {
  result.neighbours = check_pins(project, runs);
  for (const PinInput& pin : project.pins) {
    const auto is_checked = [&](const NeighbourResult& of) { return of.check.point == pin.name; };
    if (std::none_of(result.neighbours.begin(), result.neighbours.end(), is_checked)) {
      result.not_judged.push_back({Criterion::pin, "pin " + pin.name, "no force"});
    }
  }
  RodChecks rods = check_rods(project, runs);
  for (NeighbourResult& rod : rods.results) result.neighbours.push_back(std::move(rod));
  for (Gate& gate : rods.gates) result.gates.push_back(std::move(gate));
  for (const std::string& name : rods.unloaded) {
    result.not_judged.push_back({Criterion::rod, "rod " + name, "no force"});
  }
  for (const NeighbourResult& neighbour : result.neighbours) {
    result.checks.push_back({neighbour.check, {}});
  }
  if (!project.deflection) return;
  if (auto deflection = check_deflection(project, runs)) {
    result.checks.push_back(std::move(*deflection));
  } else {
    result.not_judged.push_back({Criterion::deflection, "deflection", "the beam never bends"});
  }
}

/// Notes fatigue that is asked for where no stress ever changes.
void look_for_fatigue(const Project& project, Verification& result) {
  constexpr std::array judged{Criterion::fatigue, Criterion::shear_fatigue,
                              Criterion::combined_fatigue};
  const bool found = std::any_of(judged.begin(), judged.end(), [&](Criterion criterion) {
    return result.governing(criterion) != nullptr;
  });
  if (project.fatigue.asked && !found) {
    result.not_judged.insert(result.not_judged.begin(),
                             {Criterion::fatigue, "fatigue", "no stress range"});
  }
}

Verdict verdict_of(const Verification& verification) {
  const bool all_pass =
      std::all_of(verification.checks.begin(), verification.checks.end(),
                  [](const CheckResult& result) { return result.check.passes(); });
  if (!all_pass) return Verdict::fail;
  const bool blocked = std::any_of(verification.gates.begin(), verification.gates.end(),
                                   [](const Gate& gate) { return gate.blocks; });
  return blocked ? Verdict::not_applicable : Verdict::pass;
}

void describe_beam(const Project& project, Verification& result) {
  for (const Segment& segment : project.beam.segments) {
    const Length rise = 0.5 * abs(height_of(segment.to.outer) - height_of(segment.from.outer));
    if (rise.value() == 0.0) continue;
    const double slope = std::atan2(rise.value(), segment.length.value());
    result.tapers.push_back({segment.name, slope});
  }
  for (std::size_t i = 0; i < project.beam.holes.size(); ++i) {
    const HoleCase published = HoleCase::published_exponential;
    if (project.hole_inputs[i].concentration != published) continue;
    const BeamHole& at = project.beam.holes[i];
    const Section section = section_at(project.beam, {at.s});
    const double a = at.hole.diameter /
                     plate_width_of(section, holes_at(project.beam, at.s), at.hole, published);
    result.published_concentrations.push_back({at.hole.name, a, published_concentration(a)});
  }
}

}  // namespace

std::span<const CutForceName> cut_forces_looked_at(const Project& project) {
  static constexpr CutForceName in_the_plane[] = {
      {cut_force::N, "N"}, {cut_force::V_z, "V"}, {cut_force::M_y, "M"}};
  static constexpr CutForceName all[] = {{cut_force::N, "N"},     {cut_force::V_y, "V_y"},
                                         {cut_force::V_z, "V_z"}, {cut_force::T, "T"},
                                         {cut_force::M_y, "M_y"}, {cut_force::M_z, "M_z"}};
  if (project.in_space) return all;
  return in_the_plane;
}

const char* to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::not_applicable: return "not applicable";
  }
  return "";
}

const CheckResult* Verification::governing(Criterion criterion) const {
  for (const CheckResult& result : checks) {
    if (result.check.criterion == criterion) return &result;
  }
  return nullptr;
}

Verification verify(const Project& project, Figures figures) {
  const auto [model, runs] = run_by_chosen_model(project);
  const auto [stations, search] = search_stations(project, runs);

  Verification result;
  result.model = model;
  result.search = search;
  describe_mechanism(project, runs, result);
  result.stations = cut_force_envelopes(project, runs, stations);
  const bool computed = project.given_stresses.empty();
  result.checks = computed ? check_beam(project, runs, stations) : check_given_stresses(project);
  if (computed) {
    for (CheckResult& weld : check_welds(project, runs)) result.checks.push_back(std::move(weld));
  }
  check_neighbours(project, runs, result);
  require_numbers(result);
  sort_worst_first(result.checks);
  look_for_fatigue(project, result);
  if (computed) {
    std::vector<Gate> of_beam = gates_of(project, runs, stations, result.checks, model);
    result.gates.insert(result.gates.begin(), of_beam.begin(), of_beam.end());
  }
  for (Gate& gate : model_gates_of(project, model)) result.gates.push_back(std::move(gate));
  result.verdict = verdict_of(result);
  result.codes = compare_codes(project, result.checks);
  result.critical_instants = critical_instants_of(project, result);
  add_pictures(project, runs, figures, result);
  if (project.chain) {
    result.chain = chain_comparison_of(project, runs, result.critical_instants);
  }
  describe_beam(project, result);
  if (const CheckResult* fatigue = result.governing(Criterion::fatigue)) {
    result.sn = sn_figure(project, *fatigue, result.checks);
  }
  return result;
}

}  // namespace boxbeam
