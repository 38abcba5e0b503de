#include "pressed_plates.hpp"

#include <algorithm>

#include "bent_flanges.hpp"
#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Below it the force of a web under a flange, by which no check of any of both is decided.
/// With eta_1 <= 1 a web bears eta_2 <= 0.6 (7.2); the half of it, since F_Rd jumps where m_2 ends.
Force hardly_felt(const Project& project, PatchedWeb web, Length throat) {
  web.stiff_length = web.to_end = web.flange_inside = web.flange_outside = Length{};
  web.entry = ForceEntry::near_end;
  web.length.reset();
  Force least = 0.3 * patch_resistance_of(web, project.strength.gamma_M1).resistance;
  const Length t_f = web.flange_thickness;
  least =
      std::min(least, Force(hardly_bent / (6.0 * bent_outside) * t_f * t_f * web.flange_strength));
  // f_vw of EN 1993-1-8, 4.5.3.3, is above f_y/2, spread over 2 t_f.
  if (throat > Length{})
    least = std::min(least, Force(0.03 * 0.5 * web.yield_strength * throat * 2.0 * t_f));
  double on_loads = 1.0;
  for (const Situation& of : project.situations) on_loads = std::max(on_loads, of.load_factor);
  least /= project.strength.required * on_loads;
  return least;
}

void add_web(const Project& project, const PatchedWeb& web, Length throat,
             PressedPlates::Stout& of) {
  of.hardly = std::min(of.hardly, hardly_felt(project, web, throat));
  if (project.fatigue.asked)
    of.hardly_again = std::min(of.hardly_again,
                               Force(hardly_changes * web.thickness * 2.0 * web.flange_thickness));
}

PressedPlates::Stout stout_walls(const Project& project, const Section& section,
                                 const FourWalls& walls, bool along_z) {
  const std::array webs = webs_along(along_z);
  const auto* const welded = std::get_if<Box>(&section.outer);
  PressedPlates::Stout of;
  of.apart = walls.of(webs[0]).middle - walls.of(webs[1]).middle;
  for (const BoxPlate plate : webs) {
    for (const BoxPlate by : webs_along(!along_z)) {
      add_web(project, web_onto(walls, plate, by),
              welded == nullptr ? Length{} : welded->seam_throat, of);
    }
  }
  return of;
}

PressedPlates::Stout stout_path(const Project& project, const PathSection& path, bool along_z,
                                Force none) {
  PressedPlates::Stout of;
  for (const bool onto_high : {true, false}) {
    const PathWebs bear = webs_of_path(path, along_z, onto_high);
    // Where it is not known what walls along it bear, all is looked at that is not far below it.
    if (!bear.obstacle.empty()) of.hardly = std::min(of.hardly, Force(0.3 * none));
    if (bear.webs.size() == 1) of.share = 1.0;
    if (bear.webs.size() == 2) of.apart = std::min(of.apart, bear.apart());
    for (const PathWeb& web : bear.webs) add_web(project, web.bears, {}, of);
  }
  return of;
}

}  // namespace

void PressedPlates::Stout::add(const Stout& other) {
  hardly = std::min(hardly, other.hardly);
  hardly_again = std::min(hardly_again, other.hardly_again);
  share = std::max(share, other.share);
  apart = std::min(apart, other.apart);
}

bool PressedPlates::Stout::feels(Force force, Moment couple, bool again) const {
  return share * force + couple / apart > (again ? std::min(hardly, hardly_again) : hardly);
}

void PressedPlates::add(const PressedPlates& other) {
  along_z = along_z || other.along_z;
  along_y = along_y || other.along_y;
  path = path || other.path;
  web_along_z = web_along_z || other.web_along_z;
  web_along_y = web_along_y || other.web_along_y;
  none = std::min(none, other.none);
  depth = std::max(depth, other.depth);
  closed = closed || other.closed;
  stout_z.add(other.stout_z);
  stout_y.add(other.stout_y);
}

