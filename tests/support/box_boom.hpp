#pragma once

#include <string>

/// A boom of 4 m along x in mechanisms of space, a box of 200 x 300 mm.
namespace test::box_boom {

/// `joints` hold it, `load` acts at its tip.
inline std::string boom(const std::string& joints, const std::string& load,
                        const std::string& more = "") {
  return R"([case]
name = "boom"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.arm]
points = { heel = ["0 m", "0 m", "0 m"], lug = ["2 m", "0 m", "0 m"], tip = ["4 m", "0 m", "0 m"] }
)" + joints +
         "[forces.load]\npoint = \"arm.tip\"\nkind = \"force\"\n" + load +
         R"([sections.arm]
kind = "box"
width = "200 mm"
height = "300 mm"
flange = "20 mm"
web = "12 mm"
[beam]
body = "arm"
start = "heel"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "4 m"
from = "arm"
to = "arm"
[material]
steel = "S355"
[strength]
required = 1.0
)" + more;
}

/// It luffs about y.
inline const std::string hinged = R"([joints.heel]
kind = "revolute"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = "-y"
start = "0 deg"
)";

/// From below its heel to its middle, at 45 degrees.
inline const std::string strut = R"([joints.strut]
kind = "distance"
connect = ["ground", "arm.lug"]
at = ["0 m", "0 m", "-2 m"]
length = "2.8284271247461903 m"
)";

}  // namespace test::box_boom
