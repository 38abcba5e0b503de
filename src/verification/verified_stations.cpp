#include "boxbeam/verification/verified_stations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "boxbeam/numerics/largest_on_pieces.hpp"
#include "boxbeam/verification/beam_cuts.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/path_checks.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/station_memory.hpp"
#include "boxbeam/verification/worst_place.hpp"

namespace boxbeam {
namespace {

/// How much larger the largest size of a section's plates and outlines gets from one section to
/// another, or smaller.
double largest_change(const Section& from, const Section& to) {
  const auto sizes_of = [](const Section& section) {
    std::vector<Length> sizes = thicknesses_of(section);
    const auto add = [&](const Profile& profile) {
      const Extent extent = extent_of(profile);
      sizes.push_back(extent.y_high - extent.y_low);
      sizes.push_back(extent.z_high - extent.z_low);
    };
    add(section.outer);
    if (section.inner) add(*section.inner);
    return sizes;
  };
  const std::vector<Length> a = sizes_of(from), b = sizes_of(to);
  double change = 1.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double ratio = a[i] / b[i];
    change = std::max({change, ratio, 1.0 / ratio});
  }
  return change;
}

/// The borders of the parts of a piece: shorter where the section is smaller, so that within a part
/// no size changes by more than half.
std::vector<double> parts_of(const TaperedBeam& beam, const BeamCut& from, const BeamCut& to) {
  const double start = from.s.value(), end = to.s.value();
  const Section first = section_at(beam, {from.s, Side::behind});
  const Section last = section_at(beam, {to.s, Side::before});
  constexpr double most = 1.5;
  constexpr double most_parts = 64.0;
  const double change = largest_change(first, last);
  const double needed = std::ceil(std::log(change) / std::log(most) - 1e-9);
  const bool is_long = end - start > 0.02 * beam.length().value();
  const int parts = static_cast<int>(std::clamp(needed, is_long ? 2.0 : 1.0, most_parts));
  const bool grows = height_of(last.outer) > height_of(first.outer) ||
                     (height_of(last.outer) == height_of(first.outer) &&
                      extent_of(last.outer).y_high > extent_of(first.outer).y_high);
  std::vector<double> borders{start};
  for (int k = 1; k < parts; ++k) {
    const double share = static_cast<double>(k) / parts;
    // A size that grows by the factor `change` along the piece has grown by a part's factor to the
    // k-th power at the k-th border.
    double fraction = share;
    if (needed > 1.0) {
      const double along = grows ? share : 1.0 - share;
      const double grown = (std::pow(change, along) - 1.0) / (change - 1.0);
      fraction = grows ? grown : 1.0 - grown;
    }
    borders.push_back(start + fraction * (end - start));
  }
  borders.push_back(end);
  return borders;
}

/// The largest force on the beam, moments over its length.
double largest_force_of(const std::deque<SituationRun>& runs) {
  double largest = 0.0;
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const std::vector<CutForcePiece>& pieces = run.loads.diagram(i).pieces;
      const double length = pieces.back().end().value();
      for (const CutForcePiece& of : pieces) {
        largest = std::max({largest, std::abs(of.N(0.0)), std::abs(of.V_y(0.0)),
                            std::abs(of.V_z(0.0)), std::abs(of.T(0.0)) / length,
                            std::abs(of.M_y(0.0)) / length, std::abs(of.M_z(0.0)) / length});
      }
    }
  }
  return largest;
}

/// Along the beam as functions: the utilisations, each of a point of the section and a criterion,
/// the largest and smallest cut forces, whose own places the results show, and the slenderness of
/// the webs under their stress. Each criterion is a group, and each of the others.
class AlongBeam {
 public:
  /// Functions that are groups of their own: plates that buckle, cut forces, slenderness.
  static constexpr std::size_t of_cut_forces = plate_criteria.size();
  static constexpr std::size_t of_class = of_cut_forces + 2 * cut_force::count;
  static constexpr std::size_t beside_stress = of_class + 1;
  static constexpr std::size_t groups = stress_criteria.size() + beside_stress;
  /// Those that judge; the places of the others are for the eye.
  static constexpr std::size_t judging_groups = stress_criteria.size() + plate_criteria.size();

  AlongBeam(const Project& project, const std::deque<SituationRun>& runs,
            const std::vector<BendingZone>& zones, StationMemory* memory)
      : project_(&project), runs_(&runs), zones_(&zones), memory_(memory) {
    // What is so small beside the largest force is the rounding of sums.
    constexpr double part = 1e-5;
    nothing_ = part * largest_force_of(runs);
    for (std::size_t k = 0; k < beside_stress; ++k) group_of_.push_back(stress_criteria.size() + k);
  }