PressedPlatesAlong::PressedPlatesAlong(const Project& project) : project_(&project) {
  for (const Segment& segment : project.beam.segments) {
    PressedPlates& of = of_segments_.emplace_back(at({segment.start, Side::behind}));
    of.add(at({segment.end(), Side::before}));
  }
}

PressedPlates PressedPlatesAlong::at(const Station& station) const {
  PressedPlates of;
  if (const auto walls = deciding_walls_at(*project_, station)) {
    for (const BoxPlate plate : box_plates) {
      if (!may_buckle_in_shear(walls->of(plate))) continue;
      (is_flange(plate) ? of.along_y : of.along_z) = true;
    }
    look_at_walls(station, of);
  } else {
    look_at_path(station, of);
  }
  return of;
}

const PressedPlates& PressedPlatesAlong::near(Length s) {
  const auto known = near_.find(s.value());
  if (known != near_.end()) return known->second;
  constexpr std::size_t most = 4096;
  if (near_.size() >= most) near_.clear();
  const TaperedBeam& beam = project_->beam;
  PressedPlates of;
  const auto look = [&](Length place) {
    if (place > Length{}) of.add(at({place, Side::before}));
    if (place < beam.length()) of.add(at({place, Side::behind}));
  };
  look(s);
  // What is no box has its depth by its outline.
  const Extent extent = extent_of(section_at(beam, {s, Side::both}).outer);
  const Length reach = of.depth > Length{} ? of.depth : Length(extent.z_high - extent.z_low);
  const Length from = std::max(Length{}, Length(s - reach));
  const Length to = std::min(beam.length(), Length(s + reach));
  look(from);
  look(to);
  for (const Segment& segment : beam.segments) {
    if (segment.start > from && segment.start < to) look(segment.start);
  }
  return near_.emplace(s.value(), of).first->second;
}

void PressedPlatesAlong::look_at_walls(const Station& station, PressedPlates& of) const {
  // Clause 6 bears some 18 t^2 f_y of a force; weight over the depth of a web is far below t^2 f_y.
  const auto walls = judged_walls_at(*project_, station);
  if (!walls) return;
  for (const BoxWall& wall : walls->walls) {
    of.none = std::min(of.none, Force(wall.thickness * wall.thickness * wall.yield_strength));
    of.depth = std::max(of.depth, wall.clear());
  }
  const Section section = judged_section_at(*project_, station);
  of.stout_z = stout_walls(*project_, section, *walls, true);
  of.stout_y = stout_walls(*project_, section, *walls, false);
}

void PressedPlatesAlong::look_at_path(const Station& station, PressedPlates& of) const {
  const Section section = judged_section_at(*project_, station);
  const auto* const profile = std::get_if<ThinWalled>(&section.outer);
  if (profile == nullptr || section.inner) return;
  const auto path = judged_path_at(*project_, {}, station);
  if (!path) return;
  constexpr Stress least_yield = 235e6 * pascal;
  const Extent extent = extent_of(section.outer);
  of.depth = std::max(extent.z_high - extent.z_low, extent.y_high - extent.y_low);
  for (const ThinWall& wall : profile->walls)
    of.none = std::min(of.none, Force(wall.thickness * wall.thickness * least_yield));
  of.stout_z = stout_path(*project_, *path, true, of.none);
  of.stout_y = stout_path(*project_, *path, false, of.none);
  if (!slender_path_at(*project_, {}, station)) return;
  of.path = of.along_y = of.along_z = true;
  of.closed = box_cell_of(section.outer).has_value();
  const auto slender = [&](bool along_z) {
    const std::vector<PathWeb> webs = webs_of_path(*path, along_z, true).webs;
    return std::any_of(webs.begin(), webs.end(), [](const PathWeb& web) { return web.slender; });
  };
  of.web_along_z = slender(true);
  of.web_along_y = slender(false);
}

}  // namespace boxbeam
