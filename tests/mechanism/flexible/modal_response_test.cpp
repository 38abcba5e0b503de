#include "boxbeam/mechanism/flexible/modal_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/elastic_balance.hpp"
#include "support/elastic_beams.hpp"

namespace modal_response_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using Eigen::Index;
using test::Bar;
using test::Chance;
using test::End;
using test::RandomMechanism;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double hertz = 2.0 * pi;
constexpr std::size_t all = 1000;

RandomMechanism sort(int i, bool damped) {
  RandomMechanism want;
  want.links = 1 + i % 4;
  want.closed = i % 2 == 1;
  want.rigid_joints = i % 3 == 1;
  want.damped = damped;
  // Corrected ends may have no rotary inertia: statically recovered, but not where damped.
  want.element = damped || i % 4 == 0 ? Element::classical : Element::corrected;
  return want;
}

/// Nothing holds the first link to the ground but what it bears.
Mechanism let_go(Mechanism mechanism) {
  std::erase_if(mechanism.joints, [](const Joint& joint) { return joint.b.link == ground; });
  return mechanism;
}

/// A frequency away from all natural ones, near which round-off has no limit.
double frequency_between(Chance& chance, const std::vector<Mode>& modes) {
  for (;;) {
    const double f = test::power_of_ten(chance, 0.0, 2.0);
    const auto near = [&](const Mode& mode) { return std::abs(mode.frequency / f - 1.0) < 0.02; };
    if (std::none_of(modes.begin(), modes.end(), near)) return f;
  }
}

double difference(const LinkColumns<Complex>& a, const LinkColumns<Complex>& b) {
  double size = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    size = std::max(size, b[k].cwiseAbs().maxCoeff());
    largest = std::max(largest, (a[k] - b[k]).cwiseAbs().maxCoeff());
  }
  return largest / size;
}

double difference(const Eigen::Matrix3Xcd& a, const Eigen::Matrix3Xcd& b) {
  return b.cols() == 0 ? 0.0 : (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// m x'' + c x' + k x = Im(force e^(i omega t)): a mass that only a spring along x lets move.
struct Oscillator {
  double m = 3.0, k = 700.0, c = 0.0;
  Complex force = 5.0;
  double weight = 0.0;  ///< along x

  Mechanism mechanism(double frequency) const {
    Mechanism of;
    of.links = {test::link_of(Bar{}, 1, LinkKind::rigid)};
    of.links[0].rigid = {m, {0.5, 0.0}, 2.0};
    of.joints = {test::hold(of, 0.0, {k, test::infinite, test::infinite}, "spring")};
    of.joints[0].damping[0] = c;
    of.loads = {test::load_at(1.0, {weight, 0.0, 0.0}, {std::abs(force), 0.0, 0.0})};
    of.loads[0].phase = std::arg(force);
    of.frequency = frequency;
    return of;
  }
  Complex motion(double omega) const { return force / Complex(k - omega * omega * m, omega * c); }
};

}  // namespace

TEST_CASE("All modes give the response without modes", "[flexible][modal]") {
  Chance chance(101);
  for (int i = 0; i < 120; ++i) {
    const bool damped = i % 2 == 0;
    Mechanism mechanism = test::random_elastic(chance, sort(i / 2, damped));
    if (i % 5 == 0) mechanism = let_go(mechanism);
    const Structure structure = structure_of(mechanism);
    const ModalModel model = modal_model_of(structure, all);
    const double f = frequency_between(chance, model.modes);
    const Deformation<Complex> direct = harmonic_response(structure, f);
    const Deformation<Complex> modal = harmonic_response(model, f);
    CAPTURE(i, damped, f, model.modes.size(), model.modes[0].frequency);
    CHECK(difference(modal.motion, direct.motion) < 1e-7);
    CHECK(difference(modal.joints, direct.joints) < 1e-7);
  }
}

TEST_CASE("Static correction: joints, loads and the inertia of however few modes are in balance",
          "[flexible][modal]") {
  Chance chance(102);
  for (int i = 0; i < 100; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i / 2, i % 2 == 0));
    const Structure structure = structure_of(mechanism);
    const ModalModel model = modal_model_of(structure, static_cast<std::size_t>(chance.one_of(6)));
    const double f = frequency_between(chance, model.modes);
    const Deformation<Complex> response = harmonic_response(model, f);
    const Deformation<Complex> modes = harmonic_response(model, f, false);
    const Eigen::Vector3cd on_ground = test::ground_force(structure, response);
    const Eigen::Vector3cd load = test::resultant<Complex>(structure, harmonic_loads(structure));
    const Eigen::Vector3cd inertia =
        std::pow(hertz * f, 2) *
        test::resultant<Complex>(structure, mass_times<Complex>(structure, modes.motion));
    CAPTURE(i, f, model.modes.size());
    CHECK((on_ground + load + inertia).norm() < 1e-9 * std::max(load.norm(), inertia.norm()));
  }
}

