#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A station of cut forces that files give.
struct GivenCut {
  Length s;
  /// Names of the columns by cut_force::Index; "" where it is not given.
  std::array<std::string, cut_force::count> columns;
};

/// The loads of a beam as files.
struct GivenLoads {
  std::vector<GivenCut> cuts;      ///< in order; twice where they jump
  std::vector<std::string> files;  ///< of the situations that run, in the order of the case
  std::vector<Length> held;        ///< places that hold the beam against buckling
};

/// What of a case cannot be verified from cut forces alone: a sentence each; empty where all can.
std::vector<std::string> obstacles_to_given_loads(const Project& project);

/// The text of a case of kind = "loads" that verifies the same beam by the same demands under the
/// loads of files, whatever moved or held it. All that is not mechanism is kept as the case with
/// its overrides has it. Precondition: there is no obstacle.
std::string given_loads_case(const Project& project, const GivenLoads& loads);

}  // namespace boxbeam
