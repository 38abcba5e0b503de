// A retracting landing gear: an aircraft climbs along a straight line, yaws, and retracts a leg
// with a spinning wheel. Source: P. Van Damme, W. Van Gansbeke, R. Verhulst and L. Vanmunster, Case
// Dynamica (27 November 2014), questions 1 and 2. World x y z; x'y'z' is turned by alpha about x;
// the aircraft yaws by psi about z', its leg turns by beta about y'', the wheel by theta about x'''
// of the leg:
//
//     R = Rx(alpha) Rz(psi) Ry(beta) Rx(theta),  psi' = w_g, beta' = w_i, theta' = -w_w,
//     r_C = r_A + Rx Rz (l1, 0, l2) + Rx Rz Ry (-l4, 0, -l3),  r_A' = Rx (0, v_v, 0)

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/moving.hpp"
#include "support/random_tree.hpp"

namespace landing_gear_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

/// All that the source names, SI.
struct Gear {
  double alpha, psi, beta, theta;
  double v_v, w_g, w_i, w_w;
  double a_v, a_g, a_i, a_w;
  double l1, l2, l3, l4;
};

/// Yaw and retraction up to 3 rad/s, wheels up to 200 rad/s.
Gear random_gear(test::Chance& chance) {
  Gear gear{};
  for (double* angle : {&gear.alpha, &gear.psi, &gear.beta, &gear.theta}) *angle = chance.any(3.2);
  gear.v_v = chance.any(100.0);
  gear.w_g = chance.any(3.0);
  gear.w_i = chance.any(3.0);
  gear.w_w = chance.any(200.0);
  gear.a_v = chance.any(10.0);
  gear.a_g = chance.any(5.0);
  gear.a_i = chance.any(5.0);
  gear.a_w = chance.any(300.0);
  for (double* length : {&gear.l1, &gear.l2, &gear.l3, &gear.l4}) *length = 1.5 + chance.any(1.2);
  return gear;
}

enum { climb, aircraft, leg, wheel };

Mechanism mechanism_of(const Gear& gear) {
  Mechanism mechanism;
  mechanism.bodies.resize(4);
  const auto driver = [](double value, double rate, double acceleration) {
    return PolynomialDriver{{value, rate, 0.5 * acceleration}};
  };
  const Eigen::Matrix3d tilt = rotation_about(Vector3d(gear.alpha, 0.0, 0.0));
  mechanism.joints.resize(4);
  Joint* joint = mechanism.joints.data();
  joint[climb] = {"climb",     JointKind::prismatic,           ground, {0, 0, 0}, {0, 0, 0}, tilt,
                  tilt.col(1), driver(0.0, gear.v_v, gear.a_v)};
  joint[aircraft].kind = JointKind::revolute;
  joint[aircraft].parent = climb;
  joint[aircraft].axis = Vector3d::UnitZ();
  joint[aircraft].driver = driver(gear.psi, gear.w_g, gear.a_g);
  joint[leg].kind = JointKind::revolute;
  joint[leg].parent = aircraft;
  joint[leg].at = {gear.l1, 0.0, gear.l2};
  joint[leg].axis = Vector3d::UnitY();
  joint[leg].driver = driver(gear.beta, gear.w_i, gear.a_i);
  joint[wheel].kind = JointKind::revolute;
  joint[wheel].parent = leg;
  joint[wheel].at = {-gear.l4, 0.0, -gear.l3};
  joint[wheel].axis = Vector3d::UnitX();
  joint[wheel].driver = driver(gear.theta, -gear.w_w, -gear.a_w);
  return mechanism;
}

/// Rotation about coordinate axis k, element by element.
test::Moving<test::Matrix> about(int k, const test::Moving<test::Real>& q) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const test::Real s = std::sin(q.value), c = std::cos(q.value);
  const auto fill = [&](test::Real cosine, test::Real sine, test::Real own) {
    test::Matrix R = test::Matrix::Zero();
    R(k, k) = own;
    R(i, i) = R(j, j) = cosine;
    R(j, i) = sine;
    R(i, j) = -sine;
    return R;
  };
  const test::Real square = q.rate * q.rate;
  return {fill(c, s, 1), fill(-s * q.rate, c * q.rate, 0),
          fill(-c * square - s * q.second, -s * square + c * q.second, 0)};
}

