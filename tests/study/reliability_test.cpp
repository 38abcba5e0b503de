// Probabilities of failure by all methods, beside exact values: published reliability benchmarks
// ("RP": the numbering of the TNO black-box challenge and of openturns/otbenchmark) whose exact
// values were integrated independently, closed forms, and limit states at which methods fail.

#include "boxbeam/study/reliability.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"
#include "boxbeam/study/series_system.hpp"
#include "catch.hpp"

namespace reliability_test {

using namespace boxbeam;
using Eigen::VectorXd;
using std::sqrt;
using enum ReliabilityMethod;

namespace {

LimitState limit_state_of(Eigen::Index n, std::function<double(const VectorXd&)> g,
                          std::size_t threads = 1) {
  return LimitState(
      n, [g] { return [g](const VectorXd& u) {
                 return Response{g(u), ""};
               }; }, threads, 100);
}

ReliabilityDemand demand_of(std::vector<ReliabilityMethod> methods, double variation = 0.03) {
  ReliabilityDemand demand;
  demand.methods = std::move(methods);
  demand.variation = variation;
  demand.samples = 4'000'000;
  return demand;
}

Distribution by_moments(DistributionKind kind, double mean, double sd) {
  return distribution_by_moments(kind, mean, sd);
}

const MethodResult& result_of(const ReliabilityResult& of, ReliabilityMethod method) {
  for (const MethodResult& result : of.methods)
    if (result.method == method) return result;
  throw std::runtime_error("not asked for");
}

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

constexpr double within = 4.0;  // coefficients of variation

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

/// The standard normal of a variable of given moments and value: where a limit state is written in
/// variables.
double x(const VectorXd& u, Eigen::Index i, double mean, double sd) { return mean + sd * u[i]; }

}  // namespace

TEST_CASE("reliability benchmarks: form and simulations beside exact values", "[study]") {
  using enum DistributionKind;
  const Distribution steel = by_moments(lognormal, 390.0, 27.3);
  const Distribution force = by_moments(lognormal, 140e3, 21e3);
  const Distribution rod = by_moments(lognormal, 300.0, 30.0);
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
      reliability_of(sum, demand_of({form, sorm, monte_carlo, importance, subset}, 0.03), 1);
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
}

TEST_CASE("two half-spaces: bivariate normal probabilities and Ditlevsen's bounds", "[study]") {
  // Closed forms: at the origin 1/4 + arcsin(rho)/(2 pi); independent; the same; opposite.
  for (const double rho : {-0.99, -0.5, 0.0, 0.3, 0.9, 0.9999}) {
    CAPTURE(rho);
    CHECK(both_below(0.0, 0.0, rho) ==
          Approx(0.25 + std::asin(rho) / (2.0 * std::numbers::pi)).epsilon(1e-12));
    // By Simpson's rule over the first variable.
    const double a = 1.5, b = 2.0;
    constexpr int parts = 200000;
    const double width = 10.0 / parts;
    double sum = 0.0;
    for (int i = 0; i <= parts; ++i) {
      const double z = a + i * width, weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * std::exp(-0.5 * z * z) *
             normal_share_below((rho * z - b) / sqrt(1.0 - rho * rho));
    }
    CHECK(both_below(a, b, rho) ==
          Approx(sum * width / 3.0 / sqrt(2.0 * std::numbers::pi)).epsilon(1e-6).margin(1e-12));
  }
  CHECK(both_below(2.0, 3.0, 1.0) == Approx(normal_share_below(-3.0)));
  CHECK(both_below(2.0, 3.0, -1.0) == 0.0);
  const VectorXd right = VectorXd::Unit(2, 0), up = VectorXd::Unit(2, 1);
  const double p = normal_share_below(-2.0), q = normal_share_below(-2.5);
  const Bounds two = probability_of_any({{2.5, up}, {2.0, right}});
  CHECK(two.low == Approx(p + q - p * q).epsilon(1e-12));
  CHECK(two.high == Approx(p + q - p * q).epsilon(1e-12));
  const Bounds same = probability_of_any({{2.0, right}, {2.0, right}});
  CHECK(same.high == Approx(p).epsilon(1e-12));
  const Bounds three = probability_of_any(
      {{0.0, right}, {0.0, 0.5 * right + sqrt(0.75) * up}, {0.0, -0.5 * right + sqrt(0.75) * up}});
  CHECK(three.low < three.high);
  // Half-planes through the origin, turned by 0, 60 and 120 degrees: 300 of 360 degrees.
  CHECK(three.low <= 5.0 / 6.0 + 1e-12);
  CHECK(three.high >= 5.0 / 6.0 - 1e-12);
}

TEST_CASE("p_f of a year", "[study]") {
  CHECK(per_year(0.19, 2.0) == Approx(0.1));  // 1 - 0.9^2
  CHECK(per_year(1e-9, 50.0) == Approx(2e-11).epsilon(1e-8));
  CHECK(index_of(normal_share_below(-3.8)) == Approx(3.8));
}

}  // namespace reliability_test
