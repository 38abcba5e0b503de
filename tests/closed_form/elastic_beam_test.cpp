// Elastic beams by rigid elements against textbook solutions. Statics: Timoshenko, Strength of
// Materials I (1955), chapters 5 and 6. Vibration: the continuous beam.

#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "catch.hpp"
#include "support/continuous_beam.hpp"
#include "support/elastic_beams.hpp"

namespace elastic_beam_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::End;

namespace {

struct Beam {
  Mechanism mechanism;
  Structure structure;

  explicit Beam(Mechanism of) : mechanism(std::move(of)), structure(structure_of(mechanism)) {}
  Beam(const Beam&) = delete;
  Beam& operator=(const Beam&) = delete;

  Deformation<double> statics() const { return static_response(structure); }
};

Mechanism with(Mechanism mechanism, double s, const Eigen::Vector3d& load) {
  mechanism.loads.push_back(test::load_at(s, load));
  return mechanism;
}

/// (u, w, phi) at a place of the axis.
Eigen::Vector3d at(const Beam& beam, const Deformation<double>& of, double s) {
  return motion_at(beam.structure, Attachment{0, {s, 0.0}}, of);
}

/// Steel, 4 m long and 0.5 m high: shear counts.
const Bar stout = test::steel_bar(4.0, 0.5, 0.2);

Bar without_shear(Bar bar) {
  bar.GA = 1e30;
  bar.rotary = 0.0;
  return bar;
}

constexpr int sizes[] = {1, 2, 3, 4, 7, 8, 16, 50, 100, 333, 1000};

}  // namespace

TEST_CASE("cantilever, classical: the tip is too stiff by exactly 1/(4 n^2)") {
  // Springs in the parts' middles: sum of D (L - s_i)^2/EI = L^3/(3 EI) (1 - 1/(4 n^2)).
  const Bar bar = without_shear(stout);
  const double exact = 1e4 * std::pow(bar.L, 3) / (3.0 * bar.EI);
  for (const int n : sizes) {
    const Beam beam(with(test::cantilever_of(bar, n, Element::classical), bar.L, {0.0, 1e4, 0.0}));
    const double w = at(beam, beam.statics(), bar.L).y();
    CAPTURE(n);
    const double error = w / (exact * (1.0 - 1.0 / (4.0 * n * n))) - 1.0;
    CHECK(std::abs(error) < 1e-14 * (10.0 + n));
    // The turn and the moment are exact.
    CHECK(at(beam, beam.statics(), bar.L).z() ==
          Approx(1e4 * bar.L * bar.L / (2.0 * bar.EI)).epsilon(1e-12));
  }
}

TEST_CASE("cantilever, corrected: exact with any number of elements, to round-off") {
  const double P = 1e4, N = 3e4, M = 7e3;
  for (const int n : sizes) {
    const Beam beam(with(test::cantilever_of(stout, n, Element::corrected, LinkKind::full), stout.L,
                         {N, P, M}));
    const double L = stout.L;
    const Eigen::Vector3d tip = at(beam, beam.statics(), L);
    const double w =
        P * L * L * L / (3.0 * stout.EI) + P * L / stout.GA + M * L * L / (2.0 * stout.EI);
    const double phi = P * L * L / (2.0 * stout.EI) + M * L / stout.EI;
    CAPTURE(n);
    CHECK(tip.x() == Approx(N * L / stout.EA).epsilon(1e-13));
    CHECK(tip.y() == Approx(w).epsilon(1e-14 * (10.0 + n)));
    CHECK(tip.z() == Approx(phi).epsilon(1e-14 * (10.0 + n)));
    // The clamp: -P, and the moment about it.
    const Eigen::Vector3d root = joint_force(beam.structure, 0, beam.statics());
    CHECK(root.x() == Approx(-N).epsilon(1e-14));
    CHECK(root.y() == Approx(-P).epsilon(1e-14));
    CHECK(root.z() == Approx(-(P * L + M)).epsilon(1e-13));
  }
}

