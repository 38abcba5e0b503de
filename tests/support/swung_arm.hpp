#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/space_arm.hpp"

namespace test::space_arm {

/// A point mass at the tip of an arm without mass, rigid in shear, that swings far about an axis
/// through its heel, in its own axes:
///
///     m (u'' + 2 w x u' + w' x u + w x (w x u)) + K u + d K_0 u' = -m (w' x r + w x (w x r))
///
/// K = diag(EA/L, k_z, k_y), k = N/(L (1 - tanh(x)/x)), x = L (N/EI)^(1/2), in compression of tan,
/// of the pull N of the rigid motion; by Runge and Kutta, periodic from the start that repeats.
/// Sources: Goldstein, Classical Mechanics (1980), 4-10; Timoshenko, Gere, Theory of Elastic
/// Stability (1961), 1.
struct SwungMass {
  using State = Eigen::Matrix<double, 6, 1>;
  double m, L, EA, EI_y, EI_z, delay;
  Eigen::Vector3d axis;
  boxbeam::Driver angle;
  static constexpr int steps = 9600;

  double stiffness(double EI, double N) const {
    const double x = L * std::sqrt(std::abs(N) / EI);
    if (x < 1e-4) return 3.0 * EI / (L * L * L) + 1.2 * N / L;
    return N / (L * (1.0 - (N > 0.0 ? std::tanh(x) : std::tan(x)) / x));
  }
  State rate(double t, const State& y, double load) const {
    const boxbeam::DriverState at = boxbeam::driver_at(angle, t);
    const Eigen::Vector3d w = axis * at.rate, change = axis * at.acceleration, r(L, 0.0, 0.0),
                          u = y.head<3>(), v = y.tail<3>();
    const Eigen::Vector3d rigid = change.cross(r) + w.cross(w.cross(r));
    const double N = -m * rigid.x();
    const Eigen::Vector3d K(EA / L, stiffness(EI_z, N), stiffness(EI_y, N)),
        K_0(EA / L, 3.0 * EI_z / (L * L * L), 3.0 * EI_y / (L * L * L));
    State of;
    of.head<3>() = v;
    of.tail<3>() = -load * rigid - 2.0 * w.cross(v) - change.cross(u) - w.cross(w.cross(u)) -
                   (K.cwiseProduct(u) + delay * K_0.cwiseProduct(v)) / m;
    return of;
  }
  /// From t = 0 in so many steps.
  std::vector<State> path(const State& start, double load, double length) const {
    std::vector<State> states{start};
    const double h = length / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = h * i;
      const State y = states.back(), a = rate(t, y, load),
                  b = rate(t + 0.5 * h, y + 0.5 * h * a, load),
                  c = rate(t + 0.5 * h, y + 0.5 * h * b, load), d = rate(t + h, y + h * c, load);
      states.push_back(y + h / 6.0 * (a + 2.0 * b + 2.0 * c + d));
    }
    return states;
  }
  std::vector<State> periodic(double period) const {
    Eigen::Matrix<double, 6, 6> free;
    for (int i = 0; i < 6; ++i) free.col(i) = path(State::Unit(i), 0.0, period).back();
    const State forced = path(State::Zero(), 1.0, period).back();
    const Eigen::Matrix<double, 6, 6> open = Eigen::Matrix<double, 6, 6>::Identity() - free;
    return path(open.lu().solve(forced), 1.0, period);
  }
};

/// Such a mass of 300 kg as a case, damped, and the same by hand.
struct SwungArm {
  SwungArm(const std::string& keys, const boxbeam::Driver& angle)
      : of(arm(hinge(axis(), keys) + with_load(300.0), light,
               "[model]\nshear_modulus = \"1e6 GPa\"\n"
               "damping = { ratio = 0.03, at = \"4 Hz\" }\n")),
        elastic(of.by(3, 8)) {
    const std::vector<boxbeam::frame::BeamMode> modes = of.modes(8, 3);
    for (int j = 0; j < 3; ++j)
      tip.col(j) = modes[static_cast<std::size_t>(j)].motion.tail<6>().head<3>();
    const boxbeam::SectionProperties section =
        boxbeam::properties_of(of.project.beam.segments.front().from);
    constexpr double E = 210e9, pi = std::numbers::pi;
    mass = {300.0,
            4.0,
            E * section.area.value(),
            E * section.I_y.value(),
            E * section.I_z.value(),
            0.03 / (pi * 4.0),
            axis(),
            angle};
  }
  static Eigen::Vector3d axis() { return {0.48, -0.6, 0.64}; }

  Moved of;
  boxbeam::ElasticMotionInSpace elastic;
  Eigen::Matrix3d tip;  ///< where it stands per modal coordinate [m]
  SwungMass mass;
};

}  // namespace test::space_arm
