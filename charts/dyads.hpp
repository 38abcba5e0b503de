#pragma once

#include <vector>

#include "charts/arithmetic.hpp"
#include "charts/dyad_plan.hpp"

namespace boxbeam::charts {

/// Positions, velocities and accelerations in closed form; `near` says to which turn angles belong.
/// Not finite where the mechanism cannot be assembled.
template <class Scalar>
void solve_dyads(const DyadPlan& plan, const std::vector<DriverState>& drivers,
                 const Eigen::VectorXd& near, InstantIn<Scalar>& instant);

}  // namespace boxbeam::charts