struct Exact {
  test::Moving<test::Matrix> R;
  test::Moving<test::Vector> r_C;
};

Exact exact_of(const Gear& gear) {
  const auto tilt = about(0, {gear.alpha, 0, 0});
  const auto yawed = tilt * about(2, {gear.psi, gear.w_g, gear.a_g});
  const auto retracted = yawed * about(1, {gear.beta, gear.w_i, gear.a_i});
  const auto spun = retracted * about(0, {gear.theta, -gear.w_w, -gear.a_w});
  const auto r_A = tilt * test::along(test::Vector::UnitY(), {0, gear.v_v, gear.a_v});
  return {spun, r_A + yawed * test::Vector(gear.l1, 0, gear.l2) +
                    retracted * test::Vector(-gear.l4, 0, -gear.l3)};
}

double relative(const test::Vector& exact, const Vector3d& value) {
  return static_cast<double>((exact - value.cast<test::Real>()).norm() / exact.norm());
}

/// What the source calls w_g, w_i, w_w, a_g and so on as vectors of the world, at psi = 0.
struct SourceVectors {
  Eigen::Matrix3d tilt;       ///< x'y'z' -> xyz
  Eigen::Matrix3d retracted;  ///< x'''y'''z''' -> xyz, section 1.3

  explicit SourceVectors(const Gear& gear) {
    const double sa = std::sin(gear.alpha), ca = std::cos(gear.alpha);
    const double sb = std::sin(gear.beta), cb = std::cos(gear.beta);
    tilt << 1, 0, 0, 0, ca, -sa, 0, sa, ca;
    retracted << cb, 0, sb, sa * sb, ca, -sa * cb, -ca * sb, sa, ca * cb;
  }
};

}  // namespace

TEST_CASE("landing gear: rotation and point C are the derivatives of the posture, 1000 states") {
  test::Chance chance(41);
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Gear gear = random_gear(chance);
    const Mechanism mechanism = mechanism_of(gear);
    const State state = Chain(mechanism).at(0.0);
    const Exact exact = exact_of(gear);
    const spatial::BodyMotion& body = state.bodies[wheel];
    const Attachment C{leg, {-gear.l4, 0.0, -gear.l3}};
    worst = std::max({worst, relative(omega_of(exact.R), body.omega),
                      relative(alpha_of(exact.R), body.alpha),
                      relative(exact.r_C.value, position_of(state, C)),
                      relative(exact.r_C.rate, velocity_of(state, C)),
                      relative(exact.r_C.second, acceleration_of(state, C)),
                      relative(exact.r_C.second, body.acceleration)});
    CHECK((exact.R.value - body.R_WB.cast<test::Real>()).norm() < 1e-14L);
  }
  CHECK(worst < 1e-11);
}

TEST_CASE("landing gear: the source's matrices are the rotations that it names") {
  // Section 1.3 writes the product as R(x'''->x'') R(x'->x) but multiplies, rightly, in the other
  // order.
  test::Chance chance(42);
  for (int i = 0; i < 100; ++i) {
    Gear gear = random_gear(chance);
    gear.psi = 0.0;
    const Mechanism mechanism = mechanism_of(gear);
    const State state = Chain(mechanism).at(0.0);
    const SourceVectors source(gear);
    CHECK((source.tilt - state.bodies[aircraft].R_WB).norm() < 1e-14);
    CHECK((source.retracted - state.bodies[leg].R_WB).norm() < 1e-14);
    const Eigen::Matrix3d turn = source.tilt.transpose() * source.retracted;
    CHECK((turn * source.tilt - source.retracted).norm() > 1e-6);
  }
}

