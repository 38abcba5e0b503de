#pragma once

#include <Eigen/Core>
#include <optional>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "held_scene.hpp"

/// What acts in a scene whose nodes and bodies are moved, by coordinates (`SceneRows`).
namespace boxbeam::frame {

/// From the axes of the scene to those of a beam, of both ends of a piece.
VibratingBeam::Matrix12 into_beam_axes(const PosedBeam& posed);

/// What the axial force in a piece adds to its stiffness, and that where the scene counts it.
VibratingBeam::Matrix12 geometric_stiffness_of(const PosedBeam& posed,
                                               const VibratingBeam::Piece& piece);
VibratingBeam::Matrix12 pressed_stiffness_of(const VibratingScene& scene, const PosedBeam& posed,
                                             const VibratingBeam::Piece& piece);

/// Calls f(block, row) for the diagonal blocks of a scene, which overlap along beams: 12 rows of a
/// piece, 6 of a body.
template <class OfPiece, class OfBody>
void each_block(const VibratingScene& scene, const SceneRows& rows, const OfPiece& of_piece,
                const OfBody& of_body) {
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    Eigen::Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : scene.beams[b].beam->pieces()) {
      of_piece(scene.beams[b], piece, row);
      row += 6;
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    of_body(scene.bodies[b], rows.bodies + static_cast<Eigen::Index>(6 * b));
}

/// Forces that give a scene these accelerations, a column for each.
Eigen::MatrixXd inertia_of(const VibratingScene& scene, const SceneRows& rows,
                           const Eigen::MatrixXd& accelerations);

/// Forces of elasticity and of viscosity.
struct ForcesOfMotion {
  Eigen::VectorXd elastic, viscous;
};
ForcesOfMotion forces_of(const HeldScene& held, const Eigen::VectorXd& moved);

/// The motions of modes, in the axes of the scene, and as coordinates; a column for each.
Eigen::MatrixXd motions_of(const std::vector<BeamMode>& modes);
Eigen::MatrixXd in_beam_axes(const VibratingScene& scene, const SceneRows& rows,
                             Eigen::MatrixXd motions);

/// A scene that is moved by forces and by the inertia of accelerations, elastically; `applied`: on
/// the coordinates, but for that inertia.
struct MovedScene {
  Eigen::VectorXd moved, accelerations, applied;
};

/// What acts on the first beam in it, but for what is applied, is added to nothing: line loads and
/// cut forces of every piece, and the forces of ties. `elastic`: as of `forces_of`.
void add_loads_on_first(const HeldScene& held, const MovedScene& of, const Eigen::VectorXd& elastic,
                        BeamLoads& loads, CutForceDiagram& cut);

/// Adds the load on the first beam of a tie whose force is so large.
void add_tie_load(const HeldScene& held, const Tie& tie, double force, BeamLoads& loads);

/// A number for each of the ways in which a scene may move without force: K + shift M is its
/// stiffness then, with the same modes; none where it stands by itself. Near the square of a
/// frequency of its beams [1/s^2].
double shift_of(const VibratingScene& scene);

/// Factored with its shift; nothing where it moves without force or mass, or buckles. `holding`: as
/// of `HeldScene::standing`.
std::optional<StandingScene> standing_with(const HeldScene& held, double shift,
                                           const Eigen::MatrixXd& holding = {});

/// Throws the AnalysisError of a scene that does not stand.
[[noreturn]] void refuse_to_stand(const VibratingScene& scene);

/// Stays where it is made, for its parts look at each other.
struct FactoredScene::Factors {
  Factors(VibratingScene of, KeptTies& last);
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  VibratingScene scene;
  HeldScene held;
  double shift;                           ///< `shift_of`
  std::optional<StandingScene> standing;  ///< with it; nothing where no motion is free
};

}  // namespace boxbeam::frame
