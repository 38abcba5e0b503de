#include "boxbeam/verification/hole_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/verification/judged_section.hpp"

namespace boxbeam {
namespace {

/// From this part of a plate's width on the bending of the strips beside a hole is looked at, above
/// this part of the yield strength it stops a verdict; of posts where holes in a row take more than
/// half of their pitch, in fatigue 0.4 of it: up to there the shear of a post uses it up before.
constexpr double large_hole = 0.3, felt = 0.05, narrow = 0.5, narrow_in_fatigue = 0.6;

std::string name_of(const BeamHole& at) {
  return fmt::format("hole \"{}\" at s = {} m", at.hole.name, to_text(Station{at.s, Side::both}));
}

Gate gate_at(const Project& project, const BeamHole& at, const std::string& finding) {
  const std::size_t segment = segment_at(project.beam, {at.s, Side::both});
  return {project.beam.segments[segment].name, "", name_of(at) + finding, true};
}

const Diaphragm* diaphragm_in(const Project& project, const BeamHole& at) {
  for (const Diaphragm& of : project.beam.diaphragms)
    if (abs(of.s - at.s) < 0.5 * (at.hole.diameter + of.thickness)) return &of;
  return nullptr;
}

/// How a hole leaves a plate to bend beside it.
struct StripBending {
  std::string place;
  double share = 0.0;  ///< of the plate's width that the hole takes
  Stress stress;
  double used = 0.0;  ///< of the yield strength
};

/// The bending stress of strips over the mean shear stress in them, each a rectangle of its own:
///
///     sigma/tau = 6 x 0.225 n d/c,  c what the n strips are wide together
double bending_per_shear(const BeamHole& at, const StressField& field) {
  const HoleWalls walls = at.hole.walls;
  const Length taken = taken_by_holes(field.holes, walls);
  const Length left = clear_for_holes(field.section.outer, walls) - taken;
  int strips = 1;
  for (const Hole& of : field.holes) {
    if (of.walls == walls)
      strips += walls == HoleWalls::flanges && of.position.value() != 0.0 ? 2 : 1;
  }
  return 6.0 * 0.225 * strips * at.hole.diameter / left;
}

/// Where the strips on a side of a station bend most.
std::optional<StripBending> strip_bending_at(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const BeamHole& at, const Station& station) {
  const Section section = judged_section_at(project, station);
  const double share = at.hole.diameter / clear_for_holes(section.outer, at.hole.walls);
  if (share <= large_hole) return std::nullopt;
  const Taper taper = taper_at(project.beam, station);
  const StressField field = stress_field_of(section, holes_at(project, station.s), taper);
  const StressField whole = stress_field_of(section, {}, taper);
  const PlateMaterials materials = materials_of(project, segment_at(project.beam, station));
  const double per_shear = bending_per_shear(at, field);
  const std::vector<SituationHistory> histories = histories_at(runs, station);
  StripBending worst;
  for (const PlateStrip& strip : strips_beside(
           field, whole, at.hole, project.in_space ? PointSet::in_space : PointSet::in_plane)) {
    const SectionPoint& point = strip.point;
    const PlateOf plate = first_to_yield(plates_at(materials, section, point.y, point.z));
    const double yield = yield_strength_of(*plate.material, plate.thickness)->value();
    for (const SituationHistory& of : histories) {
      for (const CutForces& cut : of.history.samples()) {
        const double stress =
            of.situation->load_factor * per_shear * std::abs(stress_of(point.influence.shear, cut));
        const double used = project.strength.required * project.strength.gamma_M0 * stress / yield;
        if (used > worst.used) worst = {point.name, share, si<Stress>(stress), used};
      }
    }
  }
  return worst;
}

/// On both sides of a hole's centre, and on its edges along the beam: beyond a border or a jump of
/// cut forces within it.
std::vector<Station> stations_of(const Project& project, const BeamHole& at) {
  const Length radius = 0.5 * at.hole.diameter, end = project.beam.length();
  std::vector<Station> stations;
  if (at.s > Length{}) stations.push_back({at.s, Side::before});
  if (at.s < end) stations.push_back({at.s, Side::behind});
  if (at.s - radius > Length{}) stations.push_back({at.s - radius, Side::behind});
  if (at.s + radius < end) stations.push_back({at.s + radius, Side::before});
  return stations;
}

std::optional<StripBending> strip_bending_of(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const BeamHole& at) {
  std::optional<StripBending> worst;
  for (const Station& station : stations_of(project, at)) {
    auto here = strip_bending_at(project, runs, at, station);
    if (here && (!worst || here->used > worst->used)) worst = std::move(here);
  }
  return worst;
}

/// How the post between two holes in a row bends.
struct PostBending {
  const HolePost* post = nullptr;
  Stress stress;
  double used = 0.0;  ///< of the yield strength
};

/// The post beside a hole that bends most among some, by the flow where the hole is.
PostBending post_bending_of(const Project& project, const std::deque<SituationRun>& runs,
                            const BeamHole& at, const std::vector<HolePost>& posts) {
  PostBending worst;
  for (const Station& station : stations_of(project, at)) {
    const Section section = judged_section_at(project, station);
    const StressField whole = stress_field_of(section, {}, taper_at(project.beam, station));
    const PlateMaterials materials = materials_of(project, segment_at(project.beam, station));
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    for (const SectionPoint& point :
         posts_at(whole, at.hole, project.in_space ? PointSet::in_space : PointSet::in_plane)) {
      double most = 0.0;
      for (const SituationHistory& of : histories) {
        for (const CutForces& cut : of.history.samples())
          most = std::max(
              most, of.situation->load_factor * std::abs(stress_of(point.influence.shear, cut)));
      }
      const PlateOf plate = first_to_yield(plates_at(materials, section, point.y, point.z));
      const double yield = yield_strength_of(*plate.material, plate.thickness)->value();
      for (const HolePost& post : posts) {
        const double stress = post.bending_per_shear() * most;
        const double used = project.strength.required * project.strength.gamma_M0 * stress / yield;
        if (used > worst.used) worst = {&post, si<Stress>(stress), used};
      }
    }
  }
  return worst;
}

/// What stands against the posts on either side of a hole.
std::optional<Gate> post_gate_of(const Project& project, const std::deque<SituationRun>& runs,
                                 const BeamHole& at) {
  std::vector<HolePost> posts = posts_beside(project, at);
  // Each post once, by its hole nearer to the beginning; far from each other holes leave webs.
  constexpr double far = 10.0;
  const auto none = [&](const HolePost& of) {
    return !of.faced || of.next->s < at.s || of.pitch > far * of.diameter;
  };
  posts.erase(std::remove_if(posts.begin(), posts.end(), none), posts.end());
  if (posts.empty()) return std::nullopt;
  const PostBending bending = post_bending_of(project, runs, at, posts);
  if (bending.post == nullptr) return std::nullopt;
  const HolePost& post = *bending.post;
  constexpr double round_off = 1e-9;
  const double share = project.fatigue.asked ? narrow_in_fatigue : narrow;
  const bool is_narrow = post.left < (1.0 - round_off) * share * post.pitch;
  if (!(bending.used > (is_narrow ? felt : 1.0))) return std::nullopt;
  return gate_at(
      project, at,
      fmt::format(" and hole \"{}\" leave a post of {:.4g} mm of {:.4g} mm along the "
                  "beam, which the shear flow of its pitch bends in its plane by {:.3g} "
                  "MPa, {:.3g} of its yield strength; that is not judged",
                  post.next->hole.name, 1e3 * post.left.value(), 1e3 * post.pitch.value(),
                  1e-6 * bending.stress.value(), bending.used));
}

/// Whether a hole, with those that reach over its station in the same plates, is wider than what
/// does not count.
bool is_wide_with_others(const Project& project, const BeamHole& at) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  std::vector<Hole> together;
  for (const BeamHole& other : project.holes) {
    if (abs(other.s - at.s) < 0.5 * (other.hole.diameter + at.hole.diameter))
      together.push_back(other.hole);
  }
  return taken_by_holes(together, at.hole.walls) >
         widest_opening * clear_for_holes(section.outer, at.hole.walls);
}

}  // namespace

