#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "geometric_stiffness.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Sparse = Eigen::SparseMatrix<double>;

/// What an axial force, tension positive, adds to the stiffness of a piece of length h against its
/// shift across and its turn at both ends, (w, dw/ds) at each.
Eigen::Matrix4d geometric_stiffness(double force, double h) {
  Eigen::Matrix4d of;
  of << 36.0, 3.0 * h, -36.0, 3.0 * h,         //
      3.0 * h, 4.0 * h * h, -3.0 * h, -h * h,  //
      -36.0, -3.0 * h, 36.0, -3.0 * h,         //
      3.0 * h, -h * h, -3.0 * h, 4.0 * h * h;
  return force / (30.0 * h) * of;
}

/// F^-1 of the components that the frame has.
Matrix6 stiffness_of(const Matrix6& flexibility, std::span<const Index> cuts) {
  Eigen::MatrixXd F(cuts.size(), cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    for (std::size_t j = 0; j < cuts.size(); ++j)
      F(static_cast<Index>(i), static_cast<Index>(j)) = flexibility(cuts[i], cuts[j]);
  }
  const Eigen::MatrixXd inverse = F.inverse();
  Matrix6 K = Matrix6::Zero();
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    for (std::size_t j = 0; j < cuts.size(); ++j)
      K(cuts[i], cuts[j]) = inverse(static_cast<Index>(i), static_cast<Index>(j));
  }
  return K;
}

}  // namespace

Eigen::Matrix<double, 12, 12> geometric_block(double force, double h) {
  Eigen::Matrix<double, 12, 12> block = Eigen::Matrix<double, 12, 12>::Zero();
  const Eigen::Matrix4d across = geometric_stiffness(force, h);
  struct Signed {
    Index at;
    double sign;
  };
  const Signed in_z[] = {{2, 1.0}, {4, -1.0}, {8, 1.0}, {10, -1.0}};
  const Signed in_y[] = {{1, 1.0}, {5, 1.0}, {7, 1.0}, {11, 1.0}};
  for (const auto& places : {in_z, in_y}) {
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j)
        block(places[i].at, places[j].at) += places[i].sign * places[j].sign * across(i, j);
    }
  }
  return block;
}

std::vector<double> Statics::axial_forces(const Equilibrium& of) const {
  std::vector<double> forces;
  forces.reserve(pieces_.size());
  for (const Piece& piece : pieces_) {
    const double middle = 0.5 * (nodes_[piece.from].s + nodes_[piece.to].s);
    const CutForceDiagram& cut = of.members[static_cast<std::size_t>(piece.member)].cut;
    forces.push_back(cut.at({si<Length>(middle)}).N.value());
  }
  return forces;
}

/// K of a frame and what axial forces in its pieces add to it, of one pattern, without dimension,
/// brought into the order of elimination once for all forces and factors.
class Stability {
 public:
  /// What is stiff, and of each piece what an axial force of one newton adds.
  struct Entries {
    std::vector<Eigen::Triplet<double>> elastic;
    std::vector<std::vector<Eigen::Triplet<double>>> of_pieces;
  };

