#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/report.hpp"

/// The chapters of a report, each of a source of its own; report.cpp puts them in order. A chapter
/// without blocks is left out.
namespace boxbeam::report {

using Entries = std::vector<std::pair<std::string, std::string>>;

/// What a chapter is made of.
struct Source {
  const Project& project;
  const Verification& verification;
  ReportLevel level;
};

// report_opening.cpp
/// What stands under the verdict: the governing instant, the utilisation along the beam and the
/// largest cut forces.
std::vector<Block> opening_blocks(const Source& source);

// report_inputs.cpp
Chapter inputs_chapter(const Source& source);
// report_mechanism.cpp
Chapter mechanism_chapter(const Source& source);

// report_motion.cpp
Chapter motion_chapter(const Source& source);
/// Natural frequencies and joint forces, static and vibrating, with the errors of division, and of
/// which model they are beside the chosen one; report_flexible.cpp.
std::vector<Block> vibration_blocks(const Source& source);

Chapter model_chapter(const Source& source);       // report_model.cpp
Chapter loads_chapter(const Source& source);       // report_loads.cpp
Chapter cut_force_chapter(const Source& source);   // report_cut_forces.cpp
Chapter section_chapter(const Source& source);     // report_sections.cpp
Chapter stress_chapter(const Source& source);      // report_stresses.cpp
Chapter fatigue_chapter(const Source& source);     // report_fatigue.cpp
Chapter comparison_chapter(const Source& source);  // report_load_models.cpp

/// By which route of EN 1993-1-5 slender plates are judged, how far they are used by it, and how
/// far by the other one; "" where none is slender. plate_routes.cpp
std::string plate_routes_text(const Verification& verification);

Mark mark_of(Verdict verdict);
/// Takes the column of instants off, "t [s]", where nothing of the case changes over time.
void drop_instants_at_rest(const Project& project, Table& table);

// report_checks.cpp
/// The worst check of every criterion, worst first.
std::vector<const CheckResult*> governing_checks(const Verification& verification);
Table governing_table(const Source& source);
Chapter sheets_chapter(const Source& source);
Chapter checks_chapter(const Source& source);
/// "s = 4.2 m, fibre +z", or the name of a pin or rod.
std::string place_of(const Check& check);

/// Where in a report a figure stands.
enum class FigurePlace {
  opening,
  mechanism,
  motion,
  vibration,
  cut_forces,
  sections,
  stresses,
  fatigue,
  checks
};

// figure_kinds.cpp
/// Adds the figures of a place that this report has, each with its caption.
void add_pictures(const Source& source, FigurePlace place, std::vector<Block>& blocks);
/// Adds those that decide at a glance.
void add_deciding_pictures(const Source& source, std::vector<Block>& blocks);

}  // namespace boxbeam::report
