// Which plates are judged, and by which route of EN 1993-1-5.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Up to this slope of its edges a plate counts as a rectangle. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double steepest = 10.0 * std::numbers::pi / 180.0;

/// Up to this part of a plate's width an opening does not count. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double widest_opening = 0.05;

/// The steepest edge of a segment [rad].
double slope_of(const Segment& segment) {
  const EdgeSlopes of = edge_slopes_of(segment);
  return std::atan(std::max(of.along_y, of.along_z));
}

/// Why a hole of a segment keeps its plates from being judged.
std::string hole_obstacle(const Project& project, const Segment& segment, const FourWalls& walls) {
  for (const BeamHole& at : project.holes) {
    if (at.s < segment.start || at.s > segment.end()) continue;
    Length width;  // of all holes of these plates in one section
    for (const BeamHole& other : project.holes) {
      if (other.s != at.s || other.hole.walls != at.hole.walls) continue;
      const bool pair =
          other.hole.walls == HoleWalls::flanges && other.hole.position.value() != 0.0;
      width += (pair ? 2.0 : 1.0) * other.hole.diameter;
    }
    for (const BoxPlate plate : box_plates) {
      const bool drilled = (at.hole.walls == HoleWalls::flanges) == is_flange(plate);
      if (drilled && width > widest_opening * walls.of(plate).clear())
        return fmt::format("hole \"{}\" is wider than 0.05 of its plate (2.3)", at.hole.name);
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

std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station,
                                         const std::vector<FourWalls>& ends) {
  const Section section = judged_section_at(project, station);
  if (section.inner) return std::nullopt;
  auto walls =
      four_walls_of(section.outer, materials_of(project, segment_at(project.beam, station)));
  if (!walls) return std::nullopt;
  walls->length = supported_length_at(project, station);
  for (const BoxPlate plate : box_plates) {
    const bool slender = std::any_of(ends.begin(), ends.end(),
                                     [&](const FourWalls& of) { return may_buckle(of.of(plate)); });
    if (!slender) walls->of(plate).stiffeners.clear();
  }
  return walls;
}

std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station) {
  return judged_walls_at(project, station, walls_of_segment(project, station));
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
  const auto walls = four_walls_of(section.outer, materials_of(project, index));
  if (!walls) return "only boxes, rectangular tubes and thin-walled paths are";
  const std::vector<FourWalls> ends = walls_of_segment(project, station);
  for (const FourWalls& end : ends)
    if (std::string why = stiffener_obstacle(end); !why.empty()) return why;
  if (plate_route_of(project, segment) == PlateRoute::reduced_stresses) {
    for (const BoxPlate plate : box_plates) {
      if (!may_buckle_with_stiffeners(ends, plate)) continue;
      return fmt::format(
          "the {} needs its stiffeners, which reduced stresses do not judge{}", to_text(plate),
          is_steep(segment)
              ? ", and " + steepness_text(segment)
              : std::string(": write plates = \"effective widths\" under [strength]"));
    }
  }
  return hole_obstacle(project, segment, *walls);
}

bool may_buckle_with_stiffeners(const std::vector<FourWalls>& ends, BoxPlate plate) {
  return std::any_of(ends.begin(), ends.end(), [&](const FourWalls& of) {
    return !of.of(plate).stiffeners.empty() && may_buckle(of.of(plate));
  });
}

bool may_buckle_with_stiffeners(const Project& project, const Station& station, BoxPlate plate) {
  return may_buckle_with_stiffeners(walls_of_segment(project, station), plate);
}

}  // namespace boxbeam
