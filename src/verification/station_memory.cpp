#include "boxbeam/verification/station_memory.hpp"

#include <algorithm>

#include "linear_stress.hpp"

namespace boxbeam {

const Turns& StationExtremes::turns_of(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const std::array<double, cut_force::count>& per_force,
                                       double factor) {
  std::array<double, cut_force::count + 1> at{};
  std::copy(per_force.begin(), per_force.end(), at.begin());
  at.back() = factor;
  return turns_.of(at, [&] {
    return boxbeam::turns_of(project, histories, LinearStress{&per_force, factor});
  });
}

const std::vector<TurningPoint>& StationExtremes::largest_von_mises(
    const std::vector<SituationHistory>& histories, const StressInfluence& influence) {
  std::array<double, 2 * cut_force::count> at{};
  const auto behind = std::copy(influence.normal.begin(), influence.normal.end(), at.begin());
  std::copy(influence.shear.begin(), influence.shear.end(), behind);
  return largest_.of(at, [&] {
    std::vector<TurningPoint> largest;
    for (const SituationHistory& of : histories) {
      largest.push_back(of.history.largest(
          [&](const CutForces& cut) { return stress_at(influence, cut).von_mises().value(); }));
    }
    return largest;
  });
}

LoadedStation::LoadedStation(const Project& project, const std::deque<SituationRun>& runs,
                             const Station& station, StationSamples::Keep keep)
    : histories(histories_at(runs, station)),
      samples(project, histories, keep),
      fields(StressFields::Keep::all) {}

void StationMemory::turn_to(const Project& project) {
  // Histories at so many instants, 48 bytes each.
  constexpr std::size_t most_samples = 1'000'000;
  if (kept_samples_ > most_samples) {
    known_.clear();
    kept_samples_ = 0;
  }
  project_ = &project;
  ++design_;
}

LoadedStation& StationMemory::at(const Station& station) {
  Known& known = known_[{station.s.value(), station.side}];
  if (known.station == nullptr) {
    known.station =
        std::make_unique<LoadedStation>(*project_, *runs_, station, StationSamples::Keep::found);
    for (const SituationHistory& of : known.station->histories)
      kept_samples_ += of.history.samples().size();
  } else if (known.design != design_) {
    auto run = runs_->begin();
    for (SituationHistory& of : known.station->histories) of.situation = (run++)->situation;
    known.station->samples.turn_to(*project_);
  }
  known.design = design_;
  return *known.station;
}

}  // namespace boxbeam
