#include "boxbeam/verification/slender_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// The path of a section; nothing where another profile stands in it.
const ThinWalled* path_in(const Section& section) {
  return section.inner ? nullptr : std::get_if<ThinWalled>(&section.outer);
}

/// The plates that decide what of a station is judged; none where a profile stands in another.
std::vector<PathPlate> deciding_plates_at(const Project& project, const Station& station) {
  const Section section = section_inside(project.beam, station);
  const ThinWalled* const path = path_in(section);
  if (path == nullptr) return {};
  return plates_of(*path, materials_of(project, segment_at(project.beam, station)));
}

bool is_slender(const std::vector<PathPlate>& plates) {
  return std::any_of(plates.begin(), plates.end(),
                     [](const PathPlate& plate) { return may_buckle(plate); });
}

/// Why plates beyond class 3 have no effective width; "" where all have.
std::string widths_obstacle(const std::vector<PathPlate>& plates) {
  for (const PathPlate& plate : plates) {
    std::string why = may_buckle(plate) ? width_obstacle(plate) : "";
    if (!why.empty()) return why;
  }
  return "";
}

/// How steep the walls of a segment are: the fastest of their nodes.
double path_slope_of(const Segment& segment) {
  const ThinWalled &from = *path_in(segment.from), &to = *path_in(segment.to);
  double most = 0.0;
  for (std::size_t i = 0; i < from.nodes.size(); ++i) {
    const SectionPlace &a = from.nodes[i], &b = to.nodes[i];
    most = std::max({most, std::abs(((b.y - a.y) / segment.length).value()),
                     std::abs(((b.z - a.z) / segment.length).value())});
  }
  return std::atan(most) * 180.0 / std::numbers::pi;
}

/// The plate whose flange may buckle into it; "" where none may.
std::string induced_buckling(const EffectivePath& of) {
  const std::vector<PathPlate>& plates = of.path().plates;
  const std::vector<PlateAlone>& alone = of.alone(ActingAlone::compression).plates;
  for (const PathPlate& web : plates) {
    if (web.outstand() || !may_buckle(web)) continue;
    for (const std::size_t node : web.nodes) {
      Area flange;
      Stress strength;
      for (std::size_t k = 0; k < plates.size(); ++k) {
        const PathPlate& other = plates[k];
        if (&other == &web || (other.nodes[0] != node && other.nodes[1] != node)) continue;
        const double share = other.outstand() ? 1.0 : 0.5;
        flange += share * (other.clear() - si<Length>(alone[k].idle())) * other.thickness;
        strength = std::max(strength, other.class_strength);
      }
      if (!(flange > Area{})) continue;
      const double ratio = web.clear() / web.thickness;
      const double limit = flange_induced_limit(web.clear() * web.thickness, flange, strength);
      if (ratio > limit) {
        return fmt::format(
            "{}: its flange may buckle into it, h_w/t_w = {:.3g} is above {:.3g} (EN 1993-1-5, 8)",
            web.name, ratio, limit);
      }
    }
  }
  return "";
}

}  // namespace

bool is_slender_path_at(const Project& project, const Station& station) {
  return is_slender(deciding_plates_at(project, station));
}

Length lagging_width_of(const PathSection& path, const PathPlate& plate) {
  const auto node = [&](std::size_t end) { return path.graph.nodes[plate.nodes[end]]; };
  if (!plate.outstand()) return si<Length>(0.5 * (node(1) - node(0)).norm());
  const bool high = plate.held_at_high();
  return si<Length>((node(high ? 1 : 0) - plate.at(high ? plate.low : plate.high)).norm());
}

std::optional<PathSection> judged_path_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station) {
  const Section section = judged_section_at(project, station);
  const ThinWalled* const path = path_in(section);
  if (path == nullptr) return std::nullopt;
  auto of = path_section_of(*path, materials_of(project, segment_at(project.beam, station)));
  if (!of) return of;
  of->length = supported_length_at(project, station);
  for (const PathPlate& plate : of->plates) {
    const auto share = [&](BendingAxis axis) {
      return ultimate_share_at(zones, station, axis, lagging_width_of(*of, plate), plate.thickness);
    };
    of->lag.push_back({share(BendingAxis::y), share(BendingAxis::z)});
  }
  return of;
}

