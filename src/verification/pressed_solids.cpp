#include "pressed_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "force_kinds.hpp"
#include "pressing_forces.hpp"

namespace boxbeam {
namespace {

/// Up to this part of its strength nothing is said of a strip, and up to this part of the depth of
/// a plate nothing of how long a bearing is.
constexpr double hardly_bent_strip = 0.1, short_bearing = 0.1;

/// A solid plate, as a web of forces along an axis. SI.
struct SolidWeb {
  double depth = 0.0, thickness = 0.0, yield_strength = 0.0;
};

std::optional<SolidWeb> solid_web_at(const Project& project, Length s, bool along_z) {
  const Section section = section_at(project.beam, {s, Side::both});
  const auto* const plate = std::get_if<Plate>(&section.outer);
  if (plate == nullptr || section.inner) return std::nullopt;
  const PlateMaterials materials = materials_of(project, segment_at(project.beam, {s, Side::both}));
  const PlateOf of = first_to_yield(plates_at(materials, section, Length{}, Length{}));
  const auto strength = yield_strength_of(*of.material, of.thickness);
  if (!strength) return std::nullopt;
  const double width = plate->width.value(), height = plate->height.value();
  return SolidWeb{along_z ? height : width, along_z ? width : height, strength->value()};
}

/// Finds the worst of all.
class PressedSolids {
 public:
  PressedSolids(const Project& project, const std::deque<SituationRun>& runs)
      : project_(&project), kinds_(project) {
    for (const SituationRun& run : runs) kinds_.learn(run);
  }

  void look_at(const SituationRun& run) {
    again_ = project_->fatigue.asked && has_cycles(*project_, *run.situation);
    scale_ = project_->strength.required * project_->strength.gamma_M0 * run.situation->load_factor;
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const BeamLoads loads = run.loads.loads_at(run.loads.time_of(i));
      std::optional<CutForceDiagram> diagram;
      if (!project_->holes.empty()) diagram = run.loads.diagram(i);
      for (const bool along_z : {true, false}) {
        if (!along_z && !project_->in_space) continue;
        for (const PointLoad& of : loads.points) look_at_bearing(loads, of, along_z);
        for (const BeamHole& at : project_->holes) look_at_hole(loads, *diagram, at, along_z);
      }
    }
  }

  void add_to(PatchChecks& found) const {
    add_strips(found);
    const auto why = [](const Bearing& of) {
      return fmt::format("\"{}\" needs a bearing {:.3g} mm long, F/(t f_y)", of.name,
                         1e3 * of.length);
    };
    const auto what = [](const Bearing& of) {
      return fmt::format("plate at s = {} m", to_text(Station{of.s, Side::both}));
    };
    if (too_short_.use > 0.0)
      found.gates.push_back({segment_name(too_short_.s), "",
                             fmt::format("{}: {}, and [[beam.load_introductions]] say less",
                                         what(too_short_), why(too_short_)),
                             true});
    if (unsaid_.use > 0.0)
      found.not_judged.push_back(
          {Criterion::patch_loading, what(unsaid_),
           why(unsaid_) + ": stiff_length in [[beam.load_introductions]] says how long it is"});
  }

 private:
  struct Bearing {
    double use = 0.0, length = 0.0;
    Length s;
    std::string name;
  };
  struct Strip {
    double use = 0.0, with_own = 0.0;
    bool stops = false, again = false;
    std::string name;
  };

  static double along(const Eigen::Vector3d& of, bool along_z) { return along_z ? of.z() : of.y(); }

  const std::string& segment_name(Length s) const {
    return project_->beam.segments[segment_at(project_->beam, {s, Side::both})].name;
  }

  std::optional<double> stiff_length_at(Length s) const {
    const Length near = 1e-6 * project_->beam.length();
    std::optional<double> least;
    for (const LoadIntroduction& of : project_->beam.introductions) {
      if (!of.stiff_length || s < of.from - near || s > of.to + near) continue;
      least = std::min(least.value_or(std::numeric_limits<double>::infinity()),
                       of.stiff_length->value());
    }
    return least;
  }

