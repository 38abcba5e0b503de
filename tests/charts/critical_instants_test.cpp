// Published figures of a slider-crank sampled at equal steps, worst phase: by its closed form, r/l
// = 0.5, 0.95 and 0.99 at 36, 72 and 360 points to a turn.

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/topics.hpp"
#include "support/program.hpp"

namespace critical_instants_test {

using namespace boxbeam;
using namespace boxbeam::charts;

TEST_CASE("peaks over time: sampling of order 2, a parabola of order 4, the program at round-off",
          "[charts]") {
  const TopicResult result = critical_instants(reference_scenes(), {true});
  REQUIRE(result.not_applicable.empty());
  for (const Chart& chart : result.charts) {
    CAPTURE(chart.name);
    REQUIRE(test::defaults_of(chart).size() == 1);
    CHECK(test::defaults_of(chart)[0].error < 1e-8);
  }

  const Chart& peak = test::chart_named(result, "critical-instants-peak");
  // The rig's moment is even about its peak, so that the parabola's error begins with h^4.
  CHECK(test::order_between(test::series_of(peak, "alone"), 24, 384) == Approx(2).margin(0.1));
  CHECK(test::order_between(test::series_of(peak, "parabola"), 24, 384) == Approx(4).margin(0.1));
  CHECK(test::defaults_of(peak)[0].error < 1e-14);

  const Chart& sharp = test::chart_named(result, "critical-instants-sharp");
  const double published[3][3] = {
      {6.7e-3, 1.7e-3, 6.7e-5}, {8.4e-2, 1.7e-2, 7.9e-4}, {0.38, 0.12, 4.6e-3}};
  const double points[] = {36, 72, 360};
  for (std::size_t i = 0; i < 3; ++i) {
    const Series& series = sharp.series[3 + i];
    CAPTURE(series.method);
    for (std::size_t k = 0; k < 3; ++k) {
      // Two digits are published.
      CHECK(test::error_at(series, points[k]) == Approx(published[i][k]).epsilon(0.03));
    }
  }

  const Chart& waves = test::chart_named(result, "critical-instants-per-wave");
  const Series& program = test::series_of(waves, "interpolated");
  // The program looks at crests within 5 % of the range. Instants 2 pi/m apart lose up to
  // 1 - cos(pi/m) of half the range: 13 % with six, 7.6 % with eight.
  CHECK(test::error_at(program, 6) > 1e-4);
  for (const double per_wave : {8.0, 10.0, 12.0, 16.0}) {
    CHECK(test::error_at(program, per_wave) < 1e-9);
  }
  // 1 - cos(pi/m) of a wave of 1 in 3, missed by instants alone.
  for (const double m : {8.0, 12.0, 16.0}) {
    const double lost = (1.0 - std::cos(std::numbers::pi / m)) / 3.0;
    CHECK(test::error_at(test::series_of(waves, "alone"), m) < 1.02 * lost);
    CHECK(test::error_at(test::series_of(waves, "alone"), m) > 0.5 * lost);
  }

  const Chart& nodes = test::chart_named(result, "critical-instants-nodes");
  // Interpolation of cos over two steps of pi/4 through n Chebyshev points: at most
  // 2 (pi/4)^n/(n! 2^(n-1)) (points of the second kind: twice those of the first).
  double bound = 2.0;
  for (int n = 1; n <= 11; ++n) {
    bound *= std::numbers::pi / 4.0 / n * (n > 1 ? 0.5 : 1.0);
    if (n < 3 || n % 2 == 0) continue;
    CAPTURE(n);
    CHECK(test::error_at(nodes.series[0], n) < bound);
    CHECK(test::error_at(nodes.series[0], n) > 0.01 * bound);
  }
  CHECK(test::defaults_of(nodes)[0].error == Approx(test::error_at(nodes.series[0], 9)));

  const Chart& bits = test::chart_named(result, "critical-instants-bits");
  for (const Point& point : bits.series[0].points) {
    // The value of a maximum is off by the square of its place: half of (pi/4 2 2^-b)^2, and
    // Brent's tolerance is met within a few times.
    const double place = std::numbers::pi / 2.0 * std::pow(2.0, -point.parameter);
    CHECK(point.error < 10.0 * place * place + 1e-15);
  }
}

TEST_CASE("peaks over time of other cases, twice the same", "[charts][unsanitized]") {
  for (const char* path :
       {"sections/landing-gear/retraction.toml", "sections/templates/flexible.toml"}) {
    CAPTURE(path);
    const Scenes scenes = scenes_of(read_project(test::project_file(path)));
    const TopicResult once = critical_instants(scenes, {true});
    const Chart& peak = test::chart_named(once, "critical-instants-peak");
    REQUIRE(test::defaults_of(peak).size() == 1);
    CHECK(test::defaults_of(peak)[0].error < peak.needed_low);
    CHECK(test::errors_of(once) == test::errors_of(critical_instants(scenes, {true})));
  }
}

}  // namespace critical_instants_test
