#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bent_flanges.hpp"
#include "boxbeam/section/wall_cells.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "boxbeam/strength/transverse_stiffener.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// What is less than that, over a length of the section, is round-off.
constexpr double flat = 1e-9;
/// The sine of 10 degrees: plates that lean so little are taken as square to the force. In the
/// plane of the web they bend no easier than square ones; their reach is their projection.
constexpr double lean = 0.17364817766693033;
/// The sine of a degree: a single web that leans so little pushes its flange hardly sideways.
constexpr double hardly_leans = 0.01745240643728351;

/// Whether a plate bears forces as a web does; an obstacle where it does so unlike one.
bool is_web(const PathPlate& plate, Eigen::Index along, std::string& obstacle) {
  if (plate.outstand()) return false;
  if (!plate.straight) {
    obstacle = plate.name + " is folded";
    return false;
  }
  if (std::abs(plate.direction[along]) <= lean) return false;
  if (std::abs(plate.direction[1 - along]) > lean)
    obstacle = plate.name + " is inclined";
  else if (plate.ribbed)
    obstacle = "a rib stands on " + plate.name;
  return obstacle.empty();
}

/// How far the flange at an end of a wall reaches, to its low and its high side.
using Reach = std::array<Length, 2>;

/// The flange at an end of a wall, as far as it is the wall's; "" or why it leads nothing in.
std::string lead_by_flange(const PathSection& path, const PathPlate& wall, std::size_t end,
                           Eigen::Index along, PatchedWeb& web, Reach& reach) {
  std::vector<Length> widths;
  for (const PathPlate& of : path.plates) {
    const bool meets = of.nodes[0] == wall.nodes[end] || of.nodes[1] == wall.nodes[end];
    // What reaches no farther than the face of what it stands on leads nothing.
    if (&of == &wall || !meets || of.clear() < flat * wall.clear()) continue;
    if (!of.straight || std::abs(of.direction[along]) > lean)
      return fmt::format("{} is no flange square to {}", of.name, wall.name);
    widths.push_back((of.outstand() ? 1.0 : 0.5) * std::abs(of.direction[1 - along]) * of.clear());
    const bool high = of.at(0.5 * (of.low + of.high))[1 - along] >
                      wall.at(end == 1 ? wall.high : wall.low)[1 - along];
    reach[high ? 1 : 0] = widths.back();
    const bool first = widths.size() == 1;
    web.flange_thickness = first ? of.thickness : std::min(web.flange_thickness, of.thickness);
    web.flange_strength =
        first ? of.yield_strength : std::min(web.flange_strength, of.yield_strength);
  }
  if (widths.empty()) return "no flange leads it into " + wall.name;
  web.flange_inside = widths[0];
  web.flange_outside = widths.size() > 1 ? widths[1] : Length{};
  return "";
}

/// What of a patch a web of a path takes, along itself: by the lever between both, at either end of
/// them where it may come in by either flange.
double share_of(const Patch& patch, const PathWebs& of, const PathWeb& web) {
  if (patch.is_none()) return 0.0;
  // A torque presses both by all of it, with unlike senses.
  if (of.webs.size() != 2 || patch.is_torque()) return 1.0 / web.cosine;
  const PathWeb &first = of.webs.front(), &last = of.webs.back();
  const auto at = [&](Length high, Length low) {
    const double by_first = ((patch.stands_at() - low) / (high - low)).value();
    return std::abs(&web == &first ? by_first : 1.0 - by_first);
  };
  double share = at(first.place, last.place);
  if (patch.diaphragm != nullptr || patch.hangs.value_or(false))
    share = std::max(share, at(first.far_place, last.far_place));
  return share / web.cosine;
}

}  // namespace

