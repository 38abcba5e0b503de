#pragma once

#include <string>
#include <vector>

namespace boxbeam::program {

struct SectionOptions {
  std::vector<std::string> profiles;
  std::string steel = "S355";
  std::string forces;  ///< "N = -600 kN, M_y = 1500 kN m"
  std::string json;
};

/// `boxbeam section`: properties of sections. Returns the exit code.
int run_section(const SectionOptions& options);

}  // namespace boxbeam::program
