#include "boxbeam/section/plate_force.hpp"

#include <array>
#include <utility>

#include "wall_places.hpp"

namespace boxbeam {
namespace {

using namespace wall_places;

const Wall& first_of(const WallGraph& graph, WallPart part) {
  return graph.walls[nearest(graph, part, false, 0.0).wall];
}

/// The plates that a hole goes through, each with the sign of its place.
std::array<std::pair<WallPart, double>, 2> plates_of(HoleWalls walls) {
  using enum WallPart;
  if (walls == HoleWalls::webs) return {{{left_web, 1.0}, {right_web, -1.0}}};
  return {{{top_flange, 1.0}, {bottom_flange, -1.0}}};
}

/// On the outer face of a plate, `along` it from the middle.
SectionPoint place_on(const StressField& field, WallPart plate, const std::string& name,
                      double along) {
  const WallGraph& graph = field.flow->at.graph;
  const WallPlace place = nearest(graph, plate, false, along);
  const Wall& wall = graph.walls[place.wall];
  const double face = outer_face_of(wall);
  const bool web = is_web(wall);
  return wall_point(field, name, place, web ? face : along, web ? along : face, 0.0,
                    si<Length>(wall.thickness));
}

/// What holes leave of the clear width of a plate.
Length left_by_holes(const StressField& field, HoleWalls walls) {
  return clear_for_holes(field.section.outer, walls) - taken_by_holes(field.holes, walls);
}

/// The edges of a hole, or of two in a flange the outer ones, each with its sense from the middle.
std::array<std::pair<double, double>, 2> outer_edges_of(const Hole& hole) {
  const double radius = 0.5 * hole.diameter.value(), middle = hole.position.value();
  const double other = hole.walls == HoleWalls::flanges ? -middle : middle;
  return {{{middle + radius, 1.0}, {other - radius, -1.0}}};
}

/// A solid plate carries all of V along itself.
std::vector<PlateStrip> strips_in_solid(const StressField& field, const Hole& hole) {
  const bool upright = hole.walls == HoleWalls::webs;
  const Extent extent = extent_of(field.section.outer);
  const double thick =
      (upright ? extent.y_high - extent.y_low : extent.z_high - extent.z_low).value();
  CutFactors shear = CutFactors::Zero();
  shear[upright ? cut_force::V_z : cut_force::V_y] =
      1.0 / (thick * left_by_holes(field, hole.walls).value());
  std::vector<PlateStrip> strips;
  for (const auto& [edge, towards] : outer_edges_of(hole)) {
    const std::string name =
        "strip beside hole " + hole.name + " " + signed_axis(towards, upright ? 'z' : 'y');
    const double y = upright ? extent.y_high.value() : edge,
                 z = upright ? edge : extent.z_high.value();
    PlateStrip& strip =
        strips.emplace_back(PlateStrip{WallPart::path, point_in_solid(field, name, y, z)});
    set_shear(strip.point.influence, shear);
    set_shear(strip.point.prismatic, shear);
    strip.point.torsion.reset();
  }
  return strips;
}

}  // namespace

CutFactors plate_force_of(const ShearFlow& flow, WallPart plate) {
  using enum WallPart;
  const WallGraph& graph = flow.at.graph;
  const bool web = plate == left_web || plate == right_web;
  const Eigen::Index across = web ? 1 : 0;
  const double low = first_of(graph, web ? bottom_flange : right_web).start[across],
               high = first_of(graph, web ? top_flange : left_web).start[across];
  CutFactors sum = CutFactors::Zero();
  double length = 0.0;
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    const double middle = 0.5 * (wall.start[across] + wall.end[across]);
    if (wall.part != plate || wall.inner || middle < low || middle > high) continue;
    // The flow is a parabola along a wall.
    const double of = length_of(wall);
    sum += of / 6.0 * (flow_at(flow, i, 0.0) + 4.0 * flow_at(flow, i, 0.5) + flow_at(flow, i, 1.0));
    length += of;
  }
  return (high - low) / length * sum;
}

Length taken_by_holes(const std::vector<Hole>& holes, HoleWalls walls) {
  Length taken;
  for (const Hole& of : holes) {
    if (of.walls != walls) continue;
    const bool pair = walls == HoleWalls::flanges && of.position.value() != 0.0;
    taken += (pair ? 2.0 : 1.0) * of.diameter;
  }
  return taken;
}

Length clear_for_holes(const Profile& profile, HoleWalls walls) {
  if (walls == HoleWalls::webs) return clear_top_of(profile) - clear_bottom_of(profile);
  const Extent extent = extent_of(profile);
  Length webs;
  if (const auto* box = std::get_if<Box>(&profile)) webs = box->left_web + box->right_web;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) webs = 2.0 * tube->wall;
  return extent.y_high - extent.y_low - webs;
}

std::vector<PlateStrip> strips_beside(const StressField& field, const StressField& whole,
                                      const Hole& hole, PointSet set) {
  const Profile& profile = field.section.outer;
  if (std::holds_alternative<Plate>(profile)) return strips_in_solid(field, hole);
  std::vector<PlateStrip> strips;
  if (!has_webs(profile)) return strips;
  const bool webs = hole.walls == HoleWalls::webs;
  const bool one_half = set == PointSet::in_plane && is_mirrored(field);
  // Of the shear of V_z, which runs to both sides in a flange, nothing is left over its width.
  if (one_half && !webs) return strips;
  const double left = left_by_holes(field, hole.walls).value();
  for (const auto& [plate, side] : plates_of(hole.walls)) {
    if (one_half && side < 0.0) continue;
    const double thickness = first_of(field.flow->at.graph, plate).thickness;
    const CutFactors shear = plate_force_of(*whole.flow, plate) / (thickness * left);
    const CutFactors prismatic = plate_force_of(whole.unchanging(), plate) / (thickness * left);
    for (const auto& [edge, towards] : outer_edges_of(hole)) {
      std::string name = "strip beside hole " + hole.name;
      if (!one_half) name += " " + signed_axis(webs ? side : towards, 'y');
      name += " " + signed_axis(webs ? towards : side, 'z');
      PlateStrip& strip =
          strips.emplace_back(PlateStrip{plate, place_on(field, plate, name, edge)});
      set_shear(strip.point.influence, shear);
      set_shear(strip.point.prismatic, prismatic);
      strip.point.torsion.reset();
    }
  }
  return strips;
}

std::vector<SectionPoint> posts_at(const StressField& whole, const Hole& hole, PointSet set) {
  const std::string name = "post beside hole " + hole.name;
  const Profile& profile = whole.section.outer;
  const bool upright = hole.walls == HoleWalls::webs;
  if (std::holds_alternative<Plate>(profile)) {
    const Extent extent = extent_of(profile);
    const double y = (upright ? extent.y_high : hole.position).value(),
                 z = (upright ? hole.position : extent.z_high).value();
    return {point_in_solid(whole, name, y, z)};
  }
  if (!has_webs(profile)) return {};
  if (upright) return points_at_level(whole, name, hole.position, set);
  std::vector<SectionPoint> posts;
  const bool one_half = set == PointSet::in_plane && is_mirrored(whole);
  for (const double up : {1.0, -1.0}) {
    for (const double side : {1.0, -1.0}) {
      if (side < 0.0 && (one_half || hole.position == Length{})) continue;
      std::string at = name;
      if (!one_half && hole.position != Length{}) at += " " + signed_axis(side, 'y');
      posts.push_back(
          point_on_flange(whole, at + " " + signed_axis(up, 'z'), side * hole.position, up));
    }
  }
  return posts;
}

}  // namespace boxbeam
