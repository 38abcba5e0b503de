#include "boxbeam/strength/hole_concentration.hpp"

#include <cmath>

namespace boxbeam {

const char* to_text(HoleCase hole_case) {
  switch (hole_case) {
    case HoleCase::in_plane_bending: return "in-plane bending";
    case HoleCase::membrane_tension: return "membrane tension";
    case HoleCase::published_exponential: return "published exponential";
  }
  return "";
}

double membrane_concentration(double diameter_to_width) {
  const double b = 1.0 - diameter_to_width;
  return 2.0 + b * (0.284 + b * (-0.600 + b * 1.32));
}

double published_concentration(double diameter_to_width) {
  return 2.68750 * std::exp(-0.7128 * diameter_to_width);
}

Length plate_width_of(const Section& section, const Hole& hole, HoleCase hole_case) {
  const auto& box = std::get<HollowRectangle>(section.outer);
  if (hole_case == HoleCase::published_exponential) return box.height;
  if (hole.walls == HoleWalls::webs) return box.height - 2.0 * box.flange;
  const Length clear = box.width - 2.0 * box.web;
  return hole.position.value() == 0.0 ? clear : 0.5 * clear;
}

std::array<HoleEdge, 2> hole_edges_of(const Section& section, const std::vector<Hole>& holes,
                                      const Hole& hole, HoleCase hole_case) {
  const SectionProperties gross = properties_of(section);
  const SectionProperties net = properties_of(section, holes);
  const double a = hole.diameter / plate_width_of(section, hole, hole_case);
  const double membrane = membrane_concentration(a) / (1.0 - a);
  const double radius = 0.5 * hole.diameter.value();

  std::array<HoleEdge, 2> edges;
  for (std::size_t k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    HoleEdge& edge = edges[k];
    switch (hole_case) {
      case HoleCase::in_plane_bending: {
        const double z = hole.position.value();
        edge.z = si<Length>(z + sign * radius);
        edge.level.per_N = membrane / gross.area.value();
        edge.level.per_M = membrane * z / gross.I_y.value() + sign * 2.0 * radius / net.I_y.value();
        break;
      }
      case HoleCase::membrane_tension: {
        const auto& box = std::get<HollowRectangle>(section.outer);
        const double z = sign * 0.5 * (box.height - box.flange).value();
        edge.z = si<Length>(z);
        edge.level.per_N = membrane / gross.area.value();
        edge.level.per_M = membrane * z / gross.I_y.value();
        break;
      }
      case HoleCase::published_exponential: {
        edge.z = hole.position + sign * 0.5 * hole.diameter;
        edge.level = stress_level_of(section, holes, net, edge.z);
        const double factor = published_concentration(a);
        edge.level.per_N *= factor;
        edge.level.per_M *= factor;
        edge.level.per_shear = 0.0;
        break;
      }
    }
  }
  return edges;
}

}  // namespace boxbeam
