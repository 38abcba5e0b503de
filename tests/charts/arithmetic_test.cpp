// The textbook solver in four arithmetics: against the program's own solver, which solves the same
// equations in double, within the round-off of each.

#include "charts/arithmetic.hpp"

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "stability/benches.hpp"
#include "support/rig.hpp"

namespace arithmetic_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

/// Largest difference from the program's state, by the largest value of each kind.
template <class Scalar>
double difference_in(const planar::Mechanism& mechanism, LinearMethod method) {
  planar::InstantSolver program(mechanism);
  const planar::State state = program.solve_from_sketch(0.1, sketch_of(mechanism));
  TextbookSolver<Scalar> solver(mechanism, method);
  solver.equations().set_time(0.1);
  InstantIn<Scalar> instant;
  instant.q = state.q.cast<Scalar>();
  for (Eigen::Index i = 0; i < instant.q.size(); ++i) {
    instant.q[i] += static_cast<Scalar>(1e-3 * std::sin(static_cast<double>(i)));
  }
  REQUIRE(solver.solve_position(instant.q, 0.0) > 0);
  REQUIRE(solver.solve_rates(instant));
  solver.solve_multipliers(0.1, instant);
  const InstantIn<double> found = instant.template in<double>();
  const auto apart = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  };
  return std::max({apart(found.q, state.q), apart(found.v, state.v), apart(found.a, state.a),
                   apart(found.lambda, state.lambda)});
}

}  // namespace

TEST_CASE("the textbook solver agrees with the program to the digits of its arithmetic") {
  const planar::Mechanism& rig = planar_of(test::rig());
  for (const LinearMethod method :
       {LinearMethod::dense, LinearMethod::sparse, LinearMethod::orthogonal}) {
    INFO(to_text(method));
    CHECK(difference_in<long double>(rig, method) < 1e-14);
    CHECK(difference_in<double>(rig, method) < 1e-13);
    CHECK(difference_in<float>(rig, method) < 1e-5);
    CHECK(difference_in<float>(rig, method) > 1e-8);
    CHECK(difference_in<Decimal<5>>(rig, method) < 1e-2);
    CHECK(difference_in<Decimal<5>>(rig, method) > 1e-5);
  }
}

TEST_CASE("redundant equations: only the orthogonal decomposition takes them") {
  const planar::Mechanism mechanism =
      test::parallel_cranks(3, HarmonicDriver{1.0, 0.3, 2.0}, 1.0, false);
  REQUIRE(mechanism.equations() > mechanism.coordinates());
  CHECK(difference_in<long double>(mechanism, LinearMethod::orthogonal) < 1e-12);
  planar::InstantSolver program(mechanism);
  const planar::State state = program.solve_from_sketch(0.0, sketch_of(mechanism));
  for (const LinearMethod method : {LinearMethod::dense, LinearMethod::sparse}) {
    TextbookSolver<double> solver(mechanism, method);
    solver.equations().set_time(0.0);
    Eigen::VectorXd q = state.q;
    CHECK(solver.solve_position(q, 1e-8) == 0);
  }
}

TEST_CASE("operations of dense elimination are the textbook's 2/3 n^3 and 2 n^2") {
  const planar::Mechanism& rig = planar_of(test::rig());
  const TextbookSolver<double> solver(rig, LinearMethod::dense);
  CHECK(solver.factor_operations() == Approx(2.0 / 3.0 * 15 * 15 * 15));
  CHECK(solver.solve_operations() == Approx(2.0 * 15 * 15));
}

}  // namespace arithmetic_test