  /// Whether a force stands in a hole through the plate, by a pin.
  bool is_pin(const PointLoad& load, bool along_z) const {
    return std::any_of(project_->holes.begin(), project_->holes.end(), [&](const BeamHole& at) {
      if ((at.hole.walls == HoleWalls::webs) != along_z) return false;
      const double here = along_z ? load.at.y() : load.at.x();
      const double beside = along_z ? here - at.hole.position.value()
                                    : std::abs(here) - std::abs(at.hole.position.value());
      constexpr double slack = 1.0 + 1e-6;
      return std::hypot((at.s - load.s).value(), beside) <= 0.5 * slack * at.hole.diameter.value();
    });
  }

  bool comes_by_edge(const PointLoad& load, bool along_z) const {
    if (along(load.force, along_z) == 0.0) return false;
    if (stands_at_end(project_->beam, load.s) && kinds_.clamps(load.name)) return false;
    return !is_pin(load, along_z) && !is_led_in(project_->beam, load.s);
  }

  void look_at_bearing(const BeamLoads& loads, const PointLoad& load, bool along_z) {
    if (!comes_by_edge(load, along_z)) return;
    const Length s = std::clamp(load.s, Length{}, project_->beam.length());
    const auto web = solid_web_at(*project_, s, along_z);
    if (!web) return;
    // All that stands there with its sense.
    const double sense = along(load.force, along_z) > 0.0 ? 1.0 : -1.0;
    double force = 0.0;
    for (const PointLoad& of : loads.points)
      if (of.s == load.s && comes_by_edge(of, along_z))
        force += std::max(0.0, sense * along(of.force, along_z));
    const double needed = scale_ * force / (web->thickness * web->yield_strength);
    const auto given = stiff_length_at(s);
    if (!(needed > given.value_or(short_bearing * web->depth))) return;
    Bearing& worst = given ? too_short_ : unsaid_;
    const double use = needed / web->depth;
    if (use > worst.use)
      worst = {use, needed, s, load.name.empty() ? "a force" : std::string(load.name)};
  }

  void look_at_hole(const BeamLoads& loads, const CutForceDiagram& diagram, const BeamHole& at,
                    bool along_z) {
    if ((at.hole.walls == HoleWalls::webs) != along_z) return;
    const auto web = solid_web_at(*project_, at.s, along_z);
    if (!web) return;
    const double d = at.hole.diameter.value(), p = at.hole.position.value();
    for (const bool high : {true, false}) {
      const double beside = along_z ? (high ? p : -p) : std::abs(p);
      const double e = std::max(1e-6, 0.5 * web->depth - beside - 0.5 * d);
      for (const double sense : {1.0, -1.0}) {
        const auto [force, name] = pressing(loads, at, along_z, high, sense, 0.5 * d + e);
        if (force == 0.0) continue;
        const PressedStrip strip{d, e, web->thickness, web->yield_strength};
        const double use = use_of(strip, scale_ * force, 0.0);
        if (!(use > hardly_bent_strip)) continue;
        const double n = scale_ * stress_at_edge(diagram, at, along_z, high) / web->yield_strength;
        keep(at, {use, use_of(strip, scale_ * force, n), false, again_, name});
      }
    }
  }

  /// What of the loads with a sense presses the strip between one edge and a hole.
  std::pair<double, std::string> pressing(const BeamLoads& loads, const BeamHole& at, bool along_z,
                                          bool high, double sense, double reach) const {
    double force = 0.0;
    std::string name;
    for (const PointLoad& load : loads.points) {
      const double size = sense * along(load.force, along_z);
      const double place = along_z ? load.at.y() : load.at.x();
      const double near = reach + 0.5 * stiff_length_at(load.s).value_or(0.0);
      if (!(size > 0.0) || std::abs((load.s - at.s).value()) >= near ||
          (high ? place < 0.0 : place > 0.0) || !comes_by_edge(load, along_z))
        continue;
      force += size;
      name = load.name.empty() ? "a force" : std::string(load.name);
    }
    for (const LineLoad& line : loads.lines) {
      const double x = (at.s - line.start).value();
      if (x < 0.0 || x > line.length.value() || is_led_in(project_->beam, at.s)) continue;
      const double size = line.outside[along_z ? 1 : 0][sense > 0.0 ? 0 : 1](x);
      if (!(size > 0.0)) continue;
      force += size * at.hole.diameter.value();
      if (name.empty()) name = "a load along the beam";
    }
    return {force, name};
  }

