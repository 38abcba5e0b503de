// The same mechanism in metres and in millimetres: nothing that is decided may depend on it, and
// everything that is computed must be the same number of another unit.

#include <algorithm>
#include <cmath>
#include <iostream>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace unit_independence_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// Lengths in a unit `k` times as small; kg and s stay, so forces are k and moments k^2 times the
/// number.
struct SmallerUnit {
  double k;

  void of(Attachment& attachment) const { attachment.p *= k; }
  void of(Driver& driver, double factor) const {
    if (auto* harmonic = std::get_if<HarmonicDriver>(&driver)) {
      harmonic->mean *= factor;
      harmonic->amplitude *= factor;
      for (Harmonic& more : harmonic->further) more.amplitude *= factor;
    } else if (auto* rate = std::get_if<RateDriver>(&driver)) {
      rate->start *= factor;
      rate->rate *= factor;
    } else {
      for (double& c : std::get<PolynomialDriver>(driver).c) c *= factor;
    }
  }
  void of(Friction& friction) const {
    friction.creep *= k;
    friction.guide *= k;
  }
  void operator()(Pin& pin) const { of(pin.a), of(pin.b); }
  void operator()(Slider& slider) const { of(slider.point), of(slider.guide), of(slider.friction); }
  void operator()(PinInSlot& slot) const { of(slot.point), of(slot.guide), of(slot.friction); }
  void operator()(Rigid& rigid) const { of(rigid.a), of(rigid.b); }
  void operator()(Distance& distance) const {
    of(distance.a), of(distance.b);
    distance.length *= k;
  }
  void operator()(AngleCoupling& coupling) const { of(coupling.a), of(coupling.b); }
  void operator()(Gear& gear) const {
    of(gear.a), of(gear.b);
    gear.radius_a *= k;
    gear.radius_b *= k;
    gear.offset *= k;
  }
  void operator()(Rack& rack) const {
    of(rack.pinion), of(rack.rack);
    rack.radius *= k;
    rack.offset *= k;
  }
  void operator()(Driven& driven) const {
    of(driven.point), of(driven.other);
    if (driven.coordinate != Coordinate::angle) of(driven.driver, k);
  }
  void operator()(Spring& spring) const {
    of(spring.a), of(spring.b);
    spring.free_length *= k;
  }
  void operator()(PinWithClearance& pin) const {
    of(pin.a), of(pin.b);
    pin.clearance *= k;
    pin.start *= k;
    pin.stiffness /= std::pow(k, pin.impact.exponent - 1.0);
  }
  void operator()(TorsionSpring& spring) const {
    of(spring.a), of(spring.b);
    spring.stiffness *= k * k;
    spring.damping *= k * k;
  }
  void operator()(PointForce& force) const {
    of(force.at);
    of(force.size, k);
  }
  void operator()(Couple& couple) const {
    of(couple.a), of(couple.b);
    of(couple.size, k * k);
  }
};

Mechanism in_smaller_unit(Mechanism mechanism, double k) {
  const SmallerUnit unit{k};
  for (Body& body : mechanism.bodies) {
    body.inertia *= k * k;
    body.sketch.centre *= k;
    body.start_velocity.head<2>() *= k;
    for (BodyPoint& point : body.points) point.p *= k;
  }
  for (Joint& joint : mechanism.joints) std::visit(unit, joint.kind);
  for (AppliedForce& force : mechanism.forces) std::visit(unit, force.kind);
  for (Loop& loop : mechanism.loops) {
    if (auto* turn = std::get_if<TurnSign>(&loop.measure)) {
      unit.of(turn->from), unit.of(turn->via), unit.of(turn->to);
    } else {
      auto& along = std::get<AlongSign>(loop.measure);
      unit.of(along.from), unit.of(along.to);
    }
  }
  mechanism.gravity *= k;
  return mechanism;
}

