#include "boxbeam/verification/beam_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "boxbeam/core/append.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/given_stresses.hpp"
#include "boxbeam/verification/path_checks.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/station_memory.hpp"
#include "boxbeam/verification/weld_checks.hpp"
#include "boxbeam/verification/worst_place.hpp"

namespace boxbeam {
namespace {

/// The checks of one station as they are gathered.
class StationChecks {
 public:
  /// `extremes`: where what they are is kept.
  StationChecks(const Project& project, const LoadedStation& loaded, StationExtremes* extremes)
      : project_(&project),
        histories_(&loaded.histories),
        samples_(&loaded.samples),
        extremes_(extremes) {}

  /// Every criterion at every point; along walls where each is worst. In the plane, where most of
  /// a section is level or has its maximum at a named point, only where it is worse there.
  void look_at(const StationPoints& of) {
    const std::vector<StressPoint>& points = of.points;
    Utilisations named;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (points[k].stretch) continue;
      const std::size_t before = results.size();
      look_at_point(points[k], of.on_edges[k]);
      for (std::size_t i = before; i < results.size(); ++i) {
        double& most = named.of(results[i].check.criterion);
        most = std::max(most, results[i].check.utilisation());
      }
    }
    if (project_->in_space) {
      for (const StressPoint& point : points) {
        if (!point.stretch) continue;
        for (const Criterion criterion : stress_criteria) {
          if (criterion != Criterion::weld)
            add(criterion, at_worst_on_stretch(*samples_, point, criterion));
        }
      }
      return;
    }
    std::vector<StretchUses> unknown;
    if (of.along.empty()) unknown = stretch_uses_of(*samples_, points);
    const WallSearch walls(*samples_, points, of.along.empty() ? unknown : of.along, named);
    for (const Criterion criterion : stress_criteria) {
      const WorstOnWall& worst = walls.worst(criterion);
      if (worst.point == nullptr || worst.utilisation < 1.0001 * named.of(criterion)) continue;
      add(criterion, worst.point->stretch->only_end
                         ? moved_along(*worst.point, worst.part)
                         : at_worst_on_stretch(*samples_, *worst.point, criterion));
    }
  }

  std::vector<CheckResult> results;

 private:
  /// A point, or by each criterion the worst on its edge.
  void look_at_point(const StressPoint& point, const std::vector<StressPoint>& worst) {
    static constexpr std::array ranges{Criterion::fatigue, Criterion::shear_fatigue,
                                       Criterion::combined_fatigue, Criterion::stress_range};
    if (!worst.empty()) {
      const auto add_worst = [&](Criterion criterion) {
        const auto at = std::find(stress_criteria.begin(), stress_criteria.end(), criterion);
        add(criterion, worst[static_cast<std::size_t>(at - stress_criteria.begin())]);
      };
      for (const Criterion criterion : ranges) add_worst(criterion);
      if (point.yield) add_worst(Criterion::yield);
      return;
    }
    PointHistory of(*project_, *histories_, point, extremes_);
    for (const Criterion criterion : ranges) add(criterion, of);
    if (point.on_throat)
      add(Criterion::weld, of);
    else if (point.yield)
      add(Criterion::yield, of);
  }

  void add(Criterion criterion, const StressPoint& point) {
    PointHistory of(*project_, *histories_, point, extremes_);
    add(criterion, of);
  }

  void add(Criterion criterion, PointHistory& of) {
    std::optional<CheckResult> result;
    if (criterion == Criterion::yield)
      result = check_yield(of);
    else if (criterion == Criterion::weld)
      result = check_throat(*project_, *histories_, *of.point);
    else if (criterion == Criterion::stress_range)
      result = check_range(of);
    else
      result = check_fatigue(of, criterion);
    if (result) results.push_back(std::move(*result));
  }

