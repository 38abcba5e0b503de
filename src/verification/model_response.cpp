#include "boxbeam/verification/model_response.hpp"

#include "boxbeam/core/angle.hpp"

namespace boxbeam {
namespace {

using flexible::Complex;

ModelResponse static_part(const flexible::Structure& structure) {
  ModelResponse result;
  result.response.frequency = structure.mechanism->frequency;
  result.response.constant = flexible::static_response(structure);
  result.inertial = flexible::no_loads<Complex>(structure);
  result.response.harmonic.motion = result.inertial;
  result.response.harmonic.joints =
      Eigen::Matrix3Xcd::Zero(3, static_cast<Eigen::Index>(structure.joints.size()));
  return result;
}

/// Rigid links may stand still on joints without give, where there is no resonance to look for.
ModelResponse rigid_response(const flexible::Structure& structure) {
  ModelResponse result = static_part(structure);
  const double omega = full_turn * result.response.frequency;
  if (omega == 0.0) return result;
  result.response.harmonic = flexible::DynamicStiffness<Complex>(structure, omega * omega, omega)
                                 .solve(flexible::harmonic_loads(structure));
  result.inertial = result.response.harmonic.motion;
  return result;
}

}  // namespace

ModelResponse modal_response(const flexible::ModalModel& model) {
  const flexible::Structure& structure = *model.structure;
  ModelResponse result = static_part(structure);
  const double frequency = result.response.frequency;
  if (frequency == 0.0) return result;
  if (model.modes.empty()) {
    result.response.harmonic = flexible::DynamicStiffness<Complex>(structure, 0.0, 0.0)
                                   .solve(flexible::harmonic_loads(structure));
    return result;
  }
  result.response.harmonic = flexible::harmonic_response(model, frequency);
  result.inertial = flexible::harmonic_response(model, frequency, false).motion;
  return result;
}

ModelResponse response_of(const flexible::Structure& structure, const ElasticModel& model) {
  switch (model.level) {
    case ModelLevel::quasi_static: return modal_response({&structure, {}, {}});
    case ModelLevel::modal:
      return modal_response(
          flexible::modal_model_of(structure, static_cast<std::size_t>(model.modes)));
    case ModelLevel::rigid: return rigid_response(structure);
    case ModelLevel::flexible: break;
  }
  ModelResponse result = static_part(structure);
  const double frequency = result.response.frequency;
  if (frequency == 0.0) return result;
  result.response.harmonic = flexible::harmonic_response(structure, frequency);
  result.inertial = result.response.harmonic.motion;
  return result;
}

}  // namespace boxbeam
