#include "boxbeam/verification/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/deflection.hpp"
#include "boxbeam/verification/elastic_posture.hpp"

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

std::vector<CriticalInstant> critical_instants_of(const Project& project,
                                                  const Verification& verification) {
  std::vector<CriticalInstant> instants;
  const auto add = [&](const CutForceName& quantity, Extreme Envelope::*end) {
    const StationEnvelope* best = nullptr;
    // Outside the beam, at the first and the last of the stations, nothing is cut.
    const std::span inside =
        std::span(verification.stations).subspan(1, verification.stations.size() - 2);
    for (const StationEnvelope& station : inside) {
      const double value = (station.of[quantity.which].*end).value;
      if (best == nullptr) best = &station;
      const double so_far = (best->of[quantity.which].*end).value;
      if (end == &Envelope::largest ? value > so_far : value < so_far) best = &station;
    }
    const Extreme& at = best->of[quantity.which].*end;
    instants.push_back({quantity.name, best->station, at.time, at.value, at.situation});
  };
  for (const auto end : {&Envelope::largest, &Envelope::smallest}) {
    for (const CutForceName& quantity : cut_forces_looked_at(project)) add(quantity, end);
  }
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  if (governing == nullptr || !governing->basis)
    governing = verification.governing(Criterion::yield);
  if (governing != nullptr && governing->basis) {
    const auto add_stress = [&](const Extreme& at) {
      instants.push_back({"stress", governing->check.station, at.time, at.value, at.situation});
    };
    add_stress(governing->basis->highest);
    if (governing->check.criterion == Criterion::fatigue) add_stress(governing->basis->lowest);
  }
  return instants;
}

/// Whether an extreme is the upper or the lower one of its quantity, and what to call it; "" where
/// it is smaller than a share of the other, `nothing`.
std::string name_of_extreme(const std::vector<CriticalInstant>& instants,
                            const CriticalInstant& instant, double nothing) {
  double highest = instant.value;
  double size = 0.0;
  for (const CriticalInstant& other : instants) {
    if (other.quantity != instant.quantity) continue;
    highest = std::max(highest, other.value);
    size = std::max(size, std::abs(other.value));
  }
  if (std::abs(instant.value) < nothing * size) return "";
  const bool upper = instant.value == highest;
  if (upper) return (instant.value > 0.0 ? "largest " : "least negative ") + instant.quantity;
  return (instant.value > 0.0 ? "smallest " : "most negative ") + instant.quantity;
}

/// The distinct times of the extremes of bending and stress: the instants worth drawing.
struct ShownInstant {
  std::size_t situation;
  Time time;
  std::string why;
};

