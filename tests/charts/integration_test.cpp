#include <cmath>

#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "catch.hpp"
#include "charts/integrators.hpp"
#include "charts/known_motions.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace integration_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

/// Of the simple pendulum at 2 s, by an integrator of equal steps.
template <class Advance>
double error_with(int steps, const Advance& advance) {
  const planar::Mechanism mechanism = simple_pendulum();
  planar::EquationsOfMotion equations(mechanism);
  Moving moving = start_of(mechanism);
  advance(equations, mechanism, moving, 2.0, steps);
  REQUIRE(moving.failure.empty());
  return (moving.q.head<2>() - simple_pendulum_at(2.0)).norm();
}

/// By steps and twice as many.
template <class Advance>
double order_with(int steps, const Advance& advance) {
  return std::log2(error_with(steps, advance) / error_with(2 * steps, advance));
}

const Series& series_of(const Chart& chart, const std::string& begin) {
  for (const Series& series : chart.series) {
    if (series.method.rfind(begin, 0) == 0) return series;
  }
  FAIL("no series " << begin);
  return chart.series.front();
}

void check_same_errors(const TopicResult& one, const TopicResult& two) {
  REQUIRE(one.charts.size() == two.charts.size());
  for (std::size_t c = 0; c < one.charts.size(); ++c) {
    for (std::size_t s = 0; s < one.charts[c].series.size(); ++s) {
      const auto& points = one.charts[c].series[s].points;
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Point& other = two.charts[c].series[s].points[p];
        CHECK(points[p].error == other.error);
        CHECK(points[p].operations == other.operations);
        CHECK(points[p].failure == other.failure);
      }
    }
  }
}

}  // namespace

TEST_CASE("known motions: the digits of the benchmark library", "[charts]") {
  // IFToMM library, A01 and A02 with two loops; by quadrature to 18 digits.
  const auto off = [](const Eigen::Vector2d& at, double x, double y) {
    return (at - Eigen::Vector2d(x, y)).norm();
  };
  CHECK(off(simple_pendulum_at(0.0), -1.0, 0.0) < 1e-15);
  CHECK(off(simple_pendulum_at(1.0), 0.98629175113187532, -0.16501085312554117) < 1e-15);
  CHECK(off(simple_pendulum_at(10.0), -0.27508746257611686, -0.96141920509912506) < 1e-14);
  CHECK(simple_pendulum_period() == Approx(2.3678419475762374).epsilon(1e-15));
  CHECK(off(n_four_bar_tip_at(2, 0.0), 0.0, 1.0) < 1e-15);
  CHECK(off(n_four_bar_tip_at(2, 1.0), -0.195020301949435094, -0.980799205662173833) < 1e-15);
  CHECK(off(n_four_bar_tip_at(2, 4.0), 0.117616102376808612, 0.993059138451325101) < 1e-15);
  CHECK(off(n_four_bar_tip_at(2, 5.0), -0.811310461005107412, -0.584615545348975548) < 1e-15);
  CHECK(off(n_four_bar_tip_at(2, 10.0), 0.328458111540815379, 0.944518538178600962) < 1e-15);
  CHECK(n_four_bar_period(2) == Approx(1.9425149226070836835).epsilon(1e-15));
}

