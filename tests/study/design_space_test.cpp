// Designs of a study: distributions by their closed forms, correlations by published values, the
// same designs whoever asks.

#include "boxbeam/study/design_space.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"

namespace design_space_test {

using namespace boxbeam;

namespace {

const std::string head = "[study]\ncase = \"rig.toml\"\n";

Study study_of(const std::string& text) { return parse_study("study.toml", text); }

/// Mean, standard deviation and correlation of the first two variables over all designs.
struct Moments {
  double mean_x = 0.0, mean_y = 0.0, sd_x = 0.0, sd_y = 0.0, rho = 0.0;
};

Moments moments_of(const DesignSpace& space) {
  double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  const auto n = static_cast<double>(space.size());
  for (std::size_t i = 0; i < space.size(); ++i) {
    const std::vector<Setting> design = space.at(i);
    const double a = design[0].number, b = design[1].number;
    x += a;
    y += b;
    xx += a * a;
    yy += b * b;
    xy += a * b;
  }
  Moments of{x / n, y / n, std::sqrt(xx / n - x / n * x / n), std::sqrt(yy / n - y / n * y / n),
             0.0};
  of.rho = (xy / n - x / n * y / n) / (of.sd_x * of.sd_y);
  return of;
}

}  // namespace

TEST_CASE("random numbers are those of Philox 4x32-10", "[study]") {
  // Published vector: counter and key zero give 6627e8d5 e169c58d.
  const std::uint64_t bits = (std::uint64_t{0xe169c58d} << 32U | 0x6627e8d5U) >> 11U;
  CHECK(uniform_number(0, 0, 0) == (static_cast<double>(bits) + 0.5) * 0x1.0p-53);
}

TEST_CASE("quantiles invert their distribution function, moments are their own", "[study]") {
  CHECK(normal_quantile(0.5) == Approx(0.0).margin(1e-15));
  CHECK(normal_quantile(0.975) == Approx(1.959963984540054));
  using enum DistributionKind;
  for (const DistributionKind kind : {normal, lognormal, uniform, weibull, gumbel, exponential}) {
    CAPTURE(static_cast<int>(kind));
    for (const double variation : {0.05, 0.3, 0.9}) {
      const double mean = 12.0, sd = kind == exponential ? mean : variation * mean;
      const Distribution of = distribution_by_moments(kind, mean, sd);
      CHECK(of.mean() == Approx(mean).epsilon(1e-12));
      CHECK(of.standard_deviation() == Approx(sd).epsilon(1e-9));
      // By the midpoint rule over the shares, which is the mean of the quantiles.
      constexpr int parts = 200000;
      double sum = 0.0, squares = 0.0;
      for (int i = 0; i < parts; ++i) {
        const double x = of.quantile((i + 0.5) / parts);
        sum += x / parts;
        squares += x * x / parts;
      }
      CHECK(sum == Approx(mean).epsilon(1e-3));
      CHECK(std::sqrt(squares - sum * sum) == Approx(sd).epsilon(1e-2));
    }
  }
  // F(x) of the closed forms.
  const Distribution gumbel_of = distribution_by_moments(gumbel, 10.0, 2.0);
  const double x = gumbel_of.quantile(0.9);
  CHECK(std::exp(-std::exp(-(x - gumbel_of.a) / gumbel_of.b)) == Approx(0.9));
  const Distribution weibull_of = distribution_by_moments(weibull, 10.0, 2.0);
  const double w = weibull_of.quantile(0.9);
  CHECK(1.0 - std::exp(-std::pow(w / weibull_of.a, weibull_of.b)) == Approx(0.9));
}

TEST_CASE("correlations of the normal variables behind are the closed forms", "[study]") {
  using enum DistributionKind;
  // Two lognormal ones: ln(1 + rho d1 d2)/sqrt(ln(1 + d1^2) ln(1 + d2^2)); of mean 1, standard
  // deviation 0.5 and rho = 0.3 Dakota's log-ratio example has 0.3240993.
  const Distribution log_ratio = distribution_by_moments(lognormal, 1.0, 0.5);
  CHECK(normal_correlation(log_ratio, log_ratio, 0.3) == Approx(0.3240993).epsilon(1e-6));
  const Distribution other = distribution_by_moments(lognormal, 3.0, 0.6);
  for (const double rho : {-0.6, -0.1, 0.5, 0.9}) {
    CHECK(normal_correlation(log_ratio, other, rho) ==
          Approx(std::log1p(rho * 0.5 * 0.2) / std::sqrt(std::log1p(0.25) * std::log1p(0.04)))
              .epsilon(1e-6));
    // Two uniform ones: 2 sin(pi rho/6).
    const Distribution even = distribution_by_moments(uniform, 5.0, 1.0);
    CHECK(normal_correlation(even, even, rho) ==
          Approx(2.0 * std::sin(std::numbers::pi * rho / 6.0)).epsilon(2e-4));
    const Distribution bell = distribution_by_moments(normal, 5.0, 1.0);
    CHECK(normal_correlation(bell, bell, rho) == Approx(rho).epsilon(1e-9));
  }
  const Distribution steep = distribution_by_moments(lognormal, 1.0, 3.0);
  CHECK_THROWS_AS(normal_correlation(steep, steep, -0.9), std::domain_error);
}

TEST_CASE("every combination of values is a design, the last variable first", "[study]") {
  const Study study = study_of(
      head +
      "[variables.t]\nkey = \"sections.A1.flange\"\nvalues = [\"8 mm\", \"1 cm\"]\n"
      "[variables.steel]\nkey = \"material.steel\"\nvalues = [\"S235\", \"S355\", \"S460\"]\n"
      "[variables.w]\nkeys = [\"sections.A1.web\", \"sections.A2.web\"]\nexpression = \"t/2\"\n"
      "unit = \"mm\"\n"
      "[variables.n]\nkey = \"fatigue.cycles\"\ngrid = { from = 1e6, to = 3e6, count = 2 }\n");
  const DesignSpace space(study);
  REQUIRE(space.size() == 12);
  CHECK(study.variables[0].unit == "mm");
  CHECK(space.overrides(space.at(0)) ==
        std::vector<std::string>{"sections.A1.flange=8 mm", "material.steel=S235",
                                 "sections.A1.web=4 mm", "sections.A2.web=4 mm",
                                 "fatigue.cycles=1e+06"});
  CHECK(space.overrides(space.at(1))[4] == "fatigue.cycles=3e+06");
  CHECK(space.overrides(space.at(2))[1] == "material.steel=S355");
  CHECK(space.overrides(space.at(11)) ==
        std::vector<std::string>{"sections.A1.flange=10 mm", "material.steel=S460",
                                 "sections.A1.web=5 mm", "sections.A2.web=5 mm",
                                 "fatigue.cycles=3e+06"});
}

TEST_CASE("samples have the moments and the correlation that are asked for", "[study]") {
  const std::string variables =
      "[variables.x]\ndistribution = \"lognormal\"\nmean = \"10 mm\"\nsd = \"2 mm\"\n"
      "[variables.y]\ndistribution = \"gumbel\"\nmean = \"3 kN\"\nsd = \"600 N\"\n"
      "[correlation]\n\"x,y\" = 0.5\n";
  struct Expected {
    const char* sampling;
    double of_mean, of_rest;
  };
  for (const Expected& of :
       {Expected{"random", 0.01, 0.05}, Expected{"latin hypercube", 1e-3, 0.05},
        Expected{"sobol", 1e-3, 0.02}}) {
    CAPTURE(of.sampling);
    const Study study = study_of(
        "[study]\ncase = \"rig.toml\"\nsamples = 16384\nseed = 3\n"
        "sampling = \"" +
        std::string(of.sampling) + "\"\n" + variables);
    const DesignSpace space(study);
    REQUIRE(space.size() == 16384);
    const Moments moments = moments_of(space);
    CHECK(moments.mean_x == Approx(10.0).epsilon(of.of_mean));
    CHECK(moments.mean_y == Approx(3.0).epsilon(of.of_mean));
    CHECK(moments.sd_x == Approx(2.0).epsilon(of.of_rest));
    CHECK(moments.sd_y == Approx(0.6).epsilon(of.of_rest));
    CHECK(moments.rho == Approx(0.5).margin(0.03));
  }
}

TEST_CASE("a Latin hypercube hits every share once, Sobol's sequence every half and quarter",
          "[study]") {
  const std::string variables =
      "[variables.x]\ndistribution = \"uniform\"\nmin = 0.0\nmax = 1.0\n"
      "[variables.y]\ndistribution = \"uniform\"\nmin = 0.0\nmax = 1.0\n";
  for (const char* sampling : {"latin hypercube", "sobol"}) {
    const Study study = study_of("[study]\ncase = \"rig.toml\"\nsamples = 256\nsampling = \"" +
                                 std::string(sampling) + "\"\n" + variables);
    const DesignSpace space(study);
    std::set<int> x, y;
    for (std::size_t i = 0; i < 256; ++i) {
      const std::vector<Setting> design = space.at(i);
      x.insert(static_cast<int>(256.0 * design[0].number));
      y.insert(static_cast<int>(256.0 * design[1].number));
    }
    CHECK(x.size() == 256);
    CHECK(y.size() == 256);
  }
}

TEST_CASE("another seed gives other samples, the same seed the same", "[study]") {
  const auto first_of = [](int seed) {
    const Study study =
        study_of("[study]\ncase = \"rig.toml\"\nsamples = 5\nseed = " + std::to_string(seed) +
                 "\n[variables.x]\ndistribution = \"normal\"\nmean = 0.0\nsd = 1.0\n");
    return DesignSpace(study).at(3)[0].number;
  };
  CHECK(first_of(1) == first_of(1));
  CHECK(first_of(1) != first_of(2));
}

TEST_CASE("broken studies say what is wrong and what to write", "[study]") {
  const std::string x = "[variables.x]\nkey = \"fatigue.cycles\"\n";
  struct Broken {
    std::string text, says;
  };
  const std::vector<Broken> all = {
      {"", "study"},
      {"[study]\ncase = 3\n" + x + "values = [1.0]\n", "case"},
      {head, "variables"},
      {head + "[variables]\n", "no variables"},
      {head + x, "values"},
      {head + x + "values = []\n", "no list"},
      {head + x + "values = 3\n", "no list"},
      {head + x + "values = [\"8 mm\", \"3 s\"]\n", "dimension"},
      {head + x + "values = [\"8 mm\", \"S355\"]\n", "no number"},
      {head + x + "values = [true]\n", "no number"},
      {head + x + "values = [1.0]\ngrid = { from = 1.0, to = 2.0, count = 3 }\n", "grid"},
      {head + x + "grid = { from = 1.0, to = 2.0 }\n", "count"},
      {head + x + "grid = { from = 1.0, to = 2.0, count = 1 }\n", "two or more"},
      {head + x + "grid = { from = 1.0, to = \"2 m\", count = 3 }\n", "dimension"},
      {head + x + "grid = { to = 2.0, count = 3 }\n", "from"},
      {head + x + "distribution = \"beta\"\nmean = 1.0\nsd = 0.1\n", "distribution"},
      {head + x + "distribution = \"normal\"\nmean = 1.0\nsd = 0.1\n", "samples"},
      {"[study]\ncase = \"rig.toml\"\nsamples = 3\n" + x + "values = [1.0, 2.0]\n", "samples"},
      {head + x + "distribution = \"normal\"\nmean = 1.0\n", "sd"},
      {head + x + "distribution = \"normal\"\nmean = 1.0\nsd = -0.1\n", "above zero"},
      {head + x + "distribution = \"lognormal\"\nmean = -1.0\nsd = 0.1\n", "above zero"},
      {head + x + "distribution = \"normal\"\nmin = 1.0\nmax = 2.0\n", "uniform"},
      {head + x + "distribution = \"uniform\"\nmin = 2.0\nmax = 1.0\n", "below"},
      {head + x + "expression = \"2*y\"\nunit = \"parsec\"\n", "no unit"},
      {head + x + "values = [1.0]\n[variables.y]\nkey = \"fatigue.cycles\"\nvalues = [1.0]\n",
       "two variables"},
      {head + x + "values = [1.0]\n[correlation]\n\"x,y\" = 0.5\n", "scatter"},
      {"[study]\ncase = \"a\"\nsamples = 3\n[variables.x]\ndistribution = \"normal\"\nmean = 0.0\n"
       "sd = 1.0\n[variables.y]\ndistribution = \"normal\"\nmean = 0.0\nsd = 1.0\n"
       "[correlation]\n\"x,y\" = 1.5\n",
       "between -1 and 1"},
      {"[study]\ncase = \"a\"\nsamples = 3\n[variables.x]\ndistribution = \"lognormal\"\n"
       "mean = 1.0\nsd = 3.0\n[variables.y]\ndistribution = \"lognormal\"\nmean = 1.0\nsd = 3.0\n"
       "[correlation]\n\"x,y\" = -0.9\n",
       "cannot have"},
      {"[study]\ncase = \"a\"\nsamples = 3\n[variables.x]\ndistribution = \"normal\"\nmean = 0.0\n"
       "sd = 1.0\n[variables.y]\ndistribution = \"normal\"\nmean = 0.0\nsd = 1.0\n"
       "[variables.z]\ndistribution = \"normal\"\nmean = 0.0\nsd = 1.0\n"
       "[correlation]\n\"x,y\" = 0.9\n\"y,z\" = 0.9\n\"x,z\" = -0.9\n",
       "at once"},
      {head + "[variables.\"2x\"]\nvalues = [1.0]\n", "name of a variable"},
      {head + "[variables.status]\nvalues = [1.0]\n", "name of a variable"},
      {head + x + "values = [1.0]\nvalue = 3\n", "value"},
      {head + x + "values = [1.0]\n[resuts]\n", "results"},
      {head + x + "values = [1.0]\n[results]\ncolumns = [\"x\"]\n", "a variable and a column"},
      {head + x + "values = [1.0]\n[results]\ncolumns = [\"verdict\", \"verdict\"]\n", "twice"},
      {head + "[variables.verdict]\nvalues = [1.0]\n", "name of a variable"},
      {head + x + "values = [nan, inf]\n", "no number"},
      {head + x + "values = [\"a\\nb\"]\n", "more than one line"},
      {head + x + "distribution = \"normal\"\nmean = \"nan mm\"\nsd = \"1 mm\"\n", "no number"},
      {head + "seeds = 3\n" + x + "values = [1.0]\n", "seed"},
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

TEST_CASE("an expression that has no value fails its design alone", "[study]") {
  const Study study = study_of(head +
                               "[variables.x]\nvalues = [0.0, 2.0]\n"
                               "[variables.y]\nkey = \"a.b\"\nexpression = \"1/x\"\n");
  const DesignSpace space(study);
  CHECK_THROWS_AS(space.at(0), AnalysisError);
  CHECK(space.overrides(space.at(1)) == std::vector<std::string>{"a.b=0.5"});
}

}  // namespace design_space_test
