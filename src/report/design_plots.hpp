#pragma once

#include <optional>

#include "boxbeam/report/optimum_report.hpp"
#include "boxbeam/study/design_rows.hpp"
#include "drawing.hpp"

/// Figures of designs, for where no script runs: paper, other programs.
namespace boxbeam::plot {

/// Every design a line over axes of all columns that vary; nothing where fewer than two do.
std::optional<Drawing> parallel_axes(const DesignRows& rows);

/// How many designs have which use, or else which of the first result; how many fail.
std::optional<Drawing> histogram(const DesignRows& rows);

/// The same of all designs of a study, where not all have a row; nothing without the use.
std::optional<Drawing> histogram(const StudySummary& summary);

/// Lines of a result over the two variables of a grid, and where designs do not pass; nothing where
/// the designs are no such grid.
std::optional<Drawing> contour(const DesignRows& rows);

/// The front of two goals, with the other designs that were judged.
std::optional<Drawing> front(const OptimumReport& of);

}  // namespace boxbeam::plot
