#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

/// Frames in space by the direct stiffness method, for comparison: nothing of it is shared with the
/// program. Prismatic Timoshenko elements of two nodes, each loaded along its whole length; dense,
/// in a longer number type. What is rigid is a constraint with a multiplier, not a stiff spring.
/// Sources: Przemieniecki, Theory of Matrix Structural Analysis (1968), 5.6 (stiffness); Friedman,
/// Kosmatka, Computers & Structures 47 (1993) (shapes, whose integrals with a load are what holds
/// the ends of an element).
namespace test {

class SpaceFrame {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  struct Stiffness {
    double EA = 0.0, GA_y = 0.0, GA_z = 0.0, GI_T = 0.0, EI_y = 0.0, EI_z = 0.0;
  };
  /// Off a node by a rigid arm, world axes; the ground has none.
  struct End {
    int node = -1;
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();
  };

  /// In the plane only x, y and the turn about z of the nodes are free.
  explicit SpaceFrame(bool plane) {
    for (int k = 0; k < 6; ++k) {
      if (!plane || k < 2 || k == 5) free_.push_back(k);
    }
  }

  int add_node() { return nodes_++; }

  /// From node to node, with its axes as columns.
  int add_element(int from, int to, double length, const Eigen::Matrix3d& axes,
                  const Stiffness& of) {
    elements_.push_back({from, to, length, {}, {}, Vector::Zero(12)});
    Element& element = elements_.back();
    element.turn = Matrix::Zero(12, 12);
    for (int k = 0; k < 12; k += 3) element.turn.block<3, 3>(k, k) = axes.transpose().cast<Real>();
    element.K = stiffness_of(of, length);
    element.shear = shear_of(of, length);
    return static_cast<int>(elements_.size()) - 1;
  }

  void add_load(const End& at, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
    Vector6 load;
    load << force, moment + at.arm.cross(force);
    loads_.push_back({at.node, load});
  }

  /// Force per length along an element, linear from end to end, world axes.
  void add_line(int element, const Eigen::Vector3d& at_from, const Eigen::Vector3d& at_to) {
    Element& of = elements_.at(static_cast<std::size_t>(element));
    const Eigen::Matrix<Real, 3, 3> into = of.turn.topLeftCorner<3, 3>();
    const Eigen::Matrix<Real, 3, 1> from = into * at_from.cast<Real>(),
                                    to = into * at_to.cast<Real>();
    const Real L = of.length;
    // Gauss' rule of three points, exact to degree 5; the products are of degree 4.
    const Real outer = std::sqrt(Real{3} / 5);
    for (const auto& [u, weight] :
         {std::pair{-outer, Real{5} / 9}, {Real{0}, Real{8} / 9}, {outer, Real{5} / 9}}) {
      const Real x = (1 + u) / 2, w = weight * L / 2;
      const Eigen::Matrix<Real, 3, 1> q = (1 - x) * from + x * to;
      of.held[0] -= w * (1 - x) * q[0];
      of.held[6] -= w * x * q[0];
      const std::array<Real, 4> y = shapes(x, L, of.shear[0]), z = shapes(x, L, of.shear[1]);
      of.held[1] -= w * y[0] * q[1];
      of.held[5] -= w * y[1] * q[1];
      of.held[7] -= w * y[2] * q[1];
      of.held[11] -= w * y[3] * q[1];
      of.held[2] -= w * z[0] * q[2];
      of.held[4] += w * z[1] * q[2];
      of.held[8] -= w * z[2] * q[2];
      of.held[10] += w * z[3] * q[2];
    }
  }

  /// Strains that come without force: along, and per length across: +y and +z longer.
  void add_heat(int element, double along, double per_y, double per_z) {
    Element& of = elements_.at(static_cast<std::size_t>(element));
    // How its end moves when its start does not.
    const Real L = of.length;
    Vector free = Vector::Zero(12);
    free[6] = along * L;
    free[7] = -per_y * L * L / 2;
    free[8] = -per_z * L * L / 2;
    free[10] = per_z * L;
    free[11] = -per_y * L;
    of.held -= of.K * free;
  }

  /// b less a, plus `shifted`, along and about the axes; infinite: no gap.
  int add_joint(const End& a, const End& b, const Eigen::Matrix3d& axes,
                const std::array<double, 6>& stiffness, const Vector6& shifted) {
    joints_.push_back({a, b, axes, stiffness, shifted});
    return static_cast<int>(joints_.size()) - 1;
  }

