#pragma once

#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

/// A small case in space for tests of the reader: the beam "arm" (A at its start, B 1 m along x)
/// and the body "load" (C, its origin); joints, drivers, forces and [motion] are the test's own.
namespace small_chain {

using test::contains;

inline const std::string bodies =
    "[case]\nname = \"small\"\nkind = \"spatial\"\n"
    "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-10 m/s^2\"]\n"
    "[bodies.load]\nmass = \"10 kg\"\ncentre = [\"0 m\", \"0 m\", \"0.1 m\"]\n"
    "inertia = [\"1 kg m^2\", \"2 kg m^2\", \"2.5 kg m^2\"]\n"
    "points = { C = [\"0 m\", \"0 m\", \"0 m\"], D = [\"0 m\", \"2 m\", \"0 m\"] }\n"
    "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\", \"0 m\"], "
    "side = [\"0.5 m\", \"0 m\", \"0.2 m\"], far = [\"1.5 m\", \"0 m\", \"0 m\"] }\n"
    "[sections.tube]\nkind = \"round tube\"\ndiameter = \"100 mm\"\nwall = \"5 mm\"\n"
    "[beam]\nbody = \"arm\"\naxis = \"x\"\nz = \"z\"\ndensity = \"7850 kg/m^3\"\n"
    "[[beam.segments]]\nlength = \"1 m\"\nsection = \"tube\"\n"
    "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
    "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
    "required = 1.0\n";

/// The beam's joint with the ground, without what its kind asks for.
inline std::string heel(const std::string& kind) {
  return "[joints.hinge]\nkind = \"" + kind + "\"\nconnect = [\"ground\", \"arm.A\"]\n";
}
inline const std::string hinge = heel("revolute") + "axis = \"y\"\n";
inline const std::string weld =
    "[joints.weld]\nkind = \"fixed\"\nconnect = [\"arm.B\", \"load.C\"]\n";
inline const std::string swing =
    "[drivers.swing]\njoint = \"hinge\"\nkind = \"harmonic\"\nmean = \"0 deg\"\n"
    "amplitude = \"5 deg\"\nfrequency = \"1 Hz\"\n";

/// Two wheels about y on the ground, 0.3 m apart along x, the first one the beam's joint.
inline const std::string two_wheels =
    hinge + weld +
    "[bodies.wheel]\npoints = { C = [\"0 m\", \"0 m\", \"0 m\"] }\n"
    "[joints.wheel]\nkind = \"revolute\"\nconnect = [\"ground\", \"wheel.C\"]\n"
    "at = [\"0.3 m\", \"0 m\", \"0 m\"]\naxis = \"y\"\n";
inline const std::string sledge =
    "[bodies.sledge]\npoints = { C = [\"0 m\", \"0 m\", \"0 m\"] }\n"
    "[joints.sledge]\nkind = \"prismatic\"\nconnect = [\"ground\", \"sledge.C\"]\n"
    "axis = \"x\"\n";
inline const std::string teeth = "[joints.teeth]\nkind = \"gear\"\n";

inline boxbeam::Project read(const std::string& mechanism) {
  return boxbeam::parse_project("small.toml", bodies + mechanism);
}

inline const boxbeam::spatial::Joint& joint(const boxbeam::Project& project, const char* name) {
  const boxbeam::spatial::Mechanism& mechanism = spatial_of(project);
  const int index = joint_index(mechanism, name);
  REQUIRE(index >= 0);
  return mechanism.joints[static_cast<std::size_t>(index)];
}

/// The one problem of a case in the given text.
inline boxbeam::Problem problem_in(const std::string& text) {
  try {
    boxbeam::parse_project("small.toml", text);
  } catch (const boxbeam::InputError& error) {
    INFO(error.what());
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong in: " << text);
  return {};
}

inline boxbeam::Problem problem_of(const std::string& mechanism) {
  return problem_in(bodies + mechanism);
}

}  // namespace small_chain
