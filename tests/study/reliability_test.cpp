// How probable failure is, by all methods: closed forms, and limit states at which methods fail.

#include "boxbeam/study/reliability.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"
#include "catch.hpp"
#include "limit_states.hpp"

namespace reliability_test {

using namespace boxbeam;
using namespace boxbeam::test;
using Eigen::VectorXd;
using std::sqrt;
using enum ReliabilityMethod;

TEST_CASE("a mean that fails has an index below zero, loads an alpha above it", "[study]") {
  // Resistance 2, load 4: p_f = 1 - 0.0786496035.
  LimitState limit_state =
      limit_state_of(2, [](const VectorXd& u) { return x(u, 0, 2, 1) - x(u, 1, 4, 1); });
  const ReliabilityResult of =
      reliability_of(limit_state, demand_of({form, sorm, monte_carlo, importance, subset}), 1);
  CHECK(*result_of(of, form).beta == Approx(-sqrt(2.0)).margin(1e-9));
  REQUIRE(of.points.size() == 1);
  CHECK(of.points[0].alpha[1] == Approx(1.0 / sqrt(2.0)));
  CHECK(of.points[0].alpha[0] == Approx(-1.0 / sqrt(2.0)));
  CHECK(of.points[0].u.dot(of.points[0].alpha) == Approx(-sqrt(2.0)));
  for (const MethodResult& by : of.methods) {
    CAPTURE(to_text(by.method), by.reason);
    REQUIRE(by.converged);
    CHECK(*by.p_f == Approx(1.0 - 0.0786496035).margin(by.history.empty() ? 1e-6 : 0.12));
    CHECK(*by.beta == Approx(-sqrt(2.0)).margin(by.history.empty() ? 1e-6 : 0.3));
  }
}

TEST_CASE("sorm: Breitung's closed form, and nearer to the truth than form", "[study]") {
  LimitState limit_state = limit_state_of(2, [](const VectorXd& u) {
    return 2.5 - (u[0] + u[1]) / sqrt(2.0) + 0.1 * std::pow(u[0] - u[1], 2);
  });
  const ReliabilityResult of = reliability_of(limit_state, demand_of({form, sorm}), 1);
  REQUIRE(of.points.size() == 1);
  CHECK(of.points[0].curvatures[0] == Approx(0.4).epsilon(1e-6));  // 0.2 v^2 along v
  const MethodResult& second = result_of(of, sorm);
  CHECK(*second.breitung == Approx(4.39089646e-3).epsilon(1e-6));
  // Phi(-2.5)/sqrt(1 + 0.4 phi(2.5)/Phi(-2.5)), Hohenbichler and Rackwitz by hand.
  const double below = normal_share_below(-2.5);
  const double psi = std::exp(-3.125) / sqrt(2.0 * std::numbers::pi) / below;
  CHECK(*second.p_f == Approx(below / sqrt(1.0 + 0.4 * psi)).epsilon(1e-6));
  CHECK(std::abs(*second.p_f - 4.20730551e-3) < 0.02 * 4.20730551e-3);
  // RP24 has no curvature there: both are Phi(-beta), far from the truth, which is remarked.
  LimitState flat = limit_state_of(2, [](const VectorXd& u) {
    return 2.5 - 0.2357 * 3.0 * (u[0] - u[1]) + 0.00463 * std::pow(3.0 * (u[0] + u[1]), 4);
  });
  const ReliabilityResult both = reliability_of(flat, demand_of({form, sorm, subset}), 1);
  CHECK(*result_of(both, sorm).p_f == Approx(*result_of(both, form).p_f).epsilon(1e-3));
  CHECK(*result_of(both, form).p_f == Approx(0.00621).epsilon(1e-3));
  CHECK(both.remarks.size() == 2);
}

TEST_CASE("where design points say nothing form refuses and simulations answer", "[study]") {
  struct Refused {
    const char* name;
    Eigen::Index n;
    std::function<double(const VectorXd&)> g;
    double p_f;
    const char* says;
  };
  const std::vector<Refused> all = {
      // Exact by integration over chi^2; the median fails, few designs do.
      {"RP63", 100, [](const VectorXd& u) { return 0.1 * u.tail(99).squaredNorm() - u[0] - 4.5; },
       3.76943612e-4, ""},
      // exp(-9/2): failure all around the origin.
      {"circle", 2, [](const VectorXd& u) { return 9.0 - u.squaredNorm(); }, std::exp(-4.5),
       "single"},
      // A limit state that tells only whether a design fails: no slope anywhere.
      {"yes or no", 2, [](const VectorXd& u) { return u[0] > 2.0 ? -1.0 : 1.0; },
       normal_share_below(-2.0), "does not change"},
  };
  for (const Refused& of : all) {
    CAPTURE(of.name);
    LimitState limit_state = limit_state_of(of.n, of.g);
    ReliabilityDemand demand = demand_of({form, sorm, monte_carlo, importance}, 0.15);
    demand.starts = 3;
    const ReliabilityResult result = reliability_of(limit_state, demand, 1);
    for (const ReliabilityMethod method : {form, sorm, importance}) {
      const MethodResult& by = result_of(result, method);
      CAPTURE(by.reason);
      CHECK_FALSE(by.converged);
      CHECK_FALSE(by.p_f);
      CHECK_FALSE(by.beta);
      CHECK_THAT(by.reason, Catch::Contains(of.says));
      CHECK_FALSE(by.reason.empty());
    }
    CHECK(result.points.empty());
    const MethodResult& by = result_of(result, monte_carlo);
    REQUIRE(by.converged);
    CHECK(std::abs(*by.p_f - of.p_f) < within * by.history.back().variation * of.p_f);
  }
  // Subset simulation needs no design point; of a limit state without slope it says nothing.
  LimitState quadratic = limit_state_of(all[0].n, all[0].g);
  const MethodResult by = reliability_of(quadratic, demand_of({subset}, 0.15), 1).methods.front();
  REQUIRE(by.converged);
  CHECK(std::abs(*by.p_f - all[0].p_f) < within * by.history.back().variation * all[0].p_f);
  LimitState steps = limit_state_of(2, [](const VectorXd& u) { return u[0] > 4.0 ? -1.0 : 1.0; });
  const MethodResult none = reliability_of(steps, demand_of({subset}, 0.05), 1).methods.front();
  CHECK_FALSE(none.p_f);
  CHECK_THAT(none.reason, Catch::Contains("flat"));
}

TEST_CASE("what cannot be judged counts as failing, and is counted", "[study]") {
  // Fails beyond 3, cannot be judged below -2.
  LimitState limit_state(1, [] {
    return [](const VectorXd& u) {
      return u[0] < -2.0 ? Response{1.0, "no assembly"} : Response{3.0 - u[0], ""};
    };
  });
  const ReliabilityResult of =
      reliability_of(limit_state, demand_of({monte_carlo, subset}, 0.05), 1);
  const double exact = normal_share_below(-3.0) + normal_share_below(-2.0);
  for (const MethodResult& by : of.methods) {
    REQUIRE(by.p_f);
    CHECK(std::abs(*by.p_f - exact) < within * by.history.back().variation * exact);
    CHECK(by.unjudged > 0);
  }
  CHECK(of.first_trouble == "no assembly");
  // None can be judged: nothing is said of design points.
  LimitState none(2, [] { return [](const VectorXd&) { return Response{1.0, "no case"}; }; });
  const MethodResult first = reliability_of(none, demand_of({form}), 1).methods.front();
  CHECK_FALSE(first.p_f);
  CHECK_THAT(first.reason, Catch::Contains("no case"));
}

TEST_CASE("the same numbers by any number of threads, others by another seed", "[study]") {
  const auto numbers = [](std::size_t threads, std::uint64_t seed) {
    LimitState limit_state = limit_state_of(
        3, [](const VectorXd& u) { return 3.0 - u[0] - 0.3 * u[1] * u[2]; }, threads);
    const ReliabilityResult of = reliability_of(
        limit_state, demand_of({form, sorm, monte_carlo, importance, subset}, 0.1), seed);
    std::vector<double> all{static_cast<double>(of.calls)};
    for (const MethodResult& by : of.methods) {
      all.push_back(by.p_f.value_or(-1.0));
      all.push_back(by.low);
      all.push_back(by.high);
    }
    return all;
  };
  CHECK(numbers(1, 7) == numbers(4, 7));
  CHECK(numbers(2, 7) != numbers(2, 8));
}

TEST_CASE("no failing sample: a bound and no probability", "[study]") {
  LimitState limit_state = limit_state_of(1, [](const VectorXd& u) { return 7.0 - u[0]; });
  ReliabilityDemand demand = demand_of({monte_carlo});
  demand.samples = 1000;
  const MethodResult by = reliability_of(limit_state, demand, 1).methods.front();
  CHECK_FALSE(by.converged);
  CHECK_FALSE(by.p_f);
  CHECK(by.high == Approx(1.0 - std::pow(0.025, 1e-3)));  // (1 - p)^n = 0.025
  LimitState fails = limit_state_of(1, [](const VectorXd& u) { return u[0] - 7.0; });
  const ReliabilityResult all = reliability_of(fails, demand, 1);
  CHECK_FALSE(all.methods.front().p_f);
  CHECK(all.methods.front().low == Approx(std::pow(0.025, 1e-3)));
  // Beyond what a probability near 1 can show the index stays: p_f = 1 - Phi(-10).
  LimitState far = limit_state_of(1, [](const VectorXd& u) { return u[0] - 10.0; });
  const ReliabilityResult beyond = reliability_of(far, demand_of({form, sorm}), 1);
  for (const MethodResult& of : beyond.methods) CHECK(*of.beta == Approx(-10.0).margin(1e-6));
}

TEST_CASE("failure of two at once: a kink is said, sorm refuses, samples are right", "[study]") {
  // Both above 2, Phi(-2)^2: the design point is the corner (2, 2).
  LimitState limit_state =
      limit_state_of(2, [](const VectorXd& u) { return std::max(2.0 - u[0], 2.0 - u[1]); });
  const ReliabilityResult of =
      reliability_of(limit_state, demand_of({form, sorm, importance, subset}, 0.05), 1);
  const double exact = std::pow(normal_share_below(-2.0), 2);
  REQUIRE(of.points.size() == 1);
  CHECK(of.points[0].kinked);
  CHECK(of.points[0].beta == Approx(2.0 * sqrt(2.0)).epsilon(1e-6));
  CHECK_FALSE(result_of(of, sorm).p_f);
  CHECK_THAT(result_of(of, sorm).reason, Catch::Contains("kink"));
  CHECK_FALSE(of.remarks.empty());
  for (const ReliabilityMethod method : {importance, subset}) {
    const MethodResult& by = result_of(of, method);
    CHECK(std::abs(*by.p_f - exact) < within * by.history.back().variation * exact);
  }
}

TEST_CASE("p_f of a year", "[study]") {
  CHECK(per_year(0.19, 2.0) == Approx(0.1));  // 1 - 0.9^2
  CHECK(per_year(1e-9, 50.0) == Approx(2e-11).epsilon(1e-8));
  CHECK(*reliability_index(normal_share_below(-3.8)) == Approx(3.8));
  CHECK_FALSE(reliability_index(1.0));
}

}  // namespace reliability_test
