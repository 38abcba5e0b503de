// Modal coordinates after loads that begin once, against closed forms of the oscillator, its energy
// and the order of convergence.

#include "boxbeam/verification/transient_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace transient_response_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

Eigen::MatrixXd one(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

ModalState still(Eigen::Index modes = 1) {
  return {Eigen::VectorXd::Zero(modes), Eigen::VectorXd::Zero(modes)};
}

/// The oscillator of period 1 from rest, its static displacement p(t) given; `damping`: zeta.
TransientResponse oscillator(const std::function<double(double)>& p, std::vector<double> borders,
                             double damping = 0.0, double step = 1.0 / 40.0) {
  const double omega = 2.0 * pi;
  return TransientResponse(
      [=](double time) -> ModalEquations {
        return {one(2.0 * damping * omega), one(omega * omega),
                Eigen::VectorXd::Constant(1, omega * omega * p(time))};
      },
      borders, still(), step);
}

double largest(const TransientResponse& of, double from, double until) {
  double most = 0.0;
  for (int i = 0; i <= 20000; ++i)
    most = std::max(most, std::abs(of.at(from + (until - from) * i / 20000).eta[0]));
  return most;
}

}  // namespace

// Harris, Piersol, Shock and Vibration Handbook (2002), chapter 8: an undamped oscillator under a
// step goes to twice the static displacement, a damped one to 1 + exp(-pi zeta/sqrt(1 - zeta^2)).
TEST_CASE("a suddenly applied load", "[transient]") {
  const auto step = [](double) { return 1.0; };
  CHECK(largest(oscillator(step, {0.0, 3.0}), 0.0, 3.0) == Approx(2.0).epsilon(1e-6));
  for (const double zeta : {0.01, 0.05, 0.2}) {
    CHECK(largest(oscillator(step, {0.0, 3.0}, zeta), 0.0, 3.0) ==
          Approx(1.0 + std::exp(-pi * zeta / std::sqrt(1.0 - zeta * zeta))).epsilon(1e-6));
  }
}

// The same source: 1 + |sin(pi t_r/T)|/(pi t_r/T).
TEST_CASE("a load that rises evenly and stays", "[transient]") {
  for (const double rise : {0.2, 0.5, 1.0, 1.5, 2.0, 3.3}) {
    const TransientResponse of =
        oscillator([&](double t) { return std::min(1.0, t / rise); }, {0.0, rise, rise + 3.0});
    CHECK(largest(of, rise, rise + 3.0) ==
          Approx(1.0 + std::abs(std::sin(pi * rise)) / (pi * rise)).epsilon(1e-6));
  }
}

// Residual amplitude of a half-sine pulse, b = T/(2 tau):
//
//     2 b cos(pi/(2 b))/(1 - b^2),  pi/2 at b = 1
//
// Chopra, Dynamics of Structures (2012), section 4.8; its shock spectrum has a maximum of 1.77 near
// tau = 0.8 T (Harris, Piersol).
TEST_CASE("a half-sine pulse", "[transient]") {
  double most = 0.0;
  for (const double pulse : {0.1, 0.25, 0.5, 0.75, 0.8, 0.82, 1.0, 1.2, 2.0}) {
    const TransientResponse of =
        oscillator([&](double t) { return t < pulse ? std::sin(pi * t / pulse) : 0.0; },
                   {0.0, pulse, pulse + 2.0});
    const double b = 0.5 / pulse;
    const double residual =
        b == 1.0 ? 0.5 * pi : std::abs(2.0 * b * std::cos(pi / (2.0 * b)) / (1.0 - b * b));
    CHECK(largest(of, pulse, pulse + 2.0) == Approx(residual).margin(2e-6));
    most = std::max(most, largest(of, 0.0, pulse + 2.0));
  }
  CHECK(most == Approx(1.77).epsilon(3e-3));
}

