#pragma once

#include "boxbeam/study/chart.hpp"
#include "boxbeam/study/stopwatch.hpp"

namespace boxbeam::study {

/// The largest moment of a connecting rod, which lies between its ends, by stations and as the
/// verification searches for it.
Chart moment_peak_chart(const Effort& effort);

}  // namespace boxbeam::study
