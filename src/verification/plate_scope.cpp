// Which plates are judged, and by which route of EN 1993-1-5.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/verification/hole_gates.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Up to this slope of its edges a plate counts as a rectangle. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double steepest = 10.0 * std::numbers::pi / 180.0;

/// The steepest edge of a segment [rad].
double slope_of(const Segment& segment) {
  const EdgeSlopes of = edge_slopes_of(segment);
  return std::atan(std::max(of.along_y, of.along_z));
}

/// Why a hole keeps the plates of its panel, between diaphragms or ends of the beam, from being
/// judged.
std::string hole_obstacle(const Project& project, const Station& station) {
  const Supports supports = supports_around(project.beam, station);
  for (const BeamHole& at : project.holes) {
    if (at.s < supports.before.value_or(Length{}) ||
        at.s > supports.behind.value_or(project.beam.length()))
      continue;
    const Station here{at.s, Side::both};
    const auto walls = four_walls_of(section_at(project.beam, here).outer,
                                     materials_of(project, segment_at(project.beam, here)));
    if (!walls) continue;  // those of its station are none of these
    const Length width = taken_by_holes(holes_at(project, at.s), at.hole.walls);
    for (const BoxPlate plate : box_plates) {
      const bool drilled = (at.hole.walls == HoleWalls::flanges) == is_flange(plate);
      if (drilled && width > widest_opening * walls->of(plate).clear())
        return fmt::format("hole \"{}\" is wider than 0.05 of its plate (2.3)", at.hole.name);
    }
  }
  return "";
}

/// Whether the same stiffeners go on from one plate to the next.
bool go_on(const std::vector<FlatStiffener>& one, const std::vector<FlatStiffener>& next) {
  return std::equal(one.begin(), one.end(), next.begin(), next.end(),
                    [](const FlatStiffener& a, const FlatStiffener& b) {
                      constexpr double same = 1e-6;
                      const Length near = same * a.depth;
                      return abs(a.depth - b.depth) <= near &&
                             abs(a.place - b.place) <= a.thickness &&
                             abs(a.thickness - b.thickness) <= near;
                    });
}

/// Why stiffeners that a plate of a box needs do not divide its panel, between diaphragms or ends
/// of the beam: they end in it, or go on as others.
std::string ending_obstacle(const Project& project, const Station& station,
                            const FourWalls& walls) {
  const auto needs_them = [&](BoxPlate plate) { return may_buckle_with_stiffeners(walls, plate); };
  if (std::none_of(box_plates.begin(), box_plates.end(), needs_them)) return "";
  const TaperedBeam& beam = project.beam;
  const Supports supports = supports_around(beam, station);
  const Length from = supports.before.value_or(Length{});
  const Length to = supports.behind.value_or(beam.length());
  for (std::size_t k = 0; k + 1 < beam.segments.size(); ++k) {
    const Length s = beam.segments[k].end();
    const Length near = 1e-9 * beam.length();
    if (!(s > from + near && s < to - near)) continue;
    const auto one = four_walls_of(beam.segments[k].to.outer, materials_of(project, k));
    const auto next = four_walls_of(beam.segments[k + 1].from.outer, materials_of(project, k + 1));
    for (const BoxPlate plate : box_plates) {
      if (!needs_them(plate)) continue;
      if (one && next && go_on(one->of(plate).stiffeners, next->of(plate).stiffeners)) continue;
      return fmt::format(
          "a stiffener of the {} ends at s = {} m, inside its panel: end it at a "
          "diaphragm",
          to_text(plate), to_text(Station{s, Side::both}));
    }
  }
  return "";
}

/// Why one of two plates of a box may buckle into one of the two that stand between them.
std::string induced_obstacle(const FourWalls& walls, const std::array<BoxPlate, 2>& webs,
                             const std::array<BoxPlate, 2>& flanges) {
  for (const BoxPlate plate : webs) {
    const BoxWall& web = walls.of(plate);
    if (!may_buckle(web)) continue;
    for (const BoxPlate by : flanges) {
      const BoxWall& flange = walls.of(by);
      // Half of it is this web's; between flats it is taken as whole.
      const Length outside = 2.0 * web.thickness;
      Length works = flange.clear();
      if (flange.stiffeners.empty()) {
        if (const auto of = internal_effective_width(works, flange.thickness, 1.0,
                                                     epsilon_of(flange.class_strength)))
          works = of->b_eff;
      }
      const double limit =
          flange_induced_limit(web.clear() * web.thickness,
                               0.5 * (works + outside) * flange.thickness, flange.class_strength);
      const double ratio = web.clear() / web.thickness;
      if (ratio > limit) {
        return fmt::format(
            "the {} may buckle into the {}, h_w/t_w = {:.3g} is above {:.3g} (EN "
            "1993-1-5, 8)",
            to_text(by), to_text(plate), ratio, limit);
      }
    }
  }
  return "";
}

}  // namespace

const char* to_text(PlateRoute route) {
  return route == PlateRoute::effective_widths ? "effective widths" : "reduced stresses";
}

bool may_buckle(const BoxWall& wall) {
  return wall.clear() / wall.thickness >
         internal_part_limits(1.0, 1.0, epsilon_of(wall.class_strength)).class_3;
}

