#pragma once

#include <deque>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// From now on these are the runs of a project whose situations run as they do.
inline void turn_to(const Project& project, std::deque<SituationRun>& runs) {
  auto run = runs.begin();
  for (const Situation& of : project.situations)
    if (of.runs()) (run++)->situation = &of;
}

}  // namespace boxbeam
