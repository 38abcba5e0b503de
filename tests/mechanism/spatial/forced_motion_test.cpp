// Freedoms in space that forces move, against closed forms, conserved quantities and the plane.

#include "boxbeam/mechanism/spatial/forced_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace forced_motion_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double g = 9.81;

/// Adds a body that a joint carries, moved by forces; its index.
int add(Mechanism& mechanism, const char* name, JointKind kind, int parent, const Vector3d& at,
        const Vector3d& axis, double start = 0.0, double rate = 0.0) {
  Joint joint;
  joint.name = name;
  joint.kind = kind;
  joint.parent = parent;
  joint.at = at;
  joint.axis = axis.normalized();
  joint.moved_by = MovedBy::forces;
  joint.start = start;
  joint.start_rate = rate;
  mechanism.bodies.emplace_back().name = name;
  mechanism.joints.push_back(joint);
  return static_cast<int>(mechanism.bodies.size()) - 1;
}

void set_mass(Mechanism& mechanism, int of, double mass, const Vector3d& centre,
              const Vector3d& inertia) {
  spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(of)];
  body.mass = mass;
  body.centre = centre;
  body.inertia = inertia.asDiagonal();
}

double energy_of(const Mechanism& mechanism, const State& state) {
  double energy = 0.0;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const spatial::Body& body = mechanism.bodies[i];
    const BodyMotion& motion = state.bodies[i];
    const Attachment centre{static_cast<int>(i), body.centre};
    const Vector3d omega = motion.R_WB.transpose() * motion.omega;
    energy += 0.5 * body.mass * velocity_of(state, centre).squaredNorm() +
              0.5 * omega.dot(body.inertia * omega) -
              body.mass * mechanism.gravity.dot(position_of(state, centre));
  }
  for (const Spring& spring : mechanism.springs) {
    double longer =
        (position_of(state, spring.b) - position_of(state, spring.a)).norm() - spring.free_length;
    if (spring.acts == Spring::Acts::pulling) longer = std::max(longer, 0.0);
    if (spring.acts == Spring::Acts::pushing) longer = std::min(longer, 0.0);
    energy += 0.5 * spring.stiffness * longer * longer;
  }
  return energy;
}

double value(const State& state, int joint) {
  return state.coordinates[static_cast<std::size_t>(joint)].value;
}

/// A mass that moves along z, at rest at a height above a stop on the ground.
Mechanism falling_onto_stop(double m, double height, double stiffness, double damping) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const int mass = add(mechanism, "mass", JointKind::prismatic, ground, Vector3d::Zero(),
                       Vector3d::UnitZ(), height);
  set_mass(mechanism, mass, m, Vector3d::Zero(), Vector3d::Zero());
  mechanism.springs.push_back({"stop",
                               {ground, {0.0, 0.0, -1.0}},
                               {mass, Vector3d::Zero()},
                               stiffness,
                               1.0,
                               damping,
                               Spring::Acts::pushing});
  return mechanism;
}

}  // namespace

TEST_CASE("a pendulum in space swings with the period of its closed form") {
  // Square to an axis askew in the world, so that gravity has a part along it.
  const Vector3d axis = Vector3d(1.0, 2.0, 0.5).normalized();
  const Vector3d down = (Vector3d(0.0, 0.0, -1.0) + axis.z() * axis).normalized();
  const double g_across = g * std::sqrt(1.0 - axis.z() * axis.z());
  constexpr double m = 3.0, l = 0.7, I = 0.2, start = 2.0;
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const int rod = add(mechanism, "rod", JointKind::revolute, ground, {0.3, 0.1, 0.2}, axis, start);
  set_mass(mechanism, rod, m, l * down, {I, I, I});
  const double period = 4.0 * std::sqrt((I + m * l * l) / (m * g_across * l)) *
                        std::comp_ellint_1(std::sin(0.5 * start));
  mechanism.duration.length = 3.0 * period;
  const Chain chain(mechanism);
  CHECK(chain.forced()->freedoms() == 1);
  CHECK(value(chain.at(2.0 * period), rod) == Approx(start).epsilon(1e-9));
  CHECK(value(chain.at(2.25 * period), rod) == Approx(0.0).margin(1e-8));
  CHECK(value(chain.at(2.5 * period), rod) == Approx(-start).epsilon(1e-9));
  // Before, between and after what has been integrated.
  CHECK(value(chain.at(-0.5 * period), rod) == Approx(-start).epsilon(1e-8));
  CHECK(value(chain.at(3.5 * period), rod) == Approx(-start).epsilon(1e-8));
  const State state = chain.at(0.3);
  const Wrench hinge = chain.joint_wrenches(state).front();
  CHECK(std::abs(hinge.moment.dot(axis)) < 1e-10);
}

