#pragma once

#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/newton_chain.hpp"

namespace boxbeam::planar {

/// The moments that the published sledge-rig calculation carries along its Newton chain, without
/// any force times arm:
///
///     n_i = J_i alpha_i + n_(i-1)
///
/// J_i      of the body about its centre of mass [kg m^2]
/// alpha_i  its angular acceleration [rad/s^2]
///
/// For comparison with that calculation only; the loads on the beam do not use them. From the first
/// step that is a piece of a body, whose J the chain does not have, there are none.
std::vector<std::optional<double>> chain_moments_at(const Mechanism& mechanism,
                                                    const NewtonChain& chain, const State& state);

}  // namespace boxbeam::planar
