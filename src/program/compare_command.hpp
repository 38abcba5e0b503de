#pragma once

#include <string>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct CompareOptions {
  CaseOptions of_case;
  std::string published;
  std::string json;
  std::string html;
};

/// `boxbeam compare`: published values beside ours. Returns the exit code.
int run_compare(const CompareOptions& options);

}  // namespace boxbeam::program
