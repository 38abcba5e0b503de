// Assembling from 10 000 random sketches: on the asked branch, or refused with a reason, and never
// anything else. Newton's method as textbooks have it is the negative control.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace random_starts_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// Anywhere within `spread` of the sketch, turned anyhow.
Eigen::VectorXd anywhere(const Eigen::VectorXd& sketch, double spread, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Eigen::VectorXd q = sketch;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] += (i % 3 == 2 ? test::pi : spread) * unit(random);
  }
  return q;
}

double residual_at(const Mechanism& mechanism, double time, const Eigen::VectorXd& q) {
  ConstraintEquations equations(mechanism);
  equations.set_time(time);
  equations.set_position(q);
  Eigen::VectorXd phi(equations.rows());
  equations.evaluate(phi);
  return phi.lpNorm<Eigen::Infinity>();
}

struct Tally {
  int asked = 0, no_assembly = 0, other_branch = 0, dead_point = 0, wrong = 0;
};

Tally tally_of(const Mechanism& mechanism, int starts, double spread, unsigned seed) {
  std::mt19937 random(seed);
  InstantSolver solver(mechanism);
  const Eigen::VectorXd sketch = sketch_of(mechanism);
  Tally tally;
  for (int i = 0; i < starts; ++i) {
    try {
      const State state = solver.solve_from_sketch(0.0, anywhere(sketch, spread, random));
      const bool right = residual_at(mechanism, 0.0, state.q) < 1e-11 &&
                         on_branch(mechanism, state.q) && state.v.allFinite() &&
                         state.a.allFinite() && state.lambda.allFinite();
      (right ? tally.asked : tally.wrong) += 1;
    } catch (const AnalysisError& error) {
      const AnalysisFailure& failure = error.failure();
      CHECK_FALSE(failure.what.empty());
      CHECK_FALSE(failure.where.empty());
      if (failure.what.find("wanted branch") != std::string::npos) {
        ++tally.other_branch;
      } else if (failure.what.find("cannot be assembled") != std::string::npos) {
        ++tally.no_assembly;
      } else {
        ++tally.dead_point;
      }
    }
  }
  return tally;
}

/// Starts of plain Newton that converge, and of these the ones on another branch than asked.
struct Control {
  int converged = 0, wrong = 0;
};

Control control_of(const Mechanism& mechanism, int starts, double spread, unsigned seed) {
  std::mt19937 random(seed);
  ConstraintEquations equations(mechanism);
  equations.set_time(0.0);
  Control control;
  for (int i = 0; i < starts; ++i) {
    Eigen::VectorXd q = anywhere(sketch_of(mechanism), spread, random);
    if (!test::plain_newton(equations, q)) continue;
    ++control.converged;
    if (!on_branch(mechanism, q)) ++control.wrong;
  }
  return control;
}

/// `most_refused`: share of the starts that may be refused; `newton`: share from which plain Newton
/// converges at most.
void check_starts(const std::string& name, const Mechanism& mechanism, int starts, double spread,
                  double most_refused, double newton) {
  const Tally tally = tally_of(mechanism, starts, spread, 20240607);
  const Control control = control_of(mechanism, starts, spread, 20240607);
  std::cout << "stability: " << name << ", " << starts << " random starts: " << tally.asked
            << " on the asked branch, " << starts - tally.asked - tally.wrong
            << " refused (no assembly " << tally.no_assembly << ", other branch "
            << tally.other_branch << ", dead point " << tally.dead_point << "), " << tally.wrong
            << " wrong; plain Newton: " << control.converged << " converged, " << control.wrong
            << " of them on a wrong branch\n";
  CHECK(tally.wrong == 0);
  CHECK(tally.asked + tally.no_assembly + tally.other_branch + tally.dead_point == starts);
  CHECK(tally.asked >= (1.0 - most_refused) * starts);
  // The control must fail, or the starts were too easy. (The rig is built of dyads, whose linear
  // and quadratic equations Newton nearly always solves, on one branch or another.)
  CHECK(control.converged <= newton * starts);
  CHECK(control.wrong > control.converged * 3 / 10);
}

/// Assemblies of the platform at a crank angle, counted independently: for each turn of the
/// platform the differences of the three circles are linear in its position; what is left is one
/// function of the turn, whose changes of sign are counted.
int platform_assemblies(const test::Platform& bench, double crank) {
  Eigen::Vector2d g[3] = {bench.g[0], bench.g[1], bench.g[2]};
  g[0] += bench.crank * Eigen::Vector2d(std::cos(crank), std::sin(crank));
  constexpr int grid = 200000;
  int count = 0;
  double last = 0.0;
  for (int i = 0; i <= grid; ++i) {
    const double turn = 2.0 * test::pi * (i + 0.37) / grid;
    const Eigen::Rotation2D<double> R(turn);
    Eigen::Vector2d c[3];
    for (int k = 0; k < 3; ++k) c[k] = R * bench.p[k] - g[k];
    Eigen::Matrix2d A;
    Eigen::Vector2d b;
    for (int k = 1; k < 3; ++k) {
      A.row(k - 1) = 2.0 * (c[k] - c[0]).transpose();
      b[k - 1] = bench.length[k] * bench.length[k] - bench.length[0] * bench.length[0] -
                 c[k].squaredNorm() + c[0].squaredNorm();
    }
    const double determinant = A.determinant();
    Eigen::Matrix2d adjoint;
    adjoint << A(1, 1), -A(0, 1), -A(1, 0), A(0, 0);
    const Eigen::Vector2d x = adjoint * b;  // position times the determinant
    const double f =
        (x + determinant * c[0]).squaredNorm() - std::pow(bench.length[0] * determinant, 2.0);
    if (i > 0 && (f > 0.0) != (last > 0.0)) ++count;
    last = f;
  }
  return count;
}

}  // namespace

