#include "boxbeam/verification/sudden_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/start_loads.hpp"
#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {
namespace {

/// A start is resolved by so many modes at most.
constexpr std::size_t most_modes_of_start = 192;

/// By so many at least, and up to so many times the frequency of the drive.
constexpr std::size_t fewest_modes = 24;
constexpr double beyond_drive = 3.0;

constexpr double unbounded = std::numeric_limits<double>::infinity();

void add_modes(VibratingModes& of) {
  of.structure = std::make_shared<const flexible::Structure>(flexible::structure_of(*of.mechanism));
  for (std::size_t count = fewest_modes;; count *= 2) {
    of.modal = flexible::modal_model_of(*of.structure, count);
    const std::vector<flexible::Mode>& modes = of.modal.modes;
    const bool all = modes.size() < count;
    if (all || count >= most_modes_of_start ||
        modes.back().frequency >= beyond_drive * of.mechanism->frequency)
      return;
  }
}

/// Of the exact form: the structure must be resolved at the last of them, so they are counted
/// before they are looked for.
void add_exact_modes(VibratingModes& of) {
  const flexible::Structure coarse = flexible::structure_of(*of.mechanism);
  const auto below = [&](double square) { return flexible::frequencies_below(coarse, square); };
  const double least = std::pow(full_turn * beyond_drive * of.mechanism->frequency, 2);
  double square = std::max(least, 1.0);
  std::size_t count = below(square);
  // Links without mass have no more modes, however far one looks.
  for (int step = 0; count < fewest_modes && step < 20; ++step) count = below(square *= 4.0);
  of.structure =
      std::make_shared<const flexible::Structure>(flexible::structure_of(*of.mechanism, square));
  of.modal = flexible::modal_model_of(*of.structure, std::min(count, most_modes_of_start));
}

}  // namespace

flexible::Mechanism with_all_elements(const flexible::Mechanism& of, const ElasticModel& model) {
  flexible::Mechanism mechanism =
      modelled(of, {ModelLevel::flexible, 0, 0, model.element, model.axial});
  for (flexible::Link& link : mechanism.links) link.parts = std::max(link.parts, model.parts);
  return mechanism;
}

VibratingModes modes_beyond_drive(flexible::Mechanism mechanism) {
  VibratingModes of;
  of.mechanism = std::make_shared<const flexible::Mechanism>(std::move(mechanism));
  if (of.mechanism->element == flexible::Element::exact) {
    add_exact_modes(of);
  } else {
    add_modes(of);
  }
  return of;
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
  flexible::Mechanism mechanism = with_all_elements(flexible_in(project, situation), model);
  if (mechanism.frequency == 0.0) {
    throw AnalysisError({"no load vibrates: there is nothing to start", "mechanism"});
  }
  const VibratingModes of = modes_beyond_drive(std::move(mechanism));
  const flexible::ModalModel& modal = of.modal;
  const double drive = of.mechanism->frequency;
  if (modal.modes.size() >= most_modes_of_start &&
      modal.modes.back().frequency < beyond_drive * drive) {
    throw AnalysisError(
        {fmt::format("{} modes of the structure lie below three times the frequency of the loads, "
                     "{:.6g} Hz: its sudden start is not resolved",
                     modal.modes.size(), drive),
         "mechanism"});
  }
  auto loads = std::make_shared<const flexible::StartLoads>(
      *of.structure, project.beam_body, project.beam, flexible::SuddenStartModes(modal));
  const StartSpan start = start_span_of(modal);
  if (!start.is_resolved) {
    throw AnalysisError(
        {fmt::format(
             "a sudden start at {:.6g} Hz has its peak after as long as {:.4g} s, which takes "
             "more steps than can be looked at where modes up to {:.4g} Hz vibrate: more "
             "damping, or a frequency farther from that of a mode, makes it shorter",
             drive, start.length, start.fastest),
         "mechanism"});
  }
  const LoadSpan span{Time{}, si<Time>(start.length), static_cast<std::size_t>(start.steps), false};
  // The links stay as long as their loads are asked for.
  return {span, [mechanism = of.mechanism, structure = of.structure, loads](Time time) {
            return loads->at(time.value());
          }};
}

}  // namespace boxbeam
