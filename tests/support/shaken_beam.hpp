#pragma once

namespace test {

/// A uniform box beam of 2 m, carried in its middle by a spring and a damper and shaken there by a
/// harmonic force; it moves up and down only.
inline constexpr const char* shaken_beam = R"(
[case]
name = "shaken-beam"
kind = "planar"

[mechanism]
gravity = ["0 m/s^2", "0 m/s^2"]

[motion]
settle = "8 s"
duration = "0.4 s"

[bodies.beam]
points = { S = ["1 m", "0 m"] }
sketch = { at = ["-1 m", "0 m"], angle = "0 deg" }

[joints.guide]
kind = "slider"
point = "beam.S"
through = ["0 m", "0 m"]
direction = "90 deg"

[forces.mount]
kind = "spring"
connect = ["beam.S", "ground"]
at = ["0 m", "-1 m"]
stiffness = "200 kN/m"
free_length = "1 m"
damping = "2 kN s/m"

[forces.exciter]
kind = "force"
point = "beam.S"
direction = "90 deg"
law = { kind = "harmonic", mean = "0 N", amplitude = "3 kN", frequency = "5 Hz" }

[sections.box]
kind = "box"
width = "100 mm"
height = "100 mm"
flange = "10 mm"
web = "10 mm"

[beam]
body = "beam"
density = "7850 kg/m^3"

[[beam.segments]]
name = "all"
length = "2 m"
section = "box"

[material]
steel = "S355"

[strength]
required = 1.5

[fatigue]
category = 71
cycles = 1e7
loading = "spectrum"
gamma_Ff = 1.0
gamma_Mf = 1.35
required = 1.0
)";

}  // namespace test
