#pragma once

#include <string>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct ExplainOptions {
  std::string check;
  CaseOptions of_case;
};

/// `boxbeam explain`: how one check comes about, line by line; or all ids. Returns the exit code.
int run_explain(const ExplainOptions& options);

}  // namespace boxbeam::program
