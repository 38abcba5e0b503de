#include "boxbeam/mechanism/flexible/modes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "support/elastic_beams.hpp"
#include "support/source_matrices.hpp"

namespace modes_test {

using namespace boxbeam::flexible;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Bar;
using test::End;
using test::matrices_of;
using test::SourceMatrices;

namespace {

constexpr double pi = std::numbers::pi;

double omega_of(const Mode& mode) { return 2.0 * pi * mode.frequency; }

std::vector<double> omegas_of(const Mechanism& mechanism, std::size_t count) {
  std::vector<double> omegas;
  for (const Mode& mode : modes_of(structure_of(mechanism), count)) {
    omegas.push_back(omega_of(mode));
  }
  return omegas;
}

double dot(const LinkColumns<double>& a, const LinkColumns<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].cwiseProduct(b[k]).sum();
  return sum;
}

/// Beams without shear and rotary inertia, EI = mass per length = length = 1: their frequencies are
/// the squares of `roots`.
struct Held {
  std::string name;
  End start, end;
  std::size_t without_strain;
  std::vector<double> roots;
  /// Published errors of the first frequency, 4, 8, 16, 32 parts, and their order.
  std::vector<double> classical, corrected;
  double classical_order, corrected_order;
};

// Roots of cos x cosh x = -1 (cantilever), = 1 (clamped, free), tan x = tanh x (clamped, pinned).
const std::vector<double> clamped_roots{4.7300407448627040, 7.8532046240958376, 10.995607838001671};
const std::vector<Held> held_beams{{"cantilever",
                                    End::clamped,
                                    End::free,
                                    0,
                                    {1.8751040687119612, 4.6940911329741746, 7.8547574382376126},
                                    {1.45e-2, 3.60e-3, 8.97e-4, 2.24e-4},
                                    {-8.7e-4, -1.05e-4, -1.30e-5, -1.6e-6},
                                    2,
                                    3},
                                   {"pinned",
                                    End::pinned,
                                    End::pinned,
                                    0,
                                    {pi, 2 * pi, 3 * pi},
                                    {-3.1e-4, -1.7e-5, -1.04e-6, -6.5e-8},
                                    {-3.1e-4, -1.7e-5, -1.04e-6, -6.5e-8},
                                    4,
                                    4},
                                   {"clamped",
                                    End::clamped,
                                    End::clamped,
                                    0,
                                    clamped_roots,
                                    {1.08e-1, 2.49e-2, 6.09e-3, 1.5e-3},
                                    {-3.2e-3, -1.1e-4, -5.7e-6, -3.4e-7},
                                    2,
                                    4},
                                   {"clamped and pinned",
                                    End::clamped,
                                    End::pinned,
                                    0,
                                    {3.9266023120479188, 7.0685827456287320, 10.210176122813031},
                                    {4.2e-2, 1.03e-2, 2.6e-3, 6.4e-4},
                                    {-1.1e-3, -4.7e-5, -2.6e-6, -1.6e-7},
                                    2,
                                    4},
                                   {"free", End::free, End::free, 3, clamped_roots, {}, {}, 4, 3}};

}  // namespace

