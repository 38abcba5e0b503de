#include "boxbeam/verification/distortion_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/distorted_stretch.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "check_sources.hpp"
#include "counts_in_fatigue.hpp"
#include "distorted_paths.hpp"
#include "distortion_ranges.hpp"
#include "holding_diaphragm.hpp"

namespace boxbeam {
namespace {

/// Stresses of distortion below this part of the yield strength are none, as far as places are
/// searched for.
constexpr double no_effect = 1e-4;

/// Segments of boxes in a row.
std::vector<BoxStretch> box_stretches_of(const TaperedBeam& beam) {
  std::vector<BoxStretch> stretches;
  bool before = false;
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const bool box = has_cell(beam.segments[i]);
    if (box && before) stretches.back().last = i;
    if (box && !before) stretches.push_back({i, i});
    before = box;
  }
  return stretches;
}

/// Whether any segment keeps its shape as cells do not.
bool has_cells(const TaperedBeam& beam) {
  return std::any_of(beam.segments.begin(), beam.segments.end(),
                     [](const Segment& of) { return has_cell(of) || is_closed_path(of); });
}

/// Whether anything twists the beam at any instant, or torques that cancel come into it.
bool is_twisted(const std::deque<SituationRun>& runs,
                const std::vector<std::vector<TorquesIn>>& torques) {
  for (const std::vector<TorquesIn>& of_run : torques)
    for (const TorquesIn& at : of_run)
      if (!at.empty()) return true;
  for (const SituationRun& run : runs) {
    const double least = least_torque(run);
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      for (const CutForcePiece& piece : run.loads.diagram(i).pieces) {
        for (const double part : {0.0, 0.5, 1.0})
          if (std::abs(piece.T(part * piece.length.value())) > least) return true;
      }
    }
  }
  return false;
}

