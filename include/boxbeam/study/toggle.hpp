#pragma once

#include <optional>
#include <string>

#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/study/chart.hpp"
#include "boxbeam/study/driven_scene.hpp"
#include "boxbeam/study/stopwatch.hpp"

namespace boxbeam::study {

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
  planar::Mechanism mechanism;  ///< its driver is a rate of 1 towards the toggle
  Toggle toggle;

  /// The mechanism with its driver so far before the toggle at t = 0, to the last digit of a
  /// double; `distance` becomes what it then really is.
  planar::Mechanism before(double& distance) const;
  /// The state at such a distance on the named branch of the loops, by dyads or else Newton's
  /// method, in long double.
  InstantIn<long double> exact(double distance) const;
};

/// A four-bar of 1 m, 0.8 m, 0.9 m and 1.5 m with the crank driven; its coupler and rocker are
/// stretched at cos phi = (1 + 1.5^2 - 1.7^2)/3.
ToggleScene four_bar_before_toggle();

/// The scene with its own toggle, or the four-bar where it has none that a named loop watches.
ToggleScene toggle_scene_of(const Scenes& scenes);

/// The map of one mechanism.
Map toggle_map_of(const ToggleScene& scene, const Effort& effort);

}  // namespace boxbeam::study
