#include "boxbeam/verification/weld_checks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/drawn_samples.hpp"

namespace boxbeam {
namespace {

/// A place of the weld's line back from the outer face of the throat to its root, the profile's
/// outline.
SectionPlace at_root(const WeldInput& weld, const SectionPoint& place) {
  const auto within = [](Length at, Length half) { return std::clamp(at, -half, half); };
  if (const auto* tube = std::get_if<RoundTube>(&weld.around)) {
    const Length radius = hypot(place.y, place.z);
    const double share = 0.5 * tube->diameter / radius;
    return {share * place.y, share * place.z};
  }
  const Extent extent = extent_of(weld.around);
  return {within(place.y, extent.y_high), within(place.z, extent.z_high)};
}

/// The places of a weld that are looked at, as points of a beam whose section is its line.
std::vector<StressPoint> points_of(const Project& project, const WeldInput& weld,
                                   const Station& station) {
  constexpr int on_side = 16;
  constexpr int on_round = 144;
  const Section section = weld_line_of(weld);
  const StressField field = stress_field_of(section, {}, {});
  const SectionProperties properties = properties_of(section);
  const std::vector<PlateOf> around = plates_around(project, weld.s, weld.thickness);
  const PlateOf yielding = first_to_yield(around), joined = weakest_to_weld(around);
  const Stress yield = yield_strength_of(*yielding.material, yielding.thickness).value();
  std::vector<StressPoint> points;
  for (const WallStretch& stretch : wall_stretches_of(field)) {
    const int steps = stretch.round ? on_round : on_side;
    for (int i = 0; i <= steps; ++i) {
      const SectionPoint place = point_on_stretch(field, stretch, static_cast<double>(i) / steps);
      const SectionPlace root = at_root(weld, place);
      StressPoint& point = points.emplace_back();
      point.station = station;
      point.name = "weld " + weld.name + ", " + stretch.name;
      point.y = root.y;
      point.z = root.z;
      point.section = section;
      point.gross = point.net = properties;
      point.influence = place.influence;
      point.influence.normal =
          normal_influence(sums_of(properties), root.y.value(), root.z.value()).normal;
      point.prismatic = point.influence;
      point.torsion = place.torsion;
      point.plate = weld.thickness;
      point.first_to_yield = yielding;
      point.yield_strength = yield;
      point.joined = joined;
      point.detail = &weld.root;
      point.shear_detail = &weld.shear;
      point.yield = false;
    }
  }
  return points;
}

/// sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) of equal legs [Pa].
double equivalent_of(const StressPoint& point, const CutForces& cut) {
  const PointStress stress = stress_at(point.influence, cut);
  return equal_leg_stress(stress.normal.value(), stress.shear.value());
}

/// How much a place is used by a criterion, by the instants alone: what finds the place.
double use_of(const StressPoint& point, const std::vector<SituationHistory>& histories,
              Criterion criterion) {
  double use = 0.0;
  for (const SituationHistory& at : histories) {
    double low_normal = 0.0, high_normal = 0.0, low_shear = 0.0, high_shear = 0.0, equivalent = 0.0;
    bool first = true;
    for (const CutForces& cut : at.history.samples()) {
      const PointStress stress = stress_at(point.influence, cut);
      const double normal = stress.normal.value(), shear = stress.shear.value();
      low_normal = first ? normal : std::min(low_normal, normal);
      high_normal = first ? normal : std::max(high_normal, normal);
      low_shear = first ? shear : std::min(low_shear, shear);
      high_shear = first ? shear : std::max(high_shear, shear);
      equivalent = std::max(equivalent, equivalent_of(point, cut));
      first = false;
    }
    const double normal = (high_normal - low_normal) / point.detail->detail.curve.reference.value();
    const double shear = (high_shear - low_shear) / point.shear_detail->curve.reference.value();
    const double of = criterion == Criterion::weld      ? equivalent * at.situation->load_factor
                      : criterion == Criterion::fatigue ? normal
                      : criterion == Criterion::shear_fatigue
                          ? shear
                          : std::pow(normal, 3) + std::pow(shear, 5);
    use = std::max(use, of);
  }
  return use;
}

std::optional<CheckResult> check_static(const Project& project, const WeldInput& weld,
                                        const std::vector<SituationHistory>& histories,
                                        const StressPoint& point) {
  const SituationHistory* worst = nullptr;
  TurningPoint largest;
  for (const SituationHistory& at : histories) {
    TurningPoint in =
        at.history.largest([&](const CutForces& cut) { return equivalent_of(point, cut); });
    in.value *= at.situation->load_factor;
    if (worst != nullptr && in.value <= largest.value) continue;
    worst = &at;
    largest = in;
  }
  const auto tensile = tensile_strength_of(*point.joined.material, point.joined.thickness);
  if (!tensile || worst == nullptr || largest.value < no_stress_at(point)) return std::nullopt;
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::weld;
  check.station = point.station;
  check.point = point.name;
  check.id = id_of(Criterion::weld, point.station, point.name);
  check.situation = worst->situation->name;
  check.time = largest.time;
  check.acting = si<Stress>(largest.value);
  CheckBasis& basis = result.basis.emplace();
  basis.point = point;
  basis.running = index_of(project, *worst->situation);
  basis.cut_at_time = basis.cut_at_highest = basis.cut_at_lowest = worst->history.at(largest.time);
  basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
  const double normal = basis.stress_at_time.normal.value();
  basis.highest = basis.lowest = {largest.time, normal, basis.running};
  const std::vector<CutForces>& samples = worst->history.samples();
  const auto stress_of = [&](std::size_t i) {
    return stress_at(point.influence, samples[i]).normal.value();
  };
  for (const std::size_t i : drawn_samples(samples.size(), {stress_of})) {
    basis.times.push_back(worst->history.time_of(i).value());
    basis.history.push_back(stress_of(i));
  }
  // The first condition of equation 4.1, of equal legs the harder one.
  constexpr NoDerivation plainly;
  basis.weld = {*tensile, point.joined.material->beta_w, project.strength.gamma_M2};
  check.resisting = weld_strength(plainly, basis.weld);
  check.safety_factor = check.resisting / check.acting;
  check.required = weld.required;
  check.source = "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1";
  return result;
}

bool jumps(const std::vector<SituationHistory>& before,
           const std::vector<SituationHistory>& behind) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::vector<CutForces>& a = before[i].history.samples();
    const std::vector<CutForces>& b = behind[i].history.samples();
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (!(a[k].N == b[k].N && a[k].V_y == b[k].V_y && a[k].V_z == b[k].V_z && a[k].T == b[k].T &&
            a[k].M_y == b[k].M_y && a[k].M_z == b[k].M_z)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Section weld_line_of(const WeldInput& weld) {
  const Length a = weld.throat;
  if (const auto* tube = std::get_if<RoundTube>(&weld.around)) {
    return {RoundTube{tube->diameter + a, a}, {}};
  }
  const Extent extent = extent_of(weld.around);
  return {RectangularTube{extent.y_high - extent.y_low + a, extent.z_high - extent.z_low + a, a},
          {}};
}

std::vector<CheckResult> check_welds(const Project& project, const std::deque<SituationRun>& runs) {
  std::vector<CheckResult> results;
  for (const WeldInput& weld : project.welds) {
    // A load at the very station is cut off on one side only.
    const std::vector<SituationHistory> before = histories_at(runs, {weld.s, Side::before});
    const std::vector<SituationHistory> behind = histories_at(runs, {weld.s, Side::behind});
    std::vector<Side> sides{Side::both};
    if (jumps(before, behind)) sides = {Side::before, Side::behind};
    for (const Side side : sides) {
      const std::vector<SituationHistory>& histories = side == Side::before ? before : behind;
      const std::vector<StressPoint> points = points_of(project, weld, {weld.s, side});
      for (const Criterion criterion : {Criterion::weld, Criterion::fatigue,
                                        Criterion::shear_fatigue, Criterion::combined_fatigue}) {
        const auto worst = std::max_element(
            points.begin(), points.end(), [&](const StressPoint& a, const StressPoint& b) {
              return use_of(a, histories, criterion) < use_of(b, histories, criterion);
            });
        auto result = criterion == Criterion::weld
                          ? check_static(project, weld, histories, *worst)
                          : check_fatigue(project, histories, *worst, criterion);
        if (result) results.push_back(std::move(*result));
      }
    }
  }
  return results;
}

}  // namespace boxbeam
