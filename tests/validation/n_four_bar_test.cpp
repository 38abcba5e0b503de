// The N-four-bar mechanism, IFToMM library of computational benchmark problems, A02, with N = 2:
// three cranks of 1 m and 1 kg side by side, joined by two couplers of the same, start upright with
// a velocity of 1 m/s. Where all links lie flat the mechanism has N + 1 instantaneous freedoms, so
// that the equations of motion are singular there; it passes twice per turn.
//
// On the physical branch all cranks turn as one: from Lagrange's equation, theta from the vertical,
//
//     theta'' = k sin(theta),   k = g ((N + 1)/2 + N)/((N + 1)/3 + N)
//
// Its solution by quadrature is the reference, to 18 digits.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "catch.hpp"
#include "charts/known_motions.hpp"

namespace n_four_bar_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr int N = 2;
constexpr double g = 9.81;

const Attachment B0{0, {0.5, 0.0}};

}  // namespace

TEST_CASE("N-four-bar: one freedom, three where it lies flat") {
  const Mechanism mechanism = charts::n_four_bar(N);
  const DegreesOfFreedom upright = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
  CHECK(upright.gruebler == 1);
  CHECK(upright.by_rank == 1);
  CHECK(upright.redundant == 0);
  Eigen::VectorXd flat(15);
  flat << 0.5, 0.0, 0.0, 1.5, 0.0, 0.0, 2.5, 0.0, 0.0, 1.5, 0.0, 0.0, 2.5, 0.0, 0.0;
  const DegreesOfFreedom singular = degrees_of_freedom_of(mechanism, flat);
  CHECK(singular.by_rank == N + 1);
  CHECK(singular.redundant == N);
}

TEST_CASE("N-four-bar of many loops: the same freedoms, by sparse singular values") {
  for (const int loops : {60, 400}) {
    const Mechanism mechanism = charts::n_four_bar(loops);
    CAPTURE(loops);
    const DegreesOfFreedom upright = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
    CHECK(upright.by_rank == 1);
    CHECK(upright.undriven == 1);
    CHECK(upright.redundant == 0);
    CHECK(upright.moving.size() == mechanism.bodies.size());
  }
  // Cranks first, then couplers: all of them flat.
  constexpr int loops = 60;
  const Mechanism mechanism = charts::n_four_bar(loops);
  Eigen::VectorXd flat = Eigen::VectorXd::Zero(mechanism.coordinates());
  for (int i = 0; i <= loops; ++i) flat[3 * i] = 0.5 + i;
  for (int i = 0; i < loops; ++i) flat[3 * (loops + 1 + i)] = 1.5 + i;
  const DegreesOfFreedom singular = degrees_of_freedom_of(mechanism, flat);
  CHECK(singular.by_rank == loops + 1);
  CHECK(singular.redundant == loops);
}

TEST_CASE("N-four-bar: ten seconds through the singular position") {
  struct Point {
    double t, x, y;
  };
  const Mechanism mechanism = charts::n_four_bar(N);
  FreeSolver solver(mechanism);
  const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const double energy = charts::energy_of(mechanism, first.q, first.v);
  State state = first;
  double drift = 0.0;
  double residual = 0.0;
  double error = 0.0;
  const auto advance = [&](double time) {
    // Ten looks per second, as the benchmark asks for output.
    while (state.time < time) {
      state = solver.advance(std::min(time, state.time + 0.1), state);
      drift =
          std::max(drift, std::abs(charts::energy_of(mechanism, state.q, state.v) / energy - 1.0));
      residual = std::max(residual, state.residual);
    }
  };
  for (const Point& point : {Point{1.0, -0.195020301949435094, -0.980799205662173833},
                             Point{4.0, 0.117616102376808612, 0.993059138451325101},
                             Point{5.0, -0.811310461005107412, -0.584615545348975548},
                             Point{10.0, 0.328458111540815379, 0.944518538178600962}}) {
    advance(point.t);
    const Eigen::Vector2d p = position_of(B0, state.q);
    const double off = (p - Eigen::Vector2d(point.x, point.y)).norm();
    error = std::max(error, off);
    INFO("t = " << point.t << ": position " << off << ", energy " << drift << ", steps "
                << solver.steps());
    CHECK(off < 1e-6);
    if (point.t == 1.0) {
      const Eigen::Vector2d v = velocity_of(B0, state.q, state.v);
      CHECK((v - Eigen::Vector2d(-6.67667803688115807, 1.32757832516048721)).norm() < 1e-6);
    }
  }
  const Eigen::Vector2d v = velocity_of(B0, state.q, state.v);
  CHECK((v - Eigen::Vector2d(1.42305147020694412, -0.494868845487042959)).norm() < 1e-6);
  CHECK(drift < 1e-6);
  CHECK(residual < 1e-13);
  // All cranks turn as one, the couplers do not turn.
  for (int i = 1; i <= N; ++i) CHECK(state.q[3 * i + 2] == Approx(state.q[2]).epsilon(1e-9));
  for (int i = N + 1; i <= 2 * N; ++i) CHECK(std::abs(state.q[3 * i + 2]) < 1e-9);
}

