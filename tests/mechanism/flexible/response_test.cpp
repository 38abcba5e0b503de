#include "boxbeam/mechanism/flexible/response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "support/elastic_balance.hpp"
#include "support/elastic_beams.hpp"

namespace response_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Chance;
using test::RandomMechanism;

namespace {

constexpr double hertz = 2.0 * std::numbers::pi;

/// Mechanisms by chance of every sort, one after the other.
RandomMechanism sort(int i) {
  RandomMechanism want;
  want.links = 1 + i % 6;
  want.closed = i % 2 == 1;
  want.rigid_joints = i % 3 == 1;
  want.nodes_at_joints = i % 5 != 0;
  want.element = i % 4 < 2 ? Element::corrected : Element::classical;
  return want;
}

/// Damps all links and joints: near a resonance without damping two ways to one answer differ by
/// what their round-off shifts its frequency.
void not_near_resonance(Mechanism& mechanism) {
  for (Link& link : mechanism.links) link.retardation = 1e-3;
  for (Joint& joint : mechanism.joints) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (joint.stiffness[i] < test::infinite) joint.damping[i] = 1e-3 * joint.stiffness[i];
    }
  }
}

double size_of(const Deformation<double>& of) {
  double size = 0.0;
  for (const auto& motion : of.motion) size = std::max(size, motion.cwiseAbs().maxCoeff());
  return size;
}

}  // namespace

TEST_CASE("statics: the ground bears weight and load, forces and moments, whatever the mechanism") {
  Chance chance(71);
  for (int i = 0; i < 200; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Structure structure = structure_of(mechanism);
    const Deformation<double> response = static_response(structure);
    const Eigen::Vector3d ground = test::ground_force(structure, response);
    const test::WeightAndLoad outer = test::weight_and_load(mechanism);
    CAPTURE(i, (ground + outer.sum).transpose(), outer.size);
    CHECK((ground + outer.sum).norm() < 1e-11 * outer.size);
  }
}

TEST_CASE("harmonic motion: ground and load make the momentum, -omega^2 times the sum of M q") {
  Chance chance(72);
  for (int i = 0; i < 200; ++i) {
    RandomMechanism want = sort(i);
    want.damped = i % 7 < 4;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    const double f = test::power_of_ten(chance, -1.0, 2.5);
    const Deformation<Complex> response = harmonic_response(structure, f);
    const Eigen::Vector3cd ground = test::ground_force(structure, response);
    const Eigen::Vector3cd load = test::resultant<Complex>(structure, harmonic_loads(structure));
    const Eigen::Vector3cd momentum =
        test::resultant<Complex>(structure, mass_times<Complex>(structure, response.motion));
    const double omega = hertz * f;
    const double size = std::max(load.norm(), (omega * omega * momentum).norm());
    CAPTURE(i, f);
    CHECK((ground + load + omega * omega * momentum).norm() < 1e-10 * size);
  }
}

TEST_CASE("the loads of a structure have the resultant of those of its mechanism") {
  Chance chance(73);
  for (int i = 0; i < 100; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Structure structure = structure_of(mechanism);
    const test::WeightAndLoad outer = test::weight_and_load(mechanism);
    const Eigen::Vector3d sum = test::resultant<double>(structure, static_loads(structure));
    CHECK((sum - outer.sum).norm() < 1e-12 * outer.size);
  }
}

TEST_CASE("phases: a load amplitude sin(omega t + phase) and a response read at a time") {
  // A mass on a spring below its resonance follows its load: F sin(omega t + phase)/(c - m w^2).
  Mechanism mechanism;
  mechanism.links.resize(1);
  mechanism.links[0].kind = LinkKind::rigid;
  mechanism.links[0].rigid = {2.0, {0.0, 0.0}, 1.0};
  mechanism.joints = {test::hold(mechanism, 0.0, {800.0, 800.0, 500.0}, "spring")};
  mechanism.gravity = {0.0, -9.81};
  mechanism.loads = {test::load_at(0.0, {30.0, 0.0, 0.0}, {7.0, 0.0, 0.0})};
  mechanism.loads[0].phase = 0.6;
  mechanism.frequency = 2.0;
  const Structure structure = structure_of(mechanism);
  const Response response = response_of(structure);
  CHECK(response.frequency == 2.0);
  const double omega = hertz * 2.0;
  const double swing = 7.0 / (800.0 - 2.0 * omega * omega);
  for (const double time : {0.0, 0.07, 0.31}) {
    const Deformation<double> now = at(response, time);
    const double x = 30.0 / 800.0 + swing * std::sin(omega * time + 0.6);
    CHECK(now.motion[0](0, 0) == Approx(x).epsilon(1e-13));
    CHECK(now.motion[0](1, 0) == Approx(-2.0 * 9.81 / 800.0).epsilon(1e-13));
    // The spring pulls its a back.
    CHECK(joint_force(structure, 0, now).x() == Approx(-800.0 * x).epsilon(1e-13));
    CHECK(now.joints(0, 0) == Approx(-800.0 * x).epsilon(1e-13));
  }
}

