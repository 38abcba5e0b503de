#pragma once

#include <fmt/format.h>

#include <string>

#include "boxbeam/project/project.hpp"

namespace test {

/// A crank of 0.1 m that turns so slowly that nothing has inertia, a rod of 4 m (box 60 mm high,
/// `width` wide, plates of 4 mm, as good as rigid in shear) and a slide without mass, pushed
/// towards the crank by a constant force. At t = 0 the rod lies level.
inline boxbeam::Project slow_slider_crank(double push, const std::string& width = "60 mm",
                                          const std::string& behind = "") {
  return boxbeam::parse_project(
      "slider-crank.toml",
      "[case]\nname = \"slider-crank\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
      "[bodies.crank]\nmass = \"1 kg\"\ninertia = \"0.01 kg m^2\"\n"
      "points = { O = [\"0 m\", \"0 m\"], A = [\"0.1 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"], angle = \"0 deg\" }\n"
      "[bodies.rod]\npoints = { A = [\"0 m\", \"0 m\"], P = [\"4 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0.1 m\", \"0 m\"], angle = \"0 deg\" }\n"
      "[bodies.slide]\nmass = \"0 kg\"\npoints = { P = [\"0 m\", \"0 m\"] }\n"
      "sketch = { at = [\"4.1 m\", \"0 m\"], angle = \"0 deg\" }\n"
      "[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[joints.A]\nkind = \"pin\"\nconnect = [\"crank.A\", \"rod.A\"]\n"
      "[joints.P]\nkind = \"pin\"\nconnect = [\"rod.P\", \"slide.P\"]\n"
      "[joints.guide]\nkind = \"slider\"\npoint = \"slide.P\"\nthrough = [\"0 m\", \"0 m\"]\n"
      "direction = \"0 deg\"\n"
      "[drivers.motor]\nkind = \"constant rate\"\npoint = \"crank.O\"\ncoordinate = \"angle\"\n"
      "start = \"0 deg\"\nrate = \"0.01 rad/s\"\n"
      "[forces.push]\nkind = \"force\"\npoint = \"slide.P\"\ndirection = \"180 deg\"\n" +
          fmt::format("size = \"{} N\"\n", push) +
          "[sections.rod]\nkind = \"box\"\nheight = \"60 mm\"\nwidth = \"" + width +
          "\"\nflange = \"4 mm\"\nweb = \"4 mm\"\n"
          "[beam]\nbody = \"rod\"\ndensity = \"7850 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"4 m\"\nsection = \"rod\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
          "[fatigue]\ncategory = 71\ncycles = 1e4\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
          "required = 1.0\n"
          "[model]\nshear_modulus = \"1e6 GPa\"\n" +
          behind);
}

}  // namespace test
