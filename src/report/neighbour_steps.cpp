#include "sheet_steps.hpp"

#include <fmt/format.h>

#include <numbers>

#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/report/format.hpp"
#include "derivation_text.hpp"

namespace boxbeam::report {
namespace {

const char* largest_of(const LoadedPin&) { return "the largest force of the joint"; }
const char* largest_of(const ServedPin&) { return "the largest force of the joint in service"; }
const char* largest_of(const LoadedLug&) { return "the largest force of the joint"; }
const char* largest_of(const PulledRod&) { return "the largest tension"; }
const char* largest_of(const PressedRod&) { return "the largest compression"; }

const char* symbol_of(const LoadedPin&) { return "F"; }
const char* symbol_of(const ServedPin&) { return "F_ser"; }
const char* symbol_of(const LoadedLug&) { return "F"; }
const char* symbol_of(const PulledRod&) { return "N"; }
const char* symbol_of(const PressedRod&) { return "N"; }

void derive_factor(Derivation& steps, const Traced& force, const LoadedPin& pin) {
  derive_pin_factor(steps, force, pin.geometry, pin.strength);
}

void derive_factor(Derivation& steps, const Traced& force, const ServedPin& pin) {
  derive_replaceable_pin_factor(steps, force, pin.youngs_modulus, pin.geometry, pin.strength);
}

void derive_factor(Derivation& steps, const Traced& force, const LoadedLug& lug) {
  const Traced resistance =
      derive_lug_resistance(steps, lug.plate, lug.yield_strength, lug.gamma_M0);
  const Traced share = steps.given("p", lug.share, {}, "of the force, for this plate");
  steps.define("factor", resistance / (share * force));
}

void derive_factor(Derivation& steps, const Traced& tension, const PulledRod& rod) {
  derive_tension_factor(steps, tension, rod);
}

void derive_factor(Derivation& steps, const Traced& compression, const PressedRod& rod) {
  derive_compression_factor(steps, compression, rod);
}

/// A lug in fatigue: from the range of the force to the life.
Steps steps_of_basis(const Project& project, const Check& check, const TiredLug& of) {
  const LugInput& lug = *of.lug;
  Derivation steps;
  const Traced range = steps.given("d_F", of.range, "range of the pin's force");
  steps.note(
      [&] { return fmt::format("of its component {}, that takes most of the life", of.seen); });
  const Traced A_net = lug_net_area(steps, lug.plate);
  const Traced share = steps.given("p", of.share, {}, "of the force, for this plate");
  const Traced K_t = lug.own_factor
                         ? steps.given("K_t", lug.detail.stress_factor, {},
                                       "stress of the detail over that of the net section, given")
                         : lug_concentration(steps, lug.plate);
  if (!lug.own_factor) steps.note([] { return "UNCONFIRMED figures"; });
  const Traced stress = steps.define("d_sigma", K_t * share * range / A_net);
  if (of.limit) {
    const Traced f_y = steps.given("f_y", lug.yield_strength);
    const Traced limit = steps.define("limit", range_limit(steps, f_y, StressKind::direct));
    const Traced gamma_Ff =
        steps.known("gamma_Ff", project.fatigue.demand.gamma_Ff, {ValueKind::factor});
    steps.define("factor", limit / (gamma_Ff * stress));
    return steps_of(steps);
  }
  for (const SnCurve& curve : of.life.curves) derive_curve(steps, curve, &lug.detail);
  Steps all = steps_of(steps);
  append(all, life_steps(project, check, of.life));
  return all;
}

/// What is judged by its largest force.
template <class Basis>
Steps steps_of_basis(const Project&, const Check& check, const Basis& basis) {
  Derivation steps;
  const std::string when =
      fmt::format("at t = {}{}, {}", text::seconds(check.time.value()),
                  check.situation.empty() ? "" : ", " + check.situation, largest_of(basis));
  const Traced force =
      steps.given(symbol_of(basis), check.acting.value(), {ValueKind::force}, when);
  derive_factor(steps, force, basis);
  return steps_of(steps);
}

}  // namespace

Steps neighbour_steps(const Project& project, const NeighbourResult& result) {
  return std::visit([&](const auto& basis) { return steps_of_basis(project, result.check, basis); },
                    result.basis);
}

}  // namespace boxbeam::report