  Stability(Index size, const Entries& of) : sum_(size, size) {
    std::vector<Eigen::Triplet<double>> all = of.elastic;
    for (const std::vector<Eigen::Triplet<double>>& piece : of.of_pieces)
      for (const Eigen::Triplet<double>& entry : piece)
        all.emplace_back(entry.row(), entry.col(), 0.0);
    Sparse stiffness(size, size);
    stiffness.setFromTriplets(all.begin(), all.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> from_order;
    Eigen::AMDOrdering<int>()(stiffness, from_order);
    const Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order =
        from_order.inverse();
    sum_.selfadjointView<Eigen::Upper>() =
        stiffness.selfadjointView<Eigen::Lower>().twistedBy(order);
    stiffness_ = sum_.coeffs();
    for (const std::vector<Eigen::Triplet<double>>& piece : of.of_pieces) {
      std::vector<Part>& parts = of_pieces_.emplace_back();
      for (const Eigen::Triplet<double>& entry : piece) {
        if (entry.row() < entry.col()) continue;
        const auto [row, column] =
            std::minmax(order.indices()[entry.row()], order.indices()[entry.col()]);
        parts.push_back({place_of(row, column), entry.value()});
      }
    }
    solver_.analyzePattern(sum_);
  }

  /// The least factor, at most `most`, from which on K + factor K_g is no longer positive definite.
  double lowest_factor(const std::vector<double>& axial_forces, double most) {
    Eigen::ArrayXd stress = Eigen::ArrayXd::Zero(stiffness_.size());
    for (std::size_t p = 0; p < of_pieces_.size(); ++p)
      for (const Part& part : of_pieces_[p]) stress[part.place] += axial_forces[p] * part.per_force;
    const auto buckles = [&](double factor) {
      sum_.coeffs() = stiffness_ + factor * stress;
      solver_.factorize(sum_);
      return solver_.info() != Eigen::Success || (solver_.vectorD().array() <= 0.0).any();
    };
    if (!buckles(most)) return most;
    double stable = 0.0, unstable = std::min(1.0, most);
    while (unstable < most && !buckles(unstable)) {
      stable = unstable;
      unstable = std::min(2.0 * unstable, most);
    }
    constexpr double within = 1e-3;
    while (unstable - stable > within * unstable) {
      const double half = 0.5 * (stable + unstable);
      (buckles(half) ? unstable : stable) = half;
    }
    return 0.5 * (stable + unstable);
  }

 private:
  struct Part {
    Index place;  ///< among the coefficients
    double per_force;
  };

  Index place_of(int row, int column) const {
    const int* const rows = sum_.innerIndexPtr();
    const int* const first = rows + sum_.outerIndexPtr()[column];
    const int* const last = rows + sum_.outerIndexPtr()[column + 1];
    return std::find(first, last, row) - rows;  // a permuted column is in no order
  }

  Sparse sum_;
  Eigen::ArrayXd stiffness_;
  std::vector<std::vector<Part>> of_pieces_;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> solver_;
};

std::shared_ptr<Stability> Statics::stability() const {
  const Structure& structure = *structure_;
  const std::span<const Index> world = world_components(structure),
                               cuts = cut_components(structure);
  const auto count = static_cast<Index>(world.size());
  const Index size = row_of_node(nodes_.size());
  const auto unit = [&](Index k) { return k < 3 ? length_ : 1.0; };
  // Energies by the unit of force times that of length, so that entries are near one.
  const double energy = force_ * length_;
  Stability::Entries all;
  const auto add = [&](std::size_t a, std::size_t b, const Matrix6& of,
                       std::vector<Eigen::Triplet<double>>& entries) {
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j) {
        const Index row = world[static_cast<std::size_t>(i)],
                    column = world[static_cast<std::size_t>(j)];
        if (of(row, column) == 0.0) continue;
        entries.emplace_back(row_of_node(a) + i, row_of_node(b) + j,
                             of(row, column) * unit(row) * unit(column) / energy);
      }
    }
  };
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const double h = nodes_[piece.to].s - nodes_[piece.from].s;
    const Matrix6 into =
        rotation(structure.members[static_cast<std::size_t>(piece.member)].axes).transpose();
    const Matrix6 K = stiffness_of(reached_[p].back().flexibility, cuts);
    const Matrix6 ends[] = {-carry(Vector3d(h, 0.0, 0.0)) * into, into};
    const std::size_t nodes[] = {piece.from, piece.to};
    const Eigen::Matrix<double, 12, 12> axial = geometric_block(1.0, h);
    std::vector<Eigen::Triplet<double>>& stressed = all.of_pieces.emplace_back();
    for (Index a = 0; a < 2; ++a) {
      for (Index b = 0; b < 2; ++b) {
        add(nodes[a], nodes[b], ends[a].transpose() * K * ends[b], all.elastic);
        add(nodes[a], nodes[b], into.transpose() * axial.block<6, 6>(6 * a, 6 * b) * into,
            stressed);
      }
    }
  }
  for (const Joint& joint : structure.joints) {
    // Rigid is far stiffer than any piece.
    constexpr double rigid = 1e7;
    Matrix6 K = Matrix6::Zero();
    for (Index k = 0; k < 6; ++k) {
      const double stiffness = joint.stiffness[static_cast<std::size_t>(k)];
      const double stiffest = rigid * energy / (unit(k) * unit(k));
      K(k, k) = std::isinf(stiffness) ? stiffest : std::min(stiffness, stiffest);
    }
    const Matrix6 into = rotation(joint.axes).transpose();
    const auto end_of = [&](const Place& at, double sign) -> Matrix6 {
      const Matrix3d& axes = structure.members[static_cast<std::size_t>(at.member)].axes;
      return sign * into * carry(axes * Vector3d(0.0, at.p.y(), at.p.z()));
    };
    struct End {
      const Place* at;
      Matrix6 motion;
    };
    std::vector<End> ends;
    if (joint.a.member != ground) ends.push_back({&joint.a, end_of(joint.a, -1.0)});
    if (joint.b.member != ground) ends.push_back({&joint.b, end_of(joint.b, 1.0)});
    for (const End& a : ends) {
      for (const End& b : ends)
        add(node_of(*a.at), node_of(*b.at), a.motion.transpose() * K * b.motion, all.elastic);
    }
  }
  return std::make_shared<Stability>(size, all);
}

double Statics::critical_factor(const std::vector<double>& axial_forces, double most) const {
  if (std::none_of(axial_forces.begin(), axial_forces.end(), [](double N) { return N < 0.0; }))
    return most;
  if (!stability_) stability_ = stability();
  return stability_->lowest_factor(axial_forces, most);
}

}  // namespace boxbeam::frame