TEST_CASE("round-off grows slowly with the number of elements") {
  // Stiffness matrices lose digits with n^2 to n^4, as their condition number; here no stiffness
  // is formed, and the error grows with n at most.
  for (const Element element : {Element::classical, Element::corrected}) {
    for (const int n : {10, 100, 1000, 10000, 100000}) {
      const Bar bar = without_shear(stout);
      const Beam beam(with(test::cantilever_of(bar, n, element), bar.L, {0.0, 1e4, 0.0}));
      const double exact = 1e4 * std::pow(bar.L, 3) / (3.0 * bar.EI);
      const double law = element == Element::classical ? 1.0 - 0.25 / n / n : 1.0;
      const double error = std::abs(at(beam, beam.statics(), bar.L).y() / (exact * law) - 1.0);
      CHECK(error < 2e-16 * (10.0 + n));
    }
  }
}

TEST_CASE("under its weight: q L^4/(8 EI) + q L^2/(2 GA), at any number of elements") {
  const double g = 9.81, q = stout.mass * g, L = stout.L;
  for (const int n : sizes) {
    for (const Element element : {Element::classical, Element::corrected}) {
      Mechanism mechanism = test::cantilever_of(stout, n, element);
      mechanism.gravity = {0.0, -g};
      const Beam beam(std::move(mechanism));
      const Eigen::Vector3d root = joint_force(beam.structure, 0, beam.statics());
      CAPTURE(n);
      CHECK(root.y() == Approx(q * L).epsilon(1e-13));
      CHECK(root.z() == Approx(q * L * L / 2.0).epsilon(1e-13));
      if (element == Element::classical) continue;
      const double w = -q * std::pow(L, 4) / (8.0 * stout.EI) - q * L * L / (2.0 * stout.GA);
      CHECK(at(beam, beam.statics(), L).y() == Approx(w).epsilon(1e-14 * (10.0 + n)));
    }
  }
}

TEST_CASE(
    "tapered cantilever, corrected: exact with any number of elements, to the rule of its "
    "integrals") {
  // EI = E0 (2 - x/L)^3, GA = G0 (2 - x/L), EA = A0 (2 - x/L). With t = 2 - x/L:
  // w = P int (L - x)^2/EI dx = P L^3/E0 int_1^2 (t - 1)^2/t^3 dt = P L^3/E0 (ln 2 - 5/8),
  // phi = P L^2/E0 int_1^2 (t - 1)/t^3 dt = P L^2/E0 / 8,
  // shear and axial: int_1^2 1/t dt = ln 2.
  const double L = 3.0, E0 = 2e6, G0 = 4e7, A0 = 1e8, P = 5e3, N = 2e4;
  for (const int n : {1, 2, 5, 10, 100, 1000}) {
    Mechanism mechanism = test::cantilever_of(Bar{L}, n, Element::corrected, LinkKind::full);
    LinkStretch& stretch = mechanism.links[0].stretches[0];
    stretch.EI.c = {8.0 * E0, -12.0 * E0 / L, 6.0 * E0 / (L * L), -E0 / (L * L * L), 0.0};
    stretch.GA.c = {2.0 * G0, -G0 / L, 0.0, 0.0, 0.0};
    stretch.EA.c = {2.0 * A0, -A0 / L, 0.0, 0.0, 0.0};
    const Beam beam(with(std::move(mechanism), L, {N, P, 0.0}));
    const Eigen::Vector3d tip = at(beam, beam.statics(), L);
    const double ln2 = std::log(2.0);
    // Springs by Gauss's rule with 7 points: in one part EI changes 8 times over.
    const double digits = n == 1 ? 1e-7 : n == 2 ? 1e-10 : 1e-13 * (10.0 + n / 10.0);
    CAPTURE(n);
    CHECK(tip.x() == Approx(N * L / A0 * ln2).epsilon(digits));
    CHECK(tip.y() == Approx(P * L * L * L / E0 * (ln2 - 0.625) + P * L / G0 * ln2).epsilon(digits));
    CHECK(tip.z() == Approx(P * L * L / E0 / 8.0).epsilon(digits));
  }
}

