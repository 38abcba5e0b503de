#include "boxbeam/verification/verify.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam {
namespace {

/// Stops where a joint has slid off the end of the beam.
void check_on_beam(const Project& project, const BeamLoads& loads, Time time) {
  const double length = project.beam.length().value();
  for (const PointLoad& load : loads.points) {
    const double s = load.s.value();
    if (s >= -1e-9 * length && s <= (1.0 + 1e-9) * length) continue;
    throw AnalysisError({fmt::format("a joint slides off the beam: it stands at s = {:.6g} m, and "
                                     "the beam goes from 0 to {:.6g} m",
                                     s, length),
                         "beam",
                         time.value(),
                         {},
                         {}});
  }
}

/// Where the loads on the beam come from at any time: the mechanism's reactions or the chain.
LoadsAt loads_of(const Project& project, const planar::Motion& motion) {
  auto finder = std::make_shared<planar::StateFinder>(project.mechanism, motion);
  if (project.dynamics == Dynamics::newton_chain) {
    auto distribution = mass_distribution_of(project.beam);
    return [&project, finder, distribution](Time time) {
      return planar::beam_loads_of(*project.chain, project.beam, distribution,
                                   project.mechanism.gravity, finder->at(time.value()));
    };
  }
  auto body = planar::beam_body_of(project.beam, project.beam_body);
  return [&project, finder, body](Time time) {
    BeamLoads loads = planar::beam_loads_of(project.mechanism, finder->at(time.value()), body);
    check_on_beam(project, loads, time);
    return loads;
  };
}

LoadHistory loads_on_beam(const Project& project, const planar::Motion& motion) {
  const LoadSpan span{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(),
                      motion.closed};
  return {project.beam, span, loads_of(project, motion)};
}

/// Largest force and moment left over on the beam, relative to the largest joint force. Anything
/// but round-off means that the loads do not belong to this beam.
double imbalance_over(const Project& project, const LoadHistory& loads) {
  double worst = 0.0;
  for (std::size_t i = 0; i < loads.instants(); i += loads.instants() / 16) {
    const Time time = loads.time_of(i);
    const BeamLoads at = loads.loads_at(time);
    double largest =
        mass_properties_of(project.beam).mass.value() * project.mechanism.gravity.norm();
    for (const PointLoad& load : at.points) largest = std::max(largest, load.force.norm());
    if (largest == 0.0) continue;
    const Imbalance open = imbalance_of(project.beam, at);
    const double relative =
        (open.force.norm() + open.moment.norm() / project.beam.length().value()) / largest;
    worst = std::max(worst, relative);
    if (relative > 1e-6) {
      throw AnalysisError(
          {"the loads on the beam are not in balance", "beam", time.value(), relative, {}});
    }
  }
  return worst;
}

Envelope envelope_of(const StationHistory& history, const CutForceFunction& f) {
  TurningPoint low = history.largest([&](const CutForces& cut) { return -f(cut); });
  low.value *= -1.0;
  low.maximum = false;
  return {low, history.largest(f)};
}

double axial(const CutForces& cut) { return cut.N.value(); }
double shear(const CutForces& cut) { return cut.V_z.value(); }
double bending(const CutForces& cut) { return cut.M_y.value(); }

std::vector<StationEnvelope> cut_force_envelopes(const Project& project, const LoadHistory& loads,
                                                 const std::vector<Station>& stations) {
  std::vector<StationEnvelope> envelopes;
  const auto add = [&](const Station& station) {
    const StationHistory history(loads, station);
    envelopes.push_back({station, envelope_of(history, axial), envelope_of(history, shear),
                         envelope_of(history, bending)});
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

std::vector<CriticalInstant> critical_instants_of(const Verification& verification) {
  std::vector<CriticalInstant> instants;
  const auto add = [&](const char* name, Envelope StationEnvelope::*quantity,
                       TurningPoint Envelope::*end) {
    const StationEnvelope* best = nullptr;
    for (const StationEnvelope& station : verification.stations) {
      const double value = (station.*quantity.*end).value;
      if (best == nullptr) best = &station;
      const double so_far = (best->*quantity.*end).value;
      if (end == &Envelope::largest ? value > so_far : value < so_far) best = &station;
    }
    const TurningPoint& point = best->*quantity.*end;
    instants.push_back({name, best->station, point.time, point.value});
  };
  for (const auto end : {&Envelope::largest, &Envelope::smallest}) {
    add("N", &StationEnvelope::N, end);
    add("V", &StationEnvelope::V, end);
    add("M", &StationEnvelope::M, end);
  }
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  if (governing == nullptr || !governing->basis)
    governing = verification.governing(Criterion::yield);
  if (governing != nullptr && governing->basis) {
    const auto add_stress = [&](const TurningPoint& point) {
      instants.push_back({"stress", governing->check.station, point.time, point.value});
    };
    add_stress(governing->basis->highest);
    if (governing->check.criterion == Criterion::fatigue) add_stress(governing->basis->lowest);
  }
  return instants;
}

/// Whether an extreme is the upper or the lower one of its quantity, and what to call it; "" where
/// it is nothing beside the other.
std::string name_of_extreme(const std::vector<CriticalInstant>& instants,
                            const CriticalInstant& instant) {
  double highest = instant.value;
  double size = 0.0;
  for (const CriticalInstant& other : instants) {
    if (other.quantity != instant.quantity) continue;
    highest = std::max(highest, other.value);
    size = std::max(size, std::abs(other.value));
  }
  if (std::abs(instant.value) < 1e-6 * size) return "";
  const bool upper = instant.value == highest;
  if (upper) return (instant.value > 0.0 ? "largest " : "least negative ") + instant.quantity;
  return (instant.value > 0.0 ? "smallest " : "most negative ") + instant.quantity;
}

/// The distinct times of the extremes of bending and stress: the instants worth drawing.
std::vector<std::pair<Time, std::string>> instants_to_show(const Verification& verification) {
  std::vector<std::pair<Time, std::string>> shown;
  for (const CriticalInstant& instant : verification.critical_instants) {
    if (instant.quantity != "M" && instant.quantity != "stress") continue;
    const std::string why = name_of_extreme(verification.critical_instants, instant);
    if (why.empty()) continue;
    const auto same = std::find_if(shown.begin(), shown.end(), [&](const auto& other) {
      return abs(other.first - instant.time) < 0.01 * verification.period;
    });
    if (same == shown.end())
      shown.emplace_back(instant.time, why);
    else
      same->second += ", " + why;
  }
  std::sort(shown.begin(), shown.end());
  return shown;
}

double beam_angle(const Project& project, const planar::State& state) {
  const int body =
      project.beam_body != planar::ground ? project.beam_body : project.chain->axis_body;
  return state.q[3 * body + 2];
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
      chain, project.beam, mass_distribution_of(project.beam), project.mechanism.gravity, state);
  comparison.moment_gap = si<Moment>(loads.points.back().moment.y());
  comparison.rigorous_first.setZero();
  comparison.rigorous_second.setZero();
  if (project.beam_body == planar::ground) return comparison;
  const auto body = planar::beam_body_of(project.beam, project.beam_body);
  const BeamLoads rigorous = planar::beam_loads_of(project.mechanism, state, body);
  for (const BeamLoadRow& row :
       load_rows(project, rigorous, comparison.time, beam_angle(project, state))) {
    if (row.s == chain.first_station) comparison.rigorous_first += row.world;
    if (row.s == chain.second_station) comparison.rigorous_second += row.world;
  }
  return comparison;
}

/// What the report shows of the instants that decide.
void describe_instants(const Project& project, const planar::Motion& motion,
                       const LoadHistory& loads, Verification& result) {
  planar::StateFinder finder(project.mechanism, motion);
  result.postures.push_back(posture_figure(project, motion.states.front(), "beginning"));
  for (const auto& [time, why] : instants_to_show(result)) {
    const planar::State state = finder.at(time.value());
    result.lines.push_back(cut_force_line(loads, time, why));
    auto rows = load_rows(project, loads.loads_at(time), time, beam_angle(project, state));
    place_loads(project, state, rows);
    result.loads.insert(result.loads.end(), rows.begin(), rows.end());
    result.postures.push_back(posture_figure(project, state, why));
    result.postures.back().loads = rows;
  }
  result.envelope = envelope_lines(loads);
  if (project.chain) {
    const auto largest_M =
        std::find_if(result.critical_instants.begin(), result.critical_instants.end(),
                     [](const CriticalInstant& c) { return c.quantity == "M"; });
    result.chain = compare_chain(project, finder.at(largest_M->time.value()));
  }
}

/// Stops where rigid bodies do not determine what acts on the beam.
void check_unique_loads(const Project& project, const planar::Motion& motion) {
  const planar::Mechanism& mechanism = project.mechanism;
  std::string names;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const auto [a, b] = planar::ends_of(mechanism.joints[i]);
    const bool on_beam = a.body == project.beam_body || b.body == project.beam_body;
    const bool rubs = planar::rubs(mechanism.joints[i]);
    if (!on_beam && !rubs) continue;
    if (planar::is_unique(mechanism, motion.freedom, static_cast<int>(i))) continue;
    names += (names.empty() ? "joint " : ", ") + mechanism.joints[i].name;
  }
  if (names.empty() || project.beam_body == planar::ground) return;
  throw AnalysisError(
      {fmt::format("the loads on the beam are not determined by rigid bodies: joints repeat each "
                   "other ({}), and how they share their load depends on their stiffness; release "
                   "one of them (a slot for a pin, a slider without its angle)",
                   fmt::join(planar::names_of_joints(mechanism, motion.freedom.repeating), ", ")),
       names,
       {},
       {},
       {}});
}

DigitsLeft digits_left_over(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  const auto worst = std::min_element(
      motion.states.begin(), motion.states.end(),
      [](const planar::State& a, const planar::State& b) { return a.pivot < b.pivot; });
  return {planar::digits_left_at(planar::condition_of(mechanism, worst->q)), si<Time>(worst->time)};
}

void describe_mechanism(const Project& project, const planar::Motion& motion,
                        Verification& result) {
  const planar::State& first = motion.states.front();
  result.freedom = motion.freedom;
  result.branch = planar::branch_of(project.mechanism, first.q);
  result.instants = motion.states.size();
  result.begin = si<Time>(motion.begin);
  result.period = si<Time>(motion.period);
  result.closed = motion.closed;
  result.change_points = motion.change_points;
  if (motion.freedom.undriven == 0) result.digits = digits_left_over(project.mechanism, motion);
  for (const planar::State& state : motion.states) {
    result.largest_residual = std::max(result.largest_residual, state.residual);
  }
  result.beam_mass = mass_properties_of(project.beam);
  if (project.equivalent_mass) {
    const EquivalentMassDemand& demand = *project.equivalent_mass;
    result.equivalent_mass = planar::equivalent_mass_of(
        project.mechanism, motion, demand.joint, demand.on, demand.adjust, demand.wanted.value());
  }
}

/// Plates of class 4: their gross elastic stress says nothing about their strength.
std::vector<Gate> gates_of(const Project& project) {
  std::vector<Gate> gates;
  for (const Segment& segment : project.beam.segments) {
    for (const Section* section : {&segment.from, &segment.to}) {
      if (section == &segment.to && segment.from == segment.to) continue;
      for (const SlenderPlate& plate : slender_plates_of(section->outer, project.material)) {
        gates.push_back({segment.name, plate});
      }
      if (!section->inner) continue;
      for (const SlenderPlate& plate : slender_plates_of(*section->inner, project.material)) {
        gates.push_back({segment.name, plate});
      }
    }
  }
  return gates;
}

void describe_beam(const Project& project, Verification& result) {
  for (const Segment& segment : project.beam.segments) {
    const Length rise = 0.5 * abs(height_of(segment.to.outer) - height_of(segment.from.outer));
    if (rise.value() == 0.0) continue;
    const double slope = std::atan2(rise.value(), segment.length.value());
    result.tapers.push_back({segment.name, slope});
  }
  for (std::size_t i = 0; i < project.beam.holes.size(); ++i) {
    if (project.hole_cases[i] != HoleCase::published_exponential) continue;
    const BeamHole& at = project.beam.holes[i];
    const Section section = section_at(project.beam, {at.s});
    const double a = at.hole.diameter / plate_width_of(section, holes_at(project.beam, at.s),
                                                       at.hole, project.hole_cases[i]);
    result.published_concentrations.push_back({at.hole.name, a, published_concentration(a)});
  }
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

const CheckResult* Verification::governing(Criterion criterion) const {
  for (const CheckResult& result : checks) {
    if (result.check.criterion == criterion) return &result;
  }
  return nullptr;
}

Verification verify(const Project& project) {
  const planar::Motion motion = planar::solve_motion(project.mechanism);
  check_unique_loads(project, motion);
  const LoadHistory loads = loads_on_beam(project, motion);
  const std::vector<Station> stations = stations_to_verify(project, loads);

  Verification result;
  describe_mechanism(project, motion, result);
  result.imbalance = imbalance_over(project, loads);
  result.stations = cut_force_envelopes(project, loads, stations);
  result.checks = project.given_stresses.empty() ? check_beam(project, loads, stations)
                                                 : check_given_stresses(project);
  sort_worst_first(result.checks);
  const bool all_pass = std::all_of(result.checks.begin(), result.checks.end(),
                                    [](const CheckResult& r) { return r.check.passes(); });
  result.gates = project.given_stresses.empty() ? gates_of(project) : std::vector<Gate>{};
  result.verdict = !all_pass              ? Verdict::fail
                   : result.gates.empty() ? Verdict::pass
                                          : Verdict::not_applicable;
  result.critical_instants = critical_instants_of(result);
  describe_instants(project, motion, loads, result);
  describe_beam(project, result);
  if (const CheckResult* fatigue = result.governing(Criterion::fatigue)) {
    result.sn = sn_figure(project, *fatigue);
  }
  return result;
}

}  // namespace boxbeam
