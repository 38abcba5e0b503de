#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

/// A small case for tests of the reader: the beam "arm" (points A at its start, B at its end, 1 m
/// apart, centre in the middle), the "rod" (P, Q, 2 m apart, centre 0.5 m from P) and the "wheel"
/// (C, its centre); joints, drivers, forces and [motion] are the test's own.
namespace small_case {

using test::contains;

inline const std::string bodies =
    "[case]\nname = \"small\"\nkind = \"planar\"\n"
    "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
    "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }\n"
    "sketch = { at = [\"0 m\", \"0 m\"] }\n"
    "[bodies.rod]\nmass = \"10 kg\"\ncentre = [\"0.5 m\", \"0 m\"]\n"
    "points = { P = [\"0 m\", \"0 m\"], Q = [\"2 m\", \"0 m\"] }\n"
    "sketch = { at = [\"1 m\", \"0 m\"], angle = \"90 deg\", velocity = [\"1 m/s\", \"2 m/s\"], "
    "angular_velocity = \"4 rad/s\" }\n"
    "[bodies.wheel]\nmass = \"1 kg\"\npoints = { C = [\"0 m\", \"0 m\"] }\n"
    "sketch = { at = [\"0 m\", \"1 m\"] }\n"
    "[sections.tube]\nkind = \"round tube\"\ndiameter = \"100 mm\"\nwall = \"5 mm\"\n"
    "[beam]\nbody = \"arm\"\ndensity = \"7850 kg/m^3\"\n"
    "[[beam.segments]]\nlength = \"1 m\"\nsection = \"tube\"\n"
    "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
    "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
    "required = 1.0\n";

inline const std::string pivot =
    "[joints.pivot]\nkind = \"pin\"\nconnect = [\"arm.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n";

/// What makes a mechanism of too few equations readable.
inline const std::string for_a_second = "[motion]\nduration = \"1 s\"\n";

/// Every kind of joint, driver and force but the table, whose file is apart.
inline const std::string all_kinds =
    pivot +
    "[joints.rail]\nkind = \"slider\"\npoint = \"rod.P\"\nthrough = [\"1 m\", \"0 m\"]\n"
    "direction = \"0 deg\"\nangle = \"10 deg\"\n"
    "friction = { coefficient = 0.1, viscous = \"20 N s/m\", creep = \"5 mm/s\", "
    "guide_length = \"0.2 m\" }\n"
    "[joints.slot]\nkind = \"pin in slot\"\npoint = \"ground\"\nat = [\"1 m\", \"0 m\"]\n"
    "guide = \"arm.A\"\ndirection = \"0 deg\"\n"
    "[joints.weld]\nkind = \"rigid\"\nconnect = [\"arm.B\", \"rod.P\"]\nangle = \"-10 deg\"\n"
    "[joints.link]\nkind = \"distance\"\nconnect = [\"arm.B\", \"ground\"]\n"
    "at = [\"2 m\", \"0 m\"]\nlength = \"1 m\"\n"
    "[joints.gearbox]\nkind = \"angle coupling\"\npoints = [\"arm.A\", \"wheel.C\"]\nratio = -0.5\n"
    "[joints.mesh]\nkind = \"gear\"\nconnect = [\"wheel.C\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
    "radii = [\"0.1 m\", \"-0.3 m\"]\n"
    "[joints.teeth]\nkind = \"rack\"\npinion = \"wheel.C\"\nrack = \"rod.Q\"\n"
    "direction = \"90 deg\"\nradius = \"-0.1 m\"\noffset = \"5 mm\"\n"
    "[drivers.swing]\nkind = \"harmonic\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\n"
    "mean = \"0 deg\"\namplitude = \"5 deg\"\nfrequency = \"1 Hz\"\n"
    "further = [{ amplitude = \"1 deg\", frequency = \"2 Hz\", phase = \"90 deg\" }]\n"
    "[drivers.turn]\nkind = \"constant rate\"\npoints = [\"rod.P\", \"arm.B\"]\n"
    "coordinate = \"relative angle\"\nstart = \"0 deg\"\nrate = \"6 rpm\"\n"
    "[drivers.cylinder]\nkind = \"smooth step\"\npoints = [\"arm.B\", \"ground\"]\n"
    "at = [\"0 m\", \"2 m\"]\ncoordinate = \"length\"\nfrom = \"1 m\"\nto = \"2 m\"\n"
    "begin = \"0.5 s\"\nend = \"1 s\"\n"
    "[drivers.path]\nkind = \"polynomial\"\npoint = \"wheel.C\"\ncoordinate = \"y\"\n"
    "coefficients = [\"1 m\", \"0 m/s\", \"2 m/s^2\"]\n"
    "[forces.spring]\nkind = \"spring\"\nconnect = [\"arm.B\", \"rod.Q\"]\nstiffness = \"2 kN/m\"\n"
    "free_length = \"0.3 m\"\ndamping = \"10 N s/m\"\n"
    "[forces.bar]\nkind = \"torsion spring\"\npoints = [\"arm.A\", \"ground\"]\n"
    "stiffness = \"5 kN m/rad\"\nfree_angle = \"10 deg\"\ndamping = \"2 N m s\"\n"
    "[forces.push]\nkind = \"force\"\npoint = \"rod.Q\"\ndirection = \"-90 deg\"\n"
    "turns_with_body = true\nsize = \"10 kN\"\n"
    "[forces.twist]\nkind = \"couple\"\npoints = [\"arm.A\", \"rod.P\"]\n"
    "law = { kind = \"harmonic\", mean = \"0 N m\", amplitude = \"2 N m\", frequency = \"1 Hz\" }\n"
    "[motion]\nduration = \"4 s\"\nsettle = \"1 s\"\n";

inline boxbeam::Project read(const std::string& mechanism, const std::string& path = "small.toml") {
  return boxbeam::parse_project(path, bodies + mechanism);
}

/// The one problem of a case.
inline boxbeam::Problem problem_of(const std::string& mechanism,
                                   const std::string& path = "small.toml") {
  try {
    read(mechanism, path);
  } catch (const boxbeam::InputError& error) {
    INFO(error.what());
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong in: " << mechanism);
  return {};
}

/// A joint or driver of a case that is moved for a second.
template <class Kind>
Kind joint(const std::string& lines) {
  const std::string pivot_if_driver = lines.starts_with("[drivers") ? pivot : "";
  const boxbeam::Project project = read(pivot_if_driver + lines + for_a_second);
  const boxbeam::planar::Joint& last = planar_of(project).joints.back();
  REQUIRE(std::holds_alternative<Kind>(last.kind));
  return std::get<Kind>(last.kind);
}

/// The only force of a case that is moved for a second.
template <class Kind>
Kind force(const std::string& lines) {
  const boxbeam::Project project = read(pivot + lines + for_a_second);
  REQUIRE(planar_of(project).forces.size() == 1);
  REQUIRE(std::holds_alternative<Kind>(planar_of(project).forces.front().kind));
  return std::get<Kind>(planar_of(project).forces.front().kind);
}

inline bool at(const boxbeam::planar::Attachment& point, int body, double x, double y) {
  return point.body == body && (point.p - Eigen::Vector2d(x, y)).norm() < 1e-12;
}

constexpr int arm = 0;
constexpr int rod = 1;
constexpr int wheel = 2;

}  // namespace small_case