/// A slider-crank with friction on its line, a spring, a force, a couple and a gear beside it.
Mechanism everything() {
  Mechanism mechanism = test::slider_crank(0.4, 1.1, RateDriver{0.7, 6.0}, 0.7);
  auto& slider = std::get<Slider>(mechanism.joints[3].kind);
  slider.friction = {0.15, 4.0, 0.02, 0.3};
  Body wheel;
  wheel.name = "wheel";
  wheel.mass = 3.0;
  wheel.inertia = 0.02;
  wheel.sketch = {{0.0, -0.5}, 0.0};
  mechanism.bodies.push_back(wheel);
  mechanism.joints.push_back({"axle", Pin{test::on(3, 0.0), test::on_ground(0.0, -0.5)}});
  // On the crank's shaft a wheel of 0.3 m: radii of 0.3 m and 0.2 m about O and the axle.
  mechanism.joints.push_back({"mesh", Gear{test::on(0, -0.2), test::on(3, 0.0), 0.3, 0.2, 0.2}});
  mechanism.forces = {
      {"spring", Spring{test::on(2, 0.1, 0.05), test::on_ground(2.0, 0.3), 900.0, 0.4, 12.0}},
      {"push",
       PointForce{test::on(1, 0.1, 0.02), 0.6, true, HarmonicDriver{20.0, 5.0, 6.0, 0.1, {}}}},
      {"twist", Couple{test::on(1, 0.0), test::on(0, 0.0), PolynomialDriver{{3.0}}}},
      {"coil", TorsionSpring{test::on(1, 0.0), test::on(0, 0.0), 7.0, -0.2, 0.5}}};
  return mechanism;
}

struct Difference {
  double position = 0.0, velocity = 0.0, acceleration = 0.0, reaction = 0.0;

  double largest() const { return std::max({position, velocity, acceleration, reaction}); }
};

/// Largest differences of two states, `small` in the unit that is `k` times as small, relative to
/// the largest of their kind.
Difference difference_of(const Mechanism& mechanism, const State& large, const State& small,
                         double k) {
  Eigen::VectorXd q_scale = Eigen::VectorXd::Constant(large.q.size(), k);
  for (Eigen::Index i = 2; i < q_scale.size(); i += 3) q_scale[i] = 1.0;
  Eigen::VectorXd lambda_scale(large.lambda.size());
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    for (int i = 0; i < equations_of(joint); ++i) {
      lambda_scale[row++] = is_length_equation(joint, i) ? k : k * k;
    }
  }
  const auto off = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                      const Eigen::VectorXd& scale) {
    return (b.cwiseQuotient(scale) - a).lpNorm<Eigen::Infinity>() /
           std::max(1.0, a.lpNorm<Eigen::Infinity>());
  };
  return {off(large.q, small.q, q_scale), off(large.v, small.v, q_scale),
          off(large.a, small.a, q_scale), off(large.lambda, small.lambda, lambda_scale)};
}

