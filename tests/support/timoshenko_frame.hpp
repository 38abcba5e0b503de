#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// A plane frame of Timoshenko finite elements, for comparison: nothing of it is shared with the
/// program. Elements of two nodes whose shapes are those of the element loaded at its ends, so that
/// statics is exact, with the mass that belongs to these shapes; dense matrices. What is rigid is
/// left out of the coordinates. Sources: Przemieniecki, Theory of Matrix Structural Analysis
/// (1968), 5.6 (stiffness); Friedman, Kosmatka, Computers & Structures 47 (1993) (shapes).
namespace test {

/// What of a member is elastic.
enum class FrameKind { bending, axial, full };

struct FrameMember {
  FrameKind kind = FrameKind::full;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double angle = 0.0;
  double length = 0.0;
  double EA = 0.0, GA = 0.0, EI = 0.0;
  double mass = 0.0;           ///< per length
  std::vector<double> places;  ///< which must be nodes
};

/// A place of a member: along it and to its left; of the ground nothing counts.
struct FramePlace {
  int member = -1;
  double s = 0.0, offset = 0.0;
};

class TimoshenkoFrame {
 public:
  /// `elements`: least number on every member.
  explicit TimoshenkoFrame(int elements) : elements_(elements) {}

  /// A rigid body with its origin and world axes.
  int add_body(const Eigen::Vector2d& origin, double mass, double inertia,
               const Eigen::Vector2d& centre) {
    Part part;
    part.nodes = {0.0};
    part.shape = Eigen::MatrixXd::Identity(3, 3);
    part.K = Eigen::MatrixXd::Zero(3, 3);
    part.M = Eigen::MatrixXd::Zero(3, 3);
    const Eigen::Vector2d c = centre - origin;
    part.M << mass, 0.0, -mass * c.y(), 0.0, mass, mass * c.x(), -mass * c.y(), mass * c.x(),
        inertia + mass * c.squaredNorm();
    return add(part);
  }

  int add_member(const FrameMember& of) {
    Part part;
    part.angle = of.angle;
    part.nodes = nodes_of(of);
    const auto n = static_cast<Eigen::Index>(part.nodes.size());
    part.K = part.M = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Eigen::Index i = 0; i + 1 < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      add_element(of, part.nodes[k + 1] - part.nodes[k], 3 * i, part);
    }
    part.shape = shape_of(of.kind, part.nodes);
    return add(part);
  }

  /// Behind all members: springs between two places, along an axis and to its left.
  void add_joint(const std::string& name, const FramePlace& a, const FramePlace& b, double angle,
                 double along, double across) {
    Joint joint{name, {}, {along, across}, Eigen::Rotation2Dd(angle).toRotationMatrix()};
    joint.gap = joint.axes.transpose() * (motion_of(b) - motion_of(a)).topRows<2>();
    joints_.push_back(joint);
  }

  /// Behind all members.
  void add_load(const FramePlace& at, const Eigen::Vector3d& constant,
                const Eigen::Vector3d& amplitude) {
    loads_.push_back({at, constant, amplitude});
  }

  /// What joints do to the members that they name first, world axes.
  struct Forces {
    std::vector<std::string> names;
    std::vector<Eigen::Vector2d> forces;

    Eigen::Vector2d of(const std::string& name) const {
      const auto found = std::find(names.begin(), names.end(), name);
      return forces.at(static_cast<std::size_t>(found - names.begin()));
    }
  };

