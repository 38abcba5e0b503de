#include <Eigen/LU>
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

/// What is moved beside modes that are followed, by forces that do no work in them, K y = f. Where
/// K has no inverse, or nearly none, the scene is held besides against its softest modes phi, by c
/// h h^T: y = y' + z a then, both without modes,
///
///     y' = (K + c h h^T)^-1 f,   z = (K + c h h^T)^-1 h,   phi^T M (y' + z a) = 0
class MovedBeside {
 public:
  /// `motions`: of the modes, as coordinates, the softest first.
  MovedBeside(const FactoredScene::Factors& of, const MatrixXd& motions)
      : standing_(&*of.standing) {
    if (of.scene.may_move == 0) return;
    const auto soft = std::min(static_cast<Index>(of.scene.may_move), motions.cols());
    const SceneRows& rows = of.held.rows();
    MatrixXd holding = MatrixXd::Zero(rows.size, soft);
    for (Index row = 0; row < rows.size; ++row) {
      const double unit = unit_of_row(row, of.held.ties().length);
      if (of.held.kept_row(row) >= 0)
        holding.row(row) = motions.row(row).head(soft) / (unit * unit);
    }
    besides_ = standing_with(of.held, 0.0, holding);
    if (!besides_) refuse_to_stand(of.scene);
    standing_ = &*besides_;
    inertia_ = inertia_of(of.scene, rows, motions.leftCols(soft));
    by_holding_ = besides_->moved_by(holding);
  }
  MovedBeside(const MovedBeside&) = delete;
  MovedBeside& operator=(const MovedBeside&) = delete;

  MatrixXd moved_by(const MatrixXd& forces) const {
    MatrixXd moved = standing_->moved_by(forces);
    if (!besides_) return moved;
    const MatrixXd of_holding = inertia_.transpose() * by_holding_;
    return moved - by_holding_ * of_holding.partialPivLu().solve(inertia_.transpose() * moved);
  }

 private:
  std::optional<StandingScene> besides_;
  const StandingScene* standing_;
  MatrixXd inertia_;     ///< of the softest modes
  MatrixXd by_holding_;  ///< z
};

/// What forces move, by modes that are followed and by all others. Of a scene that stands by itself
/// modes are not asked, which may be those of another stiffness.
VectorXd moved_statically(const HeldScene& held, const std::vector<BeamMode>& modes,
                          const MatrixXd& motions, const MovedBeside& beside,
                          const VectorXd& forces) {
  if (held.scene().may_move == 0) return beside.moved_by(forces);
  const VectorXd work = motions.transpose() * forces;
  VectorXd of_modes(work.size());
  for (Index j = 0; j < work.size(); ++j) {
    const double omega = full_turn * modes[static_cast<std::size_t>(j)].frequency;
    of_modes[j] = omega > 0.0 ? work[j] / (omega * omega) : 0.0;
  }
  const VectorXd left = forces - inertia_of(held.scene(), held.rows(), motions * work);
  return motions * of_modes + beside.moved_by(left);
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

std::vector<DampedTie> damped_ties_of(const HeldScene& held, const MatrixXd& motions,
                                      const MovedBeside& beside) {
  const SceneRows& rows = held.rows();
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
    pulled.moved =
        beside.moved_by(pulled.applied - inertia_of(held.scene(), rows, pulled.accelerations));
    CutForceDiagram cut;
    add_loads_on_first(held, pulled, forces_of(held, pulled.moved).elastic, of.loads, cut);
    add_tie_load(held, *tied.tie, -1.0, of.loads);
  }
  return all;
}

BeamLoads taken_over_of(const HeldScene& held, const VectorXd& cuts,
                        const std::vector<BeamMode>& modes, const MatrixXd& motions,
                        const MovedBeside& beside) {
  const VectorXd forces = straining_forces(held, cuts),
                 moved = moved_statically(held, modes, motions, beside, forces);
  BeamLoads loads;
  // On the modes' pieces nothing but ties acts.
  loads.lines = modes.front().loads.lines;
  unload(loads.lines);
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

}  // namespace

StaticParts static_parts_of(const FactoredScene& factored, const std::vector<BeamMode>& modes,
                            const std::optional<VectorXd>& cuts) {
  const FactoredScene::Factors& of = factored.factors();
  const std::vector<Tie>& ties = of.scene.ties;
  const bool damped = std::any_of(ties.begin(), ties.end(), is_damped);
  StaticParts parts;
  if (modes.empty() || (!damped && !cuts)) return parts;
  const MatrixXd motions = in_beam_axes(of.scene, of.held.rows(), motions_of(modes));
  const MovedBeside beside(of, motions);
  parts.dampers = damped_ties_of(of.held, motions, beside);
  if (cuts) parts.taken_over = taken_over_of(of.held, *cuts, modes, motions, beside);
  return parts;
}

}  // namespace boxbeam::frame
