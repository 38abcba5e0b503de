#include "hollow_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "bent_flanges.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "force_kinds.hpp"
#include "section_gate.hpp"

namespace boxbeam {
namespace {

/// Of a transverse plate on a round tube, over f_y t^2: the least of any, and the most.
constexpr double least_plate = 4.0, widest_plate = 5.0 / (1.0 - 0.81);
/// Up to this part of what is borne at least nothing is said.
constexpr double hardly_pressed = 0.1;
/// The largest moment of a ring that shear flow holds under a line load q, over q r: 3/(4 pi).
constexpr double bent_ring = 0.2387;
/// The same of a strip clamped at both webs under one in its middle, over q b.
constexpr double bent_strip_middle = 0.125;

/// What the walls of a section bear of a force across it.
struct Bears {
  bool round = false;
  Length wall;
  Force least, most;
  Length depth;       ///< of the section
  bool said = false;  ///< whether a profile inside shares it
  Stress yield_strength;
  Length lever = {};  ///< of the moment that a load along the beam makes across the wall, m/q
};

/// The widest hollow of a polygon.
Length widest_hollow_of(const Polygon& of) {
  Length widest;
  for (const std::vector<SectionPlace>& hollow : of.hollows) {
    for (const SectionPlace& a : hollow)
      for (const SectionPlace& b : hollow)
        widest = std::max({widest, Length(a.y - b.y), Length(a.z - b.z)});
  }
  return widest;
}

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
  of.yield_strength = yield;
  if (of.round) {
    of.lever = 0.5 * bent_ring * (of.depth - *wall);
    const Force per = *wall * *wall * yield;
    of.least = least_plate * per;
    of.most = widest_plate * per;
    return of;
  }
  of.lever = bent_strip_middle * widest_hollow_of(std::get<Polygon>(section.outer));
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
      for (const LineLoad& of : loads.lines) look_at(of, run);
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
      found.gates.push_back(section_gate_at(
          *project_, {of->s, Side::both},
          fmt::format("{} at s = {} m: {}; {}", what, place, why,
                      of->by_plate ? fmt::format("the diaphragm there bears {:.4g} kN, by its "
                                                 "plate in shear and its fillets",
                                                 1e-3 * of->by_plate->value())
                                   : "[[beam.diaphragms]] say what takes it")));
    }
    add_lines_to(found);
    if (edge_.use > 1.0)
      found.not_judged.push_back(
          {Criterion::patch_loading,
           fmt::format("edge of the diaphragm at s = {} m", to_text(Station{edge_.s, Side::both})),
           fmt::format("\"{}\" presses it by {:.3g} of its strength over 2 t and as much as "
                       "[[beam.load_introductions]] say its pad is long",
                       edge_.name, edge_.use)});
  }

 private:
  struct Worst {
    double use = 0.0;
    Length s;
    Force force;
    std::string name;
    Bears bears;
    std::optional<Force> by_plate = {};  ///< of a diaphragm there that does not bear it
  };
  /// A load along the beam, over what the wall bears across itself.
  struct WorstLine {
    double use = 0.0;
    Length s;
    double q = 0.0;      ///< [N/m]
    double range = 0.0;  ///< of the stress across the wall at every cycle [Pa]
    Bears bears;
    bool again = false;  ///< in cycles that no detail bears
  };
  struct PressedEdge {
    double use = 0.0;
    Length s;
    std::string name;
  };

  void add_lines_to(PatchChecks& found) const {
    for (const WorstLine* of : {&stopping_line_, &said_line_}) {
      if (of->use == 0.0) continue;
      const std::string what =
          fmt::format("{} at s = {} m", of->bears.round ? "round tube" : "polygon with a hollow",
                      to_text(Station{of->s, Side::both}));
      const std::string why = fmt::format(
          "how a wall of {:.4g} mm is bent across itself by {:.4g} kN/m along the beam, by about "
          "{:.2g} of its strength (m = {} over t^2 f_y/4), is not judged{}",
          1e3 * of->bears.wall.value(), 1e-3 * of->q, of->use,
          of->bears.round ? "0.239 q r" : "q b/8",
          of->range > 0.0
              ? fmt::format(", nor its stress anew by {:.3g} MPa at every cycle", 1e-6 * of->range)
              : "");
      if (of == &said_line_)
        found.not_judged.push_back({Criterion::patch_loading, what, why});
      else
        found.gates.push_back(
            section_gate_at(*project_, {of->s, Side::both}, fmt::format("{}: {}", what, why)));
    }
  }

  /// The strength of plain plates, category 160, over the cycles that a situation has a part in as
  /// a whole; nothing where it has none.
  std::optional<double> best_range_of(const Situation& situation) const {
    if (!project_->fatigue.asked) return std::nullopt;
    const std::size_t index = index_of(*project_, situation);
    double cycles = 0.0;
    for (const Situation& of : project_->situations) {
      const auto& parts = of.between;
      if (&of != &situation && std::find(parts.begin(), parts.end(), index) == parts.end())
        continue;
      double here = of.cycles;
      for (const SpectrumLevel& level : of.spectrum)
        if (level.share < 1.0) here -= level.cycles;
      cycles = std::max(cycles, here);
    }
    if (!(cycles > 0.0)) return std::nullopt;
    const FatigueDemand& demand = project_->fatigue.demand;
    return strength_at(en_1993_1_9_direct(160.0), cycles, demand.loading).value() /
           (demand.gamma_Mf * demand.gamma_Ff * project_->fatigue.required);
  }

  /// Weight and inertia act within the wall, which is on the safe side.
  void look_at(const LineLoad& line, const SituationRun& run) {
    const auto stands = [](const std::array<Polynomial<1>, 2>& of) {
      return of[0].c[0] != 0.0 || of[0].c[1] != 0.0 || of[1].c[0] != 0.0 || of[1].c[1] != 0.0;
    };
    if (!stands(line.outside[0]) && !stands(line.outside[1])) return;
    for (const double part : {0.0, 0.5, 1.0}) {
      const double x = part * line.length.value();
      const Length s = line.start + si<Length>(x);
      const auto bears = bears_near({s, part < 1.0 ? Side::behind : Side::before});
      if (!bears || bears->said || is_led_in(project_->beam, s, bears->depth)) continue;
      std::array<double, 2> q{};
      for (const std::size_t axis : {0U, 1U})
        q[axis] = std::max(line.outside[axis][0](x), line.outside[axis][1](x));
      keep_line(s, *bears, std::hypot(q[0], q[1]), *run.situation);
    }
  }

  void keep_line(Length s, const Bears& bears, double q, const Situation& situation) {
    const double t = bears.wall.value(), m = q * bears.lever.value();
    const StrengthDemand& strength = project_->strength;
    const double use = strength.required * strength.gamma_M0 * situation.load_factor * 4.0 * m /
                       (t * t * bears.yield_strength.value());
    const auto best = best_range_of(situation);
    const double range = best ? 6.0 * m / (t * t) : 0.0;
    const bool felt = range > hardly_changes.value();
    if (!(use > hardly_pressed) && !felt) return;
    const bool again = best && range > *best;
    WorstLine& worst = use > 1.0 || again ? stopping_line_ : said_line_;
    if (use > worst.use) worst = {use, s, q, felt ? range : 0.0, bears, again};
  }

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
    std::optional<Force> by_plate;
    bool stops = force > bears.most && !bears.said && !is_led_in(project_->beam, s, bears.depth);
    if (stops) {
      for (const Diaphragm& of : project_->beam.diaphragms) {
        if (abs(of.s - s) > 1e-6 * std::max(project_->beam.length(), bears.depth)) continue;
        const Force borne = borne_by(of, bears);
        stops = stops && force > borne;
        by_plate = std::max(by_plate.value_or(Force{}), borne);
        look_at_edge(of, bears, force, load);
      }
    }
    Worst& worst = stops ? blocking_ : said_;
    const double use = force / bears.least;
    if (use <= worst.use) return;
    worst = {use, s, force, load.name.empty() ? "a force" : std::string(load.name), bears};
    worst.by_plate = by_plate;
  }

  /// What a diaphragm leads from a wall into both sides of the section: by its plate in shear, with
  /// half of it on either side of its opening, and by its fillets along that, of round tubes as
  /// their shear flow F/(pi r) is at most. Source: EN 1993-1-5:2006, clause 5; EN 1993-1-8:2005,
  /// 4.5.3.2.
  Force borne_by(const Diaphragm& of, const Bears& bears) const {
    const PlateOf plate = weakest_to_weld(plates_around(*project_, of.s, of.thickness));
    const auto strength = yield_strength_of(*plate.material, plate.thickness);
    const auto tensile = tensile_strength_of(*plate.material, plate.thickness);
    if (!strength || !tensile) return {};
    ShearPanel panel;
    panel.depth = bears.depth - 2.0 * bears.wall;
    panel.length = panel.depth;
    panel.thickness = of.thickness;
    panel.yield_strength = *strength;
    const double left = std::max(0.0, 1.0 - (of.opening / panel.depth).value());
    const Force by_plate =
        2.0 * left * shear_resistance_of(panel, project_->strength.gamma_M1).resistance;
    if (!(of.throat > Length{})) return by_plate;
    StiffenerWeld weld;
    weld.throat = of.throat;
    weld.length = bears.round ? Length(0.5 * std::numbers::pi * panel.depth) : panel.depth;
    weld.strength = {*tensile, plate.material->beta_w, project_->strength.gamma_M2};
    return std::min(by_plate, Force(2.0 * stiffener_weld_resistance_of(weld)));
  }

  void look_at_edge(const Diaphragm& of, const Bears& bears, Force force, const PointLoad& load) {
    Length pressed = 2.0 * bears.wall;
    for (const LoadIntroduction& by : project_->beam.introductions)
      if (by.stiff_length && of.s >= by.from && of.s <= by.to) pressed += *by.stiff_length;
    const double use = (force / (pressed * of.thickness * bears.yield_strength)).value();
    if (use > edge_.use) edge_ = {use, of.s, std::string(load.name)};
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
  WorstLine said_line_, stopping_line_;
  PressedEdge edge_;
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
