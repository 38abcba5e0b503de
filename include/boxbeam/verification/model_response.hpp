#pragma once

#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// A response, and the motion whose inertia is in balance with it.
struct ModelResponse {
  flexible::Response response;
  flexible::LinkColumns<flexible::Complex> inertial;
};

/// Harmonic response by modes with static correction: the inertia that acts is that of the modes,
///
///     K q = f + omega^2 M sum phi_j eta_j
///
/// Without modes: elastic statics under the loads of every instant, no inertia.
ModelResponse modal_response(const flexible::ModalModel& model);

/// Static and harmonic response of a mechanism by a model of it. `structure` is that of the
/// mechanism `modelled`. Throws AnalysisError at a resonance without damping and where the
/// structure is free to move.
ModelResponse response_of(const flexible::Structure& structure, const ElasticModel& model);

}  // namespace boxbeam
