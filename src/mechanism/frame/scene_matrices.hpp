#pragma once

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "rigid_arms.hpp"

/// The equations of a scene, by the motions of the nodes of its beams, in the axes of each, and of
/// the centres of its bodies, in those of the scene.
namespace boxbeam::frame {

/// A sparse matrix as the sum of blocks.
struct MatrixSum {
  std::vector<Eigen::Triplet<double>> entries;

  template <class Block>
  void add(Eigen::Index row, Eigen::Index column, const Eigen::MatrixBase<Block>& block) {
    const typename Block::PlainObject values = block;
    for (Eigen::Index c = 0; c < values.cols(); ++c)
      for (Eigen::Index r = 0; r < values.rows(); ++r)
        if (values(r, c) != 0.0) entries.emplace_back(row + r, column + c, values(r, c));
  }
  Eigen::SparseMatrix<double> of_size(Eigen::Index rows, Eigen::Index columns) const {
    Eigen::SparseMatrix<double> sum(rows, columns);
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
  }
};

/// What a tie's force does to the coordinates: six from each place on.
struct Gap {
  std::vector<std::pair<Eigen::Index, Vector6>> parts;

  void add(Eigen::Index at, const Vector6& per) {
    for (auto& [same, sum] : parts) {
      if (same != at) continue;
      sum += per;
      return;
    }
    parts.emplace_back(at, per);
  }
  double of(const Eigen::VectorXd& motion) const {
    double sum = 0.0;
    for (const auto& [at, per] : parts) sum += per.dot(motion.segment<6>(at));
    return sum;
  }
};

/// Where the motions of a scene's members stand: six for every node and body.
struct SceneRows {
  std::vector<Eigen::Index> beams;  ///< the first of each
  Eigen::Index bodies = 0, size = 0;
};

SceneRows rows_of(const VibratingScene& scene);

/// The motions that a place of a member follows rigidly.
struct Followed {
  Eigen::Index row = 0;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of the motions, as columns
};

Followed followed_by(const VibratingScene& scene, const SceneRows& rows, const Place& at);

/// Coordinates as shifts and turns in the axes of the scene.
Eigen::VectorXd in_scene_axes(const VibratingScene& scene, const SceneRows& rows,
                              Eigen::VectorXd coordinates);

Gap gap_of(const VibratingScene& scene, const SceneRows& rows, const Tie& tie);

/// A tie with what its force does to the coordinates.
struct Tied {
  const Tie* tie;
  Gap gap;
};

/// The ties of a scene.
struct SceneTies {
  std::vector<Tied> held, elastic;
  std::vector<Tied> giving;  ///< of these those of joints and rods, in their order
  double length = 0.0;       ///< shifts by that of the longest beam, as turns
};

/// `stiff_as_rigid` is measured in the axes of the beams.
SceneTies ties_of(const VibratingScene& scene, const SceneRows& rows);

/// So many times as much counts a coordinate beside turns.
inline double unit_of_row(Eigen::Index row, double length) { return row % 6 < 3 ? length : 1.0; }

}  // namespace boxbeam::frame
