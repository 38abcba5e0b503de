#include "oracle.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

#include "beside.hpp"
#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "combined_cases.hpp"
#include "instants.hpp"
#include "life.hpp"
#include "member.hpp"
#include "neighbours.hpp"
#include "rules.hpp"
#include "section_stress.hpp"
#include "slender_walls.hpp"
#include "stations.hpp"

namespace oracle {
namespace {

using namespace boxbeam;

using Cut = std::array<double, cut_force::count>;

Cut as_array(const CutForces& cut) {
  return {cut.N.value(), cut.V_y.value(), cut.V_z.value(),
          cut.T.value(), cut.M_y.value(), cut.M_z.value()};
}

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
  Search(const Project& project, const std::deque<SituationRun>& runs, const Density& density,
         const Combining& combining)
      : project_(project),
        runs_(runs),
        density_(density),
        rules_(project),
        sampled_(sample(project, runs, density.instants)),
        life_(project, sampled_),
        zones_(bending_zones_of(project, runs)),
        combined_(combinations_of(combining, project, sampled_)) {
    for (const Situation& situation : project.situations) all_cycles_ += situation.cycles;
    for (const Run& run : sampled_) load_factors_.push_back(run.load_factor);
    load_factors_.resize(sampled_.size() + combined_.size(), 1.0);
  }

  Findings findings() {
    for (const Station& station : stations_of(project_, sampled_, zones_, density_))
      look_at(station);
    look_at_deflection(project_, sampled_, cut_places_of(project_, sampled_, zones_),
                       density_.stations, found_);
    look_at_member(project_, sampled_, rules_, found_);
    look_at_neighbours(project_, runs_, sampled_, life_, found_);
    return std::move(found_);
  }

 private:
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
    segment_ = segment_at(project_.beam, station);
    cuts_.resize(load_factors_.size());
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
    // Of load cases at rest: sums of what each does alone.
    for (std::size_t c = 0; c < combined_.size(); ++c) {
      Cuts& of = cuts_[sampled_.size() + c];
      of.setZero(1, cut_force::count);
      for (const auto& [run, factor] : combined_[c]) of.row(0) += factor * cuts_[run].row(0);
      for (std::size_t k = 0; k < cut_force::count; ++k)
        bounds.most[k] = std::max(bounds.most[k], std::abs(of(0, static_cast<Eigen::Index>(k))));
    }
    for (std::size_t k = 0; k < cut_force::count; ++k) acts_[k] = bounds.most[k] > 0.0;
    station_ = station;
    known_.clear();
    for (const Place& place : places_of(section, density_.around)) look_at(place, bounds);
    look_at_holes(section, bounds);
    if (found_.gate.empty())
      found_.gate =
          slender_wall_at(project_, rules_, section, station_, segment_, cuts_, load_factors_);
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
        place.wall = centre.kind;
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
    if (!fatigue.asked) return;
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
                       rules_.yield_strength(segment_, place);
    const double normal = bounds.size_of(place.normal), along = bounds.size_of(place.shear);
    if (!beats(Criterion::yield, per * std::sqrt(normal * normal + 3.0 * along * along))) return;
    double most = 0.0;
    for (std::size_t r = 0; r < cuts_.size(); ++r) {
      const double squared =
          (stresses_in(r, place.normal).square() + 3.0 * stresses_in(r, place.shear).square())
              .maxCoeff();
      most = std::max(most, load_factors_[r] * load_factors_[r] * squared);
    }
    ++found_.evaluations;
    note(Criterion::yield, per * std::sqrt(most), place.name);
  }

  void look_at_weld(const Place& place, const Bounds& bounds) {
    // sqrt(3) tau_par against f_u/(beta_w gamma_M2), of the weaker part joined.
    const double per = project_.strength.required * std::numbers::sqrt3 *
                       project_.strength.gamma_M2 / rules_.weld_strength(segment_, place);
    if (!beats(Criterion::weld, per * bounds.size_of(place.shear))) return;
    double most = 0.0;
    for (std::size_t r = 0; r < cuts_.size(); ++r) {
      const double largest = stresses_in(r, place.shear).abs().maxCoeff();
      most = std::max(most, load_factors_[r] * largest);
    }
    ++found_.evaluations;
    note(Criterion::weld, per * most, place.name);
  }

  // --------------------------------------------------------------------------------- ranges,
  // cycles

  const Histories& histories_of(const Factors& factors, double times, Histories& histories) const {
    histories.resize(project_.situations.size());
    for (std::size_t r = 0; r < sampled_.size(); ++r)
      add_up(r, factors, times, histories[sampled_[r].situation]);
    return histories;
  }

  void look_at_ranges(const Place& place, const Bounds& bounds, const Resisting& direct,
                      const Detail* shear) {
    const double f_y = rules_.yield_strength(segment_, place);
    const double gamma = project_.fatigue.demand.gamma_Ff;
    const auto look = [&](const Factors& factors, double times, double limit) {
      if (!beats(Criterion::stress_range, gamma * times * bounds.range_of(factors) / limit)) return;
      ++found_.evaluations;
      note(Criterion::stress_range,
           gamma * life_.largest_range(histories_of(factors, times, direct_)) / limit, place.name);
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
    const double nothing = 1e-6 * rules_.yield_strength(segment_, place);
    Histories &of_direct = direct_, &of_shear = shear_;
    bool direct_counts = false, shear_counts = false;
    // With the ranges and cycles themselves most places can be seen to be milder.
    if (direct_may) {
      histories_of(place.normal, times, of_direct);
      const double range = life_.largest_range(of_direct);
      direct_counts = range >= nothing;
      by_direct = bound_of(direct.detail->detail, range, 2.0 * reckoned_cycles * all_cycles_);
      if (together || beats(Criterion::fatigue, by_direct))
        by_direct = bound_exactly(direct.detail->detail, place.plate, per * range,
                                  2.0 * cycles_in(of_direct));
    }
    if (shear_may) {
      histories_of(place.shear, 1.0, of_shear);
      const double range = life_.largest_range(of_shear);
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
      channels.push_back(
          {life_.cycles_of(histories, reduced), rules_.curve_of(detail, place.plate)});
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

  const Project& project_;
  const std::deque<SituationRun>& runs_;
  Density density_;
  Rules rules_;
  std::vector<Run> sampled_;
  Life life_;
  std::vector<BendingZone> zones_;
  std::vector<Combination> combined_;
  std::vector<double> load_factors_;  ///< of all cuts
  std::size_t segment_ = 0;           ///< looked at
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

Findings look_everywhere(const Project& project, const std::deque<SituationRun>& runs,
                         const Density& density, const Combining& combining) {
  return Search(project, runs, density, combining).findings();
}

}  // namespace oracle
