// Modes and responses of the exact form: against independent Ritz functions of a tapered beam, a
// continuous beam on springs, counts of finely divided random structures, and the corrected form in
// the limit.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "catch.hpp"
#include "support/continuous_beam.hpp"
#include "support/elastic_beams.hpp"

namespace exact_modes_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::Chance;
using test::End;

namespace {

double square_of(const Mode& mode) {
  const double omega = 2.0 * std::numbers::pi * mode.frequency;
  return omega * omega;
}

/// A steel cantilever of rectangular section whose height goes from one value to another: EI of the
/// third degree.
Link tapered_link(double L, double h_0, double h_1, int parts) {
  const double E = 2.1e11, G = 8.1e10, rho = 7850.0, b = 0.1;
  Link link = test::link_of(test::steel_bar(L, h_0, b), parts, LinkKind::full);
  LinkStretch& of = link.stretches.front();
  const double r = (h_1 / h_0 - 1.0) / L;
  const double A = b * h_0, I = b * h_0 * h_0 * h_0 / 12.0;
  of.EA.c = {E * A, E * A * r};
  of.GA.c = {G * A / 1.2, G * A / 1.2 * r};
  of.EI.c = {E * I, 3.0 * E * I * r, 3.0 * E * I * r * r, E * I * r * r * r};
  of.mass.c = {rho * A, rho * A * r};
  of.rotary.c = {rho * I, 3.0 * rho * I * r, 3.0 * rho * I * r * r, rho * I * r * r * r};
  return link;
}

Mechanism tapered_cantilever(double L, double h_0, double h_1, int parts, Element element) {
  Mechanism mechanism;
  mechanism.element = element;
  mechanism.links = {tapered_link(L, h_0, h_1, parts)};
  const double rigid = test::infinite;
  mechanism.joints = {test::hold(mechanism, 0.0, {rigid, rigid, rigid}, "root")};
  return mechanism;
}

/// Squares of omega of a clamped link by one element of high degree: w and phi as x times
/// Legendre's polynomials of 2 x/L - 1, Rayleigh and Ritz. Ascending; bending only.
Eigen::VectorXd ritz_squares(const Link& link) {
  constexpr int degree = 22;
  using Gauss = boost::math::quadrature::gauss<double, 40>;
  const LinkStretch& of = link.stretches.front();
  const double L = of.length;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * degree, 2 * degree), M = K;
  const auto add = [&](double t, double weight) {
    const double x = 0.5 * L * (1.0 + t);
    Eigen::VectorXd P(degree), dP(degree);
    P[0] = 1.0, P[1] = t, dP[0] = 0.0, dP[1] = 1.0;
    for (int n = 1; n + 1 < degree; ++n) {
      P[n + 1] = ((2 * n + 1) * t * P[n] - n * P[n - 1]) / (n + 1);
      dP[n + 1] = dP[n - 1] + (2 * n + 1) * P[n];
    }
    const Eigen::VectorXd f = x / L * P, df = P / L + x / L * dP * 2.0 / L;
    Eigen::VectorXd w(2 * degree), phi(2 * degree), shear(2 * degree), bow(2 * degree);
    w << f, Eigen::VectorXd::Zero(degree);
    phi << Eigen::VectorXd::Zero(degree), f;
    shear << df, -f;
    bow << Eigen::VectorXd::Zero(degree), df;
    const double by = 0.5 * L * weight;
    K += by * (of.GA(x) * shear * shear.transpose() + of.EI(x) * bow * bow.transpose());
    M += by * (of.mass(x) * w * w.transpose() + of.rotary(x) * phi * phi.transpose());
  };
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    add(Gauss::abscissa()[k], Gauss::weights()[k]);
    add(-Gauss::abscissa()[k], Gauss::weights()[k]);
  }
  // Inverse squares: round-off is that of the largest, which are the lowest frequencies.
  const Eigen::VectorXd scale = K.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      scale.asDiagonal() * M * scale.asDiagonal(), scale.asDiagonal() * K * scale.asDiagonal(),
      Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseInverse().reverse();
}

std::size_t count_below(const Structure& structure, double square) {
  return DynamicStiffness<double>(structure, square, 0.0).frequencies_below();
}

