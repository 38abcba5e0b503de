#include "tube_borders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "bent_flanges.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "pressing_forces.hpp"

namespace boxbeam {
namespace {

constexpr double nu = 0.3;

/// A side of a border.
struct TubeEnd {
  const RoundTube* tube = nullptr;
  const Section* section = nullptr;
  std::size_t segment = 0;
  Station station;
  Stress yield_strength;
  double slope = 0.0;  ///< of the wall's middle, along the beam

  Length radius() const { return 0.5 * (tube->diameter - tube->wall); }
};

/// Nothing of other sections.
std::optional<TubeEnd> tube_end_of(const Project& project, std::size_t segment, bool end) {
  const Segment& of = project.beam.segments[segment];
  TubeEnd at;
  at.section = end ? &of.to : &of.from;
  at.tube = std::get_if<RoundTube>(&at.section->outer);
  if (at.tube == nullptr) return std::nullopt;
  at.segment = segment;
  at.station = {end ? of.end() : of.start, end ? Side::before : Side::behind};
  const auto& from = std::get<RoundTube>(of.from.outer);
  const auto& to = std::get<RoundTube>(of.to.outer);
  at.slope = 0.5 * ((to.diameter - to.wall) - (from.diameter - from.wall)) / of.length;
  const PlateOf plate =
      first_to_yield(plates_at(materials_of(project, segment), *at.section, Length{}, at.radius()));
  const auto strength = yield_strength_of(*plate.material, at.tube->wall);
  if (!strength) return std::nullopt;
  at.yield_strength = *strength;
  return at;
}

/// As plates of unlike thickness do (`flange_steps_of`).
bool goes_on(const RoundTube& of, const RoundTube& in) {
  const Length by = 0.5 * abs((of.diameter - of.wall) - (in.diameter - in.wall));
  return by <= 0.5 * abs(of.wall - in.wall) + 0.1001 * std::min(of.wall, in.wall);
}

/// Whether a place lies within a loop.
bool is_within(const std::vector<SectionPlace>& loop, double y, double z) {
  bool within = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const SectionPlace &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double ya = a.y.value(), za = a.z.value(), yb = b.y.value(), zb = b.z.value();
    if ((za > z) != (zb > z) && y < ya + (z - za) / (zb - za) * (yb - ya)) within = !within;
  }
  return within;
}

/// Whether a solid has material at a place; of other profiles nobody asks.
struct IsSolidAt {
  double y, z;
  bool operator()(const Plate& of) const {
    return std::abs(y) <= 0.5 * of.width.value() && std::abs(z) <= 0.5 * of.height.value();
  }
  bool operator()(const Polygon& of) const {
    return is_within(of.outer, y, z) &&
           std::none_of(of.hollows.begin(), of.hollows.end(),
                        [&](const auto& hollow) { return is_within(hollow, y, z); });
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

/// Whether the wall of a tube goes on in a solid, but for a tenth of it.
bool goes_on_in(const TubeEnd& of, const Profile& solid) {
  constexpr int places = 72;
  int within = 0;
  for (int i = 0; i < places; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / places, r = of.radius().value();
    within += std::visit(IsSolidAt{r * std::cos(angle), r * std::sin(angle)}, solid) ? 1 : 0;
  }
  return within >= 0.9 * places;
}

void add_steps(const TubeEnd& of, std::optional<Length> by, std::vector<FlangeStep>& steps) {
  const AreaSums gross = sums_of(outline_of(*of.section, {}));
  const double r = of.radius().value(), pi = std::numbers::pi;
  const Area area = 0.5 * pi * of.radius() * of.tube->wall;
  constexpr int eighths = 8;
  for (int i = 0; i < eighths; ++i) {
    const double angle = 2.0 * pi * i / eighths, y = std::cos(angle), z = std::sin(angle);
    // The centre of a quarter of a circle, and what it bears of V and T along itself.
    const double centre = 2.0 * std::numbers::sqrt2 / pi * r;
    const double of_shear = (0.25 * pi + 0.5) / pi;
    const StressInfluence at = normal_influence(gross, centre * y, centre * z);
    FlangeStep& step = steps.emplace_back();
    step.s = of.station.s;
    step.name = "wall of the round tube";
    step.area = area;
    step.yield_strength = of.yield_strength;
    for (std::size_t k = 0; k < cut_force::count; ++k)
      for (PlateForce& along : step.along) along[k] = area.value() * at.normal[k];
    step.across[cut_force::V_z] = of_shear * y;
    step.across[cut_force::V_y] = -of_shear * z;
    step.across[cut_force::T] = 0.25 / r;
    step.by = by;
  }
}

/// What of a ring load on a tube's wall stays with the wall beside a diaphragm, as stiff as each
/// is.
double left_beside(const Project& project, const TubeEnd& of, Stress pressed, double turn) {
  const double r = of.radius().value(), t = of.tube->wall.value();
  const double load = std::abs(pressed.value() * t * turn), beta = 1.285 / std::sqrt(r * t);
  const double shell = r * r * beta / (2.0 * t);
  double left = 1.0;
  for (const Diaphragm& at : project.beam.diaphragms) {
    if (abs(at.s - of.station.s) > 1e-6 * project.beam.length()) continue;
    const double a = 0.5 * at.opening.value(), plate = at.thickness.value();
    if (!(a < r)) continue;
    const double whole = r * r / (r * r - a * a);
    const double most = (a > 0.0 ? 2.0 * whole : 1.0) * load / plate;
    // Buckling of a disc on a simple support.
    constexpr double E = 210e9;
    const double critical = 0.385 * E * (plate / r) * (plate / r);
    const double throats =
        2.0 * (at.throat > Length{} ? at.throat.value() : 0.5 * plate) / std::numbers::sqrt3;
    const double f_y = of.yield_strength.value();
    if (most > std::min(f_y, critical) || load > throats * f_y) continue;
    const double ring = r * (whole * (1.0 + a * a / (r * r)) - nu) / plate;
    left = std::min(left, ring / (ring + shell));
  }
  return left;
}

/// What bends a wall at a kink.
struct Bent {
  Length s;
  double factor = 0.0;      ///< of the stress along the beam, how much comes to it
  double over_yield = 0.0;  ///< that stress alone
  double with_own = 0.0;    ///< over the yield strength, together
  double range = 0.0;       ///< at every cycle [Pa]
  double in_fatigue = 0.0;  ///< use with it
};

/// The largest stress along the wall's middle and what shears it by torque [Pa].
struct WallStress {
  double along = 0.0, tau = 0.0;
};

WallStress stress_in(const TubeEnd& of, const AreaSums& gross, const CutForces& cut) {
  const double r = of.radius().value(), t = of.tube->wall.value();
  WallStress most;
  const double across = std::hypot(cut.M_y.value(), cut.M_z.value());
  // Where it bends most in its plane of bending: sigma = N/A + M_y z/I - M_z y/I.
  for (const double sense : {1.0, -1.0}) {
    const double y = across > 0.0 ? -sense * r * cut.M_z.value() / across : 0.0;
    const double z = across > 0.0 ? sense * r * cut.M_y.value() / across : 0.0;
    const double along = stress_at(normal_influence(gross, y, z), cut).normal.value();
    if (std::abs(along) > std::abs(most.along)) most.along = along;
  }
  most.tau = cut.T.value() / (2.0 * std::numbers::pi * r * r * t);
  return most;
}

/// The use in fatigue of the tube's details there under its stress with what bends its wall.
double use_in_fatigue(const Project& project, const std::vector<SituationHistory>& histories,
                      const std::vector<BendingZone>& zones, const TubeEnd& of, double factor) {
  double use = 0.0;
  for (StressPoint& point : stress_points_at(project, zones, of.station)) {
    if (point.part != SectionPart::fibre || point.detail == nullptr) continue;
    // A stress factor of the case that is as large holds it.
    const double raised = std::max(1.0, (1.0 + factor) / point.detail->stress_factor);
    for (double& per : point.influence.normal) per *= raised;
    for (const Criterion by : {Criterion::fatigue, Criterion::combined_fatigue}) {
      if (const auto found = check_fatigue(project, histories, point, by))
        use = std::max(use, found->check.utilisation());
    }
  }
  return use;
}

Bent bent_at(const Project& project, const std::deque<SituationRun>& runs,
             const std::vector<BendingZone>& zones, const TubeEnd& of, const TubeKink& kink,
             double turn) {
  const AreaSums gross = sums_of(outline_of(*of.section, {}));
  const std::vector<SituationHistory> histories = histories_at(runs, of.station);
  const StrengthDemand& strength = project.strength;
  double largest = 0.0, cycled = 0.0;
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      const double here = at.situation->load_factor * std::abs(stress_in(of, gross, cut).along);
      largest = std::max(largest, here);
      if (has_cycles(project, *at.situation)) cycled = std::max(cycled, here);
    }
  }
  const double left = left_beside(project, of, si<Stress>(strength.required * largest), turn);
  Bent bent;
  bent.s = of.station.s;
  bent.factor = left * kink.bends;
  // To and fro at the most.
  bent.range = 2.0 * bent.factor * cycled;
  for (const SituationHistory& at : histories) {
    const double scale = strength.required * strength.gamma_M0 * at.situation->load_factor /
                         of.yield_strength.value();
    for (const CutForces& cut : at.history.samples()) {
      const auto [own, tau] = stress_in(of, gross, cut);
      // Outwards it is pulled around, inwards pressed.
      const double along = own + bent.factor * own,
                   around = left * kink.hoops * own * (turn > 0.0 ? 1.0 : -1.0);
      const double both =
          std::sqrt(along * along + around * around - along * around + 3.0 * tau * tau);
      bent.over_yield = std::max(bent.over_yield, scale * std::abs(bent.factor * own));
      bent.with_own = std::max(bent.with_own, scale * both);
    }
  }
  if (project.fatigue.asked && bent.range > hardly_changes.value())
    bent.in_fatigue = use_in_fatigue(project, histories, zones, of, bent.factor);
  return bent;
}

}  // namespace

