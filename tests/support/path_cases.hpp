#pragma once

#include <fmt/format.h>

#include <string>

#include "support/paths.hpp"
#include "support/slender_cases.hpp"

/// Thin-walled paths as sections of cases.
namespace path_cases {

using namespace boxbeam;

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

}  // namespace path_cases
