#pragma once

#include "charts/chart.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// The largest moment of a connecting rod, which lies between its ends, by stations and as the
/// verification searches for it.
Chart moment_peak_chart(const Effort& effort);

}  // namespace boxbeam::charts