  const Project* project_;
  const std::vector<SituationHistory>* histories_;
  const StationSamples* samples_;
  StationExtremes* extremes_;
};

/// Keeps the worst of each criterion.
void keep_worst(std::vector<CheckResult> of_station, std::vector<CheckResult>& worst) {
  for (CheckResult& result : of_station) {
    const auto same = std::find_if(worst.begin(), worst.end(), [&](const CheckResult& of) {
      return of.check.criterion == result.check.criterion;
    });
    if (same == worst.end())
      worst.push_back(std::move(result));
    else if (result.check.utilisation() > same->check.utilisation())
      *same = std::move(result);
  }
}

void add_route(const Project& project, const Station& station, PlateRoute route, bool steep,
               std::vector<SegmentRoute>& routes) {
  const Segment& segment = project.beam.segments[segment_at(project.beam, station)];
  if (!routes.empty() && routes.back().segment == segment.name) return;
  routes.push_back({segment.name, route, steep ? steepness_text(segment) : std::string()});
}

/// Every criterion at every point of a station.
void check_station(const Project& project, const std::vector<BendingZone>& zones,
                   const Station& station, const LoadedStation& loaded, StationExtremes* extremes,
                   const StationPoints* known, StressFields& fields, BeamChecks& beam) {
  const std::vector<SituationHistory>& histories = loaded.histories;
  StationChecks checks(project, loaded, extremes);
  checks.look_at(
      known != nullptr
          ? *known
          : station_points_of(loaded.samples, stress_points_at(project, zones, station, fields)));
  append(std::move(checks.results), beam.checks);
  if (const auto plates = slender_plates_at(project, zones, station)) {
    PlateChecks of = check_plates(project, station, plates, histories);
    append(std::move(of.checks), beam.checks);
    keep_worst(std::move(of.beside), beam.beside);
    add_route(project, station, plates->route, plates->steep, beam.routes);
  }
  if (const auto path = slender_path_at(project, zones, station)) {
    append(check_path(project, station, path, histories), beam.checks);
    keep_worst(check_reduced_path(project, station, path, histories), beam.beside);
    add_route(project, station, PlateRoute::effective_widths, false, beam.routes);
  }
}

/// The throats with which the checks of each place of a seam would pass: its shear stress is the
/// flow over the throat, which says nothing to the section.
void give_seam_throats(std::vector<CheckResult>& checks) {
  const auto of_seam = [](const CheckResult& result) {
    return result.basis && result.basis->point.on_throat;
  };
  const auto place_of = [](const CheckResult& result) {
    const Check& check = result.check;
    return std::tuple(check.station.s.value(), check.station.side, check.point);
  };
  std::map<std::tuple<double, Side, std::string>, double> most;
  for (const CheckResult& result : checks) {
    if (!of_seam(result)) continue;
    double& use = most[place_of(result)];
    use = std::max(use, result.check.utilisation());
  }
  for (CheckResult& result : checks) {
    if (!of_seam(result)) continue;
    result.sufficient_throat =
        std::max(least_throat(), most.at(place_of(result)) * seam_throat_of(result.basis->point));
  }
}

bool is_fatigue(Criterion criterion) {
  return criterion == Criterion::fatigue || criterion == Criterion::shear_fatigue ||
         criterion == Criterion::combined_fatigue;
}

/// Counts over all instants what is estimated near the largest of its criterion, until all of that
/// is counted. How near follows from how far estimates were off.
class NearLargest {
 public:
  NearLargest(const Project& project, const std::deque<SituationRun>& runs, WholeLife& whole,
              std::vector<CheckResult>& checks)
      : project_(&project), runs_(&runs), whole_(&whole), checks_(&checks) {
    whole.summary.estimate_error = 0.0;
    whole.summary.margin = near;
  }

  void count() {
    // First those that are least like what has been counted: they show how good estimates are.
    count(least_like_counted());
    for (std::vector<CheckResult*> chosen = not_counted(); !chosen.empty(); chosen = not_counted())
      count(chosen);
  }

 private:
  static constexpr double near = 0.03;

  /// Those of fatigue whose use is above a share of the largest of their criterion, largest first.
  std::vector<CheckResult*> uses_above(double share) const {
    Utilisations largest;
    for (const CheckResult& result : *checks_) {
      double& of = largest.of(result.check.criterion);
      of = std::max(of, result.check.utilisation());
    }
    std::vector<CheckResult*> found;
    for (CheckResult& result : *checks_) {
      const double least = share * largest.of(result.check.criterion);
      if (is_fatigue(result.check.criterion) && result.check.utilisation() >= least)
        found.push_back(&result);
    }
    std::stable_sort(found.begin(), found.end(), [&](const CheckResult* a, const CheckResult* b) {
      return a->check.utilisation() / largest.of(a->check.criterion) >
             b->check.utilisation() / largest.of(b->check.criterion);
    });
    return found;
  }

  std::vector<WholePlace> places_of(const CheckResult& result) const {
    return whole_places_of(histories_at(*runs_, result.check.station), result.basis->point,
                           result.check.criterion);
  }

  void check_again(CheckResult& result) const {
    auto counted = check_fatigue(*project_, histories_at(*runs_, result.check.station),
                                 result.basis->point, result.check.criterion);
    if (counted) result = std::move(*counted);
  }

