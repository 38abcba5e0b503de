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
  double plain = 0.0;         ///< the same with partial factors of 1
  std::size_t governing = 0;  ///< the situation whose cycles take most of it
};

/// Rows of all cycles of a situation.
std::vector<SpectrumRow> rows_of(const std::string& situation, StressKind kind,
                                 const std::vector<Cycle>& cycles);

/// The governing situation and the plain factor are those of every design that has these channels,
/// whatever its partial factors are.
ChannelLife life_of(const Project& project, const std::vector<LifeChannel>& channels);

/// By how much the fatigue of a case uses a place, times its plain factor.
double asked_of_life(const Project& project);

/// Puts what their life rests on into a check and its basis: factor and required one, source,
/// curves, damage, spectrum.
void take_life(const Project& project, const std::vector<LifeChannel>& channels, Check& check,
               CheckBasis& basis);

}  // namespace boxbeam
