#pragma once

#include <vector>

#include "charts/chart.hpp"
#include "charts/peak_problem.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// How many instants a wave needs so that its highest crest is found among others.
Chart instants_per_wave_chart(const Effort& effort);

/// How many solves a peak is interpolated through: of a wave of eight instants to its period, and
/// of problems at their own instants.
Chart nodes_chart(const std::vector<PeakProblem>& problems, const Effort& effort);

/// How far the search in the interpolation goes.
Chart bits_chart(const Effort& effort);

}  // namespace boxbeam::charts
