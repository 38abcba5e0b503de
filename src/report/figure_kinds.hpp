#pragma once

#include <span>
#include <string>

#include "drawing.hpp"
#include "plot_script.hpp"
#include "report_parts.hpp"

/// The figures that a report may have.
namespace boxbeam::report {

struct FigureKind {
  const char* name;  ///< of its file
  FigurePlace place;
  bool decides;  ///< whether a summary, too, shows it
  bool (*shown)(const Project&, const Verification&);
  std::string (*caption)(const Source&);  ///< a sentence that says what is to be seen
  void (*plot)(plot::Script&, const Project&, const Verification&);      ///< by gnuplot
  plot::Drawing (*draw)(const Project&, const Verification&) = nullptr;  ///< where gnuplot does not
};

/// All of them, in the order of a report.
std::span<const FigureKind> figure_kinds();

}  // namespace boxbeam::report
