#pragma once

#include "charts/chart.hpp"
#include "charts/stopwatch.hpp"

/// What becomes of a pendulum's motion over many swings.
namespace boxbeam::charts {

/// How far constraints drift.
Chart drift_chart(const Effort& effort);

/// How far its energy does.
Chart energy_chart(const Effort& effort);

}  // namespace boxbeam::charts
