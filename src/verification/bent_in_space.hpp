#pragma once

#include <functional>
#include <optional>
#include <string>

#include "boxbeam/mechanism/frame/bent_scene.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {

/// Statics of the second order of the beams of a mechanism in space, stopped at an instant under
/// what acts in its rigid motion: weight, inertia and loads (`frame::bent_scene_of`), all of it
/// stopped as for vibration (`StoppedVibration`). Of open sections, whose warping the beams do not
/// have, N alone counts.
class BentInSpace {
 public:
  /// `parts` as of `StoppedVibration`; `project` and `chain` stay. Precondition: no obstacle.
  BentInSpace(const Project& project, const spatial::Chain& chain, int parts = 16);

  /// `rigid`: the verified beam's cut forces then; all that acts counts `factor` times in the
  /// stiffness. Nothing where it is free to move.
  std::optional<frame::BentScene> at(const spatial::State& state, const CutForceDiagram& rigid,
                                     double factor);

 private:
  const spatial::Chain* chain_;
  StoppedVibration stopped_;
  std::vector<bool> whole_;
  frame::KeptTies ties_;  ///< of the last posture
};

/// Why second order of the mechanism is not known: forces move it, a joint slides along an elastic
/// beam, or teeth mesh with one; "" where it is.
std::string obstacle_to_bending_in_space(const Project& project, const spatial::Chain& chain);

/// Loads on the beam with what static bending adds to those of rigid bodies, instant by instant.
/// `states`: at any time. Throws AnalysisError where the beam buckles or is free to move.
LoadsAt bent_statically_in_space(const Project& project, const spatial::Chain& chain,
                                 std::function<spatial::State(double)> states, int parts,
                                 LoadsAt rigid);

/// Of a situation by rigid bodies, at an instant; nothing where it is not known, and of no
/// mechanism in space.
std::optional<frame::BentScene> bent_scene_in(const SituationRun& run, Time time,
                                              const CutForceDiagram& diagram, double factor);

}  // namespace boxbeam