PathWebs webs_of_path(const PathSection& path, bool along_z, bool onto_high) {
  const Eigen::Index along = along_z ? 1 : 0;
  PathWebs found;
  std::pair<double, double> levels;
  bool leans = false;
  for (const PathPlate& plate : path.plates) {
    if (!is_web(plate, along, found.obstacle)) {
      if (!found.obstacle.empty()) return found;
      continue;
    }
    const double a = plate.at(plate.low)[along], b = plate.at(plate.high)[along];
    const std::pair<double, double> own = std::minmax(a, b);
    // Of walls that lean by unlike angles the same flange's face lies at unlike levels.
    const double across = std::abs(plate.direction[1 - along]);
    leans = leans || across > flat;
    const double near = leans ? 0.1 * plate.thickness.value() : flat * std::sqrt(path.gross.area);
    if (found.webs.empty()) levels = own;
    if (std::abs(own.first - levels.first) > near || std::abs(own.second - levels.second) > near) {
      found.obstacle = "its webs stand at unlike levels";
      return found;
    }
    PathWeb& of = found.webs.emplace_back();
    of.plate = &plate;
    of.cosine = std::abs(plate.direction[along]);
    of.bears.depth = plate.clear();
    of.bears.thickness = plate.thickness;
    of.bears.yield_strength = plate.yield_strength;
    of.slender = shear_buckling_need(plate.clear(), plate.thickness, plate.class_strength,
                                     shear_hardening_factor(plate.class_strength))
                     .check_needed();
    const std::size_t end = (b > a) == onto_high ? 1 : 0;
    of.place = si<Length>(plate.at(end == 1 ? plate.high : plate.low)[1 - along]);
    of.far_place = si<Length>(plate.at(end == 1 ? plate.low : plate.high)[1 - along]);
    std::array<Reach, 2> reach;
    for (const std::size_t k : {1 - end, end}) {
      found.obstacle = lead_by_flange(path, plate, k, along, of.bears, reach[k]);
      if (!found.obstacle.empty()) return found;
    }
    const Length low = std::min(reach[0][0], reach[1][0]),
                 high = std::min(reach[0][1], reach[1][1]);
    of.both_sides = low > Length{} && high > Length{};
    of.beside = of.both_sides ? std::min(low, high) : std::max(low, high);
  }
  if (found.webs.size() == 1 &&
      std::abs(found.webs.front().plate->direction[1 - along]) > hardly_leans)
    found.obstacle = found.webs.front().plate->name + " is inclined";
  std::sort(found.webs.begin(), found.webs.end(),
            [](const PathWeb& a, const PathWeb& b) { return a.place > b.place; });
  return found;
}

Length PathWebs::apart() const {
  const PathWeb &first = webs.front(), &last = webs.back();
  return std::min(abs(first.place - last.place), abs(first.far_place - last.far_place));
}

Length PathWebs::inside() const {
  return apart() - 0.5 * (webs.front().bears.thickness + webs.back().bears.thickness);
}

std::string PatchSearch::path_obstacle_of(const Patch& patch, const PathWebs& of) {
  if (!of.obstacle.empty()) return of.obstacle;
  if (of.webs.empty())
    return fmt::format("no wall along {} between two flanges bears it", patch.along_z ? "z" : "y");
  if (of.webs.size() > 2) return fmt::format("{} walls share it", of.webs.size());
  // What a plate puts into those beside it stands on none (`use_across_kink`).
  if (patch.is_none() || patch.kink != nullptr) return "";
  // Beside two stout webs a diaphragm leads it to both by its lever, as in a box.
  if (patch.diaphragm != nullptr && of.webs.size() == 2 && !plates_.near(patch.s).path) return "";
  // In the plane forces act in that of the web.
  if (!project_->in_space && of.webs.size() == 1) return "";
  const PathWeb &first = of.webs.front(), &last = of.webs.back();
  const Length at = patch.stands_at();
  const Length above = at - first.place - 0.5 * first.bears.thickness;
  const Length below = last.place - at - 0.5 * last.bears.thickness;
  const Length beside = std::max(above, below);
  if (!(beside > flat * first.bears.depth)) return "";
  return fmt::format("it comes in {:.3g} mm beside {}, onto a flange that it bends",
                     1e3 * beside.value(), (above > below ? first : last).plate->name);
}

