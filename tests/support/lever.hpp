#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"

/// A lever in the plane with what stays and carries it.
namespace test::lever {

using namespace boxbeam;

inline constexpr double pi = std::numbers::pi;
inline constexpr double E = 2.1e11;
inline constexpr double L = 4.0;  ///< of the lever
inline constexpr double rho = 7850.0;
inline constexpr double A = 0.06 * 0.08 - 0.052 * 0.072;
inline constexpr double M = rho * A * L;  ///< of the lever [kg]
inline const double I = (0.06 * std::pow(0.08, 3) - 0.052 * std::pow(0.072, 3)) / 12.0;

inline const std::string at_ground =
    "connect = [\"lever.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n";

/// What the texts of the scenes are put together from.
struct Scene {
  double gravity = 0.0;
  double angle = 0.0;  ///< of the lever [deg]
  std::string hinge = "kind = \"pin\"\n" + at_ground;
  std::string bodies, joints, forces, rod;
  double side = 0.002;  ///< of the rod's square section [m]
  std::string model;
  bool moves = false;

  std::string text() const {
    return "[case]\nname = \"lever\"\nkind = \"planar\"\n[mechanism]\n" +
           fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) +
           "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\"], M = [\"2 m\", \"0 m\"], "
           "B = [\"4 m\", \"0 m\"] }\n" +
           fmt::format("sketch = {{ at = [\"0 m\", \"0 m\"], angle = \"{} deg\" }}\n", angle) +
           bodies + "[joints.hinge]\n" + hinge + joints + forces +
           (moves ? "" : "[motion]\nduration = \"1 s\"\n") +
           "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
           "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
           fmt::format("[sections.bar]\nkind = \"plate\"\nwidth = \"{0} m\"\nheight = \"{0} m\"\n",
                       side) +
           "[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n"
           "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n" +
           model + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" + rod;
  }
};

/// A rod without mass from the lever's end to the ground.
inline void hold_by_link(Scene& scene, double x, double y, double length) {
  scene.joints += fmt::format(
      "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"ground\"]\n"
      "at = [\"{} m\", \"{} m\"]\nlength = \"{:.17g} m\"\n",
      x, y, length);
  scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
}

/// A rod of this mass from the lever's end to the ground or another body. Its points lie along
/// (3, 4) of its own axes.
inline void hold_by_body(Scene& scene, double mass, double x, double y, double length,
                         const std::string& foot = "\"ground\"", double inertia_of_even = 1.0,
                         const std::string& name = "stay") {
  const Eigen::Vector2d end(L * std::cos(scene.angle * pi / 180.0),
                            L * std::sin(scene.angle * pi / 180.0));
  const Eigen::Vector2d line = end - Eigen::Vector2d(x, y);
  const Eigen::Vector2d middle = 0.5 * (end + Eigen::Vector2d(x, y));
  scene.bodies += fmt::format(
      "[bodies.{0}]\nmass = \"{1:.17g} kg\"\ninertia = \"{2:.17g} kg m^2\"\n"
      "points = {{ P = [\"{3:.17g} m\", \"{4:.17g} m\"], Q = [\"{5:.17g} m\", \"{6:.17g} m\"] }}\n"
      "sketch = {{ at = [\"{7} m\", \"{8} m\"], angle = \"{9} deg\" }}\n",
      name, mass, inertia_of_even * mass * length * length / 12.0, -0.3 * length, -0.4 * length,
      0.3 * length, 0.4 * length, middle.x(), middle.y(),
      (std::atan2(line.y(), line.x()) - std::atan2(4.0, 3.0)) * 180.0 / pi);
  scene.joints += fmt::format(
      "[joints.head]\nkind = \"pin\"\nconnect = [\"{0}.Q\", \"lever.B\"]\n"
      "[joints.foot]\nkind = \"pin\"\nconnect = [\"{0}.P\", {1}]\n",
      name, foot);
  if (foot == "\"ground\"") scene.joints += fmt::format("at = [\"{} m\", \"{} m\"]\n", x, y);
  scene.rod = fmt::format(
      "[[rods]]\nname = \"stay\"\nfrom = \"{0}.P\"\nto = \"{0}.Q\"\nsection = \"bar\"\n"
      "curve = \"c\"\n",
      name);
}

