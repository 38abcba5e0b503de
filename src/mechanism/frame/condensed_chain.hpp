#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "rigid_arms.hpp"

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

}  // namespace boxbeam::frame
