#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

#include "boxbeam/numerics/exact_memo.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "boxbeam/verification/turning_samples.hpp"

namespace boxbeam {

class WholeLife;

/// Utilisation by criterion; 0 where it does not look at a place.
class Utilisations {
 public:
  double& of(Criterion criterion) { return values_[static_cast<std::size_t>(criterion)]; }
  double of(Criterion criterion) const { return values_[static_cast<std::size_t>(criterion)]; }

 private:
  std::array<double, criteria.size()> values_{};
};

/// Some of the criteria.
class CriterionSet {
 public:
  constexpr CriterionSet(std::initializer_list<Criterion> of) {
    for (const Criterion criterion : of) add(criterion);
  }
  constexpr void add(Criterion criterion) { bits_ |= bit_of(criterion); }
  constexpr bool has(Criterion criterion) const { return (bits_ & bit_of(criterion)) != 0; }

 private:
  static constexpr std::uint32_t bit_of(Criterion criterion) {
    return std::uint32_t{1} << static_cast<unsigned>(criterion);
  }
  static_assert(criteria.size() <= 32);
  std::uint32_t bits_ = 0;
};

/// The criteria of the beam's stresses, which every place along it and around it is judged by.
inline constexpr std::array stress_criteria{Criterion::yield,         Criterion::fatigue,
                                            Criterion::shear_fatigue, Criterion::combined_fatigue,
                                            Criterion::stress_range,  Criterion::weld};

/// The instants at which a history is known: those of the loads, and both sides of each passage of
/// a load that slides over the station.
struct SampledInstants {
  std::vector<double> times;  ///< [s]
  std::vector<bool> begins;   ///< something jumps or bends between an instant and the one before it
  bool closed = true;
  double period = 0.0;  ///< [s]
};

/// The cut forces of one station at the instants of every motion, against which many places of its
/// section are judged.
///
/// It is the same judgement as that of the checks: the cycles of the whole life by rainflow
/// counting, their curves and partial factors, load factors. Only the extremes over time are not
/// solved for but those of the parabola through each extreme instant and its neighbours, so that a
/// place costs little; what lies between instants belongs to the loads and hardly changes from one
/// place to the next. Places that come near the largest are then checked exactly. Of long records
/// the fatigue is as far as it has been counted, and estimated from that. Not for several threads
/// at once.
class StationSamples {
 public:
  /// Whether what the cut forces do to stresses is kept, for designs under the same loads.
  enum class Keep { nothing, found };

  StationSamples(const Project& project, const std::vector<SituationHistory>& histories,
                 Keep keep = Keep::nothing);

  /// The same station of another design whose situations run as this one's do.
  void turn_to(const Project& project);

  /// Utilisations of a point by the criteria asked for.
  Utilisations judge(const StressPoint& point,
                     CriterionSet by = {Criterion::yield, Criterion::fatigue,
                                        Criterion::shear_fatigue, Criterion::combined_fatigue,
                                        Criterion::stress_range, Criterion::weld}) const;

  /// The same where the point's stress is that of another influence.
  Utilisations judge(const StressPoint& point, const StressInfluence& influence,
                     CriterionSet by) const;

  /// The turning points of a shear stress in every situation.
  Turns shear_turns_of(const StressInfluence& influence) const;

  /// The largest value of a cut force, or with sign -1 of its negative [N or N m].
  double largest_cut_force(cut_force::Index which, double sign) const;

  /// The largest use by the cut forces, load factors counted. Asks for the use of every instant, in
  /// the same order every time.
  double largest_use(const CutForceFunction& use) const;

 private:
  struct Run {
    std::size_t situation = 0;
    double load_factor = 1.0;
    SampledInstants instants;
    std::vector<std::vector<double>> cuts;  ///< each cut force that acts, over the instants
  };

  /// What the cut forces do to a stress, load factors counted. Its keys in the memo: the stresses
  /// per cut force, the factor of the detail, and which of these are looked at.
  struct Effect {
    double equivalent = 0.0, throat = 0.0;  ///< the largest [Pa]
    Turns direct, shear;
  };
  struct Looked {
    bool direct = false, along = false, yield = false, weld = false;
  };
  void take_samples(const StationHistory& history, Run& run) const;
  void find_effect(const StressInfluence& influence, double factor, const Looked& at,
                   Effect& effect) const;
  const Effect& effect_of(const StressInfluence& influence, double factor, const Looked& at) const;
  void find_stresses(const Run& run, const std::array<double, cut_force::count>& factors,
                     std::vector<double>& stresses) const;
  const SnLine& line_of(const Detail& detail, const std::shared_ptr<const BeamDetail>& kept) const;

  const Project* project_;
  std::vector<Run> runs_;
  std::vector<std::size_t> acting_;                ///< the cut forces that are not always zero
  const WholeLife* whole_ = nullptr;               ///< of long records, which judges their fatigue
  std::vector<std::vector<CutForces>> unit_cuts_;  ///< then, of each run

  /// Room for the stresses of one judgement, of which a station has thousands.
  struct Room {
    std::vector<double> normal, shear, together;
    TurningSamples turning;
    Effect effect;
    std::array<std::vector<Cycle>, 2> cycles;
  };
  mutable Room room_;
  Keep keep_ = Keep::nothing;
  mutable ExactMemo<2 * cut_force::count + 2, Effect> effects_;

  /// The lines of the details met so far; `kept` holds one that is no part of the case.
  struct Line {
    const Detail* detail;
    std::shared_ptr<const BeamDetail> kept;
    SnLine line;
  };
  mutable std::deque<Line> lines_;
};

}  // namespace boxbeam