  struct Solution {
    std::vector<Vector6> nodes;   ///< shift and turn, world axes
    std::vector<Vector6> joints;  ///< on a, world axes
    /// Cut forces at both ends of each element: N, V_y, V_z, T, M_y, M_z.
    std::vector<std::array<Vector6, 2>> cuts;
    double balance = 0.0;  ///< residual of the equations by their size
  };

  Solution solve() const {
    const auto per_node = static_cast<Eigen::Index>(free_.size());
    const Eigen::Index motions = nodes_ * per_node;
    Matrix K = Matrix::Zero(motions, motions);
    Vector f = Vector::Zero(motions);
    for (const Element& of : elements_) {
      const Matrix k = of.turn.transpose() * of.K * of.turn;
      const Vector held = of.turn.transpose() * of.held;
      for (Eigen::Index i = 0; i < 12; ++i) {
        const Eigen::Index row = row_of(i < 6 ? of.from : of.to, static_cast<int>(i % 6));
        if (row < 0) continue;
        f[row] -= held[i];
        for (Eigen::Index j = 0; j < 12; ++j) {
          const Eigen::Index column = row_of(j < 6 ? of.from : of.to, static_cast<int>(j % 6));
          if (column >= 0) K(row, column) += k(i, j);
        }
      }
    }
    for (const Load& load : loads_) {
      for (int k = 0; k < 6; ++k) {
        if (row_of(load.node, k) >= 0) f[row_of(load.node, k)] += load.load[k];
      }
    }
    std::vector<Vector> rigid;
    std::vector<Real> closed;
    for (const Joint& joint : joints_) {
      for (int k = 0; k < 6; ++k) {
        const double stiff = joint.stiffness[static_cast<std::size_t>(k)];
        if (!counts(k) || stiff == 0.0) continue;
        const Vector gap = gap_of(joint, k, motions);
        if (std::isinf(stiff)) {
          rigid.push_back(gap);
          closed.push_back(-joint.shifted[k]);
        } else {
          K += stiff * gap * gap.transpose();
          f -= static_cast<Real>(stiff) * joint.shifted[k] * gap;
        }
      }
    }
    const Real unit = K.diagonal().maxCoeff();
    const auto held = static_cast<Eigen::Index>(rigid.size());
    Matrix A = Matrix::Zero(motions + held, motions + held);
    A.topLeftCorner(motions, motions) = K / unit;
    Vector b = Vector::Zero(motions + held);
    b.head(motions) = f / unit;
    for (Eigen::Index r = 0; r < held; ++r) {
      A.row(motions + r).head(motions) = rigid[static_cast<std::size_t>(r)];
      A.col(motions + r).head(motions) = rigid[static_cast<std::size_t>(r)];
      b[motions + r] = closed[static_cast<std::size_t>(r)];
    }
    const Eigen::PartialPivLU<Matrix> lu(A);
    Vector x = lu.solve(b);
    x += lu.solve(b - A * x);

    Solution result;
    const Real size = b.norm() + A.norm() * x.norm();
    result.balance = size > 0 ? static_cast<double>((b - A * x).norm() / size) : 0.0;
    const auto motion = [&](int node) {
      Vector of = Vector::Zero(6);
      for (int k = 0; k < 6; ++k) {
        if (row_of(node, k) >= 0) of[k] = x[row_of(node, k)];
      }
      return of;
    };
    for (int node = 0; node < nodes_; ++node)
      result.nodes.push_back(motion(node).template cast<double>());
    for (const Element& of : elements_) {
      Vector ends(12);
      ends << motion(of.from), motion(of.to);
      const Vector forces = of.K * (of.turn * ends) + of.held;
      result.cuts.push_back({-forces.head<6>().cast<double>(), forces.tail<6>().cast<double>()});
    }
    Eigen::Index multiplier = motions;
    for (const Joint& joint : joints_) {
      Vector6 force = Vector6::Zero();
      for (int k = 0; k < 6; ++k) {
        const double stiff = joint.stiffness[static_cast<std::size_t>(k)];
        if (!counts(k) || stiff == 0.0) continue;
        if (std::isinf(stiff)) {
          force[k] = static_cast<double>(unit * x[multiplier++]);
        } else {
          const Real gap = gap_of(joint, k, motions).dot(x.head(motions)) + joint.shifted[k];
          force[k] = static_cast<double>(stiff * gap);
        }
      }
      Vector6 world;
      world << joint.axes * force.head<3>(), joint.axes * force.tail<3>();
      result.joints.push_back(world);
    }
    return result;
  }