TEST_CASE("twice the loads, twice the response; and a response is the sum of those of its loads") {
  Chance chance(74);
  for (int i = 0; i < 40; ++i) {
    Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Deformation<double> whole = static_response(structure_of(mechanism));
    Mechanism weight = mechanism, load = mechanism;
    weight.loads.clear();
    load.gravity.setZero();
    const Deformation<double> a = static_response(structure_of(weight));
    const Structure structure = structure_of(load);
    const Deformation<double> b = static_response(structure);
    // Without its loads a link need not have nodes at them: what is compared is the joints, which
    // are statically determinate in a tree.
    if (i % 2 == 0) {
      const double size = whole.joints.cwiseAbs().maxCoeff();
      CHECK((whole.joints - a.joints - b.joints).cwiseAbs().maxCoeff() < 1e-11 * size);
    }
    for (Load& twice : load.loads) twice.constant *= 2.0;
    const Deformation<double> c = static_response(structure_of(load));
    const double size = b.joints.cwiseAbs().maxCoeff();
    CHECK((c.joints - 2.0 * b.joints).cwiseAbs().maxCoeff() < 1e-13 * size);
  }
}

TEST_CASE("the world turned: the same motion in the links' axes, forces turned with it") {
  Chance chance(75);
  for (int i = 0; i < 60; ++i) {
    RandomMechanism want = sort(i);
    want.damped = true;
    Mechanism mechanism = test::random_elastic(chance, want);
    not_near_resonance(mechanism);
    const double angle = chance.any(3.0);
    const Mechanism turned = test::turned_world(mechanism, angle);
    const Structure a = structure_of(mechanism), b = structure_of(turned);
    const Deformation<double> p = static_response(a), q = static_response(b);
    const Deformation<Complex> r = harmonic_response(a, 3.7), s = harmonic_response(b, 3.7);
    CAPTURE(i);
    double size = size_of(p), far = 0.0;
    for (const auto& motion : r.motion) far = std::max(far, motion.cwiseAbs().maxCoeff());
    for (std::size_t k = 0; k < p.motion.size(); ++k) {
      CHECK((p.motion[k] - q.motion[k]).cwiseAbs().maxCoeff() < 1e-9 * size);
      CHECK((r.motion[k] - s.motion[k]).cwiseAbs().maxCoeff() < 1e-9 * far);
    }
    const double force = p.joints.cwiseAbs().maxCoeff();
    CHECK((p.joints - q.joints).cwiseAbs().maxCoeff() < 1e-9 * force);
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      const Eigen::Vector3d x = joint_force(a, j, p), y = joint_force(b, j, q);
      CHECK((Eigen::Rotation2Dd(angle) * x.head<2>() - y.head<2>()).norm() < 1e-9 * force);
    }
  }
}

