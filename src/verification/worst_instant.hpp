#pragma once

#include <vector>

#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Where a use is largest.
struct WorstInstant {
  const SituationHistory* at;
  TurningPoint largest;  ///< without load factor
  double use = 0.0;      ///< with it
};

template <class Use>
WorstInstant worst_instant_of(const std::vector<SituationHistory>& histories, const Use& use) {
  WorstInstant worst{&histories.front(), {}, 0.0};
  for (const SituationHistory& at : histories) {
    const TurningPoint in = at.history.largest(use);
    const double with_factor = at.situation->load_factor * in.value;
    if (with_factor > worst.use) worst = {&at, in, with_factor};
  }
  return worst;
}

/// A use this small is none, as stress is (`no_stress_at`).
inline constexpr double no_use = 1e-6;

}  // namespace boxbeam
