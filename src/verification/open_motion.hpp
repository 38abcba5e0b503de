#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/transient_response.hpp"

namespace boxbeam {

/// A motion that does not repeat, as what vibrates in it sees it.
struct OpenMotion {
  double begin = 0.0, length = 0.0;  ///< [s]
  std::size_t instants = 0;          ///< equal steps of it
  /// With both ends the times between at which loads may jump or bend, ascending [s].
  std::vector<double> borders;
  /// Whether drivers hold it at its begin and at its end, where no body moves: there it is held,
  /// before and behind.
  bool rests_before = false, rests_behind = false;

  double end() const { return begin + length; }
  double step() const { return length / static_cast<double>(instants); }
  /// A time before it, and one behind.
  double before() const { return begin - length; }
  double behind() const { return end() + length; }
};

OpenMotion open_motion_of(const planar::Mechanism& mechanism, const planar::Motion& motion);

/// At which of the borders, but for the ends, others act behind than before; between two of them
/// the same act.
std::vector<double> changes_between(const std::vector<double>& borders,
                                    const std::function<std::vector<bool>(double time)>& acting_at);

/// Adds to borders when others begin or end to act between them, looked for in steps of this
/// length, and in eight at least [s].
void add_borders_between(const std::function<std::vector<bool>(double time)>& acting_at,
                         double longest, std::vector<double>& borders);

/// `span`: of the loads of rigid bodies.
OpenMotion open_motion_of(const spatial::Chain& chain, const LoadSpan& span);
/// The motion of a run in the plane or in space, or the time of a frame's loads; nothing where it
/// repeats.
std::optional<OpenMotion> open_motion_of(const Project& project, const SituationRun& run);

/// What follows a static balance without a free vibration where a motion begins, with its rate: at
/// rest that of the mechanism held there; under way, where bodies move already, as it changes then.
ModalState state_at_begin(const OpenMotion& motion,
                          const std::function<Eigen::VectorXd(double time)>& balance_at);

}  // namespace boxbeam
