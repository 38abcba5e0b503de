#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/front_end.hpp"
#include "catch.hpp"
#include "support/space_arm.hpp"

/// A lever in space with what stays and carries it, and what its vibrations are compared by.
namespace test::lever_in_space {

inline constexpr double pi = std::numbers::pi, E = 2.1e11;
inline constexpr double L = 4.0;  ///< of the lever
inline constexpr double rho = 7850.0;
inline constexpr double A = 0.06 * 0.08 - 0.052 * 0.072;
inline constexpr double M = rho * A * L;  ///< of the lever [kg]
inline const double I =
    (0.06 * std::pow(0.08, 3) - 0.052 * std::pow(0.072, 3)) / 12.0;  ///< about y
inline const double I_z =
    (0.08 * std::pow(0.06, 3) - 0.072 * std::pow(0.052, 3)) / 12.0;  ///< about z
inline const double J = rho * (I + I_z) * L;  ///< of inertia of the lever about its axis

inline std::string vector(const Eigen::Vector3d& v, const char* unit) {
  return fmt::format("[\"{0:.17g} {3}\", \"{1:.17g} {3}\", \"{2:.17g} {3}\"]", v.x(), v.y(), v.z(),
                     unit);
}
inline std::string direction(const Eigen::Vector3d& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

/// What the texts of the scenes are put together from: a lever along x on a base, about which
/// everything may be turned.
struct Scene {
  double gravity = 0.0;
  std::string turn;  ///< of all
  std::string hinge = "kind = \"revolute\"\naxis = \"-y\"\n";
  std::string bodies, joints, forces, rod, drivers;
  double side = 0.002;  ///< of the rod's square section [m]
  std::string model;
  bool moves = false;

  std::string text() const {
    return "[case]\nname = \"lever\"\nkind = \"spatial\"\n[mechanism]\ngravity = " +
           vector({0.0, 0.0, -gravity}, "m/s^2") +
           "\n[bodies.base]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"] }\n"
           "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], M = [\"2.5 m\", \"0 m\", "
           "\"0 m\"], B = [\"4 m\", \"0 m\", \"0 m\"] }\n" +
           bodies + "[joints.base]\nkind = \"fixed\"\nconnect = [\"ground\", \"base.O\"]\n" + turn +
           "[joints.hinge]\nconnect = [\"base.O\", \"lever.A\"]\n" + hinge + joints + forces +
           drivers + (moves ? "" : "[motion]\nduration = \"1 s\"\n") +
           "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
           "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
           fmt::format(
               "[sections.bar]\nkind = \"plate\"\nwidth = \"{0:.17g} m\"\nheight = \"{0:.17g} m\"\n"
               "[sections.flat]\nkind = \"plate\"\nwidth = \"10 mm\"\nheight = \"50 mm\"\n",
               side) +
           "[beam]\nbody = \"lever\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n"
           "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n" +
           model + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" + rod;
  }
};

/// A rod without mass from a place of the base, which is the body "post", to the lever's end.
inline void hold_by_link(Scene& scene, const Eigen::Vector3d& from, const std::string& keys = "") {
  const double length = (Eigen::Vector3d(L, 0.0, 0.0) - from).norm();
  scene.bodies +=
      "[bodies.post]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"], F = " + vector(from, "m") +
      " }\n";
  scene.joints += fmt::format(
      "[joints.post]\nkind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n"
      "[joints.stay]\nkind = \"distance\"\nconnect = [\"post.F\", \"lever.B\"]\n"
      "length = \"{:.17g} m\"\n{}",
      length, keys);
  scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
}

/// A case whose rigid bodies have moved.
struct Moved : space_arm::Moved {
  using space_arm::Moved::Moved;

  std::vector<double> frequencies(int parts, std::size_t count) const {
    std::vector<double> found;
    for (const boxbeam::frame::BeamMode& mode : modes(parts, count))
      found.push_back(mode.frequency);
    return found;
  }
  /// Those in which the lever stays in its plane x z.
  std::vector<double> in_plane(int parts, std::size_t count) const {
    std::vector<double> found;
    for (const boxbeam::frame::BeamMode& mode : modes(parts, 40)) {
      double across = 0.0;
      for (Eigen::Index k = 0; k < mode.motion.size(); ++k)
        if (k % 6 == 1 || k % 6 == 3 || k % 6 == 5) across += std::pow(mode.motion[k], 2);
      if (across < 1e-6 * mode.motion.squaredNorm()) found.push_back(mode.frequency);
    }
    REQUIRE(found.size() >= count);
    found.resize(count);
    return found;
  }
  double critical_factor() const {
    const auto factor =
        runs.front().motion->critical_factor_at(rigid().time_of(0), rigid().diagram(0), 1e6);
    REQUIRE(factor);
    return *factor;
  }
};

inline Moved moved(const Scene& scene, const std::function<void(boxbeam::Project&)>& change = {}) {
  boxbeam::Project project = boxbeam::parse_project("lever.toml", scene.text());
  if (change) change(project);
  return Moved(std::move(project));
}

/// Rods and joints count as rigid ones.
inline void rigid_beside(boxbeam::Project& project) { project.elastic_beside.clear(); }
inline Moved alone(const Scene& scene) { return moved(scene, rigid_beside); }
/// Beams without shear; rods are of steel.
inline void without_shear(boxbeam::Project& project) {
  project.model.youngs_modulus = E;
  project.model.shear_modulus = 1e6 * 8.1e10;
}
/// A stiff lever beside springs of some hundred newtons a metre; rods are of steel.
inline void stiff_lever(boxbeam::Project& project) {
  project.model.youngs_modulus = 1e3 * E;
  project.model.shear_modulus = 1e3 * 8.1e10;
}

inline std::vector<double> roots_of(const std::function<double(double)>& f, std::size_t count) {
  std::vector<double> roots;
  constexpr double step = 1e-3;
  for (double z = 0.02; roots.size() < count; z += step) {
    if (f(z) * f(z + step) > 0.0) continue;
    double low = z, high = z + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (f(low) * f(middle) <= 0.0 ? high : low) = middle;
    }
    roots.push_back(low);
  }
  return roots;
}

inline double hertz(double square) { return std::sqrt(square) / (2.0 * pi); }

inline std::string stiffness(double k, double c = 0.0) {
  return fmt::format("stiffness = \"{:.17g} N/m\"\n", k) +
         (c > 0.0 ? fmt::format("damping = \"{:.17g} N s/m\"\n", c) : "");
}
inline std::string turning(double k) {
  return fmt::format("turning_stiffness = \"{:.17g} N m/rad\"\n", k);
}

}  // namespace test::lever_in_space
