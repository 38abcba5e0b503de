#include "distortion_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "check_sources.hpp"
#include "counts_in_fatigue.hpp"
#include "holding_diaphragm.hpp"

namespace boxbeam {
namespace {

/// Stresses of distortion below this part of the yield strength are none, as far as places are
/// searched for.
constexpr double no_effect = 1e-4;

/// What is not known may be any.
double or_unbounded(double size) {
  if (std::isnan(size)) return std::numeric_limits<double>::infinity();
  return size;
}

}  // namespace

DistortionSearch::DistortionSearch(const Project& project, const std::deque<SituationRun>& runs,
                                   const std::vector<BendingZone>& zones,
                                   const DistortedStretch& stretch, const BoxStretch& segments)
    : project_(&project),
      runs_(&runs),
      zones_(&zones),
      stretch_(&stretch),
      ranges_(project, runs, stretch) {
  found_.from = stretch.from();
  found_.to = stretch.to();
  found_.places = stretch.introduced();
  for (std::size_t i = segments.first; i <= segments.last; ++i)
    found_.segments += (i > segments.first ? ", " : "") + project.beam.segments[i].name;
  found_.spacing = si<Length>(0.5 / stretch.stiffness(0).decay);
  std::vector<LookedOver> all;
  for (std::size_t k = 0; k < stretch.places().size(); ++k) all.push_back(look_over(k));
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> most;
  for (const LookedOver& of : all) most.push_back(of.largest());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return most[a] > most[b]; });
  for (const std::size_t k : order) look_at(k, all[k]);
  refine();
  for (const Diaphragm& of : project.beam.diaphragms)
    if (of.s >= stretch.from() && of.s <= stretch.to()) look_at(of);
  found_.ranges_judged = ranges_.judged();
  found_.along_range = si<Stress>(ranges_.largest()[0]);
  found_.across_range = si<Stress>(ranges_.largest()[1]);
}

std::vector<CheckResult> DistortionSearch::checks() {
  std::vector<CheckResult> all;
  if (worst_.used > 0.0) all.push_back(strength_check());
  for (CheckResult& of : ranges_.checks()) all.push_back(std::move(of));
  return all;
}

double DistortionSearch::LookedOver::largest() const {
  return most.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
}

std::vector<std::vector<CutForces>> DistortionSearch::cuts_at(std::size_t place) const {
  std::vector<std::vector<CutForces>> cuts;
  for (const SituationRun& run : *runs_) cuts.push_back(run.loads.cuts_at(station_of(place)));
  return cuts;
}

std::optional<DistortionSize> DistortionSearch::size_at(const LookedOver& of, std::size_t place,
                                                        std::size_t run,
                                                        std::size_t instant) const {
  const DistortionSize size = stretch_->size_at(place, run, instant);
  const double stress =
      of.of_unit[0] * size.moment + of.of_unit[1] * size.angle + of.shear * size.shear;
  if ((*runs_)[run].situation->load_factor * stress < no_effect * of.yield) return std::nullopt;
  return size;
}

