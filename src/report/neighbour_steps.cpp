#include "neighbour_steps.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "derivation_text.hpp"

namespace boxbeam::report {
namespace {

const char* largest_of(const LoadedPin&) { return "the largest force of the joint"; }
const char* largest_of(const ServedPin&) { return "the largest force of the joint in service"; }
const char* largest_of(const PulledRod&) { return "the largest tension"; }
const char* largest_of(const PressedRod&) { return "the largest compression"; }

const char* symbol_of(const LoadedPin&) { return "F"; }
const char* symbol_of(const ServedPin&) { return "F_ser"; }
const char* symbol_of(const PulledRod&) { return "N"; }
const char* symbol_of(const PressedRod&) { return "N"; }

void derive_factor(Derivation& steps, const Traced& force, const LoadedPin& pin) {
  derive_pin_factor(steps, force, pin.geometry, pin.strength);
}

void derive_factor(Derivation& steps, const Traced& force, const ServedPin& pin) {
  derive_replaceable_pin_factor(steps, force, pin.youngs_modulus, pin.geometry, pin.strength);
}

void derive_factor(Derivation& steps, const Traced& tension, const PulledRod& rod) {
  derive_tension_factor(steps, tension, rod);
}

void derive_factor(Derivation& steps, const Traced& compression, const PressedRod& rod) {
  derive_compression_factor(steps, compression, rod);
}

}  // namespace

Steps neighbour_steps(const NeighbourResult& result) {
  const Check& check = result.check;
  return std::visit(
      [&](const auto& basis) {
        Derivation steps;
        const std::string when =
            fmt::format("at t = {}{}, {}", text::seconds(check.time.value()),
                        check.situation.empty() ? "" : ", " + check.situation, largest_of(basis));
        const Traced force =
            steps.given(symbol_of(basis), check.acting.value(), {ValueKind::force}, when);
        derive_factor(steps, force, basis);
        return steps_of(steps);
      },
      result.basis);
}

}  // namespace boxbeam::report
