#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/critical_instants.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The same loads by the Newton chain, beside the rigorous ones.
struct ChainComparison {
  Time time;
  Eigen::Vector2d chain_first, chain_second;        ///< at the chain's two stations, world [N]
  Eigen::Vector2d rigorous_first, rigorous_second;  ///< zero where not computed
  Mass chain_mass;                                  ///< that the chain yields for its last body
  Moment moment_gap;                                ///< couple left over at the pivot
};

/// The published chain beside the rigorous loads, at the instant of the largest M; nothing where a
/// case has no chain.
std::optional<ChainComparison> chain_comparison_of(const Project& project,
                                                   const std::deque<SituationRun>& runs,
                                                   const std::vector<CriticalInstant>& instants);

}  // namespace boxbeam
