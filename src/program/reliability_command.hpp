#pragma once

#include <string>

namespace boxbeam::program {

struct ReliabilityOptions {
  std::string study;
  std::string out;          ///< "": reports/NAME of the study
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once
  bool quiet = false;
  std::string json;
};

/// `boxbeam reliability`: the probability that a limit state is passed. Returns the exit code.
int run_reliability(const ReliabilityOptions& options);

}  // namespace boxbeam::program
