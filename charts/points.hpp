#pragma once

#include <string>

#include "charts/chart.hpp"

namespace boxbeam::charts {

/// A point that came to a result, not timed.
Point solved_point(const std::string& setting, double parameter, double operations, double error);

/// One that did not, and why.
Point failed_point(const std::string& setting, double parameter, double operations,
                   const std::string& failure);

/// A chart whose scene has no answer, and why: one failed point.
Chart without_answer(Chart chart, const std::string& failure);

}  // namespace boxbeam::charts
