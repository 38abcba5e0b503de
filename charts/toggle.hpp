#pragma once

#include <optional>
#include <string>

#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "charts/chart.hpp"
#include "charts/driven_scene.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// Where a driver cannot go on: two branches of the mechanism meet there.
struct Toggle {
  long double value = 0.0L;  ///< of the driver [m, rad]
  int side = 1;              ///< +1: the driver cannot go beyond, -1: not below
  Eigen::VectorXd q;         ///< the position there
};

/// The toggle of a mechanism with one driver that is nearest to a position, if there is one: found
/// by continuation and located to the last digits of a long double, with a coordinate as the
/// parameter of the curve in the place of the driver, by Newton's method on d(driver) = 0.
/// Source: Allgower and Georg, Numerical Continuation Methods (1990), section 9.1.
std::optional<Toggle> toggle_of(const planar::Mechanism& mechanism, const Eigen::VectorXd& q);

/// A mechanism and its toggle.
struct ToggleScene {
  std::string name;
  planar::Mechanism mechanism;
  Toggle toggle;

  /// The mechanism at a place before its toggle at t = 0, its driver going on towards it with a
  /// rate of 1, and what is right there.
  struct Place {
    double distance = 0.0;  ///< of the driver to the toggle, to the last digit [m, rad]
    planar::Mechanism mechanism;
    /// On the named branch of the loops, by dyads or else Newton's method, in long double.
    InstantIn<long double> exact;
  };

  /// `share`: of the mechanism's size, or of a radian. Nothing where it cannot stand there.
  std::optional<Place> place(double share) const;
};

/// A four-bar of 1 m, 0.8 m, 0.9 m and 1.5 m with the crank driven; its coupler and rocker are
/// stretched at cos phi = (1 + 1.5^2 - 1.7^2)/3.
ToggleScene four_bar_before_toggle();

/// The scene with its own toggle, or the four-bar where it has none that a named loop watches.
ToggleScene toggle_scene_of(const Scenes& scenes);

/// The map of one mechanism.
Map toggle_map_of(const ToggleScene& scene, const Effort& effort);

}  // namespace boxbeam::charts
