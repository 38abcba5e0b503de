// Probabilities of failure beside exact values: published reliability benchmarks ("RP": their
// numbers in the TNO black-box challenge), whose exact values were integrated independently.

#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"
#include "catch.hpp"
#include "limit_states.hpp"

namespace reliability_benchmarks_test {

using namespace boxbeam;
using namespace boxbeam::test;
using Eigen::VectorXd;
using std::sqrt;
using enum ReliabilityMethod;

namespace {

/// What is known of a limit state, and what methods are to say.
struct Benchmark {
  const char* name;
  Eigen::Index n;
  std::function<double(const VectorXd&)> g;
  double p_f;                         ///< exact
  double beta;                        ///< of the nearest design point
  std::size_t points;                 ///< that count
  std::vector<ReliabilityMethod> by;  ///< simulations that are asked
};

void check(const Benchmark& of) {
  CAPTURE(of.name);
  LimitState limit_state = limit_state_of(of.n, of.g);
  std::vector<ReliabilityMethod> methods{form, sorm};
  methods.insert(methods.end(), of.by.begin(), of.by.end());
  const ReliabilityResult result = reliability_of(limit_state, demand_of(methods), 1);
  const MethodResult& first = result_of(result, form);
  CAPTURE(first.reason);
  REQUIRE(first.converged);
  CHECK(*first.beta == Approx(of.beta).margin(1e-6));
  REQUIRE(result.points.size() == of.points);
  for (const DesignPoint& point : result.points) {
    CHECK(point.alpha.norm() == Approx(1.0));
    CHECK((point.u - point.beta * point.alpha).norm() < 1e-12);
    CHECK(std::abs(of.g(point.u)) < 1e-3 * point.slope);
  }
  for (const ReliabilityMethod method : of.by) {
    const MethodResult& by = result_of(result, method);
    CAPTURE(to_text(method), by.reason, by.samples);
    REQUIRE(by.converged);
    CHECK(std::abs(*by.p_f - of.p_f) < within * by.history.back().variation * of.p_f);
    CHECK(by.history.back().variation <= 0.03);
    CHECK(by.low < *by.p_f);
    CHECK(by.high > *by.p_f);
  }
}

}  // namespace

TEST_CASE("reliability benchmarks of one design point beside exact values", "[study]") {
  using enum DistributionKind;
  const Distribution steel = distribution_by_moments(lognormal, 390.0, 27.3);
  const Distribution force = distribution_by_moments(lognormal, 140e3, 21e3);
  const Distribution rod = distribution_by_moments(lognormal, 300.0, 30.0);
  const double root2 = sqrt(2.0);
  const std::vector<Benchmark> all = {
      {"R-S",
       2,
       [](const VectorXd& u) { return x(u, 0, 4, 1) - x(u, 1, 2, 1); },
       0.0786496035,
       root2,
       1,
       {monte_carlo, importance, subset}},
      {"RP107",
       10,
       [](const VectorXd& u) { return 5.0 * sqrt(10.0) - u.sum(); },
       2.86651572e-7,
       5.0,
       1,
       {importance, subset}},
      {"box under bending, lognormal",
       2,
       [=](const VectorXd& u) {
         return std::log(steel.value_at(u[0]) * 2e6 / (force.value_at(u[1]) * 3000.0));
       },
       6.936694e-5,
       3.8104147,
       1,
       {importance, subset}},
      {"axial rod",
       2,
       [=](const VectorXd& u) {
         return rod.value_at(u[0]) - x(u, 1, 75e3, 5e3) / (100.0 * std::numbers::pi);
       },
       0.0291981946,
       1.8810464,
       1,
       {monte_carlo, importance, subset}},
      {"RP22",
       2,
       [=](const VectorXd& u) {
         return 2.5 - (u[0] + u[1]) / root2 + 0.1 * std::pow(u[0] - u[1], 2);
       },
       4.20730551e-3,
       2.5,
       1,
       {monte_carlo, importance, subset}},
      {"RP24",
       2,
       [](const VectorXd& u) {
         const double a = x(u, 0, 10, 3), b = x(u, 1, 10, 3);
         return 2.5 - 0.2357 * (a - b) + 0.00463 * std::pow(a + b - 20.0, 4);
       },
       2.85994569e-3,
       2.5 / (0.2357 * 3.0 * root2),
       1,
       {monte_carlo, importance, subset}},
  };
  for (const Benchmark& of : all) check(of);
}

TEST_CASE("reliability benchmarks of several design points beside exact values", "[study]") {
  const double root2 = sqrt(2.0);
  const std::vector<Benchmark> all = {
      {"RP75, no slope at the mean",
       2,
       [](const VectorXd& u) { return 3.0 - u[0] * u[1]; },
       9.81929872e-3,
       sqrt(6.0),
       2,
       {monte_carlo, importance, subset}},
      // beta by a scan along the limit state, in steps of 1e-5 of u_0.
      {"RP28, a saddle between two points",
       2,
       [](const VectorXd& u) {
         return x(u, 0, 78064.0, 11710.0) * x(u, 1, 0.0104, 0.00156) - 146.14;
       },
       1.45329455e-7,
       5.3331239022,
       2,
       {importance, subset}},
      {"four branches",
       2,
       [=](const VectorXd& u) {
         const double even = 3.0 + 0.1 * std::pow(u[0] - u[1], 2), sum = (u[0] + u[1]) / root2,
                      apart = u[0] - u[1], far = 7.0 / root2;
         return std::min({even - sum, even + sum, apart + far, far - apart});
       },
       2.22279507e-3,
       3.0,
       4,
       {monte_carlo, importance, subset}},
      {"RP111",
       2,
       [](const VectorXd& u) { return 12.5 - std::abs(u[0] * u[1]); },
       8.03508596e-7,
       5.0,
       4,
       {importance, subset}},
      {"RP89, two parts",
       2,
       [](const VectorXd& u) {
         return std::min(8.0 - u[0] * u[0] - u[1], 6.0 - u[0] / 5.0 - u[1]);
       },
       5.4712805e-3,
       2.7838822,
       2,
       {monte_carlo, importance, subset}},
  };
  for (const Benchmark& of : all) check(of);
}

TEST_CASE("form is exact of limit states that are planes in standard normal space", "[study]") {
  // beta = (4 - 2)/sqrt(2), alpha^2 halves; the resistance has alpha below zero, the load above.
  LimitState resistance_and_load =
      limit_state_of(2, [](const VectorXd& u) { return x(u, 0, 4, 1) - x(u, 1, 2, 1); });
  const ReliabilityResult of = reliability_of(resistance_and_load, demand_of({form, sorm}), 1);
  REQUIRE(of.points.size() == 1);
  CHECK(*result_of(of, form).p_f == Approx(0.0786496035).epsilon(1e-8));
  CHECK(*result_of(of, sorm).p_f == Approx(0.0786496035).epsilon(1e-6));
  CHECK(of.points[0].alpha[0] == Approx(-1.0 / sqrt(2.0)));
  CHECK(of.points[0].alpha[1] == Approx(1.0 / sqrt(2.0)));

  // Wirsching's lognormal format: ln T = ln 20 + ln D - 3 ln B - ln K in normal parts.
  const double d = sqrt(std::log1p(0.09)), k = sqrt(std::log1p(0.73 * 0.73)),
               b = 3.0 * sqrt(std::log1p(0.0625));
  LimitState life = limit_state_of(
      3, [=](const VectorXd& u) { return std::log(20.0) + d * u[0] + k * u[1] - b * u[2]; });
  const ReliabilityResult fatigue = reliability_of(life, demand_of({form}), 1);
  REQUIRE(fatigue.points.size() == 1);
  CHECK(*result_of(fatigue, form).beta == Approx(2.9111400).margin(1e-6));
  CHECK(*result_of(fatigue, form).p_f == Approx(1.800563e-3).epsilon(1e-5));
  const VectorXd share = fatigue.points[0].alpha.array().square();
  CHECK(share[0] == Approx(0.08138).margin(5e-6));
  CHECK(share[1] == Approx(0.40338).margin(5e-6));
  CHECK(share[2] == Approx(0.51524).margin(5e-6));
}

TEST_CASE("many variables that are not normal", "[study]") {
  using enum DistributionKind;
  // RP54: the sum of 20 exponential variables is a Gamma variable; p_f = P(20, 8.951).
  LimitState sum = limit_state_of(20, [](const VectorXd& u) {
    const Distribution one{exponential, 1.0, 1.0};
    double g = -8.951;
    for (const double z : u) g += one.value_at(z);
    return g;
  });
  const ReliabilityResult rp54 =
      reliability_of(sum, demand_of({form, sorm, monte_carlo, importance, subset}, 0.08), 1);
  for (const ReliabilityMethod method : {monte_carlo, importance, subset}) {
    const MethodResult& by = result_of(rp54, method);
    CAPTURE(to_text(method), by.reason);
    REQUIRE(by.converged);
    CHECK(std::abs(*by.p_f - 9.90603073e-4) < within * by.history.back().variation * 9.90603073e-4);
  }
  // By symmetry all variables are the same at the design point, x = 8.951/20. That plane has 56
  // times the probability, which is refused; with curvatures twice. All 19 are the same, of x(z)
  // with the hazard r = phi(z)/Phi(-z) as its slope: (r - z)/sqrt(20).
  REQUIRE(rp54.points.size() == 1);
  const double z = normal_quantile(-std::expm1(-8.951 / 20.0));
  CHECK(rp54.points[0].beta == Approx(-z * sqrt(20.0)).margin(1e-6));
  CHECK_FALSE(result_of(rp54, form).p_f);
  CHECK_THAT(result_of(rp54, form).reason, Catch::Contains("bent too much"));
  const auto density = [](double at) {
    return std::exp(-0.5 * at * at) / sqrt(2.0 * std::numbers::pi);
  };
  const double curvature = (density(z) / normal_share_below(-z) - z) / sqrt(20.0);
  const double below = normal_share_below(z * sqrt(20.0)), psi = density(z * sqrt(20.0)) / below;
  CHECK(*result_of(rp54, sorm).p_f ==
        Approx(below * std::pow(1.0 + psi * curvature, -9.5)).epsilon(1e-4));

  // RP8, six lognormal variables; p_f and beta by OpenTURNS as published with the benchmark.
  const Distribution a = distribution_by_moments(lognormal, 120.0, 12.0),
                     b = distribution_by_moments(lognormal, 50.0, 10.0),
                     c = distribution_by_moments(lognormal, 40.0, 8.0);
  LimitState frame = limit_state_of(6, [=](const VectorXd& u) {
    return a.value_at(u[0]) + 2.0 * a.value_at(u[1]) + 2.0 * a.value_at(u[2]) + a.value_at(u[3]) -
           5.0 * b.value_at(u[4]) - 5.0 * c.value_at(u[5]);
  });
  const ReliabilityResult rp8 = reliability_of(frame, demand_of({form, importance}), 1);
  CHECK(*result_of(rp8, form).beta == Approx(3.2116397).margin(1e-6));
  CHECK(std::abs(*result_of(rp8, importance).p_f - 7.8979e-4) < within * 0.03 * 7.8979e-4);
}

}  // namespace reliability_benchmarks_test