void check(const std::string& name, const Mechanism& in_m, bool branches = true) {
  Difference worst;
  double digits = 0.0;
  for (const double k : {1000.0, 0.001, 39.37007874015748}) {
    INFO(name << ", unit " << k << " times as small");
    const Mechanism in_mm = in_smaller_unit(in_m, k);
    CHECK(size_of(in_mm) == Approx(k * size_of(in_m)).epsilon(1e-13));
    InstantSolver solver_m(in_m), solver_mm(in_mm);
    State m = solver_m.solve_from_sketch(0.0, sketch_of(in_m));
    State mm = solver_mm.solve_from_sketch(0.0, sketch_of(in_mm));
    const DegreesOfFreedom freedom_m = degrees_of_freedom_of(in_m, m.q);
    const DegreesOfFreedom freedom_mm = degrees_of_freedom_of(in_mm, mm.q);
    CHECK(freedom_m.gruebler == freedom_mm.gruebler);
    CHECK(freedom_m.by_rank == freedom_mm.by_rank);
    CHECK(freedom_m.redundant == freedom_mm.redundant);
    CHECK(freedom_m.undriven == freedom_mm.undriven);
    CHECK(freedom_m.repeating == freedom_mm.repeating);
    CHECK(freedom_m.moving == freedom_mm.moving);
    CHECK(freedom_m.unique == freedom_mm.unique);
    CHECK(freedom_m.condition == Approx(freedom_mm.condition).epsilon(1e-9));
    CHECK(digits_left_at(freedom_m.condition) ==
          Approx(digits_left_at(freedom_mm.condition)).margin(1e-6));
    digits = digits_left_at(freedom_m.condition);
    const double span = time_span_of(in_m).length;
    for (int i = 0; i <= 48; ++i) {
      if (i > 0) {
        m = solver_m.solve_near(span * i / 48.0, m);
        mm = solver_mm.solve_near(span * i / 48.0, mm);
      }
      CHECK(m.assembly == mm.assembly);
      const Difference difference = difference_of(in_m, m, mm, k);
      // Two roundings agree in no more digits than are left: velocities lose the square of the
      // condition, accelerations, which take their right side from velocities, once more.
      const double condition = condition_of(in_m, m.q);
      const double lost = std::pow(10.0, -digits_left_at(condition));
      CHECK(std::max(difference.position, difference.velocity) < std::max(1e-9, lost));
      CHECK(difference.largest() < std::max(1e-9, lost * condition));
      worst.position = std::max(worst.position, difference.position);
      worst.velocity = std::max(worst.velocity, difference.velocity);
      worst.acceleration = std::max(worst.acceleration, difference.acceleration);
      worst.reaction = std::max(worst.reaction, difference.reaction);
    }
    CHECK(solver_m.elimination().pivots() == solver_mm.elimination().pivots());
    CHECK(solver_m.elimination().rows_left() == solver_mm.elimination().rows_left());
    CHECK(solver_m.elimination().smallest_pivot() ==
          Approx(solver_mm.elimination().smallest_pivot()).epsilon(1e-9));
    CHECK(solver_m.reorderings() == solver_mm.reorderings());
    if (!branches) continue;
    const auto list_m = list_assemblies(in_m, 0.0, 64);
    const auto list_mm = list_assemblies(in_mm, 0.0, 64);
    REQUIRE(list_m.size() == list_mm.size());
    for (std::size_t i = 0; i < list_m.size(); ++i) {
      CHECK(branch_of(in_m, list_m[i]) == branch_of(in_mm, list_mm[i]));
    }
  }
  std::cout << "stability: " << name << " in mm, m, km and inches at 49 instants: positions within "
            << worst.position << ", velocities " << worst.velocity << ", accelerations "
            << worst.acceleration << ", reactions " << worst.reaction << "; digits left " << digits
            << " in all\n";
}

}  // namespace

TEST_CASE("units: the sledge rig") { check("sledge rig", planar_of(test::rig())); }

TEST_CASE("units: a four-bar") {
  HarmonicDriver driver;
  driver.mean = 0.6;
  driver.amplitude = 0.84;
  driver.omega = 5.0;
  check("four-bar near its limit", test::four_bar({}, driver, 0.6, 1));
}

TEST_CASE("units: a parallelogram with a third crank") {
  // It can also be assembled in isolated other positions: their list is no part of this.
  check("parallelogram with a third crank",
        test::parallel_cranks(3, RateDriver{0.4, 3.0}, 0.4, false), false);
}

TEST_CASE("units: a slider with friction, gears, springs, forces and couples") {
  check("slider-crank with friction, gear and springs", everything(), false);
}

TEST_CASE("units: a platform on three rods") {
  HarmonicDriver driver;
  driver.mean = 0.4;
  driver.amplitude = 0.1;
  driver.omega = 5.0;
  check("platform on three rods", test::platform_on_rods({}, driver));
}

TEST_CASE("units: what is refused in metres is refused in millimetres") {
  const test::FourBar bar;
  int refused = 0;
  for (const double delta : {1e-3, 1e-9, -1e-9, -1e-6, -1e-3}) {
    const double phi = static_cast<double>(bar.limit()) - delta;
    const Mechanism in_m = test::four_bar(bar, RateDriver{phi, 1.0}, 1.0, 1);
    for (const Mechanism& mechanism : {in_m, in_smaller_unit(in_m, 1000.0)}) {
      bool solved = true;
      try {
        InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
      } catch (const AnalysisError& error) {
        solved = false;
        ++refused;
        const double unit = size_of(mechanism) / size_of(in_m);
        if (error.failure().where != "joint motor") {
          CHECK(error.failure().residual.value() / unit < -delta);
        }
      }
      INFO("delta = " << delta);
      CHECK(solved == (delta > 0.0));
    }
  }
  std::cout << "stability: crank angles beyond the limit in m and mm: " << refused
            << " of 6 refused, none before the limit\n";
}

}  // namespace unit_independence_test