TEST_CASE("clamped and propped: 5/16 P, 3/8 q L, a couple at the prop") {
  const Bar bar = without_shear(stout);
  const double P = 1e4, L = bar.L, g = 9.81, q = bar.mass * g;
  for (const int n : {1, 2, 5, 8, 64}) {
    CAPTURE(n);
    const Mechanism propped = test::beam_of(bar, n, End::clamped, End::pinned, Element::corrected);
    {
      // The load in the middle has a node of its own.
      const Beam beam(with(propped, L / 2.0, {0.0, -P, 0.0}));
      const auto response = beam.statics();
      CHECK(joint_force(beam.structure, 1, response).y() == Approx(5.0 / 16.0 * P).epsilon(1e-12));
      CHECK(joint_force(beam.structure, 0, response).y() == Approx(11.0 / 16.0 * P).epsilon(1e-12));
      CHECK(joint_force(beam.structure, 0, response).z() ==
            Approx(3.0 / 16.0 * P * L).epsilon(1e-12));
      CHECK(at(beam, response, L / 2.0).y() ==
            Approx(-7.0 * P * L * L * L / (768.0 * bar.EI)).epsilon(1e-12));
    }
    {
      const Beam beam(with(propped, L, {0.0, 0.0, P}));
      const auto response = beam.statics();
      CHECK(joint_force(beam.structure, 1, response).y() == Approx(-1.5 * P / L).epsilon(1e-12));
      CHECK(joint_force(beam.structure, 0, response).z() == Approx(0.5 * P).epsilon(1e-12));
      CHECK(at(beam, response, L).z() == Approx(P * L / (4.0 * bar.EI)).epsilon(1e-12));
    }
    Mechanism heavy = propped;
    heavy.gravity = {0.0, -g};
    const Beam beam(std::move(heavy));
    const auto response = beam.statics();
    CHECK(joint_force(beam.structure, 1, response).y() == Approx(0.375 * q * L).epsilon(1e-12));
    CHECK(joint_force(beam.structure, 0, response).z() == Approx(q * L * L / 8.0).epsilon(1e-12));
  }
}

TEST_CASE("clamped and propped with shear: the prop by the force method") {
  // R = w_P(L)/(L^3/(3 EI) + L/GA), w_P(L) = P (a^2 (3 L - a)/(6 EI) + a/GA).
  const double P = 1e4, L = stout.L;
  for (const double a : {0.25, 0.5, 0.8}) {
    for (const int n : {1, 4, 30}) {
      const Beam beam(with(test::beam_of(stout, n, End::clamped, End::pinned, Element::corrected),
                           a * L, {0.0, -P, 0.0}));
      const double shift =
          P * (a * a * L * L * (3.0 * L - a * L) / (6.0 * stout.EI) + a * L / stout.GA);
      const double R = shift / (L * L * L / (3.0 * stout.EI) + L / stout.GA);
      CAPTURE(a, n);
      CHECK(joint_force(beam.structure, 1, beam.statics()).y() == Approx(R).epsilon(1e-12));
    }
  }
}