TEST_CASE("a bead in a tube that turns evenly goes outwards as cosh") {
  constexpr double r0 = 0.1, omega = 3.0, m = 2.0, until = 1.0;
  Mechanism mechanism;
  const int tube =
      add(mechanism, "tube", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ());
  mechanism.joints.back().moved_by = MovedBy::driver;
  mechanism.joints.back().driver = RateDriver{0.0, omega};
  const int bead =
      add(mechanism, "bead", JointKind::prismatic, tube, Vector3d::Zero(), Vector3d::UnitX(), r0);
  set_mass(mechanism, bead, m, Vector3d::Zero(), Vector3d::Zero());
  mechanism.duration.length = until;
  const Chain chain(mechanism);
  for (const double t : {0.0, 0.31, 1.0}) {
    const State state = chain.at(t);
    CHECK(value(state, bead) == Approx(r0 * std::cosh(omega * t)).epsilon(1e-9));
    const Vector3d force =
        in_axes(state, tube, chain.joint_wrenches(state)[static_cast<std::size_t>(bead)].force);
    CHECK(force.y() == Approx(2.0 * m * omega * omega * r0 * std::sinh(omega * t)).margin(1e-8));
    CHECK(std::abs(force.x()) < 1e-9);
  }
}

TEST_CASE("a heavy top precesses evenly where its rates are those of the closed form") {
  // (I_3 w_3) W - I_1 W^2 cos(theta) = m g l about the fixed point. Source: Goldstein, Classical
  // Mechanics, 5.7.
  constexpr double m = 1.5, l = 0.2, I_1 = 0.08, I_3 = 0.012, theta = 0.6, spin_3 = 250.0;
  const double c = std::cos(theta);
  const double root = std::sqrt(I_3 * I_3 * spin_3 * spin_3 - 4.0 * I_1 * c * m * g * l);
  const double precession = (I_3 * spin_3 - root) / (2.0 * I_1 * c);
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const int yaw = add(mechanism, "yaw", JointKind::revolute, ground, Vector3d::Zero(),
                      Vector3d::UnitZ(), 0.0, precession);
  const int nod =
      add(mechanism, "nod", JointKind::revolute, yaw, Vector3d::Zero(), Vector3d::UnitX(), theta);
  const int top = add(mechanism, "spin", JointKind::revolute, nod, Vector3d::Zero(),
                      Vector3d::UnitZ(), 0.0, spin_3 - precession * c);
  const double I_c = I_1 - m * l * l;
  set_mass(mechanism, top, m, {0.0, 0.0, l}, {I_c, I_c, I_3});
  mechanism.duration.length = 1.0;
  const Chain chain(mechanism);
  for (const double t : {0.25, 1.0}) {
    const State state = chain.at(t);
    CHECK(value(state, nod) == Approx(theta).epsilon(1e-8));
    CHECK(value(state, yaw) == Approx(precession * t).epsilon(1e-7));
  }
}

TEST_CASE("a body that nothing turns keeps its energy and its angular momentum") {
  // About its middle axis, beside it: it turns over.
  Mechanism mechanism;
  const int a = add(mechanism, "a", JointKind::revolute, ground, Vector3d::Zero(),
                    Vector3d::UnitZ(), 0.0, 0.1);
  const int b =
      add(mechanism, "b", JointKind::revolute, a, Vector3d::Zero(), Vector3d::UnitX(), 0.5, 0.05);
  const int c =
      add(mechanism, "c", JointKind::revolute, b, Vector3d::Zero(), Vector3d::UnitY(), 0.3, 6.0);
  set_mass(mechanism, c, 1.0, Vector3d::Zero(), {1.0, 2.0, 2.8});
  mechanism.duration.length = 2.0;
  const Chain chain(mechanism);
  const auto momentum_of = [&](const State& state) -> Vector3d {
    const BodyMotion& motion = state.bodies[static_cast<std::size_t>(c)];
    return motion.R_WB * mechanism.bodies[static_cast<std::size_t>(c)].inertia *
           motion.R_WB.transpose() * motion.omega;
  };
  const State first = chain.at(0.0);
  for (const double t : {0.5, 1.3, 2.0}) {
    const State state = chain.at(t);
    CHECK(energy_of(mechanism, state) == Approx(energy_of(mechanism, first)).epsilon(1e-9));
    CHECK((momentum_of(state) - momentum_of(first)).norm() < 1e-8 * momentum_of(first).norm());
  }
}