DistortionSearch::LookedOver DistortionSearch::look_over(std::size_t place) {
  LookedOver over{distorted_points_at(*project_, *zones_, *stretch_, place),
                  {},
                  {},
                  0.0,
                  std::numeric_limits<double>::infinity()};
  for (const DistortedPoint& of : over.points) {
    for (const DistortionInfluence& at : of.at) {
      over.of_unit[0] = std::max(over.of_unit[0], std::abs(at.along));
      over.of_unit[1] = std::max(over.of_unit[1], at.across);
      over.shear = std::max(over.shear, std::abs(at.shear));
    }
    over.yield = std::min(over.yield, of.point.yield_strength.value());
  }
  found_.spacing =
      std::min(found_.spacing, si<Length>(0.5 / stretch_->stiffness(place).decay), std::less<>());
  const std::vector<std::vector<CutForces>> cuts = cuts_at(place);
  std::vector<CutForceHull> hulls(cuts.size());
  for (std::size_t r = 0; r < cuts.size(); ++r)
    for (const CutForces& cut : cuts[r]) hulls[r].take(cut);
  note_bending(over.points, cuts, hulls);
  const bool slender = slender_plates_at(*project_, *zones_, station_of(place)) != nullptr ||
                       slender_path_at(*project_, *zones_, station_of(place)) != nullptr;
  over.most.resize(over.points.size());
  for (std::size_t r = 0; r < cuts.size(); ++r) {
    const double factor = (*runs_)[r].situation->load_factor;
    DistortionSize most;
    bool any = false;
    for (std::size_t i = 0; factor > 0.0 && i < cuts[r].size(); ++i) {
      const std::optional<DistortionSize> size = size_at(over, place, r, i);
      if (!size) continue;
      any = true;
      most.angle = std::max(most.angle, size->angle);
      most.moment = std::max(most.moment, size->moment);
      most.shear = std::max(most.shear, size->shear);
      note_size(place, r, i,
                {factor * over.of_unit[0] * size->moment, factor * over.of_unit[1] * size->angle},
                over.yield, slender);
    }
    for (std::size_t p = 0; any && p < over.points.size(); ++p) {
      if (over.points[p].resisting == 0.0) continue;
      const StressInfluence& per_force = over.points[p].point.influence;
      const PointStress alone{si<Stress>(hulls[r].of(per_force.normal).size()),
                              si<Stress>(hulls[r].of(per_force.shear).size())};
      const double use = use_of(over.points[p], alone, most, factor).use();
      over.most[p] = std::max(over.most[p], or_unbounded(use));
    }
  }
  return over;
}

void DistortionSearch::look_at(std::size_t place, const LookedOver& of) {
  const auto may_be_worst = [&](double most) { return !(most < worst_.used) && most != 0.0; };
  const bool any = std::any_of(of.most.begin(), of.most.end(), may_be_worst);
  if (!any && !project_->fatigue.asked) return;
  const std::vector<std::vector<CutForces>> cuts = cuts_at(place);
  if (any) {
    std::vector<std::vector<std::optional<DistortionSize>>> sizes(cuts.size());
    for (std::size_t r = 0; r < cuts.size(); ++r)
      for (std::size_t i = 0; i < cuts[r].size(); ++i) sizes[r].push_back(size_at(of, place, r, i));
    for (std::size_t p = 0; p < of.points.size(); ++p)
      if (may_be_worst(of.most[p])) look_at(place, p, of.points[p], cuts, sizes);
  }
  if (project_->fatigue.asked)
    ranges_.look_at(place, of.points, cuts, of.of_unit, no_effect * of.yield);
}

void DistortionSearch::look_at(
    std::size_t place, std::size_t point, const DistortedPoint& of,
    const std::vector<std::vector<CutForces>>& cuts,
    const std::vector<std::vector<std::optional<DistortionSize>>>& sizes) {
  for (std::size_t r = 0; r < cuts.size(); ++r) {
    const double factor = (*runs_)[r].situation->load_factor;
    for (std::size_t i = 0; factor > 0.0 && i < cuts[r].size(); ++i) {
      if (!sizes[r][i]) continue;
      const PointUse use =
          use_of(of, stress_at(of.point.influence, cuts[r][i]), *sizes[r][i], factor);
      // Of several that are used alike the first one, in whatever order they are looked at.
      const bool before = std::tuple(place, r, i, point) <
                          std::tuple(worst_.place, worst_.run, worst_.instant, worst_.point);
      if (use.use() > worst_.used || (before && use.use() == worst_.used && worst_.used > 0.0))
        worst_ = {use.use(), place, r, i, point, (*runs_)[r].loads.time_of(i), use};
    }
  }
}

