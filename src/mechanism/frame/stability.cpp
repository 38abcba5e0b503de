#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

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

/// The least factor, at most `most`, from which on K + factor K_g is no longer positive definite;
/// both of one pattern.
double lowest_factor(const Sparse& stiffness, const Sparse& stress, double most) {
  // Brought into the order of elimination once for all factors.
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> from_order;
  Eigen::AMDOrdering<int>()(stiffness, from_order);
  const auto ordered = [&](const Sparse& matrix) {
    Sparse upper(stiffness.rows(), stiffness.cols());
    upper.selfadjointView<Eigen::Upper>() =
        matrix.selfadjointView<Eigen::Lower>().twistedBy(from_order.inverse());
    return upper;
  };
  const Sparse ordered_stiffness = ordered(stiffness), ordered_stress = ordered(stress);
  Sparse sum = ordered_stiffness;
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> solver;
  solver.analyzePattern(sum);
  const auto buckles = [&](double factor) {
    sum.coeffs() = ordered_stiffness.coeffs() + factor * ordered_stress.coeffs();
    solver.factorize(sum);
    return solver.info() != Eigen::Success || (solver.vectorD().array() <= 0.0).any();
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

Statics::StressedStiffness Statics::stressed_stiffness(
    const std::vector<double>& axial_forces) const {
  const Structure& structure = *structure_;
  const std::span<const Index> world = world_components(structure),
                               cuts = cut_components(structure);
  const auto count = static_cast<Index>(world.size());
  const Index size = row_of_node(nodes_.size());
  const auto unit = [&](Index k) { return k < 3 ? length_ : 1.0; };
  // Energies by the unit of force times that of length, so that entries are near one.
  const double energy = force_ * length_;
  std::vector<Eigen::Triplet<double>> elastic, geometric;
  // Both of one pattern, so that their sums are.
  const auto add = [&](std::size_t a, std::size_t b, const Matrix6& stiff,
                       const Matrix6& stressed) {
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j) {
        const Index row = world[static_cast<std::size_t>(i)],
                    column = world[static_cast<std::size_t>(j)];
        if (stiff(row, column) == 0.0 && stressed(row, column) == 0.0) continue;
        const double per = unit(row) * unit(column) / energy;
        const Index from = row_of_node(a) + i, to = row_of_node(b) + j;
        elastic.emplace_back(from, to, stiff(row, column) * per);
        geometric.emplace_back(from, to, stressed(row, column) * per);
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
    const Eigen::Matrix<double, 12, 12> axial = geometric_block(axial_forces[p], h);
    for (Index a = 0; a < 2; ++a) {
      for (Index b = 0; b < 2; ++b) {
        add(nodes[a], nodes[b], ends[a].transpose() * K * ends[b],
            into.transpose() * axial.block<6, 6>(6 * a, 6 * b) * into);
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
        add(node_of(*a.at), node_of(*b.at), a.motion.transpose() * K * b.motion, Matrix6::Zero());
    }
  }
  StressedStiffness found;
  found.stiffness.resize(size, size);
  found.stress.resize(size, size);
  found.stiffness.setFromTriplets(elastic.begin(), elastic.end());
  found.stress.setFromTriplets(geometric.begin(), geometric.end());
  return found;
}

double Statics::critical_factor(const std::vector<double>& axial_forces, double most) const {
  if (std::none_of(axial_forces.begin(), axial_forces.end(), [](double N) { return N < 0.0; }))
    return most;
  const StressedStiffness of = stressed_stiffness(axial_forces);
  return lowest_factor(of.stiffness, of.stress, most);
}

}  // namespace boxbeam::frame
