#include "oracle.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <span>

#include "beside.hpp"
#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/strength/material.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "instants.hpp"
#include "rules.hpp"
#include "section_stress.hpp"

namespace oracle {
namespace {

using namespace boxbeam;

using Cut = std::array<double, cut_force::count>;

Cut as_array(const CutForces& cut) {
  return {cut.N.value(), cut.V_y.value(), cut.V_z.value(),
          cut.T.value(), cut.M_y.value(), cut.M_z.value()};
}

/// The cut forces over the instants of a situation, each in a column; and a stress of them.
using Cuts = Eigen::Array<double, Eigen::Dynamic, cut_force::count>;
using Stresses = Eigen::ArrayXd;

template <typename Column>
std::span<const double> values_of(const Column& column) {
  return {column.data(), static_cast<std::size_t>(column.size())};
}

/// What a place's stresses can reach at most, by the box around all cut forces.
struct Bounds {
  Cut low, high, most{};  ///< most: largest size, load factors applied

  double range_of(const Factors& factors) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < low.size(); ++k) sum += std::abs(factors[k]) * (high[k] - low[k]);
    return sum;
  }
  double size_of(const Factors& factors) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < low.size(); ++k) sum += std::abs(factors[k]) * most[k];
    return sum;
  }
};

class Search {
 public:
  Search(const Project& project, const std::deque<SituationRun>& runs, const Density& density)
      : project_(project),
        runs_(runs),
        density_(density),
        rules_(project),
        sampled_(sample(project, runs, density.instants)),
        zones_(bending_zones_of(project, runs)) {
    for (const Situation& situation : project.situations) all_cycles_ += situation.cycles;
  }

  Findings findings() {
    for (const Station& station : stations()) look_at(station);
    look_at_deflection(project_, sampled_, cuts(), density_.stations, found_);
    if (!std::holds_alternative<flexible::Mechanism>(project_.mechanism) && !project_.in_space)
      look_at_neighbours(project_, runs_, sampled_, found_);
    return std::move(found_);
  }

 private:
  // ------------------------------------------------------------------------------- along the beam

  /// Every place where something begins, ends, jumps or bends.
  std::set<double> cuts() const {
    const TaperedBeam& beam = project_.beam;
    std::set<double> places{0.0, beam.length().value()};
    for (const Segment& segment : beam.segments) {
      places.insert(segment.start.value());
      places.insert(segment.end().value());
    }
    for (const BeamHole& hole : project_.holes) {
      const double radius = 0.5 * hole.hole.diameter.value();
      for (const double s : {hole.s.value() - radius, hole.s.value(), hole.s.value() + radius})
        if (s >= 0.0 && s <= beam.length().value()) places.insert(s);
    }
    for (const BeamDetail& detail : project_.fatigue.details) {
      places.insert(detail.from.value());
      places.insert(detail.to.value());
    }
    for (const BendingZone& zone : zones_) {
      places.insert(zone.from.value());
      places.insert(zone.to.value());
    }
    // Loads that slide are met at a few of their places.
    for (const Run& run : sampled_) {
      const std::size_t stride = std::max<std::size_t>(1, run.diagrams.size() / 16);
      for (std::size_t i = 0; i < run.diagrams.size(); i += stride) {
        for (const CutForcePiece& piece : run.diagrams[i].pieces) {
          places.insert(std::clamp(piece.start.value(), 0.0, beam.length().value()));
          places.insert(std::clamp(piece.end().value(), 0.0, beam.length().value()));
        }
      }
    }
    return places;
  }

