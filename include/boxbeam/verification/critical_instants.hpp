#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/cut_force_envelope.hpp"
#include "boxbeam/verification/motion_summary.hpp"

namespace boxbeam {

/// Which extreme of its quantity an instant is.
enum class End {
  largest,
  smallest,
  neither,  ///< the stress where a yield check governs, which looks at the equivalent stress
};

/// Where and when a quantity has its extreme: a cut force over the whole beam and all situations,
/// the stress at the governing place only.
struct CriticalInstant {
  std::optional<CutForceName> force;  ///< nothing: the stress
  Station station;
  Time time;
  double value = 0.0;         ///< SI: N, N m, Pa
  std::size_t situation = 0;  ///< index in the case
  End end = End::largest;

  /// The name of its cut force, or "stress".
  std::string quantity() const { return force ? force->name : "stress"; }
};

/// Where and when the cut forces and the stress of the governing check have their extremes. The
/// checks stand worst first.
std::vector<CriticalInstant> critical_instants_of(const Project& project,
                                                  const std::vector<StationEnvelope>& stations,
                                                  const std::vector<CheckResult>& checks);

/// An instant worth drawing.
struct ShownInstant {
  std::size_t situation = 0;  ///< index in the case
  Time time;
  std::string why;  ///< "largest M, highest stress at the governing place"
  /// How telling: the largest bending moment there over the largest of all, and one more at an
  /// extreme of stress at the governing place.
  double weight = 0.0;
};

/// The distinct times of the extremes of bending and stress, in order.
std::vector<ShownInstant> instants_to_show(const Project& project,
                                           const std::vector<CriticalInstant>& instants,
                                           const std::vector<MotionSummary>& motions);

}  // namespace boxbeam
