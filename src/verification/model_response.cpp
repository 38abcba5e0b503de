#include "boxbeam/verification/model_response.hpp"

namespace boxbeam {
namespace {

using flexible::Complex;

/// Elastic statics under the amplitudes of the loads.
flexible::Deformation<Complex> without_inertia(const flexible::Structure& structure) {
  flexible::Deformation<Complex> deformation =
      flexible::DynamicStiffness<Complex>(structure, 0.0, 0.0)
          .solve(flexible::harmonic_loads(structure));
  for (auto& motion : deformation.motion) motion.setZero();
  return deformation;
}

}  // namespace

flexible::Deformation<Complex> modal_response(const flexible::ModalModel& model) {
  const double frequency = model.structure->mechanism->frequency;
  flexible::Deformation<Complex> alone = flexible::harmonic_response(model, frequency, false);
  alone.joints = flexible::harmonic_response(model, frequency).joints;
  return alone;
}

flexible::Response response_of(const flexible::Structure& structure, const ElasticModel& model) {
  const double frequency = structure.mechanism->frequency;
  flexible::Response response;
  response.frequency = frequency;
  response.constant = flexible::static_response(structure);
  if (frequency == 0.0) return response;
  switch (model.level) {
    case ModelLevel::rigid:
    case ModelLevel::quasi_static: response.harmonic = without_inertia(structure); break;
    case ModelLevel::modal:
      response.harmonic = modal_response(
          flexible::modal_model_of(structure, static_cast<std::size_t>(model.modes)));
      break;
    case ModelLevel::flexible:
      response.harmonic = flexible::harmonic_response(structure, frequency);
      break;
  }
  return response;
}

}  // namespace boxbeam
