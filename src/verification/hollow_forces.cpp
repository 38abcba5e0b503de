#include "hollow_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "force_kinds.hpp"

namespace boxbeam {
namespace {

/// Of a transverse plate on a round tube, over f_y t^2: the least of any, and the most.
constexpr double least_plate = 4.0, widest_plate = 5.0 / (1.0 - 0.81);
/// Up to this part of what is borne at least nothing is said.
constexpr double hardly_pressed = 0.1;

/// What the walls of a section bear of a force across it.
struct Bears {
  bool round = false;
  Length wall;
  Force least, most;
  Length depth;       ///< of the section
  bool said = false;  ///< whether a profile inside shares it
};

double away_from(const SectionPlace& from, const SectionPlace& to, const SectionPlace& place) {
  const double y = (to.y - from.y).value(), z = (to.z - from.z).value();
  const double py = (place.y - from.y).value(), pz = (place.z - from.z).value();
  const double size = y * y + z * z;
  const double along = size > 0.0 ? std::clamp((py * y + pz * z) / size, 0.0, 1.0) : 0.0;
  return std::hypot(py - along * y, pz - along * z);
}

/// The least way between two loops.
double least_way(const std::vector<SectionPlace>& one, const std::vector<SectionPlace>& other) {
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const std::vector<SectionPlace>& edges,
                        const std::vector<SectionPlace>& places) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (const SectionPlace& place : places)
        least = std::min(least, away_from(edges[i], edges[(i + 1) % edges.size()], place));
    }
  };
  look(one, other);
  look(other, one);
  return least;
}

std::optional<Length> wall_of(const Profile& profile) {
  if (const auto* const tube = std::get_if<RoundTube>(&profile)) return tube->wall;
  const auto* const polygon = std::get_if<Polygon>(&profile);
  if (polygon == nullptr || polygon->hollows.empty()) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon->hollows.size(); ++i) {
    least = std::min(least, least_way(polygon->hollows[i], polygon->outer));
    for (std::size_t k = 0; k < i; ++k)
      least = std::min(least, least_way(polygon->hollows[i], polygon->hollows[k]));
  }
  return si<Length>(least);
}

/// Nothing of other sections.
std::optional<Bears> bears_at(const Project& project, const Station& station) {
  const Section section = judged_section_at(project, station);
  const auto wall = wall_of(section.outer);
  if (!wall) return std::nullopt;
  const Extent extent = extent_of(section.outer);
  const PlateMaterials materials = materials_of(project, segment_at(project.beam, station));
  const PlateOf plate =
      first_to_yield(plates_at(materials, section, Length{}, extent.z_high - 0.5 * *wall));
  const Stress yield = *yield_strength_of(*plate.material, *wall);
  Bears of;
  of.wall = *wall;
  of.round = std::holds_alternative<RoundTube>(section.outer);
  of.depth = std::max(extent.z_high - extent.z_low, extent.y_high - extent.y_low);
  of.said = section.inner.has_value();
  if (of.round) {
    const Force per = *wall * *wall * yield;
    of.least = least_plate * per;
    of.most = widest_plate * per;
    return of;
  }
  PatchedWeb web;
  web.depth = of.depth - 2.0 * *wall;
  web.thickness = web.flange_thickness = *wall;
  web.yield_strength = web.flange_strength = yield;
  web.flange_inside = 0.5 * of.depth;
  of.least = of.most = 2.0 * patch_resistance_of(web, project.strength.gamma_M1).resistance;
  return of;
}

/// Finds the worst of all.
class HollowForces {
 public:
  HollowForces(const Project& project, const std::deque<SituationRun>& runs)
      : project_(&project), kinds_(project) {
    for (const SituationRun& run : runs) kinds_.learn(run);
  }

