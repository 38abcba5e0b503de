#pragma once

#include "charts/chart.hpp"

namespace boxbeam::charts {

/// Of double, where nothing at all is lost.
inline constexpr double most_digits = 16.0;

/// |found - exact|/|exact|; where nothing is right, |found|.
double relative_error(double found, long double exact);

/// A trial by its relative error: solved with -log10 of it left; wrong where a strength check,
/// which needs 1e-3, is misled.
Cell digits_cell(double x, double y, double error);

}  // namespace boxbeam::charts
