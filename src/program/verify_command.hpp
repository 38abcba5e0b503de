#pragma once

#include <string>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct VerifyOptions {
  CaseOptions of_case;
  std::string out;
  std::string json;
  std::string level = "governing";
  std::string export_to;  ///< folder for files of other programs; "": none
  bool sensitivities = false;
  bool no_plots = false;
  bool no_html = false;
  bool no_pdf = false;
  bool quiet = false;
  bool watch = false;  ///< verifies again whenever a file changes, without end
};

/// `boxbeam verify`: verifies a case and writes its report. Returns the exit code.
int run_verify(const VerifyOptions& options);

}  // namespace boxbeam::program
