// The recursion over the rigid elements against one dense system in longer numbers, and against
// what holds for every linear structure.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "catch.hpp"
#include "support/dense_structure.hpp"
#include "support/elastic_beams.hpp"

namespace dynamic_stiffness_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Chance;
using test::RandomMechanism;

namespace {

double square_of(double frequency) {
  const double omega = 2.0 * std::numbers::pi * frequency;
  return omega * omega;
}

template <class Scalar>
LinkColumns<Scalar> random_loads(Chance& chance, const Structure& structure) {
  LinkColumns<Scalar> loads = no_loads<Scalar>(structure);
  for (auto& link : loads) {
    for (Eigen::Index i = 0; i < link.size(); ++i) {
      if constexpr (std::is_same_v<Scalar, Complex>) {
        link(i) = Complex(chance.any(1e3), chance.any(1e3));
      } else {
        link(i) = chance.any(1e3);
      }
    }
  }
  return loads;
}

/// Sum of products, not conjugated: the work of loads on a motion.
template <class Scalar>
Scalar work(const LinkColumns<Scalar>& loads, const LinkColumns<Scalar>& motion) {
  Scalar sum{};
  for (std::size_t l = 0; l < loads.size(); ++l) {
    sum += loads[l].cwiseProduct(motion[l]).sum();
  }
  return sum;
}

/// The largest difference of two deformations over the largest entry: motion (shifts and turns) and
/// joint forces apart; shifts and turns of a mechanism of some metres are of one size.
struct Difference {
  double motion = 0.0, joints = 0.0;
};
template <class Scalar>
Difference difference(const Deformation<Scalar>& a, const Deformation<Complex>& b) {
  double size = 0.0, most = 0.0;
  for (std::size_t l = 0; l < b.motion.size(); ++l) {
    size = std::max(size, b.motion[l].cwiseAbs().maxCoeff());
    const Eigen::Matrix<Complex, 3, -1> gap = a.motion[l].template cast<Complex>() - b.motion[l];
    most = std::max(most, gap.cwiseAbs().maxCoeff());
  }
  const Eigen::Matrix<Complex, 3, -1> gap = a.joints.template cast<Complex>() - b.joints;
  return {most / size, gap.cwiseAbs().maxCoeff() / b.joints.cwiseAbs().maxCoeff()};
}

RandomMechanism sort(int i) {
  RandomMechanism want;
  want.links = 1 + i % 4;
  want.closed = i % 2 == 1;
  want.rigid_joints = i % 3 == 1;
  want.nodes_at_joints = i % 5 != 0;
  want.element = i % 4 < 2 ? Element::corrected : Element::classical;
  return want;
}

}  // namespace

TEST_CASE("motion and joint forces are those of the dense system: statics") {
  Chance chance(81);
  for (int i = 0; i < 40; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Structure structure = structure_of(mechanism);
    const LinkColumns<double> loads = random_loads<double>(chance, structure);
    const auto dense = test::DenseStructure(structure).solve(0.0, loads);
    REQUIRE(dense.residual < 1e-12);
    const Difference gap =
        difference(DynamicStiffness<double>(structure, 0.0, 0.0).solve(loads), dense.deformation);
    CAPTURE(i, structure.elements());
    CHECK(gap.motion < 1e-13);
    CHECK(gap.joints < 1e-13);
  }
}

TEST_CASE("motion and joint forces are those of the dense system: vibration and shifts") {
  Chance chance(82);
  for (int i = 0; i < 60; ++i) {
    RandomMechanism want = sort(i);
    want.damped = i % 6 < 3;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    double square = square_of(test::power_of_ten(chance, -1.0, 2.5));
    Difference gap;
    if (want.damped) {
      const auto loads = random_loads<Complex>(chance, structure);
      gap = difference(DynamicStiffness<Complex>(structure, square, std::sqrt(square)).solve(loads),
                       test::DenseStructure(structure).solve(square, loads).deformation);
    } else {
      if (i % 6 == 5) square = -square;  // the shift of an eigenvalue problem
      const auto loads = random_loads<double>(chance, structure);
      gap = difference(DynamicStiffness<double>(structure, square, 0.0).solve(loads),
                       test::DenseStructure(structure).solve(square, loads).deformation);
    }
    CAPTURE(i, structure.elements(), square, want.damped);
    CHECK(gap.motion < 1e-9);
    CHECK(gap.joints < 1e-9);
  }
}