bool may_buckle_in_shear(const PathPlate& plate) {
  return shear_buckling_need(plate.clear(), plate.thickness, plate.class_strength,
                             shear_hardening_factor(plate.class_strength))
      .check_needed();
}

SlenderPath slender_path_of(const ThinWalled& profile, const PathSection& path, const Taper& taper,
                            std::optional<Length> panel_length, double gamma_M1,
                            const std::vector<PathPlate>& looked_at) {
  SlenderPath of{EffectivePath(path), {}, {}, {}, {}};
  of.plastic = PlasticBox::of_path(of.section);
  const auto is = [&](const ShearedWall& wall, const auto& what) {
    return std::any_of(looked_at.begin(), looked_at.end(), [&](const PathPlate& plate) {
      return plate.name == wall.name && what(plate);
    });
  };
  of.sheared = sheared_walls_of(profile, path, taper, false);
  for (ShearedWall& wall : of.sheared) {
    wall.panel.length = panel_length;
    wall.resists = shear_resistance_of(wall.panel, gamma_M1);
    wall.may_buckle = is(wall, [](const PathPlate& plate) { return may_buckle_in_shear(plate); });
  }
  of.outstands = sheared_walls_of(profile, path, taper, true);
  of.reduced = reduced_plates_of(path, of.sheared, of.outstands);
  std::erase_if(of.outstands, [&](const ShearedWall& wall) {
    return !is(wall, [](const PathPlate& plate) { return may_buckle(plate); });
  });
  return of;
}

double sheared_share(const ShearedWall& outstand, const CutForces& cut) {
  const ShearPanel& panel = outstand.panel;
  return outstand.force_of(cut) /
         (panel.yield_strength * panel.depth * panel.thickness / std::numbers::sqrt3);
}

std::string sheared_outstand_text(double share) {
  return fmt::format(
      "it has a free edge, is beyond class 3 and bears shear, {:.3g} of what makes it yield: its "
      "buckling under that is not judged (EN 1993-1-5, clause 5, is for plates between flanges)",
      share);
}

std::string section_obstacle(const EffectivePath& of) {
  std::string why = widths_obstacle(of.path().plates);
  if (!why.empty()) return why;
  if (!of.settled()) return "its effective section does not settle step by step (4.4)";
  return induced_buckling(of);
}

std::string path_obstacle(const Project& project, const Station& station) {
  const Segment& segment = project.beam.segments[segment_at(project.beam, station)];
  const std::vector<PathPlate> plates = deciding_plates_at(project, station);
  if (plates.empty()) return "a profile inside another shares its buckling";
  if (std::string why = widths_obstacle(plates); !why.empty()) return why;
  if (project.strength.plates == PlateRoute::reduced_stresses)
    return "reduced stresses are for boxes: write plates = \"effective widths\" under [strength]";
  constexpr double steepest = 10.0;
  if (const double slope = path_slope_of(segment); slope > steepest)
    return fmt::format("its walls are inclined by {:.3g} deg, above 10 deg (2.3)", slope);
  const auto path = judged_path_at(project, {}, station);
  if (!path) return "a wall is thicker than its steel has a strength for";
  return section_obstacle(EffectivePath(*path));
}

std::vector<int> path_choices_at(const Project& project, const Station& station) {
  std::vector<int> choices;
  for (const PathPlate& plate : deciding_plates_at(project, station)) {
    const bool slender = may_buckle(plate);
    choices.push_back(slender && width_obstacle(plate).empty() ? 1 : 0);
    choices.push_back(slender ? 1 : 0);
    choices.push_back(may_buckle_in_shear(plate) ? 1 : 0);
  }
  return choices;
}

std::shared_ptr<const SlenderPath> slender_path_at(const Project& project,
                                                   const std::vector<BendingZone>& zones,
                                                   const Station& station) {
  const std::vector<PathPlate> plates = deciding_plates_at(project, station);
  if (!is_slender(plates) || !path_obstacle(project, station).empty()) return nullptr;
  const Section section = judged_section_at(project, station);
  return std::make_shared<SlenderPath>(slender_path_of(
      *path_in(section), *judged_path_at(project, zones, station), taper_at(project.beam, station),
      path_panel_length_at(project, station), project.strength.gamma_M1, plates));
}

}  // namespace boxbeam
