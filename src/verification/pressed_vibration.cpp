#include "pressed_vibration.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"

namespace boxbeam {
namespace {

/// The links as they are divided at the case's word, in a form that bears axial forces: corrected
/// elements in the place of the exact form.
flexible::Mechanism divided(const Project& project, const SituationRun& run) {
  constexpr int least_parts = 8;
  flexible::Mechanism mechanism = flexible_in(project, *run.situation);
  if (mechanism.element == flexible::Element::exact)
    mechanism.element = flexible::Element::corrected;
  for (flexible::Link& link : mechanism.links) link.parts = std::max(link.parts, least_parts);
  return mechanism;
}

flexible::BeamResponse response_of(const Project& project, const flexible::Structure& structure) {
  const flexible::Response response = flexible::response_of(structure);
  return flexible::beam_response_of(structure, project.beam_body, project.beam, response,
                                    response.harmonic.motion);
}

/// The response with the axial force of the static loads so many times in the beam's stiffness.
flexible::BeamResponse pressed_response_of(const Project& project, flexible::Structure structure,
                                           const CutForceDiagram& still, double factor) {
  flexible::DividedLink& link = structure.links[static_cast<std::size_t>(project.beam_body)];
  flexible::load_axially(link, [&](double s, Side side) {
    return factor * still.at({si<Length>(s), side}).N.value();
  });
  const bool held =
      flexible::parts_stand(link) &&
      flexible::DynamicStiffness<double>(structure, 0.0, 0.0).frequencies_below() == 0;
  if (!held)
    throw AnalysisError({"the beam buckles between its links, and does not vibrate", "beam"});
  return response_of(project, structure);
}

}  // namespace

BothCompared pressed_vibration_of(const Project& project, const SituationRun& run, double factor,
                                  const std::vector<ComparedPlace>& places) {
  const flexible::Mechanism mechanism = divided(project, run);
  const flexible::Structure structure = flexible::structure_of(mechanism);
  const flexible::BeamResponse straight = response_of(project, structure);
  const CutForceDiagram still = cut_forces_of(straight.constant);
  const auto rows_of = [&](double times) {
    const flexible::BeamResponse bent = pressed_response_of(project, structure, still, times);
    Compared rows;
    constexpr int instants = 48;
    for (int i = 0; i < instants; ++i) {
      const double time = mechanism.frequency > 0.0 ? i / (instants * mechanism.frequency) : 0.0;
      const Eigen::ArrayXd stress =
          fibre_stresses(cut_forces_of(flexible::beam_loads_at(straight, time)), places);
      rows.add(stress,
               fibre_stresses(cut_forces_of(flexible::beam_loads_at(bent, time)), places) - stress);
      if (mechanism.frequency == 0.0) break;
    }
    return rows;
  };
  BothCompared both;
  both.design = rows_of(factor);
  if (factor != 1.0) both.once = rows_of(1.0);
  return both;
}

}  // namespace boxbeam