TEST_CASE("Frequencies of uniform beams converge to the closed ones in the order of their elements",
          "[flexible][modes]") {
  for (const Held& held : held_beams) {
    for (const Element element : {Element::classical, Element::corrected}) {
      const bool classical = element == Element::classical;
      CAPTURE(held.name, classical);
      const auto errors_with = [&](int parts) {
        const std::vector<double> omegas =
            omegas_of(test::beam_of(Bar{}, parts, held.start, held.end, element),
                      held.without_strain + held.roots.size());
        std::vector<double> errors;
        for (std::size_t i = 0; i < held.without_strain; ++i) CHECK(omegas[i] == 0.0);
        // Four parts may have fewer modes than there are roots.
        const std::size_t there = std::min(held.roots.size(), omegas.size() - held.without_strain);
        for (std::size_t i = 0; i < there; ++i) {
          const double exact = held.roots[i] * held.roots[i];
          errors.push_back(omegas[held.without_strain + i] / exact - 1.0);
        }
        return errors;
      };
      const std::vector<double>& published = classical ? held.classical : held.corrected;
      for (std::size_t i = 0; i < published.size(); ++i) {
        // Two figures are printed, of some three.
        const double error = errors_with(4 << i)[0];
        CHECK(error == Approx(published[i]).epsilon(0.05));
      }
      const std::vector<double> coarse = errors_with(64);
      const std::vector<double> fine = errors_with(128);
      REQUIRE(coarse.size() == held.roots.size());
      REQUIRE(fine.size() == held.roots.size());
      for (std::size_t i = 0; i < fine.size(); ++i) {
        const double order = std::log2(std::abs(coarse[i] / fine[i]));
        CHECK(order == Approx(classical ? held.classical_order : held.corrected_order).margin(0.1));
      }
    }
  }
}

TEST_CASE("Rods along their axis: (2k - 1) pi/2 sqrt(EA/mass)/L, order two", "[flexible][modes]") {
  for (const Element element : {Element::classical, Element::corrected}) {
    for (const LinkKind kind : {LinkKind::axial, LinkKind::full}) {
      std::array<double, 2> first_errors{};
      for (const std::size_t fine : {0U, 1U}) {
        Bar bar;
        bar.L = 2.0;
        bar.EA = 9.0;
        bar.mass = 4.0;
        bar.EI = 1e4;  // bending far above
        bar.GA = 1e4;
        bar.rotary = 0.01;
        const std::vector<double> omegas =
            omegas_of(test::cantilever_of(bar, fine == 1 ? 80 : 40, element, kind), 2);
        for (std::size_t k = 0; k < 2; ++k) {
          const double exact = (2.0 * static_cast<double>(k) + 1.0) * pi / 2.0 * 1.5 / 2.0;
          CHECK(omegas[k] == Approx(exact).epsilon(1e-3 * static_cast<double>(1 + 8 * k)));
          if (k == 0) first_errors[fine] = omegas[k] / exact - 1.0;
        }
      }
      CHECK(std::log2(first_errors[0] / first_errors[1]) == Approx(2.0).margin(0.1));
    }
  }
}

TEST_CASE("Shear and rotary inertia: Timoshenko's beam", "[flexible][modes]") {
  // EI = mass = L = 1, rectangle of height h, Poisson's ratio 0.3, shear factor 1.2. Pinned: closed
  // form; cantilevers: roots of Timoshenko's frequency equation.
  struct Known {
    double h;
    End start, end;
    std::array<double, 3> omega;
  };
  const std::array<Known, 4> known{{
      {0.1, End::pinned, End::pinned, {9.707477234869, 37.096158847697, 78.154736289806}},
      {0.05, End::clamped, End::free, {3.509026846582, 21.73458026269, 59.76025337038}},
      {0.1, End::clamped, End::free, {3.488354951181, 20.90691543849, 54.98837972198}},
      {0.2, End::clamped, End::free, {3.409783152514, 18.3637030909, 43.70908209275}},
  }};
  for (const Known& beam : known) {
    Bar bar;
    bar.rotary = beam.h * beam.h / 12.0;                            // rho I
    bar.GA = 12.0 / (beam.h * beam.h) / (2.0 * (1.0 + 0.3)) / 1.2;  // E A/(2 (1 + nu) 1.2)
    for (const Element element : {Element::classical, Element::corrected}) {
      CAPTURE(beam.h, element == Element::classical);
      std::array<std::vector<double>, 3> omegas;
      for (std::size_t i = 0; i < 3; ++i) {
        omegas[i] = omegas_of(test::beam_of(bar, 32 << i, beam.start, beam.end, element), 3);
      }
      for (std::size_t j = 0; j < 3; ++j) {
        const double exact = beam.omega[j];
        const double coarse = omegas[1][j] - exact;
        const double fine = omegas[2][j] - exact;
        CHECK(std::log2(std::abs(coarse / fine)) == Approx(2.0).margin(0.25));
        // Without the term of order two.
        CHECK(omegas[2][j] + (omegas[2][j] - omegas[1][j]) / 3.0 == Approx(exact).epsilon(2e-7));
      }
    }
  }
  // Published with 64 corrected parts: within 2e-6.
  Bar bar;
  bar.rotary = 0.01 / 12.0;
  bar.GA = 1200.0 / 2.6 / 1.2;
  CHECK(omegas_of(test::cantilever_of(bar, 64, Element::corrected), 1)[0] ==
        Approx(3.488354951181).epsilon(2e-6));
}

