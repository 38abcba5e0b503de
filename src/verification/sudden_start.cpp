#include "boxbeam/verification/sudden_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/start_loads.hpp"
#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {
namespace {

/// A start is resolved by so many modes at most.
constexpr std::size_t most_modes_of_start = 192;

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
  constexpr std::size_t shown = 6;
  constexpr double most_steps = 4000.0;
  const double drive = model.structure->mechanism->frequency;
  double slowest = drive;
  for (const flexible::Mode& mode : model.modes) {
    if (mode.frequency > 0.0) slowest = std::min(slowest, mode.frequency);
  }
  double fastest = drive;
  for (std::size_t i = 0; i < std::min(shown, model.modes.size()); ++i) {
    fastest = std::max(fastest, model.modes[i].frequency);
  }
  const double rate = 20.0 * fastest;
  const double steps = std::min(most_steps, std::ceil(rate * std::max(8.0 / drive, 3.0 / slowest)));
  return {steps / rate, static_cast<std::size_t>(steps)};
}

LoadHistory loads_after_start(const Project& project, const Situation& situation,
                              const ElasticModel& model) {
  const flexible::Mechanism mechanism = with_all_elements(flexible_in(project, situation), model);
  if (mechanism.element == flexible::Element::exact) {
    throw AnalysisError(
        {"a sudden start is the sum of the modes of divided links, which the exact "
         "form has not; write element = \"corrected\"",
         "mechanism",
         {},
         {},
         {}});
  }
  if (mechanism.frequency == 0.0) {
    throw AnalysisError({"no load vibrates: there is nothing to start", "mechanism", {}, {}, {}});
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
         "mechanism",
         {},
         {},
         {}});
  }
  auto loads = std::make_shared<const flexible::StartLoads>(
      *structure, project.beam_body, project.beam, flexible::SuddenStartModes(modal));
  const StartSpan start = start_span_of(modal);
  const LoadSpan span{Time{}, si<Time>(start.length), start.steps, false};
  return {span, [of, structure, loads](Time time) { return loads->at(time.value()); }};
}

}  // namespace boxbeam
