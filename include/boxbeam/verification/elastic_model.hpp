#pragma once

#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// A mechanism of elastic links as a model takes it: rigid links with their mass laid out as it is,
/// or elastic ones with at least the model's parts, in its element form, and bending links with
/// their elasticity along the axis where it counts. Joints stay elastic in every model.
flexible::Mechanism modelled(flexible::Mechanism mechanism, const ElasticModel& model);

}  // namespace boxbeam
