// A uniform cantilever that turns steadily: its pull stiffens it. In the plane of turning the same
// pull, turned with the beam, takes omega^2 away again. Sources: Southwell and Gough, ARC R&M 766
// (1921); Wright, Smith, Thresher and Wang, Journal of Applied Mechanics 49 (1982), tables of a
// hub without radius. With eta = Omega sqrt(m L^4/(E I)) and frequencies in the same unit.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "src/verification/vibration_in_space.hpp"
#include "support/space_arm.hpp"

namespace rotating_beam_test {

using namespace boxbeam;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using test::space_arm::Moved;

namespace {

/// Frequencies square to the plane of turning, by Ritz's method with x^2, x^3, ..., independent of
/// the program: int phi'' phi'' + eta^2/2 int (1 - x^2) phi' phi' against int phi phi.
std::array<double, 3> flapping(double eta) {
  constexpr int terms = 9;
  MatrixXd K(terms, terms), M(terms, terms);
  for (int i = 0; i < terms; ++i)
    for (int j = 0; j < terms; ++j) {
      const double k = i + 2.0, l = j + 2.0;
      M(i, j) = 1.0 / (k + l + 1.0);
      K(i, j) = k * (k - 1.0) * l * (l - 1.0) / (k + l - 3.0) +
                0.5 * eta * eta * k * l * (1.0 / (k + l - 1.0) - 1.0 / (k + l + 1.0));
    }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(K, M);
  return {std::sqrt(modes.eigenvalues()[0]), std::sqrt(modes.eigenvalues()[1]),
          std::sqrt(modes.eigenvalues()[2])};
}

constexpr double E = 210e9, length = 12.0, area = 1700e-6, mass = 7850.0 * area;
constexpr double I_y = (80.0 * 100.0 * 100.0 * 100.0 - 70.0 * 90.0 * 90.0 * 90.0) / 12.0 * 1e-12;
constexpr double I_z = (100.0 * 80.0 * 80.0 * 80.0 - 90.0 * 70.0 * 70.0 * 70.0) / 12.0 * 1e-12;

/// Of a second moment of area: the rate whose eta is one [rad/s].
double unit_of(double I) { return std::sqrt(E * I / mass) / (length * length); }

/// A beam that turns about an axis square to it, at a rate [rad/s].
Moved turning(const Vector3d& axis, double rate) {
  return Moved(test::space_arm::slender(
      axis,
      fmt::format("kind = \"constant rate\"\nstart = \"0 rad\"\nrate = \"{:.15g} rad/s\"\n", rate),
      80, 100, 1e6));
}

/// Circular frequencies of free vibration in the frame that turns [rad/s]: of modes of the posture
/// with the pull, and what turning adds to them.
std::vector<double> frequencies(const Moved& of) {
  constexpr int count = 10;
  StoppedVibration stopped(of.project, of.chain(), 48);
  const double begin = of.rigid().begin().value();
  const ModesInMotion modes = stopped.modes_in_motion(
      of.chain().at(begin), of.rigid().diagram_at(of.rigid().begin()), count);
  MatrixXd A = MatrixXd::Zero(2 * count, 2 * count);
  A.topRightCorner(count, count).setIdentity();
  for (int j = 0; j < count; ++j)
    A(count + j, j) =
        -std::pow(2.0 * std::numbers::pi * modes.modes[static_cast<std::size_t>(j)].frequency, 2);
  A.bottomLeftCorner(count, count) -= modes.turning.of_size;
  A.bottomRightCorner(count, count) = -modes.turning.of_rate;
  const Eigen::VectorXcd roots = A.eigenvalues();
  std::vector<double> found;
  for (const std::complex<double>& root : roots)
    if (root.imag() > 0.0) found.push_back(root.imag());
  std::sort(found.begin(), found.end());
  return found;
}

bool has(const std::vector<double>& found, double wanted, double within) {
  return std::any_of(found.begin(), found.end(),
                     [&](double f) { return std::abs(f - wanted) < within * wanted; });
}

}  // namespace

TEST_CASE("Ritz's method gives the published frequencies of a turning cantilever") {
  const double published[][4] = {{0.0, 3.5160, 22.0345, 61.6972},
                                 {1.0, 3.6817, 22.1810, 61.8418},
                                 {3.0, 4.7973, 23.3203, 62.9850},
                                 {6.0, 7.3604, 26.8091, 66.6840},
                                 {12.0, 13.1702, 37.6031, 79.6145}};
  for (const auto& row : published) {
    const std::array<double, 3> found = flapping(row[0]);
    for (std::size_t k = 0; k < 3; ++k) CHECK(found[k] == Approx(row[k + 1]).epsilon(2e-5));
  }
  // Southwell's coefficients: what omega^2 adds to the square of a frequency.
  const auto southwell = [](std::size_t k) {
    return (std::pow(flapping(0.1)[k], 2) - std::pow(flapping(0.0)[k], 2)) / 0.01;
  };
  CHECK(southwell(0) == Approx(1.193).epsilon(1e-3));
  CHECK(southwell(1) == Approx(6.478).epsilon(1e-3));
}

TEST_CASE("a cantilever that turns steadily has Southwell's frequencies, in its plane and across",
          "[elastic_motion]") {
  for (const double eta : {0.5, 1.0, 3.0, 6.0}) {
    // About z: across the plane of turning it bends about y; about y the other way round.
    for (const bool about_z : {true, false}) {
      const double across = about_z ? I_y : I_z, within = about_z ? I_z : I_y;
      const double rate = eta * unit_of(across);
      const std::vector<double> found =
          frequencies(turning(about_z ? Vector3d::UnitZ() : Vector3d::UnitY(), rate));
      const std::array<double, 3> flap = flapping(eta), stiff = flapping(rate / unit_of(within));
      INFO("eta " << eta << ", about " << (about_z ? "z" : "y"));
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(has(found, flap[k] * unit_of(across), 1e-4));
        const double lead = std::sqrt(std::pow(stiff[k] * unit_of(within), 2) - rate * rate);
        CHECK(has(found, lead, 2e-4));  // stretching takes part: (omega/omega_stretching)^2
      }
    }
  }
}

}  // namespace rotating_beam_test