  Forces statics(const Eigen::Vector2d& gravity) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(size_);
    for (const Part& part : parts_) {
      const Eigen::Vector2d g = Eigen::Rotation2Dd(-part.angle) * gravity;
      Eigen::VectorXd field = Eigen::VectorXd::Zero(part.M.rows());
      for (Eigen::Index i = 0; i < field.size(); i += 3) field.segment<2>(i) = g;
      f.segment(part.start, part.shape.cols()) += part.shape.transpose() * (part.M * field);
    }
    for (const Load& load : loads_) f += motion_of(load.at).transpose() * load.constant;
    return forces_in(stiffness().ldlt().solve(f));
  }

  Forces harmonic(double frequency) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(size_);
    for (const Load& load : loads_) f += motion_of(load.at).transpose() * load.amplitude;
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Eigen::MatrixXd dynamic = stiffness() - omega * omega * mass();
    return forces_in(dynamic.partialPivLu().solve(f));
  }

  std::vector<double> frequencies(std::size_t count) const {
    // M x = x/omega^2 K: the lowest frequencies have the largest eigenvalues, without round-off of
    // the highest ones.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(mass(), stiffness(),
                                                                          Eigen::EigenvaluesOnly);
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) {
      const double inverse = modes.eigenvalues()[size_ - 1 - static_cast<Eigen::Index>(i)];
      found.push_back(1.0 / (2.0 * std::numbers::pi * std::sqrt(inverse)));
    }
    return found;
  }

 private:
  /// Matrices of all (u, w, phi) of the nodes in the member's axes; `shape` gives these from the
  /// coordinates that are left.
  struct Part {
    double angle = 0.0;
    std::vector<double> nodes;
    Eigen::MatrixXd K, M, shape;
    Eigen::Index start = 0;
  };
  struct Joint {
    std::string name;
    Eigen::MatrixXd gap;  ///< along and across, from all coordinates
    Eigen::Vector2d stiffness;
    Eigen::Matrix2d axes;
  };
  struct Load {
    FramePlace at;
    Eigen::Vector3d constant, amplitude;
  };

  std::vector<double> nodes_of(const FrameMember& of) const {
    std::vector<double> kept = of.places;
    kept.insert(kept.end(), {0.0, of.length});
    std::sort(kept.begin(), kept.end());
    std::vector<double> nodes{0.0};
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      const double step = kept[i + 1] - kept[i];
      if (step < 1e-9) continue;
      const int n = static_cast<int>(std::ceil(elements_ * step / of.length - 1e-9));
      for (int k = 1; k <= n; ++k) nodes.push_back(kept[i] + step * k / n);
    }
    return nodes;
  }

  static void add_element(const FrameMember& of, double h, Eigen::Index at, Part& part) {
    // Along: a bar.
    const Eigen::Index u[] = {at, at + 3};
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        part.K(u[i], u[j]) += of.EA / h * (i == j ? 1.0 : -1.0);
        part.M(u[i], u[j]) += of.mass * h / 6.0 * (i == j ? 2.0 : 1.0);
      }
    }
    // Across: (w, phi) of both ends.
    const double shear = 12.0 * of.EI / (of.GA * h * h);
    Eigen::Matrix4d K;
    K << 12.0, 6.0 * h, -12.0, 6.0 * h,                                   //
        6.0 * h, (4.0 + shear) * h * h, -6.0 * h, (2.0 - shear) * h * h,  //
        -12.0, -6.0 * h, 12.0, -6.0 * h,                                  //
        6.0 * h, (2.0 - shear) * h * h, -6.0 * h, (4.0 + shear) * h * h;
    K *= of.EI / (h * h * h * (1.0 + shear));
    Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
    // Gauss' rule of four nodes, exact to degree 7; the products are of degree 6.
    const double inner = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(1.2));
    const double outer = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(1.2));
    const double w_inner = (18.0 + std::sqrt(30.0)) / 36.0;
    const double w_outer = (18.0 - std::sqrt(30.0)) / 36.0;
    for (const auto& [node, weight] :
         {std::pair{-outer, w_outer}, {-inner, w_inner}, {inner, w_inner}, {outer, w_outer}}) {
      const double x = 0.5 * (1.0 + node);
      Eigen::Vector4d N;
      N << 1.0 - 3.0 * x * x + 2.0 * x * x * x + shear * (1.0 - x),
          h * (x - 2.0 * x * x + x * x * x + 0.5 * shear * (x - x * x)),
          3.0 * x * x - 2.0 * x * x * x + shear * x,
          h * (-x * x + x * x * x + 0.5 * shear * (x * x - x));
      N /= 1.0 + shear;
      M += 0.5 * h * weight * of.mass * N * N.transpose();
    }
    const Eigen::Index v[] = {at + 1, at + 2, at + 4, at + 5};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        part.K(v[i], v[j]) += K(i, j);
        part.M(v[i], v[j]) += M(i, j);
      }
    }
  }

  static Eigen::MatrixXd shape_of(FrameKind kind, const std::vector<double>& nodes) {
    const auto n = static_cast<Eigen::Index>(nodes.size());
    if (kind == FrameKind::full) return Eigen::MatrixXd::Identity(3 * n, 3 * n);
    Eigen::MatrixXd shape =
        Eigen::MatrixXd::Zero(3 * n, kind == FrameKind::bending ? 1 + 2 * n : 2 + n);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (kind == FrameKind::bending) {  // u of all; w and phi of each
        shape(3 * i, 0) = 1.0;
        shape(3 * i + 1, 1 + 2 * i) = shape(3 * i + 2, 2 + 2 * i) = 1.0;
      } else {  // w of the first, phi of all; u of each
        shape(3 * i + 1, 0) = 1.0;
        shape(3 * i + 1, 1) = nodes[static_cast<std::size_t>(i)];
        shape(3 * i + 2, 1) = 1.0;
        shape(3 * i, 2 + i) = 1.0;
      }
    }
    return shape;
  }

  int add(Part& part) {
    part.start = size_;
    size_ += part.shape.cols();
    parts_.push_back(part);
    return static_cast<int>(parts_.size()) - 1;
  }

  /// (x, y, phi) of a place in the world from all coordinates.
  Eigen::MatrixXd motion_of(const FramePlace& place) const {
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(3, size_);
    if (place.member < 0) return motion;
    const Part& part = parts_.at(static_cast<std::size_t>(place.member));
    const auto nearest = std::min_element(
        part.nodes.begin(), part.nodes.end(),
        [&](double x, double y) { return std::abs(x - place.s) < std::abs(y - place.s); });
    const Eigen::Index node = nearest - part.nodes.begin();
    const Eigen::Vector2d arm(place.s - *nearest, place.offset);
    Eigen::Matrix3d rigid = Eigen::Matrix3d::Identity();
    rigid(0, 2) = -arm.y();
    rigid(1, 2) = arm.x();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(part.angle).toRotationMatrix();
    motion.middleCols(part.start, part.shape.cols()) =
        turn * rigid * part.shape.middleRows(3 * node, 3);
    return motion;
  }

  Eigen::MatrixXd stiffness() const {
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size_, size_);
    for (const Part& part : parts_) {
      const Eigen::Index n = part.shape.cols();
      K.block(part.start, part.start, n, n) += part.shape.transpose() * part.K * part.shape;
    }
    for (const Joint& joint : joints_) {
      K += joint.gap.transpose() * joint.stiffness.asDiagonal() * joint.gap;
    }
    return K;
  }

  Eigen::MatrixXd mass() const {
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(size_, size_);
    for (const Part& part : parts_) {
      const Eigen::Index n = part.shape.cols();
      M.block(part.start, part.start, n, n) += part.shape.transpose() * part.M * part.shape;
    }
    return M;
  }

  Forces forces_in(const Eigen::VectorXd& q) const {
    Forces found;
    for (const Joint& joint : joints_) {
      const Eigen::Vector2d gap = joint.gap * q;
      found.names.push_back(joint.name);
      found.forces.push_back(joint.axes * joint.stiffness.cwiseProduct(gap));
    }
    return found;
  }

  int elements_;
  Eigen::Index size_ = 0;
  std::vector<Part> parts_;
  std::vector<Joint> joints_;
  std::vector<Load> loads_;
};

}  // namespace test
