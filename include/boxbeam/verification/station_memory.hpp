#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxbeam/numerics/exact_memo.hpp"
#include "boxbeam/verification/cut_force_envelope.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

/// What the cut forces of a station do to stresses, found once for all points and designs that have
/// the same: it follows from the loads and from the stresses per cut force, by whose bits it is
/// kept, and from nothing else.
class StationExtremes {
 public:
  /// Of a stress that is linear in the cut forces, times a factor, as `turns_of`.
  const Turns& turns_of(const Project& project, const std::vector<SituationHistory>& histories,
                        const std::array<double, cut_force::count>& per_force, double factor);
  /// In each situation the largest equivalent stress, load factors not counted.
  const std::vector<TurningPoint>& largest_von_mises(const std::vector<SituationHistory>& histories,
                                                     const StressInfluence& influence);

 private:
  ExactMemo<cut_force::count + 1, Turns> turns_;
  ExactMemo<2 * cut_force::count, std::vector<TurningPoint>> largest_;
};

/// A station under the loads of all situations.
struct LoadedStation {
  LoadedStation(const Project& project, const std::deque<SituationRun>& runs,
                const Station& station, StationSamples::Keep keep = StationSamples::Keep::nothing);
  LoadedStation(const LoadedStation&) = delete;
  LoadedStation& operator=(const LoadedStation&) = delete;

  std::vector<SituationHistory> histories;
  StationSamples samples;
  StationExtremes extremes;
  std::optional<StationEnvelope> envelope;
  StressFields fields;  ///< of sections that the station has had
};

/// The stations of one beam at which it has been judged, for designs under the same loads. Not for
/// several threads at once.
class StationMemory {
 public:
  /// Looks at the runs, which stay.
  explicit StationMemory(const std::deque<SituationRun>& runs) : runs_(&runs) {}

  /// From now on the stations are those of this design, whose situations run as they do.
  void turn_to(const Project& project);

  /// Stays until the next design.
  LoadedStation& at(const Station& station);

 private:
  struct Known {
    std::unique_ptr<LoadedStation> station;
    std::size_t design = 0;  ///< whose situations it looks at
  };

  const std::deque<SituationRun>* runs_;
  const Project* project_ = nullptr;
  std::size_t design_ = 0;
  std::size_t kept_samples_ = 0;
  std::map<std::pair<double, Side>, Known> known_;
};

}  // namespace boxbeam
