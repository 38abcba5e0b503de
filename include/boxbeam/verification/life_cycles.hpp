#pragma once

#include <utility>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The turning points of a stress in a situation, and with what it begins and ends.
struct SituationTurns {
  std::vector<TurningPoint> turns;
  double begin = 0.0, end = 0.0;
};

/// Of every situation that runs, by its index.
using Turns = std::vector<SituationTurns>;

/// Found exactly in time.
Turns turns_of(const Project& project, const std::vector<SituationHistory>& histories,
               const CutForceFunction& stress);

/// The highest and the lowest stress in a situation, or in those between which it changes.
std::pair<Extreme, Extreme> extremes_in(const Project& project, std::size_t situation,
                                        const Turns& turns);

/// Cycles of a situation, as often as the wanted life asks for.
struct SituationCycles {
  std::size_t situation = 0;
  std::vector<Cycle> cycles;
};

/// All cycles of the wanted life of one stress, by situations that have any. `compression_reduced`:
/// EN 1993-1-9, 7.2.1.
std::vector<SituationCycles> life_cycles_of(const Project& project, const Turns& turns,
                                            bool compression_reduced);

}  // namespace boxbeam