  /// Both sides of the cuts first, then a grid from coarse to fine, so that most places can soon be
  /// seen to be milder than the worst.
  std::vector<Station> stations() const {
    const double length = project_.beam.length().value();
    std::vector<Station> stations;
    for (const double s : cuts()) {
      if (s > 0.0) stations.push_back({si<Length>(s), Side::before});
      if (s < length) stations.push_back({si<Length>(s), Side::behind});
    }
    std::vector<bool> done(static_cast<std::size_t>(density_.stations) + 1, false);
    for (int stride = 64; stride >= 1; stride /= 2) {
      for (int j = stride; j < density_.stations; j += stride) {
        if (done[static_cast<std::size_t>(j)]) continue;
        done[static_cast<std::size_t>(j)] = true;
        const Length s = si<Length>(length * j / density_.stations);
        stations.push_back({s, Side::before});
        if (!sliding()) continue;
        stations.push_back({s, Side::behind});
      }
    }
    return stations;
  }

  /// Whether loads slide along the beam, so that both sides of any station may differ.
  bool sliding() const {
    for (const Run& run : sampled_) {
      const CutForceDiagram& first = run.diagrams.front();
      const CutForceDiagram& other = run.diagrams[run.diagrams.size() / 3];
      if (first.pieces.size() != other.pieces.size()) return true;
      for (std::size_t i = 0; i < first.pieces.size(); ++i) {
        if (abs(first.pieces[i].end() - other.pieces[i].end()).value() > 1e-12) return true;
      }
    }
    return false;
  }

  LocalSection section_at(const Station& station) const {
    const TaperedBeam& beam = project_.beam;
    LocalSection local;
    local.here = boxbeam::section_at(beam, station);
    local.space = project_.in_space;
    for (const BeamHole& hole : project_.holes) {
      if (hole.s == station.s) local.holes.push_back(hole.hole);
    }
    const Segment& segment = beam.segments[segment_at(beam, station)];
    const ShearLags lags = shear_lags_at(zones_, local.here, station);
    if (lags.flanges) local.flange_part = lags.flanges->flange_part;
    if (lags.webs) local.web_part = lags.webs->flange_part;
    if (segment.from == segment.to) return local;
    const double h = 1e-4;
    const double x = (station.s - segment.start) / segment.length;
    const double per = 1.0 / (h * segment.length.value());
    const auto near = [&](double at, double weight) {
      local.nearby.emplace_back(interpolate(segment.from, segment.to, at), weight * per);
    };
    if (x < h) {
      near(x, -1.5);
      near(x + h, 2.0);
      near(x + 2.0 * h, -0.5);
    } else if (x > 1.0 - h) {
      near(x, 1.5);
      near(x - h, -2.0);
      near(x - 2.0 * h, 0.5);
    } else {
      near(x + h, 0.5);
      near(x - h, -0.5);
    }
    return local;
  }

  /// Whether a station cuts a hole beside its centre: holes are judged in the section through it,
  /// and nothing is whole here.
  bool cuts_a_hole(const Station& station) const {
    return std::any_of(project_.holes.begin(), project_.holes.end(), [&](const BeamHole& hole) {
      const double off = std::abs((station.s - hole.s).value());
      return off > 0.0 && off < 0.5 * hole.hole.diameter.value() - 1e-9;
    });
  }

