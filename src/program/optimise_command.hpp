#pragma once

#include <string>

namespace boxbeam::program {

struct OptimiseOptions {
  std::string study;
  std::string out;          ///< folder of page and figures; "": none is written
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once
  std::string json;
};

/// `boxbeam optimise`: looks for the best design of a study. Returns the exit code.
int run_optimise(const OptimiseOptions& options);

}  // namespace boxbeam::program
