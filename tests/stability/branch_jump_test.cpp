// Passing close to dead points, where the two branches of a loop nearly meet: at every instant the
// branch is the right one (circles intersected in closed form) or the instant is refused. Newton
// from the position of the instant before, which says nothing, is the negative control.

#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace branch_jump_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// How far a position is from an exact one, and from the one on the other branch.
struct Distances {
  double right = 0.0, other = 0.0;
};
using Exact = std::function<Distances(double time, const Eigen::VectorXd& q)>;

struct Tally {
  int right = 0, refused = 0, jumped = 0;
  int control_jumped = 0, control_failed = 0;

  Tally& operator+=(const Tally& more) {
    right += more.right;
    refused += more.refused;
    jumped += more.jumped;
    control_jumped += more.control_jumped;
    control_failed += more.control_failed;
    return *this;
  }
};

/// One period, each instant from the last one solved. What is refused is left out and the motion
/// taken up again behind it.
Tally follow(const Mechanism& mechanism, double period, int instants, const Exact& exact,
             const Eigen::VectorXd& sketch) {
  Tally tally;
  InstantSolver solver(mechanism);
  State known = solver.solve_from_sketch(0.0, sketch);
  ConstraintEquations equations(mechanism);
  Eigen::VectorXd control = known.q;
  for (int i = 1; i <= instants; ++i) {
    const double time = period * i / instants;
    try {
      known = solver.solve_near(time, known);
      const Distances distances = exact(time, known.q);
      const bool jumped = !(distances.right < 0.1 * distances.other || distances.right < 1e-9);
      (jumped ? tally.jumped : tally.right) += 1;
    } catch (const AnalysisError& error) {
      CHECK_FALSE(error.failure().what.empty());
      ++tally.refused;
    }
    equations.set_time(time);
    if (!test::plain_newton(equations, control)) {
      ++tally.control_failed;
      control = known.q;
    } else {
      const Distances distances = exact(time, control);
      if (distances.right > distances.other) ++tally.control_jumped;
    }
  }
  return tally;
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * test::pi)); }

void report(const std::string& what, const Tally& tally) {
  std::cout << "stability: " << what << ": " << tally.right << " on the branch, " << tally.refused
            << " refused, " << tally.jumped
            << " silent jumps; plain Newton: " << tally.control_jumped << " on the wrong branch, "
            << tally.control_failed << " without convergence\n";
}

Tally four_bar_tally(bool named_loop) {
  const test::FourBar bar;
  const auto limit = static_cast<double>(bar.limit());
  Tally all;
  for (int k = 1; k <= 12; ++k) {
    for (const int instants : {24, 36, 96}) {
      for (const int sign : {1, -1}) {
        for (const double phase : {0.0, 0.031}) {
          HarmonicDriver driver;
          driver.mean = 0.7;
          driver.amplitude = limit - std::pow(10.0, -k) - driver.mean;
          driver.omega = 2.0 * test::pi;
          driver.phase = phase;
          Mechanism mechanism = test::four_bar(bar, driver, 0.7, sign);
          if (!named_loop) mechanism.loops.clear();
          const Exact exact = [&](double time, const Eigen::VectorXd& q) {
            const double phi = driver_at(driver, time).value;
            const double right = test::posture_of(bar, phi, sign).rocker;
            const double other = test::posture_of(bar, phi, -sign).rocker;
            return Distances{apart(q[8], right), apart(q[8], other)};
          };
          INFO("margin 1e-" << k << ", " << instants << " instants, sign " << sign << ", phase "
                            << phase);
          const Tally tally = follow(mechanism, 1.0, instants, exact, sketch_of(mechanism));
          CHECK(tally.jumped == 0);
          all += tally;
        }
      }
    }
  }
  return all;
}

/// Angle of the rig's beam by the circles of 3 m about O and 0.5 m about the blade's point A.
double beam_angle(double x, int side) {
  const Eigen::Vector2d A(x, 3.0);
  const double d = A.norm();
  // Heron's factors, exact near the dead point.
  const double area = (3.5 - d) * (3.5 + d) * (d - 2.5) * (d + 2.5);
  const double across = 0.5 * std::sqrt(std::max(0.0, area)) / d;
  const double along = (d * d + 9.0 - 0.25) / (2.0 * d);
  return std::atan2(A.y(), A.x()) + side * std::atan2(across, along);
}

Tally rig_tally(bool named_loops) {
  const double stroke = std::sqrt(3.5 * 3.5 - 9.0) - 0.5;
  Tally all;
  for (int k = 3; k <= 12; ++k) {
    for (const int instants : {24, 36, 96}) {
      for (const double phase : {0.0, 0.031}) {
        Mechanism mechanism = planar_of(test::rig());
        HarmonicDriver& driver = test::exciter_of(mechanism);
        driver.amplitude = stroke - std::pow(10.0, -k);
        driver.phase = phase;
        const Eigen::VectorXd sketch = test::rig_state(0.0).q;
        if (!named_loops) mechanism.loops.clear();
        const Exact exact = [&](double time, const Eigen::VectorXd& q) {
          const double x = driver_at(driver, time).value;
          return Distances{apart(q[2], beam_angle(x, 1)), apart(q[2], beam_angle(x, -1))};
        };
        INFO("margin 1e-" << k << " m, " << instants << " instants, phase " << phase);
        const Tally tally = follow(mechanism, 1.0 / 0.7, instants, exact, sketch);
        CHECK(tally.jumped == 0);
        all += tally;
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("a four-bar that turns back 1e-1 .. 1e-12 rad before its limit keeps its branch") {
  for (const bool named : {true, false}) {
    const Tally tally = four_bar_tally(named);
    report(std::string("four-bar turning back 1e-1 .. 1e-12 rad before its limit, ") +
               (named ? "loop named" : "no loop named"),
           tally);
    CHECK(tally.jumped == 0);
    CHECK(tally.control_jumped > 100);  // else the test asks nothing
    CHECK(tally.right > 4 * tally.refused);
  }
}

TEST_CASE("the rig at full stroke keeps its branch") {
  for (const bool named : {true, false}) {
    const Tally tally = rig_tally(named);
    report(std::string("sledge rig turning back 1e-3 .. 1e-12 m before its limit, ") +
               (named ? "loops named" : "no loop named"),
           tally);
    CHECK(tally.jumped == 0);
    CHECK(tally.control_jumped > 100);
    CHECK(tally.right > 4 * tally.refused);
  }
}

}  // namespace branch_jump_test
