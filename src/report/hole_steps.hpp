#pragma once

#include "boxbeam/verification/stress_points.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// The concentration at a hole's edge: its factors, and from them the stress at the place of the
/// edge that is looked at, per cut force.
Steps hole_factor_steps(const Project& project, const StressPoint& point);

}  // namespace boxbeam::report
