// Motion and forces of trees of bodies against derivatives of their postures by the product rule in
// long double (support/moving.hpp) and against the laws of mechanics.

#include "boxbeam/mechanism/spatial/chain.hpp"

#include <algorithm>
#include <vector>

#include "catch.hpp"
#include "support/moving.hpp"
#include "support/random_tree.hpp"

namespace chain_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr int trees = 60;
constexpr int size = 12;
const double times[] = {0.2, 0.43, 0.8};

double distance(const test::Vector& expected, const Vector3d& value) {
  return static_cast<double>((expected - value.cast<test::Real>()).norm());
}

test::Vector wide(const Vector3d& v) { return v.cast<test::Real>(); }

/// Force and moment about the world's origin.
struct Sum {
  test::Vector force = test::Vector::Zero(), moment = test::Vector::Zero();
  test::Real largest = 1e-300L;  ///< of the forces and moments that were added

  void add(const Vector3d& place, const Vector3d& f, const Vector3d& m) {
    force += wide(f);
    const test::Vector about_origin = wide(m) + wide(place).cross(wide(f));
    moment += about_origin;
    largest = std::max({largest, wide(f).norm(), about_origin.norm()});
  }
};

/// What loads and gravity do on a body, taken from the case data and the places alone.
void add_loads(const Mechanism& mechanism, const State& state, int body, Sum& sum) {
  const Body& of = mechanism.bodies[static_cast<std::size_t>(body)];
  sum.add(position_of(state, {body, of.centre}), of.mass * mechanism.gravity, Vector3d::Zero());
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on != body) continue;
    const Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    if (load.kind == LoadKind::force) {
      sum.add(position_of(state, load.at), vector, Vector3d::Zero());
    } else {
      sum.add(Vector3d::Zero(), Vector3d::Zero(), vector);
    }
  }
  for (const LineForce& line : mechanism.line_forces) {
    if (line.on != body) continue;
    const Vector3d from = position_of(state, {body, line.from});
    const Vector3d to = position_of(state, {body, line.to});
    sum.add(0.5 * (from + to),
            (to - from).norm() * driver_at(line.size, state.time).value *
                in_world(state, line.axes, line.direction),
            Vector3d::Zero());
  }
}

}  // namespace

TEST_CASE("every body of random trees moves as the derivatives of its posture say") {
  test::Chance chance(1);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const Chain chain(mechanism);
    for (const double time : times) {
      const State state = chain.at(time);
      const auto expected = test::moving_bodies_of(mechanism, time);
      double worst = 0.0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const BodyMotion& body = state.bodies[i];
        const test::MovingBody& moving = expected[i];
        const auto relative = [&](const test::Vector& exact, const Vector3d& value) {
          return distance(exact, value) / (1.0 + static_cast<double>(exact.norm()));
        };
        worst = std::max(
            {worst, relative(omega_of(moving.R), body.omega),
             relative(alpha_of(moving.R), body.alpha), relative(moving.p.value, body.position),
             relative(moving.p.rate, body.velocity), relative(moving.p.second, body.acceleration)});
        const test::Matrix R = body.R_WB.cast<test::Real>();
        worst = std::max(worst, static_cast<double>((moving.R.value - R).norm()));
        const Attachment point{static_cast<int>(i), chance.vector()};
        const auto exact = test::point_of(moving, point.p);
        worst = std::max({worst, relative(exact.value, position_of(state, point)),
                          relative(exact.rate, velocity_of(state, point)),
                          relative(exact.second, acceleration_of(state, point))});
      }
      CHECK(worst < 1e-12);
    }
  }
}

TEST_CASE("Newton and Euler hold for every body of random trees") {
  // Rates of momentum from the second moments of mass and the derivatives of the posture.
  test::Chance chance(2);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const Chain chain(mechanism);
    for (const double time : times) {
      const State state = chain.at(time);
      const std::vector<Wrench> joints = chain.joint_wrenches(state);
      const auto moving = test::moving_bodies_of(mechanism, time);
      double worst = 0.0;
      for (std::size_t i = 0; i < joints.size(); ++i) {
        Sum sum;
        add_loads(mechanism, state, static_cast<int>(i), sum);
        for (std::size_t k = 0; k < joints.size(); ++k) {
          const Joint& joint = mechanism.joints[k];
          const Vector3d place = position_of(state, {static_cast<int>(k), joint.point});
          if (k == i) sum.add(place, joints[k].force, joints[k].moment);
          if (joint.parent == static_cast<int>(i)) {
            sum.add(place, -joints[k].force, -joints[k].moment);
          }
        }
        const auto rate = test::momentum_rate_of(mechanism.bodies[i], moving[i]);
        sum.largest = std::max({sum.largest, rate.force.norm(), rate.moment.norm()});
        worst = std::max({worst, static_cast<double>((sum.force - rate.force).norm() / sum.largest),
                          static_cast<double>((sum.moment - rate.moment).norm() / sum.largest)});
      }
      CHECK(worst < 1e-12);
    }
  }
}

TEST_CASE("inertia loads are the rates of momentum with the other sign") {
  test::Chance chance(3);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const State state = Chain(mechanism).at(0.5);
    const auto moving = test::moving_bodies_of(mechanism, 0.5);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const InertiaLoad load = inertia_of(mechanism, state, i);
      const auto rate = test::momentum_rate_of(mechanism.bodies[i], moving[i]);
      const test::Vector centre = test::point_of(moving[i], mechanism.bodies[i].centre).value;
      const test::Vector about_centre = rate.moment - centre.cross(rate.force);
      CHECK(distance(-rate.force, load.force) < 1e-12 * (1.0 + load.force.norm()));
      CHECK(distance(-about_centre, load.moment) < 1e-11 * (1.0 + load.moment.norm()));
    }
  }
}

