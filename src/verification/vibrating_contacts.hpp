#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/verification/transient_response.hpp"

namespace boxbeam {

/// The springs of a mechanism that act from a length on.
std::vector<const spatial::Spring*> contacts_of(const spatial::Mechanism& mechanism);

/// By how much so many modes make each of these longer, a row for each mode.
using GapsAt = std::function<Eigen::MatrixXd(double time, Eigen::Index modes)>;

/// Throws AnalysisError where vibration beside the rigid motion itself opens or closes one of them,
/// and that does more than `tolerance` of the largest force in any: modes act as contacts do in the
/// rigid motion. What stands open or closed wrongly by d bears k d for d/p of the time, p how far
/// the rigid motion presses it.
void check_contacts(const spatial::Chain& chain, const spatial::StatesAround& states,
                    const TransientResponse& response, const GapsAt& gaps_at, double tolerance);

}  // namespace boxbeam
