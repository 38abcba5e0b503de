#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam::program {

struct VerifyOptions {
  std::string case_file;
  std::string out;
  std::string json;
  std::vector<std::string> set;
  std::string dynamics;
  std::string model;  ///< "": as the case says
  std::optional<double> tolerance;
  std::string level = "governing";
  bool no_plots = false;
  bool no_html = false;
  bool no_pdf = false;
  bool quiet = false;
};

/// `boxbeam verify`: verifies a case and writes its report. Returns the exit code.
int run_verify(const VerifyOptions& options);

/// The case with what the command line changes of it.
Project project_of(const VerifyOptions& options);

}  // namespace boxbeam::program