std::vector<ShownInstant> instants_to_show(const Project& project,
                                           const Verification& verification) {
  // In space two moments and several situations compete for the place.
  const double nothing = in_space(project) ? 1e-2 : 1e-6;
  std::vector<ShownInstant> shown;
  for (const CriticalInstant& instant : verification.critical_instants) {
    if (!instant.quantity.starts_with("M") && instant.quantity != "stress") continue;
    const std::string why = name_of_extreme(verification.critical_instants, instant, nothing);
    if (why.empty()) continue;
    const auto motion =
        std::find_if(verification.motions.begin(), verification.motions.end(),
                     [&](const MotionSummary& of) { return of.situation == instant.situation; });
    const auto same = std::find_if(shown.begin(), shown.end(), [&](const ShownInstant& other) {
      return other.situation == instant.situation &&
             abs(other.time - instant.time) < 0.01 * motion->period;
    });
    if (same == shown.end())
      shown.push_back({instant.situation, instant.time, why});
    else
      same->why += ", " + why;
  }
  std::sort(shown.begin(), shown.end(), [](const ShownInstant& a, const ShownInstant& b) {
    return std::pair(a.situation, a.time) < std::pair(b.situation, b.time);
  });
  return shown;
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

DeformedPosture deformed_at(const SituationRun& run, Time time) {
  constexpr double part = 0.06;
  const FlexibleMotion& motion = flexible_motion_of(run);
  const double largest = largest_displacement(motion.response);
  return {motion.structure.get(), flexible::at(motion.response, time.value()),
          magnification_of(*motion.structure, largest, part)};
}

/// The mechanism as it stands at a time of a situation, with the loads on the beam.
PostureFigure posture_at(const Project& project, const SituationRun& run, Time time,
                         const std::string& why) {
  const BeamLoads loads = run.loads.loads_at(time);
  PostureFigure posture;
  if (is_flexible(project)) {
    const DeformedPosture deformed = deformed_at(run, time);
    posture = posture_figure(project, deformed, why);
    posture.time = time;
    posture.loads = load_rows(project, deformed, loads);
  } else if (in_space(project)) {
    const spatial::Mechanism& mechanism = spatial_in(project, *run.situation);
    const spatial::State state = spatial::Chain(mechanism).at(time.value());
    posture = posture_figure(project, mechanism, state, why);
    posture.loads = load_rows(project, mechanism, loads, state);
  } else {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    planar::StateFinder finder(mechanism, planar_motion_of(run));
    const planar::State state = finder.at(time.value());
    posture = posture_figure(project, mechanism, state, why);
    posture.loads = load_rows(project, loads, state);
  }
  posture.situation = run.situation->name;
  for (BeamLoadRow& row : posture.loads) {
    row.time = time;
    row.situation = index_of(project, *run.situation);
  }
  return posture;
}

/// The station of the worst check that rests on cut forces.
const Station* governing_station_of(const Verification& verification) {
  for (const CheckResult& result : verification.checks) {
    if (result.basis) return &result.check.station;
  }
  return nullptr;
}

/// What the report shows of the instants that decide.
void describe_instants(const Project& project, const std::deque<SituationRun>& runs,
                       Verification& result) {
  result.envelope = envelope_lines(runs);
  if (is_flexible(project)) {
    result.elastic = elastic_figures_of(project, runs.front(), result.model.chosen);
    result.postures.push_back(result.elastic->rest);
  } else {
    result.postures.push_back(
        posture_at(project, runs.front(), runs.front().loads.begin(), "beginning"));
  }
  for (const auto& [index, time, why] : instants_to_show(project, result)) {
    const Situation& situation = project.situations[index];
    const SituationRun& run = run_of(runs, situation);
    const std::string label =
        situation.name.empty() ? why : fmt::format("{} ({})", why, situation.name);
    result.lines.push_back(cut_force_line(run, time, label));
    result.postures.push_back(posture_at(project, run, time, label));
    const std::vector<BeamLoadRow>& rows = result.postures.back().loads;
    result.loads.insert(result.loads.end(), rows.begin(), rows.end());
  }
  const Station* governing = governing_station_of(result);
  if (in_space(project) && governing != nullptr) {
    result.loads_over_time = loads_over_time(project, runs, *governing);
  }
  if (project.chain) {
    const auto largest_M =
        std::find_if(result.critical_instants.begin(), result.critical_instants.end(),
                     [](const CriticalInstant& c) { return c.quantity == "M"; });
    const SituationRun& run = run_of(runs, project.situations[largest_M->situation]);
    planar::StateFinder finder(planar_in(project, *run.situation), planar_motion_of(run));
    result.chain = compare_chain(project, finder.at(largest_M->time.value()));
  }
}

DigitsLeft digits_left_over(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  const auto worst = std::min_element(
      motion.states.begin(), motion.states.end(),
      [](const planar::State& a, const planar::State& b) { return a.pivot < b.pivot; });
  return {planar::digits_left_at(planar::condition_of(mechanism, worst->q)), si<Time>(worst->time)};
}

ClosureSummary closure_of(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  ClosureSummary closure;
  closure.freedom = motion.freedom;
  closure.branch = planar::branch_of(mechanism, motion.states.front().q);
  if (motion.freedom.undriven == 0) closure.digits = digits_left_over(mechanism, motion);
  closure.change_points = motion.change_points;
  for (const planar::State& state : motion.states) {
    closure.largest_residual = std::max(closure.largest_residual, state.residual);
  }
  return closure;
}

MotionSummary summary_of(const Project& project, const SituationRun& run) {
  MotionSummary summary;
  summary.situation = index_of(project, *run.situation);
  // Of a history that stays open, its end is an instant of its own.
  summary.instants = run.loads.instants() - (run.loads.closed() ? 0 : 1);
  summary.begin = run.loads.begin();
  summary.period = run.loads.period();
  summary.closed = run.loads.closed();
  summary.imbalance = run.imbalance;
  if (std::holds_alternative<planar::Motion>(run.motion)) {
    summary.closure = closure_of(planar_in(project, *run.situation), planar_motion_of(run));
  }
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

/// The checks beside the stresses of the beam, which the case asks for.
void check_neighbours(const Project& project, const std::deque<SituationRun>& runs,
                      Verification& result) {
  result.neighbours = check_pins(project, runs);
  for (NeighbourResult& rod : check_rods(project, runs))
    result.neighbours.push_back(std::move(rod));
  for (const NeighbourResult& neighbour : result.neighbours) {
    result.checks.push_back({neighbour.check, {}});
  }
  if (!project.deflection) return;
  if (const auto deflection = check_deflection(project, runs)) {
    result.checks.push_back({*deflection, {}});
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
  if (in_space(project)) return all;
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

Verification verify(const Project& project, [[maybe_unused]] Figures figures) {
  const auto [model, runs] = run_by_chosen_model(project);
  const std::vector<Station> stations = stations_to_verify(project, runs);

  Verification result;
  result.model = model;
  describe_mechanism(project, runs, result);
  result.stations = cut_force_envelopes(project, runs, stations);
  const bool computed = project.given_stresses.empty();
  result.checks = computed ? check_beam(project, runs, stations) : check_given_stresses(project);
  check_neighbours(project, runs, result);
  sort_worst_first(result.checks);
  if (computed) result.gates = gates_of(project, runs, stations, result.checks);
  for (Gate& gate : model_gates_of(project, model)) result.gates.push_back(std::move(gate));
  result.verdict = verdict_of(result);
  result.codes = compare_codes(project, result.checks);
  result.critical_instants = critical_instants_of(project, result);
  describe_instants(project, runs, result);
  describe_beam(project, result);
  if (const CheckResult* fatigue = result.governing(Criterion::fatigue)) {
    result.sn = sn_figure(project, *fatigue);
  }
  return result;
}

}  // namespace boxbeam
