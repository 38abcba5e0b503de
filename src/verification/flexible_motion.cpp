#include "boxbeam/verification/flexible_motion.hpp"

#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {
namespace {

/// Static response to loads and to the inertia of a motion, as phasors.
flexible::Deformation<flexible::Complex> static_response_to(
    const flexible::Structure& structure, const flexible::LinkColumns<flexible::Complex>& inertial,
    double frequency) {
  const double square = std::pow(full_turn * frequency, 2);
  flexible::LinkColumns<flexible::Complex> loads = flexible::harmonic_loads(structure);
  const auto inertia = flexible::mass_times(structure, inertial);
  for (std::size_t k = 0; k < loads.size(); ++k) loads[k] += square * inertia[k];
  return flexible::DynamicStiffness<flexible::Complex>(structure, 0.0, 0.0).solve(loads);
}

}  // namespace

FlexibleMotion flexible_motion_of(const flexible::Mechanism& of, const ElasticModel& model) {
  FlexibleMotion motion;
  motion.mechanism = std::make_shared<const flexible::Mechanism>(modelled(of, model));
  motion.structure =
      std::make_shared<const flexible::Structure>(flexible::structure_of(*motion.mechanism));
  const flexible::Structure& structure = *motion.structure;
  const bool reduced = model.level == ModelLevel::quasi_static || model.level == ModelLevel::modal;
  if (!reduced || of.frequency == 0.0) {
    motion.response = flexible::response_of(structure);
    motion.inertial = motion.response.harmonic.motion;
    return motion;
  }
  motion.response.frequency = of.frequency;
  motion.response.constant = flexible::static_response(structure);
  motion.inertial = flexible::no_loads<flexible::Complex>(structure);
  if (model.level == ModelLevel::modal) {
    const flexible::ModalModel modes =
        flexible::modal_model_of(structure, static_cast<std::size_t>(model.modes));
    motion.inertial = flexible::harmonic_response(modes, of.frequency, false).motion;
  }
  motion.response.harmonic = static_response_to(structure, motion.inertial, of.frequency);
  return motion;
}

}  // namespace boxbeam