  void look_at(const Station& station) {
    if (cuts_a_hole(station)) return;
    const LocalSection section = section_at(station);
    cuts_.resize(sampled_.size());
    Bounds bounds;
    bounds.low.fill(std::numeric_limits<double>::infinity());
    bounds.high.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t r = 0; r < sampled_.size(); ++r) {
      const Run& run = sampled_[r];
      Cuts& of = cuts_[r];
      of.resize(static_cast<Eigen::Index>(run.diagrams.size()), Eigen::NoChange);
      for (Eigen::Index i = 0; i < of.rows(); ++i) {
        const Cut cut = as_array(run.diagrams[static_cast<std::size_t>(i)].at(station));
        of.row(i) = Eigen::Map<const Eigen::Array<double, 1, cut_force::count>>(cut.data());
      }
      for (std::size_t k = 0; k < cut_force::count; ++k) {
        const auto column = of.col(static_cast<Eigen::Index>(k));
        bounds.low[k] = std::min(bounds.low[k], column.minCoeff());
        bounds.high[k] = std::max(bounds.high[k], column.maxCoeff());
        bounds.most[k] = std::max(bounds.most[k], run.load_factor * column.abs().maxCoeff());
      }
    }
    for (std::size_t k = 0; k < cut_force::count; ++k) acts_[k] = bounds.most[k] > 0.0;
    station_ = station;
    known_.clear();
    for (const Place& place : places_of(section, density_.around)) look_at(place, bounds);
    look_at_holes(section, bounds);
    look_at_class(section);
  }

  // ---------------------------------------------------------------------------- around the section

  /// The edges of holes: 200 angles of the superposition that the case's concentration stands for.
  void look_at_holes(const LocalSection& section, const Bounds& bounds) {
    for (const BeamHole& at : project_.holes) {
      if (at.s != station_.s || !at.concentration) continue;
      if (*at.concentration != HoleCase::in_plane_bending &&
          *at.concentration != HoleCase::membrane_tension)
        continue;
      LocalSection prismatic = section;
      prismatic.nearby.clear();
      // How much of the shear inclined flanges carry beside a hole is not certain: both ways.
      look_at_edges(section, at, bounds);
      if (!section.nearby.empty()) look_at_edges(prismatic, at, bounds);
    }
  }

  void look_at_edges(const LocalSection& section, const BeamHole& at, const Bounds& bounds) {
    const Hole& hole = at.hole;
    const double r = 0.5 * hole.diameter.value();
    int across = 0;
    for (const Hole& other : section.holes) {
      if (other.walls == HoleWalls::flanges) across += other.position.value() == 0.0 ? 1 : 2;
    }
    const Plane whole = plane_of(section, true, false), left = plane_of(section, true, true);
    for (const HoleCentre& centre : centres_of(section, hole)) {
      const double a = 2.0 * r / (centre.clear / (centre.along_z ? 1 : across));
      const double b = 1.0 - a;
      // Howland's hole in a strip, Peterson's fit of its gross factor.
      const double K = (2.0 + 0.284 * b - 0.600 * b * b + 1.32 * b * b * b) / b;
      const bool plane_only = !section.space;
      for (int k = 0; k < density_.around; ++k) {
        const double theta = 2.0 * std::numbers::pi * k / density_.around;
        Place place;
        place.name = "edge of hole " + hole.name + " in " + centre.wall;
        place.hole = hole.name;
        place.kind = centre.along_z ? PlaceKind::web : PlaceKind::fibre;
        place.plate = centre.plate;
        place.y = centre.y + (centre.along_z ? 0.0 : r * std::sin(theta));
        place.z = centre.z + (centre.along_z ? r * std::sin(theta) : 0.0);
        for (std::size_t i = 0; i < cut_force::count; ++i) {
          if (plane_only && !centre.along_z) {
            place.normal[i] = K * centre.normal[i];
            continue;
          }
          place.normal[i] = K / 3.0 * (1.0 - 2.0 * std::cos(2.0 * theta)) * centre.normal[i] +
                            r * centre.gradient[i] * (std::sin(theta) - std::sin(3.0 * theta)) -
                            4.0 / b * std::sin(2.0 * theta) * centre.shear[i];
        }
        // What shear lag leaves bends more.
        place.normal[cut_force::M_y] *= left.of[1][2] / whole.of[1][2];
        place.normal[cut_force::M_z] *= left.of[2][1] / whole.of[2][1];
        look_at(place, bounds, at.detail ? &*at.detail : nullptr);
        if (plane_only && !centre.along_z) break;
      }
    }
  }

  /// Whether a criterion can be worse here than where it is worst so far.
  bool beats(Criterion criterion, double utilisation) const {
    return utilisation > found_.utilisation(criterion);
  }

  void note(Criterion criterion, double utilisation, const std::string& place) {
    found_.note(criterion, utilisation, station_, place);
  }

  /// A stress over the instants of a run: of the cut forces that act.
  Stresses stresses_in(std::size_t run, const Factors& factors) const {
    Stresses sum;
    add_up(run, factors, 1.0, sum);
    return sum;
  }

  void add_up(std::size_t run, const Factors& factors, double times, auto& sum) const {
    sum.resize(cuts_[run].rows());
    std::array<Term, cut_force::count> terms;
    std::size_t count = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (!acts_[k] || factors[k] == 0.0) continue;
      const auto column = cuts_[run].col(static_cast<Eigen::Index>(k));
      terms[count++] = {times * factors[k], values_of(column)};
    }
    oracle::add_up({terms.data(), count}, {sum.data(), static_cast<std::size_t>(sum.size())});
  }

  void look_at(const Place& place, const Bounds& bounds, const BeamDetail* own = nullptr) {
    const FatigueInput& fatigue = project_.fatigue;
    const bool throat = place.kind == PlaceKind::throat;
    const bool edge = !place.hole.empty();
    if (!throat)
      look_at_yield(place, bounds);
    else
      look_at_weld(place, bounds);
    Resisting direct;
    if (!throat) direct = detail_here(place);
    if (own != nullptr) direct = {own, own->detail.compression_reduced, own->stress_factor};
    // The whole edge of a hole carries no shear.
    const Detail* shear = edge ? nullptr : (throat ? &fatigue.throat : &fatigue.shear);
    look_at_ranges(place, bounds, direct, shear);
    look_at_fatigue(place, bounds, direct, shear);
  }

  /// Many places of a station share kind and plate.
  const Resisting& detail_here(const Place& place) {
    for (const Known& known : known_) {
      if (known.kind == place.kind && known.plate == place.plate && known.at_flat == place.at_flat)
        return known.resisting;
    }
    known_.push_back({place.kind, place.plate, place.at_flat,
                      rules_.detail_at(station_, place.kind, place.plate, place.at_flat)});
    return known_.back().resisting;
  }

  void look_at_yield(const Place& place, const Bounds& bounds) {
    const double per = project_.strength.required * project_.strength.gamma_M0 /
                       rules_.yield_strength(place.plate);
    const double normal = bounds.size_of(place.normal), along = bounds.size_of(place.shear);
    if (!beats(Criterion::yield, per * std::sqrt(normal * normal + 3.0 * along * along))) return;
    double most = 0.0;
    for (std::size_t r = 0; r < sampled_.size(); ++r) {
      const double squared =
          (stresses_in(r, place.normal).square() + 3.0 * stresses_in(r, place.shear).square())
              .maxCoeff();
      most = std::max(most, sampled_[r].load_factor * sampled_[r].load_factor * squared);
    }
    ++found_.evaluations;
    note(Criterion::yield, per * std::sqrt(most), place.name);
  }

  void look_at_weld(const Place& place, const Bounds& bounds) {
    // sqrt(3) tau_par against f_u/(beta_w gamma_M2), of the weaker part joined.
    const double per = project_.strength.required * std::numbers::sqrt3 * project_.material.beta_w *
                       project_.strength.gamma_M2 / rules_.tensile_strength(place.joined);
    if (!beats(Criterion::weld, per * bounds.size_of(place.shear))) return;
    double most = 0.0;
    for (std::size_t r = 0; r < sampled_.size(); ++r) {
      const double largest = stresses_in(r, place.shear).abs().maxCoeff();
      most = std::max(most, sampled_[r].load_factor * largest);
    }
    ++found_.evaluations;
    note(Criterion::weld, per * most, place.name);
  }

  // --------------------------------------------------------------------------------- ranges,
  // cycles

  /// A stress over the instants of each situation that runs, by its index in the case.
  using Histories = std::vector<std::vector<double>>;

  const Histories& histories_of(const Factors& factors, double times, Histories& histories) const {
    histories.resize(project_.situations.size());
    for (std::size_t r = 0; r < sampled_.size(); ++r)
      add_up(r, factors, times, histories[sampled_[r].situation]);
    return histories;
  }

  /// Lowest and highest in a situation, or in those of which it is made.
  std::pair<double, double> extremes(const Histories& histories, std::size_t i) const {
    const Situation& situation = project_.situations[i];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto take = [&](std::size_t of) {
      if (histories[of].size() == 0) return;
      const auto [lowest, highest] = extremes_of(histories[of]);
      low = std::min(low, lowest);
      high = std::max(high, highest);
    };
    if (situation.between.empty()) take(i);
    for (const std::size_t part : situation.between) take(part);
    return {low, high};
  }

  double largest_range(const Histories& histories) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < project_.situations.size(); ++i) {
      if (project_.situations[i].cycles == 0.0) continue;
      const auto [low, high] = extremes(histories, i);
      largest = std::max(largest, high - low);
    }
    return largest;
  }

  /// All cycles of the life.
  std::vector<Cycle> cycles_of(const Histories& histories, bool reduced) const {
    std::vector<Cycle> all;
    for (std::size_t i = 0; i < project_.situations.size(); ++i) {
      const Situation& situation = project_.situations[i];
      if (situation.cycles == 0.0) continue;
      std::vector<Cycle> cycles;
      if (!situation.between.empty() && !situation.in_order) {
        const auto [low, high] = extremes(histories, i);
        cycles = {{si<Stress>(high - low), si<Stress>(0.5 * (high + low)), 1.0}};
      } else {
        std::vector<double> history = histories[i];
        for (const std::size_t part : situation.between) {
          const std::vector<double>& of = histories[part];
          history.insert(history.end(), of.begin(), of.end());
          if (closed(part)) history.push_back(of[0]);
        }
        cycles = count_cycles(history, {Counting::periodic});
      }
      for (Cycle& cycle : cycles) {
        cycle.count *= situation.cycles;
        if (reduced) {
          // 7.2.1: the compressive part counts 60 %.
          const double high = cycle.mean.value() + 0.5 * cycle.range.value();
          const double low = high - cycle.range.value();
          const double tension = std::max(high, 0.0) - std::max(low, 0.0);
          cycle.range = si<Stress>(tension + 0.6 * (high - low - tension));
        }
        all.push_back(cycle);
      }
    }
    return all;
  }

  bool closed(std::size_t situation) const {
    for (const Run& run : sampled_) {
      if (run.situation == situation) return run.closed;
    }
    return true;
  }

  void look_at_ranges(const Place& place, const Bounds& bounds, const Resisting& direct,
                      const Detail* shear) {
    const double f_y = rules_.yield_strength(place.plate);
    const double gamma = project_.fatigue.demand.gamma_Ff;
    const auto look = [&](const Factors& factors, double times, double limit) {
      if (!beats(Criterion::stress_range, gamma * times * bounds.range_of(factors) / limit)) return;
      ++found_.evaluations;
      note(Criterion::stress_range,
           gamma * largest_range(histories_of(factors, times, direct_)) / limit, place.name);
    };
    if (direct.detail != nullptr) look(place.normal, direct.range_factor, 1.5 * f_y);
    if (shear != nullptr) look(place.shear, 1.0, 1.5 / std::numbers::sqrt3 * f_y);
  }

  /// So many cycles in one repetition are reckoned with where only the box around the cut forces is
  /// known; a place at which more of them are met says so (Findings::most_cycles).
  static constexpr double reckoned_cycles = 8.0;

  /// Half the turning points of all situations, each as often as it happens: no fewer than the
  /// cycles of the life. The histories keep those alone.
  double cycles_in(Histories& histories) {
    for (std::vector<double>& history : histories) history.resize(keep_turns(history));
    double sum = 0.0;
    for (std::size_t i = 0; i < project_.situations.size(); ++i) {
      const Situation& situation = project_.situations[i];
      if (situation.cycles == 0.0) continue;
      double turns = 2.0;
      const auto count = [&](std::size_t of) {
        turns += static_cast<double>(changes_of(histories[of]));
      };
      if (situation.between.empty()) count(i);
      if (situation.in_order) {
        for (const std::size_t part : situation.between) {
          count(part);
          turns += 2.0;
        }
      }
      found_.most_cycles = std::max(found_.most_cycles, 0.5 * turns);
      sum += situation.cycles * 0.5 * turns;
    }
    return sum;
  }

  void look_at_fatigue(const Place& place, const Bounds& bounds, const Resisting& direct,
                       const Detail* shear) {
    const FatigueInput& fatigue = project_.fatigue;
    const FatigueDemand& demand = fatigue.demand;
    const double per = fatigue.required * demand.gamma_Ff * demand.gamma_Mf;
    // As many cycles of the largest range as there are cycles, and of two stresses a half of the
    // damage for each, is worse than what is there.
    const auto bound_of = [&](const Detail& detail, double range, double cycles) {
      return per * range / rules_.strength_at(detail, place.plate, cycles);
    };
    const double times = direct.detail != nullptr ? direct.detail->stress_factor : 1.0;
    double by_direct = 0.0, by_shear = 0.0;
    if (direct.detail != nullptr) {
      by_direct = bound_of(direct.detail->detail, times * bounds.range_of(place.normal),
                           2.0 * reckoned_cycles * all_cycles_);
    }
    if (shear != nullptr) {
      by_shear =
          bound_of(*shear, bounds.range_of(place.shear), 2.0 * reckoned_cycles * all_cycles_);
    }
    const bool together = direct.detail != nullptr && shear != nullptr &&
                          beats(Criterion::combined_fatigue, std::max(by_direct, by_shear));
    const bool direct_may =
        direct.detail != nullptr && (together || beats(Criterion::fatigue, by_direct));
    const bool shear_may =
        shear != nullptr && (together || beats(Criterion::shear_fatigue, by_shear));
    if (!direct_may && !shear_may) return;
    ++found_.evaluations;

    // By the rule of the program: so small no range is one.
    const double nothing = 1e-6 * rules_.yield_strength(place.plate);
    Histories &of_direct = direct_, &of_shear = shear_;
    bool direct_counts = false, shear_counts = false;
    // With the ranges and cycles themselves most places can be seen to be milder.
    if (direct_may) {
      histories_of(place.normal, times, of_direct);
      const double range = largest_range(of_direct);
      direct_counts = range >= nothing;
      by_direct = bound_of(direct.detail->detail, range, 2.0 * reckoned_cycles * all_cycles_);
      if (together || beats(Criterion::fatigue, by_direct))
        by_direct = bound_exactly(direct.detail->detail, place.plate, per * range,
                                  2.0 * cycles_in(of_direct));
    }
    if (shear_may) {
      histories_of(place.shear, 1.0, of_shear);
      const double range = largest_range(of_shear);
      shear_counts = range >= nothing;
      by_shear = bound_of(*shear, range, 2.0 * reckoned_cycles * all_cycles_);
      if (together || beats(Criterion::shear_fatigue, by_shear))
        by_shear = bound_exactly(*shear, place.plate, per * range, 2.0 * cycles_in(of_shear));
    }
    const bool want_direct = direct_counts && beats(Criterion::fatigue, by_direct);
    const bool want_shear = shear_counts && beats(Criterion::shear_fatigue, by_shear);
    const bool want_both = together && direct_counts && shear_counts &&
                           beats(Criterion::combined_fatigue, std::max(by_direct, by_shear));
    std::vector<FatigueChannel> channels;
    const auto add = [&](const Histories& histories, bool reduced, const Detail& detail) {
      channels.push_back({cycles_of(histories, reduced), rules_.curve_of(detail, place.plate)});
    };
    const auto use = [&](Criterion criterion) {
      note(criterion, fatigue.required / largest_factor(channels, demand), place.name);
    };
    if (want_direct || want_both) {
      add(of_direct, direct.compression_reduced, direct.detail->detail);
      if (want_direct) use(Criterion::fatigue);
    }
    if (want_shear || want_both) {
      add(of_shear, false, *shear);
      if (want_both) use(Criterion::combined_fatigue);
      if (channels.size() == 2) channels.erase(channels.begin());
      if (want_shear) use(Criterion::shear_fatigue);
    }
  }

  /// The same bound with numbers that differ from place to place.
  double bound_exactly(const Detail& detail, double plate, double range, double cycles) {
    const Loading loading = project_.fatigue.demand.loading;
    return range / strength_at(rules_.curve_of(detail, plate), cycles, loading).value();
  }

  // -------------------------------------------------------------------------------- section class

  void look_at_class(const LocalSection& section) {
    if (!found_.gate.empty()) return;
    look_at_class(section, section.here.outer);
    if (section.here.inner) look_at_class(section, *section.here.inner);
  }

  /// EN 1993-1-1, table 5.2: even compression 42 eps, round tubes 90 eps^2, webs by their stress;
  /// EN 1993-1-5, 5.1(2): shear buckling above 72 eps/eta, eta = 1.2.
  void look_at_class(const LocalSection& section, const Profile& profile) {
    const auto eps = [&](double t) { return std::sqrt(235e6 / rules_.yield_strength(t)); };
    const auto gate = [&](const char* what) {
      if (found_.gate.empty())
        found_.gate = fmt::format("{} at s = {:.6g} m", what, station_.s.value());
    };
    if (const auto* round = std::get_if<RoundTube>(&profile)) {
      const double t = round->wall.value();
      if (round->diameter.value() / t > 90.0 * eps(t) * eps(t)) gate("round wall of class 4");
      return;
    }
    const auto* box = std::get_if<Box>(&profile);
    const auto* tube = std::get_if<RectangularTube>(&profile);
    if (box == nullptr && tube == nullptr) return;
    const double W = (box ? box->width : tube->width).value();
    const double H = (box ? box->height : tube->height).value();
    const double top = (box ? box->top_flange : tube->wall).value();
    const double bottom = (box ? box->bottom_flange : tube->wall).value();
    const double left = (box ? box->left_web : tube->wall).value();
    const double right = (box ? box->right_web : tube->wall).value();
    const bool bars = box != nullptr && !box->stiffeners.empty();
    const double c_flange = W - left - right, h_w = H - top - bottom;
    if (!bars) {
      for (const double t : {top, bottom})
        if (c_flange / t > 42.0 * eps(t)) gate("flange of class 4");
    }
    for (const double t : {left, right})
      if (h_w / t > 72.0 / 1.2 * eps(t)) gate("web that may buckle in shear");
    if (project_.in_space) {
      for (const double t : {top, bottom})
        if (c_flange / t > 72.0 / 1.2 * eps(t)) gate("flange that may buckle in shear");
    }
    const Plane plane = plane_of({section.here, {}, {}, section.space, 1.0, 1.0}, false, false);
    const auto stress = [&](const auto& cut, double y, double z) {
      double sum = 0.0;
      const double forces[] = {cut[cut_force::N], cut[cut_force::M_y], cut[cut_force::M_z]};
      for (std::size_t k = 0; k < 3; ++k)
        sum += forces[k] * (plane.of[k][0] + plane.of[k][1] * y + plane.of[k][2] * z);
      return sum;
    };
    for (const double side : {1.0, -1.0}) {
      const double t = side > 0.0 ? left : right;
      const double ratio = h_w / t, e = eps(t);
      if (ratio <= 42.0 * e) continue;
      const double y = side * 0.5 * (W - t);
      double largest = 0.0;
      for (const Cuts& run : cuts_) {
        for (const auto& cut : run.rowwise())
          largest = std::max({largest, std::abs(stress(cut, y, 0.5 * H - top)),
                              std::abs(stress(cut, y, -0.5 * H + bottom))});
      }
      for (std::size_t r = 0; r < cuts_.size(); ++r) {
        const double design = project_.strength.required * project_.strength.gamma_M0 *
                              sampled_[r].load_factor / rules_.yield_strength(t);
        for (const auto& cut : cuts_[r].rowwise()) {
          const double up = -stress(cut, y, 0.5 * H - top), low = -stress(cut, y, bottom - 0.5 * H);
          const double most = std::max(up, low);
          if (most <= 0.01 * largest) continue;  // compression that does not matter
          const double psi = std::min(up, low) / most;
          // The branches miss each other by 0.4 % at -1, where rounding does not decide.
          const double limit = psi > -1.0 + 1e-9 ? 42.0 * e / (0.67 + 0.33 * psi)
                                                 : 62.0 * e * (1.0 - psi) * std::sqrt(-psi);
          // 5.5.2(9): of a part with less than its yield strength eps is larger.
          if (ratio * std::sqrt(std::min(1.0, design * most)) > limit) gate("web of class 4");
        }
      }
    }
  }

  const Project& project_;
  const std::deque<SituationRun>& runs_;
  Density density_;
  Rules rules_;
  std::vector<Run> sampled_;
  std::vector<BendingZone> zones_;
  double all_cycles_ = 0.0;
  Station station_;
  struct Known {
    PlaceKind kind;
    double plate;
    bool at_flat;
    Resisting resisting;
  };
  std::vector<Known> known_;                   ///< details of the station looked at
  Histories direct_, shear_;                   ///< of the place looked at
  std::vector<Cuts> cuts_;                     ///< at the station looked at, by run
  std::array<bool, cut_force::count> acts_{};  ///< whether a cut force is not always zero there
  Findings found_;
};

}  // namespace

