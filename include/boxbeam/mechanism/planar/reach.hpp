#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// How far drivers can go towards wanted values.
struct Reach {
  bool limited = false;        ///< whether they end before
  std::vector<double> values;  ///< of the drivers at the limit (or the wanted ones) [m, rad]
  Eigen::VectorXd q;           ///< the position there
  double share = 1.0;          ///< of the way from the start to the wanted values
};

/// Values of the driven coordinates in a position, whatever drives them.
std::vector<double> driver_values_at(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// Leads the drivers from their values in the assembled position `q` straight to `wanted`, and
/// finds where that ends: a fold, where the mechanism would have to turn back. Continuation by
/// pseudo-arclength, the fold located where the drivers' rate along the curve is zero.
/// Sources: Keller (1977); Allgower and Georg, Numerical Continuation Methods (1990), chapter 6.
Reach find_reach(const Mechanism& mechanism, const Eigen::VectorXd& q,
                 const std::vector<double>& wanted);

/// What to say where a mechanism cannot be assembled at an instant: the driver values, the gap, the
/// joint that stays open, the limiting driver values and the position there.
AnalysisFailure failure_of_assembly(const Mechanism& mechanism, double time,
                                    const Assembly& closest);

/// The same where a motion cannot be followed beyond a state towards a later instant.
AnalysisFailure failure_of_motion(const Mechanism& mechanism, const State& reached, double time);

}  // namespace boxbeam::planar
