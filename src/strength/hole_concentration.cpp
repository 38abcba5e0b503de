#include "boxbeam/strength/hole_concentration.hpp"

#include <cmath>
#include <numbers>

namespace boxbeam {

const char* to_text(HoleCase hole_case) {
  switch (hole_case) {
    case HoleCase::in_plane_bending: return "in-plane bending";
    case HoleCase::membrane_tension: return "membrane tension";
    case HoleCase::published_exponential: return "published exponential";
  }
  return "";
}

Length plate_width_of(const Section& section, const std::vector<Hole>& holes, const Hole& hole,
                      HoleCase hole_case) {
  const auto& box = std::get<HollowRectangle>(section.outer);
  if (hole_case == HoleCase::published_exponential) return box.height;
  if (hole.walls == HoleWalls::webs) return box.height - 2.0 * box.flange;
  double across = 0.0;
  for (const Hole& other : holes) {
    if (other.walls == HoleWalls::flanges) across += other.position.value() == 0.0 ? 1.0 : 2.0;
  }
  return (box.width - 2.0 * box.web) / across;
}

namespace {

std::vector<HoleEdge> edges_in_web(const Section& section, const std::vector<Hole>& holes,
                                   const Hole& hole, double a) {
  const SectionProperties gross = properties_of(section);
  const SectionProperties net = properties_of(section, holes);
  const double membrane = membrane_concentration(a) / (1.0 - a) / 3.0;
  const double radius = 0.5 * hole.diameter.value();
  const double z = hole.position.value();
  const double shear = stress_level_of(section, {}, gross, hole.position).per_shear;
  constexpr int steps = 120;
  std::vector<HoleEdge> edges;
  for (int k = 0; k < steps; ++k) {
    const double theta = 2.0 * std::numbers::pi * k / steps;
    const double along = membrane * (1.0 - 2.0 * std::cos(2.0 * theta));
    const double gradient = std::sin(theta) - std::sin(3.0 * theta);
    HoleEdge edge;
    edge.z = si<Length>(z + radius * std::sin(theta));
    edge.angle = theta;
    edge.level.per_N = along / gross.area.value();
    edge.level.per_M = along * z / gross.I_y.value() + gradient * radius / net.I_y.value();
    edge.level.per_V = -4.0 / (1.0 - a) * std::sin(2.0 * theta) * shear;
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace

std::vector<HoleEdge> hole_edges_of(const Section& section, const std::vector<Hole>& holes,
                                    const Hole& hole, HoleCase hole_case) {
  const double a = hole.diameter / plate_width_of(section, holes, hole, hole_case);
  if (hole_case == HoleCase::in_plane_bending) return edges_in_web(section, holes, hole, a);

  std::vector<HoleEdge> edges(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    HoleEdge& edge = edges[k];
    if (hole_case == HoleCase::membrane_tension) {
      const SectionProperties gross = properties_of(section);
      const double factor = membrane_concentration(a) / (1.0 - a);
      edge.z = sign * gross.z_top;
      edge.level.per_N = factor / gross.area.value();
      edge.level.per_M = factor * edge.z.value() / gross.I_y.value();
    } else {
      const double factor = published_concentration(a);
      edge.z = hole.position + sign * 0.5 * hole.diameter;
      edge.level = stress_level_of(section, holes, properties_of(section, holes), edge.z);
      edge.level.per_N *= factor;
      edge.level.per_M *= factor;
      edge.level.per_shear = 0.0;
    }
  }
  return edges;
}

}  // namespace boxbeam