TEST_CASE("a mass falls onto a stop that only pushes, and is thrown back") {
  // Contact with rate v: half a wave about the weight's sag and what that adds. Closed form of a
  // mass on a spring: z = -s + s cos(w t) - v/w sin(w t), s = m g/k.
  constexpr double m = 4.0, k = 2e4, height = 0.5;
  Mechanism mechanism = falling_onto_stop(m, height, k, 0.0);
  const double v = std::sqrt(2.0 * g * height), fall = v / g, w = std::sqrt(k / m), s = m * g / k;
  const double contact = (2.0 / w) * (0.5 * full_turn - std::atan(v / (w * s)));
  mechanism.duration.length = 3.0 * (2.0 * fall + contact);
  const Chain chain(mechanism);
  constexpr int mass = 0;
  const double lowest = fall + 0.5 * contact;
  CHECK(value(chain.at(lowest), mass) == Approx(-s - std::hypot(s, v / w)).epsilon(1e-7));
  CHECK(value(chain.at(2.0 * fall + contact), mass) == Approx(height).epsilon(1e-7));
  CHECK(value(chain.at(2.0 * (2.0 * fall + contact)), mass) == Approx(height).epsilon(1e-7));
}

TEST_CASE("a mass falls freely onto a damped stop, and is braked from where it touches it") {
  // From the touch on m x" = -m g - k x - c x', with x = 0 and x' = -v.
  constexpr double m = 4.0, k = 2e4, c = 300.0, height = 0.5;
  Mechanism mechanism = falling_onto_stop(m, height, k, c);
  const double v = std::sqrt(2.0 * g * height), fall = v / g, s = m * g / k;
  const double delta = c / (2.0 * m), w = std::sqrt(k / m - delta * delta);
  mechanism.duration.length = 2.0 * fall;
  const Chain chain(mechanism);
  constexpr int mass = 0;
  CHECK(value(chain.at(0.99 * fall), mass) == Approx(height * (1.0 - 0.99 * 0.99)).epsilon(1e-9));
  const double touched = chain.forced()->changes().front();
  CHECK(touched == Approx(fall).epsilon(1e-9));
  for (const double t : {1e-6, 0.005, 0.01, 0.02}) {
    const double x =
        std::exp(-delta * t) * (s * std::cos(w * t) + (s * delta - v) / w * std::sin(w * t)) - s;
    INFO("t = " << t);
    CHECK(value(chain.at(fall + t), mass) == Approx(x).epsilon(1e-7).margin(1e-10));
  }
}

TEST_CASE("a slack cable does not pull while its ends part") {
  // Thrown away from its anchor: the rate is as it was until the cable is taut.
  constexpr double m = 4.0, k = 2e4, c = 300.0, v = 2.0;
  Mechanism mechanism;
  const int mass =
      add(mechanism, "mass", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX());
  mechanism.joints.back().start_rate = v;
  set_mass(mechanism, mass, m, Vector3d::Zero(), Vector3d::Zero());
  mechanism.springs.push_back({"cable",
                               {ground, {-1.0, 0.0, 0.0}},
                               {mass, Vector3d::Zero()},
                               k,
                               1.5,
                               c,
                               Spring::Acts::pulling});
  mechanism.duration.length = 0.3;
  const Chain chain(mechanism);
  CHECK(value(chain.at(0.2499), mass) == Approx(0.4998).epsilon(1e-9));
  const double delta = c / (2.0 * m), w = std::sqrt(k / m - delta * delta), t = 0.01;
  CHECK(value(chain.at(0.25 + t), mass) ==
        Approx(0.5 + v / w * std::exp(-delta * t) * std::sin(w * t)).epsilon(1e-8));
}

TEST_CASE("a mass bounces on stops of any stiffness and loses nothing") {
  constexpr double m = 10.0, height = 0.4;
  for (const double k : {1e4, 1e5, 1e6, 3e7, 1e8, 1e9, 1e10}) {
    Mechanism mechanism;
    mechanism.gravity = {0.0, 0.0, -g};
    const int mass = add(mechanism, "mass", JointKind::prismatic, ground, Vector3d::Zero(),
                         Vector3d::UnitZ(), 0.1 + height);
    set_mass(mechanism, mass, m, Vector3d::Zero(), Vector3d::Zero());
    mechanism.springs.push_back({"stop",
                                 {ground, Vector3d::Zero()},
                                 {mass, Vector3d::Zero()},
                                 k,
                                 0.1,
                                 0.0,
                                 Spring::Acts::pushing});
    const double v = std::sqrt(2.0 * g * height), w = std::sqrt(k / m);
    const double contact = (2.0 / w) * (0.5 * full_turn - std::atan(v * w / g));
    const double whole = 2.0 * v / g + contact;
    mechanism.duration.length = 3.2 * whole;
    const Chain chain(mechanism);
    INFO("k = " << k);
    CHECK(chain.forced()->changes().size() == 6);
    for (const double n : {1.0, 2.0, 3.0})
      CHECK(value(chain.at(n * whole), mass) == Approx(0.1 + height).epsilon(1e-6));
  }
}

