#include <algorithm>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "moved_scene.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_damped(const Tie& tie) { return tie.damping > 0.0; }

/// What forces move that do no work in the modes that are followed. With a shift each round leaves
/// of every other mode the part that the shift is of its square with it.
VectorXd moved_by_others(const HeldScene& held, const StandingScene& standing, double shift,
                         const VectorXd& forces) {
  constexpr int most_rounds = 100;
  constexpr double same = 1e-15;
  VectorXd moved = VectorXd::Zero(forces.size());
  for (int round = 0; round < most_rounds; ++round) {
    const VectorXd before = moved;
    moved = standing.moved_by(forces + shift * inertia_of(held.scene(), held.rows(), before));
    if (shift == 0.0 || (moved - before).norm() <= same * moved.norm()) break;
  }
  return moved;
}

/// What forces move of a scene that stands with a shift alone: of the modes that are given, all
/// that are soft, by their frequencies, and of the others.
VectorXd moved_beside_shift(const HeldScene& held, const StandingScene& standing, double shift,
                            const std::vector<BeamMode>& modes, const VectorXd& forces) {
  const MatrixXd motions = in_beam_axes(held.scene(), held.rows(), motions_of(modes));
  const VectorXd work = motions.transpose() * forces;
  VectorXd of_modes(work.size());
  for (Index j = 0; j < work.size(); ++j) {
    const double omega = full_turn * modes[static_cast<std::size_t>(j)].frequency;
    of_modes[j] = omega > 0.0 ? work[j] / (omega * omega) : 0.0;
  }
  const VectorXd left = forces - inertia_of(held.scene(), held.rows(), motions * work);
  return motions * of_modes + moved_by_others(held, standing, shift, left);
}

/// B^T c: the forces on the coordinates that strain as these cut forces do.
VectorXd straining_forces(const HeldScene& held, const VectorXd& cuts) {
  VectorXd forces = VectorXd::Zero(held.rows().size);
  Index at = 0;
  each_block(
      held.scene(), held.rows(),
      [&](const PosedBeam&, const VibratingBeam::Piece& piece, Index row) {
        for (const VibratingBeam::Sample& sample : piece.samples) {
          forces.segment<12>(row) +=
              sample.weight * sample.strain.transpose() * cuts.segment<6>(at);
          at += 6;
        }
      },
      [](const RigidMass&, Index) {});
  for (const Tied& tied : held.ties().giving) {
    for (const auto& [row, per] : tied.gap.parts)
      forces.segment<6>(row) += cuts[at + tied.tie->way()] * per;
    at += 6;
  }
  return forces;
}

}  // namespace

std::vector<DampedTie> damped_ties_of(const VibratingScene& scene,
                                      const std::vector<BeamMode>& modes, KeptTies& last) {
  if (std::none_of(scene.ties.begin(), scene.ties.end(), is_damped)) return {};
  const HeldScene held(scene, {}, last);
  const SceneRows& rows = held.rows();
  const double shift = shift_of(scene);
  const auto standing = standing_with(held, shift);
  if (!standing) refuse_to_stand(scene);
  const MatrixXd motions = in_beam_axes(scene, rows, motions_of(modes));
  std::vector<DampedTie> all;
  for (const Tied& tied : held.ties().elastic) {
    if (!is_damped(*tied.tie)) continue;
    DampedTie& of = all.emplace_back();
    of.damping = tied.tie->damping;
    MovedScene pulled{VectorXd::Zero(rows.size), VectorXd::Zero(rows.size),
                      VectorXd::Zero(rows.size)};
    for (const auto& [row, per] : tied.gap.parts) pulled.applied.segment<6>(row) -= per;
    of.gaps = -(motions.transpose() * pulled.applied);
    pulled.accelerations = -(motions * of.gaps);
    pulled.moved = moved_by_others(held, *standing, shift,
                                   pulled.applied - inertia_of(scene, rows, pulled.accelerations));
    CutForceDiagram cut;
    add_loads_on_first(held, pulled, forces_of(held, pulled.moved).elastic, of.loads, cut);
    add_tie_load(held, *tied.tie, -1.0, of.loads);
  }
  return all;
}

BeamLoads taken_over_of(const VibratingScene& scene, const VectorXd& cuts,
                        const std::vector<BeamMode>& modes, KeptTies& last) {
  const HeldScene held(scene, {}, last);
  const double shift = shift_of(scene);
  const auto standing = standing_with(held, shift);
  if (!standing) refuse_to_stand(scene);
  const VectorXd forces = straining_forces(held, cuts),
                 moved = shift > 0.0 ? moved_beside_shift(held, *standing, shift, modes, forces)
                                     : standing->moved_by(forces).col(0);
  BeamLoads loads;
  // On the modes' pieces nothing but ties acts.
  loads.lines = modes.front().loads.lines;
  for (LineLoad& line : loads.lines) {
    line.force = {};
    line.couple = {};
  }
  const VectorXd sizes = held.tie_forces(forces_of(held, moved).elastic - forces);
  const SceneTies& ties = held.ties();
  for (std::size_t t = 0; t < ties.held.size(); ++t)
    add_tie_load(held, *ties.held[t].tie,
                 ties.held[t].tie->rigid.value_or(0.0) + sizes[static_cast<Index>(t)], loads);
  for (const Tied& tied : ties.elastic)
    add_tie_load(held, *tied.tie,
                 tied.tie->rigid.value_or(0.0) - tied.tie->stiffness * tied.gap.of(moved), loads);
  return loads;
}

}  // namespace boxbeam::frame
