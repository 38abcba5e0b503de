#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "rigid_arms.hpp"
#include "rigid_ties.hpp"
#include "scene_matrices.hpp"

namespace boxbeam::frame {

/// A chain of pieces between nodes of six motions each, of which those that are not kept are
/// eliminated, one node i between what is left at a and the next node j after the other:
///
///     K_aj = [K_aa 0; 0 K_jj] - [K_ai; K_ji] K_ii^-1 [K_ia K_ij]
///
/// Exact for forces at any node. Source: Przemieniecki, Theory of Matrix Structural Analysis
/// (1968), chapter 9.
class CondensedChain {
 public:
  using Matrix12 = VibratingBeam::Matrix12;

  /// Of the stiffness of each piece; the first and the last node are kept. Nothing where a node
  /// that is not moves against forces: of the whole matrix positive eigenvalues are those of all
  /// K_ii and of what is left. Source: Haynsworth, Linear Algebra and its Applications 1 (1968).
  static std::optional<CondensedChain> of(const std::vector<Matrix12>& pieces,
                                          const std::vector<bool>& kept);

  /// What is left between two kept nodes.
  struct Stretch {
    std::size_t from, to;
    Matrix12 stiffness;
  };
  const std::vector<Stretch>& stretches() const { return stretches_; }

  /// Adds to the forces on kept nodes what those on the others do there; six rows a node.
  void carry_to_kept(Eigen::Ref<Eigen::MatrixXd> forces) const;
  /// Motions of kept nodes are known; at the others stand these forces, and then their motions.
  void move_between(Eigen::Ref<Eigen::MatrixXd> motions) const;

 private:
  struct Eliminated {
    std::size_t from, node;                ///< the next node is its other neighbour
    Matrix6 flexibility;                   ///< K_ii^-1
    Eigen::Matrix<double, 6, 12> follows;  ///< K_ii^-1 [K_ia K_ij]
  };
  std::vector<Eliminated> eliminated_;
  std::vector<Stretch> stretches_;
};

class StandingScene;

/// The stiffness of a scene without its ties.
struct SceneStiffness {
  /// Of each beam, of its pieces.
  std::vector<std::vector<VibratingBeam::Matrix12>> pieces;
  MatrixSum beside;  ///< between nodes and bodies that are kept
};

/// A scene as its ties hold it: nodes of its beams that nothing takes hold of move as their
/// neighbours do, and of the others, which are kept like all bodies, ties leave some motions free.
class HeldScene {
 public:
  /// `pushed`: what takes hold of members beside ties. `scene` stays.
  HeldScene(const VibratingScene& scene, const std::vector<Place>& pushed, KeptTies& last);

  const VibratingScene& scene() const { return *scene_; }
  const SceneRows& rows() const { return rows_; }
  const SceneTies& ties() const { return ties_; }
  /// How many motions are free.
  Eigen::Index free() const { return rows_.size - size_ + rigidly_->free(); }
  /// Of a row of what is kept, its row in what is kept.
  Eigen::Index kept_row(Eigen::Index row) const {
    return place_[static_cast<std::size_t>(row / 6)];
  }

  /// Its elastic ties, beside the pieces.
  MatrixSum elastic_ties() const;
  /// Sizes of rigid ties that do these forces.
  Eigen::VectorXd tie_forces(const Eigen::VectorXd& on_coordinates) const;

  /// Factored; nothing where it moves without force or buckles. `holding`: forces on what is kept,
  /// a column for each; it is held besides against them, as stiff as its stiffest.
  std::optional<StandingScene> standing(const SceneStiffness& stiffness,
                                        const Eigen::MatrixXd& holding = {}) const;

 private:
  friend class StandingScene;

  /// Forces on what is kept, shifts as turns.
  Eigen::MatrixXd on_kept(const Eigen::MatrixXd& forces) const;

  const VibratingScene* scene_;
  SceneRows rows_;
  SceneTies ties_;
  std::vector<std::vector<bool>> kept_;  ///< of each beam, of its nodes
  std::vector<Eigen::Index> place_;      ///< of every six coordinates among those kept, or -1
  Eigen::Index size_ = 0;                ///< of those kept
  Eigen::VectorXd norms_;                ///< lengths of the equations of rigid ties
  std::optional<RigidTies> rigidly_;
};

/// A scene that stands: its stiffness, factored.
class StandingScene {
 public:
  /// What forces on the coordinates move, a column for each; what they do at rigid ties is done.
  Eigen::MatrixXd moved_by(Eigen::MatrixXd forces) const;
  /// The largest of its diagonal before anything is eliminated, shifts as turns.
  double stiffest() const { return stiffest_; }

 private:
  friend class HeldScene;
  explicit StandingScene(const HeldScene& held) : held_(&held) {}

  const HeldScene* held_;
  std::vector<CondensedChain> chains_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  double stiffest_ = 0.0;
};

}  // namespace boxbeam::frame