TEST_CASE("A heavy body on a light cantilever: omega^2 from its two by two flexibility",
          "[flexible][modes]") {
  // Mass m, inertia J about the tip, the beam weighs nothing: eigenvalues of M F.
  const double m = 3.0;
  const double J = 0.5;
  Bar bar;
  bar.L = 2.0;
  bar.EI = 5.0;
  bar.mass = 1e-12;
  Mechanism mechanism = test::cantilever_of(bar, 3, Element::corrected);
  Link body;
  body.name = "body";
  body.kind = LinkKind::rigid;
  body.origin = {2.0, 0.0};
  body.angle = 1.0;
  body.rigid = {m, {0.0, 0.0}, J};
  mechanism.links.push_back(body);
  Joint weld;
  weld.name = "weld";
  weld.a = {0, {2.0, 0.0}};
  weld.b = {1, {0.0, 0.0}};
  weld.stiffness.fill(test::infinite);
  mechanism.joints.push_back(weld);

  Eigen::Matrix2d F;  // L^3/3EI, L^2/2EI; L^2/2EI, L/EI
  F << 8.0 / 15.0, 4.0 / 10.0, 4.0 / 10.0, 2.0 / 5.0;
  const Eigen::Matrix2d F_M = F * Eigen::Vector2d(m, J).asDiagonal();
  Eigen::Vector2d expected = F_M.eigenvalues().real().cwiseInverse().cwiseSqrt();
  std::sort(expected.begin(), expected.end());
  const std::vector<Mode> modes = modes_of(structure_of(mechanism), 2);
  CHECK(omega_of(modes[0]) == Approx(expected[0]).epsilon(1e-10));
  CHECK(omega_of(modes[1]) == Approx(expected[1]).epsilon(1e-10));
  // The weld accelerates the body: force on the beam, opposite on the body.
  const double phi = modes[0].shape.motion[1](2, 0);
  CHECK(modes[0].shape.joints(2, 1) == Approx(expected[0] * expected[0] * J * phi).epsilon(1e-9));
}

TEST_CASE("Random mechanisms: all that the dense matrices of the source have",
          "[flexible][modes]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    test::Chance chance(seed);
    test::RandomMechanism want;
    want.links = 1 + chance.one_of(5);
    want.closed = chance.one_of(2) == 0;
    want.element = Element::classical;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    const SourceMatrices matrices = matrices_of(structure);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(matrices.K, matrices.M);
    const VectorXd& squares = eigen.eigenvalues();

    const std::size_t count = std::min<std::size_t>(6, static_cast<std::size_t>(squares.size()));
    const std::vector<Mode> modes = modes_of(structure, count);
    REQUIRE(modes.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const double square = omega_of(modes[i]) * omega_of(modes[i]);
      // The dense solver has the round-off of its largest eigenvalue.
      const double round_off = 1e-15 * static_cast<double>(squares.size()) * squares.maxCoeff();
      const double exact = squares[static_cast<Index>(i)];
      CHECK(std::abs(square - exact) < 1e-9 * exact + round_off);
      for (std::size_t j = 0; j <= i; ++j) {
        const double product =
            dot(modes[j].shape.motion, mass_times(structure, modes[i].shape.motion));
        CHECK(product == Approx(i == j ? 1.0 : 0.0).margin(1e-8));
      }
    }
  }
}

