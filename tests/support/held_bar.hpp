#pragma once

#include <string>

#include "boxbeam/project/project.hpp"

namespace test {

/// A horizontal bar of 2 m and 8000 kg/m^3 under 10 m/s^2, pinned to the ground at its left end A;
/// a rod without mass holds its right end B, from above or from below, and goes to a block that
/// creeps so slowly along a vertical line that only the weight acts.
/// `section`: lines of the bar's section; `behind`: further lines of the case.
inline boxbeam::Project held_bar(bool from_above, const std::string& section,
                                 const std::string& behind = "") {
  const std::string y = from_above ? "1 m" : "-1 m";
  const std::string turn = from_above ? "90 deg" : "-90 deg";
  return boxbeam::parse_project(
      "bar.toml",
      "[case]\nname = \"bar\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n"
      "[bodies.bar]\npoints = { A = [\"0 m\", \"0 m\"], M = [\"1 m\", \"0 m\"], "
      "B = [\"2 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"] }\n"
      "[bodies.rod]\nmass = \"0 kg\"\npoints = { P = [\"0 m\", \"0 m\"], Q = [\"1 m\", \"0 m\"] }\n"
      "sketch = { at = [\"2 m\", \"0 m\"], angle = \"" +
          turn +
          "\" }\n"
          "[bodies.block]\nmass = \"0 kg\"\npoints = { Q = [\"0 m\", \"0 m\"] }\n"
          "sketch = { at = [\"2 m\", \"" +
          y +
          "\"] }\n"
          "[joints.A]\nkind = \"pin\"\nconnect = [\"bar.A\", \"ground\"]\n"
          "at = [\"0 m\", \"0 m\"]\n"
          "[joints.B]\nkind = \"pin\"\nconnect = [\"bar.B\", \"rod.P\"]\n"
          "[joints.Q]\nkind = \"pin\"\nconnect = [\"rod.Q\", \"block.Q\"]\n"
          "[joints.guide]\nkind = \"slider\"\npoint = \"block.Q\"\nthrough = [\"2 m\", \"0 m\"]\n"
          "direction = \"90 deg\"\nangle = \"-90 deg\"\n"
          "[drivers.creep]\nkind = \"harmonic\"\npoint = \"block.Q\"\ncoordinate = \"y\"\n"
          "mean = \"" +
          y +
          "\"\namplitude = \"0.1 mm\"\nfrequency = \"0.001 Hz\"\n"
          "[sections.bar]\n" +
          section +
          "[beam]\nbody = \"bar\"\ndensity = \"8000 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"2 m\"\nsection = \"bar\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
          "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
          "required = 1.0\n" +
          behind);
}

}  // namespace test
