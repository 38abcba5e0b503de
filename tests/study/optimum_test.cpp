#include "boxbeam/study/optimum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "catch.hpp"

namespace boxbeam {
namespace {

using Values = std::vector<double>;

OptimumQuestion question_of(std::vector<Choice> choices, std::vector<std::string> limits,
                            const OptimumQuestion::Function& function) {
  OptimumQuestion question;
  question.choices = std::move(choices);
  question.limits = std::move(limits);
  question.make = [function] { return function; };
  return question;
}

double price_of(const Optimum& optimum, const std::string& name) {
  for (const ActiveLimit& active : optimum.active)
    if (active.name == name && active.price) return *active.price;
  return 0.0;
}

// A stepped cantilever of hollow squares: min .0624 sum x, sum a_i/x_i^3 <= 1. Closed form by
// Lagrange: x_i = S^(1/3) a_i^(1/4), f = .0624 S^(4/3), S = sum a_i^(1/4).
TEST_CASE("the stepped hollow cantilever has the sides of the closed form, and its price") {
  const Values a{61, 37, 19, 7, 1};
  double S = 0.0;
  for (const double ai : a) S += std::pow(ai, 0.25);
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < a.size(); ++i)
    choices.push_back({std::string(1, static_cast<char>('a' + i)), 0.01, 100.0, {}});
  const Optimum optimum = optimum_of(question_of(choices, {"deflection"}, [&](const Values& x) {
    Worth worth;
    double bent = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      worth.goal += 0.0624 * x[i];
      bent += a[i] / std::pow(x[i], 3);
    }
    worth.margins = {1.0 - bent};
    return worth;
  }));
  REQUIRE(optimum.best);
  CHECK(optimum.confirmed);
  const double least = 0.0624 * std::pow(S, 4.0 / 3.0);
  CHECK(least == Approx(1.3399564).epsilon(1e-7));
  CHECK(optimum.best->goal == Approx(least).epsilon(1e-6));
  CHECK(optimum.best->goal >= least * (1.0 - 1e-9));
  for (std::size_t i = 0; i < a.size(); ++i)
    CHECK(optimum.best->values[i] == Approx(std::cbrt(S) * std::pow(a[i], 0.25)).epsilon(1e-3));
  // f of a limit 1 + e is f (1 + e)^(-1/3).
  CHECK(price_of(optimum, "deflection") == Approx(least / 3.0).epsilon(1e-4));
}

// Ragsdell and Phillips' welded beam with the polar moment 2 sqrt2 h l (l^2/12 + ((h+t)/2)^2).
Worth welded_beam(const Values& x, double polar_divisor, bool by_deb) {
  const double h = x[0], l = x[1], t = x[2], b = x[3];
  const double P = 6000, L = 14, E = 30e6, G = 12e6;
  const double M = P * (L + l / 2), R = std::sqrt(l * l / 4 + std::pow((h + t) / 2, 2));
  const double J = 2 * std::sqrt(2) * h * l * (l * l / polar_divisor + std::pow((h + t) / 2, 2));
  const double t1 = P / (std::sqrt(2) * h * l), t2 = M * R / J;
  const double tau = std::sqrt(t1 * t1 + t1 * t2 * l / R + t2 * t2);
  const double sigma = 6 * P * L / (b * t * t),
               deflection = 4 * P * L * L * L / (E * b * t * t * t);
  const double buckling =
      by_deb ? 64746.022 * (1 - 0.0282346 * t) * t * b * b * b
             : 4.013 * E * t * b * b * b / (6 * L * L) * (1 - t / (2 * L) * std::sqrt(E / (4 * G)));
  return {1.10471 * h * h * l + 0.04811 * t * b * (14 + l),
          {1 - tau / 13600, 1 - sigma / 30000, b - h, 1 - deflection / 0.25, 1 - P / buckling},
          ""};
}

TEST_CASE("the welded beam costs 1.7248523, and 1.6952472 with another polar moment") {
  const std::vector<Choice> choices{
      {"h", 0.1, 2, {}}, {"l", 0.1, 10, {}}, {"t", 0.1, 10, {}}, {"b", 0.1, 2, {}}};
  const std::vector<std::string> limits{"shear", "bending", "weld", "deflection", "buckling"};
  const auto least = [&](double divisor) {
    return optimum_of(question_of(
        choices, limits, [divisor](const Values& x) { return welded_beam(x, divisor, false); }));
  };
  const Optimum optimum = least(12);
  REQUIRE(optimum.best);
  CHECK(optimum.confirmed);
  CHECK(optimum.best->goal == Approx(1.7248523).epsilon(1e-6));
  CHECK(optimum.best->values[0] == Approx(0.2057296).epsilon(1e-4));
  CHECK(optimum.best->values[1] == Approx(3.4704887).epsilon(1e-4));
  CHECK(optimum.best->values[2] == Approx(9.0366239).epsilon(1e-4));
  CHECK(least(4).best->goal == Approx(1.6952472).epsilon(1e-6));
}

