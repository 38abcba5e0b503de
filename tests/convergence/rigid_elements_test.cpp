// Natural frequencies and responses of rigid finite elements against those of the continuous beam:
// the order with which they converge.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "support/continuous_beam.hpp"
#include "support/elastic_beams.hpp"
#include "support/frequency_count.hpp"

namespace rigid_elements_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::End;

namespace {

/// Relative error of the k-th frequency, omega/omega_exact - 1.
double frequency_error(const Mechanism& mechanism, std::size_t k, double exact_square) {
  const Structure structure = structure_of(mechanism);
  return std::sqrt(test::natural_square(structure, k, 1.3 * exact_square) / exact_square) - 1.0;
}

struct Convergence {
  std::vector<double> errors;  ///< each with twice the elements of the one before
  double order = 0.0;          ///< of the last two
};

template <class Error>
Convergence convergence_of(const std::vector<int>& sizes, const Error& error) {
  Convergence result;
  for (const int n : sizes) result.errors.push_back(error(n));
  const std::size_t last = result.errors.size() - 1;
  result.order = std::log2(std::abs(result.errors[last - 1] / result.errors[last]));
  return result;
}

}  // namespace

TEST_CASE(
    "orders of the frequencies of a beam without shear: 2 and 4 classical, 3 and 4 corrected") {
  // (beta L) of Euler and Bernoulli's beam; errors at 8 parts as measured by an independent
  // implementation of both forms (first frequency).
  struct Case {
    const char* name;
    End start, end;
    std::vector<double> beta;
    double classical, corrected;            ///< orders
    double classical_at_8, corrected_at_8;  ///< errors
  };
  const double pi = std::numbers::pi;
  const Case cases[] = {
      {"cantilever",
       End::clamped,
       End::free,
       {1.8751040687119612, 4.6940911329741746, 7.8547574382376126},
       2.0,
       3.0,
       3.60e-3,
       -1.05e-4},
      {"pinned", End::pinned, End::pinned, {pi, 2.0 * pi, 3.0 * pi}, 4.0, 4.0, -1.7e-5, -1.7e-5},
      {"clamped",
       End::clamped,
       End::clamped,
       {4.7300407448627040, 7.8532046240958376, 10.995607838001671},
       2.0,
       4.0,
       2.49e-2,
       -1.1e-4},
      {"clamped and pinned",
       End::clamped,
       End::pinned,
       {3.9266023120479188, 7.0685827456287320, 10.210176122813031},
       2.0,
       4.0,
       1.03e-2,
       -4.7e-5}};
  for (const Case& it : cases) {
    for (const Element element : {Element::classical, Element::corrected}) {
      const bool corrected = element == Element::corrected;
      for (std::size_t k = 1; k <= 3; ++k) {
        const Convergence found = convergence_of({8, 16, 32, 64}, [&](int n) {
          return frequency_error(test::beam_of(Bar{}, n, it.start, it.end, element), k,
                                 std::pow(it.beta[k - 1], 4));
        });
        CAPTURE(it.name, corrected, k, found.errors[0], found.errors[1], found.errors[2],
                found.errors[3], found.order);
        const double order = corrected ? it.corrected : it.classical;
        CHECK(found.order == Approx(order).margin(k == 1 ? 0.1 : 0.25));
        if (k == 1) {
          const double at_8 = corrected ? it.corrected_at_8 : it.classical_at_8;
          CHECK(found.errors[0] == Approx(at_8).epsilon(0.04));
        }
      }
    }
  }
}

TEST_CASE("free at both ends: two motions without strain, then the frequencies of a clamped beam") {
  for (const Element element : {Element::classical, Element::corrected}) {
    const double exact = std::pow(4.7300407448627040, 4);
    const Convergence found = convergence_of({8, 16, 32, 64}, [&](int n) {
      // Held along its axis, on a sliding contact across which nothing is held.
      Mechanism mechanism = test::beam_of(Bar{}, n, End::free, End::free, element);
      mechanism.joints.push_back(test::hold(mechanism, 0.0, {test::infinite, 0.0, 0.0}, "axial"));
      const Structure structure = structure_of(mechanism);
      CHECK(DynamicStiffness<double>(structure, 1e-3, 0.0).frequencies_below() == 2);
      CHECK(DynamicStiffness<double>(structure, 0.8 * exact, 0.0).frequencies_below() == 2);
      return frequency_error(mechanism, 3, exact);
    });
    const double order = element == Element::classical ? 4.0 : 3.0;
    CAPTURE(static_cast<int>(element), found.errors[0], found.errors[3]);
    CHECK(found.order == Approx(order).margin(0.15));
  }
}

