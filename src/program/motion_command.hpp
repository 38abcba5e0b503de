#pragma once

#include <string>
#include <vector>

#include "program/case_options.hpp"

namespace boxbeam::program {

struct MotionOptions {
  CaseOptions of_case;
  std::vector<double> at;
  bool assemblies = false;
  std::string axes;
  std::string json;
  std::string gltf;
  std::string csv;
};

/// `boxbeam motion`: the mechanism alone. Returns the exit code.
int run_motion(const MotionOptions& options);

}  // namespace boxbeam::program