  void count(const std::vector<CheckResult*>& chosen) {
    constexpr double largest_margin = 0.3;
    std::vector<double> before;
    std::vector<WholePlace> places;
    for (const CheckResult* result : chosen) {
      before.push_back(result->check.utilisation());
      for (WholePlace& place : places_of(*result)) places.push_back(std::move(place));
    }
    whole_->count(places);
    WholeSummary& summary = whole_->summary;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      check_again(*chosen[i]);
      const double apart = std::abs(before[i] / chosen[i]->check.utilisation() - 1.0);
      summary.estimate_error = std::max(summary.estimate_error, apart);
    }
    summary.margin = std::clamp(2.0 * summary.estimate_error, near, largest_margin);
    // The others by what is known now.
    for (CheckResult* const result : uses_above(1.0 - 2.0 * summary.margin)) {
      if (std::find(chosen.begin(), chosen.end(), result) == chosen.end()) check_again(*result);
    }
  }

  std::vector<CheckResult*> least_like_counted() const {
    constexpr double much_used = 0.5;
    constexpr std::size_t most_unlike = 4;
    std::vector<CheckResult*> known;
    std::vector<WholePlace> theirs;
    for (CheckResult* const result : uses_above(much_used)) {
      if (result->check.criterion == Criterion::combined_fatigue) continue;
      known.push_back(result);
      theirs.push_back(places_of(*result).front());
    }
    const std::vector<WholePlace> unlike =
        whole_->unlike(theirs, std::vector<double>(theirs.size(), 1.0), most_unlike);
    std::vector<CheckResult*> tried;
    for (std::size_t i = 0; i < known.size(); ++i) {
      const bool is_chosen = std::any_of(unlike.begin(), unlike.end(), [&](const WholePlace& of) {
        return of.factors == theirs[i].factors;
      });
      if (is_chosen) tried.push_back(known[i]);
    }
    return tried;
  }

  /// Some of those near the largest that are only estimated.
  std::vector<CheckResult*> not_counted() const {
    constexpr std::size_t most_at_once = 16;
    std::vector<CheckResult*> chosen;
    for (CheckResult* const result : uses_above(1.0 - whole_->summary.margin)) {
      const std::vector<WholePlace> own = places_of(*result);
      const bool all_counted = std::all_of(own.begin(), own.end(), [&](const WholePlace& place) {
        return whole_->is_counted(place);
      });
      if (all_counted) continue;
      chosen.push_back(result);
      if (chosen.size() == most_at_once) break;
    }
    return chosen;
  }

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  WholeLife* whole_;
  std::vector<CheckResult>* checks_;
};

}  // namespace

BeamChecks check_beam(const Project& project, const std::deque<SituationRun>& runs,
                      const std::vector<BendingZone>& zones, const VerifiedStations& verified,
                      const ModelChoice& model, StationMemory* memory) {
  const bool computed = project.given_stresses.empty();
  BeamChecks beam;
  PlateGates gates(project, zones, model);
  StressFields fields;
  const auto add_outside = [&](const Station& station) {
    beam.stations.push_back(envelope_at(project, station, histories_at(runs, station)));
  };
  add_outside({Length{}, Side::before});
  for (const Station& station : verified.stations) {
    std::optional<LoadedStation> once;
    LoadedStation& loaded =
        memory != nullptr ? memory->at(station) : once.emplace(project, runs, station);
    if (!loaded.envelope) loaded.envelope = envelope_at(project, station, loaded.histories);
    beam.stations.push_back(*loaded.envelope);
    if (!computed) continue;
    const auto known = verified.points.find({station.s.value(), station.side});
    check_station(project, zones, station, loaded, memory != nullptr ? &loaded.extremes : nullptr,
                  known != verified.points.end() ? &known->second : nullptr,
                  memory != nullptr ? loaded.fields : fields, beam);
    gates.look_at(station, loaded.histories);
  }
  add_outside({project.beam.length(), Side::behind});
  if (!computed) {
    beam.checks = check_given_stresses(project);
    return beam;
  }
  leave_out_covered(project, beam.checks);
  append(check_welds(project, runs, zones), beam.checks);
  if (WholeLife* const whole = whole_life_of(runs);
      whole != nullptr && project.fatigue.asked && !beam.checks.empty())
    NearLargest(project, runs, *whole, beam.checks).count();
  give_seam_throats(beam.checks);
  gates.look_at(beam.checks);
  beam.gates = gates.gates();
  return beam;
}

}  // namespace boxbeam
