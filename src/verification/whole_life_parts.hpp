#pragma once

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "boxbeam/verification/whole_life.hpp"

namespace boxbeam {

/// A situation that runs.
struct WholeLife::Part {
  std::size_t situation = 0;
  std::shared_ptr<const recorded::Channels> channels;  ///< those looked at one by one
  std::shared_ptr<const recorded::Record> record;
  std::size_t first = 0;  ///< of its factors
  Eigen::VectorXd centre;
  Eigen::MatrixXd metric;
};

/// The life of a counted place on a curve of reference 1 Pa.
struct WholeLife::Life {
  static constexpr int nodes = 12;           ///< on either side of the factor
  double factor = 0.0;                       ///< at which the damage is 1
  std::array<double, 2 * nodes + 1> logs{};  ///< of the damage at factors a quarter octave apart

  /// Damage at so many times the factor.
  double damage(double times) const {
    const double at = std::clamp(4.0 * std::log2(times) + nodes, 0.0, 2.0 * nodes - 1e-9);
    const auto i = static_cast<std::size_t>(at);
    return std::exp(std::lerp(logs[i], logs[i + 1], at - static_cast<double>(i)));
  }
};

/// A place that was counted.
struct WholeLife::Counted {
  WholePlace place;
  double norm = 0.0;
  std::vector<SituationCycles> cycles;        ///< reduced and as often as the life has them
  std::vector<SituationCycles> few;           ///< the same in some classes
  std::vector<double> largest;                ///< range of the same situations, not reduced [Pa]
  mutable std::map<std::size_t, Life> lives;  ///< by the shape of the curve

  std::vector<Cycle> all() const {
    std::vector<Cycle> all;
    for (const SituationCycles& of : cycles)
      all.insert(all.end(), of.cycles.begin(), of.cycles.end());
    return all;
  }
};

}  // namespace boxbeam