TEST_CASE("N-four-bar: on the branch after any time at any tolerance") {
  // Where a run ends decides where its steps fall, and with it how near a stage comes to one of the
  // ten singular positions passed. The equation of the one angle, above, by steps of 2^-13 s of the
  // classical Runge-Kutta method is exact to 1e-9 here, which the value at 10 s confirms.
  constexpr double step = 1.0 / 8192.0;
  constexpr int per_end = 512;  // ends are 1/16 s apart
  const double k = g * ((N + 1) / 2.0 + N) / ((N + 1) / 3.0 + N);
  std::vector<double> angles{0.0};
  double theta = 0.0;
  double rate = 1.0;
  for (int i = 1; i <= 160 * per_end; ++i) {
    const double a1 = k * std::sin(theta);
    const double v2 = rate + 0.5 * step * a1;
    const double a2 = k * std::sin(theta + 0.5 * step * rate);
    const double v3 = rate + 0.5 * step * a2;
    const double a3 = k * std::sin(theta + 0.5 * step * v2);
    const double v4 = rate + step * a3;
    const double a4 = k * std::sin(theta + step * v3);
    theta += step / 6.0 * (rate + 2.0 * v2 + 2.0 * v3 + v4);
    rate += step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    if (i % per_end == 0) angles.push_back(theta);
  }
  REQUIRE(std::abs(std::sin(theta) - 0.328458111540815379) < 1e-9);

  const Mechanism mechanism = charts::n_four_bar(N);
  for (const double tolerance : {1e-8, 1e-11, 1e-13}) {
    double error = 0.0;
    int evaluations = 0;
    for (std::size_t end = 10; end < angles.size(); end += 10) {
      FreeSolver solver(mechanism, tolerance);
      const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
      const State last = solver.advance(static_cast<double>(end) / 16.0, first);
      const Eigen::Vector2d exact(std::sin(angles[end]), std::cos(angles[end]));
      error = std::max(error, (position_of(B0, last.q) - exact).norm());
      evaluations += solver.evaluations();
    }
    INFO("tolerance " << tolerance << ": error " << error << ", evaluations " << evaluations);
    // On another branch it would be of the size of the links.
    CHECK(error < std::max(1e3 * tolerance, 1e-5));
    // No step is lost in the singular positions: 16 runs of 5 s in the mean.
    CHECK(evaluations < 16 * 4000);
  }
}

TEST_CASE("N-four-bar: one revolution takes the exact period") {
  // By quadrature of theta' = sqrt(1 + 2 k (1 - cos theta)).
  const double period = 1.9425149226070836835;
  const Mechanism mechanism = charts::n_four_bar(N);
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  state = solver.advance(period, state);
  CHECK((position_of(B0, state.q) - Eigen::Vector2d(0.0, 1.0)).norm() < 1e-6);
  CHECK((velocity_of(B0, state.q, state.v) - Eigen::Vector2d(1.0, 0.0)).norm() < 1e-6);
  // One turn, clockwise.
  CHECK(state.q[2] == Approx(-3.0 * std::acos(0.0)).epsilon(1e-6));
}

}  // namespace n_four_bar_test
