#pragma once

#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// Harmonic response by modes, as in `response_of`.
flexible::Deformation<flexible::Complex> modal_response(const flexible::ModalModel& model);

/// The response of a divided mechanism by a model of it.
///
/// Rigid bodies at rest and quasi-static: joint forces of elastic statics under the loads of every
/// instant, no inertia. Modal: `motion` is that of the modes alone, whose inertia acts; `joints`
/// have the static part of the modes left out besides,
///
///     q = sum phi_j eta_j,   K q' = f + omega^2 M q
///
/// so that joints, loads and the inertia of `motion` are in balance. Flexible: direct.
/// Throws AnalysisError at a resonance without damping and where the structure is free to move.
flexible::Response response_of(const flexible::Structure& structure, const ElasticModel& model);

}  // namespace boxbeam
