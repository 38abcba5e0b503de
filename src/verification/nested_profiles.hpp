#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "stress_check.hpp"

namespace boxbeam {

/// How far the outer one of nested profiles would be used alone, where most.
struct OuterProfileUse {
  double use = 0.0;
  Station station;

  void take(const OuterProfileUse& other) {
    if (other.use > use) *this = other;
  }
};

/// Nested profiles count as one section; what ties them nobody describes. Where the outer one alone
/// would not bear all of N, M_y and M_z, by yield or by the details of the place in fatigue, what
/// ties the inner one to it stands with the verdict: at the ends of segments, and wherever
/// something comes onto the beam. Source: sigma = N/A + M/W of the outer profile alone.
struct NestedProfiles {
  OuterProfileUse in_strength;          ///< with what is asked for
  std::vector<StressCheck> in_fatigue;  ///< of all places that are looked at
};

NestedProfiles look_at_nested_profiles(const Project& project, const std::deque<SituationRun>& runs,
                                       const std::vector<BendingZone>& zones);
void say_of_nested_profiles(const Project& project, const NestedProfiles& of, PatchChecks& found);

}  // namespace boxbeam
