#pragma once

#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam::flexible {

/// Adds to the damping of modes of the exact form what links damp by the way they bend between
/// their nodes beyond the static one. With b = phi - phi_static of a part, which is zero at its
/// nodes and has no work in common with any static bending, and as phi_i is in balance with its
/// inertia,
///
///     integral of EI phi_i' phi_j' + ... = that of the static parts + omega_i^2 integral of
///                                          mu (u_i b_u,j + w_i b_w,j) + rho I phi_i b_phi,j
///
/// by Gauss's rule with 10 points. Precondition: the structure is resolved at all frequencies of
/// the modes. Source: Betti's theorem.
void add_damping_within(const Structure& structure, ModalModel& model);

}  // namespace boxbeam::flexible