  void look_at(const SituationRun& run) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const BeamLoads loads = run.loads.loads_at(run.loads.time_of(i));
      for (const PointLoad& of : loads.points) look_at(loads, of, run.situation->load_factor);
    }
  }

  void add_to(PatchChecks& found) const {
    for (const Worst* of : {&blocking_, &said_}) {
      if (of->use == 0.0) continue;
      const std::string place = to_text(Station{of->s, Side::both});
      const std::string what = of->bears.round ? "round tube" : "polygon with a hollow";
      const std::string why = fmt::format(
          "how a wall of {:.4g} mm bears {:.4g} kN of \"{}\" across it is not judged{}",
          1e3 * of->bears.wall.value(), 1e-3 * of->force.value(), of->name,
          of->bears.round
              ? fmt::format("; by EN 1993-1-8, table 7.3, {:.4g} kN (4 f_y t^2) under a narrow "
                            "plate, up to {:.4g} kN under one as wide as the tube",
                            1e-3 * of->bears.least.value(), 1e-3 * of->bears.most.value())
              : fmt::format("; two such webs bear {:.4g} kN under an edge (EN 1993-1-5, clause 6)",
                            1e-3 * of->bears.most.value()));
      if (of == &said_) {
        found.not_judged.push_back(
            {Criterion::patch_loading, fmt::format("{} at s = {} m", what, place), why});
        continue;
      }
      const std::size_t segment = segment_at(project_->beam, {of->s, Side::both});
      found.gates.push_back(
          {project_->beam.segments[segment].name, "",
           fmt::format("{} at s = {} m: {}; [[beam.diaphragms]] say what takes it", what, place,
                       why),
           true});
    }
  }

 private:
  struct Worst {
    double use = 0.0;
    Length s;
    Force force;
    std::string name;
    Bears bears;
  };

  void look_at(const BeamLoads& loads, const PointLoad& load, double load_factor) {
    const Length end = project_->beam.length(), s = std::clamp(load.s, Length{}, end);
    if (stands_at_end(project_->beam, load.s) && kinds_.clamps(load.name)) return;
    const double size = load.force.norm();
    if (size == 0.0) return;
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? s == Length{} : s == end) continue;
      const auto bears = bears_near({s, side});
      if (!bears) continue;
      // All that comes in there with its sense; what is along the beam does not count.
      const Eigen::Vector2d across(load.force.y(), load.force.z());
      if (across.norm() == 0.0) continue;
      double sum = 0.0;
      for (const PointLoad& other : loads.points) {
        const bool clamp = stands_at_end(project_->beam, other.s) && kinds_.clamps(other.name);
        if (clamp || abs(other.s - load.s) > 0.5 * bears->depth) continue;
        const double with = Eigen::Vector2d(other.force.y(), other.force.z()).dot(across);
        sum += std::max(0.0, with / across.norm());
      }
      keep(load, s, *bears, load_factor * project_->strength.required * si<Force>(sum));
    }
  }

  void keep(const PointLoad& load, Length s, const Bears& bears, Force force) {
    if (!(force > hardly_pressed * bears.least)) return;
    const bool stops = force > bears.most && !bears.said && !is_taken(s, bears.depth);
    Worst& worst = stops ? blocking_ : said_;
    const double use = force / bears.least;
    if (use <= worst.use) return;
    worst = {use, s, force, load.name.empty() ? "a force" : std::string(load.name), bears};
  }

  /// Whether a diaphragm or a boss stands there, or goes round the place.
  bool is_taken(Length s, Length depth) const {
    const TaperedBeam& beam = project_->beam;
    constexpr double same_place = 1e-6;
    const Length near = same_place * std::max(beam.length(), depth);
    return std::any_of(beam.diaphragms.begin(), beam.diaphragms.end(),
                       [&](const Diaphragm& of) { return abs(of.s - s) <= near; }) ||
           std::any_of(beam.introductions.begin(), beam.introductions.end(),
                       [&](const LoadIntroduction& of) {
                         return !of.stiff_length && s >= of.from - near && s <= of.to + near;
                       });
  }

  const std::optional<Bears>& bears_near(const Station& station) {
    const auto key = std::pair(station.s.value(), station.side);
    const auto known = bears_.find(key);
    if (known != bears_.end()) return known->second;
    // Of what slides along the beam the places never end.
    constexpr std::size_t most = 4096;
    if (bears_.size() >= most) bears_.clear();
    return bears_.emplace(key, bears_at(*project_, station)).first->second;
  }

  const Project* project_;
  ForceKinds kinds_;
  std::map<std::pair<double, Side>, std::optional<Bears>> bears_;
  Worst said_, blocking_;
};

}  // namespace

void check_hollow_forces(const Project& project, const std::deque<SituationRun>& runs,
                         PatchChecks& found) {
  const bool any =
      std::any_of(project.beam.segments.begin(), project.beam.segments.end(),
                  [](const Segment& of) { return wall_of(of.from.outer) || wall_of(of.to.outer); });
  if (!any) return;
  HollowForces forces(project, runs);
  for (const SituationRun& run : runs) forces.look_at(run);
  forces.add_to(found);
}

}  // namespace boxbeam
