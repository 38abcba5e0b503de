#pragma once

#include <string>
#include <vector>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct ChartOptions {
  std::vector<std::string> topics;  ///< "all", or none: all
  CaseOptions of_case;              ///< without a file: the reference cases
  std::string out;
  bool quick = false;
  bool no_pdf = false;
};

/// What can be charted; nothing in a build without charts.
std::vector<std::string> chart_topics();

/// `boxbeam chart`: accuracy against cost, and where methods fail. Returns the exit code. Throws
/// AnalysisError, and writes nothing, where no topic has anything to say of the case.
int run_chart(const ChartOptions& options);

}  // namespace boxbeam::program