TubeKink tube_kink_of(Length diameter, Length wall, Length beyond, double turn) {
  const double D = diameter.value(), t = wall.value();
  return {0.6 * std::sqrt(D * (t + beyond.value())) * std::abs(turn) / t,
          0.45 * std::sqrt(D / t) * std::abs(turn)};
}

std::vector<FlangeStep> tube_steps_of(const Project& project) {
  std::vector<FlangeStep> steps;
  for (std::size_t k = 0; k + 1 < project.beam.segments.size(); ++k) {
    const std::array ends{tube_end_of(project, k, true), tube_end_of(project, k + 1, false)};
    for (const std::size_t side : {0U, 1U}) {
      if (!ends[side]) continue;
      const Segment& other = project.beam.segments[side == 0 ? k + 1 : k];
      const Profile& beyond = (side == 0 ? other.from : other.to).outer;
      const auto* const next = std::get_if<RoundTube>(&beyond);
      if (next != nullptr ? goes_on(*ends[side]->tube, *next) : goes_on_in(*ends[side], beyond))
        continue;
      std::optional<Length> by;
      if (next != nullptr) by = abs(ends[side]->radius() - 0.5 * (next->diameter - next->wall));
      add_steps(*ends[side], by, steps);
    }
  }
  return steps;
}

