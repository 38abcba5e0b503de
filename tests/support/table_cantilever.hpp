#pragma once

#include <string>

/// A cantilever of 1 m without gravity, box 100 x 200 mm of 10 mm, held at its start; a force
/// across its end follows the table "force.csv" beside the case. It is still, so that V = F and
/// M(s) = F (1 m - s) at every instant.
namespace table_cantilever {

inline std::string text(const std::string& law, const std::string& more = {}) {
  return "[case]\nname = \"cantilever\"\nkind = \"planar\"\n"
         "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
         "[model]\ndemand = \"rigid\"\n"
         "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }\n"
         "sketch = { at = [\"0 m\", \"0 m\"] }\n"
         "[joints.root]\nkind = \"rigid\"\nconnect = [\"arm.A\", \"ground\"]\n"
         "at = [\"0 m\", \"0 m\"]\n"
         "[forces.push]\nkind = \"force\"\npoint = \"arm.B\"\ndirection = \"90 deg\"\n"
         "law = { kind = \"table\", file = \"force.csv\", " +
         law +
         " }\n"
         "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
         "flange = \"10 mm\"\nweb = \"10 mm\"\n"
         "[beam]\nbody = \"arm\"\ndensity = \"7850 kg/m^3\"\n"
         "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n"
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n"
         "[fatigue]\ncategory = 71\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
         "required = 1.0\n" +
         more;
}

/// 20 kN for a second of five, up and down in a second each.
inline const std::string trapezoid = "time [s], force [kN]\n0, 0\n1, 0\n2, 20\n3, 20\n4, 0\n5, 0\n";

/// I/z of the box at its fibres, 100 x 200 less 80 x 180 mm [m^3].
inline constexpr double W = (0.1 * 0.2 * 0.2 * 0.2 - 0.08 * 0.18 * 0.18 * 0.18) / 12.0 / 0.1;

}  // namespace table_cantilever