/// Searches one stretch.
class DistortionSearch {
 public:
  DistortionSearch(const Project& project, const std::deque<SituationRun>& runs,
                   const std::vector<BendingZone>& zones, const DistortedStretch& stretch,
                   const BoxStretch& segments)
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
    for (std::size_t k = 0; k < stretch.places().size(); ++k) look_at(k);
    refine();
    for (const Diaphragm& of : project.beam.diaphragms)
      if (of.s >= stretch.from() && of.s <= stretch.to()) look_at(of);
    found_.ranges_judged = ranges_.judged();
    found_.along_range = si<Stress>(ranges_.largest()[0]);
    found_.across_range = si<Stress>(ranges_.largest()[1]);
  }

  const DistortionEstimate& estimate() const { return found_; }

  std::vector<CheckResult> checks() {
    std::vector<CheckResult> all;
    if (worst_.used > 0.0) all.push_back(strength_check());
    for (CheckResult& of : ranges_.checks()) all.push_back(std::move(of));
    return all;
  }

 private:
  struct Worst {
    double used = 0.0;
    std::size_t place = 0, point = 0, run = 0, instant = 0;
    Time time;
    PointUse use;
  };

  const Station& station_of(std::size_t place) const { return stretch_->places()[place].station; }

  void look_at(std::size_t place) {
    const std::vector<DistortedPoint> points =
        distorted_points_at(*project_, *zones_, *stretch_, place);
    double along = 0.0, across = 0.0, shear = 0.0;
    double yield = std::numeric_limits<double>::infinity();
    for (const DistortedPoint& of : points) {
      for (const DistortionInfluence& at : of.at) {
        along = std::max(along, std::abs(at.along));
        across = std::max(across, at.across);
        shear = std::max(shear, std::abs(at.shear));
      }
      yield = std::min(yield, of.point.yield_strength.value());
    }
    found_.spacing =
        std::min(found_.spacing, si<Length>(0.5 / stretch_->stiffness(place).decay), std::less<>());
    std::vector<std::vector<CutForces>> cuts;
    for (const SituationRun& run : *runs_) cuts.push_back(run.loads.cuts_at(station_of(place)));
    look_at_bending(points, cuts);
    const bool slender = slender_plates_at(*project_, *zones_, station_of(place)) != nullptr ||
                         slender_path_at(*project_, *zones_, station_of(place)) != nullptr;
    for (std::size_t r = 0; r < cuts.size(); ++r) {
      const double factor = (*runs_)[r].situation->load_factor;
      for (std::size_t i = 0; factor > 0.0 && i < cuts[r].size(); ++i) {
        const DistortionSize size = stretch_->size_at(place, r, i);
        const double stretched = factor * along * size.moment, bent = factor * across * size.angle;
        if (stretched + bent + factor * shear * size.shear < no_effect * yield) continue;
        note_size(place, r, i, {stretched, bent}, yield, slender);
        for (std::size_t p = 0; p < points.size(); ++p) {
          if (points[p].resisting == 0.0) continue;
          const PointUse use =
              use_of(points[p], stress_at(points[p].point.influence, cuts[r][i]), size, factor);
          if (use.use() > worst_.used)
            worst_ = {use.use(), place, p, r, i, (*runs_)[r].loads.time_of(i), use};
        }
      }
    }
    if (project_->fatigue.asked)
      ranges_.look_at(place, points, cuts, {along, across}, no_effect * yield);
  }

  void look_at(const Diaphragm& of) {
    const auto& places = stretch_->places();
    const auto away = [&](const DistortedStretch::Place& at) { return abs(at.station.s - of.s); };
    const auto at =
        std::min_element(places.begin(), places.end(),
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

  /// Its fillets and its plate in shear, strips beside an opening bent in its plane as corners are.
  void look_at_life(std::size_t place, const Diaphragm& of, double stiffness,
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

  void note_size(std::size_t place, std::size_t run, std::size_t instant,
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

  void look_at_bending(const std::vector<DistortedPoint>& points,
                       const std::vector<std::vector<CutForces>>& cuts) {
    for (const DistortedPoint& of : points) {
      if (of.at.size() < 2 || of.point.on_throat) continue;
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (std::size_t r = 0; r < cuts.size(); ++r) {
        const Situation& situation = *(*runs_)[r].situation;
        const bool counts = project_->fatigue.asked && counts_in_fatigue(*project_, situation);
        for (CutForces cut : cuts[r]) {
          cut.N = Force{};
          const Stress stress = stress_at(of.point.influence, cut).normal;
          found_.bending =
              std::max(found_.bending, Stress(situation.load_factor * abs(stress)), std::less<>());
          if (!counts) continue;
          lowest = std::min(lowest, stress.value());
          highest = std::max(highest, stress.value());
        }
      }
      if (highest > lowest)
        found_.bending_range =
            std::max(found_.bending_range, si<Stress>(highest - lowest), std::less<>());
    }
  }

  /// The maximum between the instants beside the worst, at its place.
  void refine() {
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

  PointUse use_in(const BeamLoads& loads) const {
    const DistortedPoint& of = points_[worst_.point];
    const CutForces cut = cut_forces_of(loads).at(station_of(worst_.place));
    return use_of(of, stress_at(of.point.influence, cut), stretch_->size_at(worst_.place, loads),
                  (*runs_)[worst_.run].situation->load_factor);
  }

  CheckResult strength_check() {
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

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const std::vector<BendingZone>* zones_;
  const DistortedStretch* stretch_;
  DistortionRanges ranges_;
  DistortionEstimate found_;
  Worst worst_;
  std::vector<DistortedPoint> points_;  ///< at the worst place
};

}  // namespace

namespace {

/// What of a diaphragm's fatigue is in no check, nor stops the verdict.
void note_life(const DistortionEstimate& estimate, const DistortionEstimate::Holding& of,
               std::vector<NotJudged>& not_judged) {
  // Judged and below one it is said where little is left for what forces put there as well.
  const double hardly = estimate.ranges_judged ? 0.5 : 0.1;
  if (!(of.life > hardly) || (estimate.ranges_judged && of.life > 1.0)) return;
  not_judged.push_back(
      {Criterion::distortion_fatigue,
       fmt::format("welds of the diaphragm at s = {} m", to_text(Station{of.s, Side::both})),
       fmt::format("so that the box keeps its shape sheared anew by up to {:.3g} MPa at every "
                   "cycle, they or its plate {} (EN 1993-1-9, table 8.5, row 8), in no check",
                   1e-6 * of.range.value(),
                   estimate.ranges_judged ? fmt::format("used by {:.2g} in fatigue", of.life)
                                          : "in a long record")});
}

/// A couple that all plates of a box are said to bear though nothing spreads it there.
NotJudged spread_by_nothing(const DistortedStretch::Torque& of) {
  return {Criterion::distortion,
          fmt::format("torque at s = {} m", to_text(Station{of.s, Side::both})),
          fmt::format("{:.4g} kN m taken to come by all plates (torque_by = \"flow\") where no "
                      "diaphragm stands that spreads it",
                      1e-3 * of.torque.value())};
}

}  // namespace

DistortionChecks check_distortion(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<BendingZone>& zones,
                                  const std::vector<Station>& stations) {
  DistortionChecks found;
  if (!project.in_space || !has_cells(project.beam)) return found;
  const std::vector<std::vector<TorquesIn>> torques = torques_in(project, runs);
  if (!is_twisted(runs, torques)) return found;
  for (const BoxStretch& segments : box_stretches_of(project.beam)) {
    const DistortedStretch stretch(project, runs, torques, segments, stations);
    if (stretch.spread_by_nothing().torque > Moment{})
      found.not_judged.push_back(spread_by_nothing(stretch.spread_by_nothing()));
    if (!stretch.is_distorted()) continue;
    DistortionSearch search(project, runs, zones, stretch, segments);
    for (CheckResult& check : search.checks()) found.checks.push_back(std::move(check));
    found.estimates.push_back(search.estimate());
    const DistortionEstimate& estimate = found.estimates.back();
    for (const DistortionEstimate::Holding& of : estimate.held)
      note_life(estimate, of, found.not_judged);
    const auto& holding = estimate.holding;
    if (!holding || !(project.strength.required * holding->needed > least_throat())) continue;
    found.not_judged.push_back(unsaid_welds(project, *holding));
  }
  look_at_other_cells(project, runs, torques, found);
  return found;
}

void leave_out_without_effect(std::vector<CheckResult>& checks) {
  const auto leave_out = [&](Criterion criterion, std::initializer_list<Criterion> without) {
    double most = 0.0;
    for (const CheckResult& of : checks) {
      if (!of.patch &&
          std::find(without.begin(), without.end(), of.check.criterion) != without.end())
        most = std::max(most, of.check.utilisation());
    }
    constexpr double close = 1e-6;
    std::erase_if(checks, [&](const CheckResult& of) {
      return of.check.criterion == criterion &&
             std::abs(of.check.utilisation() - most) <= close * most;
    });
  };
  leave_out(Criterion::distortion, {Criterion::yield, Criterion::weld});
  leave_out(Criterion::distortion_fatigue,
            {Criterion::fatigue, Criterion::shear_fatigue, Criterion::combined_fatigue});
}

}  // namespace boxbeam
