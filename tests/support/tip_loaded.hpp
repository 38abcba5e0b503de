#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace test {

/// A force on the axis of a beam: mean + amplitude sin(2 pi frequency t + phase), in kN.
struct AxisForce {
  double s = 0.0;          ///< [m]
  double direction = -90;  ///< [deg], from the axis; -90 pushes down
  double mean = 10.0, amplitude = 10.0;
  double frequency = 1.0;  ///< [Hz]
  double phase = 0.0;      ///< [deg]
};

/// A beam along x in the plane, held rigidly at its start, without weight; a wheel beside it turns
/// once a second, which is the time looked at. `sections`: tables [sections.NAME]; `segments`:
/// tables
/// [[beam.segments]]; `behind`: the lines of [fatigue] behind its category and what follows.
inline boxbeam::Project planar_cantilever(double length, const std::string& sections,
                                          const std::string& segments,
                                          const std::vector<AxisForce>& forces,
                                          const std::string& behind) {
  std::string points = "A = [\"0 m\", \"0 m\"]", applied;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const AxisForce& force = forces[i];
    points += fmt::format(", P{} = [\"{:.17g} m\", \"0 m\"]", i, force.s);
    applied += fmt::format(
        "[forces.F{0}]\nkind = \"force\"\npoint = \"bar.P{0}\"\ndirection = \"{1:.17g} deg\"\n"
        "law = {{ kind = \"harmonic\", mean = \"{2:.17g} kN\", amplitude = \"{3:.17g} kN\", "
        "frequency = \"{4:.17g} Hz\", phase = \"{5:.17g} deg\" }}\n",
        i, force.direction, force.mean, force.amplitude, force.frequency, force.phase);
  }
  points += fmt::format(", B = [\"{:.17g} m\", \"0 m\"]", length);
  boxbeam::Project project = boxbeam::parse_project(
      "cantilever.toml",
      "[case]\nname = \"cantilever\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[bodies.bar]\npoints = { " +
          points +
          " }\nsketch = { at = [\"0 m\", \"0 m\"] }\n"
          "[bodies.wheel]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\n"
          "points = { O = [\"0 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"1 m\"] }\n"
          "[joints.clamp]\nkind = \"rigid\"\nconnect = [\"bar.A\", \"ground\"]\n"
          "at = [\"0 m\", \"0 m\"]\n"
          "[joints.O]\nkind = \"pin\"\nconnect = [\"wheel.O\", \"ground\"]\n"
          "at = [\"0 m\", \"1 m\"]\n"
          "[drivers.wheel]\npoint = \"wheel.O\"\ncoordinate = \"angle\"\n"
          "kind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"60 rpm\"\n" +
          applied + sections + "[beam]\nbody = \"bar\"\ndensity = \"7850 kg/m^3\"\n" + segments +
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" + behind);
  project.model.demand = boxbeam::ModelDemand::rigid;
  return project;
}

}  // namespace test