TEST_CASE("landing gear: the source's omega and v_C") {
  test::Chance chance(43);
  for (int i = 0; i < 1000; ++i) {
    Gear g = random_gear(chance);
    g.psi = 0.0;
    const double sa = std::sin(g.alpha), ca = std::cos(g.alpha);
    const double sb = std::sin(g.beta), cb = std::cos(g.beta);
    const Mechanism mechanism = mechanism_of(g);
    const State state = Chain(mechanism).at(0.0);
    const Vector3d omega(-cb * g.w_w, ca * g.w_i - sa * (g.w_g + sb * g.w_w),
                         sa * g.w_i + ca * (g.w_g + sb * g.w_w));
    CHECK((state.bodies[wheel].omega - omega).norm() < 1e-13 * omega.norm());
    const double across = g.l3 * sb + g.l4 * cb;
    const Vector3d v_C(g.w_i * (-g.l3 * cb + g.l4 * sb),
                       ca * g.v_v - g.w_g * ca * (across - g.l1) - g.w_i * sa * across,
                       sa * g.v_v - g.w_g * sa * (across - g.l1) + g.w_i * ca * across);
    CHECK((velocity_of(state, {wheel, Vector3d::Zero()}) - v_C).norm() < 1e-13 * v_C.norm());
  }
}

TEST_CASE(
    "landing gear: the terms of the source's angular acceleration, as printed and corrected") {
  test::Chance chance(44);
  for (int i = 0; i < 1000; ++i) {
    Gear g = random_gear(chance);
    g.psi = 0.0;
    const double sa = std::sin(g.alpha), ca = std::cos(g.alpha);
    const double sb = std::sin(g.beta), cb = std::cos(g.beta);
    const Mechanism mechanism = mechanism_of(g);
    const Vector3d alpha = Chain(mechanism).at(0.0).bodies[wheel].alpha;
    const double round_off = 1e-13 * (g.w_w * g.w_w + g.w_g * g.w_g + g.w_i * g.w_i + 300.0);

    const SourceVectors source(g);
    const Vector3d w_g = source.tilt * Vector3d(0.0, 0.0, g.w_g);
    const Vector3d w_i = source.tilt * Vector3d(0.0, g.w_i, 0.0);
    const Vector3d w_w = source.retracted * Vector3d(-g.w_w, 0.0, 0.0);

    // Right as printed.
    const Vector3d a_g(0.0, -sa * g.a_g, ca * g.a_g);
    const Vector3d a_i(0.0, ca * g.a_i, sa * g.a_i);
    const Vector3d g_x_i(-g.w_i * g.w_g, 0.0, 0.0);
    const Vector3d g_x_w(0.0, -ca * cb * g.w_g * g.w_w, -sa * cb * g.w_g * g.w_w);
    CHECK((w_g.cross(w_i) - g_x_i).norm() < round_off);
    CHECK((w_g.cross(w_w) - g_x_w).norm() < round_off);

    // The spin is -w_w about x''', so its rate is -a_w; printed with +a_w.
    const Vector3d printed_a_w(cb * g.a_w, sa * sb * g.a_w, -ca * sb * g.a_w);
    const Vector3d a_w = source.retracted * Vector3d(-g.a_w, 0.0, 0.0);
    CHECK((a_w + printed_a_w).norm() < round_off);

    // w_i x w_w: the z part is printed with cos(b) cos(b) for cos(a) cos(b).
    const double iw = g.w_i * g.w_w;
    const Vector3d printed_i_x_w(sb * iw, -sa * cb * iw, cb * cb * iw);
    const Vector3d i_x_w(sb * iw, -sa * cb * iw, ca * cb * iw);
    CHECK((w_i.cross(w_w) - i_x_w).norm() < round_off);
    CHECK((printed_i_x_w - i_x_w - Vector3d(0.0, 0.0, (cb - ca) * cb * iw)).norm() < round_off);

    const Vector3d corrected = a_g + a_i + a_w + g_x_i + g_x_w + i_x_w;
    CHECK((alpha - corrected).norm() < round_off);

    // The sum: printed with +a_w, and with sin(a) sin(b) for sin(a) cos(b) in y of w_i x w_w.
    const Vector3d printed(
        cb * g.a_w - g.w_g * g.w_i + sb * iw,
        -sa * g.a_g + ca * g.a_i + sa * sb * g.a_w - ca * cb * g.w_g * g.w_w - sa * sb * iw,
        ca * g.a_g + sa * g.a_i - ca * sb * g.a_w - sa * cb * g.w_g * g.w_w + ca * cb * iw);
    const Vector3d slips = -2.0 * a_w + Vector3d(0.0, sa * (cb - sb) * iw, 0.0);
    CHECK((printed - alpha - slips).norm() < round_off);
  }
}

