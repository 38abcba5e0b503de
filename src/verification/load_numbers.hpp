#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"

namespace boxbeam {

/// Loads on a beam in space as numbers, which depend on them linearly: coefficients of the line
/// loads of every piece, then force and moment of every point, of one that slides along the beam
/// about its start.
class LoadNumbers {
 public:
  LoadNumbers() = default;
  /// `sliding`: names of loads whose places move along the beam.
  explicit LoadNumbers(std::vector<std::string> sliding) : sliding_(std::move(sliding)) {}

  /// Of loads on the same pieces each time; new points become places, behind the others.
  Eigen::RowVectorXd of(const BeamLoads& loads);
  /// `rigid`: then, where what slides is there.
  BeamLoads loads_of(const Eigen::VectorXd& numbers, const BeamLoads& rigid) const;

  /// What makes moments of these numbers, of their size [m, ...].
  Eigen::VectorXd arms() const;

 private:
  bool slides(const PointLoad& load) const;

  std::vector<std::string> sliding_;
  BeamLoads places_;  ///< points and pieces, without loads
};

/// Adds what bending does to a beam to its loads: without a name to what stands at the same place.
void add_bending(const BeamLoads& bending, BeamLoads& loads);

}  // namespace boxbeam