Mechanism divided(Mechanism mechanism, Element element, int parts) {
  mechanism.element = element;
  for (Link& link : mechanism.links) link.parts = parts;
  return mechanism;
}

/// Joint forces in a vibration, all in one vector.
Eigen::VectorXcd joints_of(const Mechanism& mechanism, double frequency) {
  const Structure structure = structure_of(mechanism);
  const Deformation<Complex> response = harmonic_response(structure, frequency);
  return Eigen::Map<const Eigen::VectorXcd>(response.joints.data(), response.joints.size());
}

}  // namespace

TEST_CASE("exact modes: a tapered beam by Ritz functions of high degree", "[exact]") {
  for (const double h_1 : {0.1, 0.2, 0.45}) {
    for (const int parts : {1, 5}) {
      const Mechanism mechanism = tapered_cantilever(3.0, 0.3, h_1, parts, Element::exact);
      const Structure structure = structure_of(mechanism);
      const Eigen::VectorXd expected = ritz_squares(mechanism.links.front());
      std::vector<double> bending;
      for (const Mode& mode : modes_of(structure, 10)) {
        // The modes along the axis have none across it at the end.
        const auto& q = mode.shape.motion.front();
        if (std::abs(q(1, q.cols() - 1)) > 1e-6 * std::abs(q(0, q.cols() - 1)))
          bending.push_back(square_of(mode));
      }
      REQUIRE(bending.size() >= 6);
      for (std::size_t i = 0; i < 6; ++i) {
        CAPTURE(h_1, parts, i);
        CHECK(bending[i] == Approx(expected[static_cast<Eigen::Index>(i)]).epsilon(1e-10));
      }
    }
  }
}

TEST_CASE("exact modes: a beam turning on a spring of any stiffness", "[exact]") {
  const Bar bar = test::steel_bar(4.0, 0.3, 0.1);
  for (const double ratio : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const double k = ratio * bar.EI / bar.L;
    Mechanism mechanism = test::cantilever_of(bar, 2, Element::exact);
    mechanism.joints.front().stiffness[2] = k;
    const auto residual = [&](double square) {
      const test::Transfer T = test::transfer_of(bar, square, static_cast<long double>(bar.L));
      const auto by = static_cast<long double>(k);
      return (T(2, 1) + by * T(2, 3)) * T(3, 2) - (T(3, 1) + by * T(3, 3)) * T(2, 2);
    };
    for (const Mode& mode : modes_of(structure_of(mechanism), 8)) {
      const double square = square_of(mode);
      CAPTURE(ratio, square);
      CHECK(residual(square * (1.0 - 1e-11)) * residual(square * (1.0 + 1e-11)) < 0.0L);
    }
  }
}

TEST_CASE("exact modes: equal frequencies are all found", "[exact]") {
  // Three equal cantilevers side by side, without anything between them.
  const Bar bar = test::steel_bar(2.0, 0.2, 0.1);
  Mechanism mechanism = test::cantilever_of(bar, 1, Element::exact);
  for (int i = 1; i < 3; ++i) {
    mechanism.links.push_back(mechanism.links.front());
    Joint joint = mechanism.joints.front();
    joint.a.link = i;
    mechanism.joints.push_back(joint);
  }
  const std::vector<Mode> alone =
      modes_of(structure_of(test::cantilever_of(bar, 1, Element::exact)), 3);
  const std::vector<Mode> modes = modes_of(structure_of(mechanism), 8);
  REQUIRE(modes.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(modes[i].frequency == Approx(alone[i / 3].frequency).epsilon(1e-12));
  }
}

TEST_CASE("exact modes: as many as a fine division counts, in random structures", "[exact]") {
  std::size_t compared = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    const Mechanism mechanism = test::random_elastic(
        chance, {2, seed % 2 == 0, false, seed % 3 == 0, true, Element::exact});
    constexpr std::size_t count = 5;
    const std::vector<Mode> modes = modes_of(structure_of(mechanism), count);
    const Mechanism fine = divided(mechanism, Element::corrected, 96);
    const Structure parts = structure_of(fine);
    REQUIRE(modes.size() <= count);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double square = square_of(modes[i]);
      if (i > 0) CHECK(square >= square_of(modes[i - 1]) * (1.0 - 1e-9));
      // Where the next is clearly apart, the division has as many below as were found.
      const double next = i + 1 < modes.size() ? square_of(modes[i + 1]) : 0.0;
      if (next < 1.02 * square) continue;
      CHECK(count_below(parts, std::sqrt(square * next)) == i + 1);
      ++compared;
    }
  }
  CHECK(compared > 6000);
}

