// Drivers that ask for more than a mechanism reaches: the gap of the closest approach, and the
// value of the driver at which the reach ends, against closed forms.

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <iostream>
#include <optional>
#include <regex>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace beyond_limit_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// What the solver says of a mechanism that cannot be assembled at t = 0.
std::optional<AnalysisFailure> refusal_of(const Mechanism& mechanism) {
  try {
    InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
  } catch (const AnalysisError& error) {
    return error.failure();
  }
  return std::nullopt;
}

/// The number behind "reachable on this way" in the lines of a failure, driver after driver.
std::vector<double> reachable_in(const AnalysisFailure& failure) {
  std::vector<double> values;
  for (const std::string& line : failure.details) {
    std::smatch match;
    if (std::regex_search(line, match, std::regex("reachable on this way ([-+0-9.e]+)"))) {
      values.push_back(std::stod(match[1]));
    }
  }
  return values;
}

std::vector<double> one(double value) { return {value}; }

/// Smallest sum of squares of what the joints of an over-stretched four-bar are open by (lengths
/// by the size 1.5 m) and what the driver is off by: the shortfall s is shared by its four pins,
/// s/4 each, and the crank turns back by x.
struct Closest {
  double pin = 0.0;     ///< what each pin is open by [m]
  double driver = 0.0;  ///< [rad]
};

Closest closest_of(const test::FourBar& bar, double beyond) {
  const auto phi = static_cast<double>(bar.limit()) + beyond;
  const auto shortfall = [&](double x) {
    const double r =
        std::sqrt(bar.a * bar.a + bar.d * bar.d - 2.0 * bar.a * bar.d * std::cos(phi - x));
    return std::max(0.0, r - bar.b - bar.c);
  };
  const auto cost = [&](double share) {
    return 4.0 * std::pow(0.25 * shortfall(share * beyond) / (1.5 * beyond), 2.0) + share * share;
  };
  const double x = beyond * boost::math::tools::brent_find_minima(cost, 0.0, 1.0, 50).first;
  return {0.25 * shortfall(x), x};
}

}  // namespace