TEST_CASE("a damped spring that a load pulls moves as its closed form") {
  constexpr double m = 2.0, k = 800.0, d = 6.0, F = 40.0;
  Mechanism mechanism;
  const int mass =
      add(mechanism, "mass", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX());
  set_mass(mechanism, mass, m, Vector3d::Zero(), Vector3d::Zero());
  mechanism.springs.push_back(
      {"spring", {ground, {-1.0, 0.0, 0.0}}, {mass, Vector3d::Zero()}, k, 1.0, d, {}});
  AppliedLoad load;
  load.name = "pull";
  load.on = mass;
  load.at = {mass, Vector3d::Zero()};
  load.direction = Vector3d::UnitX();
  load.size = PolynomialDriver{{F}};
  mechanism.loads.push_back(load);
  mechanism.duration.length = 2.0;
  const Chain chain(mechanism);
  const double delta = d / (2.0 * m), w = std::sqrt(k / m - delta * delta);
  for (const double t : {0.05, 0.7, 2.0}) {
    const double x =
        F / k * (1.0 - std::exp(-delta * t) * (std::cos(w * t) + delta / w * std::sin(w * t)));
    CHECK(value(chain.at(t), mass) == Approx(x).epsilon(1e-9));
  }
}

TEST_CASE("between steps a mass on a spring moves as its closed form everywhere") {
  // x = A cos(w t), with what its rate and its acceleration are then.
  constexpr double m = 2.0, k = 800.0, A = 0.3;
  Mechanism mechanism;
  const int mass =
      add(mechanism, "mass", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX(), A);
  set_mass(mechanism, mass, m, Vector3d::Zero(), Vector3d::Zero());
  mechanism.springs.push_back(
      {"spring", {ground, {-1.0, 0.0, 0.0}}, {mass, Vector3d::Zero()}, k, 1.0, 0.0, {}});
  mechanism.duration.length = 1.0;
  const Chain chain(mechanism);
  const double w = std::sqrt(k / m);
  for (int i = 0; i <= 1000; ++i) {
    const double t = 1e-3 * i;
    const State state = chain.at(t);
    const DriverState& q = state.coordinates[static_cast<std::size_t>(mass)];
    INFO("t = " << t);
    CHECK(q.value == Approx(A * std::cos(w * t)).margin(1e-9));
    CHECK(q.rate == Approx(-A * w * std::sin(w * t)).margin(1e-8));
    CHECK(q.acceleration == Approx(-A * w * w * std::cos(w * t)).margin(1e-6));
  }
}

TEST_CASE("a parallelogram that closes a loop swings as a pendulum") {
  // Two cranks of a rod that never turns: its mass is as at the end of one thread.
  constexpr double l = 0.8, m = 5.0, start = 1.2;
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const Vector3d y = Vector3d::UnitY();
  const int crank =
      add(mechanism, "crank", JointKind::revolute, ground, Vector3d::Zero(), y, start);
  const int other = add(mechanism, "other", JointKind::revolute, ground, {1.0, 0.0, 0.0}, y, start);
  mechanism.joints.back().moved_by = MovedBy::loops;
  const int rod = add(mechanism, "rod", JointKind::revolute, crank, {0.0, 0.0, -l}, y, -start);
  mechanism.joints.back().moved_by = MovedBy::loops;
  set_mass(mechanism, rod, m, {0.4, 0.0, 0.0}, {0.1, 0.1, 0.1});
  ClosingJoint pin;
  pin.name = "pin";
  pin.kind = ClosingKind::revolute;
  pin.a = {other, {0.0, 0.0, -l}};
  pin.b = {rod, {1.0, 0.0, 0.0}};
  pin.axis = y;
  mechanism.closing.push_back(pin);
  const double period = 4.0 * std::sqrt(l / g) * std::comp_ellint_1(std::sin(0.5 * start));
  mechanism.duration.length = 2.0 * period;
  const Chain chain(mechanism);
  CHECK(value(chain.at(2.0 * period), crank) == Approx(start).epsilon(1e-8));
  CHECK(value(chain.at(1.25 * period), crank) == Approx(0.0).margin(1e-7));
  const State half = chain.at(0.5 * period);
  CHECK(value(half, rod) == Approx(start).epsilon(1e-8));
  const State state = chain.at(0.37 * period);
  CHECK(energy_of(mechanism, state) == Approx(energy_of(mechanism, chain.at(0.0))).epsilon(1e-9));
}

