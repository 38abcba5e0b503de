#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "stopped_scene.hpp"

namespace boxbeam {

/// Of a beam as a rigid body in a state, with `joint_wrenches` of the chain. Throws AnalysisError
/// where a load has left it.
CutForceDiagram rigid_cut_forces(const spatial::Chain& chain, const spatial::State& state,
                                 const spatial::BeamBody& beam,
                                 const std::vector<spatial::Wrench>& wrenches);

/// The six cut forces at stations, one station after the other.
Eigen::VectorXd cuts_at(const CutForceDiagram& diagram, const std::vector<Station>& stations);

/// Modes of a posture.
struct ModesOfPosture {
  frame::FactoredScene scene;
  std::vector<frame::BeamMode> modes;
  /// Motion of the beams and of the bodies in their own axes, by roots of masses: a column per
  /// mode. Tells modes of different postures apart.
  Eigen::MatrixXd shapes;
};

/// The same, with what a motion through it adds to their equations.
struct ModesInMotion {
  std::vector<frame::BeamMode> modes;
  Eigen::MatrixXd shapes;   ///< as of `ModesOfPosture`
  Eigen::VectorXd force;    ///< generalised, of the loads on the rigid beams
  Eigen::MatrixXd damping;  ///< phi^T C phi [1/s]
  Eigen::MatrixXd gaps;     ///< of springs that act from a length on, a row for each [m]
  /// Of joints, springs and rods; the rest of the damping is that of the material.
  std::vector<frame::DampedTie> dampers;
  /// What springs and joints take over from the verified beam as it bends statically, where they
  /// do (`StoppedVibration::takes_over`).
  std::optional<BeamLoads> taken_over;
  frame::TurningTerms turning;
};

/// Vibration of the beams of a mechanism in space, which is stopped in a posture: all beams of the
/// case and its rods by their section elastic, joints that have a stiffness as well, other bodies,
/// rods and drives rigid, other joints free as they are, springs elastic. Friction holds nothing.
/// Where forces move the mechanism it is free to move as far as they do (`VibratingScene`). Its
/// axial force softens or stiffens each beam and rod that is a body; what presses other bodies,
/// springs and rods without mass does not.
class StoppedVibration {
 public:
  /// `parts`: about so many pieces of the verified beam, and of each other one unless these are so
  /// many that fewer must do. `loaded`: they end where loads stand on the beams, too. `project` and
  /// `chain` stay.
  StoppedVibration(const Project& project, const spatial::Chain& chain, int parts,
                   bool loaded = false);

  /// In how many ways forces move the mechanism: so many modes may have the frequency zero.
  std::size_t freedoms() const;

  /// Whether any joint, rod or spring has a damper.
  bool is_damped() const;

  /// Whether anything can take loads over from a beam that bends: springs, or bodies that forces
  /// move.
  bool takes_over() const;

  /// In the posture of a state, `rigid` the verified beam's cut forces then. Throws AnalysisError
  /// where the stopped mechanism is free to move otherwise, or buckles. Where forces move it those
  /// modes that strain beams: as many as there are freedoms move whole bodies, which the rigid
  /// motion knows.
  std::vector<frame::BeamMode> modes(const spatial::State& state, const CutForceDiagram& rigid,
                                     std::size_t count);

  /// The lowest modes of a posture, those that move whole bodies among them; where forces move it
  /// without axial forces.
  ModesOfPosture modes_with_shapes(const spatial::State& state, const CutForceDiagram& rigid,
                                   std::size_t count);

  /// The same of a posture that is passed in motion. Where forces move it, axial forces are in what
  /// turning adds, between modes that are faster than twice the turning.
  /// `statically`: whether what is taken over is asked for.
  ModesInMotion modes_in_motion(const spatial::State& state, const CutForceDiagram& rigid,
                                std::size_t count, bool statically = true);

  /// What springs take over from the verified beam as it bends statically where drivers move the
  /// mechanism, without what axial forces do to the bent beam. `modes`: of that posture, at least
  /// one.
  BeamLoads taken_over(const spatial::State& state, const CutForceDiagram& rigid,
                       const std::vector<frame::BeamMode>& modes);

  /// What rigid bodies put in all members, joints and rods that give way where `BeamMode::work` has
  /// it; `rigid`: the cut forces of the verified beam.
  Eigen::VectorXd rigid_cuts(const spatial::State& state, const CutForceDiagram& rigid) const;

  const std::vector<spatial::BeamPlacement>& placements() const { return placements_; }
  const std::vector<int>& members() const { return members_; }  ///< as `members_of_scene`

  /// The beams with their cut forces, the bodies and how they are tied, in the posture of a state.
  frame::VibratingScene scene_in(const spatial::State& state, const CutForceDiagram& rigid) const;

 private:
  BeamLoads taken_over_in(frame::VibratingScene scene, const std::vector<frame::BeamMode>& modes,
                          const Eigen::VectorXd& cuts);
  /// The scene, and ties along springs that act from a length on.
  struct SceneWithContacts {
    frame::VibratingScene scene;
    std::vector<frame::Tie> contacts;
  };
  SceneWithContacts contacts_in(const spatial::State& state, const CutForceDiagram& rigid) const;
  ModesOfPosture modes_with_shapes(frame::VibratingScene scene, const spatial::State& state,
                                   std::size_t count);
  std::vector<frame::PosedBeam> beams_in(const spatial::State& state, const CutForceDiagram& rigid,
                                         const std::vector<spatial::Wrench>& wrenches) const;

  /// The bodies behind the beams in a scene, in its order.
  std::vector<std::size_t> bodies_of_scene() const;

  const spatial::Chain* chain_;
  GivingWay giving_;
  std::vector<spatial::BeamPlacement> placements_;  ///< the verified beam first
  std::vector<frame::VibratingBeam> beams_;         ///< likewise
  std::vector<spatial::BeamBody> beside_;           ///< the others as rigid bodies
  std::vector<int> members_;                        ///< of the scene, that bodies are
  std::vector<Eigen::Matrix3d> roots_;              ///< of the inertias of all bodies
  frame::KeptTies ties_;                            ///< of the last posture
};

}  // namespace boxbeam
