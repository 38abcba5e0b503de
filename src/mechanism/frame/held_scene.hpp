#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "condensed_chain.hpp"
#include "rigid_ties.hpp"
#include "scene_matrices.hpp"

namespace boxbeam::frame {

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