TEST_CASE("integrators: their orders on the pendulum", "[charts]") {
  using planar::EquationsOfMotion, planar::Mechanism;
  CHECK(order_with(1024, [](EquationsOfMotion& equations, const Mechanism&, Moving& moving,
                            double until, int steps) {
          runge_kutta_4(equations, moving, until, steps, Constraints::projected);
        }) == Approx(4.0).margin(0.1));
  CHECK(order_with(1024, [](EquationsOfMotion& equations, const Mechanism& mechanism,
                            Moving& moving, double until, int steps) {
          generalised_alpha(equations, mechanism, moving, until, steps, damped_by(0.8));
        }) == Approx(2.0).margin(0.1));
  CHECK(order_with(512, [](EquationsOfMotion& equations, const Mechanism& mechanism, Moving& moving,
                           double until, int steps) {
          generalised_alpha(equations, mechanism, moving, until, steps, newmark());
        }) == Approx(2.0).margin(0.1));
  CHECK(order_with(512, [](EquationsOfMotion& equations, const Mechanism& mechanism, Moving& moving,
                           double until, int steps) {
          central_differences(equations, mechanism, moving, until, steps);
        }) == Approx(2.0).margin(0.1));
  // Without step control every look is one step of Fehlberg's method.
  const auto fehlberg = [](int steps) {
    const Mechanism mechanism = simple_pendulum();
    planar::FreeSolver solver(mechanism, 1e10);
    planar::State state =
        solver.start(0.0, planar::sketch_of(mechanism), planar::start_velocity_of(mechanism));
    for (int i = 1; i <= steps; ++i) state = solver.advance(2.0 * i / steps, state);
    return (state.q.head<2>() - simple_pendulum_at(2.0)).norm();
  };
  CHECK(std::log2(fehlberg(20) / fehlberg(40)) == Approx(8.0).margin(0.5));
}

TEST_CASE("chart integration: orders, failures, the default", "[charts][unsanitized]") {
  const TopicResult result = integration(reference_scenes(), {true});
  REQUIRE(result.charts.size() == 5);
  const Chart& pendulum = result.charts[0];
  const Chart& singular = result.charts[1];
  const Chart& reactions = result.charts[2];
  const Chart& drift = result.charts[3];
  const Chart& energy = result.charts[4];

  // Every default is far better than what is needed, and cheaper than ten times the cheapest.
  for (const Chart& chart : result.charts) {
    CAPTURE(chart.name);
    REQUIRE(default_point(chart) != nullptr);
    CHECK(default_point(chart)->failure.empty());
    CHECK(default_point(chart)->error < 1e-3 * chart.needed_low);
    CHECK_FALSE(chart.lesson.empty());
  }
  // Dormand and Prince's method is of order 5 with step control as well.
  const Series& fifth = series_of(pendulum, "Dormand");
  CHECK(order_over_work(fifth.points[3], fifth.points[4]) == Approx(5.0).margin(0.1));
  CHECK(fifth.points.back().error > pendulum.floor->error);

  // On the constraints themselves Newmark's method is unstable without numerical damping.
  // Cardona, Geradin, Computers and Structures 33 (1989) 801-820.
  for (const Point& point : series_of(pendulum, "Newmark").points) {
    CHECK_FALSE(point.failure.empty());
  }
  // Central differences take their directions where the constraints have none.
  for (const Point& point : series_of(singular, "central").points) {
    CHECK_FALSE(point.failure.empty());
  }
  // The program's own never fails there, nor is it wrong.
  for (const std::size_t own : {0U, 1U}) {
    for (const Point& point : singular.series[own].points) {
      CAPTURE(point.setting);
      CHECK(point.failure.empty());
      CHECK(point.error < std::max(2e-6, 1000.0 * (own == 0 ? point.parameter : 0.0)));
    }
  }
  CHECK(series_of(reactions, "Fehlberg").points.back().error < 1e-9);

  // Index 1 without projection: round-off and truncation push the second derivative of the
  // constraint, so that it opens with the square of time.
  for (std::size_t i = 1; i < drift.series.size(); ++i) {
    const auto& points = drift.series[i].points;
    CHECK(order_over_work(points.front(), points.back()) == Approx(-2.0).margin(0.1));
  }
  CHECK(default_point(drift)->error < 1e-15);
  // Errors of energy add up step by step; a symplectic method's do not.
  const auto& own = energy.series[0].points;
  CHECK(order_over_work(own.front(), own.back()) == Approx(-1.0).margin(0.1));
  const auto& central = series_of(energy, "central").points;
  CHECK(central.back().error < 1.01 * central.front().error);

  check_same_errors(result, integration(reference_scenes(), {true}));
}

}  // namespace integration_test
