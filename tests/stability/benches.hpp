#pragma once

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"

/// Small mechanisms with closed forms, for tests of where methods fail.
namespace test {

using boxbeam::Body;
using boxbeam::Driver;
namespace planar = boxbeam::planar;

inline constexpr double pi = std::numbers::pi;

inline planar::Attachment on(int body, double x, double y = 0.0) { return {body, {x, y}}; }
inline planar::Attachment on_ground(double x, double y) { return {planar::ground, {x, y}}; }

/// A uniform rod between two points of the sketch, 10 kg/m unless it is massless.
inline Body rod(const std::string& name, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                bool massless = false) {
  const Eigen::Vector2d way = to - from;
  const double length = way.norm();
  Body body;
  body.name = name;
  body.mass = massless ? 0.0 : 10.0 * length;
  body.inertia = body.mass * length * length / 12.0;
  body.sketch = {0.5 * (from + to), std::atan2(way.y(), way.x())};
  return body;
}

inline planar::Joint driver_of_angle(int body, const Driver& driver) {
  return {"motor", planar::Driven{on(body, 0.0), planar::Coordinate::angle, driver}};
}

// ---- four-bar -------------------------------------------------------------------------------

/// Crank a from O = (0, 0) to A, coupler b from A to B, rocker c from D = (d, 0) to B.
struct FourBar {
  double a = 1.0, b = 0.8, c = 0.9, d = 1.5;