TEST_CASE("landing gear: the source's a_C, completed with d(w_i)/dt = a_i + w_g x w_i") {
  // The source writes a_A + d(w_g)/dt x (r_C - r_A) + w_g x (v_C - v_A) + d(w_i)/dt x (r_C - r_B) +
  // w_i x (v_C - v_B) and stops behind the second term. The axis of w_g stands still; that of w_i
  // yaws.
  test::Chance chance(45);
  for (int i = 0; i < 1000; ++i) {
    Gear g = random_gear(chance);
    g.psi = 0.0;
    const double sa = std::sin(g.alpha), ca = std::cos(g.alpha);
    const double sb = std::sin(g.beta), cb = std::cos(g.beta);
    const Mechanism mechanism = mechanism_of(g);
    const State state = Chain(mechanism).at(0.0);
    const Attachment A{aircraft, Vector3d::Zero()}, C{wheel, Vector3d::Zero()};
    const Attachment B{aircraft, {g.l1, 0.0, g.l2}};

    const SourceVectors source(g);
    const Vector3d w_g = source.tilt * Vector3d(0.0, 0.0, g.w_g);
    const Vector3d w_i = source.tilt * Vector3d(0.0, g.w_i, 0.0);
    const Vector3d a_g = source.tilt * Vector3d(0.0, 0.0, g.a_g);
    const Vector3d a_i = source.tilt * Vector3d(0.0, g.a_i, 0.0);
    const Vector3d CA =
        source.tilt * Vector3d(g.l1 - g.l3 * sb - g.l4 * cb, 0.0, g.l2 - g.l3 * cb + g.l4 * sb);
    const Vector3d CB = source.tilt * Vector3d(-g.l3 * sb - g.l4 * cb, 0.0, -g.l3 * cb + g.l4 * sb);
    CHECK((position_of(state, C) - position_of(state, A) - CA).norm() < 1e-13);
    CHECK((position_of(state, C) - position_of(state, B) - CB).norm() < 1e-13);

    // The two terms that are printed.
    const Vector3d a_A(0.0, g.a_v * ca, g.a_v * sa);
    const double across = -g.l3 * sb - g.l4 * cb + g.l1;
    const Vector3d first(0.0, ca * g.a_g * across, sa * g.a_g * across);
    CHECK((acceleration_of(state, A) - a_A).norm() < 1e-13);
    CHECK((a_g.cross(CA) - first).norm() < 1e-12);

    const Vector3d CA_rate = velocity_of(state, C) - velocity_of(state, A);
    const Vector3d CB_rate = velocity_of(state, C) - velocity_of(state, B);
    const auto a_C = [&](const Vector3d& w_i_rate) -> Vector3d {
      return a_A + first + w_g.cross(CA_rate) + w_i_rate.cross(CB) + w_i.cross(CB_rate);
    };
    const Vector3d acceleration = acceleration_of(state, C);
    CHECK((a_C(a_i + w_g.cross(w_i)) - acceleration).norm() < 1e-11);
    // Without the turn of its axis this is missing.
    CHECK((acceleration - a_C(a_i) - w_g.cross(w_i).cross(CB)).norm() < 1e-11);
  }
}

}  // namespace landing_gear_test
