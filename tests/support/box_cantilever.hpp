#pragma once

#include <string>

/// A case that is read and verified in a moment, as text.
namespace test {

inline const std::string box_of_cantilever = R"(kind = "box"
width = "200 mm"
height = "300 mm"
flange = "10 mm"
web = "8 mm"
)";
inline const std::string tube_of_cantilever = R"(kind = "round tube"
diameter = "300 mm"
wall = "10 mm"
)";

/// A cantilever of 2 m without weight under 10 kN at its end. The name of the load has a dot.
inline std::string cantilever(const std::string& section) {
  return R"([case]
name = "cantilever"
kind = "static"
[frame]
gravity = ["0 m/s^2", "0 m/s^2"]
[beam]
density = "7850 kg/m^3"
[[beam.segments]]
length = "2 m"
section = "of"
[sections.of]
)" + section +
         R"([supports.wall]
at = "0 m"
kind = "fixed"
[loads."tip.1"]
kind = "force"
at = "2 m"
force = ["0 kN", "-10 kN"]
[material]
steel = "S355"
[strength]
required = 1
)";
}

/// The same with another flange, in metres.
inline double mass_of_box(double flange) {
  return 7850.0 * (0.2 * 0.3 - (0.2 - 0.016) * (0.3 - 2.0 * flange)) * 2.0;
}

}  // namespace test
