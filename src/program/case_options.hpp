#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam::program {

/// A case and what the command line changes of it.
struct CaseOptions {
  std::string file;
  std::vector<std::string> set;
  std::string dynamics;             ///< "": as the case says
  std::string model;                ///< likewise
  std::optional<double> tolerance;  ///< of the model, likewise
};

/// The case so changed. Throws InputError with all problems.
Project read_case(const CaseOptions& options);

}  // namespace boxbeam::program
