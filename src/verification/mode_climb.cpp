#include "model_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/model_ladder.hpp"
#include "modal_transient.hpp"

namespace boxbeam {
namespace {

/// Of each elastic link of a modal model. Beyond the most the climb takes minutes.
constexpr int fewest_parts_climbed = 8, most_parts_climbed = 64;

void choose_modes(const Climb& climb, const ModelEstimate& by_modes, ModelChoice& choice) {
  choice.chosen = by_modes.model;
  choice.reason = fmt::format(
      "{}: {}; rigid bodies: {}; {} estimated to miss {}, found {} against one mode "
      "more and twice the parts",
      describe(choice.chosen), climb.against, climb.missed,
      by_modes.model.modes == 1 ? "this mode is" : "these modes are", percent_text(by_modes.error),
      percent_text(*by_modes.found));
}

}  // namespace

double missed_beside_mode(double found, const VibrationEstimate& estimate) {
  const std::vector<double>& missed = estimate.without_modes;
  return found + (missed.size() > 1 ? missed[1] : estimate.left_out);
}

std::string missed_text(const VibrationEstimate& estimate, const ModelChoice& choice) {
  return fmt::format(
      "vibration is estimated to change the governing stress by {}, {}; tolerance {}",
      percent_text(estimate.without_modes.front()), second_order_text(choice.second_order),
      percent_text(choice.tolerance));
}

std::string against_frequencies(const VibrationEstimate& estimate, const std::string& beside) {
  std::string text = fmt::format(
      "the lowest natural frequency of the beam in its mechanism, with all masses attached, is "
      "{:.4g} Hz{}",
      estimate.frequencies.front(), beside);
  if (!estimate.harmonics.empty()) {
    const LoadHarmonic& highest = estimate.harmonics.back();
    text += fmt::format(
        ", {:.3g} times the highest harmonic with more than 1 % of its bending moment, {:.4g} Hz",
        estimate.frequencies.front() / highest.frequency, highest.frequency);
  }
  return text;
}

std::string too_fast(const std::deque<SituationRun>& rigid, const std::vector<double>& frequencies,
                     std::size_t modes, bool held_behind) {
  // Other postures and finer parts have somewhat faster modes.
  constexpr double elsewhere = 1.3;
  const double fastest = frequencies[std::min(modes, frequencies.size()) - 1];
  for (const SituationRun& run : rigid) {
    const double period = run.loads.period().value();
    constexpr double least_behind = 3.0;  // periods of the lowest mode
    const double length = period + (held_behind ? least_behind / frequencies.front() : 0.0);
    if (run.loads.closed() ||
        elsewhere * instants_to_a_period * fastest * length <= most_vibrating_instants)
      continue;
    return fmt::format(
        "the motion holds {:.0f} periods of {:.4g} Hz, more than {:.0f} instants "
        "resolve; a shorter time can be looked at",
        period * fastest, fastest, most_vibrating_instants);
  }
  return "";
}

std::string climb_modes(const VibrationEstimate& estimate, const Climb& climb,
                        ModelChoice& choice) {
  int parts = fewest_parts_climbed;
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k) {
    const auto weigh = [&]() -> ModelEstimate& {
      ModelEstimate& by_modes = choice.weighed.emplace_back();
      by_modes.model = {ModelLevel::modal, static_cast<int>(k), parts, {}, false,
                        climb.bends_twice};
      by_modes.error = estimate.without_modes[k];
      by_modes.basis =
          fmt::format("modes left out, and {} that the beam's rotation couples with its vibration",
                      percent_text(estimate.left_out));
      return by_modes;
    };
    if (weigh().error > choice.tolerance) continue;
    if (climb.unseen && climb.unseen(k)) return "";
    for (ModelEstimate* by_modes = &choice.weighed.back();; by_modes = &weigh()) {
      by_modes->found = climb.found_by(by_modes->model) + estimate.left_out;
      if (*by_modes->found <= choice.tolerance) {
        choose_modes(climb, *by_modes, choice);
        return "";
      }
      if (!climb.missed_by_parts || !std::isfinite(*by_modes->found)) break;
      // What the division into parts misses by itself no other modes mend.
      const double of_parts = climb.missed_by_parts();
      if (!std::isfinite(of_parts)) break;
      if (of_parts + estimate.left_out <= choice.tolerance) break;
      if (2 * parts > most_parts_climbed)
        return fmt::format("{} parts of each elastic link and twice as many differ by {}", parts,
                           percent_text(of_parts));
      parts *= 2;
    }
  }
  return estimate.left_out > choice.tolerance
             ? fmt::format(
                   "what the beam's rotation couples with its vibration, of the order of {}, "
                   "is in none of them and is the least error that can be asked for",
                   percent_text(estimate.left_out))
             : fmt::format("{} modes of the beam are not known to be within {} either",
                           estimate.without_modes.size() - 1, percent_text(choice.tolerance));
}

}  // namespace boxbeam
