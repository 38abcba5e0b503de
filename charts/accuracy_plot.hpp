#pragma once

#include "charts/chart.hpp"
#include "report/plot_script.hpp"

namespace boxbeam::plot {

/// Error over work and over time of the methods of a chart, two panels with one ordinate; a single
/// one where there is no time, or nothing that is counted.
void work_precision(Script& gp, const charts::Chart& chart);

/// Where the methods of a map solve, fail and refuse, a panel each.
void stability_map(Script& gp, const charts::Map& map);

}  // namespace boxbeam::plot
