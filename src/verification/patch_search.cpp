#include "patch_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Diaphragms, introductions and forces so near each other are at one place, by the beam's length.
constexpr double same_place = 1e-6;

}  // namespace

std::array<BoxPlate, 2> flanges_of(const Patch& patch) {
  using enum BoxPlate;
  std::array flanges =
      patch.along_z ? std::array{top_flange, bottom_flange} : std::array{left_web, right_web};
  // A force along -z pushes onto the top, one along -y onto the left.
  if (patch.force.value() > 0.0) std::swap(flanges[0], flanges[1]);
  return flanges;
}

Length thinner_flange(const FourWalls& walls, const Patch& patch) {
  const auto [one, other] = flanges_of(patch);
  return std::min(walls.of(one).thickness, walls.of(other).thickness);
}

PatchSearch::PatchSearch(const Project& project, const std::vector<BendingZone>& zones)
    : project_(&project),
      zones_(&zones),
      pulling_(project, zones),
      kinks_(flange_kinks_of(project)),
      knees_(judged_knees_of(project)),
      plates_(project),
      kinds_(project) {}

const Diaphragm* PatchSearch::diaphragm_at(Length s) const {
  for (const Diaphragm& of : project_->beam.diaphragms)
    if (abs(of.s - s) <= same_place * project_->beam.length()) return &of;
  return nullptr;
}

bool PatchSearch::holds(const Diaphragm& of, bool along_z) const {
  const auto known = holds_.find({&of, along_z});
  if (known != holds_.end()) return known->second;
  return holds_.emplace(std::pair(&of, along_z), is_firm(*project_, of, along_z)).first->second;
}

PatchSearch::Points PatchSearch::points_of(const SituationRun& run) const {
  constexpr std::size_t looked_at = 8;
  const LoadHistory& history = run.loads;
  const std::size_t step = std::max<std::size_t>(1, history.instants() / looked_at);
  Points of;
  std::vector<Length> places;
  for (std::size_t i = 0; i < history.instants(); i += step) {
    places.clear();
    for (const PointLoad& load : history.loads_at(history.time_of(i)).points)
      places.push_back(load.s);
    std::sort(places.begin(), places.end());
    for (std::size_t k = 1; k < places.size(); ++k)
      of.apart = of.apart && places[k] - places[k - 1] > same_place * project_->beam.length();
    // What enters the beam meanwhile is one more than at the instants looked at.
    of.most = std::max(of.most, static_cast<double>(places.size() + 1));
  }
  return of;
}

bool PatchSearch::again_and_again() const { return project_->fatigue.asked || kinds_.any_moves(); }

bool PatchSearch::has_something_to_do(const std::deque<SituationRun>& runs) {
  // Where a force comes in the cut forces jump by as much, to twice the largest at most; forces
  // that stand at one place may do so without any trace.
  ForcesAcross most;
  most.again = true;
  for (const SituationRun& run : runs) {
    const double largest = run.loads.largest_force();
    const Points points = points_of(run);
    double force =
        points.apart ? 2.0 * points.most * largest : std::numeric_limits<double>::infinity();
    for (const FlangeKink& of : kinks_) force += of.most_under(largest, run.loads.largest_moment());
    most.along_z = std::max(most.along_z, si<Force>(force));
    most.along_y = most.along_z;
    if (!project_->in_space) continue;
    most.couple = std::max(most.couple, si<Moment>(2.0 * points.most * run.loads.largest_moment()));
  }
  // In the plane flanges take forces from diaphragms and from kinks of webs alone.
  const bool sideways =
      std::any_of(kinks_.begin(), kinks_.end(), [](const FlangeKink& of) { return !of.along_z; });
  const bool flanges = project_->in_space || !project_->beam.diaphragms.empty() || sideways;
  const auto any_meets = [&] {
    const std::vector<PressedPlates>& all = plates_.of_segments();
    return !project_->beam.introductions.empty() ||
           std::any_of(all.begin(), all.end(), [&](const PressedPlates& of) {
             return of.along_z || (flanges && of.along_y) || of.meet(true, most) ||
                    ((project_->in_space || sideways) && of.meet(false, most));
           });
  };
  if (!any_meets()) return false;
  for (const SituationRun& run : runs) kinds_.learn(run);
  most.again = again_and_again();
  return any_meets();
}