// Dakota's cantilever with the stress and deflection of the mean values.
TEST_CASE("the cantilever of two loads has 7.8235203 square inches") {
  const double R = 4e4, E = 2.9e7, X = 500, Y = 1000, L = 100;
  const Optimum optimum = optimum_of(question_of(
      {{"w", 1, 10, {}}, {"t", 1, 10, {}}}, {"stress", "deflection"}, [&](const Values& x) {
        const double w = x[0], t = x[1];
        const double stress = 600 * Y / (w * t * t) + 600 * X / (w * w * t);
        const double deflection = 4 * L * L * L / (E * w * t) *
                                  std::sqrt(std::pow(Y / (t * t), 2) + std::pow(X / (w * w), 2));
        return Worth{w * t, {1 - stress / R, 1 - deflection / 2.2535}, ""};
      }));
  REQUIRE(optimum.best);
  CHECK(optimum.best->goal == Approx(7.8235203).epsilon(1e-6));
  CHECK(optimum.confirmed);
  CHECK(optimum.agreeing >= 2);
}

// NLopt's tutorial, at which one of its algorithms reports success at 2.328.
TEST_CASE("the tutorial's optimum is sqrt(8/27)") {
  const Optimum optimum = optimum_of(
      question_of({{"x", -10, 10, {}}, {"y", 0, 10, {}}}, {"a", "b"}, [](const Values& x) {
        return Worth{std::sqrt(std::max(x[1], 0.0)),
                     {x[1] - std::pow(2 * x[0], 3), x[1] - std::pow(1 - x[0], 3)},
                     ""};
      }));
  REQUIRE(optimum.best);
  CHECK(optimum.best->goal == Approx(std::sqrt(8.0 / 27.0)).epsilon(1e-6));
}

TEST_CASE("a bound that is active has the price of a linear goal") {
  const Optimum optimum =
      optimum_of(question_of({{"x", 2, 5, {}}, {"y", -1, 4, {}}}, {}, [](const Values& x) {
        return Worth{3 * x[0] - 7 * x[1], {}, ""};
      }));
  REQUIRE(optimum.best);
  CHECK(optimum.best->goal == Approx(6 - 28));
  CHECK(price_of(optimum, "x") == Approx(3));
  CHECK(price_of(optimum, "y") == Approx(7));
  CHECK(optimum.confirmed);
}

TEST_CASE("where no design keeps all limits it is said which, and no number is given") {
  const Optimum none =
      optimum_of(question_of({{"x", 0, 1, {}}}, {"low", "high"}, [](const Values& x) {
        return Worth{x[0], {x[0] + 1, x[0] - 2}, ""};
      }));
  CHECK_FALSE(none.best);
  CHECK(none.reason.find("high") != std::string::npos);
  CHECK(none.reason.find("low") == std::string::npos);
  const Optimum unjudged = optimum_of(question_of({{"x", 0, 1, {}}}, {}, [](const Values&) {
    return Worth{std::nan(""), {}, ""};
  }));
  CHECK_FALSE(unjudged.best);
  CHECK(unjudged.reason.find("no number") != std::string::npos);
}

TEST_CASE("a goal with half of its designs impossible is still found") {
  const Optimum optimum =
      optimum_of(question_of({{"x", 0, 1, {}}, {"y", 0, 1, {}}}, {"sum"}, [](const Values& x) {
        if (x[0] > 0.6) return Worth{0, {0}, "cannot be built"};
        return Worth{x[0] * x[0] + x[1] * x[1], {x[0] + x[1] - 1}, ""};
      }));
  REQUIRE(optimum.best);
  CHECK(optimum.best->goal == Approx(0.5).epsilon(1e-6));
}