// Residual of a symmetric triangle by three ramps, slopes 2, -4, 2 over tau, each of which leaves
// slope/omega: (4 T/(pi tau)) sin^2(pi tau/(2 T)). Maximum of its spectrum: 1.52 near tau = T
// (Harris, Piersol).
TEST_CASE("a triangular pulse", "[transient]") {
  double most = 0.0;
  for (const double pulse : {0.3, 0.6, 0.9, 1.0, 1.1, 1.4, 2.5}) {
    const TransientResponse of =
        oscillator([&](double t) { return std::max(0.0, 1.0 - std::abs(2.0 * t / pulse - 1.0)); },
                   {0.0, 0.5 * pulse, pulse, pulse + 2.0});
    CHECK(largest(of, pulse, pulse + 2.0) ==
          Approx(4.0 / (pi * pulse) * std::pow(std::sin(0.5 * pi * pulse), 2)).margin(2e-6));
    most = std::max(most, largest(of, 0.0, pulse + 2.0));
  }
  CHECK(most == Approx(1.52).epsilon(5e-3));
}

namespace {

/// Three coupled modes whose coefficients change over time, with loads for which the answer is
///
///     eta = (sin 3t, cos 2t, t e^-t)
///
class Manufactured {
 public:
  static Eigen::Vector3d eta(double t) {
    return {std::sin(3.0 * t), std::cos(2.0 * t), t * std::exp(-t)};
  }
  static Eigen::Vector3d speed(double t) {
    return {3.0 * std::cos(3.0 * t), -2.0 * std::sin(2.0 * t), (1.0 - t) * std::exp(-t)};
  }
  static Eigen::Vector3d acceleration(double t) {
    return {-9.0 * std::sin(3.0 * t), -4.0 * std::cos(2.0 * t), (t - 2.0) * std::exp(-t)};
  }
  static ModalEquations at(double t) {
    Eigen::Matrix3d damping, stiffness;
    damping << 0.1, 0.5 * std::sin(t), 0.0, -0.5 * std::sin(t), 0.2, t, 0.0, -t, 0.3;
    stiffness << 20.0 + std::cos(t), 1.0, t, 1.0, 60.0, std::sin(2.0 * t), t, std::sin(2.0 * t),
        150.0 - 10.0 * t;
    return {damping, stiffness, acceleration(t) + damping * speed(t) + stiffness * eta(t)};
  }
  /// Largest errors of a solution by so many steps: at their ends, and of both anywhere.
  static Eigen::Vector3d errors(int steps) {
    const double end = 2.0;
    const TransientResponse of(at, {0.0, end}, {eta(0.0), speed(0.0)}, end / steps);
    Eigen::Vector3d worst = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < of.times().size(); ++i) {
      worst[0] = std::max(worst[0], (of.states()[i].eta - eta(of.times()[i])).norm());
    }
    for (int i = 0; i <= 997; ++i) {
      const double t = end * i / 997;
      worst[1] = std::max(worst[1], (of.at(t).eta - eta(t)).norm());
      worst[2] = std::max(worst[2], (of.at(t).speed - speed(t)).norm());
    }
    return worst;
  }
};

}  // namespace

// Gauss's method of three stages: order 2 x 3 at the ends of steps; between them its polynomial has
// the stage order, 3 + 1 in the rate, and 3 + 2 in its integral.
TEST_CASE("the error falls with the sixth power of the step", "[transient]") {
  const Eigen::Vector3d coarse = Manufactured::errors(20), fine = Manufactured::errors(40);
  CHECK(std::log2(coarse[0] / fine[0]) == Approx(6.0).margin(0.3));
  CHECK(std::log2(coarse[1] / fine[1]) > 4.6);
  CHECK(std::log2(coarse[2] / fine[2]) > 3.6);
}

// Turning frames couple rates without work: eta'^T G eta' = 0 for skew G.
TEST_CASE("without damping the energy stays, however long the steps", "[transient]") {
  Eigen::Matrix2d turning, stiffness;
  turning << 0.0, 3.0, -3.0, 0.0;
  stiffness << 40.0, 5.0, 5.0, 90.0;
  const ModalState start{Eigen::Vector2d(1.0, -0.5), Eigen::Vector2d(2.0, 0.3)};
  const auto energy = [&](const ModalState& at) {
    return at.speed.squaredNorm() + at.eta.dot(stiffness * at.eta);
  };
  for (const double step : {0.02, 0.3, 5.0}) {
    const TransientResponse of(
        [&](double) -> ModalEquations {
          return {turning, stiffness, Eigen::Vector2d::Zero()};
        },
        {0.0, 400.0 * step}, start, step);
    CHECK(energy(of.states().back()) == Approx(energy(start)).epsilon(1e-10));
  }
}