std::vector<Patch> PatchSearch::patches_of(const BeamLoads& loads, const CutForceDiagram& diagram) {
  std::vector<Patch> patches = forces_of(loads), kinks = kinks_under(diagram);
  patches.insert(patches.end(), std::make_move_iterator(kinks.begin()),
                 std::make_move_iterator(kinks.end()));
  ForcesAcross all;
  all.again = again_and_again();
  for (const Patch& of : patches) {
    Force& sum = of.along_z ? all.along_z : all.along_y;
    sum += abs(of.force);
    all.couple += abs(of.couple);
  }
  // What hardly presses by itself is opposed to others all the same.
  std::vector<Patch> looked_at;
  looked_at.reserve(2 * patches.size());  // groups follow
  for (Patch& of : patches)
    if (say_how_it_comes_in(of, all)) looked_at.push_back(of);
  if (!looked_at.empty()) mark_opposed(loads.lines, patches, looked_at);
  patches = std::move(looked_at);
  add_groups(patches);
  add_lines(loads.lines, true, patches);
  if (project_->in_space) add_lines(loads.lines, false, patches);
  add_bare_diaphragms(patches);
  return patches;
}

std::vector<Borne> PatchSearch::worst_of(const Patch& patch, const std::vector<Patch>& all,
                                         const CutForceDiagram& diagram) {
  std::vector<Borne> worst;
  const auto take = [&](Borne of) {
    const auto same = std::find_if(worst.begin(), worst.end(),
                                   [&](const Borne& other) { return other.part == of.part; });
    if (same == worst.end())
      worst.push_back(std::move(of));
    else if (factor_of(of.basis) < factor_of(same->basis))
      *same = std::move(of);
  };
  Patch there = patch;
  for (const Reached& reached : reached_by(patch)) {
    const Station& station = reached.at;
    there.force = reached.part * patch.force;
    there.couple = reached.part * patch.couple;
    there.stiff_length = reached.stiff_length;
    const PatchBasis start = basis_of(there, station, diagram);
    const JudgedSection& judged = judged_at(station);
    there.square_to_it = square_to(patch, all, judged);
    if (judged.path) {
      for (Borne& of : path_ways_at(there, start, station, judged, diagram)) take(std::move(of));
    }
    if (!judged.box) continue;
    for (Borne& of : ways_at(there, start, station, judged, diagram)) take(std::move(of));
    if (judged.seams.empty()) continue;
    for (Borne& of : seams_at(patch, all, judged, diagram.at(station))) take(std::move(of));
  }
  return worst;
}

Force PatchSearch::square_to(const Patch& patch, const std::vector<Patch>& all,
                             const JudgedSection& judged) {
  if (patch.diaphragm == nullptr) return {};
  // Of each sense by themselves, on either plate of a box; of paths all of it.
  std::array<std::array<Force, 2>, 2> on{};
  for (const Patch& other : all) {
    const bool alone = !other.together || other.led_onto;
    if (other.diaphragm != patch.diaphragm || other.along_z == patch.along_z || !alone ||
        other.is_none())
      continue;
    std::array<double, 2> shares{1.0, 1.0};
    if (judged.box) shares = shared_by_webs(other, judged.box->box()).shares;
    for (const std::size_t k : {0U, 1U})
      on[other.force > Force{} ? 0 : 1][k] += std::abs(shares[k]) * abs(other.force);
  }
  return std::max({on[0][0], on[0][1], on[1][0], on[1][1]});
}

std::vector<PatchSearch::Reached> PatchSearch::reached_by(const Patch& patch) {
  std::vector<Reached> stations;
  stations.reserve(2);
  const Length end = project_->beam.length();
  Length flange;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? patch.s == Length{} : patch.s == end) continue;
    stations.push_back({{patch.s, side}, 1.0, patch.stiff_length});
    const JudgedSection& judged = judged_at(stations.back().at);
    if (!judged.box || patch.is_line) continue;
    for (const BoxPlate plate : flanges_of(patch))
      flange = std::max(flange, judged.box->box().of(plate).thickness);
  }
  if (patch.diaphragm != nullptr) return stations;
  const Length half = 0.5 * patch.stiff_length, reach = half + flange;
  const std::vector<Segment>& segments = project_->beam.segments;
  for (std::size_t k = 0; k + 1 < segments.size(); ++k) {
    const Length border = segments[k].end(), away = abs(border - patch.s);
    if (border == patch.s || away >= reach) continue;
    const Station beyond{border, border > patch.s ? Side::behind : Side::before};
    // Of several that stand together any may be beyond it.
    if (patch.together && !patch.is_line)
      stations.push_back({beyond, 1.0, patch.stiff_length});
    else
      stations.push_back({beyond, ((reach - away) / (2.0 * reach)).value(),
                          std::max(Length{}, Length(half - away))});
  }
  return stations;
}

