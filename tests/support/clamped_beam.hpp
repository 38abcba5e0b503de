#pragma once

#include <cmath>
#include <string>

#include "boxbeam/project/project.hpp"

/// A cantilever of 4 m without weight in the plane: a box of 150 x 300 mm, flanges 12, webs 8 mm,
/// its start A welded to the ground, a force of constant size pulling its tip B down.
namespace test {

namespace clamped {

inline constexpr double length = 4.0;
inline constexpr double E = 210e9;
inline constexpr double G = 81e9;

/// I_y of the box by hand [m^4].
inline double inertia() { return (0.150 * std::pow(0.300, 3) - 0.134 * std::pow(0.276, 3)) / 12.0; }

/// Its webs carry the shear: EN 1993-1-1, 6.2.6(3) [m^2].
inline double shear_area() { return 2.0 * 0.008 * 0.300; }

/// P L^3/(3 E I) + P L/(G A_v) [m].
inline double tip_deflection(double P) {
  return P * std::pow(length, 3) / (3.0 * E * inertia()) + P * length / (G * shear_area());
}

/// A fatigue demand that nothing comes near.
inline const std::string fatigue =
    "[fatigue]\ncategory = 160\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
    "required = 1.0\n";

inline const std::string steady = "size = \"30 kN\"\n";

inline const std::string weld =
    "[joints.root]\nkind = \"rigid\"\nconnect = [\"beam.A\", \"ground\"]\n"
    "at = [\"0 m\", \"0 m\"]\nangle = \"0 deg\"\n";

}  // namespace clamped

/// `force`: how large the force is; `behind`: [fatigue], [deflection] and the like; `joints`: what
/// holds the beam.
inline std::string clamped_beam_text(const std::string& force, const std::string& behind,
                                     const std::string& joints = clamped::weld) {
  return "[case]\nname = \"cantilever\"\nkind = \"planar\"\n"
         "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
         "[motion]\nduration = \"1 s\"\n"
         "[bodies.beam]\npoints = { A = [\"0 m\", \"0 m\"], M = [\"2.5 m\", \"0 m\"], "
         "B = [\"4 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] }\n" +
         joints + "[forces.tip]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"-90 deg\"\n" +
         force +
         "[sections.box]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\n"
         "flange = \"12 mm\"\nweb = \"8 mm\"\n"
         "[beam]\nbody = \"beam\"\ndensity = \"7850 kg/m^3\"\n"
         "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n"
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" +
         behind;
}

inline boxbeam::Project clamped_beam(const std::string& force, const std::string& behind,
                                     const std::string& joints = clamped::weld) {
  return boxbeam::parse_project("cantilever.toml", clamped_beam_text(force, behind, joints));
}

}  // namespace test