void Findings::note(Criterion criterion, double utilisation_there, const Station& station,
                    const std::string& place) {
  if (utilisation_there > utilisation(criterion))
    worst[criterion] = {utilisation_there, station, place};
}

bool Findings::fails() const {
  return std::any_of(worst.begin(), worst.end(),
                     [](const auto& each) { return each.second.utilisation > 1.0; });
}

namespace {

/// A stiffened box with a web that may buckle in shear: judged by effective widths, of which the
/// oracle knows nothing.
bool has_slender_webs_and_bars(const Project& project, const Section& section) {
  const auto* box = std::get_if<Box>(&section.outer);
  if (box == nullptr || box->stiffeners.empty()) return false;
  const Length depth = box->height - box->top_flange - box->bottom_flange;
  const Length thinnest = std::min(box->left_web, box->right_web);
  const auto yield = yield_strength_of(project.material, thinnest);
  return !yield || depth / thinnest > 72.0 / 1.2 * std::sqrt(235e6 / yield->value());
}

}  // namespace

bool covers(const Project& project) {
  if (!project.given_stresses.empty() || !project.points.empty()) return false;
  if (!project.welds.empty()) return false;
  if (project.dynamics == Dynamics::newton_chain) return false;
  for (const BeamHole& at : project.holes) {
    const Section section = section_at(project.beam, {at.s, Side::both});
    if (std::holds_alternative<Plate>(section.outer)) return false;
  }
  return std::all_of(
      project.beam.segments.begin(), project.beam.segments.end(), [&](const Segment& s) {
        return covers(s.from) && covers(s.to) && !has_slender_webs_and_bars(project, s.from) &&
               !has_slender_webs_and_bars(project, s.to);
      });
}

Findings look_everywhere(const Project& project, const std::deque<SituationRun>& runs,
                         const Density& density) {
  return Search(project, runs, density).findings();
}

}  // namespace oracle