double PatchSearch::factor_of(const PatchBasis& basis) const {
  const bool beside = std::holds_alternative<PatchedWeb>(basis.bears);
  if (basis.pulls) {
    return stiffener_factor(basis.share * basis.force, basis.pulls->shear,
                            buckling_shear_of(basis.pulls->panel, project_->strength.gamma_M1),
                            basis.resistance);
  }
  return patch_factor(basis.share * basis.force / basis.resistance, beside ? eta_1_of(basis) : 0.0);
}

double PatchSearch::eta_1_of(const PatchBasis& basis) const {
  return project_->strength.gamma_M0 * (basis.path ? basis.place.use : basis.corner.use);
}

std::string PatchSearch::obstacle_of(const LoadIntroduction& of) {
  for (const Length& s : {of.from, of.to}) {
    const Station station{s, s < project_->beam.length() ? Side::behind : Side::before};
    const JudgedSection& judged = judged_at(station);
    if (judged.box || judged.path) continue;
    return std::holds_alternative<ThinWalled>(judged_section_at(*project_, station).outer)
               ? path_obstacle(*project_, station)
               : "only of boxes, rectangular tubes and thin-walled paths is it judged what it does";
  }
  return used_.count(&of) > 0 ? "" : "no force of the case is known to come in there";
}

std::optional<FourWalls> PatchSearch::walls_at(const Station& station) const {
  return judged_walls_at(*project_, station);
}

bool PatchSearch::is_at_end(Length s) const { return stands_at_end(project_->beam, s); }

const LoadIntroduction* PatchSearch::introduction_at(Length s) const {
  const Length near = same_place * project_->beam.length();
  const LoadIntroduction* narrowest = nullptr;
  for (const LoadIntroduction& of : project_->beam.introductions) {
    if (s < of.from - near || s > of.to + near) continue;
    // Of two as narrow the shorter stiff length.
    const auto size = [](const LoadIntroduction& at) {
      return std::pair(at.to - at.from, at.stiff_length.value_or(Length{}));
    };
    if (narrowest == nullptr || size(of) < size(*narrowest)) narrowest = &of;
  }
  return narrowest;
}

bool PatchSearch::say_how_it_comes_in(Patch& patch, const ForcesAcross& all) {
  // What turns off does so on a line, whatever the case says of its loads.
  const LoadIntroduction* by = patch.kink != nullptr ? nullptr : introduction_at(patch.s);
  if (by != nullptr && !by->stiff_length) {
    // What bosses in webs lead into them along z, bends them along y.
    if (patch.along_z) return false;
    by = nullptr;
  }
  patch.diaphragm = diaphragm_at(patch.s);
  if (patch.diaphragm != nullptr && !holds(*patch.diaphragm, patch.along_z))
    patch.diaphragm = nullptr;
  if (by != nullptr) {
    patch.stiff_length = *by->stiff_length;
    used_.insert(by);
  }
  patch.given = by != nullptr || patch.diaphragm != nullptr;
  const PressedPlates& of = plates_.near(patch.s);
  const bool slender = patch.along_z ? (of.path ? of.web_along_z : of.along_z)
                                     : (of.path ? of.web_along_y : of.along_y);
  patch.stout = !patch.given && !slender;
  return patch.given || of.meet(patch.along_z, all);
}

Length PatchSearch::depth_at(const Patch& patch) {
  const BoxPlate web = patch.along_z ? BoxPlate::left_web : BoxPlate::top_flange;
  Length depth;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? patch.s == Length{} : patch.s == project_->beam.length()) continue;
    const JudgedSection& judged = judged_at({patch.s, side});
    depth = std::max(depth,
                     judged.box ? judged.box->box().of(web).clear() : depth_of_path(patch, judged));
  }
  return depth;
}