TEST_CASE("a double pendulum in space with torsion springs moves as the one in the plane") {
  constexpr double l = 0.9, m = 1.2, I = 0.05, first = 1.4, second = 0.7;
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  // Turned about -y, from x towards z.
  const Vector3d axis = -Vector3d::UnitY();
  const int upper =
      add(mechanism, "upper", JointKind::revolute, ground, Vector3d::Zero(), axis, first, 0.5);
  const int lower =
      add(mechanism, "lower", JointKind::revolute, upper, {l, 0.0, 0.0}, axis, second);
  for (const int of : {upper, lower}) set_mass(mechanism, of, m, {0.5 * l, 0.0, 0.0}, {I, I, I});
  mechanism.torsion_springs = {{"bar", upper, 9.0, 1.1, 0.3}, {"elbow's", lower, 5.0, -0.2, 0.1}};
  mechanism.duration.length = 2.0;
  const Chain chain(mechanism);

  planar::Mechanism flat;
  flat.gravity = {0.0, -g};
  for (const char* name : {"upper", "lower"}) {
    boxbeam::Body& body = flat.bodies.emplace_back();
    body.name = name;
    body.mass = m;
    body.inertia = I;
  }
  // In the plane bodies are at their centres.
  const Eigen::Vector2d half{0.5 * l, 0.0};
  flat.joints.push_back({"hinge", planar::Pin{{planar::ground, {0.0, 0.0}}, {0, -half}}});
  flat.joints.push_back({"elbow", planar::Pin{{0, half}, {1, -half}}});
  const planar::Attachment world{planar::ground, {0.0, 0.0}}, of_upper{0, {0.0, 0.0}},
      of_lower{1, {0.0, 0.0}};
  flat.forces.push_back({"bar", planar::TorsionSpring{of_upper, world, 9.0, 1.1, 0.3}});
  flat.forces.push_back({"elbow's", planar::TorsionSpring{of_lower, of_upper, 5.0, -0.2, 0.1}});
  flat.duration.length = 2.0;
  planar::FreeSolver solver(flat);
  Eigen::VectorXd q(6), v(6);
  const auto along = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  const auto across = [](double angle) {
    return Eigen::Vector2d(-std::sin(angle), std::cos(angle));
  };
  q << 0.5 * l * along(first), first, l * along(first) + 0.5 * l * along(first + second),
      first + second;
  v << 0.25 * l * across(first), 0.5, 0.5 * l * across(first) + 0.25 * l * across(first + second),
      0.5;
  const planar::State end = solver.advance(2.0, solver.start(0.0, q, v));
  const State state = chain.at(2.0);
  CHECK(value(state, upper) == Approx(end.q[2]).epsilon(1e-7));
  CHECK(value(state, upper) + value(state, lower) == Approx(end.q[5]).epsilon(1e-7));
}

TEST_CASE("what forces cannot move says where and why") {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const int arm =
      add(mechanism, "arm", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitY());
  const auto failure = [&]() {
    return test::refusal_of<AnalysisError>([&] { const Chain chain(mechanism); });
  };
  CHECK(failure().find("[motion] duration says how long") != std::string::npos);
  mechanism.duration.length = 1.0;
  CHECK(failure().find("nothing that it moves has a mass") != std::string::npos);
  // A point on the axis has no inertia about it.
  set_mass(mechanism, arm, 1.0, Vector3d::Zero(), Vector3d::Zero());
  CHECK(failure().find("\"arm\" is not determined") != std::string::npos);
  // Turns that come to lie in line: about x, y and, where y is at 90 degrees, about x again.
  Mechanism gimbal;
  const int a = add(gimbal, "a", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitX());
  const int b =
      add(gimbal, "b", JointKind::revolute, a, Vector3d::Zero(), Vector3d::UnitY(), 0.0, 1.0);
  const int c = add(gimbal, "c", JointKind::revolute, b, Vector3d::Zero(), Vector3d::UnitZ());
  set_mass(gimbal, c, 1.0, Vector3d::Zero(), {1.0, 2.0, 2.5});
  gimbal.joints[1].start = 0.25 * full_turn;
  gimbal.duration.length = 1.0;
  mechanism = gimbal;
  CHECK(failure().find("two of its turns lie in line") != std::string::npos);
}

}  // namespace forced_motion_test