/// Plates in stock for a box: area at a wanted section modulus.
Worth box_of_stock(const Values& x) {
  const double flange = x[0], web = x[1], height = x[2];
  const double area = 2 * 300 * flange + 2 * height * web;
  const double inertia =
      2 * 300 * flange * std::pow(0.5 * height, 2) + 2 * web * std::pow(height, 3) / 12;
  return {area, {inertia / (0.5 * height) / 4e6 - 1, 100 - height / web}, ""};
}

TEST_CASE("of lists all combinations are looked at, or a design without a better neighbour") {
  Values stock{6, 8, 10, 12, 15, 20, 25, 30};
  Values heights;
  for (double h = 300; h <= 1200; h += 50) heights.push_back(h);
  const std::vector<Choice> choices{
      {"flange", 0, 0, stock}, {"web", 0, 0, stock}, {"height", 0, 0, heights}};
  double least = 1e99;
  Values best;
  for (const double f : stock)
    for (const double w : stock)
      for (const double h : heights) {
        const Worth worth = box_of_stock({f, w, h});
        const bool keeps = *std::min_element(worth.margins.begin(), worth.margins.end()) >= 0.0;
        if (keeps && worth.goal < least) {
          least = worth.goal;
          best = {f, w, h};
        }
      }
  OptimumQuestion question = question_of(choices, {"modulus", "slenderness"}, box_of_stock);
  const Optimum all = optimum_of(question);
  REQUIRE(all.best);
  CHECK(all.exhaustive);
  CHECK(all.confirmed);
  CHECK(all.best->values == best);
  CHECK_FALSE(all.active.empty());
  question.designs = 100;
  question.starts = 24;
  const Optimum some = optimum_of(question);
  REQUIRE(some.best);
  CHECK_FALSE(some.exhaustive);
  CHECK(some.best->goal >= least);
  CHECK(some.best->goal <= 1.02 * least);
}

TEST_CASE("lists and bounds together: the best of each combination") {
  const Values stock{6, 8, 10, 12, 15};
  const std::vector<Choice> choices{
      {"flange", 0, 0, {15}}, {"web", 0, 0, stock}, {"height", 300, 1200, {}}};
  const Optimum optimum =
      optimum_of(question_of(choices, {"modulus", "slenderness"}, box_of_stock));
  REQUIRE(optimum.best);
  // By a fine grid of the height.
  double least = 1e99;
  for (const double w : stock)
    for (int k = 0; k <= 90000; ++k) {
      const Worth worth = box_of_stock({15, w, 300 + 0.01 * k});
      if (*std::min_element(worth.margins.begin(), worth.margins.end()) >= 0.0)
        least = std::min(least, worth.goal);
    }
  CHECK(optimum.best->goal <= least);
  CHECK(optimum.best->goal >= least * (1 - 1e-5));
}

TEST_CASE("an optimum is the same on any number of threads") {
  const std::vector<Choice> choices{
      {"h", 0.1, 2, {}}, {"l", 0.1, 10, {}}, {"t", 0.1, 10, {}}, {"b", 0.1, 2, {}}};
  OptimumQuestion question =
      question_of(choices, {"shear", "bending", "weld", "deflection", "buckling"},
                  [](const Values& x) { return welded_beam(x, 12, true); });
  const Optimum one = optimum_of(question);
  question.threads = 3;
  const Optimum three = optimum_of(question);
  REQUIRE(one.best);
  CHECK(one.best->values == three.best->values);
  CHECK(one.evaluations == three.evaluations);
}

// With Deb's load of buckling and the shear of the other source's polar moment.
TEST_CASE("a random linear goal in a random ball is met on its surface") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 20; ++k) {
    const Values c{normal(random), normal(random), normal(random)};
    const double radius = 0.5 + std::abs(normal(random));
    const Optimum optimum = optimum_of(question_of(
        {{"x", -9, 9, {}}, {"y", -9, 9, {}}, {"z", -9, 9, {}}}, {"ball"}, [&](const Values& x) {
          return Worth{std::inner_product(c.begin(), c.end(), x.begin(), 0.0),
                       {radius * radius - std::inner_product(x.begin(), x.end(), x.begin(), 0.0)},
                       ""};
        }));
    const double length = std::sqrt(std::inner_product(c.begin(), c.end(), c.begin(), 0.0));
    REQUIRE(optimum.best);
    CHECK(optimum.best->goal == Approx(-radius * length).epsilon(1e-6));
    CHECK(price_of(optimum, "ball") == Approx(length / (2 * radius)).epsilon(1e-3));
  }
}

}  // namespace
}  // namespace boxbeam
