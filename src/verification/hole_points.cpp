#include <algorithm>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/plate_force.hpp"
#include "gathered_points.hpp"

/// The points of holes in the section of a station.
namespace boxbeam {
namespace {

void append_edges(std::vector<HoleEdge>& edges, const std::vector<HoleEdge>& others) {
  edges.insert(edges.end(), others.begin(), others.end());
}

}  // namespace

void GatheredPoints::add_hole(const CutHole& at) {
  const Hole& hole = at.hole;
  const bool webs = hole.walls == HoleWalls::webs;
  if (at.concentration) {
    const HoleCase hole_case = *at.concentration;
    const double a = hole.diameter / plate_width_of(field_.section, field_.holes, hole, hole_case);
    const double factor = hole_case == HoleCase::published_exponential
                              ? published_concentration(a)
                              : membrane_concentration(a) / (1.0 - a);
    const EdgeConcentration concentration{hole.name, a, factor, edge_basis_of(hole, hole_case)};
    // The webs of a box that is no mirror image of itself are stressed unlike in the plane too.
    const bool unlike = !is_mirrored(field_) && hole_case != HoleCase::published_exponential &&
                        !unknown_hole_stress_of(field_.section, hole_case);
    if (set_ == PointSet::in_space || unlike) {
      stop_where(unknown_hole_stress_of(field_.section, hole_case));
      std::vector<HoleInWall> walls = holes_in_walls_of(field_.section, field_.holes, taper_, hole);
      if (!taper_.empty()) {
        std::vector<HoleInWall> prismatic =
            holes_in_walls_of(field_.section, field_.holes, {}, hole);
        for (std::size_t i = 0; i < walls.size(); ++i)
          append_edges(walls[i].edges, prismatic[i].edges);
      }
      for (HoleInWall& wall : walls) {
        add_edge("hole " + hole.name + " edge " + wall.side, std::move(wall.edges), webs,
                 wall.plate, at, concentration);
      }
    } else {
      std::vector<HoleEdge> edges =
          hole_edges_of(field_.section, field_.holes, taper_, hole, hole_case);
      // How much of the shear the inclined flanges carry near a hole, often at a kink of the
      // taper and under a force, is not certain: the worse of both shears counts.
      if (!taper_.empty())
        append_edges(edges, hole_edges_of(field_.section, field_.holes, {}, hole, hole_case));
      const Length plate = wall_at(field_.section, edges.front().z);
      const auto material_at = [&](const HoleEdge& edge) -> const Material* {
        if (webs || project_->part_materials.empty()) return nullptr;
        return first_to_yield(plates_here(edge.y, edge.z)).material;
      };
      // Flanges of different thickness or steel resist each on its own.
      const auto other = std::stable_partition(
          edges.begin(), edges.end(),
          [&, material = material_at(edges.front())](const HoleEdge& edge) {
            return wall_at(field_.section, edge.z) == plate && material_at(edge) == material;
          });
      std::vector<HoleEdge> below(other, edges.end());
      edges.erase(other, edges.end());
      const std::string name = "hole " + hole.name + " edge";
      add_edge(name + (below.empty() ? "" : " +z"), std::move(edges), webs, plate, at,
               concentration);
      if (!below.empty()) {
        const Length lower = wall_at(field_.section, below.front().z);
        add_edge(name + " -z", std::move(below), webs, lower, at, concentration);
      }
    }
  }
  // Where a hole has taken the neutral fibre, the shear is largest just beside the hole; a
  // category for the net section is judged by the nominal stress there.
  for (const double sign : {1.0, -1.0}) {
    const Length z = webs ? hole.position + sign * 0.5 * hole.diameter
                          : (sign > 0.0 ? gross_.z_top : gross_.z_bottom);
    if (!webs && at.concentration) continue;
    const std::string name = "beside hole " + hole.name + (sign > 0.0 ? " +z" : " -z");
    for (StressPoint& point : add_level(name, z)) {
      if (!at.concentration) resist_hole(point, at);
    }
  }
  add_strips(at);
  add_posts(at);
}

void GatheredPoints::add_posts(const CutHole& at) {
  double raised = 1.0;
  for (const HolePost& post : posts_beside(*project_, *at.of))
    raised = std::max(raised, post.shear_raised());
  if (raised == 1.0) return;
  const auto whole = fields_->of(field_.section, {}, taper_);
  for (SectionPoint& place : posts_at(*whole, at.hole, set_)) {
    for (StressInfluence* of : {&place.influence, &place.prismatic}) {
      for (double& each : of->shear) each *= raised;
      of->normal = normal_influence(sums_of(net_), place.y.value(), place.z.value()).normal;
    }
    place.torsion.reset();
    StressPoint& point = add(place);
    point.is_strip = true;
    point.shear_detail = if_asked(project_->fatigue.shear);
  }
}

void GatheredPoints::add_strips(const CutHole& at) {
  const auto whole = fields_->of(field_.section, {}, taper_);
  for (const PlateStrip& strip : strips_beside(field_, *whole, at.hole, set_)) {
    StressPoint& point = add(strip.point);
    point.is_strip = true;
    point.shear_detail = if_asked(project_->fatigue.shear);
    if (!at.concentration) resist_hole(point, at);
  }
}

void GatheredPoints::resist_hole(StressPoint& point, const CutHole& at) {
  const std::optional<BeamDetail>& own = at.of->detail;
  if (!own || !project_->fatigue.asked) return resist(point);
  point.detail = &*own;
  point.compression_reduced = own->detail.compression_reduced;
  point.range_factor = own->stress_factor;
}

EdgeBasis GatheredPoints::edge_basis_of(const Hole& hole, HoleCase hole_case) const {
  EdgeBasis basis;
  basis.hole_case = hole_case;
  basis.in_space = set_ == PointSet::in_space;
  basis.walls = hole.walls;
  basis.diameter = hole.diameter;
  basis.plate_width = plate_width_of(field_.section, field_.holes, hole, hole_case);
  basis.position = hole.position;
  basis.plate = height_of(field_.section.outer);
  basis.gross = gross_;
  basis.net = properties_of(field_.section, field_.holes);
  basis.effective_I = net_.I_y;
  return basis;
}

void GatheredPoints::add_edge(const std::string& name, std::vector<HoleEdge> edges, bool webs,
                              Length plate, const CutHole& at,
                              const EdgeConcentration& concentration) {
  // Shear lag leaves less to bend, and raises every stress of bending alike.
  const SectionProperties& whole = concentration.edge.net;
  for (HoleEdge& edge : edges) {
    edge.influence.normal[cut_force::M_y] *= whole.I_y / net_.I_y;
    edge.influence.normal[cut_force::M_z] *= whole.I_z / net_.I_z;
  }
  SectionPoint edge{name, edges.front().y, edges.front().z, {}, {}, {}, {}};
  edge.plate = plate;
  edge.part = webs ? SectionPart::web : SectionPart::fibre;
  edge.influence = edge.prismatic = edges.front().influence;
  StressPoint& point = add(edge);
  point.influence = edges.front().influence;  // of the gross section, as its source has it
  resist_hole(point, at);
  point.concentration = concentration;
  point.edges = std::move(edges);
}

}  // namespace boxbeam
