#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"

namespace boxbeam {

/// The bodies beside the verified beam of a mechanism in space that is stopped in a state, and how
/// they and the beam are tied, in beam axes: rods and driven joints rigid, other joints free as
/// they are, springs elastic.
struct StoppedScene {
  std::vector<frame::RigidMass> bodies;  ///< in the order of the mechanism, without the beam's
  std::vector<frame::Tie> ties;
};
StoppedScene stopped_scene(const spatial::Mechanism& mechanism, const spatial::State& state,
                           const spatial::BeamPlacement& placement);

/// The six cut forces at stations, one station after the other.
Eigen::VectorXd cuts_at(const CutForceDiagram& diagram, const std::vector<Station>& stations);

/// Modes of a posture, with what a motion through it adds to their equations.
struct ModesInMotion {
  std::vector<frame::BeamMode> modes;
  Eigen::MatrixXd damping;  ///< phi^T C phi [1/s]
  frame::TurningTerms turning;
  /// Motion of the beam and of the bodies in their own axes, by roots of masses: a column per mode.
  /// Tells modes of different postures apart.
  Eigen::MatrixXd shapes;
};

/// Vibration of the verified beam of a mechanism in space, which is stopped in a posture: the beam
/// elastic, other bodies, rods and driven joints rigid, other joints free as they are, springs
/// elastic. Friction holds nothing. The beam's axial force softens or stiffens it; what presses
/// other bodies, springs and rods does not.
class StoppedVibration {
 public:
  /// `parts`: about so many pieces of the beam. `project` and `chain` stay.
  StoppedVibration(const Project& project, const spatial::Chain& chain, int parts);

  /// In the posture of a state, under the beam's cut forces then. Throws AnalysisError where the
  /// stopped mechanism is free to move, or buckles.
  std::vector<frame::BeamMode> modes(const spatial::State& state, const CutForceDiagram& rigid,
                                     std::size_t count) const;

  /// The same modes of a posture that is passed in motion.
  ModesInMotion modes_in_motion(const spatial::State& state, const CutForceDiagram& rigid,
                                std::size_t count) const;

  const frame::VibratingBeam& beam() const { return beam_; }
  const spatial::BeamPlacement& placement() const { return placement_; }

 private:
  const spatial::Chain* chain_;
  spatial::BeamPlacement placement_;
  frame::VibratingBeam beam_;
};

/// Largest part of a mode's elastic energy, in words: "bending about y", "bending about z",
/// "torsion", "stretching", "springs beside the beam".
std::string shape_of(const frame::BeamMode& mode);

/// `estimate_vibration` of a beam in space: the modes of its stopped mechanism, stresses of N, M_y
/// and M_z at the corners of the sections' extent and sqrt(3) times that of T in walls of even
/// thickness, T/sqrt(I_T A) of closed profiles, of others T sqrt(3/(I_T A)).
struct VibrationInSpace {
  VibrationEstimate estimate;
  std::string obstacle;  ///< why there is none; "" where there is
  Time lowest_at;        ///< when the first frequency is lowest
  std::string shape;     ///< of the first mode then
};

/// These stresses along a beam at the even instants of its loads, a row for each.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam);
/// The same at the even instants of another time.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam,
                                        const LoadSpan& span);

/// The largest of these stresses that a unit of each mode makes.
Eigen::VectorXd largest_stresses_in_space(const std::vector<frame::BeamMode>& modes,
                                          const TaperedBeam& beam);

/// Why nothing is estimated in any of the situations that run; "" where the motion lets it.
std::string obstacle_to_vibration_in_space(const std::deque<SituationRun>& rigid);

/// What rigid bodies were estimated to miss by vibration, of the governing stress; zero where that
/// was not estimated, and in the plane, where it decides on the model.
double vibration_missed_in_space(const Project& project, const ModelChoice& model);

/// At instants evenly spread over a run and about the lowest first frequency. Of loads whose edges
/// are steeper than the instants the frequencies alone. Precondition: forces move nothing.
VibrationInSpace estimate_vibration_in_space(const Project& project, const SituationRun& run,
                                             int parts = 8);

}  // namespace boxbeam