const PatchSearch::JudgedSection& PatchSearch::judged_at(const Station& station) {
  const auto key = std::pair(station.s.value(), station.side);
  const auto known = judged_.find(key);
  if (known != judged_.end()) return known->second;
  // Of what slides along the beam the places never end.
  constexpr std::size_t most = 4096;
  if (judged_.size() >= most) judged_.clear();
  JudgedSection of;
  const Section section = judged_section_at(*project_, station);
  if (std::holds_alternative<ThinWalled>(section.outer)) {
    // What keeps slender plates from being judged says nothing of stout ones.
    const bool judged =
        !is_slender_path_at(*project_, station) || path_obstacle(*project_, station).empty();
    auto path = judged ? judged_path_at(*project_, *zones_, station) : std::nullopt;
    if (path) of.path = std::make_shared<EffectivePath>(*std::move(path));
  }
  if (const auto walls = walls_at(station)) {
    of.box = std::make_shared<EffectiveBox>(*walls, lag_shares_at(*zones_, section, station));
    for (const BoxPlate plate : box_plates) {
      of.panels[static_cast<std::size_t>(plate)] = panel_length_at(*project_, station, plate);
    }
    of.reduced = reduced_at(station, section, *walls);
    const auto* const welded = std::get_if<Box>(&section.outer);
    if (welded != nullptr && welded->seam_throat > Length{}) {
      for (StressPoint& throat : seam_throats_at(*project_, *zones_, station))
        of.seams.push_back(std::make_shared<const StressPoint>(std::move(throat)));
    }
  }
  return judged_.emplace(key, std::move(of)).first->second;
}

std::vector<std::shared_ptr<const ReducedPlate>> PatchSearch::reduced_at(
    const Station& station, const Section& section, const FourWalls& walls) const {
  const TaperedBeam& beam = project_->beam;
  const Segment& segment = beam.segments[segment_at(beam, station)];
  // What a profile inside takes of the stresses along the beam is on the safe side.
  if (plate_route_of(*project_, segment) != PlateRoute::reduced_stresses || section.inner)
    return {};
  std::vector<ShearedPlate> sheared = sheared_plates_of(
      section, walls, taper_at(beam, station), !project_->in_space, project_->strength.gamma_M1);
  divide_into_panels(*project_, station, sheared);
  std::vector<std::shared_ptr<const ReducedPlate>> plates;
  for (ReducedPlate& of : reduced_plates_at(*project_, *zones_, station, section, walls, sheared))
    plates.push_back(std::make_shared<const ReducedPlate>(std::move(of)));
  return plates;
}

PatchBasis PatchSearch::basis_of(const Patch& patch, const Station& station,
                                 const CutForceDiagram& diagram) {
  PatchBasis most;
  const auto look = [&](const Station& at) {
    const JudgedSection& judged = judged_at(at);
    PatchBasis of;
    of.cut = diagram.at(at);
    of.used_most = at.s;
    if (judged.path) {
      of.path = judged.path;
      of.place = judged.path->worst_place(of.cut);
    } else if (judged.box) {
      of.box = judged.box;
      of.corner = judged.box->worst_corner(of.cut);
    }
    const bool first = at.s == station.s && at.side == station.side;
    if (first || (static_cast<bool>(of.box) == static_cast<bool>(most.box) &&
                  static_cast<bool>(of.path) == static_cast<bool>(most.path) &&
                  eta_1_of(of) > eta_1_of(most)))
      most = std::move(of);
  };
  look(station);
  if (patch.diaphragm == nullptr && (patch.together || patch.is_line)) {
    const Length half = 0.5 * patch.stiff_length, from = std::max(Length{}, Length(patch.s - half)),
                 to = std::min(project_->beam.length(), Length(patch.s + half));
    const double near = same_place * project_->beam.length().value();
    // Between forces the moment is a parabola at most, whose bow on so short a length is nothing.
    for (const CutForcePiece& piece : diagram.pieces) {
      if ((piece.start - from).value() > near && (to - piece.start).value() > near)
        for (const Side side : {Side::before, Side::behind}) look({piece.start, side});
    }
    if (from < to) {
      look({from, Side::behind});
      look({to, Side::before});
    }
  }
  most.force = abs(patch.force);
  return most;
}

}  // namespace boxbeam
