#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"

/// A vibrating beam in space by ordinary finite elements, which share nothing with the program.
namespace test::space_elements {

inline constexpr double E = 210e9, G = 81e9;

/// The stiffness of an element of Timoshenko's beam and the mass of Euler and Bernoulli's shapes,
/// (u, v, w, theta_x, theta_y, theta_z) at both ends. Source: Przemieniecki, Theory of Matrix
/// Structural Analysis (1968), 5.6, 11.3.
struct Element {
  Eigen::Matrix<double, 12, 12> K = Eigen::Matrix<double, 12, 12>::Zero(), M = K;
};

inline Element element(const boxbeam::Section& section, double h, double rho) {
  using namespace boxbeam;
  const SectionProperties of = properties_of(section);
  const ShearAreas shear = shear_areas_of(section);
  const double A = of.area.value(), I_p = of.I_y.value() + of.I_z.value();
  const double I_T = torsion_properties_of(section).I_T->value();
  Element e;
  const auto bar = [&](Eigen::Index at, double k, double m) {
    for (const auto& [i, j, kk, mm] : {std::tuple{at, at, 1.0, 2.0},
                                       {at, at + 6, -1.0, 1.0},
                                       {at + 6, at, -1.0, 1.0},
                                       {at + 6, at + 6, 1.0, 2.0}}) {
      e.K(i, j) += kk * k / h;
      e.M(i, j) += mm * m * h / 6.0;
    }
  };
  bar(0, E * A, rho * A);
  bar(3, G * I_T, rho * I_p);
  const auto beam = [&](Eigen::Index w, Eigen::Index t, double sign, double EI, double GA) {
    const double phi = 12.0 * EI / (GA * h * h);
    Eigen::Matrix4d K, M;
    K << 12, 6 * h, -12, 6 * h, 6 * h, (4 + phi) * h * h, -6 * h, (2 - phi) * h * h, -12, -6 * h,
        12, -6 * h, 6 * h, (2 - phi) * h * h, -6 * h, (4 + phi) * h * h;
    K *= EI / (h * h * h * (1 + phi));
    M << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h * h, 13 * h, -3 * h * h, 54, 13 * h, 156, -22 * h,
        -13 * h, -3 * h * h, -22 * h, 4 * h * h;
    M *= rho * A * h / 420.0;
    const Eigen::Index at[] = {w, t, w + 6, t + 6};
    const double signs[] = {1.0, sign, 1.0, sign};
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) {
        e.K(at[i], at[j]) += signs[i] * signs[j] * K(i, j);
        e.M(at[i], at[j]) += signs[i] * signs[j] * M(i, j);
      }
    }
  };
  beam(1, 5, 1.0, E * of.I_z.value(), G * shear.y.value());
  beam(2, 4, -1.0, E * of.I_y.value(), G * shear.z.value());
  return e;
}

/// A beam of `n` even elements, six freedoms for each node from the first one.
struct ElementsOfBeam {
  boxbeam::Section section;
  Eigen::Matrix3d axes;
  double length = 0.0, density = 0.0;
  Eigen::Index n = 0, first = 0;
  bool rotary = false;  ///< rotary inertia across the axis, at the nodes
};

/// Adds its stiffness and mass.
inline void add_beam(const ElementsOfBeam& beam, Eigen::MatrixXd& K, Eigen::MatrixXd& M) {
  const double h = beam.length / static_cast<double>(beam.n);
  const Element e = element(beam.section, h, beam.density);
  Eigen::Matrix<double, 12, 12> into = Eigen::Matrix<double, 12, 12>::Zero();
  for (Eigen::Index i = 0; i < 12; i += 3) into.block<3, 3>(i, i) = beam.axes.transpose();
  const boxbeam::SectionProperties of = boxbeam::properties_of(beam.section);
  const Eigen::Vector3d slices(0.0, of.I_y.value(), of.I_z.value());
  const Eigen::Matrix3d turned = beam.axes * slices.asDiagonal() * beam.axes.transpose();
  for (Eigen::Index i = 0; i < beam.n; ++i) {
    const Eigen::Index row = beam.first + 6 * i;
    K.block<12, 12>(row, row) += into.transpose() * e.K * into;
    M.block<12, 12>(row, row) += into.transpose() * e.M * into;
    if (!beam.rotary) continue;
    for (const Eigen::Index end : {row, row + 6})
      M.block<3, 3>(end + 3, end + 3) += 0.5 * h * beam.density * turned;
  }
}

/// Stiffness and mass of a beam of sixty even elements with a rigid body at its tip, in its axes,
/// six freedoms for each node from its start.
struct Assembled {
  Eigen::MatrixXd K, M;
};

inline Assembled assembled(const boxbeam::TaperedBeam& beam, double m, const Eigen::Vector3d& c,
                           const Eigen::Matrix3d& J) {
  constexpr Eigen::Index n = 60;
  Assembled of{Eigen::MatrixXd::Zero(6 * n + 6, 6 * n + 6),
               Eigen::MatrixXd::Zero(6 * n + 6, 6 * n + 6)};
  const double h = beam.length().value() / n;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) * h;
    const Element e = element(boxbeam::section_at(beam, {boxbeam::si<boxbeam::Length>(middle)}), h,
                              beam.density.value());
    of.K.block<12, 12>(6 * i, 6 * i) += e.K;
    of.M.block<12, 12>(6 * i, 6 * i) += e.M;
  }
  // v_c = v + theta x c.
  Eigen::Matrix3d cross;
  cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  Eigen::Matrix<double, 3, 6> centre;
  centre << Eigen::Matrix3d::Identity(), -cross;
  of.M.bottomRightCorner<6, 6>() += m * centre.transpose() * centre;
  of.M.bottomRightCorner<3, 3>() += J;
  return of;
}

}  // namespace test::space_elements
