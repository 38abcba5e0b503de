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

/// The cycles of a change between situations whose cycle from extreme to extreme is `whole`. At a
/// share p every stress s becomes m + p (s - m), where m is the middle between the extremes of the
/// first situation: between states at rest, from the first on towards the other.
std::vector<Cycle> change_cycles(const Situation& change, const Cycle& whole, Stress first_middle);

/// Cycles of a situation, as often as the wanted life asks for.
struct SituationCycles {
  std::size_t situation = 0;
  std::vector<Cycle> cycles;
};

/// All cycles of the wanted life of one stress, by situations that have any. `compression_reduced`:
/// EN 1993-1-9, 7.2.1.
std::vector<SituationCycles> life_cycles_of(const Project& project, const Turns& turns,
                                            bool compression_reduced);
/// The same in one list, into the room of what had cycles before.
void count_life_cycles(const Project& project, const Turns& turns, bool compression_reduced,
                       std::vector<Cycle>& cycles);

}  // namespace boxbeam
