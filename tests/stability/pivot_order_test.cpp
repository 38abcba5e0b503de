// An order of pivots that is chosen once must hold for all positions, or be renewed: long sweeps
// against dense elimination with partial pivoting, a motion on which the first order must fail,
// and sparse matrices of random patterns against LU with full pivoting.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/numerics/sparse_elimination.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace pivot_order_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

struct Sweep {
  int instants = 0, reorderings = 0, refused = 0;
  double worst = 0.0;
};

/// `instants` over one period; every `every`-th is solved again, densely. Differences relative to
/// the largest of their kind, times the share of digits that the position leaves.
void sweep(const Mechanism& mechanism, double period, int instants, int every, Sweep& result) {
  InstantSolver sparse(mechanism);
  InstantSolver dense(mechanism, Elimination::dense);
  State state = sparse.solve_from_sketch(0.0, sketch_of(mechanism));
  State next;
  for (int i = 1; i <= instants; ++i) {
    sparse.solve_near(period * i / instants, state, next);
    std::swap(state, next);
    ++result.instants;
    if (i % every != 0) continue;
    const State other = dense.solve_at(state.time, state.q);
    const auto off = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
      return (a - b).lpNorm<Eigen::Infinity>() / std::max(1.0, b.lpNorm<Eigen::Infinity>());
    };
    result.worst = std::max({result.worst, off(state.v, other.v), off(state.a, other.a),
                             off(state.lambda, other.lambda)});
  }
  result.reorderings += sparse.reorderings();
}

void report(const std::string& name, const Sweep& result) {
  std::cout << "stability: " << name << ", " << result.instants
            << " instants: " << result.reorderings << " new orders, solutions within "
            << result.worst << " of dense elimination\n";
}

}  // namespace

TEST_CASE("random crank sweeps keep their order of pivots or renew it") {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Sweep four_bars, slider_cranks, rigs;
  for (int i = 0; i < 40; ++i) {
    // A crank-rocker (Grashof): the crank is the shortest and turns all round.
    test::FourBar bar;
    do {
      bar.a = 0.2 + 0.5 * unit(random);
      bar.b = 0.5 + 1.5 * unit(random);
      bar.c = 0.5 + 1.5 * unit(random);
      bar.d = 0.5 + 1.5 * unit(random);
    } while (
        !(bar.a + bar.d < bar.b + bar.c - 0.05 && bar.d - bar.a > std::abs(bar.b - bar.c) + 0.05));
    const double start = 6.0 * unit(random);
    INFO("four-bar " << bar.a << " " << bar.b << " " << bar.c << " " << bar.d);
    sweep(test::four_bar(bar, RateDriver{start, 1.0}, start, i % 2 == 0 ? 1 : -1), 2.0 * test::pi,
          2000, 7, four_bars);
  }
  for (int i = 0; i < 40; ++i) {
    const double r = 0.1 + unit(random);
    const double l = r * (1.01 + 2.0 * unit(random) * unit(random));
    const double start = 6.0 * unit(random);
    INFO("slider-crank " << r << " " << l);
    sweep(test::slider_crank(r, l, RateDriver{start, 1.0}, start), 2.0 * test::pi, 2000, 7,
          slider_cranks);
  }
  for (int i = 0; i < 20; ++i) {
    Mechanism rig = planar_of(test::rig());
    HarmonicDriver& driver = test::exciter_of(rig);
    driver.amplitude = 0.05 + 1.24 * unit(random);
    driver.phase = 6.0 * unit(random);
    INFO("rig, stroke " << driver.amplitude);
    sweep(rig, 1.0 / 0.7, 2000, 7, rigs);
  }
  report("40 random crank-rockers", four_bars);
  report("40 random slider-cranks", slider_cranks);
  report("20 random strokes of the rig", rigs);
  CHECK(four_bars.instants + slider_cranks.instants + rigs.instants == 200000);
  for (const Sweep& result : {four_bars, slider_cranks, rigs}) {
    CHECK(result.worst < 1e-9);
    // An order is renewed at places of the turn, not at every instant.
    CHECK(result.reorderings < result.instants / 500);
  }
}

