#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"

namespace boxbeam::frame {

/// What presses, pulls, bends and twists the members of a scene beside the cut forces of its beams,
/// in the axes of the scene.
struct SceneStress {
  /// A force of lasting direction on a place of a member [N].
  struct Force {
    Place at;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
  };
  /// A line without mass between two places, under its tension [N]; what it does to them stands
  /// among the forces.
  struct Line {
    Place a, b;
    double tension = 0.0;
  };
  std::vector<Force> forces;
  std::vector<Line> lines;
  /// Of each beam, whether moments, shear forces and torque count beside its axial force.
  std::vector<bool> whole;
};

/// How a scene bends statically under its loads.
struct BentScene {
  /// It buckles under so many times its loads, fewer than were asked for, to 1e-3 of itself; then
  /// nothing else is known.
  std::optional<double> critical;
  Eigen::VectorXd motion;  ///< as `BeamMode::motion` [m, rad]
  /// What this adds to what acts on the first beam, in balance: changes of the ties' forces, and
  /// forces and couples per length, so that cut moments and shear forces, cubic on every piece, are
  /// those about and along the axes of the turned sections. N stands along the straight axis.
  BeamLoads loads;
  double turn = 0.0;  ///< largest of a section of the first beam about any axis [rad]
};

/// Solves (K + factor K_g) u = int B^T c ds, c the cut forces of the rigid beams in balance with
/// all that acts: statics of the second order about the rigid posture. From the second variation of
/// the work of all forces there, theta a vector of turn,
///
///     beams        int N (v'^2 + w'^2)/2 + theta_x (V_y (w' + theta_y/2) - V_z (v' - theta_z/2))
///                      - M . (theta x theta')/2 ds
///     forces       (theta^2 F . a - F . theta a . theta)/2,  a from what turns to where F acts
///     lines        S/l g^2/2,  g the gap across
///
/// Forces keep their direction, couples are semitangential. Slopes v', w' are those of the axis
/// with shear. Of beams that are not `whole` N alone counts. Left out: bending before (K is that of
/// the straight beam), shortening, warping, N r^2 theta_x'^2 (Wagner), that a guide's force turns
/// with the guide, and a hinge's couple with the hinge while it turns in it. Nothing where
/// something is free to move. `scene.beams`: with their cut forces; `last` as of `modes_of`.
/// Sources: Argyris, Computer Methods in Applied Mechanics and Engineering 32 (1982); Simo,
/// Vu-Quoc, ibid. 58 (1986), strains of the beam; Przemieniecki, Theory of Matrix Structural
/// Analysis (1968), chapter 15.
std::optional<BentScene> bent_scene_of(const VibratingScene& scene, const SceneStress& stress,
                                       double factor, KeptTies& last);

}  // namespace boxbeam::frame