/// A shoe under the lever's end that a driver moves up and down.
inline void drive_shoe(Scene& scene, double x, double y, const std::string& driver) {
  scene.moves = true;
  scene.bodies += fmt::format(
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = {{ S = [\"0 m\", \"0 m\"] }}\n"
      "sketch = {{ at = [\"{} m\", \"{} m\"] }}\n",
      x, y);
  scene.joints += fmt::format(
      "[joints.guide]\nkind = \"slider\"\npoint = \"shoe.S\"\nthrough = [\"{} m\", \"0 m\"]\n"
      "direction = \"90 deg\"\nangle = \"-90 deg\"\n"
      "[drivers.shake]\ncoordinate = \"y\"\npoint = \"shoe.S\"\n",
      x);
  scene.joints += driver;
}

inline std::string force_at_end(double x, double y) {
  const auto one = [](const char* name, double direction, double size) {
    return fmt::format(
        "[forces.{}]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"{} deg\"\n"
        "size = \"{:.17g} N\"\n",
        name, direction, size);
  };
  return one("across", 0.0, x) + one("along", 90.0, y);
}

/// A case and its motion by rigid bodies.
struct Solved {
  Project project;
  planar::Motion motion;
  planar::BeamBody body;
  std::shared_ptr<planar::StatesAround> finder;

  explicit Solved(const Scene& scene, int instants = 0)
      : project(parse_project("lever.toml", scene.text())),
        motion(instants > 0 ? planar::solve_motion(planar_of(project), instants)
                            : planar::solve_motion(planar_of(project))),
        body(planar::beam_body_of(project.beam, project.beam_body)),
        finder(std::make_shared<planar::StatesAround>(planar_of(project), motion)) {}
  Solved(const Solved&) = delete;
  Solved& operator=(const Solved&) = delete;

  BeamLoads loads(const planar::State& state) const {
    return planar::beam_loads_of(planar_of(project), state, body);
  }
  RigidMotion rigid() const {
    return {&planar_of(project), &motion, &project.beam,
            [this](Time time) { return loads(finder->at(time.value())); }};
  }
  LoadedPosture posture(const ElasticBody& elastic, double factor = 1.0) const {
    const planar::State& state = motion.states.front();
    return loaded_posture(planar_of(project), state, elastic, project.beam, loads(state), factor);
  }
  std::vector<double> frequencies(const ElasticBody& elastic, std::size_t count) const {
    return modes_in_posture(posture(elastic), count).frequencies;
  }
  /// All forces times which the posture no longer stands.
  double critical_factor(const ElasticBody& elastic) const {
    const auto holds = [&](double factor) {
      try {
        return stands(posture(elastic, factor));
      } catch (const AnalysisError&) {
        return false;  // to round-off it is free to move there
      }
    };
    double low = 0.0, high = 1.0;
    while (holds(high)) high *= 2.0;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (holds(middle) ? low : high) = middle;
    }
    return low;
  }
};

/// So many times stiffer.
inline void stiffen(ElasticBody& of, double EA, double GA, double EI) {
  for (flexible::LinkStretch& stretch : of.stretches) {
    stretch.EA = EA * stretch.EA;
    stretch.GA = GA * stretch.GA;
    stretch.EI = EI * stretch.EI;
  }
}

inline void check_same_loads(const BeamLoads& found, const BeamLoads& expected, double within) {
  const CutForceDiagram one = cut_forces_of(found), other = cut_forces_of(expected);
  double axial = 0.0, shear = 0.0, bending = 0.0;
  for (int i = 1; i < 20; ++i) {
    const CutForces cut = other.at({si<Length>(i * L / 20), Side::before});
    axial = std::max(axial, std::abs(cut.N.value()));
    shear = std::max(shear, std::abs(cut.V_z.value()));
    bending = std::max(bending, std::abs(cut.M_y.value()));
  }
  for (int i = 1; i < 20; ++i) {
    const Station at{si<Length>(i * L / 20), Side::before};
    CHECK(one.at(at).N.value() ==
          Approx(other.at(at).N.value()).margin(within * std::max(axial, shear)));
    CHECK(one.at(at).V_z.value() == Approx(other.at(at).V_z.value()).margin(within * shear));
    CHECK(one.at(at).M_y.value() == Approx(other.at(at).M_y.value()).margin(within * bending));
  }
}

/// The lever, loaded at its end and moved by a shoe by way of an inclined rod.
inline Scene moved(bool body, const std::string& driver) {
  Scene scene;
  scene.gravity = 9.81;
  scene.angle = 30.0;
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const double l = (end - foot).norm();
  drive_shoe(scene, foot.x(), foot.y(), driver);
  if (body) {
    hold_by_body(scene, 12.0, foot.x(), foot.y(), l, "\"shoe.S\"");
    scene.side = 0.03;
  } else {
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  scene.forces = force_at_end(-150.0, -400.0);
  return scene;
}

inline const std::string shaking =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.05 m\"\nfrequency = \"1.1 Hz\"\n";
inline const std::string lifting =
    "kind = \"smooth step\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\nend = \"0.8 s\"\n";

/// Puts keys behind the head of a joint's table.
inline void give(Scene& scene, const std::string& joint, const std::string& keys) {
  const std::string head = "[joints." + joint + "]\n";
  const std::size_t at = scene.joints.find(head);
  REQUIRE(at != std::string::npos);
  scene.joints.insert(at + head.size(), keys);
}

inline std::string stiffness(double k) { return fmt::format("stiffness = \"{:.17g} N/m\"\n", k); }

}  // namespace test::lever
