#pragma once

#include "boxbeam/study/chart.hpp"

namespace boxbeam::study {

/// The order at which a series' error falls with its parameter: slope of the straight line of
/// least squares through the logarithms of the points whose error is above `floor` and that did not
/// fail. Zero where fewer than two are left.
double fitted_order(const Series& series, double floor = 1e-12);

}  // namespace boxbeam::study
