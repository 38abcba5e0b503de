#pragma once

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "boxbeam/mechanism/flexible/response.hpp"

/// A structure's equations written out as one dense system: slow, plain, and in a longer number
/// type than the solver under test, with which it shares nothing but the structure.
///
///     -omega^2 M q + G_s^T s + G_j^T f = load      motion of the rigid elements
///      G_s q - F/(1 + i omega tau) s   = 0         springs, s what each bears
///      G_j q - f/(c + i omega d)       = 0         joints (c infinite: no gap; zero: f = 0)
namespace test {

using Long = long double;
using LongComplex = std::complex<Long>;

struct DenseSolution {
  boxbeam::flexible::Deformation<boxbeam::flexible::Complex> deformation;
  double residual = 0.0;  ///< of the long solution, relative
};

class DenseStructure {
 public:
  explicit DenseStructure(const boxbeam::flexible::Structure& structure) : structure_(structure) {
    for (const auto& link : structure.links) {
      first_.push_back(elements_);
      first_spring_.push_back(springs_);
      elements_ += static_cast<Eigen::Index>(link.elements.size());
      springs_ += static_cast<Eigen::Index>(link.springs.size());
    }
    joints_ = static_cast<Eigen::Index>(structure.joints.size());
  }

  Eigen::Index size() const { return 3 * (elements_ + springs_ + joints_); }

  Eigen::Matrix<LongComplex, -1, -1> matrix(double square) const {
    using namespace boxbeam::flexible;
    Eigen::Matrix<LongComplex, -1, -1> A = Eigen::Matrix<LongComplex, -1, -1>::Zero(size(), size());
    const Long omega = std::sqrt(std::max(static_cast<Long>(square), Long{0}));
    for (std::size_t l = 0; l < structure_.links.size(); ++l) {
      const DividedLink& link = structure_.links[l];
      const LongComplex viscous(
          1.0L, omega * static_cast<Long>(structure_.mechanism->links[l].retardation));
      for (std::size_t i = 0; i < link.elements.size(); ++i) {
        const Eigen::Index q = at(l, i);
        const RigidElement& e = link.elements[i];
        Eigen::Matrix3d M;
        M << e.mass, 0.0, -e.first_moment.y(),  //
            0.0, e.mass, e.first_moment.x(),    //
            -e.first_moment.y(), e.first_moment.x(), e.inertia;
        A.block(q, q, 3, 3) -= static_cast<Long>(square) * M.cast<LongComplex>();
      }
      for (std::size_t i = 0; i < link.springs.size(); ++i) {
        const SpringElement& spring = link.springs[i];
        const Eigen::Index s = 3 * (elements_ + first_spring_[l] + static_cast<Eigen::Index>(i));
        for (const std::size_t side : {i, i + 1}) {
          const Long sign = side == i ? -1.0L : 1.0L;
          Eigen::Matrix<LongComplex, 3, 3> G = Eigen::Matrix<LongComplex, 3, 3>::Zero();
          G(0, 0) = G(1, 1) = G(2, 2) = sign;
          G(1, 2) = sign *
                    (static_cast<Long>(spring.place) - static_cast<Long>(link.elements[side].node));
          A.block(s, at(l, side), 3, 3) += G;
          A.block(at(l, side), s, 3, 3) += G.transpose();
        }
        A(s, s) -= static_cast<Long>(spring.axial) / viscous;
        A.block(s + 1, s + 1, 2, 2) -= spring.bending.cast<LongComplex>() / viscous;
      }
    }
    for (std::size_t j = 0; j < structure_.joints.size(); ++j) {
      const Joint& joint = structure_.mechanism->joints[j];
      const auto& ends = structure_.joints[j];
      const Eigen::Index f = joint_force_at(j);
      for (const Grip* grip : {&ends.a, &ends.b}) {
        if (grip->link == ground) continue;
        const Long sign = grip == &ends.a ? -1.0L : 1.0L;
        const Eigen::Matrix<LongComplex, 3, 3> G =
            sign * (ends.axes * grip->motion).cast<LongComplex>();
        const Eigen::Index q = at(static_cast<std::size_t>(grip->link), grip->element);
        A.block(f, q, 3, 3) += G;
        A.block(q, f, 3, 3) += G.transpose();
      }
      for (Eigen::Index i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const LongComplex c(joint.stiffness[k], omega * static_cast<Long>(joint.damping[k]));
        if (std::isinf(joint.stiffness[k])) continue;
        if (c == LongComplex(0)) {
          A.row(f + i).setZero();
          A(f + i, f + i) = 1.0L;
        } else {
          A(f + i, f + i) -= 1.0L / c;
        }
      }
    }
    return A;
  }

