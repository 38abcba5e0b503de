#include "boxbeam/strength/hole_concentration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {

const char* to_text(HoleCase hole_case) {
  switch (hole_case) {
    case HoleCase::in_plane_bending: return "in-plane bending";
    case HoleCase::membrane_tension: return "membrane tension";
    case HoleCase::out_of_plane_bending: return "out-of-plane bending";
    case HoleCase::published_exponential: return "published exponential";
  }
  return "";
}

Length plate_width_of(const Section& section, const std::vector<Hole>& holes, const Hole& hole,
                      HoleCase hole_case) {
  const Profile& outer = section.outer;
  if (hole_case == HoleCase::published_exponential) return height_of(outer);
  if (hole.walls == HoleWalls::webs) return clear_top_of(outer) - clear_bottom_of(outer);
  double across = 0.0;
  for (const Hole& other : holes) {
    if (other.walls == HoleWalls::flanges) across += other.position.value() == 0.0 ? 1.0 : 2.0;
  }
  const Extent extent = extent_of(outer);
  Length walls;
  if (const auto* box = std::get_if<Box>(&outer)) walls = box->left_web + box->right_web;
  if (const auto* tube = std::get_if<RectangularTube>(&outer)) walls = 2.0 * tube->wall;
  return (extent.y_high - extent.y_low - walls) / across;
}

namespace {

std::vector<HoleEdge> edges_in_web(const Section& section, const std::vector<Hole>& holes,
                                   const Taper& taper, const Hole& hole, double a) {
  const AreaSums gross = sums_of(outline_of(section, {}));
  const AreaSums net = sums_of(outline_of(section, holes));
  const double membrane = membrane_concentration(a) / (1.0 - a) / 3.0;
  const double radius = 0.5 * hole.diameter.value();
  const double z = hole.position.value();
  const StressInfluence middle = normal_influence(gross, 0.0, z);
  const double gradient_per_N = normal_stress_plane(gross)(2, 0);
  const double gradient_per_M = normal_stress_plane(net)(2, 1);
  // Of two unlike webs the one with the larger shear.
  const std::vector<SectionPoint> webs =
      points_at_level(stress_field_of(section, {}, taper), "", hole.position, PointSet::in_plane);
  const StressInfluence shear =
      std::max_element(webs.begin(), webs.end(), [](const SectionPoint& one, const auto& other) {
        return std::abs(one.influence.shear[cut_force::V_z]) <
               std::abs(other.influence.shear[cut_force::V_z]);
      })->influence;
  constexpr int steps = 120;
  std::vector<HoleEdge> edges;
  for (int k = 0; k < steps; ++k) {
    const double theta = 2.0 * std::numbers::pi * k / steps;
    const double along = membrane * (1.0 - 2.0 * std::cos(2.0 * theta));
    const double gradient = std::sin(theta) - std::sin(3.0 * theta);
    HoleEdge edge;
    edge.z = si<Length>(z + radius * std::sin(theta));
    edge.angle = theta;
    for (const std::size_t force : {cut_force::N, cut_force::V_z, cut_force::M_y}) {
      edge.influence.normal[force] = along * middle.normal[force] -
                                     4.0 / (1.0 - a) * std::sin(2.0 * theta) * shear.shear[force];
    }
    edge.influence.normal[cut_force::N] += gradient * radius * gradient_per_N;
    edge.influence.normal[cut_force::M_y] += gradient * radius * gradient_per_M;
    edges.push_back(edge);
  }
  return edges;
}

/// At both faces of a plate that lies flat, of which holes take a part of the width.
std::vector<HoleEdge> edges_in_flat_plate(const Plate& plate, double diameter, double a) {
  const double width = plate.width.value();
  const double height = plate.height.value();
  const auto bending = plate_bending_concentration(diameter / height, a);
  if (!bending) return {};
  std::vector<HoleEdge> edges(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    edges[k].z = sign * 0.5 * plate.height;
    edges[k].influence.normal[cut_force::N] =
        membrane_concentration(a) / (1.0 - a) / (width * height);
    edges[k].influence.normal[cut_force::M_y] =
        sign * *bending * 6.0 / (width * (1.0 - a) * height * height);
  }
  return edges;
}

}  // namespace

std::vector<HoleEdge> hole_edges_of(const Section& section, const std::vector<Hole>& holes,
                                    const Taper& taper, const Hole& hole, HoleCase hole_case) {
  const double a = hole.diameter / plate_width_of(section, holes, hole, hole_case);
  if (hole_case == HoleCase::in_plane_bending) return edges_in_web(section, holes, taper, hole, a);

  if (hole_case == HoleCase::out_of_plane_bending) {
    return edges_in_flat_plate(std::get<Plate>(section.outer), hole.diameter.value(), a);
  }
  std::vector<HoleEdge> edges(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    HoleEdge& edge = edges[k];
    const bool membrane = hole_case == HoleCase::membrane_tension;
    const Extent extent = extent_of(section.outer);
    const AreaSums sums = sums_of(outline_of(section, membrane ? std::vector<Hole>{} : holes));
    double factor = published_concentration(a);
    if (membrane) {
      factor = membrane_concentration(a) / (1.0 - a);
      edge.z = k == 0 ? extent.z_high : extent.z_low;
    } else {
      edge.z = hole.position + sign * 0.5 * hole.diameter;
    }
    edge.influence = normal_influence(sums, 0.0, edge.z.value());
    for (double& normal : edge.influence.normal) normal *= factor;
  }
  return edges;
}

}  // namespace boxbeam
