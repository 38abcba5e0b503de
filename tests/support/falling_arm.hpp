#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <complex>
#include <string>
#include <vector>

#include "support/hub_and_arm.hpp"
#include "support/space_elements.hpp"

/// The arm of a hub that falls onto what is below it, and the same by ordinary finite elements.
namespace test::falling_arm {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using space_arm::Cuts;
using space_arm::Moved;

inline constexpr double g = 9.81;

/// The arm on a hub that falls along z, on a spring below it, with a load beside its tip.
struct Falling : hub_and_arm::HubAndArm {
  double stiffness = 2e5;  ///< of what is below [N/m]
  std::string acts = "both ways";
  double damping = 0.0, at_tip = 0.0;  ///< of the spring, and of a damper below the tip [N s/m]
  double under_tip = 1e-3;             ///< stiffness there [N/m]
  double duration = 1.0;               ///< [s]
  std::string driver = "";             ///< moves the hub instead of forces

  Moved moved() const {
    const auto below = [](const char* name, const char* point, double x, double stiff,
                          double damped, const std::string& ways) {
      return fmt::format(R"([forces.{}]
kind = "spring"
connect = ["ground", "{}"]
at = ["{:.15g} m", "0 m", "-1 m"]
stiffness = "{:.15g} N/m"
free_length = "1 m"
damping = "{:.15g} N s/m"
acts = "{}"
)",
                         name, point, x, stiff, damped, ways);
    };
    return Moved(
        text(below("below", "hub.o", 0.0, stiffness, damping, acts) +
                 below("tip", "arm.tip", 4.0, under_tip, at_tip, "both ways") +
                 (driver.empty() ? fmt::format("[motion]\nduration = \"{:.15g} s\"\n", duration)
                                 : driver),
             !driver.empty()));
  }
};

/// The same by ordinary elements: nodes from the heel on, of which the heel only falls.
class FallingElements {
 public:
  FallingElements(const boxbeam::TaperedBeam& beam, const Falling& of)
      : of_(of),
        whole_(space_elements::assembled(beam, of.load, of.centre, of.inertia.asDiagonal())) {
    whole_.M(2, 2) += of.hub;
    h_ = beam.length().value() / 60.0;
    element_ = space_elements::element(section_at(beam, {boxbeam::si<boxbeam::Length>(0.5 * h_)}),
                                       h_, beam.density.value());
    for (Index i = 0; i < whole_.M.rows(); ++i)
      if (i == 2 || i > 5) free_.push_back(i);
    up_ = VectorXd::Zero(whole_.M.rows());
    for (Index i = 2; i < up_.size(); i += 6) up_[i] = 1.0;
    mass_ = up_.dot(whole_.M * up_);
  }

  double mass() const { return mass_; }
  const VectorXd& up() const { return up_; }

  /// Frequencies and modes of modal mass one, with the spring or without it.
  struct Modes {
    VectorXd squares;
    MatrixXd shapes;
  };
  Modes modes(bool on_spring) const {
    MatrixXd K = whole_.K(free_, free_);
    if (on_spring) K(0, 0) += of_.stiffness;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, whole_.M(free_, free_));
    Modes modes{solver.eigenvalues(), MatrixXd::Zero(up_.size(), K.cols())};
    for (std::size_t i = 0; i < free_.size(); ++i)
      modes.shapes.row(free_[i]) = solver.eigenvectors().row(static_cast<Index>(i));
    return modes;
  }
  /// What follows the rigid motion statically on the spring: M up times an acceleration, and forces
  /// on heel and tip; moves no mass as a whole.
  VectorXd moved_by(double acceleration, double at_heel, double at_tip) const {
    MatrixXd K = whole_.K(free_, free_);
    K(0, 0) += of_.stiffness;
    K(K.rows() - 4, K.cols() - 4) += of_.under_tip;
    VectorXd force = -acceleration * (whole_.M * up_);
    force[2] += at_heel;
    force[force.size() - 4] += at_tip;
    VectorXd moved = VectorXd::Zero(up_.size());
    const VectorXd found = K.ldlt().solve(force(free_));
    for (std::size_t i = 0; i < free_.size(); ++i) moved[free_[i]] = found[static_cast<Index>(i)];
    return moved;
  }
  /// Forces on all nodes, mass times what it is moved by.
  VectorXd inertia(const VectorXd& acceleration) const { return whole_.M * acceleration; }

  /// The six cut forces at a node.
  Cuts cuts_at(Index node, const VectorXd& y, const VectorXd& acceleration) const {
    const VectorXd ends = y.segment<12>(6 * node);
    const VectorXd moved = (acceleration + g * up_).segment<12>(6 * node);
    return -(element_.K * ends + element_.M * moved).head<6>();
  }
  /// Of a heel that moves by e^(i w t), with spring and damper at the tip.
  Eigen::VectorXcd shaken(double w) const {
    Eigen::MatrixXcd dynamic = (whole_.K - w * w * whole_.M).cast<std::complex<double>>();
    dynamic(dynamic.rows() - 4, dynamic.cols() - 4) +=
        std::complex<double>(of_.under_tip, w * of_.at_tip);
    const std::vector<Index> held(free_.begin() + 1, free_.end());
    Eigen::VectorXcd y = Eigen::VectorXcd::Zero(up_.size());
    y[2] = 1.0;
    const Eigen::MatrixXcd left = dynamic(held, held);
    const Eigen::VectorXcd by_heel = dynamic.col(2)(held),
                           moved = left.partialPivLu().solve(by_heel);
    y(held) = -moved;
    return y;
  }
  /// Under its weight, the heel held.
  VectorXd sagged() const {
    const std::vector<Index> held(free_.begin() + 1, free_.end());
    VectorXd y = VectorXd::Zero(up_.size());
    MatrixXd left = whole_.K(held, held);
    left(left.rows() - 4, left.cols() - 4) += of_.under_tip;
    const VectorXd weight = -g * (whole_.M * up_), on_held = weight(held),
                   moved = left.ldlt().solve(on_held);
    y(held) = moved;
    return y;
  }
  double station(Index node) const { return static_cast<double>(node) * h_; }

 private:
  Falling of_;
  space_elements::Assembled whole_;
  space_elements::Element element_;
  double h_ = 0.0, mass_ = 0.0;
  std::vector<Index> free_;
  VectorXd up_;
};

}  // namespace test::falling_arm
