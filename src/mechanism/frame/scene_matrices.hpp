#pragma once

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"

/// The matrices of a scene, by the motions of the nodes of its beams and the centres of its bodies.
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

/// From the axes of the scene to those of a beam, for the motions of the ends of a piece.
VibratingBeam::Matrix12 into_beam_axes(const PosedBeam& posed);

/// The motions that a place of a member follows rigidly.
struct Followed {
  Eigen::Index row = 0;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
};

Followed followed_by(const VibratingScene& scene, const SceneRows& rows, const Place& at);

/// A tie with what its force does to the coordinates.
struct Tied {
  const Tie* tie;
  Gap gap;
};

/// The matrices of a scene before rigid ties take motions away.
struct SceneMatrices {
  Eigen::SparseMatrix<double> springs, K, M, C;
  std::vector<Tied> held, elastic;
  std::vector<Tied> giving;  ///< of these those of joints and rods, in their order
  Eigen::VectorXd unit;      ///< shifts by the length of the longest beam, as turns
};

/// `pressed`: the beams' axial forces are in their stiffness.
SceneMatrices matrices_of(const VibratingScene& scene, const SceneRows& rows, bool pressed = true);

/// The equations of rigid ties, a column of length one for each, and their lengths before.
Eigen::SparseMatrix<double> equations_of(const std::vector<Tied>& held, const Eigen::VectorXd& unit,
                                         Eigen::VectorXd& norms);

}  // namespace boxbeam::frame