  /// The crank angle at which coupler and rocker are stretched [rad].
  long double limit() const {
    const auto A = static_cast<long double>(a), D = static_cast<long double>(d);
    const long double reach = static_cast<long double>(b) + static_cast<long double>(c);
    return std::acos((A * A + D * D - reach * reach) / (2.0L * A * D));
  }
};

template <class T>
struct FourBarPosture {
  T coupler{}, rocker{};  ///< angles
  T rocker_rate{};        ///< per rate of the crank
  T across{};             ///< distance of B from the line AD
};

/// By intersecting the circles about A and D; sign +1: B to the left of A -> D. The distance of B
/// from the line is factored (Heron), so that it stays exact near a dead point.
template <class T>
FourBarPosture<T> posture_of(const FourBar& bar, T phi, int sign) {
  using std::atan2, std::cos, std::sin, std::sqrt;
  const T a = bar.a, b = bar.b, c = bar.c, d = bar.d;
  const T Ax = a * cos(phi), Ay = a * sin(phi);
  const T r = sqrt((d - Ax) * (d - Ax) + Ay * Ay);
  const T ux = (d - Ax) / r, uy = -Ay / r;
  const T along = (b * b + r * r - c * c) / (2 * r);
  // b + c - r from the squares, whose difference is exact.
  const T open = ((b + c) * (b + c) - a * a - d * d + 2 * a * d * cos(phi)) / (b + c + r);
  const T product = open * (b + c + r) * (c + r - b) * (b + r - c);
  FourBarPosture<T> posture;
  posture.across = sqrt(product) / (2 * r);
  const T side = sign * posture.across;
  const T Bx = Ax + along * ux - side * uy, By = Ay + along * uy + side * ux;
  posture.coupler = atan2(By - Ay, Bx - Ax);
  posture.rocker = atan2(By, Bx - d);
  // Velocity of B along AB: a w x A . (B - A) = c w_c x (B - D) . (B - A).
  const T from_crank = (-Ay * (Bx - Ax) + Ax * (By - Ay));
  const T turning = -side * r;  // (B - D) x (B - A)
  posture.rocker_rate = from_crank / turning;
  return posture;
}

/// Bodies crank, coupler, rocker; joints O, A, B, D, motor; a loop "coupler" with the wanted sign.
inline planar::Mechanism four_bar(const FourBar& bar, const Driver& driver, double sketch_angle,
                                  int sign, bool massless = false) {
  using Eigen::Vector2d;
  const FourBarPosture<double> posture = posture_of(bar, sketch_angle, sign);
  const Vector2d O(0.0, 0.0), D(bar.d, 0.0);
  const Vector2d A = bar.a * Vector2d(std::cos(sketch_angle), std::sin(sketch_angle));
  const Vector2d B = D + bar.c * Vector2d(std::cos(posture.rocker), std::sin(posture.rocker));
  planar::Mechanism mechanism;
  mechanism.bodies = {rod("crank", O, A, massless), rod("coupler", A, B, massless),
                      rod("rocker", D, B, massless)};
  mechanism.gravity = {0.0, -9.81};
  mechanism.joints = {
      {"O", planar::Pin{on(0, -bar.a / 2.0), on_ground(0.0, 0.0)}},
      {"A", planar::Pin{on(0, bar.a / 2.0), on(1, -bar.b / 2.0)}},
      {"B", planar::Pin{on(1, bar.b / 2.0), on(2, bar.c / 2.0)}},
      {"D", planar::Pin{on(2, -bar.c / 2.0), on_ground(bar.d, 0.0)}},
      driver_of_angle(0, driver),
  };
  mechanism.loops = {
      {"coupler", planar::TurnSign{on(1, -bar.b / 2.0), on_ground(bar.d, 0.0), on(1, bar.b / 2.0)},
       sign}};
  return mechanism;
}

// ---- slider-crank ---------------------------------------------------------------------------

/// Crank r about O, rod l, slider along x through O. Bodies crank, rod, slider; the driver moves
/// the crank, or the slider along x.
inline planar::Mechanism slider_crank(double r, double l, const Driver& driver, double sketch_angle,
                                      bool drives_slider = false, bool massless = false) {
  using Eigen::Vector2d;
  const Vector2d O(0.0, 0.0);
  const Vector2d A = r * Vector2d(std::cos(sketch_angle), std::sin(sketch_angle));
  const Vector2d S(A.x() + std::sqrt(l * l - A.y() * A.y()), 0.0);
  planar::Mechanism mechanism;
  mechanism.bodies = {rod("crank", O, A, massless), rod("rod", A, S, massless), Body{}};
  mechanism.bodies[2].name = "slider";
  mechanism.bodies[2].mass = massless ? 0.0 : 5.0;
  mechanism.bodies[2].sketch.centre = S;
  mechanism.gravity = {0.0, -9.81};
  mechanism.joints = {
      {"O", planar::Pin{on(0, -r / 2.0), on_ground(0.0, 0.0)}},
      {"A", planar::Pin{on(0, r / 2.0), on(1, -l / 2.0)}},
      {"S", planar::Pin{on(1, l / 2.0), on(2, 0.0)}},
      {"line", planar::Slider{on(2, 0.0), on_ground(0.0, 0.0)}},
      driver_of_angle(0, driver),
  };
  if (drives_slider) {
    mechanism.joints.back() = {"motor", planar::Driven{on(2, 0.0), planar::Coordinate::x, driver}};
    mechanism.loops = {{"crank", planar::TurnSign{on_ground(0.0, 0.0), on(2, 0.0), on(0, r / 2.0)},
                        A.y() > 0.0 ? 1 : -1}};
  } else {
    mechanism.loops = {{"rod", planar::AlongSign{on(1, -l / 2.0), on(2, 0.0), 0.0}, 1}};
  }
  return mechanism;
}

// ---- parallel cranks ------------------------------------------------------------------------

/// `count` cranks of 1 m about points of the x axis, evenly over 2 m, and one coupler of 2 m; the
/// first crank is driven. Bodies coupler, crank 1, crank 2, ...; joints ground 1, tip 1, ground
/// 2, ... and motor. `longer`: what the last crank is too long by.
inline planar::Mechanism parallel_cranks(int count, const Driver& driver, double sketch_angle,
                                         bool massless, double longer = 0.0) {
  using Eigen::Vector2d;
  const Vector2d e(std::cos(sketch_angle), std::sin(sketch_angle));
  planar::Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  mechanism.bodies = {rod("coupler", e, e + Vector2d(2.0, 0.0), massless)};
  for (int k = 0; k < count; ++k) {
    const double x = 2.0 * k / (count - 1);
    const std::string number = std::to_string(k + 1);
    const double half = 0.5 * (k + 1 < count ? 1.0 : 1.0 + longer);
    mechanism.bodies.push_back(rod("crank " + number, {x, 0.0}, Vector2d(x, 0.0) + e, massless));
    mechanism.joints.push_back(
        {"ground " + number, planar::Pin{on(k + 1, -half), on_ground(x, 0.0)}});
    mechanism.joints.push_back({"tip " + number, planar::Pin{on(k + 1, half), on(0, x - 1.0)}});
  }
  mechanism.joints.push_back(driver_of_angle(1, driver));
  return mechanism;
}

// ---- platform on three rods -----------------------------------------------------------------

/// A triad: a triangular body held by three massless rods, one of them to the tip of a driven
/// crank. Bodies crank, platform; up to six assemblies.
struct Platform {
  double crank = 0.5;
  Eigen::Vector2d p[3] = {{-0.6, -0.3}, {0.6, -0.3}, {0.0, 0.5}};  ///< on the platform
  Eigen::Vector2d g[3] = {{0.0, 0.0}, {0.6, 0.2}, {-0.2, 1.0}};    ///< crank's pivot, ground
  double length[3] = {1.1, 1.0, 1.1};
};

inline planar::Mechanism platform_on_rods(const Platform& bench, const Driver& driver) {
  planar::Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  mechanism.bodies = {rod("crank", bench.g[0], bench.g[0] + Eigen::Vector2d(bench.crank, 0.0)), {}};
  Body& platform = mechanism.bodies[1];
  platform.name = "platform";
  platform.mass = 8.0;
  platform.inertia = 1.5;
  platform.sketch = {{0.3, 0.4}, 0.5};
  const auto point = [&](int k) { return planar::Attachment{1, bench.p[k]}; };
  mechanism.joints = {
      {"O", planar::Pin{on(0, -bench.crank / 2.0), {planar::ground, bench.g[0]}}},
      {"rod 1", planar::Distance{on(0, bench.crank / 2.0), point(0), bench.length[0]}},
      {"rod 2", planar::Distance{{planar::ground, bench.g[1]}, point(1), bench.length[1]}},
      {"rod 3", planar::Distance{{planar::ground, bench.g[2]}, point(2), bench.length[2]}},
      driver_of_angle(0, driver),
  };
  mechanism.loops = {
      {"left", planar::TurnSign{on(0, bench.crank / 2.0), {planar::ground, bench.g[1]}, point(0)},
       1},
      {"right",
       planar::TurnSign{{planar::ground, bench.g[1]}, {planar::ground, bench.g[2]}, point(1)}, 1}};
  return mechanism;
}

// ---- the negative control -------------------------------------------------------------------

/// Newton's method as every textbook has it: full steps, dense LU, no look at the branch. Returns
/// whether it converged.
inline bool plain_newton(planar::ConstraintEquations& equations, Eigen::VectorXd& q,
                         int most = 60) {
  Eigen::VectorXd phi(equations.rows());
  std::vector<double> values;
  for (int i = 0; i < most; ++i) {
    equations.set_position(q);
    equations.evaluate(phi, values);
    if (phi.lpNorm<Eigen::Infinity>() < 1e-11) return true;
    const Eigen::MatrixXd jacobian = equations.pattern().dense(values);
    q -= jacobian.partialPivLu().solve(phi);
    if (!q.allFinite()) return false;
  }
  return false;
}

}  // namespace test
