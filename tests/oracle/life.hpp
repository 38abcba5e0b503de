#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "beside.hpp"
#include "boxbeam/fatigue/rainflow.hpp"

/// How the cycles of situations come together.
namespace oracle {

using boxbeam::Cycle;

/// A stress over the instants of each situation that runs, by its index in the case.
using Histories = std::vector<std::vector<double>>;

/// Looks at a case and what has been sampled of it, which stay.
class Life {
 public:
  Life(const Project& project, const std::vector<Run>& sampled)
      : project_(project), sampled_(sampled) {}

  double largest_range(const Histories& histories) const;
  /// All cycles of the life; `reduced`: the compressive part counts 60 % (EN 1993-1-9, 7.2.1).
  std::vector<Cycle> cycles_of(const Histories& histories, bool reduced) const;

 private:
  /// Lowest and highest in a situation, or in those of which it is made.
  std::pair<double, double> extremes(const Histories& histories, std::size_t i) const;
  bool closed(std::size_t situation) const;

  const Project& project_;
  const std::vector<Run>& sampled_;
};

}  // namespace oracle