  /// At a station; what was found of its points is kept on request.
  FunctionValues at(const Station& station, bool keep = false) {
    ++evaluations_;
    std::optional<LoadedStation> once;
    LoadedStation& loaded =
        memory_ != nullptr ? memory_->at(station) : once.emplace(*project_, *runs_, station);
    const std::vector<SituationHistory>& histories = loaded.histories;
    const StationSamples& samples = loaded.samples;
    StressFields& fields = memory_ != nullptr ? loaded.fields : (keep ? fields_ : passing_fields_);
    StationPoints of_station =
        station_points_of(samples, stress_points_at(*project_, *zones_, station, fields));
    const std::vector<StressPoint>& points = of_station.points;
    FunctionValues values(group_of_.size());
    add_cut_forces(samples, values);
    values[of_class] = class_3_use_at(*project_, station, histories);
    if (const auto plates = slender_plates_at(*project_, *zones_, station)) {
      const Utilisations uses = plate_uses_of(*project_, *plates, samples);
      for (std::size_t k = 0; k < plate_criteria.size(); ++k)
        values[k] = uses.of(plate_criteria[k]);
    }
    if (const auto path = slender_path_at(*project_, *zones_, station)) {
      const Utilisations uses = path_uses_of(*project_, *path, samples);
      for (std::size_t k = 0; k < plate_criteria.size(); ++k)
        values[k] = uses.of(plate_criteria[k]);
    }
    const auto add = [&](const std::string& name, const Utilisations& found) {
      const std::vector<std::size_t>& functions = functions_of(name);
      if (values.size() < group_of_.size()) values.resize(group_of_.size());
      for (std::size_t k = 0; k < stress_criteria.size(); ++k)
        values[functions[k]] = std::max(values[functions[k]], found.of(stress_criteria[k]));
    };
    Utilisations named;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].stretch) continue;
      const Utilisations found = judge(samples, points[i], of_station.on_edges[i]);
      add(points[i].name, found);
      for (const Criterion criterion : stress_criteria)
        named.of(criterion) = std::max(named.of(criterion), found.of(criterion));
    }
    of_station.along = stretch_uses_of(samples, points);
    const WallSearch walls(samples, points, of_station.along, named);
    Utilisations on_walls;
    for (const Criterion criterion : stress_criteria)
      on_walls.of(criterion) = walls.worst(criterion).utilisation;
    add("walls", on_walls);
    if (keep) kept.insert_or_assign({station.s.value(), station.side}, std::move(of_station));
    return values;
  }

  std::size_t group_of(std::size_t function) const { return group_of_[function]; }
  std::size_t evaluations() const { return evaluations_; }

  std::map<std::pair<double, Side>, StationPoints> kept;

 private:
  void add_cut_forces(const StationSamples& samples, FunctionValues& values) const {
    for (std::size_t k = 0; k < cut_force::count; ++k) {
      const auto which = static_cast<cut_force::Index>(k);
      const bool moment = which >= cut_force::T;
      const double nothing = nothing_ * (moment ? project_->beam.length().value() : 1.0);
      for (const std::size_t negative : {0, 1}) {
        const double value = samples.largest_cut_force(which, negative == 0 ? 1.0 : -1.0);
        values[of_cut_forces + 2 * k + negative] = value > nothing ? value : 0.0;
      }
    }
  }

  static Utilisations judge(const StationSamples& samples, const StressPoint& point,
                            const std::vector<StressPoint>& worst) {
    if (worst.empty()) return samples.judge(point);
    Utilisations found;
    for (std::size_t k = 0; k < worst.size(); ++k) {
      const Criterion criterion = stress_criteria[k];
      found.of(criterion) = samples.judge(worst[k], {criterion}).of(criterion);
    }
    return found;
  }

  const std::vector<std::size_t>& functions_of(const std::string& name) {
    const auto found = functions_.find(name);
    if (found != functions_.end()) return found->second;
    std::vector<std::size_t>& functions = functions_[name];
    for (std::size_t k = 0; k < stress_criteria.size(); ++k) {
      functions.push_back(group_of_.size());
      group_of_.push_back(k);
    }
    return functions;
  }

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const std::vector<BendingZone>* zones_;
  StationMemory* memory_;
  std::map<std::string, std::vector<std::size_t>> functions_;
  StressFields fields_;
  /// Of stations of which nothing is kept to be shown.
  StressFields passing_fields_{StressFields::Keep::even, Prismatic::left_out};
  std::size_t evaluations_ = 0;
  double nothing_ = 0.0;               ///< below it a force is none [N]
  std::vector<std::size_t> group_of_;  ///< of each function
};

