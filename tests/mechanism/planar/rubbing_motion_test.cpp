// Motions that forces decide where friction turns round, its guide is pressed from the other side
// and forces jump: a block on a spring, against an own integration in steps of 2 microseconds.

#include <cmath>
#include <vector>

#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "catch.hpp"

namespace rubbing_motion_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double m = 4.0, k = 900.0, g = 9.81;

/// A block of 4 kg on a rail without play, held by a spring and pushed along by a table, pressed on
/// the rail by its weight and by a force that is larger at times.
struct Block {
  double mu = 0.2, creep = 0.01;
  double lift = 60.0, omega = 13.0;
  double start = 0.15;
  Interpolation interpolation = Interpolation::step;
  std::vector<double> times{0.0, 0.2, 0.45, 0.7, 1.0};
  std::vector<double> pushes{5.0, -30.0, 20.0, 0.0, 0.0};

  double push_at(double t, double side) const {
    std::size_t i = 0;
    while (i + 2 < times.size() && t + side >= times[i + 1]) ++i;
    if (interpolation == Interpolation::step) return pushes[i];
    return pushes[i] + (pushes[i + 1] - pushes[i]) * (t - times[i]) / (times[i + 1] - times[i]);
  }

  double acceleration(double t, double side, double x, double v) const {
    const double N = m * g - lift * std::sin(omega * t);
    return (push_at(t, side) - k * x - mu * std::abs(N) * v / std::hypot(v, creep)) / m;
  }

  /// Runge and Kutta; the times of the table are ends of steps.
  Eigen::Vector2d integrated(double until) const {
    double x = start, v = 0.0;
    constexpr int per_second = 500000;
    const int steps = static_cast<int>(std::lround(until * per_second));
    const double h = 1.0 / per_second;
    for (int i = 0; i < steps; ++i) {
      const double t = i * h;
      // Stages at the ends of a step belong to it.
      const double e = 1e-9;
      const double a1 = acceleration(t, e, x, v);
      const double a2 = acceleration(t + h / 2, 0.0, x + h / 2 * v, v + h / 2 * a1);
      const double v2 = v + h / 2 * a1;
      const double a3 = acceleration(t + h / 2, 0.0, x + h / 2 * v2, v + h / 2 * a2);
      const double v3 = v + h / 2 * a2;
      const double a4 = acceleration(t + h, -e, x + h * v3, v + h * a3);
      const double v4 = v + h * a3;
      x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return {x, v};
  }

  Mechanism mechanism() const {
    Mechanism of;
    of.gravity = {0.0, -g};
    Body block;
    block.name = "block";
    block.mass = m;
    block.inertia = 0.1;
    block.sketch.centre = {start, 0.0};
    of.bodies = {block};
    Slider rail;
    rail.point = {0, {0.0, 0.0}};
    rail.friction = {mu, 0.0, creep, 0.0};
    of.joints = {{"rail", rail}};
    Spring spring;
    spring.a = {0, {0.0, 0.0}};
    spring.b = {ground, {-2.0, 0.0}};
    spring.stiffness = k;
    spring.free_length = 2.0;
    PointForce push, press;
    push.at = {0, {0.0, 0.0}};
    push.size = TableDriver{TableCurve(times, pushes, interpolation, Beyond::hold)};
    press.at = push.at;
    press.direction = std::acos(0.0);
    press.size = HarmonicDriver{0.0, lift, omega, 0.0};
    of.forces = {{"spring", spring}, {"push", push}, {"press", press}};
    of.duration.length = 1.0;
    return of;
  }
};

}  // namespace

TEST_CASE("a rubbing block moves as an own integration says, whatever turns round on its way") {
  for (const double creep : {0.01, 0.001}) {
    for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
      Block block;
      block.creep = creep;
      block.interpolation = interpolation;
      const Mechanism mechanism = block.mechanism();
      for (const bool often : {false, true}) {
        FreeSolver solver(mechanism);
        State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
        for (const double time : {0.3, 0.6, 0.9}) {
          const double before = state.time;
          for (int i = 1; often && i < 30; ++i) {
            state = solver.advance(before + (time - before) * i / 30.0, state);
          }
          state = solver.advance(time, state);
          const Eigen::Vector2d exact = block.integrated(time);
          CAPTURE(creep, often, time);
          CHECK(state.q[0] == Approx(exact[0]).margin(2e-9 * block.start));
          CHECK(state.v[0] == Approx(exact[1]).margin(2e-8));
          CHECK(state.a[0] ==
                Approx(block.acceleration(time, 0.0, exact[0], exact[1])).margin(2e-5));
        }
      }
    }
  }
}

}  // namespace rubbing_motion_test
