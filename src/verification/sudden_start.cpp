#include "boxbeam/verification/sudden_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/start_loads.hpp"
#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {
namespace {

/// A start is resolved by so many modes at most.
constexpr std::size_t most_modes_of_start = 192;

constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

flexible::Mechanism with_modes_of_division(flexible::Mechanism mechanism) {
  if (mechanism.element == flexible::Element::exact) {
    mechanism.element = flexible::Element::corrected;
  }
  return mechanism;
}

flexible::Mechanism with_all_elements(const flexible::Mechanism& of, const ElasticModel& model) {
  flexible::Mechanism mechanism =
      modelled(of, {ModelLevel::flexible, 0, 0, model.element, model.axial});
  for (flexible::Link& link : mechanism.links) link.parts = std::max(link.parts, model.parts);
  return mechanism;
}

flexible::ModalModel modal_model_beyond(const flexible::Structure& structure, double drive) {
  constexpr std::size_t fewest = 24;
  for (std::size_t count = fewest;; count *= 2) {
    flexible::ModalModel model = flexible::modal_model_of(structure, count);
    const bool all = model.modes.size() < count;
    if (all || count >= most_modes_of_start || model.modes.back().frequency >= 3.0 * drive)
      return model;
  }
}

StartSpan start_span_of(const flexible::ModalModel& model) {
  constexpr double bears = 0.01, most_steps = 40000.0, gone = 0.01;
  constexpr double periods = 8.0, fewest_periods = 1.25;  // in which it pushes and pulls
  const double drive = model.structure->mechanism->frequency;
  const flexible::StartShares shares = flexible::start_shares_of(model);
  double fastest = 2.0 * drive, length = 0.0;
  for (std::size_t i = 0; i < model.modes.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    const double own = model.modes[i].frequency;
    if (!(own > 0.0)) continue;
    if (shares.free[j] >= bears) fastest = std::max(fastest, own);
    if (std::max(shares.free[j], shares.driven[j]) < bears) continue;
    // It beats with the drive, which ends where its own vibration has died away.
    const double damping = 0.5 * model.damping(j, j);
    const double dies = damping > 0.0 ? -std::log(gone) / damping : unbounded;
    length = std::max({length, 3.0 / own, std::min(1.0 / std::abs(drive - own), dies)});
  }
  const double rate = 10.0 * fastest;
  const auto steps_over = [&](double time) { return std::ceil(rate * std::max(length, time)); };
  double steps = steps_over(periods / drive);
  if (!(steps <= most_steps))
    steps = std::max(std::min(steps, most_steps), steps_over(fewest_periods / drive));
  return {steps / rate, steps, fastest, steps <= most_steps};
}

LoadHistory loads_after_start(const Project& project, const Situation& situation,
                              const ElasticModel& model) {
  const flexible::Mechanism mechanism = with_all_elements(flexible_in(project, situation), model);
  if (mechanism.element == flexible::Element::exact) {
    throw AnalysisError(
        {"a sudden start is the sum of the modes of divided links, which the exact "
         "form has not; write element = \"corrected\"",
         "mechanism"});
  }
  if (mechanism.frequency == 0.0) {
    throw AnalysisError({"no load vibrates: there is nothing to start", "mechanism"});
  }
  // The structure looks at its mechanism, and both stay as long as the loads are asked for.
  auto of = std::make_shared<const flexible::Mechanism>(mechanism);
  auto structure = std::make_shared<const flexible::Structure>(flexible::structure_of(*of));
  const flexible::ModalModel modal = modal_model_beyond(*structure, of->frequency);
  if (modal.modes.size() >= most_modes_of_start &&
      modal.modes.back().frequency < 3.0 * of->frequency) {
    throw AnalysisError(
        {fmt::format("{} modes of the structure lie below three times the frequency of the loads, "
                     "{:.6g} Hz: its sudden start is not resolved",
                     modal.modes.size(), of->frequency),
         "mechanism"});
  }
  auto loads = std::make_shared<const flexible::StartLoads>(
      *structure, project.beam_body, project.beam, flexible::SuddenStartModes(modal));
  const StartSpan start = start_span_of(modal);
  if (!start.is_resolved) {
    throw AnalysisError(
        {fmt::format(
             "a sudden start at {:.6g} Hz has its peak after as long as {:.4g} s, which takes "
             "more steps than can be looked at where modes up to {:.4g} Hz vibrate: more "
             "damping, or a frequency farther from that of a mode, makes it shorter",
             of->frequency, start.length, start.fastest),
         "mechanism"});
  }
  const LoadSpan span{Time{}, si<Time>(start.length), static_cast<std::size_t>(start.steps), false};
  return {span, [of, structure, loads](Time time) { return loads->at(time.value()); }};
}

}  // namespace boxbeam