  /// Rows and columns to about one: motions are small and forces large.
  Eigen::Matrix<LongComplex, -1, 1> scales() const {
    Eigen::Matrix<LongComplex, -1, 1> scale(size());
    const Long force = 1e7L;
    for (Eigen::Index i = 0; i < size(); ++i) {
      scale[i] = i < 3 * elements_ ? 1.0L / std::sqrt(force) : std::sqrt(force);
    }
    return scale;
  }
  Eigen::Matrix<LongComplex, -1, -1> scaled(double square) const {
    return scales().asDiagonal() * matrix(square) * scales().asDiagonal();
  }

  template <class Scalar>
  DenseSolution solve(double square, const boxbeam::flexible::LinkColumns<Scalar>& loads) const {
    Eigen::Matrix<LongComplex, -1, 1> b = Eigen::Matrix<LongComplex, -1, 1>::Zero(size());
    for (std::size_t l = 0; l < loads.size(); ++l) {
      for (Eigen::Index i = 0; i < loads[l].cols(); ++i) {
        b.segment(at(l, static_cast<std::size_t>(i)), 3) =
            loads[l].col(i).template cast<LongComplex>();
      }
    }
    const Eigen::Matrix<LongComplex, -1, -1> A = matrix(square);
    const Eigen::Matrix<LongComplex, -1, 1> scale = scales();
    const Eigen::Matrix<LongComplex, -1, -1> S = scaled(square);
    const Eigen::FullPivLU<Eigen::Matrix<LongComplex, -1, -1>> lu(S);
    Eigen::Matrix<LongComplex, -1, 1> x = scale.asDiagonal() * lu.solve(scale.asDiagonal() * b);
    x += scale.asDiagonal() * lu.solve(scale.asDiagonal() * (b - A * x));
    DenseSolution result;
    result.residual = static_cast<double>((A * x - b).norm() / b.norm());
    for (std::size_t l = 0; l < loads.size(); ++l) {
      result.deformation.motion.emplace_back(3, loads[l].cols());
      for (Eigen::Index i = 0; i < loads[l].cols(); ++i) {
        result.deformation.motion[l].col(i) =
            x.segment(at(l, static_cast<std::size_t>(i)), 3).cast<std::complex<double>>();
      }
    }
    // A spring's or joint's force acts on its first end against the gap's rows of -1.
    result.deformation.joints.resize(3, joints_);
    for (std::size_t j = 0; j < structure_.joints.size(); ++j) {
      result.deformation.joints.col(static_cast<Eigen::Index>(j)) =
          x.segment(joint_force_at(j), 3).cast<std::complex<double>>();
    }
    return result;
  }

 private:
  Eigen::Index at(std::size_t link, std::size_t element) const {
    return 3 * (first_[link] + static_cast<Eigen::Index>(element));
  }
  Eigen::Index joint_force_at(std::size_t joint) const {
    return 3 * (elements_ + springs_ + static_cast<Eigen::Index>(joint));
  }

  const boxbeam::flexible::Structure& structure_;
  std::vector<Eigen::Index> first_, first_spring_;
  Eigen::Index elements_ = 0, springs_ = 0, joints_ = 0;
};

}  // namespace test