bool is_wide(const Project& project, const BeamHole& at) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  return at.hole.diameter > widest_opening * clear_for_holes(section.outer, at.hole.walls);
}

std::vector<Gate> hole_gates_of(const Project& project, const std::deque<SituationRun>& runs) {
  std::vector<Gate> gates;
  for (const BeamHole& at : project.holes) {
    if (is_wide(project, at) || is_wide_with_others(project, at)) {
      const Length radius = 0.5 * at.hole.diameter;
      if (const Diaphragm* of = diaphragm_in(project, at))
        gates.push_back(gate_at(project, at,
                                fmt::format(": the diaphragm at s = {} m stands on it, which is "
                                            "taken to stand on whole plates",
                                            to_text(Station{of->s, Side::both}))));
      if (at.s < radius || at.s > project.beam.length() - radius)
        gates.push_back(gate_at(project, at,
                                " reaches over the end of the beam, which is taken to be "
                                "that of whole plates"));
    }
    if (auto gate = post_gate_of(project, runs, at)) gates.push_back(std::move(*gate));
    if (at.concentration) continue;
    const auto bending = strip_bending_of(project, runs, at);
    if (!bending || !(bending->used > felt)) continue;
    gates.push_back(gate_at(
        project, at,
        fmt::format(" takes {:.3g} of its plate's width: under the plate's force what it leaves "
                    "bends by about {:.3g} MPa (F/n 0.225 d in each strip by itself, {}), which "
                    "is not judged by a detail alone; concentration = \"{}\" judges its edge",
                    bending->share, bending->stress.value() * 1e-6, bending->place,
                    at.hole.walls == HoleWalls::webs ? "in-plane bending" : "membrane tension")));
  }
  return gates;
}

}  // namespace boxbeam
