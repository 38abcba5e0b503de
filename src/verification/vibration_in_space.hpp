#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "members_in_space.hpp"

namespace boxbeam {

/// Where the elastic members of a case in space lie, the verified beam first.
std::vector<spatial::BeamPlacement> elastic_placements(const Project& project,
                                                       const spatial::Mechanism& mechanism);

/// The rigid bodies beside elastic members of a mechanism in space that is stopped in a state, and
/// how they and the members are tied, in the axes of the first of these: drives rigid, joints and
/// rods without mass rigid where they do not give way, other joints free as they are, springs
/// elastic.
struct StoppedScene {
  std::vector<frame::RigidMass> bodies;  ///< in the order of the mechanism, without the members'
  std::vector<frame::Tie> ties;
};
/// `wrenches`: `spatial::Chain::joint_wrenches` then, where something gives way.
StoppedScene stopped_scene(const spatial::Mechanism& mechanism, const spatial::State& state,
                           const std::vector<spatial::BeamPlacement>& members,
                           const GivingWay& giving = {},
                           const std::vector<spatial::Wrench>& wrenches = {});

/// Which bodies drivers and fixed joints that do not give way hold to the ground, none of these
/// beams between: in a stopped mechanism they are at rest.
std::vector<bool> resting_bodies(const spatial::Mechanism& mechanism,
                                 const std::vector<spatial::BeamPlacement>& beams,
                                 const GivingWay& giving);

/// Of a beam as a rigid body in a state, with `joint_wrenches` of the chain. Throws AnalysisError
/// where a load has left it.
CutForceDiagram rigid_cut_forces(const spatial::Chain& chain, const spatial::State& state,
                                 const spatial::BeamBody& beam,
                                 const std::vector<spatial::Wrench>& wrenches);

/// The six cut forces at stations, one station after the other.
Eigen::VectorXd cuts_at(const CutForceDiagram& diagram, const std::vector<Station>& stations);

/// Modes of a posture, with what a motion through it adds to their equations.
struct ModesInMotion {
  std::vector<frame::BeamMode> modes;
  Eigen::VectorXd force;    ///< generalised, of the loads on the rigid beams
  Eigen::MatrixXd damping;  ///< phi^T C phi [1/s]
  frame::TurningTerms turning;
  /// Motion of the beams and of the bodies in their own axes, by roots of masses: a column per
  /// mode. Tells modes of different postures apart.
  Eigen::MatrixXd shapes;
};

/// Vibration of the beams of a mechanism in space, which is stopped in a posture: all beams of the
/// case and its rods by their section elastic, joints that have a stiffness as well, other bodies,
/// rods and drives rigid, other joints free as they are, springs elastic. Friction holds nothing.
/// Its axial force softens or stiffens each beam and rod that is a body; what presses other bodies,
/// springs and rods without mass does not.
class StoppedVibration {
 public:
  /// `parts`: about so many pieces of the verified beam, and of each other one unless these are so
  /// many that fewer must do. `loaded`: they end where loads stand on the beams, too. `project` and
  /// `chain` stay.
  StoppedVibration(const Project& project, const spatial::Chain& chain, int parts,
                   bool loaded = false);

  /// In the posture of a state, `rigid` the verified beam's cut forces then. Throws AnalysisError
  /// where the stopped mechanism is free to move, or buckles.
  std::vector<frame::BeamMode> modes(const spatial::State& state, const CutForceDiagram& rigid,
                                     std::size_t count);

  /// The same modes of a posture that is passed in motion.
  ModesInMotion modes_in_motion(const spatial::State& state, const CutForceDiagram& rigid,
                                std::size_t count);

  /// What rigid bodies put in all members, joints and rods that give way where `BeamMode::work` has
  /// it; `rigid`: the cut forces of the verified beam.
  Eigen::VectorXd rigid_cuts(const spatial::State& state, const CutForceDiagram& rigid) const;

  const std::vector<spatial::BeamPlacement>& placements() const { return placements_; }
  const std::vector<bool>& resting() const { return resting_; }  ///< bodies that are the ground

  /// The beams with their cut forces, the bodies and how they are tied, in the posture of a state.
  frame::VibratingScene scene_in(const spatial::State& state, const CutForceDiagram& rigid) const;

 private:
  std::vector<frame::PosedBeam> beams_in(const spatial::State& state, const CutForceDiagram& rigid,
                                         const std::vector<spatial::Wrench>& wrenches) const;

  const spatial::Chain* chain_;
  GivingWay giving_;
  std::vector<spatial::BeamPlacement> placements_;  ///< the verified beam first
  std::vector<frame::VibratingBeam> beams_;         ///< likewise
  std::vector<spatial::BeamBody> beside_;           ///< the others as rigid bodies
  std::vector<bool> resting_;                       ///< of all bodies, which stay at rest
  std::vector<Eigen::Matrix3d> roots_;              ///< of the inertias of all bodies
  frame::KeptTies ties_;                            ///< of the last posture
};

/// Largest part of a mode's elastic energy, in words: "bending about y", "bending about z",
/// "torsion", "stretching", "springs and joints beside the beam", "other beams and rods".
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

/// What makes these stresses of the cut forces of a place.
struct PlaceInSpace {
  Station station;
  double per_N, per_M_y, per_M_z, per_T;
};
inline constexpr Eigen::Index stresses_of_place = 5;

/// `joints`: as of `compared_places_of`.
std::vector<PlaceInSpace> places_in_space(const TaperedBeam& beam,
                                          const std::vector<Length>& joints = {});

/// These stresses of one place after the other.
Eigen::RowVectorXd stresses_at(const CutForceDiagram& diagram,
                               const std::vector<PlaceInSpace>& places);

/// These stresses along a beam at the even instants of its loads, a row for each.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam);
/// The same at the even instants of another time.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam,
                                        const LoadSpan& span);

/// What modes do beside the loads of a history, relative to the largest of these stresses or of
/// their ranges, with none, one, ... of them counted, and the harmonics of what repeats; nothing
/// of a beam without stress.
struct MissedInSpace {
  std::vector<double> without_modes;
  std::vector<LoadHarmonic> harmonics;
};
/// `parts`: of each mode beyond its static one over time (`dynamic_part`), a column each.
MissedInSpace missed_in_space(const LoadHistory& history, const TaperedBeam& beam,
                              const std::vector<frame::BeamMode>& modes,
                              const Eigen::MatrixXd& parts);

/// The largest of these stresses that a unit of each mode makes.
Eigen::VectorXd largest_stresses_in_space(const std::vector<frame::BeamMode>& modes,
                                          const TaperedBeam& beam);

/// Why nothing is estimated in any of the situations that run; "" where the motion lets it.
std::string obstacle_to_vibration_in_space(const std::deque<SituationRun>& rigid);

/// What rigid bodies, or loads on a frame that act slowly, were estimated to miss by vibration, of
/// the governing stress, without second order where the model weighs it; zero where that was not
/// estimated, and of mechanisms in the plane, where it decides on the model.
double vibration_missed_in_space(const Project& project, const ModelChoice& model);

/// At instants evenly spread over a run and about the lowest first frequency. Of loads whose edges
/// are steeper than the instants the frequencies alone. Precondition: forces move nothing.
VibrationInSpace estimate_vibration_in_space(const Project& project, const SituationRun& run,
                                             int parts = 8);

}  // namespace boxbeam