TEST_CASE("Root moment of a cantilever: one mode with static correction beats ten without",
          "[flexible][modal]") {
  // A force F sin(omega t) at the tip of a bar without shear and rotary inertia, r = omega/omega_1.
  // From the differential equation M = F L (sin x + sinh x)/(x (1 + cos x cosh x)), x = root
  // sqrt(r); from its first mode M = F L 4/(root^2 (1 - r^2)), and with the others static
  // F L (1 + 4 r^2/(root^2 (1 - r^2))).
  Mechanism mechanism = test::cantilever_of(Bar{}, 200, Element::corrected);
  mechanism.loads = {test::load_at(1.0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0})};
  const Structure structure = structure_of(mechanism);
  const double root = 1.8751040687119612;
  const auto moment = [&](double r, std::size_t modes, bool corrected) {
    const ModalModel model = modal_model_of(structure, modes);
    return std::abs(harmonic_response(model, root * root * r / hertz, corrected).joints(2, 0));
  };
  for (const double r : {0.1, 0.3, 0.6}) {
    CAPTURE(r);
    const double x = root * std::sqrt(r);
    const double exact = (std::sin(x) + std::sinh(x)) / (x * (1.0 + std::cos(x) * std::cosh(x)));
    const double first = 4.0 / (root * root * (1.0 - r * r));
    CHECK(moment(r, 1, false) == Approx(first).epsilon(1e-5));
    CHECK(moment(r, 1, true) == Approx(1.0 + r * r * first).epsilon(1e-5));
    const auto error = [&](std::size_t modes, bool corrected) {
      return std::abs(moment(r, modes, corrected) / exact - 1.0);
    };
    CHECK(error(1, false) > 0.1 * (1.0 - r * r));
    CHECK(error(1, true) < 5e-3 * r * r);
    CHECK(error(1, true) < error(10, false));
    CHECK(error(3, true) < 0.1 * error(1, true));
  }
}

TEST_CASE("An oscillator's force over frequency", "[flexible][modal]") {
  for (const double c : {0.0, 4.0}) {
    Oscillator of;
    of.c = c;
    of.force = std::polar(5.0, 0.7);
    const Mechanism mechanism = of.mechanism(0.0);
    const Structure structure = structure_of(mechanism);
    const Sweep sweep = sweep_of(modal_model_of(structure, 1), {0.5, 1.0, 2.0, 2.6, 7.0});
    REQUIRE(sweep.joints.size() == 1);
    for (std::size_t i = 0; i < sweep.frequencies.size(); ++i) {
      const double omega = hertz * sweep.frequencies[i];
      const Complex force = -Complex(of.k, omega * c) * of.motion(omega);
      CAPTURE(c, omega);
      CHECK(std::abs(sweep.joints[0][i].x() - force) < 1e-12 * std::abs(force));
      CHECK(std::abs(sweep.joints[0][i].y()) < 1e-12 * std::abs(force));
    }
  }
}

TEST_CASE("An oscillator started suddenly: beat, resonance and decay", "[flexible][modal]") {
  Oscillator of;
  of.weight = 11.0;
  const double own = std::sqrt(of.k / of.m);
  const auto check = [&](double omega, const auto& x, const auto& speed) {
    const Mechanism mechanism = of.mechanism(omega / hertz);
    const Structure structure = structure_of(mechanism);
    const SuddenStart start = sudden_start_of(modal_model_of(structure, 1), 10.0, 1000);
    REQUIRE(start.times.size() == 1001);
    CHECK(start.times[1000] == Approx(10.0));
    for (std::size_t i = 0; i < start.times.size(); ++i) {
      const double t = start.times[i];
      const double force = -of.weight - of.k * x(t) - of.c * speed(t);
      CAPTURE(omega, t);
      CHECK(start.joints[0][i].x() == Approx(force).margin(1e-9));
    }
  };
  const auto none = [](double) { return 0.0; };
  const double F = of.force.real();
  for (const double omega : {0.3 * own, 0.9 * own, 1.4 * own}) {
    check(
        omega,
        [&](double t) {
          return F / of.m / (own * own - omega * omega) *
                 (std::sin(omega * t) - omega / own * std::sin(own * t));
        },
        none);
  }
  check(
      own,
      [&](double t) {
        return F / (2.0 * of.k) * (std::sin(own * t) - own * t * std::cos(own * t));
      },
      none);

  of.c = 6.0;
  of.force = std::polar(5.0, -1.1);
  const double decay = of.c / (2.0 * of.m);
  const Complex free(-decay, std::sqrt(own * own - decay * decay));
  for (const double omega : {0.3 * own, own, 1.4 * own}) {
    // At rest at t = 0: x = Im(X e^(i omega t) + A e^(free t) + B e^(conj(free) t)) in real form.
    const Complex X = of.motion(omega);
    const double a = -X.imag();
    const double b = (-omega * X.real() + decay * a) / free.imag();
    const Complex A(a, -b);  // Re(A e^(free t)) = e^(-decay t) (a cos + b sin)
    const Complex drive(0.0, omega);
    check(
        omega,
        [&](double t) {
          return (X * std::exp(drive * t)).imag() + (A * std::exp(free * t)).real();
        },
        [&](double t) {
          return (drive * X * std::exp(drive * t)).imag() + (free * A * std::exp(free * t)).real();
        });
  }
}