TEST_CASE("the power of drives, gravity, loads and line forces is the rate of kinetic energy") {
  test::Chance chance(4);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const Chain chain(mechanism);
    for (const double time : times) {
      const State state = chain.at(time);
      const std::vector<Wrench> joints = chain.joint_wrenches(state);
      const auto moving = test::moving_bodies_of(mechanism, time);
      test::Real energy_rate = 0, power = 0, largest = 0;
      const auto add = [&](test::Real part) {
        power += part;
        largest = std::max(largest, std::abs(part));
      };
      for (std::size_t i = 0; i < joints.size(); ++i) {
        energy_rate += test::energy_of(mechanism.bodies[i], moving[i]).rate;
        const Joint& joint = mechanism.joints[i];
        const double rate = driver_at(joint.driver, time).rate;
        const Vector3d axis = in_world(state, joint.parent, joint.axis);
        if (joint.kind == JointKind::revolute) add(rate * axis.dot(joints[i].moment));
        if (joint.kind == JointKind::prismatic) add(rate * axis.dot(joints[i].force));
        // All that acts on the body from outside, with the motion of the world's origin as a point
        // of the body.
        Sum sum;
        add_loads(mechanism, state, static_cast<int>(i), sum);
        const test::Vector omega = omega_of(moving[i].R);
        add(sum.force.dot(moving[i].p.rate - omega.cross(moving[i].p.value)) +
            sum.moment.dot(omega));
      }
      CHECK(std::abs(static_cast<double>((power - energy_rate) / largest)) < 1e-11);
    }
  }
}

TEST_CASE("what the ground gives is all inertia less all loads, about the world's origin") {
  test::Chance chance(5);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const Chain chain(mechanism);
    const State state = chain.at(0.5);
    const std::vector<Wrench> joints = chain.joint_wrenches(state);
    const auto moving = test::moving_bodies_of(mechanism, 0.5);
    Sum sum;
    test::Vector force = test::Vector::Zero(), moment = test::Vector::Zero();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      add_loads(mechanism, state, static_cast<int>(i), sum);
      const auto rate = test::momentum_rate_of(mechanism.bodies[i], moving[i]);
      force += rate.force;
      moment += rate.moment;
      const Joint& joint = mechanism.joints[i];
      if (joint.parent != ground) continue;
      sum.add(position_of(state, {static_cast<int>(i), joint.point}), joints[i].force,
              joints[i].moment);
    }
    CHECK(static_cast<double>((sum.force - force).norm() / sum.largest) < 1e-12);
    CHECK(static_cast<double>((sum.moment - moment).norm() / sum.largest) < 1e-12);
  }
}

TEST_CASE("the whole world turned: the same joint forces in body axes") {
  test::Chance chance(6);
  for (int tree = 0; tree < trees; ++tree) {
    const Mechanism mechanism = test::random_tree(chance, size);
    const Eigen::Matrix3d turn = chance.rotation();
    const Mechanism other = test::turned_world(mechanism, turn);
    const Chain chain(mechanism), other_chain(other);
    const State state = chain.at(0.5), other_state = other_chain.at(0.5);
    const auto joints = chain.joint_wrenches(state);
    const auto other_joints = other_chain.joint_wrenches(other_state);
    double largest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const int body = static_cast<int>(i);
      const auto compare = [&](const Vector3d& one, const Vector3d& two) {
        largest = std::max(largest, one.norm());
        worst =
            std::max(worst, (in_axes(state, body, one) - in_axes(other_state, body, two)).norm());
      };
      compare(joints[i].force, other_joints[i].force);
      compare(joints[i].moment, other_joints[i].moment);
    }
    CHECK(worst < 1e-11 * largest);
  }
}

TEST_CASE("at rest, loads and gravity doubled double every joint force, exactly") {
  test::Chance chance(7);
  for (int tree = 0; tree < trees; ++tree) {
    Mechanism mechanism = test::random_tree(chance, size);
    for (Joint& joint : mechanism.joints) joint.driver = PolynomialDriver{{chance.any()}};
    for (AppliedLoad& load : mechanism.loads) load.size = PolynomialDriver{{chance.any(20.0)}};
    for (LineForce& line : mechanism.line_forces) line.size = PolynomialDriver{{chance.any(20.0)}};
    Mechanism doubled = mechanism;
    doubled.gravity *= 2.0;
    for (AppliedLoad& load : doubled.loads) std::get<PolynomialDriver>(load.size).c[0] *= 2.0;
    for (LineForce& line : doubled.line_forces) std::get<PolynomialDriver>(line.size).c[0] *= 2.0;
    const Chain chain(mechanism), doubled_chain(doubled);
    const auto joints = chain.joint_wrenches(chain.at(0.0));
    const auto twice = doubled_chain.joint_wrenches(doubled_chain.at(0.0));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      CHECK(twice[i].force == 2.0 * joints[i].force);
      CHECK(twice[i].moment == 2.0 * joints[i].moment);
    }
  }
}

TEST_CASE("a state that is used again is as a new one") {
  test::Chance chance(8);
  const Mechanism one = test::random_tree(chance, size), two = test::random_tree(chance, 5);
  const Chain chain(one), small(two);
  State state;
  std::vector<Wrench> joints;
  small.at(0.7, state);
  small.joint_wrenches(state, joints);
  chain.at(0.3, state);
  chain.joint_wrenches(state, joints);
  const State fresh = chain.at(0.3);
  const auto expected = chain.joint_wrenches(fresh);
  REQUIRE(joints.size() == expected.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    CHECK(state.bodies[i].acceleration == fresh.bodies[i].acceleration);
    CHECK(joints[i].moment == expected[i].moment);
  }
}

}  // namespace chain_test