TEST_CASE("an order whose pivot passes through zero is renewed") {
  // Started where crank and rod are in line, or at right angles: what is a good pivot there is none
  // a quarter of a turn later.
  Sweep cranks;
  for (const double start : {0.0, 0.02, test::pi / 2.0, test::pi, 4.0}) {
    for (const double r : {0.3, 0.99}) {
      INFO("slider-crank r = " << r << " started at " << start);
      const Mechanism mechanism = test::slider_crank(r, 1.0, RateDriver{start, 1.0}, start);
      sweep(mechanism, 2.0 * test::pi, 720, 1, cranks);
    }
  }
  report("10 slider-cranks started at dead centres and elsewhere", cranks);
  CHECK(cranks.worst < 1e-9);
  CHECK(cranks.reorderings > 0);
  CHECK(cranks.reorderings < 100);
  // A quick-return drive: the slot of the arm passes through every direction.
  using test::on, test::on_ground;
  Sweep turned;
  for (const double start : {0.0, 0.7, 1.5}) {
    Mechanism mechanism;
    mechanism.gravity = {0.0, -9.81};
    const Eigen::Vector2d tip = Eigen::Vector2d(std::cos(start), std::sin(start));
    mechanism.bodies = {test::rod("crank", {0.0, 0.0}, tip), test::rod("arm", {0.3, 0.0}, tip)};
    mechanism.bodies[1].mass = 4.0;
    mechanism.bodies[1].inertia = 0.5;
    const double half = 0.5 * (tip - Eigen::Vector2d(0.3, 0.0)).norm();
    mechanism.joints = {{"O", Pin{on(0, -0.5), on_ground(0.0, 0.0)}},
                        {"D", Pin{on(1, -half), on_ground(0.3, 0.0)}},
                        {"slot", PinInSlot{on(0, 0.5), on(1, 0.0), 0.0, {}}},
                        test::driver_of_angle(0, RateDriver{start, 1.0})};
    sweep(mechanism, 2.0 * test::pi, 720, 1, turned);
  }
  report("3 turns of a quick-return drive", turned);
  CHECK(turned.worst < 1e-9);
}

TEST_CASE("redundant equations take turns where one of them determines nothing") {
  // An arm whose tip is driven in x and in y: x alone says nothing of the angle's rate where the
  // tip moves along y, y alone nothing at right angles to that. Both together are always regular.
  using test::on, test::on_ground;
  Sweep carried;
  for (const double start : {0.0, 1.0}) {
    for (const int instants : {720, 20011}) {
      Mechanism mechanism;
      mechanism.bodies = {test::rod("arm", {0.0, 0.0}, {std::cos(start), std::sin(start)})};
      HarmonicDriver x;
      x.amplitude = 1.0;
      x.omega = 1.0;
      x.phase = start + test::pi / 2.0;
      HarmonicDriver y = x;
      y.phase = start;
      mechanism.joints = {{"O", Pin{on(0, -0.5), on_ground(0.0, 0.0)}},
                          {"tip x", Driven{on(0, 0.5), Coordinate::x, x}},
                          {"tip y", Driven{on(0, 0.5), Coordinate::y, y}}};
      InstantSolver solver(mechanism);
      State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
      double worst = 0.0;
      for (int i = 1; i <= instants; ++i) {
        state = solver.solve_near(2.0 * test::pi * i / instants, state);
        const double angle = std::remainder(state.q[2] - start - state.time, 2.0 * test::pi);
        worst =
            std::max({worst, std::abs(angle), std::abs(state.v[2] - 1.0), std::abs(state.a[2])});
      }
      INFO("started at " << start << ", " << instants << " instants");
      CHECK(worst < 1e-9);
      CHECK(solver.change_points().empty());
      carried.instants += instants;
      carried.reorderings += solver.reorderings();
      carried.worst = std::max(carried.worst, worst);
    }
  }
  std::cout << "stability: arm whose tip is driven in x and in y, " << carried.instants
            << " instants: " << carried.reorderings
            << " new orders; angle, rate and acceleration within " << carried.worst << "\n";
}

