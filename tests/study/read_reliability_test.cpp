// Studies of a limit state as files have them, and their variables.

#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/named_expression.hpp"
#include "boxbeam/study/study_reliability.hpp"
#include "catch.hpp"

namespace read_reliability_test {

using namespace boxbeam;

namespace {

const std::string resistance = "[variables.r]\ndistribution = \"normal\"\nmean = 4\nsd = 1\n";
const std::string load = "[variables.s]\ndistribution = \"normal\"\nmean = 2\nsd = 1\n";
const std::string limit = "[limit_state]\nexpression = \"r - s\"\n";

Study study_of(const std::string& text) { return parse_study("study.toml", text); }

ReliabilityResult result_of(const Study& study) {
  LimitState limit_state = limit_state_of_variables(study, 1);
  return reliability_of(limit_state, *study.reliability, study.seed);
}

}  // namespace

TEST_CASE("a study without a case: its limit state is a formula", "[study]") {
  const Study study = study_of("[study]\nseed = 3\n" + resistance + load + limit +
                               "[reliability]\nmethods = [\"form\"]\nyears = 2\n");
  REQUIRE(study.reliability);
  CHECK(study.case_file.empty());
  CHECK(study.reliability->samples == 100'000);
  const StudyReliability of = study_reliability(study, result_of(study));
  CHECK(of.limit_state == std::vector<std::string>{"r - s < 0"});
  REQUIRE(of.points.size() == 1);
  CHECK(*of.result.methods[0].beta == Approx(std::sqrt(2.0)).margin(1e-9));
  // r = s = 3 at the design point, a standard deviation from each mean.
  CHECK(of.points[0][0].value == Approx(3.0));
  CHECK(of.points[0][1].value == Approx(3.0));
  CHECK(of.points[0][1].u == Approx(1.0));
}

TEST_CASE("correlated variables: index and importance", "[study]") {
  const std::string correlated = "[correlation]\n\"r,s\" = 0.5\n";
  const Study study = study_of("[study]\n" + resistance + load + correlated + limit);
  const StudyReliability of = study_reliability(study, result_of(study));
  // sd of r - s: sqrt(1 + 1 - 2 * 0.5) = 1.
  CHECK(*of.result.methods[0].beta == Approx(2.0).margin(1e-9));
  CHECK(*of.result.methods[0].p_f == Approx(0.0227501319).epsilon(1e-8));
  REQUIRE(of.points.size() == 1);
  CHECK(of.correlated);
  // Whichever stands first, by symmetry of r and s.
  const Study turned = study_of("[study]\n" + load + resistance + correlated + limit);
  const StudyReliability other = study_reliability(turned, result_of(turned));
  CHECK(of.points[0][0].alpha == Approx(-std::sqrt(0.5)));
  CHECK(of.points[0][1].alpha == Approx(std::sqrt(0.5)));
  CHECK(other.points[0][0].alpha == Approx(std::sqrt(0.5)));
  CHECK(other.points[0][1].alpha == Approx(-std::sqrt(0.5)));
}

TEST_CASE("Dakota's correlated lognormal log-ratio", "[study]") {
  // Published with Dakota: x1/x2, both LN(1, 0.5), correlation 0.3; indices at two levels, of
  // x1/x2 below the level; its positive index is that of little probability.
  for (const auto& [level, beta] : {std::pair{0.4, 1.6683404}, std::pair{1.75, -1.0189229}}) {
    const Study study = study_of(
        "[study]\n[variables.a]\ndistribution = \"lognormal\"\nmean = 1\nsd = 0.5\n"
        "[variables.b]\ndistribution = \"lognormal\"\nmean = 1\nsd = 0.5\n"
        "[correlation]\n\"a,b\" = 0.3\n[limit_state]\nexpression = \"a/b - " +
        std::to_string(level) + "\"\n[reliability]\nmethods = [\"form\"]\n");
    CHECK(*result_of(study).methods[0].beta == Approx(beta).margin(1e-6));
  }
}

TEST_CASE("any of several expressions, and variables tied to others", "[study]") {
  const Study study =
      study_of("[study]\n" + resistance + "[variables.half]\nexpression = \"r/2\"\n" +
               "[limit_state]\nexpressions = [\"half - 0.5\", \"7 - r\"]\n");
  const ReliabilityResult of = result_of(study);
  // r below 1 or above 7: both three standard deviations away, and they exclude each other.
  REQUIRE(of.points.size() == 2);
  CHECK(*of.methods[0].p_f == Approx(2.0 * normal_share_below(-3.0)).epsilon(1e-8));
}

TEST_CASE("values far out are exact", "[study]") {
  using enum DistributionKind;
  for (const DistributionKind kind : {normal, lognormal, uniform, weibull, gumbel, exponential}) {
    CAPTURE(static_cast<int>(kind));
    const Distribution of = distribution_by_moments(kind, 10.0, 3.0);
    for (const double z : {-4.0, -1.0, 0.0, 0.7, 3.0})
      CHECK(of.value_at(z) == Approx(of.quantile(normal_share_below(z))).epsilon(1e-10));
    CHECK(of.value_at(9.0) < of.value_at(10.0) * (kind == uniform ? 1.0 + 1e-15 : 1.0));
  }
  // Exponential: exp(-x/a) is the share above.
  const Distribution one{exponential, 1.0, 1.0};
  CHECK(std::exp(-one.value_at(12.0)) == Approx(normal_share_below(-12.0)).epsilon(1e-12));
}

TEST_CASE("expressions name variables and results", "[study]") {
  CHECK(names_in("a*b.c + 2.5*sin(a)") == std::vector<std::string>{"a", "b.c"});
  CHECK_THROWS_AS(names_in("a + "), std::invalid_argument);
  CHECK(NamedExpression("2*x^2 - y", {"x", "y"}).at({3.0, 4.0}) == 14.0);
  CHECK_THROWS_AS(NamedExpression("x + z", {"x"}), std::invalid_argument);
}

TEST_CASE("broken studies of a limit state say what to write", "[study]") {
  const std::string head = "[study]\n", of_case = "[study]\ncase = \"rig.toml\"\n";
  const std::string method = "[reliability]\nmethods = ";
  struct Broken {
    std::string text, says;
  };
  const std::vector<Broken> all = {
      {head + resistance, "case"},
      {head + resistance + method + "[\"form\"]\n", "where a design fails"},
      {head + resistance + "[limit_state]\n", "where a design fails"},
      {head + resistance + "[limit_state]\nchecks = [\"yield\"]\n", "the study has none"},
      {head + resistance + limit, "no number of the study"},
      {head + resistance + "[limit_state]\nexpression = \"r - \"\n", "write a formula"},
      {head + resistance + "[limit_state]\nexpression = \"r - beam.mass\"\n", "has no case"},
      {of_case + resistance + "[limit_state]\nexpression = \"r - beam.length\"\n",
       "[results] columns"},
      {head + resistance + load + limit + method + "[\"fosm\"]\n", "no method"},
      {head + resistance + load + limit + "[reliability]\nsamples = 3\n", "below 100"},
      {head + resistance + load + limit + "[reliability]\nvariation = 2.0\n", "says nothing"},
      {head + resistance + load + limit + "[reliability]\nyears = -3.0\n", "years"},
      {head + resistance + load + limit + "[reliability]\nseeds = 3\n", "seeds"},
      {head + "[variables.r]\nvalues = [1, 2]\n[limit_state]\nexpression = \"r\"\n",
       "several values"},
      {head + "[variables.r]\nvalues = [1]\n[limit_state]\nexpression = \"r\"\n",
       "no variable scatters"},
      {head + "[variables.r]\nkey = \"a.b\"\ndistribution = \"normal\"\nmean = 4\nsd = 1\n"
              "[limit_state]\nexpression = \"r\"\n",
       "key of a case"},
      {head + resistance + "[limit_state]\nexpresion = \"r\"\n", "expresion"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.text);
    try {
      study_of(broken.text);
      FAIL("it was read");
    } catch (const InputError& error) {
      CHECK_THAT(std::string(error.what()), Catch::Contains(broken.says));
    }
  }
}

}  // namespace read_reliability_test