TEST_CASE("the same mechanism in millimetres") {
  // kg and s stay: forces are 10^3, moments and stiffness against turning 10^6 times the number.
  Chance chance(76);
  for (int i = 0; i < 40; ++i) {
    RandomMechanism want = sort(i);
    want.damped = true;
    Mechanism in_metres = test::random_elastic(chance, want);
    not_near_resonance(in_metres);
    Mechanism in_millimetres = in_metres;
    in_millimetres.gravity *= 1e3;
    const auto times = [](auto& p, double factor) {
      double power = factor;  // p(x) = c_k x^k
      for (double& c : p.c) c *= power, power *= 1e-3;
    };
    for (Link& link : in_millimetres.links) {
      link.origin *= 1e3;
      link.length *= 1e3;
      link.rigid.centre *= 1e3;
      link.rigid.inertia *= 1e6;
      for (LinkStretch& stretch : link.stretches) {
        stretch.start *= 1e3;
        stretch.length *= 1e3;
        times(stretch.EA, 1e3);
        times(stretch.GA, 1e3);
        times(stretch.EI, 1e9);
        times(stretch.mass, 1e-3);
        times(stretch.rotary, 1e3);
      }
    }
    for (Joint& joint : in_millimetres.joints) {
      joint.a.p *= 1e3;
      joint.b.p *= 1e3;
      joint.stiffness[2] *= 1e6;
      joint.damping[2] *= 1e6;
    }
    for (Load& load : in_millimetres.loads) {
      load.at.p *= 1e3;
      for (auto* f : {&load.constant, &load.amplitude}) {
        f->head<2>() *= 1e3;
        (*f)[2] *= 1e6;
      }
    }
    const Deformation<Complex> a = harmonic_response(structure_of(in_metres), 3.7);
    const Deformation<Complex> b = harmonic_response(structure_of(in_millimetres), 3.7);
    const double force = a.joints.cwiseAbs().maxCoeff();
    CAPTURE(i);
    CHECK((b.joints.topRows(2) / 1e3 - a.joints.topRows(2)).cwiseAbs().maxCoeff() < 1e-9 * force);
    CHECK((b.joints.row(2) / 1e6 - a.joints.row(2)).cwiseAbs().maxCoeff() < 1e-9 * force);
  }
}

TEST_CASE("the longest half axis of an ellipse") {
  Chance chance(77);
  for (int i = 0; i < 200; ++i) {
    const Complex x(chance.any(), chance.any()), y(chance.any(), chance.any());
    double longest = 0.0;
    for (int k = 0; k < 20000; ++k) {
      const Complex turn = std::polar(1.0, k * std::numbers::pi / 20000.0);
      longest = std::max(longest, std::hypot((x * turn).imag(), (y * turn).imag()));
    }
    CHECK(largest_length(x, y) == Approx(longest).epsilon(1e-7));
    CHECK(largest_length(x, y) >= longest * (1.0 - 1e-15));
  }
  CHECK(largest_length({3.0, 0.0}, {4.0, 0.0}) == Approx(5.0));  // in a line
  CHECK(largest_length({2.0, 0.0}, {0.0, 2.0}) == Approx(2.0));  // a circle
  CHECK(largest_length({0.0, 0.0}, {0.0, 0.0}) == 0.0);
}

TEST_CASE("a place of a link moves with the element that holds it") {
  Chance chance(78);
  for (int i = 0; i < 30; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const Structure structure = structure_of(mechanism);
    const Deformation<double> response = static_response(structure);
    // The gap of a joint times its stiffness is its force.
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      const Joint& joint = mechanism.joints[j];
      const Eigen::Vector3d a = joint.a.link == ground ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                                       : motion_at(structure, joint.a, response);
      const Eigen::Vector3d b = motion_at(structure, joint.b, response);
      const double size = size_of(response);
      const Eigen::Vector3d gap = structure.joints[j].axes * (b - a);
      const auto column = static_cast<Eigen::Index>(j);
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double c = joint.stiffness[static_cast<std::size_t>(k)];
        CAPTURE(i, j, k, c);
        if (std::isinf(c)) {
          CHECK(std::abs(gap[k]) < 1e-13 * size);
        } else {
          const double force = response.joints.col(column).cwiseAbs().maxCoeff();
          CHECK(c * gap[k] ==
                Approx(response.joints(k, column)).margin(1e-9 * force + 1e-13 * c * size));
        }
      }
    }
    CHECK(motion_at(structure, {ground, {1.0, 2.0}}, response).norm() == 0.0);
  }
}

TEST_CASE("what has no damping says so") {
  Chance chance(79);
  RandomMechanism want;
  CHECK_FALSE(is_damped(test::random_elastic(chance, want)));
  Mechanism mechanism = test::random_elastic(chance, want);
  mechanism.links[0].retardation = 1e-5;
  CHECK(is_damped(mechanism));
  mechanism = test::random_elastic(chance, want);
  mechanism.joints[0].damping[1] = 1.0;
  CHECK(is_damped(mechanism));
}

}  // namespace response_test
