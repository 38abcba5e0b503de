// A four-bar whose driven crank comes close to its limit, where coupler and rocker are stretched:
// positions and velocities against closed form in extended precision, and what the solver says
// about the digits that are left. Limit: cos phi = (a^2 + d^2 - (b + c)^2)/(2 a d).

#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"

namespace approach_to_toggle_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

struct Sample {
  double delta = 0.0;           ///< distance of the crank from its limit [rad]
  double position_error = 0.0;  ///< of the rocker's angle [rad]
  double velocity_error = 0.0;  ///< of the rocker's rate, relative
  double digits = 0.0;          ///< that the solver says are left
};

enum class Way { from_sketch, followed };

/// The four-bar at a distance from its limit: from a sketch 0.45 rad away, or followed from there.
std::optional<Sample> sample_at(const test::FourBar& bar, double delta, int sign, Way way) {
  const double phi = static_cast<double>(bar.limit() - static_cast<long double>(delta));
  const Mechanism mechanism = test::four_bar(bar, RateDriver{phi, 1.0}, 1.0, sign);
  InstantSolver solver(mechanism);
  State state;
  try {
    if (way == Way::from_sketch) {
      state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
    } else {
      const State start = solver.solve_from_sketch(1.0 - phi, sketch_of(mechanism));
      state = solver.solve_near(0.0, start);
    }
  } catch (const AnalysisError&) {
    return std::nullopt;
  }
  const auto exact = test::posture_of(bar, static_cast<long double>(phi), sign);
  Sample sample;
  sample.delta = static_cast<double>(bar.limit() - static_cast<long double>(phi));
  sample.position_error = static_cast<double>(
      std::abs(std::remainder(static_cast<long double>(state.q[8]) - exact.rocker,
                              2.0L * std::numbers::pi_v<long double>)));
  sample.velocity_error =
      static_cast<double>(std::abs(static_cast<long double>(state.v[8]) - exact.rocker_rate) /
                          std::abs(exact.rocker_rate));
  sample.digits = digits_left_at(degrees_of_freedom_of(mechanism, state.q).condition);
  return sample;
}

/// Slope of the line of least squares through (log delta, log error).
double slope_of(const std::vector<Sample>& samples) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Sample& sample : samples) {
    const double u = std::log(sample.delta);
    const double w = std::log(sample.velocity_error);
    n += 1.0;
    x += u;
    y += w;
    xx += u * u;
    xy += u * w;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

TEST_CASE("the limit of the four-bar (hand formula)") {
  CHECK(std::abs(static_cast<double>(test::FourBar{}.limit() - 1.450506444400108624L)) < 4e-16);
}

TEST_CASE("towards a dead point velocities lose digits as round-off over the distance") {
  const test::FourBar bar;
  for (const Way way : {Way::from_sketch, Way::followed}) {
    std::vector<Sample> falling;
    double worst_position = 0.0;
    double worst_promise = -100.0;
    double worst_factor = 0.0;
    int refused = 0;
    int solved = 0;
    for (int k = 4; k <= 56; ++k) {
      for (const int sign : {1, -1}) {
        const double delta = std::pow(10.0, -0.25 * k);
        INFO("delta = " << delta << ", sign " << sign);
        const std::optional<Sample> sample = sample_at(bar, delta, sign, way);
        if (!sample) {
          ++refused;
          // Before, there are digits left to give; a motion is followed by halving its steps, which
          // ends some 24 halvings away from a dead point.
          CHECK(delta < (way == Way::from_sketch ? 1e-11 : 1e-7));
          continue;
        }
        ++solved;
        // A position cannot be better than the root of what its residual is told apart by.
        CHECK(sample->position_error < 1e-14 + 4e-15 / std::sqrt(sample->delta));
        worst_position = std::max(worst_position, sample->position_error);
        worst_factor = std::max(worst_factor, sample->velocity_error * sample->delta);
        CHECK(sample->velocity_error < 0.5);
        CHECK(sample->velocity_error < 1e-14 + 1e-14 / sample->delta);
        const double really = -std::log10(std::max(sample->velocity_error, 1e-16));
        CHECK(sample->digits >= 0.0);
        CHECK(sample->digits <= really + 1.0);
        worst_promise = std::max(worst_promise, sample->digits - really);
        if (sample->velocity_error > 1e-14) falling.push_back(*sample);
      }
    }
    const double slope = slope_of(falling);
    std::cout << "stability: approach to a dead point, "
              << (way == Way::from_sketch ? "from a sketch" : "followed")
              << ", 1e-1 .. 1e-14 rad: " << solved << " solved, " << refused
              << " refused; velocity error at most " << worst_factor << "/delta, slope " << slope
              << "; position error at most " << worst_position
              << " rad; digits promised minus digits left at most " << worst_promise << "\n";
    CHECK(slope == Approx(-1.0).margin(0.15));
    CHECK(falling.size() > 30);
    CHECK(solved > (way == Way::from_sketch ? 80 : 48));
  }
}

TEST_CASE("at the dead point and beyond nothing is returned") {
  const test::FourBar bar;
  int refused = 0;
  int wrong = 0;
  for (const Way way : {Way::from_sketch, Way::followed}) {
    for (const double delta :
         {0.0, -1e-15, -1e-14, -1e-13, -1e-12, -1e-11, -1e-10, -1e-9, -1e-6, -1e-3, -1e-1}) {
      for (const int sign : {1, -1}) {
        INFO("delta = " << delta << ", sign " << sign);
        const bool solved = sample_at(bar, delta, sign, way).has_value();
        CHECK_FALSE(solved);
        (solved ? wrong : refused) += 1;
      }
    }
    // Closer than a few units of the last place: an answer with a digit, or none.
    for (const double delta : {5e-15, 2e-15, 1e-15, 5e-16}) {
      for (const int sign : {1, -1}) {
        const std::optional<Sample> sample = sample_at(bar, delta, sign, way);
        INFO("delta = " << delta << ", sign " << sign);
        const bool bad = sample && !(sample->velocity_error < 1.0);
        CHECK_FALSE(bad);
        wrong += bad ? 1 : 0;
        refused += sample ? 0 : 1;
      }
    }
  }
  std::cout << "stability: dead point and up to 0.1 rad beyond, 60 times: " << refused
            << " refused, " << wrong << " wrong\n";
}

}  // namespace approach_to_toggle_test