BearingStiffener PatchSearch::path_stiffener_of(const Patch& patch, const PathWebs& of,
                                                const PathWeb& web, const Station& station) const {
  const bool alone = of.webs.size() == 1;
  BearingStiffener stiffener =
      alone ? flats_beside(*project_, web, *patch.diaphragm, station)
            : stiffener_of(*project_, web.bears, of.inside(), *patch.diaphragm, station);
  stiffener.bows = alone && !web.both_sides;
  const std::vector<Restraint>& holds = project_->restraints;
  stiffener.ends_clamped =
      !alone || std::any_of(holds.begin(), holds.end(), [&](const Restraint& at) {
        const Length near = 1e-6 * project_->beam.length();
        return patch.along_z && at.along_y && at.turning && abs(at.s - patch.s) <= near;
      });
  return stiffener;
}

std::string PatchSearch::bearing_obstacle_of(const Patch& patch, const PathWebs& of,
                                             const Station& station) const {
  if (of.webs.size() == 2) return "";
  return flats_obstacle(flats_beside(*project_, of.webs.front(), *patch.diaphragm, station));
}

bool PatchSearch::bends_a_flange(const Patch& patch, const PathSection& path,
                                 const PathWebs& of) const {
  if (!project_->in_space || patch.standing.empty()) return false;
  // Where no wall is a web any plate may be the flange.
  double bears = std::numeric_limits<double>::infinity();
  const auto take = [&](Length t, Stress strength) {
    bears = std::min(bears, (t * t * strength).value());
  };
  if (!of.webs.empty())
    take(of.webs.front().bears.flange_thickness, of.webs.front().bears.flange_strength);
  else
    for (const PathPlate& plate : path.plates) take(plate.thickness, plate.yield_strength);
  return 6.0 * bent_outside * std::abs(patch.force.value()) > hardly_bent * bears;
}

std::optional<PatchSearch::OnPath> PatchSearch::unjudged_on_path_at(const Patch& patch,
                                                                    const Station& station,
                                                                    double on_loads) {
  const JudgedSection& judged = judged_at(station);
  if (!judged.path) return std::nullopt;
  const PathSection& path = judged.path->path();
  const bool slender = plates_.near(patch.s).path;
  const PathWebs of = webs_of_path(path, patch.along_z, patch.force < Force{});
  std::string why = path_obstacle_of(patch, of);
  if (patch.diaphragm == nullptr) {
    if (why.empty()) return std::nullopt;
    // Stout walls that do not buckle bear much; a plate that turns off has no lug or boss.
    const bool blocks = slender || patch.given || patch.kink != nullptr ||
                        bends_a_flange(patch, path, of) ||
                        on_loads * pressed_by_weakest(*project_, patch, path) > hardly_bent;
    return OnPath{true, blocks, why};
  }
  if (why.empty()) why = bearing_obstacle_of(patch, of, station);
  if (why.empty()) return std::nullopt;
  // Slender walls along the force are judged as webs or not at all.
  if (slender && (!of.webs.empty() || !of.obstacle.empty())) return OnPath{false, true, why};
  const LedUse led = led_into_walls(*project_, patch, path, station);
  const double use = on_loads * std::max(led.across, led.edge);
  // What comes again and again is felt from far less on.
  const double hardly = project_->fatigue.asked ? 0.3 * hardly_bent : hardly_bent;
  if (!slender && !(use > hardly)) return std::nullopt;
  if (use > hardly)
    why += fmt::format(
        "; by an estimate its fillets, its plate in shear or its edge are used by "
        "{:.2g}",
        use);
  // As of boxes it is only said how its edge is pressed.
  return OnPath{false, on_loads * led.across > 1.0, why, !slender};
}

