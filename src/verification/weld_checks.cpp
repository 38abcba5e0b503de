#include "boxbeam/verification/weld_checks.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "boxbeam/core/append.hpp"
#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/station_samples.hpp"
#include "weld_losses.hpp"

namespace boxbeam {
namespace {

/// One face of a weld's station and all that is cut there: a load at the very station is cut off on
/// one side only.
struct WeldFace {
  WeldFace(const Project& project, const std::deque<SituationRun>& runs,
           const std::vector<BendingZone>& zones, const Station& at)
      : station(at),
        histories(histories_at(runs, {at.s, behind_or_before(at.side)})),
        samples(project, histories),
        in_fatigue(lag_loss_at(project, zones, at.s)),
        in_strength(in_fatigue * buckling_loss_at(project, zones, at.s, histories)) {}

  static Side behind_or_before(Side side) { return side == Side::before ? side : Side::behind; }

  Station station;
  std::vector<SituationHistory> histories;
  StationSamples samples;
  WeldLoss in_fatigue, in_strength;
};

/// A place of the weld's line back from the outer face of the throat to its root.
SectionPlace at_root(const WeldInput& weld, const SectionPoint& place) {
  if (const auto* tube = std::get_if<RoundTube>(&weld.around)) {
    const Length radius = hypot(place.y, place.z);
    const double share = (0.5 * tube->diameter - weld.penetration) / radius;
    return {share * place.y, share * place.z};
  }
  const auto within = [&](Length at, Length half) {
    const Length root = half - weld.penetration;
    return std::clamp(at, -root, root);
  };
  const Extent extent = extent_of(weld.around);
  return {within(place.y, extent.y_high), within(place.z, extent.z_high)};
}

/// Both ends of the stretches of a section and the places between that are looked at.
template <class Look>
void look_along(const StressField& field, const Look& look) {
  constexpr int on_side = 16;
  constexpr int on_round = 144;
  for (const WallStretch& stretch : wall_stretches_of(field)) {
    const int steps = stretch.round ? on_round : on_side;
    for (int i = 0; i <= steps; ++i)
      look(stretch, point_on_stretch(field, stretch, static_cast<double>(i) / steps));
  }
}

/// What the points at a weld have in common.
StressPoint point_at(const Project& project, const WeldInput& weld, const Station& station,
                     const Section& section, const WeldLoss& loss) {
  const std::vector<PlateOf> around = plates_around(project, weld.s, weld.thickness);
  StressPoint point;
  point.station = station;
  point.section = section;
  point.gross = properties_of(section);
  point.net = less(point.gross, loss);
  point.beside_idle = !loss.none();
  point.first_to_yield = first_to_yield(around);
  point.joined = weakest_to_weld(around);
  point.yield_strength =
      yield_strength_of(*point.first_to_yield.material, point.first_to_yield.thickness).value();
  return point;
}

/// The places of a weld's line, as points of a beam whose section it is.
std::vector<StressPoint> line_points_of(const Project& project, const WeldInput& weld,
                                        const Station& station, const WeldLoss& loss) {
  const Section section = weld_line_of(weld);
  const StressPoint common = point_at(project, weld, station, section, loss);
  std::vector<StressPoint> points;
  look_along(stress_field_of(section, {}, {}), [&](const WallStretch& stretch, auto place) {
    const SectionPlace root = at_root(weld, place);
    StressPoint& point = points.emplace_back(common);
    point.name = "weld " + weld.name + ", " + stretch.name;
    point.y = root.y;
    point.z = root.z;
    point.influence = place.influence;
    point.influence.normal =
        normal_influence(sums_of(common.net), root.y.value(), root.z.value()).normal;
    point.prismatic = point.influence;
    point.torsion = place.torsion;
    point.plate = weld.thickness;
    point.detail = &weld.root;
    point.shear_detail = &weld.shear;
    point.yield = false;
  });
  return points;
}

/// The places of the profile at a weld's toe, on the outer faces of its walls.
std::vector<StressPoint> toe_points_of(const Project& project, const WeldInput& weld,
                                       const Station& station, const WeldLoss& loss) {
  const Section section{weld.around, {}};
  const StressPoint common = point_at(project, weld, station, section, loss);
  std::vector<StressPoint> points;
  look_along(stress_field_of(section, {}, {}), [&](const WallStretch& stretch, auto place) {
    StressPoint& point = points.emplace_back(common);
    point.name = "toe of weld " + weld.name + ", " + stretch.name;
    point.y = place.y;
    point.z = place.z;
    point.influence = place.influence;
    point.prismatic = place.prismatic;
    if (!loss.none()) {
      point.influence.normal =
          normal_influence(sums_of(common.net), place.y.value(), place.z.value()).normal;
    }
    point.torsion = place.torsion;
    point.plate = stretch.plate;
    point.yield = weld.full;
    if (!project.fatigue.asked) return;
    point.detail = &weld.toe;
    if (auto detail = in_plate(weld.toe.detail, stretch.plate)) {
      auto own = std::make_shared<BeamDetail>(weld.toe);
      own->detail = std::move(*detail);
      point.detail = own.get();
      point.in_plate = std::move(own);
    }
    point.compression_reduced = point.detail->detail.compression_reduced;
    point.range_factor = weld.toe.stress_factor;
    point.shear_detail = &project.fatigue.shear;
  });
  return points;
}

/// sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) of equal legs [Pa].
double equivalent_of(const StressPoint& point, const CutForces& cut) {
  const PointStress stress = stress_at(point.influence, cut);
  return equal_leg_stress(stress.normal.value(), stress.shear.value());
}

std::optional<CheckResult> check_line(const Project& project, const WeldInput& weld,
                                      const std::vector<SituationHistory>& histories,
                                      const StressPoint& point) {
  const WorstInstant worst =
      worst_instant_of(histories, [&](const CutForces& cut) { return equivalent_of(point, cut); });
  const auto tensile = tensile_strength_of(*point.joined.material, point.joined.thickness);
  if (!tensile || worst.use < no_stress_at(point)) return std::nullopt;
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::weld;
  check.station = point.station;
  check.point = point.name;
  check.id = id_of(Criterion::weld, point.station, point.name);
  check.situation = worst.at->situation->name;
  check.time = worst.largest.time;
  check.acting = si<Stress>(worst.use);
  CheckBasis& basis = result.basis.emplace();
  basis.point = point;
  basis.running = index_of(project, *worst.at->situation);
  basis.cut_at_time = basis.cut_at_highest = basis.cut_at_lowest = worst.at->history.at(check.time);
  basis.stress_at_time = stress_at(point.influence, basis.cut_at_time);
  const double normal = basis.stress_at_time.normal.value();
  basis.highest = basis.lowest = {check.time, normal, basis.running};
  // The first condition of equation 4.1, of equal legs the harder one.
  basis.weld = {*tensile, point.joined.material->beta_w, project.strength.gamma_M2};
  check.resisting = weld_strength(plainly, basis.weld);
  check.safety_factor = check.resisting / check.acting;
  check.required = weld.required;
  check.source = "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1";
  return result;
}

/// The profile where a weld that penetrates fully joins it: no weaker than the weaker part.
std::optional<CheckResult> check_full_penetration(const Project& project, const WeldInput& weld,
                                                  const WeldFace& face, const StressPoint& point) {
  std::optional<CheckResult> result = check_yield(project, face.histories, point);
  if (!result) return std::nullopt;
  result->check.required = weld.required;
  result->check.source += "; EN 1993-1-8:2005, 4.7.1";
  return result;
}

enum class Part { line, toe };

const std::vector<Criterion> fatigue_criteria{Criterion::fatigue, Criterion::shear_fatigue,
                                              Criterion::combined_fatigue};

/// The checks of some criteria, each where `points` are used most by it.
std::vector<CheckResult> check_points(const Project& project, const WeldInput& weld,
                                      const WeldFace& face, const std::vector<StressPoint>& points,
                                      Part part, const std::vector<Criterion>& by) {
  CriterionSet asked({});
  bool throat = false;  // all places of a line have the same strength
  for (const Criterion criterion : by) {
    if (part == Part::line && criterion == Criterion::weld)
      throat = true;
    else
      asked.add(criterion);
  }
  std::vector<Utilisations> uses;
  uses.reserve(points.size());
  for (const StressPoint& point : points) {
    Utilisations& use = uses.emplace_back(face.samples.judge(point, asked));
    if (throat)
      use.of(Criterion::weld) =
          face.samples.largest_use([&](const CutForces& cut) { return equivalent_of(point, cut); });
  }
  std::vector<CheckResult> results;
  for (const Criterion criterion : by) {
    const auto most = std::max_element(uses.begin(), uses.end(), [&](const auto& a, const auto& b) {
      return a.of(criterion) < b.of(criterion);
    });
    const StressPoint& worst = points[static_cast<std::size_t>(most - uses.begin())];
    std::optional<CheckResult> result;
    if (criterion == Criterion::weld)
      result = check_line(project, weld, face.histories, worst);
    else if (criterion == Criterion::yield)
      result = check_full_penetration(project, weld, face, worst);
    else if (criterion == Criterion::stress_range)
      result = check_range(project, face.histories, worst);
    else
      result = check_fatigue(project, face.histories, worst, criterion);
    if (result) results.push_back(std::move(*result));
  }
  return results;
}

/// Throat and root.
std::vector<CheckResult> check_line(const Project& project, const WeldInput& weld,
                                    const WeldFace& face) {
  std::vector<CheckResult> results = check_points(
      project, weld, face, line_points_of(project, weld, face.station, face.in_strength),
      Part::line, {Criterion::weld});
  append(check_points(project, weld, face,
                      line_points_of(project, weld, face.station, face.in_fatigue), Part::line,
                      fatigue_criteria),
         results);
  return results;
}

std::vector<CheckResult> check_toe(const Project& project, const WeldInput& weld,
                                   const WeldFace& face) {
  std::vector<CheckResult> results;
  if (weld.full) {
    results = check_points(project, weld, face,
                           toe_points_of(project, weld, face.station, face.in_strength), Part::toe,
                           {Criterion::yield});
  }
  if (!project.fatigue.asked) return results;
  std::vector<Criterion> by = fatigue_criteria;
  by.push_back(Criterion::stress_range);
  append(check_points(project, weld, face,
                      toe_points_of(project, weld, face.station, face.in_fatigue), Part::toe, by),
         results);
  return results;
}

/// The thickest line that leaves the ring a hollow, and with which the search ends.
Length thickest_line_of(const WeldInput& weld) {
  const Extent extent = extent_of(weld.around);
  const Length size = std::min(extent.y_high - extent.y_low, extent.z_high - extent.z_low);
  constexpr double nearly = 0.999;
  return nearly * (size - 2.0 * weld.penetration);
}

/// The least throat with which all checks of throat and root pass. The line's own geometry depends
/// on it, so that it is solved for: the largest utilisation falls nearly as one over the throat.
std::optional<Length> sufficient_throat_of(const Project& project, const WeldInput& weld,
                                           const std::deque<WeldFace>& faces, double utilisation) {
  const auto log_use = [&](double log_line) {
    WeldInput other = weld;
    other.throat = si<Length>(std::exp(log_line)) - weld.penetration;
    double most = 0.0;
    for (const WeldFace& face : faces) {
      for (const CheckResult& result : check_line(project, other, face))
        most = std::max(most, result.check.utilisation());
    }
    constexpr double next_to_nothing = 1e-9;
    return std::log(std::max(most, next_to_nothing));
  };
  const double thickest = std::log(thickest_line_of(weld).value());
  const double thinnest = std::log((least_throat() + weld.penetration).value());
  double low = std::log((weld.throat + weld.penetration).value()), at_low = std::log(utilisation);
  double high = low, at_high = at_low;
  // Towards where one over the throat crosses one, and a little further, until it is bracketed.
  constexpr double further = 0.05;
  while (at_high > 0.0) {
    if (high >= thickest) return std::nullopt;
    low = high;
    at_low = at_high;
    high = std::min(high + at_high + further, thickest);
    at_high = log_use(high);
  }
  while (at_low < 0.0) {
    if (low <= thinnest) return least_throat();
    high = low;
    at_high = at_low;
    low = std::max(low + at_low - further, thinnest);
    at_low = log_use(low);
  }
  if (at_low == 0.0) return si<Length>(std::exp(low)) - weld.penetration;
  std::uintmax_t most = 60;
  constexpr double tolerance = 1e-10;
  const auto [below, above] = boost::math::tools::toms748_solve(
      log_use, low, high, at_low, at_high, [](double a, double b) { return b - a <= tolerance; },
      most);
  return std::max(si<Length>(std::exp(above)) - weld.penetration, least_throat());
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

/// The faces on which a weld is judged: both where the cut forces jump.
std::deque<WeldFace> faces_of(const Project& project, const std::deque<SituationRun>& runs,
                              const std::vector<BendingZone>& zones, const WeldInput& weld) {
  std::deque<WeldFace> faces;
  const bool both =
      jumps(histories_at(runs, {weld.s, Side::before}), histories_at(runs, {weld.s, Side::behind}));
  if (both) faces.emplace_back(project, runs, zones, Station{weld.s, Side::before});
  faces.emplace_back(project, runs, zones, Station{weld.s, both ? Side::behind : Side::both});
  return faces;
}

}  // namespace

Section weld_line_of(const WeldInput& weld) {
  const Length a = weld.throat + weld.penetration;
  const Length beyond = a - 2.0 * weld.penetration;
  if (const auto* tube = std::get_if<RoundTube>(&weld.around)) {
    return {RoundTube{tube->diameter + beyond, a}, {}};
  }
  const Extent extent = extent_of(weld.around);
  return {RectangularTube{extent.y_high - extent.y_low + beyond,
                          extent.z_high - extent.z_low + beyond, a},
          {}};
}

std::vector<CheckResult> check_welds(const Project& project, const std::deque<SituationRun>& runs,
                                     const std::vector<BendingZone>& zones) {
  std::vector<CheckResult> results;
  for (const WeldInput& weld : project.welds) {
    const std::deque<WeldFace> faces = faces_of(project, runs, zones, weld);
    std::vector<CheckResult> of_line;
    double most = 0.0;
    for (const WeldFace& face : faces) {
      for (CheckResult& result : check_toe(project, weld, face))
        results.push_back(std::move(result));
      if (weld.full) continue;
      for (CheckResult& result : check_line(project, weld, face)) {
        most = std::max(most, result.check.utilisation());
        of_line.push_back(std::move(result));
      }
    }
    if (of_line.empty()) continue;
    const auto throat = sufficient_throat_of(project, weld, faces, most);
    for (CheckResult& result : of_line) {
      result.sufficient_throat = throat;
      results.push_back(std::move(result));
    }
  }
  return results;
}

}  // namespace boxbeam