TEST_CASE("axial rods: (2 k - 1) pi/2 sqrt(EA/mu)/L, order 2") {
  for (const Element element : {Element::classical, Element::corrected}) {
    for (std::size_t k = 1; k <= 3; ++k) {
      const double beta = (2.0 * static_cast<double>(k) - 1.0) * std::numbers::pi / 2.0;
      const Convergence found = convergence_of({16, 32, 64}, [&](int n) {
        return frequency_error(test::cantilever_of(Bar{}, n, element, LinkKind::axial), k,
                               beta * beta);
      });
      // Masses between springs, halves at the ends: omega = 2 n sin(beta/(2 n)) by hand.
      const double exact = 2.0 * 64 * std::sin(beta / 128.0) / beta - 1.0;
      CHECK(found.errors[2] == Approx(exact).epsilon(1e-6));
      CHECK(found.order == Approx(2.0).margin(0.02));
    }
  }
}

TEST_CASE("with shear and rotary inertia: order 2, corrected many times closer in the first") {
  // Cantilever of Timoshenko, rectangle, nu = 0.3, shear coefficient 5/6: frequencies by an
  // independent solution of its equation, EI = mu = L = 1.
  struct Case {
    double slenderness;  ///< h/L
    std::vector<double> omega;
  };
  const Case cases[] = {{0.05, {3.509026846582, 21.73458026269, 59.76025337038}},
                        {0.1, {3.488354951181, 20.90691543849, 54.98837972198}},
                        {0.2, {3.409783152514, 18.3637030909, 43.70908209275}}};
  for (const Case& it : cases) {
    const double j = it.slenderness * it.slenderness / 12.0;
    const Bar bar{1.0, 1.0, 1.0 / (j * 2.6 * 1.2), 1.0, 1.0, j};
    for (std::size_t k = 1; k <= 3; ++k) {
      const double exact = it.omega[k - 1] * it.omega[k - 1];
      CHECK(std::sqrt(test::exact_square_near(bar, End::clamped, End::free, exact)) ==
            Approx(it.omega[k - 1]).epsilon(2e-12));
      const auto errors_of = [&](Element element) {
        return convergence_of({16, 32, 64, 128}, [&](int n) {
          return frequency_error(test::cantilever_of(bar, n, element), k, exact);
        });
      };
      const Convergence classical = errors_of(Element::classical);
      const Convergence corrected = errors_of(Element::corrected);
      CAPTURE(it.slenderness, k, classical.errors[3], corrected.errors[1], corrected.errors[2],
              corrected.errors[3]);
      CHECK(classical.order == Approx(2.0).margin(0.1));
      CHECK(corrected.order > 1.8);
      if (k == 1) CHECK(std::abs(corrected.errors[3]) < 0.2 * std::abs(classical.errors[3]));
    }
  }
}

TEST_CASE("a tapered beam: order 2 classical, 2 or better corrected") {
  // Wedge-like cantilever, EI = (2 - x)^3, mu = 2 - x: against its own limit, by a division of 2048
  // parts, whose error is (32/2048)^2 of that of the coarsest.
  for (const Element element : {Element::classical, Element::corrected}) {
    const auto tapered = [&](int n) {
      Mechanism mechanism = test::cantilever_of(Bar{}, n, element);
      LinkStretch& stretch = mechanism.links[0].stretches[0];
      stretch.EI.c = {8.0, -12.0, 6.0, -1.0, 0.0};
      stretch.mass.c = {2.0, -1.0, 0.0};
      return mechanism;
    };
    const Mechanism fine = tapered(2048);
    const Structure finest = structure_of(fine);
    const double exact = test::natural_square(finest, 1, 30.0);
    const Convergence found =
        convergence_of({8, 16, 32}, [&](int n) { return frequency_error(tapered(n), 1, exact); });
    CAPTURE(static_cast<int>(element), found.errors[0], found.errors[1], found.errors[2]);
    CHECK(found.order > 1.9);
    CHECK(std::abs(found.errors[2]) < 0.01);
  }
}

TEST_CASE("a joint in a node is exact, one between nodes has the error of the division") {
  // A prop at 0.37 L of a cantilever under a load at its end: by the force method R = P (shift at
  // the prop under the load)/(shift under one unit there).
  const double a = 0.37;
  const double R = (a * a * (3.0 - a) / 6.0) / (a * a * a / 3.0);
  const auto error = [&](int n, bool nodes, Element element) {
    Mechanism mechanism = test::cantilever_of(Bar{}, n, element);
    mechanism.nodes_at_joints = nodes;
    mechanism.joints.push_back(test::hold(mechanism, a, {0.0, test::infinite, 0.0}, "prop"));
    mechanism.loads = {test::load_at(1.0, {0.0, -1.0, 0.0})};
    const Structure structure = structure_of(mechanism);
    return joint_force(structure, 1, static_response(structure)).y() / R - 1.0;
  };
  double between = 0.0;
  for (int n = 100; n <= 128; ++n) {
    CAPTURE(n);
    CHECK(std::abs(error(n, true, Element::corrected)) < 1e-12);
    CHECK(n * n * std::abs(error(n, true, Element::classical)) < 4.0);
    between = std::max(between, n * n * std::abs(error(n, false, Element::corrected)));
  }
  CAPTURE(between);
  CHECK(between > 0.1);
  CHECK(between < 10.0);
}

}  // namespace rigid_elements_test