TEST_CASE("the count of natural frequencies below is that of the dense system's inertia") {
  // [[-s M, G^T], [G, -F]] has one negative eigenvalue for every force and, by Sylvester's law of
  // inertia, one for every natural frequency below.
  Chance chance(87);
  for (int i = 0; i < 40; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Structure structure = structure_of(mechanism);
    std::size_t forces = 0;
    for (const DividedLink& link : structure.links) forces += 3 * link.springs.size();
    for (const Joint& joint : mechanism.joints) {
      for (const double c : joint.stiffness) forces += c > 0.0 ? 1 : 0;
    }
    for (const double frequency : {1.0, 30.0, 400.0, 3000.0}) {
      const double square = square_of(frequency);
      const Eigen::MatrixXd A =
          test::DenseStructure(structure).scaled(square).real().cast<double>();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A, Eigen::EigenvaluesOnly);
      const auto negative = static_cast<std::size_t>((eigen.eigenvalues().array() < 0.0).count());
      CAPTURE(i, frequency, structure.elements());
      CHECK(DynamicStiffness<double>(structure, square, 0.0).frequencies_below() + forces ==
            negative);
    }
  }
}

TEST_CASE("reciprocity: the work of one load on the motion of another is mutual") {
  Chance chance(83);
  for (int i = 0; i < 80; ++i) {
    RandomMechanism want = sort(i);
    want.damped = true;
    want.links += 2;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    {
      const auto p = random_loads<double>(chance, structure);
      const auto q = random_loads<double>(chance, structure);
      const DynamicStiffness<double> statics(structure, 0.0, 0.0);
      const double pq = work(p, statics.solve(q).motion), qp = work(q, statics.solve(p).motion);
      const double size =
          std::sqrt(work(p, statics.solve(p).motion) * work(q, statics.solve(q).motion));
      CAPTURE(i);
      CHECK(std::abs(pq - qp) < 1e-12 * size);
    }
    const auto p = random_loads<Complex>(chance, structure);
    const auto q = random_loads<Complex>(chance, structure);
    const double square = square_of(5.0 + chance.any(4.0));
    const DynamicStiffness<Complex> vibration(structure, square, std::sqrt(square));
    const auto of_p = vibration.solve(p), of_q = vibration.solve(q);
    const double size = std::max(std::abs(work(p, of_p.motion)), std::abs(work(q, of_q.motion)));
    CHECK(std::abs(work(p, of_q.motion) - work(q, of_p.motion)) < 1e-10 * size);
  }
}

TEST_CASE("statically no load does negative work, and with damping none gives energy back") {
  Chance chance(84);
  for (int i = 0; i < 60; ++i) {
    RandomMechanism want = sort(i);
    want.damped = true;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    const auto p = random_loads<double>(chance, structure);
    CHECK(work(p, DynamicStiffness<double>(structure, 0.0, 0.0).solve(p).motion) > 0.0);
    const double square = square_of(7.0);
    // Mean power 1/2 Re(conj(f) i omega q) >= 0: the imaginary part of conj(f) q is not positive.
    auto f = random_loads<Complex>(chance, structure);
    const auto q = DynamicStiffness<Complex>(structure, square, std::sqrt(square)).solve(f).motion;
    for (auto& link : f) link = link.conjugate().eval();
    const Complex power = work(f, q);
    CHECK(power.imag() < 1e-9 * std::abs(power));
  }
}