std::string stiffener_obstacle(const FourWalls& of) {
  for (const BoxPlate plate : box_plates) {
    const BoxWall& wall = of.of(plate);
    const auto twists = [&](const FlatStiffener& bar) {
      return !resists_torsional_buckling(bar, wall.class_strength);
    };
    const auto bar = std::find_if(wall.stiffeners.begin(), wall.stiffeners.end(), twists);
    if (bar != wall.stiffeners.end()) {
      return fmt::format("a stiffener of the {} twists: d/t = {:.3g}, above 13 eps (9.2.1(8))",
                         to_text(plate), (bar->depth / bar->thickness).value());
    }
    const StiffenedPlate as_plate = stiffened_plate_of(wall, {});
    if (!wall.stiffeners.empty() && may_buckle(wall) && !are_stiff_enough(as_plate)) {
      return fmt::format("the stiffeners of the {} are too weak, gamma = {:.3g} below 25",
                         to_text(plate), relative_stiffness(as_plate));
    }
  }
  return "";
}

std::vector<FourWalls> walls_of_segment(const Project& project, const Station& station) {
  const std::size_t index = segment_at(project.beam, station);
  const Segment& segment = project.beam.segments[index];
  std::vector<FourWalls> walls;
  for (const Section* section : {&segment.from, &segment.to}) {
    if (auto of = four_walls_of(section->outer, materials_of(project, index)))
      walls.push_back(std::move(*of));
  }
  return walls;
}

std::optional<FourWalls> deciding_walls_at(const Project& project, const Station& station) {
  const std::size_t index = segment_at(project.beam, station);
  auto walls =
      four_walls_of(section_inside(project.beam, station).outer, materials_of(project, index));
  if (!walls || !is_steep(project.beam.segments[index])) return walls;
  const std::array<Length, 4> widest = widest_in_panel(project, station);
  for (std::size_t k = 0; k < widest.size(); ++k) {
    BoxWall& wall = walls->walls[k];
    wall.high = std::max(wall.high, Length(wall.low + widest[k]));
  }
  return walls;
}

std::vector<int> plate_choices_at(const Project& project, const Station& station) {
  const auto walls = deciding_walls_at(project, station);
  if (!walls) return path_choices_at(project, station);
  std::vector<int> choices{stiffener_obstacle(*walls).empty() ? 1 : 0,
                           induced_obstacle(*walls, project.in_space).empty() ? 1 : 0};
  for (const BoxWall& wall : walls->walls) {
    choices.push_back(may_buckle(wall) ? 1 : 0);
    choices.push_back(may_buckle_in_shear(wall) ? 1 : 0);
  }
  return choices;
}

std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station) {
  auto walls = four_walls_of(judged_section_at(project, station).outer,
                             materials_of(project, segment_at(project.beam, station)));
  if (!walls) return std::nullopt;
  walls->length = supported_length_at(project, station);
  const auto deciding = deciding_walls_at(project, station);
  if (!deciding) return std::nullopt;
  for (const BoxPlate plate : box_plates) {
    if (!may_buckle(deciding->of(plate))) walls->of(plate).stiffeners.clear();
  }
  return walls;
}

EdgeSlopes edge_slopes_of(const Segment& segment) {
  const Extent from = extent_of(segment.from.outer), to = extent_of(segment.to.outer);
  const auto most = [&](Length Extent::*low, Length Extent::*high) {
    return std::max(std::abs(((to.*low - from.*low) / segment.length).value()),
                    std::abs(((to.*high - from.*high) / segment.length).value()));
  };
  return {most(&Extent::y_low, &Extent::y_high), most(&Extent::z_low, &Extent::z_high)};
}

bool is_steep(const Segment& segment) { return slope_of(segment) > steepest; }

PlateRoute plate_route_of(const Project& project, const Segment& segment) {
  return is_steep(segment) ? PlateRoute::reduced_stresses : project.strength.plates;
}

std::string steepness_text(const Segment& segment) {
  return fmt::format("its edges are inclined by {:.3g} deg, above 10 deg (2.3)",
                     slope_of(segment) * 180.0 / std::numbers::pi);
}

std::string plates_obstacle(const Project& project, const Station& station) {
  const Section section = judged_section_at(project, station);
  const std::size_t index = segment_at(project.beam, station);
  const Segment& segment = project.beam.segments[index];
  if (section.inner) return "a profile inside another shares its buckling";
  if (std::holds_alternative<ThinWalled>(section.outer)) return path_obstacle(project, station);
  const auto walls = deciding_walls_at(project, station);
  if (!walls) return "only boxes, rectangular tubes and thin-walled paths are";
  if (std::string why = stiffener_obstacle(*walls); !why.empty()) return why;
  if (std::string why = ending_obstacle(project, station, *walls); !why.empty()) return why;
  if (plate_route_of(project, segment) == PlateRoute::reduced_stresses) {
    for (const BoxPlate plate : box_plates) {
      if (!may_buckle_with_stiffeners(*walls, plate)) continue;
      return fmt::format(
          "the {} needs its stiffeners, which reduced stresses do not judge{}", to_text(plate),
          is_steep(segment)
              ? ", and " + steepness_text(segment)
              : std::string(": write plates = \"effective widths\" under [strength]"));
    }
  }
  if (std::string why = induced_obstacle(*walls, project.in_space); !why.empty()) return why;
  return hole_obstacle(project, station);
}

std::string induced_obstacle(const FourWalls& walls, bool in_space) {
  using enum BoxPlate;
  constexpr std::array webs{left_web, right_web}, flanges{top_flange, bottom_flange};
  if (std::string why = induced_obstacle(walls, webs, flanges); !why.empty()) return why;
  // Under M_z the flanges are the webs.
  return in_space ? induced_obstacle(walls, flanges, webs) : "";
}

bool may_buckle_with_stiffeners(const FourWalls& walls, BoxPlate plate) {
  return !walls.of(plate).stiffeners.empty() && may_buckle(walls.of(plate));
}

bool may_buckle_with_stiffeners(const Project& project, const Station& station, BoxPlate plate) {
  const auto walls = deciding_walls_at(project, station);
  return walls && may_buckle_with_stiffeners(*walls, plate);
}

}  // namespace boxbeam