void DistortionSearch::look_at(const Diaphragm& of) {
  const auto& places = stretch_->places();
  const auto away = [&](const DistortedStretch::Place& at) { return abs(at.station.s - of.s); };
  const auto at = std::min_element(places.begin(), places.end(),
                                   [&](const auto& a, const auto& b) { return away(a) < away(b); });
  const auto place = static_cast<std::size_t>(at - places.begin());
  double angle = 0.0;
  for (std::size_t r = 0; r < runs_->size(); ++r) {
    const SituationRun& run = (*runs_)[r];
    for (std::size_t i = 0; i < run.loads.instants(); ++i)
      angle = std::max(angle, run.situation->load_factor * stretch_->size_at(place, r, i).angle);
  }
  const BoxCell& cell = stretch_->cell(place);
  const double E = project_->model.youngs_modulus,
               nu = 0.5 * E / project_->model.shear_modulus - 1.0;
  const double stiffness = diaphragm_stiffness(cell, of.thickness, of.opening, E, nu);
  const double d = angle * stiffness;
  auto holding = holding_of(*project_, of, cell, d);
  if (!holding) return;
  look_at_life(place, of, stiffness, *holding);
  found_.held.push_back(*holding);
  if (!found_.holding || holding->used() > found_.holding->used()) found_.holding = holding;
}

void DistortionSearch::look_at_life(std::size_t place, const Diaphragm& of, double stiffness,
                                    DistortionEstimate::Holding& holding) const {
  if (!project_->fatigue.asked || !(stiffness > 0.0)) return;
  const BoxCell& cell = stretch_->cell(place);
  const double flow = stiffness / (cell.width * cell.height).value();
  const double throat = of.throat > Length{} ? of.throat.value() : 0.5 * of.thickness.value();
  const double left = (std::min(cell.width, cell.height) - of.opening).value();
  const double t = of.thickness.value(), in_welds = 0.5 * flow / throat;
  holding.range = ranges_.range_of(place, in_welds);
  holding.life =
      std::max(ranges_.use_of(place, in_welds, project_->fatigue.throat, StressKind::shear),
               ranges_.use_of(place, flow / t * (1.0 + of.opening.value() / left),
                              project_->fatigue.shear, StressKind::shear));
  if (of.opening > Length{})
    holding.life =
        std::max(holding.life, ranges_.use_of(place, 6.0 * stiffness / (t * left * left),
                                              project_->fatigue.corner, StressKind::direct));
}

void DistortionSearch::note_size(std::size_t place, std::size_t run, std::size_t instant,
                                 const DistortionStresses& of, double yield, bool slender) {
  found_.along = std::max(found_.along, si<Stress>(of[0]), std::less<>());
  found_.across = std::max(found_.across, si<Stress>(of[1]), std::less<>());
  const double used = (of[0] + of[1]) * project_->strength.gamma_M0 / yield;
  if (slender) found_.used_where_slender = std::max(found_.used_where_slender, used);
  if (used <= found_.used) return;
  const SituationRun& by = (*runs_)[run];
  found_.used = used;
  found_.station = station_of(place);
  found_.when = by.loads.time_of(instant);
  found_.situation = index_of(*project_, *by.situation);
  const DistortedStretch::Torque torque =
      torque_at(*stretch_, place, stretch_->torques_at(run, instant));
  found_.introduced = torque.s;
  found_.torque = torque.torque;
}

void DistortionSearch::note_bending(const std::vector<DistortedPoint>& points,
                                    const std::vector<std::vector<CutForces>>& cuts,
                                    const std::vector<CutForceHull>& hulls) {
  constexpr std::size_t of_moments = cut_force::V_y;  // all but N
  for (const DistortedPoint& of : points) {
    if (of.at.size() < 2 || of.point.on_throat) continue;
    const auto& per_force = of.point.influence.normal;
    CutForceHull::Bounds counted{std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
    double most = 0.0;
    for (std::size_t r = 0; r < cuts.size(); ++r) {
      const Situation& situation = *(*runs_)[r].situation;
      const CutForceHull::Bounds bounds = hulls[r].of(per_force, of_moments);
      most = std::max(most, or_unbounded(situation.load_factor * bounds.size()));
      if (!project_->fatigue.asked || !counts_in_fatigue(*project_, situation)) continue;
      counted.lowest = std::min(counted.lowest, bounds.lowest);
      counted.highest = std::max(counted.highest, bounds.highest);
    }
    if (most <= found_.bending.value() &&
        counted.highest - counted.lowest <= found_.bending_range.value())
      continue;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t r = 0; r < cuts.size(); ++r) {
      const Situation& situation = *(*runs_)[r].situation;
      const bool counts = project_->fatigue.asked && counts_in_fatigue(*project_, situation);
      for (CutForces cut : cuts[r]) {
        cut.N = Force{};
        const double stress = stress_of(per_force, cut);
        found_.bending = std::max(
            found_.bending, si<Stress>(situation.load_factor * std::abs(stress)), std::less<>());
        if (!counts) continue;
        lowest = std::min(lowest, stress);
        highest = std::max(highest, stress);
      }
    }
    if (highest > lowest)
      found_.bending_range =
          std::max(found_.bending_range, si<Stress>(highest - lowest), std::less<>());
  }
}