namespace {

enum class Kind { scattered, banded, arrow, blocks };

SparsePattern pattern_of(Kind kind, int rows, int cols, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SparsePattern pattern;
  pattern.rows = rows;
  pattern.cols = cols;
  pattern.row_start.push_back(0);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int at = r % cols;
      bool there = at == c;
      switch (kind) {
        case Kind::scattered: there = there || unit(random) < 3.0 / cols; break;
        case Kind::banded: there = there || std::abs(at - c) <= 2; break;
        case Kind::arrow: there = there || c == 0 || at == 0; break;
        case Kind::blocks:
          there = there || at / 3 == c / 3 || (c / 3 == 0 && unit(random) < 0.3);
          break;
      }
      if (there) pattern.col.push_back(c);
    }
    pattern.row_start.push_back(static_cast<int>(pattern.col.size()));
  }
  return pattern;
}

std::vector<double> random_values(std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  for (double& value : values) value = normal(random);
  return values;
}

}  // namespace

TEST_CASE("sparse elimination of random matrices against LU with full pivoting") {
  std::mt19937 random(7);
  const std::pair<Kind, const char*> kinds[] = {{Kind::scattered, "scattered"},
                                                {Kind::banded, "banded"},
                                                {Kind::arrow, "arrow"},
                                                {Kind::blocks, "blocks"}};
  for (const auto& [kind, name] : kinds) {
    int solved = 0, repeated = 0, renewed = 0, skipped = 0, fails = 0;
    double worst = 0.0;
    for (int n = 1; n <= 40; ++n) {
      for (int trial = 0; trial < 5; ++trial) {
        const SparsePattern pattern = pattern_of(kind, n, n, random);
        std::vector<double> values = random_values(pattern.entries(), random);
        const Eigen::VectorXd one = Eigen::VectorXd::Ones(n);
        SparseElimination elimination;
        Eigen::Index rank = elimination.analyse(pattern, values, one, one);
        // The order of the first values on others of the same pattern.
        for (int again = 0; again < 4; ++again) {
          if (again > 0) values = random_values(pattern.entries(), random);
          const Eigen::MatrixXd A = pattern.dense(values);
          const Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
          if (lu.rcond() < 1e-8) {
            ++skipped;
            continue;
          }
          bool fits = rank == n && elimination.factor(values);
          if (!fits) {
            rank = elimination.analyse(pattern, values, one, one);
            fits = rank == n && elimination.factor(values);
            ++renewed;
          } else {
            ++repeated;
          }
          CHECK(fits);
          if (!fits) {
            ++fails;
            continue;
          }
          const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(
              random_values(static_cast<std::size_t>(n), random).data(), n);
          Eigen::VectorXd x(n), y(n);
          elimination.solve(b, x);
          elimination.solve_transposed(b, y);
          const Eigen::VectorXd x_lu = lu.solve(b);
          const Eigen::VectorXd y_lu = lu.transpose().solve(b);
          const double off = lu.rcond() * std::max((x - x_lu).norm() / x_lu.norm(),
                                                   (y - y_lu).norm() / y_lu.norm());
          worst = std::max(worst, off);
          ++solved;
        }
      }
    }
    CHECK(worst < 1e-11);
    std::cout << "stability: " << solved << " random " << name
              << " matrices up to 40 x 40: " << repeated << " in the order of other values, "
              << renewed << " in a new one, " << fails << " failed, " << skipped
              << " skipped as singular; within " << worst << " of LU, by the condition\n";
  }
}