void check_tube_kinks(const Project& project, const std::deque<SituationRun>& runs,
                      const std::vector<BendingZone>& zones, PatchChecks& found) {
  std::optional<Bent> said;
  for (std::size_t k = 0; k + 1 < project.beam.segments.size(); ++k) {
    const auto before = tube_end_of(project, k, true), behind = tube_end_of(project, k + 1, false);
    if (!before || !behind || !goes_on(*before->tube, *behind->tube)) continue;
    const double turn = behind->slope - before->slope;
    constexpr double straight = 1e-6;
    if (std::abs(turn) < straight) continue;
    const Length D = std::max(before->tube->diameter, behind->tube->diameter);
    Bent worst;
    for (const TubeEnd* of : {&*before, &*behind}) {
      const Length beyond = (of == &*before ? behind : before)->tube->wall;
      const Bent here =
          bent_at(project, runs, zones, *of, tube_kink_of(D, of->tube->wall, beyond, turn), turn);
      const auto rank = [](const Bent& at) { return std::max(at.with_own, at.in_fatigue); };
      if (rank(here) > rank(worst)) worst = here;
    }
    if (worst.with_own > 1.0 || worst.in_fatigue > 1.0) {
      found.gates.push_back(
          {project.beam.segments[k].name, "",
           fmt::format(
               "wall of the round tube at s = {} m: where it turns off it is bent by {:.3g} "
               "of its stress along the beam (NORSOK N-004, 6.5.3.1), with which it is "
               "used by {:.3g}{}: a slope that changes less, a thicker wall, or "
               "[[beam.diaphragms]] take it",
               to_text(Station{worst.s, Side::both}), worst.factor,
               std::max(worst.with_own, worst.in_fatigue),
               worst.in_fatigue > worst.with_own ? " in fatigue" : ""),
           true});
    } else if ((worst.over_yield > hardly_bent || worst.in_fatigue > 0.0) &&
               (!said || worst.over_yield > said->over_yield)) {
      said = worst;
    }
  }
  if (said)
    found.not_judged.push_back(
        {Criterion::patch_loading, "walls of round tubes that turn off",
         fmt::format(
             "bent along the beam by {:.2g} of f_y at s = {} m, which their checks do "
             "not count{}",
             said->over_yield, to_text(Station{said->s, Side::both}),
             said->in_fatigue > 0.0
                 ? fmt::format(", nor in fatigue, where with it {:.2g} is used", said->in_fatigue)
                 : "")});
}

}  // namespace boxbeam