void DistortionSearch::refine() {
  if (worst_.used == 0.0) return;
  const SituationRun& run = (*runs_)[worst_.run];
  const LoadHistory& history = run.loads;
  if (history.is_recorded()) return;
  const std::size_t i = worst_.instant, last = history.instants() - 1;
  const Time at = history.time_of(i);
  const Time low = i > 0 && !history.begins_piece(i) ? history.time_of(i - 1) : at;
  const Time high = i < last && !history.begins_piece(i + 1) ? history.time_of(i + 1) : at;
  if (!(high > low)) return;
  points_ = distorted_points_at(*project_, *zones_, *stretch_, worst_.place);
  constexpr int bits = 14;
  find_maximum(
      [&](double time) {
        const PointUse use = use_in(history.loads_at(si<Time>(time)));
        if (use.use() > worst_.used) {
          worst_.used = use.use();
          worst_.use = use;
          worst_.time = si<Time>(time);
        }
        return use.use();
      },
      low.value(), high.value(), bits);
}

PointUse DistortionSearch::use_in(const BeamLoads& loads) const {
  const DistortedPoint& of = points_[worst_.point];
  const CutForces cut = cut_forces_of(loads).at(station_of(worst_.place));
  return use_of(of, stress_at(of.point.influence, cut), stretch_->size_at(worst_.place, loads),
                (*runs_)[worst_.run].situation->load_factor);
}

CheckResult DistortionSearch::strength_check() {
  if (points_.empty()) points_ = distorted_points_at(*project_, *zones_, *stretch_, worst_.place);
  const DistortedPoint& of = points_[worst_.point];
  const SituationRun& run = (*runs_)[worst_.run];
  const BeamLoads loads = run.loads.loads_at(worst_.time);
  const CutForceDiagram diagram = run.loads.diagram_at(worst_.time);
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::distortion;
  check.station = station_of(worst_.place);
  check.point = of.point.name;
  check.id = id_of(check.criterion, check.station, check.point);
  check.situation = run.situation->name;
  check.time = worst_.time;
  check.acting = si<Stress>(worst_.use.acting);
  check.resisting = si<Stress>(worst_.use.resisting);
  check.required = project_->strength.required;
  check.safety_factor = check.resisting / check.acting;
  check.source = of.point.on_throat ? "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1"
                                    : yield_source(*of.point.first_to_yield.material);
  DistortionBasis& basis = result.distortion.emplace();
  basis.in_throat = of.point.on_throat;
  basis.load_factor = run.situation->load_factor;
  basis.size = stretch_->size_at(worst_.place, loads);
  basis.stress.point = of.point;
  basis.stress.weld = of.weld;
  basis.stress.cut_at_time = diagram.at(check.station);
  basis.stress.stress_at_time = stress_at(of.point.influence, basis.stress.cut_at_time);
  basis.stress.running = index_of(*project_, *run.situation);
  const PointUse use = use_of(of, basis.stress.stress_at_time, basis.size, basis.load_factor);
  basis.at = *use.at;
  const DistortedStretch::Torque torque =
      torque_at(*stretch_, worst_.place, stretch_->torques_of(loads));
  basis.introduced = torque.s;
  basis.torque = torque.torque;
  return result;
}

}  // namespace boxbeam
