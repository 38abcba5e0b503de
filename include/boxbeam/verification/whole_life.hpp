#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A stress of a place as the channels of all situations make it: for each situation that runs, in
/// their order, what does not change [Pa] and the stress for a value of one of each channel.
struct WholePlace {
  std::vector<double> factors;
  bool compression_reduced = false;
};

/// How places were counted in full, and how far estimates were from it.
struct WholeSummary {
  std::size_t instants = 0;  ///< of all records; none where every instant is looked at anyway
  std::size_t counted = 0;   ///< stresses whose cycles were counted over all instants
  /// Largest difference between an estimated utilisation and the one counted then, relative.
  double estimate_error = 0.0;
  /// By how much the largest range over all instants exceeds that over the working instants.
  double extreme_error = 0.0;
  /// Places whose estimate is this near the largest of their criterion are counted in full.
  double margin = 0.0;
};

/// The cycles of stresses under long records.
///
/// A place is counted over all instants: its stress is a sum of channels, block by block, counted
/// by rainflow as it comes. Cycles are kept in classes of a 256th of an octave, each by its mean
/// range; a sum of powers is that of the cycles to 2e-5.
///
/// Places that have not been counted are estimated. The factor on the loads at which the life is
/// used up, times a factor on a stress, is the same for all multiples of it; and it hardly depends
/// on the mixture of channels when taken for one of standard deviation one. So it is interpolated
/// between the mixtures that have been counted, by the angle between them, and meets these.
class WholeLife {
 public:
  WholeLife(const Project& project, const std::deque<SituationRun>& runs);
  WholeLife(const WholeLife&) = delete;
  WholeLife& operator=(const WholeLife&) = delete;
  ~WholeLife();

  std::size_t instants() const;

  /// The stress of an influence on the cut forces of a station, whose cut forces are given for each
  /// situation: constant, then of each channel.
  WholePlace place_of(std::span<const std::vector<CutForces>> unit_cuts,
                      const std::array<double, cut_force::count>& influence, double factor,
                      bool compression_reduced) const;

  /// Counts places over all instants, those that are not multiples of others.
  void count(const std::vector<WholePlace>& places);
  bool is_counted(const WholePlace& place) const;

  /// Those of the places that are strongest and least alike, at most so many; `strengths` are of
  /// what resists each.
  std::vector<WholePlace> unlike(const std::vector<WholePlace>& places,
                                 const std::vector<double>& strengths, std::size_t most) const;

  /// The largest factor on the loads for stresses together, each with its curve; as estimated where
  /// a place has not been counted.
  double factor_of(std::span<const std::pair<WholePlace, SnCurve>> channels) const;

  /// All cycles of the wanted life: counted, or those of the most similar place as the estimate has
  /// them.
  std::vector<SituationCycles> cycles_of(const WholePlace& place, const SnCurve& curve) const;

  WholeSummary summary;

 private:
  struct Part;
  struct Counted;
  struct Life;
  double product(const WholePlace& a, const WholePlace& b) const;
  double unlikeness(const WholePlace& a, double norm_a, const Counted& b) const;
  std::pair<const Counted*, double> parallel_to(const WholePlace& place) const;
  const Life& life_of(const Counted& counted, const SnCurve& shape) const;
  std::pair<const Life*, double> estimate(const WholePlace& place, const SnCurve& shape) const;
  void count_in_one_thread(std::span<Counted*> places) const;

  const Project* project_;
  std::vector<Part> parts_;
  std::vector<Counted> counted_;
  mutable std::vector<SnCurve> shapes_;
};

/// What counts long records, where there are any.
WholeLife* whole_life_of(const std::deque<SituationRun>& runs);
WholeLife* whole_life_of(const std::vector<SituationHistory>& histories);

/// Of each situation at their station the cut forces that do not change, then those of each channel
/// for a value of one.
std::vector<std::vector<CutForces>> unit_cuts_of(const std::vector<SituationHistory>& histories);

}  // namespace boxbeam