std::optional<PatchSearch::OnPath> PatchSearch::unjudged_on_path(const Patch& patch,
                                                                 double on_loads) {
  std::optional<OnPath> found;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? patch.s == Length{} : patch.s == project_->beam.length()) continue;
    const auto here = unjudged_on_path_at(patch, {patch.s, side}, on_loads);
    if (here && (!found || !found->blocks)) found = here;
  }
  return found;
}

std::vector<Borne> PatchSearch::path_ways_at(const Patch& patch, const PatchBasis& start,
                                             const Station& station, const JudgedSection& judged,
                                             const CutForceDiagram& diagram) {
  std::vector<Borne> ways;
  const PathWebs of = webs_of_path(judged.path->path(), patch.along_z, patch.force < Force{});
  if (!path_obstacle_of(patch, of).empty()) return ways;
  // Others of a path that may buckle are no reason to look at webs that hardly feel it.
  const PressedPlates& here = plates_.near(patch.s);
  if (!patch.given && !(patch.along_z ? here.web_along_z : here.web_along_y) &&
      !here.stout(patch.along_z).feels(abs(patch.force), abs(patch.couple), again_and_again()))
    return ways;
  Borne borne;
  PatchBasis& basis = borne.basis = start;
  const PathWebs others = webs_of_path(judged.path->path(), patch.along_z, patch.force > Force{});
  for (const PathWeb& web : of.webs) {
    basis.share = share_of(patch, of, web);
    borne.wall = web.plate->name;
    if (patch.diaphragm != nullptr) {
      if (!bearing_obstacle_of(patch, of, station).empty()) continue;
      bear_by_stiffener(patch, path_stiffener_of(patch, of, web, station),
                        web.bears.flange_thickness, borne.wall, diagram, borne, ways);
      continue;
    }
    PatchedWeb under = web_under(web.bears, patch);
    under.length = path_panel_length_at(*project_, station);
    std::vector<PatchedWeb> all = in_every_way(under, patch);
    const auto hung = std::find_if(others.webs.begin(), others.webs.end(), [&](const PathWeb& at) {
      return at.plate->name == web.plate->name;
    });
    if (patch.hangs.value_or(false) && hung != others.webs.end() &&
        bears_less(hung->bears, web.bears)) {
      PatchedWeb pulled = web_under(hung->bears, patch);
      pulled.length = under.length;
      pulled.pulled = true;
      for (PatchedWeb& way : in_every_way(pulled, patch)) all.push_back(std::move(way));
    }
    for (const PatchedWeb& way : all) {
      bear_by_effective_widths(way, basis);
      ways.push_back(borne);
    }
  }
  return ways;
}

Length PatchSearch::depth_of_path(const Patch& patch, const JudgedSection& judged) {
  if (!judged.path) return {};
  const PathSection& path = judged.path->path();
  const PathWebs of = webs_of_path(path, patch.along_z, patch.force < Force{});
  if (!of.webs.empty()) return of.webs.front().bears.depth;
  if (of.obstacle.empty()) return {};
  // Of walls along it that are no webs: as far as the section reaches.
  const Eigen::Index along = patch.along_z ? 1 : 0;
  const auto [low, high] = std::minmax_element(
      path.graph.nodes.begin(), path.graph.nodes.end(),
      [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a[along] < b[along]; });
  return si<Length>((*high)[along] - (*low)[along]);
}

PatchSearch::PathTorque PatchSearch::torque_into_path(const BeamLoads& loads) {
  PathTorque most;
  for (const PointLoad& load : loads.points) {
    const Length s = std::clamp(load.s, Length{}, project_->beam.length());
    const Moment torque = si<Moment>(std::abs(load.moment.x()));
    if (!(torque > most.torque) || diaphragm_at(s) != nullptr) continue;
    if (plates_.near(s).closed) most = {s, torque};
  }
  return most;
}

}  // namespace boxbeam