TEST_CASE(
    "Long chains by Lanczos' method: as many modes as frequencies below the last, mass one, "
    "in balance with their inertia",
    "[flexible][modes]") {
  for (unsigned seed = 100; seed < 130; ++seed) {
    CAPTURE(seed);
    test::Chance chance(seed);
    test::RandomMechanism want;
    want.links = 6 + chance.one_of(5);
    want.closed = chance.one_of(2) == 0;
    want.rigid_joints = chance.one_of(2) == 0;
    want.element = chance.one_of(2) == 0 ? Element::classical : Element::corrected;
    Mechanism mechanism = test::random_elastic(chance, want);
    for (Link& link : mechanism.links) {
      if (link.kind != LinkKind::rigid) link.parts = 20 + chance.one_of(20);
    }
    const Structure structure = structure_of(mechanism);
    const std::vector<Mode> modes = modes_of(structure, 8);
    REQUIRE(modes.size() == 8);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double square = omega_of(modes[i]) * omega_of(modes[i]);
      const LinkColumns<double> inertia = mass_times(structure, modes[i].shape.motion);
      for (std::size_t j = 0; j <= i; ++j) {
        CHECK(dot(modes[j].shape.motion, inertia) == Approx(i == j ? 1.0 : 0.0).margin(1e-8));
      }
      // The static deformation under the inertia omega^2 M q is q.
      LinkColumns<double> load = inertia;
      for (auto& columns : load) columns *= square;
      const Deformation<double> under = DynamicStiffness<double>(structure, 0.0, 0.0).solve(load);
      double largest = 0.0;
      double off = 0.0;
      for (std::size_t k = 0; k < load.size(); ++k) {
        const Eigen::Matrix3Xd& q = modes[i].shape.motion[k];
        largest = std::max(largest, q.cwiseAbs().maxCoeff());
        off = std::max(off, (under.motion[k] - q).cwiseAbs().maxCoeff());
      }
      CHECK(off / largest < 1e-8);
      CHECK((under.joints - modes[i].shape.joints).cwiseAbs().maxCoeff() <
            1e-8 * under.joints.cwiseAbs().maxCoeff());
      const DynamicStiffness<double> above(structure, square * (1.0 + 1e-5), 0.0);
      CHECK(above.frequencies_below() == i + 1);
    }
  }
}

TEST_CASE("Frequencies that agree are all found", "[flexible][modes]") {
  // As many equal cantilevers, each on its own.
  for (const int parts : {4, 60}) {
    Mechanism mechanism = test::cantilever_of(Bar{}, parts, Element::corrected);
    for (int i = 1; i < 4; ++i) {
      mechanism.links.push_back(mechanism.links[0]);
      Joint joint = mechanism.joints[0];
      joint.a.link = i;
      mechanism.joints.push_back(joint);
    }
    const std::vector<double> one =
        omegas_of(test::cantilever_of(Bar{}, parts, Element::corrected), 3);
    const std::vector<double> all = omegas_of(mechanism, 10);
    REQUIRE(all.size() == 10);
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK(all[i] == Approx(one[i / 4]).epsilon(1e-10));
    }
  }
}

TEST_CASE("Free links: three motions without strain each, the others unchanged by the place",
          "[flexible][modes]") {
  for (const int parts : {5, 80}) {
    Mechanism mechanism = test::beam_of(Bar{}, parts, End::free, End::free, Element::corrected);
    const std::vector<double> one = omegas_of(mechanism, 5);
    Link other = mechanism.links[0];
    other.origin = {3.0, -2.0};
    other.angle = 0.7;
    mechanism.links.push_back(other);
    const std::vector<Mode> modes = modes_of(structure_of(mechanism), 8);
    REQUIRE(modes.size() == 8);
    for (std::size_t i = 0; i < 6; ++i) CHECK(modes[i].frequency == 0.0);
    CHECK(one[2] == 0.0);
    CHECK(omega_of(modes[6]) == Approx(one[3]).epsilon(1e-10));
    CHECK(omega_of(modes[7]) == Approx(one[3]).epsilon(1e-10));
  }
}