  /// Of the net section at an edge, the larger one of both sides [Pa].
  double stress_at_edge(const CutForceDiagram& diagram, const BeamHole& at, bool along_z,
                        bool high) const {
    const Section section = section_at(project_->beam, {at.s, Side::both});
    const AreaSums net = sums_of(outline_of(section, holes_at(*project_, at.s)));
    const Extent of = extent_of(section.outer);
    const double edge =
        (along_z ? (high ? of.z_high : of.z_low) : (high ? of.y_high : of.y_low)).value();
    double most = 0.0;
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? at.s == Length{} : at.s == project_->beam.length()) continue;
      const CutForces cut = diagram.at({at.s, side});
      for (const double other : {-1.0, 1.0}) {
        const double beside = other * (along_z ? of.y_high : of.z_high).value();
        const auto influence =
            along_z ? normal_influence(net, beside, edge) : normal_influence(net, edge, beside);
        most = std::max(most, std::abs(boxbeam::stress_at(influence, cut).normal.value()));
      }
    }
    return most;
  }

  void keep(const BeamHole& at, Strip of) {
    of.stops = of.with_own > 1.0 || of.again;
    Strip& worst = strips_[&at];
    if (std::pair(of.stops, of.with_own) > std::pair(worst.stops, worst.with_own))
      worst = std::move(of);
  }

  void add_strips(PatchChecks& found) const {
    for (const BeamHole& at : project_->holes) {
      const auto known = strips_.find(&at);
      if (known == strips_.end()) continue;
      const Strip& of = known->second;
      const std::string what =
          fmt::format("hole \"{}\" at s = {} m", at.hole.name, to_text(Station{at.s, Side::both}));
      const std::string why = fmt::format(
          "\"{}\" presses the strip of the plate beside it by {:.3g} of its strength, "
          "with the beam's own stress by {:.3g}, which is not judged{}",
          of.name, of.use, of.with_own, of.again ? " in fatigue" : "");
      if (of.stops)
        found.gates.push_back({segment_name(at.s), "",
                               fmt::format("{}: {}; [[beam.load_introductions]], into = \"webs\", "
                                           "say that it does not come by an edge",
                                           what, why),
                               true});
      else
        found.not_judged.push_back({Criterion::patch_loading, what, why});
    }
  }

  const Project* project_;
  ForceKinds kinds_;
  double scale_ = 1.0;
  bool again_ = false;
  std::map<const BeamHole*, Strip> strips_;
  Bearing too_short_, unsaid_;
};

}  // namespace

double use_of(const PressedStrip& strip, double force, double n) {
  const double plastic = strip.depth * strip.thickness * strip.yield_strength;
  const double m = force * strip.diameter / (2.0 * strip.depth * plastic);
  const double v = 0.5 * std::sqrt(3.0) * force / plastic;
  return 0.5 * (m + std::sqrt(m * m + 4.0 * (v * v + n * n)));
}

void check_pressed_solids(const Project& project, const std::deque<SituationRun>& runs,
                          PatchChecks& found) {
  const auto& segments = project.beam.segments;
  const bool any = std::any_of(segments.begin(), segments.end(), [](const Segment& of) {
    return std::holds_alternative<Plate>(of.from.outer) && !of.from.inner;
  });
  if (!any) return;
  PressedSolids solids(project, runs);
  for (const SituationRun& run : runs) solids.look_at(run);
  solids.add_to(found);
}

}  // namespace boxbeam
