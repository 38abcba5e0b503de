#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "boxbeam/verification/model_ladder.hpp"
#include "front_ends.hpp"

namespace boxbeam {
namespace {

LadderCase ladder_case(const Project& project, const Situation& situation) {
  return {&flexible_in(project, situation), project.beam_body, &project.beam};
}

/// A model that the user demands, with the error that it is found to have.
ModelChoice demanded(const Project& project, const ElasticModel& model) {
  ModelChoice choice;
  choice.chosen = model;
  choice.tolerance = project.model.tolerance;
  ModelEstimate& estimate = choice.weighed.emplace_back();
  estimate.model = model;
  estimate.basis = "as demanded";
  for (const Situation& situation : project.situations) {
    if (!situation.runs()) continue;
    const LadderCase of = ladder_case(project, situation);
    estimate.error = std::max(estimate.error, error_of(of, model));
    choice.harmonics = {{of.mechanism->frequency, 1.0}};
  }
  estimate.found = estimate.error;
  choice.reason = fmt::format(
      "{}, as demanded: found {} from all elements of a finer division with all elasticity, "
      "where {} would be the tolerance",
      describe(model), percent_text(estimate.error), percent_text(choice.tolerance));
  return choice;
}

/// The exact form, which the case asks for by name, has no division to weigh: whether links are
/// elastic along their axes.
ModelChoice choose_exact(const Project& project) {
  const auto exact = [](bool axial) {
    return ElasticModel{ModelLevel::flexible, 0, 0, flexible::Element::exact, axial};
  };
  ModelChoice choice;
  choice.tolerance = project.model.tolerance;
  double largest = 0.0;
  for (const Situation& situation : project.situations) {
    if (!situation.runs()) continue;
    const LadderCase of = ladder_case(project, situation);
    const std::vector<ComparedPlace> places = places_of(of);
    largest = std::max(largest, difference_between(stresses_by(of, exact(false), places),
                                                   stresses_by(of, exact(true), places)));
    choice.harmonics = {{of.mechanism->frequency, 1.0}};
  }
  const bool axial = largest > choice.tolerance;
  choice.weighed.push_back({exact(false), "elasticity along the axes", largest, largest});
  if (axial) choice.weighed.push_back({exact(true), "no error of division", 0.0, 0.0});
  choice.chosen = exact(axial);
  choice.reason = fmt::format(
      "{}: the exact form of the links, as the case says, has no error of division; bending links "
      "taken as rigid along their axes would change the governing stress by {}, tolerance {}",
      describe(choice.chosen), percent_text(largest), percent_text(choice.tolerance));
  return choice;
}

/// What either of two models counts.
ElasticModel both(const ElasticModel& a, const ElasticModel& b) {
  ElasticModel most;
  most.level = std::max(a.level, b.level);
  most.modes = most.level == ModelLevel::modal ? std::max(a.modes, b.modes) : 0;
  most.parts = std::max(a.parts, b.parts);
  most.element = a.element ? a.element : b.element;
  most.axial = a.axial || b.axial;
  return most;
}

/// One model for situations that each ask for their own: what any of them counts. Where that is
/// not good enough for all, whose errors may cancel, all elements of the finer division that each
/// was verified against.
ModelChoice for_all(const Project& project, const std::vector<ModelChoice>& choices,
                    const std::vector<const Situation*>& of) {
  const auto cost = [](const ElasticModel& model) {
    return std::tuple(model.level, model.modes, model.parts, model.axial);
  };
  const auto costliest = std::max_element(
      choices.begin(), choices.end(),
      [&](const ModelChoice& a, const ModelChoice& b) { return cost(a.chosen) < cost(b.chosen); });
  ModelChoice choice = *costliest;
  choice.harmonics.clear();
  for (const ModelChoice& one : choices) {
    choice.chosen = both(choice.chosen, one.chosen);
    for (const LoadHarmonic& harmonic : one.harmonics) {
      const bool known =
          std::any_of(choice.harmonics.begin(), choice.harmonics.end(),
                      [&](const auto& other) { return other.frequency == harmonic.frequency; });
      if (!known) choice.harmonics.push_back(harmonic);
    }
  }
  const std::string& asking = of[static_cast<std::size_t>(costliest - choices.begin())]->name;
  choice.reason = fmt::format("situation \"{}\" asks for most: {}", asking, costliest->reason);
  const bool same = std::all_of(choices.begin(), choices.end(), [&](const ModelChoice& one) {
    return cost(one.chosen) == cost(choice.chosen);
  });
  if (same) return choice;
  const auto largest_error = [&] {
    double error = 0.0;
    for (const Situation* situation : of) {
      error = std::max(error, error_of(ladder_case(project, *situation), choice.chosen));
    }
    return error;
  };
  double found = largest_error();
  if (found > choice.tolerance) {
    constexpr int fewest = 32;
    const int parts = std::max(fewest, 2 * choice.chosen.parts);
    choice.chosen = {ModelLevel::flexible, 0, parts, flexible::Element::corrected, true};
    found = largest_error();
  }
  choice.weighed.push_back({choice.chosen, "the most that any situation asks for", found, found});
  choice.reason += fmt::format("; all situations together: {}, found {} at most",
                               describe(choice.chosen), percent_text(found));
  return choice;
}

}  // namespace

ModelChoice choose_for_links(const Project& project) {
  if (project.model.demand == ModelDemand::rigid) return demanded(project, {});
  if (project.model.demand == ModelDemand::flexible) {
    return demanded(project, {ModelLevel::flexible, 0, 0, {}, false});
  }
  if (flexible_of(project).element == flexible::Element::exact) return choose_exact(project);
  std::vector<ModelChoice> choices;
  std::vector<const Situation*> of;
  for (const Situation& situation : project.situations) {
    if (!situation.runs()) continue;
    choices.push_back(climb_ladder(ladder_case(project, situation), project.model.tolerance));
    of.push_back(&situation);
  }
  if (choices.size() == 1) return choices.front();
  return for_all(project, choices, of);
}

}  // namespace boxbeam