TEST_CASE("clamped at both ends: P L/8, q L^2/12; pinned: P L^3/(48 EI), 5 q L^4/(384 EI)") {
  const Bar bar = without_shear(stout);
  const double P = 1e4, L = bar.L, g = 9.81, q = bar.mass * g;
  for (const int n : {2, 4, 10, 100}) {
    CAPTURE(n);
    const Mechanism clamped = test::beam_of(bar, n, End::clamped, End::clamped, Element::corrected);
    const Beam pressed(with(clamped, L / 2.0, {0.0, -P, 0.0}));
    const auto response = pressed.statics();
    CHECK(joint_force(pressed.structure, 0, response).z() == Approx(P * L / 8.0).epsilon(1e-12));
    CHECK(joint_force(pressed.structure, 1, response).z() == Approx(-P * L / 8.0).epsilon(1e-12));
    CHECK(at(pressed, response, L / 2.0).y() ==
          Approx(-P * L * L * L / (192.0 * bar.EI)).epsilon(1e-12));
    Mechanism heavy = clamped;
    heavy.gravity = {0.0, -g};
    const Beam beam(std::move(heavy));
    CHECK(joint_force(beam.structure, 0, beam.statics()).z() ==
          Approx(q * L * L / 12.0).epsilon(1e-12));

    const Mechanism pinned = test::beam_of(bar, n, End::pinned, End::pinned, Element::corrected);
    const Beam bent(with(pinned, L / 2.0, {0.0, -P, 0.0}));
    CHECK(at(bent, bent.statics(), L / 2.0).y() ==
          Approx(-P * L * L * L / (48.0 * bar.EI)).epsilon(1e-12));
    CHECK(at(bent, bent.statics(), 0.0).z() == Approx(-P * L * L / (16.0 * bar.EI)).epsilon(1e-12));
    Mechanism sagging = pinned;
    sagging.gravity = {0.0, -g};
    const Beam sag(std::move(sagging));
    CHECK(at(sag, sag.statics(), L / 2.0).y() ==
          Approx(-5.0 * q * std::pow(L, 4) / (384.0 * bar.EI)).epsilon(1e-12));
    CHECK(joint_force(sag.structure, 0, sag.statics()).y() == Approx(q * L / 2.0).epsilon(1e-12));
    CHECK(joint_force(sag.structure, 1, sag.statics()).y() == Approx(q * L / 2.0).epsilon(1e-12));
  }
}

TEST_CASE("two equal spans: the middle bears 5/4 of a span's weight") {
  const Bar bar = without_shear(stout);
  const double L = bar.L, q = bar.mass * 9.81;
  for (const int n : {2, 6, 40}) {
    Mechanism mechanism = test::beam_of(bar, n, End::pinned, End::pinned, Element::corrected);
    mechanism.joints.push_back(test::hold(mechanism, L / 2.0, {0.0, test::infinite, 0.0}, "mid"));
    mechanism.gravity = {0.0, -9.81};
    const Beam beam(std::move(mechanism));
    CAPTURE(n);
    CHECK(joint_force(beam.structure, 2, beam.statics()).y() ==
          Approx(1.25 * q * L / 2.0).epsilon(1e-12));
  }
}

TEST_CASE("an axial rod: N L/EA at its end, q L^2/(2 EA) under its weight") {
  const Bar bar = stout;
  for (const int n : {1, 3, 10, 1000}) {
    for (const Element element : {Element::classical, Element::corrected}) {
      Mechanism mechanism = test::cantilever_of(bar, n, element, LinkKind::axial);
      mechanism.gravity = {9.81, 0.0};
      const Beam beam(with(std::move(mechanism), bar.L, {5e4, 0.0, 0.0}));
      const double q = bar.mass * 9.81, L = bar.L;
      CAPTURE(n);
      CHECK(at(beam, beam.statics(), L).x() ==
            Approx((5e4 * L + q * L * L / 2.0) / bar.EA).epsilon(1e-12));
      CHECK(at(beam, beam.statics(), L).y() == 0.0);
      CHECK(joint_force(beam.structure, 0, beam.statics()).x() ==
            Approx(-5e4 - q * L).epsilon(1e-13));
    }
  }
}

