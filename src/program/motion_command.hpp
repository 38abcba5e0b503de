#pragma once

#include <string>
#include <vector>

namespace boxbeam::program {

struct MotionOptions {
  std::string case_file;
  std::vector<double> at;
  bool assemblies = false;
  std::string axes;
  std::string json;
  std::vector<std::string> set;
};

/// `boxbeam motion`: the mechanism alone. Returns the exit code.
int run_motion(const MotionOptions& options);

}  // namespace boxbeam::program