TEST_CASE("exact responses: what corrected elements tend to", "[exact]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    const Mechanism mechanism =
        test::random_elastic(chance, {3, seed % 2 == 0, true, false, true, Element::exact});
    const double frequency =
        modes_of(structure_of(mechanism), 2).back().frequency * (0.7 + 0.2 * chance.any());
    const Eigen::VectorXcd exact = joints_of(mechanism, frequency);
    const auto difference = [&](int parts) {
      return (joints_of(divided(mechanism, Element::corrected, parts), frequency) - exact).norm() /
             exact.norm();
    };
    const double coarse = difference(24), fine = difference(96);
    CAPTURE(coarse, fine);
    // At least of the first order where errors of a sign change meet, and small.
    CHECK(fine < 0.25 * coarse + 1e-9);
    CHECK(fine < 1e-2);
    // Neither the division nor its nodes matter.
    CHECK((joints_of(divided(mechanism, Element::exact, 7), frequency) - exact).norm() <
          1e-9 * exact.norm());
  }
}

TEST_CASE("exact responses: the moment at the root, near resonance as well", "[exact]") {
  // mu = EI = L = 1, force one at the end: M = (sinh x + sin x)/(x (1 + cosh x cos x)).
  const double first = std::pow(1.8751040687119611, 2);
  for (const double r : {1e-4, 0.3, 0.9, 0.999, 1.001, 7.0, 80.0}) {
    const double omega = r * first;
    const long double x = std::sqrt(static_cast<long double>(omega));
    const auto expected = static_cast<double>((std::sinh(x) + std::sin(x)) /
                                              (x * (1.0L + std::cosh(x) * std::cos(x))));
    Mechanism mechanism = test::cantilever_of({}, 1, Element::exact);
    mechanism.loads = {test::load_at(1.0, Eigen::Vector3d::Zero(), {0.0, 1.0, 0.0})};
    const Structure structure = structure_of(mechanism);
    const auto force =
        joint_force(structure, 0, harmonic_response(structure, omega / (2.0 * std::numbers::pi)));
    CAPTURE(r);
    CHECK(std::abs(force.z()) ==
          Approx(std::abs(expected)).epsilon(1e-11 + 1e-13 / std::abs(1.0 - r)));
  }
  Mechanism mechanism = test::cantilever_of({}, 1, Element::exact);
  mechanism.loads = {test::load_at(1.0, Eigen::Vector3d::Zero(), {0.0, 1.0, 0.0})};
  const Structure structure = structure_of(mechanism);
  CHECK_THROWS_AS(harmonic_response(structure, first * (1.0 + 1e-8) / (2.0 * std::numbers::pi)),
                  AnalysisError);
}

TEST_CASE("exact links at rest: weight of a tapered link by its flexibility", "[exact]") {
  // End of a cantilever under its weight: virtual work, integral of m x/EI + Q/GA over the link.
  Mechanism mechanism = tapered_cantilever(3.0, 0.3, 0.1, 1, Element::exact);
  mechanism.gravity = {0.0, -9.81};
  const LinkStretch& of = mechanism.links.front().stretches.front();
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  const auto over = [](const auto& f, double a, double b) { return Gauss::integrate(f, a, b); };
  const double L = of.length;
  const double expected = over(
      [&](double x) {
        const double Q = over([&](double s) { return 9.81 * of.mass(s); }, x, L);
        const double m = over([&](double s) { return 9.81 * of.mass(s) * (s - x); }, x, L);
        return m * (L - x) / of.EI(x) + Q / of.GA(x);
      },
      0.0, L);
  const Structure structure = structure_of(mechanism);
  const Attachment end{0, {L, 0.0}};
  CHECK(motion_at(structure, end, static_response(structure)).y() ==
        Approx(-expected).epsilon(1e-12));
}

}  // namespace exact_modes_test