TEST_CASE("random starts of a four-bar: the asked branch or a refusal") {
  check_starts("four-bar", test::four_bar({}, RateDriver{1.0, 1.0}, 1.0, 1), 10000, 1.0, 0.0, 0.9);
}

TEST_CASE("random starts of the sledge rig: the asked branch or a refusal") {
  check_starts("sledge rig", planar_of(test::rig()), 10000, 1.0, 0.0, 1.0);
}

TEST_CASE("random starts of a platform on three rods: the asked branch or a refusal",
          "[unsanitized]") {
  check_starts("platform on three rods", test::platform_on_rods({}, RateDriver{0.4, 1.0}), 10000,
               1.0, 0.5, 0.9);
}

TEST_CASE("random starts where the asked branch does not exist are all refused") {
  // The platform with the signs of its two loops that no assembly has.
  Mechanism mechanism = test::platform_on_rods({}, RateDriver{0.4, 1.0});
  std::vector<std::vector<int>> there;
  for (const Eigen::VectorXd& q : list_assemblies(mechanism, 0.0)) {
    there.push_back(branch_of(mechanism, q));
  }
  // The four-bar beyond its limit, where nothing closes.
  const test::FourBar bar;
  const Tally four_bar = tally_of(test::four_bar(bar, RateDriver{1.6, 1.0}, 1.0, 1), 100, 1.0, 7);
  CHECK(four_bar.no_assembly == 100);
  int impossible = 0;
  for (const int left : {1, -1}) {
    for (const int right : {1, -1}) {
      if (std::find(there.begin(), there.end(), std::vector<int>{left, right}) != there.end()) {
        continue;
      }
      ++impossible;
      mechanism.loops[0].sign = left;
      mechanism.loops[1].sign = right;
      const Tally tally = tally_of(mechanism, 20, 1.0, 8);
      CHECK(tally.asked + tally.wrong == 0);
    }
  }
  std::cout << "stability: 100 random starts of a four-bar beyond its limit: "
            << four_bar.no_assembly << " refused; " << impossible
            << " pairs of signs of the platform that no assembly has: all refused\n";
}

TEST_CASE("all assemblies are listed: four-bar 2, rig 4, platform as counted by a scan") {
  const test::FourBar bar;
  const auto four_bar = list_assemblies(test::four_bar(bar, RateDriver{1.0, 1.0}, 1.0, 1), 0.0);
  CHECK(four_bar.size() == 2);
  const auto rig = list_assemblies(planar_of(test::rig()), 0.0);
  CHECK(rig.size() == 4);
  std::vector<std::vector<int>> branches;
  for (const Eigen::VectorXd& q : rig) branches.push_back(branch_of(planar_of(test::rig()), q));
  std::sort(branches.begin(), branches.end());
  CHECK(std::adjacent_find(branches.begin(), branches.end()) == branches.end());
  std::cout << "stability: assemblies listed: four-bar " << four_bar.size() << " of 2, rig "
            << rig.size() << " of 4, platform at four crank angles";
  for (const double crank : {0.4, 1.5, 2.6, 4.5}) {
    const int expected = platform_assemblies({}, crank);
    const auto found = list_assemblies(test::platform_on_rods({}, RateDriver{crank, 1.0}), 0.0);
    INFO("crank at " << crank);
    CHECK(static_cast<int>(found.size()) == expected);
    std::cout << " " << found.size() << " of " << expected;
  }
  std::cout << "\n";
}

TEST_CASE("close to a dead point both assemblies are listed, as far as they are apart") {
  const test::FourBar bar;
  int both = 0;
  for (const double delta : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto phi = static_cast<double>(bar.limit() - static_cast<long double>(delta));
    const auto found = list_assemblies(test::four_bar(bar, RateDriver{phi, 1.0}, 1.0, 1), 0.0);
    INFO("delta = " << delta);
    CHECK(found.size() == 2);
    both += found.size() == 2 ? 1 : 0;
  }
  std::cout << "stability: assemblies 1e-2 .. 1e-10 rad before a dead point: both listed " << both
            << " times of 5\n";
}

}  // namespace random_starts_test
