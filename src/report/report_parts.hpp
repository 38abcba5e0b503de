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
  std::vector<std::string> figures;  ///< names of those that are drawn
};

// report_inputs.cpp
Chapter inputs_chapter(const Source& source);
// report_mechanism.cpp
Chapter mechanism_chapter(const Source& source);

// report_motion.cpp
Chapter motion_chapter(const Source& source);
/// Natural frequencies and joint forces, static and vibrating, with the errors of division, and of
/// which model they are beside the chosen one; report_flexible.cpp.
std::vector<Block> vibration_blocks(const ElasticFigures& figures, const ElasticModel& model);

Chapter model_chapter(const Source& source);       // report_model.cpp
Chapter loads_chapter(const Source& source);       // report_loads.cpp
Chapter cut_force_chapter(const Source& source);   // report_cut_forces.cpp
Chapter section_chapter(const Source& source);     // report_sections.cpp
Chapter stress_chapter(const Source& source);      // report_stresses.cpp
Chapter fatigue_chapter(const Source& source);     // report_fatigue.cpp
Chapter comparison_chapter(const Source& source);  // report_load_models.cpp

Mark mark_of(Verdict verdict);

// report_checks.cpp
/// The worst check of every criterion, worst first.
std::vector<const CheckResult*> governing_checks(const Verification& verification);
Table governing_table(const Source& source);
Chapter sheets_chapter(const Source& source);
Chapter checks_chapter(const Source& source);
/// "s = 4.2 m, fibre +z", or the name of a pin or rod.
std::string place_of(const Check& check);

/// Adds the figures of these names that are drawn, each with a sentence that says what is to be
/// seen; report_pictures.cpp.
void add_pictures(const Source& source, const std::vector<std::string>& names,
                  std::vector<Block>& blocks);

}  // namespace boxbeam::report