TEST_CASE("a crank beyond its limit: closest approach by a scan, limit by the hand formula") {
  const test::FourBar bar;
  const auto limit = static_cast<double>(bar.limit());
  double worst_gap = 0.0;
  double worst_limit = 0.0;
  for (const double beyond : {0.6, 0.2, 0.05, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
    for (const int side : {1, -1}) {
      const double phi = side * (limit + beyond);
      const Mechanism mechanism = test::four_bar(bar, RateDriver{phi, 1.0}, side * 1.0, side);
      INFO("beyond by " << beyond << " to side " << side);
      const std::optional<AnalysisFailure> failure = refusal_of(mechanism);
      REQUIRE(failure.has_value());
      CHECK(failure->time.value() == 0.0);
      const Closest closest = closest_of(bar, beyond);
      const bool driver_named = closest.driver > closest.pin / 1.5;
      const double gap = driver_named ? closest.driver : closest.pin;
      CHECK(failure->residual.value() == Approx(gap).epsilon(1e-3));
      CHECK((failure->where == "joint motor") == driver_named);
      worst_gap = std::max(worst_gap, std::abs(failure->residual.value() / gap - 1.0));

      const std::vector<double> said = reachable_in(*failure);
      REQUIRE(said.size() == 1);
      CHECK(said[0] == Approx(side * limit * 180.0 / test::pi).epsilon(1e-8));

      const Assembly start = Assembler(mechanism).assemble_at({side * 1.0}, sketch_of(mechanism));
      REQUIRE(start.closed);
      const Reach reach = find_reach(mechanism, start.q, {phi});
      REQUIRE(reach.limited);
      CHECK(reach.values[0] == Approx(side * limit).margin(1e-10));
      worst_limit = std::max(worst_limit, std::abs(reach.values[0] - side * limit));
    }
  }
  std::cout
      << "stability: crank 1e-8 .. 0.6 rad beyond its limit, 16 times: all refused; gap within "
      << worst_gap << " of the scanned one, limit within " << worst_limit << " rad\n";
}

TEST_CASE("a slider pulled further than crank and rod reach (hand formula r + l)") {
  double worst = 0.0;
  int cases = 0;
  for (const double l : {0.9, 1.0, 1.6, 3.0}) {
    const double r = 0.7;
    for (const double beyond : {1.0, 0.1, 1e-3, 1e-6}) {
      // Beyond r + l outwards.
      const double wanted = r + l + beyond;
      const Mechanism mechanism =
          test::slider_crank(r, l, PolynomialDriver{one(wanted)}, 1.2, true);
      INFO("l = " << l << ", wanted " << wanted);
      const std::optional<AnalysisFailure> failure = refusal_of(mechanism);
      REQUIRE(failure.has_value());
      // The overlap is shared by three pins and the driver of the slider: a quarter each.
      CHECK(failure->residual.value() == Approx(0.25 * beyond).epsilon(1e-6));
      const std::vector<double> said = reachable_in(*failure);
      REQUIRE(said.size() == 1);
      CHECK(said[0] == Approx(r + l).epsilon(1e-8));
      const Reach reach = find_reach(
          mechanism,
          Assembler(mechanism).assemble_at({r * std::cos(1.2) + l * 0.6}, sketch_of(mechanism)).q,
          {wanted});
      REQUIRE(reach.limited);
      CHECK(reach.values[0] == Approx(r + l).margin(1e-10));
      worst = std::max(worst, std::abs(reach.values[0] - r - l));
      ++cases;
    }
  }
  std::cout << "stability: slider 1e-6 .. 1 m beyond crank and rod, " << cases
            << " times: all refused with a quarter of it as the gap, limit within " << worst
            << " m\n";
}

TEST_CASE("the sledge rig beyond its reach (hand formula)") {
  // Beam of 3 m and upper rod of 0.5 m in line: x^2 + 3^2 = 3.5^2; folded over on the other side
  // the same with -x. The lower loop ends earlier only for shorter rods.
  const double limit = std::sqrt(3.5 * 3.5 - 3.0 * 3.0);
  CHECK(limit - 0.5 == Approx(1.302776).margin(5e-7));
  double worst = 0.0;
  for (const double wanted : {limit + 1e-6, limit + 1e-3, 2.0, 3.0, 5.0}) {
    Mechanism mechanism = planar_of(test::rig());
    test::exciter_of(mechanism).mean = wanted;
    INFO("blade at " << wanted);
    const std::optional<AnalysisFailure> failure = refusal_of(mechanism);
    REQUIRE(failure.has_value());
    CHECK(failure->residual.value() > 0.0);
    const std::vector<double> said = reachable_in(*failure);
    REQUIRE(said.size() == 1);
    CHECK(said[0] == Approx(limit).epsilon(1e-8));
    const Reach reach = find_reach(mechanism, test::rig_state(0.0).q, {wanted});
    REQUIRE(reach.limited);
    CHECK(reach.values[0] == Approx(limit).margin(1e-10));
    worst = std::max(worst, std::abs(reach.values[0] - limit));
  }
  // A motion: the stroke a little too long is refused near the instant at which the reach ends.
  for (const double beyond : {0.5, 1e-2, 1e-3}) {
    Mechanism mechanism = planar_of(test::rig());
    test::exciter_of(mechanism).amplitude = limit - 0.5 + beyond;
    const double at = std::asin((limit - 0.5) / (limit - 0.5 + beyond)) / (2.0 * test::pi * 0.7);
    INFO("stroke beyond by " << beyond);
    try {
      solve_motion(mechanism);
      FAIL_CHECK("must be refused");
    } catch (const AnalysisError& error) {
      CHECK(error.failure().time.value() == Approx(at).margin(1e-6));
      const std::vector<double> said = reachable_in(error.failure());
      REQUIRE(said.size() == 1);
      CHECK(said[0] == Approx(limit).epsilon(1e-8));
    }
  }
  std::cout << "stability: sledge rig's blade 1e-6 .. 3.2 m beyond its reach: all refused, limit "
               "1.802776 m within "
            << worst << " m; strokes 1 mm .. 0.5 m too long refused at their instant\n";
}

TEST_CASE("two drivers that ask for too much together (bisection along the straight way)") {
  // A five-bar: cranks of 0.5 m about (0, 0) and (2, 0), couplers of 0.9 m between their tips.
  const auto tips_apart = [](double first, double second) {
    const Eigen::Vector2d A = 0.5 * Eigen::Vector2d(std::cos(first), std::sin(first));
    const Eigen::Vector2d B =
        Eigen::Vector2d(2.0, 0.0) + 0.5 * Eigen::Vector2d(std::cos(second), std::sin(second));
    return (B - A).norm();
  };
  const double from_1 = 1.0, from_2 = 2.2;
  int cases = 0;
  double worst = 0.0;
  for (const auto& [to_1, to_2] :
       {std::pair{3.0, 0.3}, std::pair{2.5, 1.2}, std::pair{1.6, 0.2}, std::pair{3.2, 6.3}}) {
    const Eigen::Vector2d A = 0.5 * Eigen::Vector2d(std::cos(from_1), std::sin(from_1));
    const Eigen::Vector2d B =
        Eigen::Vector2d(2.0, 0.0) + 0.5 * Eigen::Vector2d(std::cos(from_2), std::sin(from_2));
    const Eigen::Vector2d half = 0.5 * (B - A);
    const Eigen::Vector2d tip =
        A + half +
        std::sqrt(0.81 - half.squaredNorm()) * Eigen::Vector2d(-half.y(), half.x()).normalized();
    Mechanism mechanism;
    mechanism.bodies = {test::rod("first", {0.0, 0.0}, A), test::rod("left", A, tip),
                        test::rod("right", tip, B), test::rod("second", {2.0, 0.0}, B)};
    using test::on, test::on_ground;
    mechanism.joints = {
        {"O", Pin{on(0, -0.25), on_ground(0.0, 0.0)}},
        {"A", Pin{on(0, 0.25), on(1, -0.45)}},
        {"T", Pin{on(1, 0.45), on(2, -0.45)}},
        {"B", Pin{on(2, 0.45), on(3, 0.25)}},
        {"D", Pin{on(3, -0.25), on_ground(2.0, 0.0)}},
        {"one", Driven{on(0, 0.0), Coordinate::angle, PolynomialDriver{one(to_1)}}},
        {"two", Driven{on(3, 0.0), Coordinate::angle, PolynomialDriver{one(to_2)}}}};
    INFO("to " << to_1 << ", " << to_2);
    // Where the tips are first 1.8 m apart.
    double low = 0.0;
    while (low < 1.0 &&
           tips_apart(from_1 + low * (to_1 - from_1), from_2 + low * (to_2 - from_2)) < 1.8) {
      low += 1e-3;
    }
    REQUIRE(low < 1.0);
    double high = low;
    low -= 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double s = 0.5 * (low + high);
      (tips_apart(from_1 + s * (to_1 - from_1), from_2 + s * (to_2 - from_2)) < 1.8 ? low : high) =
          s;
    }
    const Assembly start = Assembler(mechanism).assemble_at({from_1, from_2}, sketch_of(mechanism));
    REQUIRE(start.closed);
    const Reach reach = find_reach(mechanism, start.q, {to_1, to_2});
    REQUIRE(reach.limited);
    CHECK(reach.share == Approx(low).margin(1e-10));
    CHECK(reach.values[0] == Approx(from_1 + low * (to_1 - from_1)).margin(1e-10));
    CHECK(reach.values[1] == Approx(from_2 + low * (to_2 - from_2)).margin(1e-10));
    worst = std::max(worst, std::abs(reach.share - low));
    if (tips_apart(to_1, to_2) > 1.8) {
      const std::optional<AnalysisFailure> failure = refusal_of(mechanism);
      REQUIRE(failure.has_value());
      CHECK(reachable_in(*failure).size() == 2);
    }
    ++cases;
  }
  std::cout << "stability: two drivers beyond their common reach, " << cases
            << " times: all limited, share of the way within " << worst << "\n";
}

TEST_CASE("a reach that holds all the way is not limited") {
  const test::FourBar bar;
  const Mechanism mechanism = test::four_bar(bar, RateDriver{0.5, 1.0}, 1.0, 1);
  const Assembly start = Assembler(mechanism).assemble_at({1.0}, sketch_of(mechanism));
  const auto limit = static_cast<double>(bar.limit());
  int wrong = 0;
  for (const double wanted : {0.0, -1.0, -limit + 1e-6, 1.4, limit - 1e-3, limit - 1e-6}) {
    INFO("wanted " << wanted);
    const bool limited = find_reach(mechanism, start.q, {wanted}).limited;
    CHECK_FALSE(limited);
    wrong += limited ? 1 : 0;
  }
  std::cout << "stability: 6 crank angles up to 1e-6 rad before the limit: " << wrong
            << " wrongly called out of reach\n";
}

}  // namespace beyond_limit_test
