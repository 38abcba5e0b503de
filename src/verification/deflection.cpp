#include "boxbeam/verification/deflection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/peak_over_time.hpp"
#include "second_order_growth.hpp"

namespace boxbeam {

std::string to_text(const MeasuredFrom& against) {
  if (std::holds_alternative<UnloadedAxis>(against)) return "unloaded axis";
  if (const auto* chord = std::get_if<Chord>(&against)) {
    return fmt::format("chord {} to {} m", to_text(Station{chord->from}),
                       to_text(Station{chord->to}));
  }
  return fmt::format("tangent at {} m", to_text(Station{std::get<Tangent>(against).at}));
}

namespace {

/// What second order makes of a deflection, w_0 by the cut forces: w = w_0/(1 - n), of one that
/// holds the second order of the loads times one w_0 (1 - n/factor)/(1 - n), n = N/N_cr under the
/// largest compression in the situation times `factor`. One for frames and elastic links, which
/// `second_order_gates_of` looks at, and where the beam buckles, which stops the verdict.
/// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 1.6.
double grown_by_second_order(const Project& project, const SituationRun& run, double factor,
                             bool counted) {
  if (std::holds_alternative<frame::Structure>(project.mechanism) ||
      std::holds_alternative<flexible::Mechanism>(project.mechanism) || (counted && factor == 1.0))
    return 1.0;
  const double once = pressed_part_in(project, run), n = factor * once;
  if (n >= 1.0) return 1.0;
  return (counted ? 1.0 - once : 1.0) / (1.0 - n);
}

std::string deflection_source(const DeflectionInput& input, const Situation& situation,
                              double grown) {
  std::string text = fmt::format("the case's limit; measured from {}", input.measured_from);
  if (input.load_factor && situation.load_factor != 1.0)
    text += fmt::format("; times the load factor {:.4g}, as the case asks", situation.load_factor);
  constexpr double worth_saying = 5e-4;
  if (grown > 1.0 + worth_saying)
    text += fmt::format("; times {:.4g} by second order, 1/(1 - N/N_cr)", grown);
  return text;
}

}  // namespace

std::optional<CheckResult> check_deflection(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            bool second_order_counted) {
  if (!project.deflection) return std::nullopt;
  const DeflectionInput& input = *project.deflection;
  const DeflectionModel model = deflection_model_of(project);
  DividedBeam beam(model);
  const auto largest_in = [&](const SituationRun& run, const CutForceDiagram& diagram, Time time) {
    return largest_of(beam.line_under(diagram, run.motion->beam_shift(time)));
  };
  Extreme worst;
  DeflectionBasis basis;
  double worst_grown = 1.0;
  Length place;
  for (const SituationRun& run : runs) {
    if (!run.situation->serviceability) continue;
    const LoadHistory& loads = run.loads;
    const double factor = input.load_factor ? run.situation->load_factor : 1.0;
    std::vector<double> values;
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      values.push_back(largest_in(run, loads.diagram(i), loads.time_of(i)).size.value());
    }
    const double begin = loads.begin().value(), end = (loads.begin() + loads.period()).value();
    const auto diagram_at = [&](double time) {
      return loads.diagram_at(si<Time>(loads.closed() ? time : std::clamp(time, begin, end)));
    };
    const Extremum peak = peak_over_time(values, sampled_time_of(loads), [&](double time) {
      return largest_in(run, diagram_at(time), si<Time>(time)).size.value();
    });
    const double grown = grown_by_second_order(project, run, factor, second_order_counted);
    const double alone = grown * peak.value;
    if (factor * alone <= worst.value) continue;
    worst = {si<Time>(peak.at), factor * alone, index_of(project, *run.situation)};
    const LargestDeflection largest = largest_in(run, diagram_at(peak.at), si<Time>(peak.at));
    basis = {si<Length>(alone), grown * largest.along, factor};
    worst_grown = grown;
    place = largest.at;
  }
  if (worst.value == 0.0) return std::nullopt;
  const Situation& situation = project.situations[worst.situation];
  CheckResult result;
  result.deflection = basis;
  Check& check = result.check;
  check.criterion = Criterion::deflection;
  check.station = {place, Side::both};
  check.point = "from " + to_text(input.against);
  check.id = fmt::format("deflection/{}/axis", to_text(check.station));
  check.situation = situation.name;
  check.time = worst.time;
  check.acting = si<Length>(worst.value);
  check.resisting = input.limit;
  check.safety_factor = check.resisting / check.acting;
  check.required = 1.0;
  check.source = deflection_source(input, situation, worst_grown);
  return result;
}

}  // namespace boxbeam