double value_of(const SearchedPlace& place, std::size_t function) {
  return function < place.values.size() ? place.values[function] : 0.0;
}

/// Inside a piece a function has a local maximum that may be the largest of its criterion.
struct LocalMaximum {
  std::size_t place = 0, function = 0;  ///< place as index among those of the piece
  double share = 0.0;                   ///< of the largest of the criterion
};

/// The largest first.
std::vector<LocalMaximum> local_maxima_of(const std::vector<SearchedPlace>& places,
                                          const std::vector<double>& largest,
                                          const AlongBeam& along) {
  constexpr double near = 0.98;
  std::vector<LocalMaximum> maxima;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    for (std::size_t f = 0; f < places[i].values.size(); ++f) {
      const double at = places[i].values[f];
      const double share = at / largest[along.group_of(f)];
      if (at <= 0.0 || share < near) continue;
      const double rise = at - value_of(places[i - 1], f), fall = at - value_of(places[i + 1], f);
      // A difference within round-off is a level stretch, no maximum.
      if (rise >= 0.0 && fall > 0.0 && std::max(rise, fall) > 1e-9 * at)
        maxima.push_back({i, f, share});
    }
  }
  std::stable_sort(maxima.begin(), maxima.end(),
                   [](const LocalMaximum& a, const LocalMaximum& b) { return a.share > b.share; });
  return maxima;
}

/// Where the parabola through a place and its neighbours has its top.
double top_near(const std::vector<SearchedPlace>& places, const LocalMaximum& maximum) {
  const SearchedPlace& at = places[maximum.place];
  const auto difference = [&](const SearchedPlace& other) {
    return std::pair{other.at - at.at,
                     value_of(other, maximum.function) - value_of(at, maximum.function)};
  };
  const auto [h, before] = difference(places[maximum.place - 1]);
  const auto [k, behind] = difference(places[maximum.place + 1]);
  // v = slope x + bend x^2 through (h, before), (0, 0), (k, behind).
  const double bend = (before / h - behind / k) / (h - k);
  const double slope = before / h - bend * h;
  return bend < 0.0 ? at.at + std::clamp(-0.5 * slope / bend, h, k) : at.at;
}

/// The places inside a piece that the exact checks decide among, ascending. Maxima of several
/// functions close together are one place, where none of them is lower than half the tolerance.
std::vector<Length> chosen_in(const std::vector<SearchedPlace>& places,
                              const std::vector<double>& largest, double tolerance,
                              AlongBeam& along) {
  std::vector<SearchedPlace> chosen;
  for (const LocalMaximum& maximum : local_maxima_of(places, largest, along)) {
    const double value = value_of(places[maximum.place], maximum.function);
    const bool there = std::any_of(chosen.begin(), chosen.end(), [&](const SearchedPlace& other) {
      return value_of(other, maximum.function) >= (1.0 - 0.5 * tolerance) * value;
    });
    if (there) continue;
    const double top = top_near(places, maximum);
    SearchedPlace polished{top, along.at({si<Length>(top), Side::both})};
    const bool higher = value_of(polished, maximum.function) >= value;
    if (!higher) polished = places[maximum.place];
    chosen.push_back(std::move(polished));
  }
  std::vector<Length> stations;
  for (const SearchedPlace& place : chosen) stations.push_back(si<Length>(place.at));
  std::sort(stations.begin(), stations.end());
  return stations;
}

/// The stations of a cut.
std::vector<Station> stations_of(const BeamCut& cut, const TaperedBeam& beam) {
  if (!cut.sides) return {{cut.s, Side::both}};
  std::vector<Station> stations;
  if (cut.s.value() > 0.0) stations.push_back({cut.s, Side::before});
  if (cut.s < beam.length()) stations.push_back({cut.s, Side::behind});
  return stations;
}

