#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "charts/follower.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// A topic about the planar scene, or why there is none.
TopicResult on_driven_scene(const Scenes& scenes,
                            const std::function<TopicResult(const DrivenScene&)>& topic);

/// A setting that is tried along a motion: its point but for the error, and what it came to.
struct Run {
  std::size_t series = 0;
  Point point;
  std::vector<InstantIn<long double>> instants;
  std::function<void()> work = {};  ///< the whole motion; empty: not to be timed
};

/// 1e-2 .. 1e-15; a few of them in a quick look.
std::vector<double> tolerances_of(const Effort& effort);

/// What the textbook solver is asked for.
struct NewtonSetting {
  LinearMethod method = LinearMethod::sparse;
  int order = 2;  ///< of the predictor
  bool reactions = false;
};

/// The textbook solver at tolerances.
std::vector<Run> newton_runs(const DrivenScene& scene, const ReferenceMotion& reference,
                             const NewtonSetting& setting, const std::vector<double>& tolerances);

/// The program as it is.
Run program_run(const DrivenScene& scene, const ReferenceMotion& reference);

/// Measures all of them by turns, per instant.
void time_runs(std::vector<Run>& runs, std::size_t instants, const Effort& effort);

/// Velocities and accelerations from differences of order 2 or 4 of positions `step` apart, which
/// are solved by Newton's method in double; multipliers from these accelerations.
std::vector<InstantIn<long double>> by_differences(const DrivenScene& scene,
                                                   const ReferenceMotion& reference, double step,
                                                   int order, bool reactions);

/// A chart of these differences over the instants per motion: of accelerations or reactions.
Chart differences_chart(const DrivenScene& scene, const ReferenceMotion& reference,
                        Quantity quantity, const Effort& effort);

/// The point of a run with its error in a quantity; a failure where that is no number.
Point point_of(const Run& run, const ErrorOf& error_of, Quantity quantity);

}  // namespace boxbeam::charts