TEST_CASE("a link cut in two with a rigid joint is the same link") {
  Chance chance(85);
  for (int i = 0; i < 60; ++i) {
    Link link = test::random_link(chance);
    while (link.kind == LinkKind::rigid) link = test::random_link(chance);
    link.parts = 12;
    link.stretches.resize(1);
    link.stretches[0].start = 0.0;
    link.stretches[0].length = link.length;
    // More rotary inertia than the corrected form needs for the mass of an end that moves, which
    // a cut would add.
    link.stretches[0].rotary.c = {0.01 * link.stretches[0].mass.c[0] * link.length * link.length};
    link.angle = chance.any(3.0);
    Mechanism whole;
    whole.element = i % 2 == 0 ? Element::corrected : Element::classical;
    whole.gravity = {1.0, -9.81};
    whole.links = {link};
    whole.joints = {test::hold(whole, 0.0, {1e7, 2e7, 1e6}, "root")};
    if (i % 3 == 0) {
      whole.joints.push_back(test::hold(whole, link.length, {0.0, 3e6, 0.0}, "tip"));
    }
    whole.loads = {test::load_at(link.length, {1e3, 2e3, 500.0}, {300.0, 100.0, -50.0})};

    const double cut = link.length / 3.0;  // a node: 4 and 8 parts
    Mechanism halves = whole;
    Link& first = halves.links[0];
    first.length = first.stretches[0].length = cut;
    first.parts = 4;
    Link second = link;
    second.name = "rest";
    second.length = second.stretches[0].length = link.length - cut;
    second.parts = 8;
    second.origin = Eigen::Rotation2Dd(link.angle) * Eigen::Vector2d(cut, 0.0);
    const auto shift = [&](auto& p) {  // p(x + cut)
      auto c = p.c;
      for (std::size_t m = 0; m < c.size(); ++m) {
        p.c[m] = 0.0;
        double binomial = 1.0;
        for (std::size_t n = m; n < c.size(); ++n) {
          p.c[m] += binomial * c[n] * std::pow(cut, static_cast<double>(n - m));
          binomial *= static_cast<double>(n + 1) / static_cast<double>(n + 1 - m);
        }
      }
    };
    LinkStretch& rest = second.stretches[0];
    shift(rest.EA), shift(rest.GA), shift(rest.EI), shift(rest.mass), shift(rest.rotary);
    halves.links.push_back(second);
    halves.joints.push_back({"weld",
                             {0, {cut, 0.0}},
                             {1, {0.0, 0.0}},
                             0.3,
                             {test::infinite, test::infinite, test::infinite},
                             {}});
    if (i % 3 == 0) halves.joints[1].a = {1, {link.length - cut, 0.0}};
    halves.loads[0].at = {1, {link.length - cut, 0.0}};

    const Structure a = structure_of(whole), b = structure_of(halves);
    REQUIRE(a.links[0].springs.size() == 12);
    REQUIRE(b.links[0].springs.size() + b.links[1].springs.size() == 12);
    const auto compare = [&](const auto& p, const auto& q) {
      const double size = p.motion[0].cwiseAbs().maxCoeff();
      CHECK((p.motion[0].leftCols(5) - q.motion[0]).cwiseAbs().maxCoeff() < 1e-11 * size);
      CHECK((p.motion[0].rightCols(9) - q.motion[1]).cwiseAbs().maxCoeff() < 1e-11 * size);
      const auto joints = p.joints.cols();
      const double force = p.joints.cwiseAbs().maxCoeff();
      CHECK((p.joints - q.joints.leftCols(joints)).cwiseAbs().maxCoeff() < 1e-11 * force);
    };
    CAPTURE(i, static_cast<int>(link.kind), static_cast<int>(whole.element));
    compare(static_response(a), static_response(b));
    compare(harmonic_response(a, 2.3), harmonic_response(b, 2.3));
  }
}

TEST_CASE("what damps in the material only is a structure of complex moduli") {
  // K (1 + i omega tau) q = f without mass: the static answer over 1 + i omega tau, joints included
  // where they are rigid.
  Chance chance(86);
  Mechanism mechanism = test::cantilever_of(test::Bar{1.5, 1e8, 4e7, 1e6, 1e-9}, 7,
                                            Element::corrected, LinkKind::full);
  mechanism.links[0].retardation = 2e-3;
  const Structure structure = structure_of(mechanism);
  const auto loads = random_loads<Complex>(chance, structure);
  const double omega = 400.0;
  const auto statics = DynamicStiffness<Complex>(structure, 0.0, 0.0).solve(loads);
  const auto vibration = DynamicStiffness<Complex>(structure, omega * omega, omega).solve(loads);
  const Complex viscous(1.0, omega * 2e-3);
  const double size = statics.motion[0].cwiseAbs().maxCoeff();
  CHECK((vibration.motion[0] * viscous - statics.motion[0]).cwiseAbs().maxCoeff() < 1e-9 * size);
}

}  // namespace dynamic_stiffness_test