TEST_CASE("the continuous beam of these tests: textbook frequencies and receptance") {
  // The reference itself: Euler and Bernoulli's cantilever, beta L = 1.8751040687119612, and
  // w(L) = F (sin b cosh b - cos b sinh b)/(EI beta^3 (1 + cos b cosh b)).
  const Bar bar;
  CHECK(exact_square_near(bar, End::clamped, End::free, 12.0) ==
        Approx(std::pow(1.8751040687119612, 4)).epsilon(1e-14));
  CHECK(exact_square_near(bar, End::clamped, End::pinned, 237.0) ==
        Approx(std::pow(3.9266023120479188, 4)).epsilon(1e-14));
  CHECK(exact_square_near(bar, End::clamped, End::clamped, 500.0) ==
        Approx(std::pow(4.7300407448627040, 4)).epsilon(1e-14));
  for (const double b : {0.7, 1.5, 3.0, 6.0}) {
    const double exact = (std::sin(b) * std::cosh(b) - std::cos(b) * std::sinh(b)) /
                         (std::pow(b, 3) * (1.0 + std::cos(b) * std::cosh(b)));
    const auto vibration = test::vibration_of(bar, End::clamped, std::pow(b, 4), 1.0, 0.0);
    CHECK(static_cast<double>(vibration.end[0]) == Approx(exact).epsilon(1e-12));
  }
  // Timoshenko's beam pinned at both ends, h/L = 0.1, nu = 0.3, shear coefficient 5/6:
  // Omega = 2 l^4/(a + sqrt(a^2 - 4 g j l^4)), a = (g + j) l^2 + 1, l = pi, j = I/(A L^2),
  // g = EI/(k GA L^2).
  const double j = 0.01 / 12.0, g = j * 2.6 * 1.2, l2 = std::pow(std::numbers::pi, 2);
  const double a = (g + j) * l2 + 1.0;
  const double Omega = 2.0 * l2 * l2 / (a + std::sqrt(a * a - 4.0 * g * j * l2 * l2));
  const Bar timoshenko{1.0, 1.0, 1.0 / g, 1.0, 1.0, j};
  CHECK(exact_square_near(timoshenko, End::pinned, End::pinned, 94.0) ==
        Approx(Omega).epsilon(1e-13));
}

TEST_CASE("harmonic response of a beam driven at its end, to the order of its division") {
  // Tip motion and clamp forces at 0.5, 0.9, 1.5 and 3 times the first frequency of Euler and
  // Bernoulli; classical elements order 2, corrected ones 3, with shear and rotary inertia 2.
  struct Case {
    Bar bar;
    Element element;
    double order;
    double coarse;  ///< error at n = 16, at most
  };
  Bar euler;
  Bar timoshenko{1.0, 1.0, 400.0, 1.0, 1.0, 1.0 / 1200.0};
  const Case cases[] = {{euler, Element::classical, 2.0, 0.1},
                        {euler, Element::corrected, 3.0, 0.01},
                        {timoshenko, Element::classical, 2.0, 0.1},
                        {timoshenko, Element::corrected, 2.0, 0.01}};
  for (const Case& it : cases) {
    for (const double r : {0.5, 0.9, 1.5, 3.0}) {
      const double square = std::pow(r, 2) * std::pow(1.8751040687119612, 4);
      const auto exact = test::vibration_of(it.bar, End::clamped, square, 2.0, 0.7);
      std::vector<double> errors;
      for (const int n : {16, 32, 64}) {
        const Mechanism mechanism = test::cantilever_of(it.bar, n, it.element);
        const Structure structure = structure_of(mechanism);
        auto loads = no_loads<double>(structure);
        loads[0].col(loads[0].cols() - 1) = Eigen::Vector3d(0.0, 2.0, 0.7);
        const auto response = DynamicStiffness<double>(structure, square, 0.0).solve(loads);
        const Eigen::Vector3d tip = response.motion[0].rightCols(1);
        const Eigen::Vector3d root = response.joints.col(0);
        const auto of = [](double value, long double truth) {
          return std::abs(value / static_cast<double>(truth) - 1.0);
        };
        errors.push_back(std::max({of(tip.y(), exact.end[0]), of(tip.z(), exact.end[1]),
                                   of(root.y(), -exact.start[2]), of(root.z(), -exact.start[3])}));
      }
      const double order = std::log2(errors[1] / errors[2]);
      CAPTURE(static_cast<int>(it.element), it.bar.rotary, r, errors[0], errors[1], errors[2]);
      CHECK(errors[0] < it.coarse);
      CHECK(order > it.order - 0.25);
    }
  }
}

}  // namespace elastic_beam_test