/// Counts over all instants of long records what is strong at the cuts of the beam, from which the
/// search estimates all else.
void count_at_cuts(const Project& project, const std::deque<SituationRun>& runs,
                   const std::vector<BendingZone>& zones, const std::vector<BeamCut>& cuts,
                   WholeLife& whole) {
  struct Kind {
    std::vector<WholePlace> places;
    std::vector<double> strengths;
  };
  Kind direct, shear;
  for (const BeamCut& cut : cuts) {
    for (const Station& station : stations_of(cut, project.beam)) {
      const std::vector<SituationHistory> histories = histories_at(runs, station);
      for (const StressPoint& of : stress_points_at(project, zones, station)) {
        const StressPoint point = of.stretch ? moved_along(of, 0.5) : of;
        if (point.detail != nullptr) {
          direct.places.push_back(whole_places_of(histories, point, Criterion::fatigue).front());
          direct.strengths.push_back(curve_of(point.detail->detail).reference.value());
        }
        if (point.shear_detail == nullptr) continue;
        shear.places.push_back(whole_places_of(histories, point, Criterion::shear_fatigue).front());
        shear.strengths.push_back(curve_of(*point.shear_detail).reference.value());
      }
    }
  }
  constexpr std::size_t most = 8;
  std::vector<WholePlace> chosen = whole.unlike(direct.places, direct.strengths, most);
  for (WholePlace& place : whole.unlike(shear.places, shear.strengths, most))
    chosen.push_back(std::move(place));
  whole.count(chosen);
}

}  // namespace

VerifiedStations search_stations(const Project& project, const std::deque<SituationRun>& runs,
                                 const std::vector<BendingZone>& zones, StationMemory* memory) {
  const TaperedBeam& beam = project.beam;
  const std::vector<BeamCut> cuts = beam_cuts_of(project, runs, zones);
  if (!project.given_stresses.empty()) {
    // No stress is computed: there is nothing to search.
    VerifiedStations verified;
    for (const BeamCut& cut : cuts) {
      for (const Station& station : stations_of(cut, beam)) verified.stations.push_back(station);
    }
    return verified;
  }
  if (WholeLife* const whole = whole_life_of(runs); whole != nullptr && project.fatigue.asked)
    count_at_cuts(project, runs, zones, cuts, *whole);
  AlongBeam along(project, runs, zones, memory);
  PieceSearch search;
  search.known.resize(AlongBeam::groups);
  for (const BeamCut& cut : cuts) {
    if (!cut.alone) continue;
    for (const Station& station : stations_of(cut, beam)) {
      const FunctionValues values = along.at(station, true);
      for (std::size_t f = 0; f < values.size(); ++f) {
        double& known = search.known[along.group_of(f)];
        known = std::max(known, values[f]);
      }
    }
  }
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    search.pieces.push_back(parts_of(beam, cuts[i], cuts[i + 1]));
  // Where stresses are but the round-off of larger ones no number of evaluations is enough.
  constexpr std::size_t at_least = 20'000, by_piece = 100;
  search.most_evaluations =
      std::min(search.most_evaluations, at_least + by_piece * search.pieces.size());
  search.group_of = [&](std::size_t function) { return along.group_of(function); };
  FunctionValues last;  // behind a cut without sides it is as before
  search.at = [&](std::size_t piece, double at) {
    const BeamCut& from = cuts[piece];
    const BeamCut& to = cuts[piece + 1];
    const auto limit_at = [&](const BeamCut& cut, Side side) {
      if (!cut.alone) return along.at({cut.s, cut.sides ? side : Side::both}, true);
      // What is judged there alone does not belong to the piece.
      const double inwards = side == Side::before ? -1e-9 : 1e-9;
      return along.at({cut.s + inwards * (to.s - from.s), Side::both});
    };
    if (at == from.s.value()) {
      const bool known = piece > 0 && !from.sides && !from.alone;
      return known ? last : limit_at(from, Side::behind);
    }
    if (at == to.s.value()) return last = limit_at(to, Side::before);
    return along.at({si<Length>(at), Side::both});
  };
  const PieceSearchResult found = largest_on_pieces(search);

  VerifiedStations verified;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    for (const Station& station : stations_of(cuts[i], beam)) verified.stations.push_back(station);
    if (i + 1 == cuts.size()) break;
    for (const Length& s : chosen_in(found.pieces[i], found.largest, search.tolerance, along))
      verified.stations.push_back({s, Side::both});
  }
  double tolerance = search.tolerance;
  for (std::size_t k = 0; k < std::min(AlongBeam::judging_groups, found.left_open.size()); ++k)
    tolerance = std::max(tolerance, found.left_open[k]);
  verified.points = std::move(along.kept);
  verified.search = {along.evaluations(), search.pieces.size(), tolerance};
  return verified;
}

}  // namespace boxbeam
