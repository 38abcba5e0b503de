#include "boxbeam/strength/hole_concentration.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "hole_formulas.hpp"

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

/// An edge by its distance along u from the centre.
template <class Place>
std::vector<HoleEdge> edges_around(const AroundHole& around, const Place& place) {
  const auto wall = std::make_shared<const AroundHole>(around);
  const double K_g = hole::on_gross(hole::membrane_concentration(plainly, around.a), around.a);
  constexpr int steps = 120;
  std::vector<HoleEdge> edges;
  for (int k = 0; k < steps; ++k) {
    const double theta = full_turn * k / steps;
    const auto factors = hole::edge_factors(K_g, theta, around.a, around.radius);
    HoleEdge edge;
    place(edge, around.radius * std::sin(theta));
    edge.angle = theta;
    edge.around = wall;
    for (std::size_t force = 0; force < cut_force::count; ++force) {
      edge.influence.normal[force] = hole::edge_stress(
          factors, around.middle.normal[force], around.middle.shear[force], around.gradient[force]);
    }
    edges.push_back(std::move(edge));
  }
  return edges;
}

std::vector<HoleEdge> edges_in_web(const Section& section, const std::vector<Hole>& holes,
                                   const Taper& taper, const Hole& hole, double a) {
  const AreaSums gross = sums_of(outline_of(section, {}));
  const AreaSums net = sums_of(outline_of(section, holes));
  // Of two unlike webs the one with the larger shear.
  const std::vector<SectionPoint> webs =
      points_at_level(stress_field_of(section, {}, taper), "", hole.position, PointSet::in_plane);
  const StressInfluence shear =
      std::max_element(webs.begin(), webs.end(), [](const SectionPoint& one, const auto& other) {
        return std::abs(one.influence.shear[cut_force::V_z]) <
               std::abs(other.influence.shear[cut_force::V_z]);
      })->influence;
  const StressInfluence middle = normal_influence(gross, 0.0, hole.position.value());
  AroundHole around;
  around.radius = 0.5 * hole.diameter.value();
  around.a = a;
  for (const std::size_t force : {cut_force::N, cut_force::V_z, cut_force::M_y}) {
    around.middle.normal[force] = middle.normal[force];
    around.middle.shear[force] = shear.shear[force];
  }
  around.gradient[cut_force::N] = normal_stress_plane(gross)(2, 0);
  around.gradient[cut_force::M_y] = normal_stress_plane(net)(2, 1);
  return edges_around(around, [&](HoleEdge& edge, double along) {
    edge.z = si<Length>(hole.position.value() + along);
  });
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
        hole::on_gross(membrane_concentration(a), a) / (width * height);
    edges[k].influence.normal[cut_force::M_y] =
        sign * *bending * 6.0 / (width * (1.0 - a) * height * height);
  }
  return edges;
}

}  // namespace

double membrane_concentration(double diameter_to_width) {
  return hole::membrane_concentration(plainly, diameter_to_width);
}

double published_concentration(double diameter_to_width) {
  return hole::published_concentration(plainly, diameter_to_width);
}

std::optional<double> plate_bending_concentration(double diameter_to_thickness,
                                                  double diameter_to_width) {
  const double k = diameter_to_thickness;
  const double a = diameter_to_width;
  if (!(k >= 0.0 && a >= 0.0 && a < 0.3)) return std::nullopt;
  return hole::plate_bending_concentration(plainly, k, a);
}

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
      factor = hole::on_gross(membrane_concentration(a), a);
      edge.z = k == 0 ? extent.z_high : extent.z_low;
    } else {
      edge.z = hole.position + sign * 0.5 * hole.diameter;
    }
    edge.influence = normal_influence(sums, 0.0, edge.z.value());
    for (double& normal : edge.influence.normal) normal *= factor;
  }
  return edges;
}

std::vector<HoleInWall> holes_in_walls_of(const Section& section, const std::vector<Hole>& holes,
                                          const Taper& taper, const Hole& hole) {
  const bool webs = hole.walls == HoleWalls::webs;
  const HoleCase hole_case = webs ? HoleCase::in_plane_bending : HoleCase::membrane_tension;
  const StressField gross = stress_field_of(section, {}, taper);
  const Eigen::Matrix3d gross_plane = normal_stress_plane(gross.sums);
  const Eigen::Matrix3d net_plane = normal_stress_plane(sums_of(outline_of(section, holes)));
  std::vector<HoleInWall> walls;
  const auto add = [&](const std::string& side, const SectionPoint& centre) {
    const Eigen::Index along = webs ? 2 : 1;
    AroundHole around;
    around.radius = 0.5 * hole.diameter.value();
    around.a = hole.diameter / plate_width_of(section, holes, hole, hole_case);
    around.middle = centre.influence;
    around.gradient[cut_force::N] = gross_plane(along, 0);
    around.gradient[cut_force::M_y] = net_plane(along, 1);
    around.gradient[cut_force::M_z] = net_plane(along, 2);
    walls.push_back({side, centre.plate, edges_around(around, [&](HoleEdge& edge, double offset) {
                       edge.y = centre.y;
                       edge.z = centre.z;
                       (webs ? edge.z : edge.y) += si<Length>(offset);
                     })});
  };
  if (webs) {
    const auto sides = points_at_level(gross, "", hole.position, PointSet::in_space);
    add("+y", sides.at(0));
    add("-y", sides.at(1));
    return walls;
  }
  const bool pair = hole.position.value() != 0.0;
  for (const double up : {1.0, -1.0}) {
    const std::string z_name = up > 0.0 ? "+z" : "-z";
    add(z_name + (pair ? " +y" : ""), point_on_flange(gross, "", hole.position, up));
    if (pair) add(z_name + " -y", point_on_flange(gross, "", -hole.position, up));
  }
  return walls;
}

std::optional<std::string> unknown_hole_stress_of(const Section& section, HoleCase hole_case) {
  if (hole_case == HoleCase::published_exponential) {
    return "the published concentration is one of bending in a plane: give \"in-plane bending\", "
           "or a detail for the net section";
  }
  if (std::holds_alternative<Box>(section.outer) ||
      std::holds_alternative<RectangularTube>(section.outer)) {
    return std::nullopt;
  }
  return "the concentration of a hole through a solid section under torque, and under forces and "
         "moments out of its plane, is not known: give a detail for the net section, or make the "
         "section a box or tube";
}

}  // namespace boxbeam
