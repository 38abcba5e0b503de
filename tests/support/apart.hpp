#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/beam/cut_force_diagram.hpp"

/// Moments of beams that move in the plane z, by different models.
namespace test::apart {

inline double bending(const boxbeam::BeamLoads& loads, double s) {
  return boxbeam::cut_forces_of(loads)
      .at({boxbeam::si<boxbeam::Length>(s), boxbeam::Side::behind})
      .M_y.value();
}

/// How far apart moments are, and of rigid bodies, by the largest.
struct Apart {
  double found = 0.0, rigid = 0.0, largest = 0.0;

  void add(double expected, double by_modes, double by_rigid) {
    largest = std::max(largest, std::abs(expected));
    found = std::max(found, std::abs(by_modes - expected));
    rigid = std::max(rigid, std::abs(by_rigid - expected));
  }
};

/// What is left over on a beam of this length beside a force of this size.
inline double unbalanced(const boxbeam::BeamLoads& loads, double length, double size) {
  const boxbeam::Imbalance left = boxbeam::imbalance_of(loads);
  return std::max(left.force.norm(), left.moment.norm() / length) / size;
}

}  // namespace test::apart