TEST_CASE("A body on springs: mass, springs and a lever by hand", "[flexible][modes]") {
  // Two equal vertical springs at +-a: heave sqrt(2c/m), pitch sqrt(2c a^2/J); held along x.
  Mechanism mechanism;
  Link body;
  body.name = "body";
  body.kind = LinkKind::rigid;
  body.rigid = {50.0, {0.0, 0.0}, 20.0};
  mechanism.links = {body};
  for (const double x : {-1.5, 1.5}) {
    Joint spring;
    spring.name = "spring";
    spring.a = {0, {x, 0.0}};
    spring.b = {ground, {x, 0.0}};
    spring.stiffness = {x < 0.0 ? test::infinite : 0.0, 4000.0, 0.0};
    mechanism.joints.push_back(spring);
  }
  const std::vector<double> omegas = omegas_of(mechanism, 5);
  REQUIRE(omegas.size() == 2);  // all that there are
  CHECK(omegas[0] == Approx(std::sqrt(8000.0 / 50.0)).epsilon(1e-12));
  CHECK(omegas[1] == Approx(std::sqrt(8000.0 * 2.25 / 20.0)).epsilon(1e-12));
  CHECK(modes_of(structure_of(mechanism), 0).empty());
}

TEST_CASE("Stiffer joints raise all frequencies, more mass lowers them", "[flexible][modes]") {
  // Rayleigh's principle.
  for (unsigned seed = 200; seed < 230; ++seed) {
    CAPTURE(seed);
    test::Chance chance(seed);
    const Mechanism mechanism = test::random_elastic(chance, {});
    const std::vector<double> before = omegas_of(mechanism, 5);
    Mechanism stiffer = mechanism;
    for (double& c : stiffer.joints[0].stiffness) c *= 2.0;
    Mechanism heavier = mechanism;
    for (Link& link : heavier.links) {
      link.rigid.mass *= 1.5;
      link.rigid.inertia *= 1.5;
      for (LinkStretch& stretch : link.stretches) {
        stretch.mass = 1.5 * stretch.mass;
        stretch.rotary = 1.5 * stretch.rotary;
      }
    }
    const std::vector<double> above = omegas_of(stiffer, 5);
    const std::vector<double> below = omegas_of(heavier, 5);
    for (std::size_t i = 0; i < std::min(before.size(), above.size()); ++i) {
      CHECK(above[i] >= before[i] * (1.0 - 1e-9));
      CHECK(below[i] == Approx(before[i] / std::sqrt(1.5)).epsilon(1e-8));
    }
  }
}

TEST_CASE("rigid links on rigid joints have no modes") {
  const Mechanism mechanism = test::beam_of(test::steel_bar(2.0, 0.1, 0.1), 8, End::pinned,
                                            End::pinned, Element::corrected, LinkKind::rigid);
  CHECK(modes_of(structure_of(mechanism), 6).empty());
}

TEST_CASE("two dozen modes are found, however many parts") {
  // A steel cantilever that is rigid along its axis: two coordinates per part.
  for (const int parts : {48, 50, 64, 65, 80, 100, 128}) {
    INFO(parts);
    const Mechanism mechanism =
        test::cantilever_of(test::steel_bar(2.0, 0.1, 0.1), parts, Element::corrected);
    const Structure structure = structure_of(mechanism);
    const std::vector<Mode> modes = modes_of(structure, 24);
    REQUIRE(modes.size() == 24);
    const double beyond = std::pow(omega_of(modes.back()) * (1.0 + 1e-6), 2);
    CHECK(DynamicStiffness<double>(structure, beyond, 0.0).frequencies_below() == 24);
  }
}

}  // namespace modes_test