TEST_CASE("A sudden start with damping ends in the harmonic response, whatever the steps",
          "[flexible][modal]") {
  Chance chance(103);
  for (int i = 0; i < 30; ++i) {
    Mechanism mechanism = test::random_elastic(chance, sort(i, true));
    mechanism.frequency = test::power_of_ten(chance, 0.0, 1.5);
    constexpr double retardation = 2e-3;
    for (Link& link : mechanism.links) link.retardation = retardation;
    for (Joint& joint : mechanism.joints) {
      for (const std::size_t axis : {0U, 1U, 2U}) {
        if (std::isfinite(joint.stiffness[axis])) {
          joint.damping[axis] = retardation * joint.stiffness[axis];
        }
      }
    }
    const Structure structure = structure_of(mechanism);
    const ModalModel model = modal_model_of(structure, 5);
    // C = tau K: free vibrations decay as e^(-tau omega_j^2 t/2), or slower than e^(-t/(2 tau))
    // never.
    const double slowest = std::pow(hertz * model.modes[0].frequency, 2) * retardation / 2.0;
    const double length = 40.0 / std::min(slowest, 0.5 / retardation);
    const SuddenStart start = sudden_start_of(model, length, 500);
    const SuddenStart finer = sudden_start_of(model, length, 1000);
    const Deformation<double> constant = static_response(structure);
    const Deformation<Complex> harmonic = harmonic_response(model, mechanism.frequency);
    const Complex turn = std::polar(1.0, hertz * mechanism.frequency * length);
    Deformation<double> last;
    last.joints = constant.joints + (turn * harmonic.joints).imag();
    const double size = harmonic.joints.cwiseAbs().maxCoeff();
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      CAPTURE(i, j, length);
      CHECK((start.joints[j].back() - joint_force(structure, j, last)).norm() < 1e-8 * size);
      for (std::size_t k = 0; k <= 500; ++k) {
        CHECK((start.joints[j][k] - finer.joints[j][2 * k]).norm() < 1e-8 * size);
      }
    }
  }
}

TEST_CASE("Resonance without damping is refused where the loads excite the mode",
          "[flexible][modal]") {
  // Pinned at both ends and loaded in the middle: nothing excites the second mode.
  Mechanism mechanism = test::beam_of(Bar{}, 16, End::pinned, End::pinned, Element::corrected);
  mechanism.loads = {test::load_at(0.5, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0})};
  const Structure structure = structure_of(mechanism);
  const ModalModel model = modal_model_of(structure, 4);
  const double first = model.modes[0].frequency;
  CHECK_THROWS_AS(harmonic_response(model, first), AnalysisError);
  CHECK_THROWS_AS(sweep_of(model, {0.5 * first, first}), AnalysisError);
  CHECK_THROWS_WITH(harmonic_response(model, model.modes[2].frequency), Catch::Contains("mode 3"));
  CHECK_NOTHROW(harmonic_response(model, first * (1.0 + 1e-5)));
  const double second = model.modes[1].frequency;
  const Deformation<Complex> at = harmonic_response(model, second);
  const Deformation<Complex> beside = harmonic_response(model, second * (1.0 + 1e-5));
  CHECK(difference(at.motion, beside.motion) < 1e-3);

  mechanism.links[0].retardation = 1e-4;
  CHECK_NOTHROW(harmonic_response(modal_model_of(structure, 4), first));
}

TEST_CASE("Motions without strain must all be among the modes", "[flexible][modal]") {
  Mechanism mechanism = test::beam_of(Bar{}, 8, End::free, End::free, Element::corrected);
  mechanism.loads = {test::load_at(0.3, {0.0, 0.0, 0.0}, {1.0, 1.0, 0.5})};
  const Structure structure = structure_of(mechanism);
  CHECK_THROWS_AS(harmonic_response(modal_model_of(structure, 2), 1.0), AnalysisError);
  CHECK_NOTHROW(harmonic_response(modal_model_of(structure, 3), 1.0));
  CHECK_THROWS_AS(harmonic_response({&structure, {}, {}}, 1.0), AnalysisError);
}

}  // namespace modal_response_test
