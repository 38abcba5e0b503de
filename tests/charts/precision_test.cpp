// Errors against the precision of the arithmetic: each a few units of its round-off.

#include "charts/chart_values.hpp"
#include "charts/topics.hpp"

namespace precision_test {

using namespace boxbeam::charts;

namespace {

void check_precision(const TopicResult& result) {
  REQUIRE(result.not_applicable == "");
  for (const char* name : {"precision-positions", "precision-velocities", "precision-accelerations",
                           "precision-reactions"}) {
    INFO(name);
    const Chart& chart = test::chart_named(result, name);
    const double round_off[] = {0.5e-4, std::pow(2.0, -24), std::pow(2.0, -53), std::pow(2.0, -64)};
    for (std::size_t s = 0; s < 2; ++s) {
      REQUIRE(chart.series[s].points.size() == 4);
      for (std::size_t i = 0; i < 4; ++i) {
        const Point& point = chart.series[s].points[i];
        INFO(chart.series[s].method << ", " << point.setting);
        CHECK(point.failure == "");
        CHECK(point.error > 0.1 * round_off[i]);
        CHECK(point.error < 100.0 * round_off[i]);
      }
    }
    CHECK(test::default_of(chart).error < 1e-9 * chart.needed_low);
  }
}

}  // namespace

TEST_CASE("precision on the sledge rig: errors are units of round-off, the same twice") {
  const TopicResult result = precision(reference_scenes(), {true});
  check_precision(result);
  CHECK(test::errors_of(precision(reference_scenes(), {true})) == test::errors_of(result));

  const Chart& turning = test::chart_named(result, "precision-turning-points");
  // d(cos phase)/cos phase = tan(phase) d phase: the error grows as the loss of the rate. An
  // argument of up to 3 pi (t = 2.14 s) rounded to three digits is wrong by 0.005 at most, to five
  // by 5e-5.
  const double argument[] = {5e-3, 5e-5};
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Point& point : turning.series[s].points) {
      INFO(turning.series[s].method << ", " << point.setting);
      CHECK(point.error < 2.0 * argument[s] * *point.operations + 1e-3);
    }
  }
  const Point& three = turning.series[0].points.back();
  const Point& five = turning.series[1].points.back();
  CHECK(three.error > 0.1);
  CHECK(five.error < 0.1);
  CHECK(turning.series[1].points.front().error < 1e-3);
  CHECK(test::default_of(turning).error < 1e-11);
}

TEST_CASE("precision on another shipped mechanism") {
  check_precision(precision(test::shipped_scene("slider-crank-press/press.toml"), {true}));
}

}  // namespace precision_test
