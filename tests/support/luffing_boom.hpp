#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

namespace test {

/// A boom that luffs on a strut, in the plane and in space, whose density nearly nothing is.
inline std::string luffing_boom(const std::string& mechanism) {
  return mechanism + R"([sections.arm]
kind = "box"
width = "400 mm"
height = "150 mm"
flange = "12 mm"
web = "12 mm"
[sections.arm2]
kind = "box"
width = "400 mm"
height = "100 mm"
flange = "12 mm"
web = "12 mm"
[material]
steel = "S355"
[strength]
required = 1.0
[motion]
duration = "1 s"
)";
}

/// Under a force of so many kN at an angle.
inline std::string luffing_in_plane(double degrees, double size) {
  return luffing_boom(fmt::format(R"([case]
name = "p"
kind = "planar"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2"]
[bodies.arm]
points = {{ heel = ["0 m", "0 m"], lug = ["2 m", "0 m"], tip = ["4 m", "0 m"] }}
sketch = {{ at = ["0 m","0 m"] }}
[bodies.strut]
mass = "1e-3 kg"
uniform_rod = "2.8284271247461903 m"
points = {{ a = ["-1.4142135623730951 m", "0 m"], b = ["1.4142135623730951 m", "0 m"] }}
sketch = {{ at = ["1 m","-1 m"], angle = "45 deg" }}
[joints.heel]
kind = "pin"
connect = ["arm.heel", "ground"]
at = ["0 m", "0 m"]
[joints.foot]
kind = "pin"
connect = ["strut.a", "ground"]
at = ["0 m", "-2 m"]
[joints.head]
kind = "pin"
connect = ["strut.b", "arm.lug"]
[forces.load]
kind = "force"
point = "arm.tip"
direction = "{} deg"
size = "{} kN"
[beam]
body = "arm"
density = "1e-3 kg/m^3"
[[beam.segments]]
length = "4 m"
from = "arm"
to = "arm2"
)",
                                  degrees, size));
}

/// Under a force of so many kN at an angle in that plane, and so much of it across; on a base that
/// is turned: "turn" of joints turns about z, then about the turned x.
inline std::string luffing_in_space(double degrees, double size, double about_z = 0.0,
                                    double about_x = 0.0, double sideways = 0.0) {
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(about_z * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ()) *
       Eigen::AngleAxisd(about_x * std::numbers::pi / 180.0, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const double angle = degrees * std::numbers::pi / 180.0;
  const Eigen::Vector3d force = R * Eigen::Vector3d(std::cos(angle), sideways, std::sin(angle));
  return luffing_boom(fmt::format(R"([case]
name = "s"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.base]
points = {{ o = ["0 m", "0 m", "0 m"], foot = ["0 m", "0 m", "-2 m"] }}
[bodies.arm]
points = {{ heel = ["0 m", "0 m", "0 m"], lug = ["2 m", "0 m", "0 m"], tip = ["4 m", "0 m", "0 m"] }}
[joints.base]
kind = "fixed"
connect = ["ground", "base.o"]
at = ["0 m", "0 m", "0 m"]
turn = [["z", "{} deg"], ["x", "{} deg"]]
[joints.heel]
kind = "revolute"
connect = ["base.o", "arm.heel"]
axis = "-y"
start = "0 deg"
[joints.strut]
kind = "distance"
connect = ["base.foot", "arm.lug"]
length = "2.8284271247461903 m"
[forces.load]
kind = "force"
point = "arm.tip"
direction = [{:.17g}, {:.17g}, {:.17g}]
size = "{:.17g} kN"
[beam]
body = "arm"
start = "heel"
axis = "x"
z = "z"
density = "1e-3 kg/m^3"
[[beam.segments]]
length = "4 m"
from = "arm"
to = "arm2"
)",
                                  about_z, about_x, force.x() / force.norm(),
                                  force.y() / force.norm(), force.z() / force.norm(),
                                  size * force.norm()));
}

}  // namespace test
