#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <string>

#include "support/space_arm.hpp"

/// The arm of `space_arm` clamped to a hub that moves across it, with a load at or beside its tip.
namespace test::hub_and_arm {

struct HubAndArm {
  double hub = 300.0, load = 30.0;                                 ///< [kg]
  Eigen::Vector3d centre{0.1, 0.3, -0.2}, inertia{2.0, 1.0, 1.5};  ///< of the load [m, kg m^2]
  double start = 0.0, rate = 0.0;                                  ///< of the hub [m, m/s]
  std::string across = "z";                                        ///< the way it moves
  double density = 7850.0, gravity = 9.81;  ///< of the arm [kg/m^3], down along z [m/s^2]

  /// The case, with forces and what moves it: a driver, or forces. `points`: further ones of the
  /// arm; `model`: what stands behind the beam.
  std::string text(const std::string& forces, bool driven, const std::string& points = "",
                   const std::string& model = "") const {
    const std::string bodies = fmt::format(
        R"([bodies.hub]
mass = "{:.15g} kg"
points = {{ o = ["0 m", "0 m", "0 m"] }}
[bodies.load]
mass = "{:.15g} kg"
centre = ["{:.15g} m", "{:.15g} m", "{:.15g} m"]
inertia = ["{:.15g} kg m^2", "{:.15g} kg m^2", "{:.15g} kg m^2"]
points = {{ c = ["0 m", "0 m", "0 m"] }}
[joints.fall]
kind = "prismatic"
connect = ["ground", "hub.o"]
at = ["0 m", "0 m", "0 m"]
axis = "{}"
{}
[joints.root]
kind = "fixed"
connect = ["hub.o", "arm.heel"]
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
)",
        hub, load, centre.x(), centre.y(), centre.z(), inertia.x(), inertia.y(), inertia.z(),
        across,
        driven ? ""
               : fmt::format("moved_by = \"forces\"\nstart = \"{:.15g} m\"\nstart_rate = "
                             "\"{:.15g} m/s\"",
                             start, rate));
    return test::space_arm::arm(bodies + forces,
                                fmt::format("density = \"{:.15g} kg/m^3\"\n", density), model,
                                gravity, points);
  }
};

}  // namespace test::hub_and_arm