TEST_CASE("tall and singular matrices: rank, rows left over and columns without pivot") {
  std::mt19937 random(11);
  int tall = 0, singular = 0;
  double worst = 0.0;
  for (int n = 2; n <= 24; ++n) {
    for (const Kind kind : {Kind::scattered, Kind::banded, Kind::arrow, Kind::blocks}) {
      INFO("n = " << n);
      // Tall and consistent: rows that repeat others of the same pattern, by a factor.
      const SparsePattern square = pattern_of(kind, n, n, random);
      const std::vector<double> values = random_values(square.entries(), random);
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(square.dense(values));
      if (lu.rcond() < 1e-6) continue;
      SparsePattern pattern = square;
      std::vector<double> more = values;
      const int extra = 1 + n / 4;
      for (int k = 0; k < extra; ++k) {
        const auto row = static_cast<std::size_t>((3 * k + 1) % n);
        for (int e = square.row_start[row]; e < square.row_start[row + 1]; ++e) {
          pattern.col.push_back(square.col[static_cast<std::size_t>(e)]);
          more.push_back(-1.7 * values[static_cast<std::size_t>(e)]);
        }
        pattern.row_start.push_back(static_cast<int>(pattern.col.size()));
      }
      pattern.rows = n + extra;
      SparseElimination elimination;
      const Eigen::VectorXd rows = Eigen::VectorXd::Ones(n + extra);
      const Eigen::VectorXd cols = Eigen::VectorXd::Ones(n);
      REQUIRE(elimination.analyse(pattern, more, rows, cols) == n);
      CHECK(static_cast<int>(elimination.rows_left().size()) == extra);
      REQUIRE(elimination.factor(more));
      const Eigen::MatrixXd A = pattern.dense(more);
      const Eigen::VectorXd x_0 = Eigen::Map<const Eigen::VectorXd>(
          random_values(static_cast<std::size_t>(n), random).data(), n);
      Eigen::VectorXd x(n), y(n + extra);
      const Eigen::VectorXd b = A * x_0;
      elimination.solve(b, x);
      elimination.solve_transposed(x_0, y);
      worst = std::max({worst, lu.rcond() * (x - x_0).norm() / x_0.norm(),
                        lu.rcond() * (A.transpose() * y - x_0).norm() / x_0.norm()});
      for (const int row : elimination.rows_left()) CHECK(y[row] == 0.0);
      ++tall;

      // Singular: a column that repeats another, in a pattern that has both.
      const SparsePattern full = [&] {
        SparsePattern p;
        p.rows = p.cols = n;
        p.row_start.push_back(0);
        for (int r = 0; r < n; ++r) {
          for (int c = 0; c < n; ++c) p.col.push_back(c);
          p.row_start.push_back(static_cast<int>(p.col.size()));
        }
        return p;
      }();
      const int lost = 1 + n / 8;
      const Eigen::MatrixXd left = Eigen::Map<const Eigen::MatrixXd>(
          random_values(static_cast<std::size_t>(n * (n - lost)), random).data(), n, n - lost);
      const Eigen::MatrixXd right = Eigen::Map<const Eigen::MatrixXd>(
          random_values(static_cast<std::size_t>(n * (n - lost)), random).data(), n - lost, n);
      const Eigen::MatrixXd S = left * right;
      std::vector<double> dense_values;
      for (int r = 0; r < n; ++r) {
        for (int c = 0; c < n; ++c) dense_values.push_back(S(r, c));
      }
      SparseElimination none;
      CHECK(none.analyse(full, dense_values, cols, cols) == n - lost);
      CHECK(static_cast<int>(none.cols_left().size()) == lost);
      ++singular;
    }
  }
  CHECK(worst < 1e-11);
  std::cout << "stability: " << tall
            << " tall matrices: all redundant rows left over, solutions within " << worst << "; "
            << singular << " singular ones: all ranks found\n";
}

}  // namespace pivot_order_test
