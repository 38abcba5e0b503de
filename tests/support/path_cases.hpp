#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "boxbeam/verification/slender_path.hpp"
#include "support/paths.hpp"
#include "support/slender_cases.hpp"

/// Thin-walled paths as sections of cases.
namespace path_cases {

using namespace boxbeam;
using slender_cases::steel;

inline std::string section(const std::string& name, const ThinWalled& path) {
  std::string text =
      fmt::format("[sections.{}]\nkind = \"thin-walled\"\n[sections.{}.nodes]\n", name, name);
  for (std::size_t i = 0; i < path.nodes.size(); ++i) {
    text += fmt::format("n{} = [\"{:.17g} m\", \"{:.17g} m\"]\n", i, path.nodes[i].y.value(),
                        path.nodes[i].z.value());
  }
  for (const ThinWall& wall : path.walls) {
    text += fmt::format(
        "[[sections.{}.walls]]\nfrom = \"n{}\"\nto = \"n{}\"\nthickness = \"{:.17g} m\"\n"
        "trim_from = \"{:.17g} m\"\ntrim_to = \"{:.17g} m\"\n",
        name, wall.from, wall.to, wall.thickness.value(), wall.trim_from.value(),
        wall.trim_to.value());
  }
  return text;
}

/// What holds a beam sideways and against turning over, so near that it does neither.
inline std::string held(double length, int times) {
  std::string text;
  for (int i = 0; i <= times; ++i) {
    text += fmt::format(
        "[[beam.restraints]]\nstation = \"{:.17g} m\"\nholds = [\"along y\", \"turning over\"]\n",
        length * i / times);
  }
  return text;
}

/// S355, flanges 400 x 12, web 1200 x 6: both of class 4.
inline const ThinWalled girder = paths::i_section(400.0, 12.0, 1200.0, 6.0);

/// A path as a cantilever, held, with a diaphragm and forces at its tip.
inline std::string girder_case(const ThinWalled& path, double length, double V, double N = 0.0) {
  using namespace slender_cases;
  return cantilever(section("a", path),
                    segment(length, "a") + diaphragms({length}) + held(length, 20),
                    tip(length, V, N));
}

inline std::shared_ptr<const SlenderPath> path_at(const Project& project, double s) {
  return slender_path_at(project, {}, {s * metre, Side::both});
}

struct At {
  double y, z;
};

/// Walls in millimetres; trims where plates butt: half of the other's thickness.
inline ThinWalled path(const std::vector<At>& nodes,
                       const std::vector<std::array<double, 3>>& walls, double trim_from = 0.0,
                       double trim_to = 0.0, int trimmed = -1) {
  ThinWalled of;
  for (const At& at : nodes) of.nodes.push_back({si<Length>(1e-3 * at.y), si<Length>(1e-3 * at.z)});
  for (std::size_t i = 0; i < walls.size(); ++i) {
    ThinWall wall{static_cast<std::size_t>(walls[i][0]), static_cast<std::size_t>(walls[i][1]),
                  si<Length>(1e-3 * walls[i][2])};
    if (static_cast<int>(i) == trimmed) {
      wall.trim_from = si<Length>(1e-3 * trim_from);
      wall.trim_to = si<Length>(1e-3 * trim_to);
    }
    of.walls.push_back(wall);
  }
  return of;
}

/// A force at a station of a beam at rest, and the moment beside it.
inline std::string force(const std::string& name, double at, const std::string& of,
                         const std::string& moment = "") {
  return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = {}\n", name, at, of) +
         (moment.empty() ? "" : "moment = \"" + moment + "\"\n");
}

/// A beam at rest between a pin and a roller.
inline std::string simple_beam(double length, const std::string& sections,
                               const std::string& segments, const std::string& more,
                               const std::string& loads, const std::string& gravity = "0 m/s^2") {
  return "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"" +
         gravity + "\"]\n" + sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + more +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n" +
         fmt::format("[supports.right]\nkind = \"roller\"\nat = \"{} m\"\n", length) + loads +
         steel + "[strength]\nrequired = 1.0\nshear_lag = false\ngamma_M1 = 1.1\n";
}

/// The largest use of the checks whose names begin so.
inline double use_of(const Verification& of, const std::string& id) {
  double most = 0.0;
  for (const CheckResult& result : of.checks)
    if (result.check.id.starts_with(id)) most = std::max(most, result.check.utilisation());
  return most;
}

}  // namespace path_cases