TEST_CASE("what a load does is in energy or dissipated", "[transient]") {
  // Work p v and dissipation c v^2 by Simpson's rule over the solution.
  const double omega = 2.0 * pi, zeta = 0.03;
  const auto p = [](double t) { return t < 0.7 ? t * t : 0.2; };
  const TransientResponse of = oscillator(p, {0.0, 0.7, 4.0}, zeta);
  double left = 0.0;
  for (const auto& [from, until] : {std::pair(0.0, 0.7), std::pair(0.7, 4.0)}) {
    const int n = 4000;
    const double h = (until - from) / n;
    for (int i = 0; i <= n; ++i) {
      // At the jump the side of its own.
      const double t = from + h * i, inside = std::min(t, until - 1e-12);
      const double v = of.at(t).speed[0];
      const double power = omega * omega * p(inside) * v - 2.0 * zeta * omega * v * v;
      left += power * h / 3.0 * (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
    }
  }
  const ModalState& end = of.states().back();
  const double energy = 0.5 * (std::pow(end.speed[0], 2) + omega * omega * std::pow(end.eta[0], 2));
  CHECK(left == Approx(energy).epsilon(1e-5));
}

TEST_CASE("what begins at rest stays there, and goes on where it was", "[transient]") {
  const ModalEquations constant{Eigen::Matrix2d::Zero(), Eigen::Vector2d(30.0, 700.0).asDiagonal(),
                                Eigen::Vector2d(3.0, 14.0)};
  const ModalState rest = resting(constant);
  CHECK(rest.eta[0] == Approx(0.1));
  CHECK(rest.eta[1] == Approx(0.02));
  TransientResponse of([&](double) { return constant; }, {1.0, 5.0}, rest, 0.05);
  of.go_on([&](double) { return constant; }, {5.0, 6.0}, 0.3);
  CHECK(of.times().back() == 6.0);
  for (const double t : {0.0, 1.0, 3.3, 5.0, 5.7, 6.0, 9.0}) {
    CHECK((of.at(t).eta - rest.eta).norm() < 1e-14);
    CHECK(of.at(t).speed.norm() < 1e-12);
  }
}

// Of steps of a fraction of a period and of many. By the equations of all modes at once, which the
// tests above hold against closed forms.
TEST_CASE("modes that nothing couples, each by itself or all at once", "[transient]") {
  const Eigen::Vector3d damping(0.0, 0.4, 3.0), stiffness(30.0, 900.0, 4e6);
  const auto force = [](double time) -> Eigen::VectorXd {
    return Eigen::Vector3d(std::sin(time), time < 1.0 ? 50.0 : -20.0, 1e3 * time * time);
  };
  const std::vector<double> borders{0.0, 1.0, 2.5};
  const ModalState start{Eigen::Vector3d(0.3, -0.1, 1e-4), Eigen::Vector3d(1.0, 2.0, -0.3)};
  for (const double step : {0.003, 0.07, 0.5}) {
    const UncoupledResponse alone =
        uncoupled_response(force, damping, stiffness, borders, start, step);
    const TransientResponse together(
        [&](double time) -> ModalEquations {
          return {damping.asDiagonal(), stiffness.asDiagonal(), force(time)};
        },
        borders, start, step);
    REQUIRE(alone.times == together.times());
    for (std::size_t i = 0; i < alone.times.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const ModalState& at = together.states()[i];
      CHECK((alone.eta.row(row).transpose() - at.eta).cwiseAbs().maxCoeff() < 1e-10);
      CHECK((alone.speed.row(row).transpose() - at.speed).cwiseAbs().maxCoeff() < 1e-8);
    }
  }
}

}  // namespace transient_response_test