 private:
  struct Element {
    int from = 0, to = 0;
    double length = 0.0;
    Matrix turn, K;
    Vector held;                  ///< what holds its ends against its loads, its axes
    std::array<Real, 2> shear{};  ///< 12 EI/(G A L^2) of bending along y and z
  };
  struct Load {
    int node = 0;
    Vector6 load;
  };
  struct Joint {
    End a, b;
    Eigen::Matrix3d axes;
    std::array<double, 6> stiffness;
    Vector6 shifted;
  };

  bool counts(int component) const { return free_.size() == 6 || component < 2 || component == 5; }

  Eigen::Index row_of(int node, int component) const {
    for (std::size_t k = 0; k < free_.size(); ++k) {
      if (free_[k] == component)
        return node * static_cast<Eigen::Index>(free_.size()) + static_cast<Eigen::Index>(k);
    }
    return -1;
  }

  Vector gap_of(const Joint& joint, int component, Eigen::Index motions) const {
    Vector gap = Vector::Zero(motions);
    const Eigen::Vector3d axis = joint.axes.col(component % 3);
    for (const auto& [end, sign] : {std::pair{&joint.a, -1.0}, {&joint.b, 1.0}}) {
      if (end->node < 0) continue;
      Vector6 of = Vector6::Zero();
      if (component < 3) {
        of << axis, end->arm.cross(axis);
      } else {
        of.tail<3>() = axis;
      }
      for (int k = 0; k < 6; ++k) {
        if (row_of(end->node, k) >= 0) gap[row_of(end->node, k)] += sign * of[k];
      }
    }
    return gap;
  }

  static std::array<Real, 2> shear_of(const Stiffness& of, Real L) {
    return {12 * of.EI_z / (of.GA_y * L * L), 12 * of.EI_y / (of.GA_z * L * L)};
  }

  /// Of the shift across by the shift and the slope of both ends.
  static std::array<Real, 4> shapes(Real x, Real L, Real shear) {
    const Real x2 = x * x, x3 = x2 * x, by = 1 / (1 + shear);
    return {by * (1 - 3 * x2 + 2 * x3 + shear * (1 - x)),
            by * L * (x - 2 * x2 + x3 + shear / 2 * (x - x2)), by * (3 * x2 - 2 * x3 + shear * x),
            by * L * (-x2 + x3 - shear / 2 * (x - x2))};
  }

  static Matrix stiffness_of(const Stiffness& of, Real L) {
    Matrix K = Matrix::Zero(12, 12);
    const auto spring = [&](Eigen::Index i, Eigen::Index j, Real k) {
      K(i, i) += k;
      K(j, j) += k;
      K(i, j) -= k;
      K(j, i) -= k;
    };
    spring(0, 6, of.EA / L);
    spring(3, 9, of.GI_T / L);
    // Shift and slope of both ends; about y the slope is the turn backwards.
    const std::array<Real, 2> shear = shear_of(of, L);
    const auto bend = [&](const std::array<Eigen::Index, 4>& at, Real EI, Real phi, Real sign) {
      const Real k = EI / (L * L * L * (1 + phi));
      const std::array<std::array<Real, 4>, 4> block{{
          {12, 6 * L, -12, 6 * L},
          {6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L},
          {-12, -6 * L, 12, -6 * L},
          {6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L},
      }};
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          const Real turned = (i % 2 == 1 ? sign : 1) * (j % 2 == 1 ? sign : 1);
          K(at[i], at[j]) += k * turned * block[i][j];
        }
      }
    };
    bend({1, 5, 7, 11}, of.EI_z, shear[0], 1);
    bend({2, 4, 8, 10}, of.EI_y, shear[1], -1);
    return K;
  }

  std::vector<int> free_;
  int nodes_ = 0;
  std::vector<Element> elements_;
  std::vector<Load> loads_;
  std::vector<Joint> joints_;
};

}  // namespace test
