#include "charts/connecting_rod.hpp"

#include <fmt/format.h>

#include <cmath>

namespace boxbeam::charts {
namespace {

constexpr const char* text = R"([case]
name = "connecting-rod"
title = "Connecting rod of a fast crank"
kind = "planar"

[mechanism]
gravity = ["0 m/s^2", "0 m/s^2"]

[bodies.crank]
mass = "10 kg"
inertia = "0.1 kg m^2"
points = {{ O = ["0 m", "0 m"], A = ["{0} m", "0 m"] }}
sketch = {{ at = ["0 m", "0 m"], angle = "{1} rad" }}

[bodies.rod]
points = {{ A = ["0 m", "0 m"], P = ["1 m", "0 m"] }}
sketch = {{ at = ["{2} m", "{3} m"], angle = "{4} rad" }}

[bodies.slide]
mass = "20 kg"
points = {{ P = ["0 m", "0 m"] }}
sketch = {{ at = ["{5} m", "0 m"], angle = "0 deg" }}

[joints.O]
kind = "pin"
connect = ["crank.O", "ground"]
at = ["0 m", "0 m"]

[joints.A]
kind = "pin"
connect = ["crank.A", "rod.A"]

[joints.P]
kind = "pin"
connect = ["rod.P", "slide.P"]

[joints.guide]
kind = "slider"
point = "slide.P"
through = ["0 m", "0 m"]
direction = "0 deg"

[drivers.motor]
kind = "constant rate"
point = "crank.O"
coordinate = "angle"
start = "{1} rad"
rate = "300 rpm"

[loops.slide]
along = ["rod.A", "slide.P"]
direction = "0 deg"
sign = "+"

[sections.large]
kind = "box"
width = "60 mm"
height = "100 mm"
flange = "8 mm"
web = "6 mm"

[sections.small]
kind = "box"
width = "40 mm"
height = "60 mm"
flange = "8 mm"
web = "6 mm"

[beam]
body = "rod"
density = "7850 kg/m^3"

[[beam.segments]]
length = "1 m"
from = "large"
to = "small"

[material]
steel = "S355"

[strength]
required = 1.5

[fatigue]
category = 80
cycles = 1e7
loading = "spectrum"
gamma_Ff = 1.0
gamma_Mf = 1.35
required = 1.0
)";

}  // namespace

Project connecting_rod(double ratio, double start) {
  const double x = ratio * std::cos(start), y = ratio * std::sin(start);
  const double reach = std::sqrt(1.0 - y * y);
  return parse_project("connecting-rod.toml",
                       fmt::format(text, ratio, start, x, y, std::atan2(-y, reach), x + reach));
}

long double slide_acceleration(long double ratio, long double phi) {
  const long double sin = std::sin(phi), cos = std::cos(phi);
  const long double w = std::sqrt(1.0L - ratio * ratio * sin * sin);
  const long double slope = -ratio * ratio * sin * cos / w;
  return -ratio * cos - (ratio * ratio * (cos * cos - sin * sin) + slope * slope) / w;
}

}  // namespace boxbeam::charts
