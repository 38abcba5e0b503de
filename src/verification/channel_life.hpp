#pragma once

#include <vector>

#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// The cycles of one stress in the wanted life, and what resists them.
struct LifeChannel {
  std::vector<SpectrumRow> spectrum;
  SnCurve curve;

  FatigueChannel for_damage() const;
};

/// What cycles of one or two stresses come to.
struct ChannelLife {
  double factor = 0.0;        ///< on all of them, with which the life is just used up
  std::size_t governing = 0;  ///< the situation whose cycles take most of it
};

/// Rows of all cycles of a situation.
std::vector<SpectrumRow> rows_of(const std::string& situation, StressKind kind,
                                 const std::vector<Cycle>& cycles);

ChannelLife life_of(const Project& project, const std::vector<LifeChannel>& channels);

/// Puts what that life rests on into a check and its basis: factor and required one, source,
/// curves, damage, spectrum.
void take_life(const Project& project, const std::vector<LifeChannel>& channels,
               const ChannelLife& life, Check& check, CheckBasis& basis);

}  // namespace boxbeam
