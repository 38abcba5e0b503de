#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/reduced_plates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A use this small is none, as stress is (`no_stress_at`).
inline constexpr double no_use = 1e-6;

/// What is used of a section whose plates may buckle, of boxes and of paths alike.
struct SlenderUse {
  Criterion criterion = Criterion::effective_section;
  const ShearedWall* wall = nullptr;      ///< nothing of the section
  const ReducedPlate* reduced = nullptr;  ///< by reduced stresses
  std::string point = {};
  Stress yield_strength = {};  ///< of the section's place used most
  const char* clause = "";     ///< by which its plates are reduced
  bool web = false;            ///< bending and shear together by 7.1(1)
};

/// The check of it, where it is used most.
Check slender_check_of(const Project& project, const Station& station, const WorstInstant& worst,
                       const SlenderUse& of);

}  // namespace boxbeam
