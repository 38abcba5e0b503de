// Accuracy of reactions: which factorisation, which tolerance, and what a balance proves.

#include "charts/chart_values.hpp"
#include "charts/topics.hpp"

namespace reactions_test {

using namespace boxbeam::charts;

namespace {

void check_reactions(const TopicResult& result) {
  REQUIRE(result.not_applicable == "");
  const Chart& methods = test::chart_named(result, "reactions-methods");
  const Chart& balance = test::chart_named(result, "reactions-balance");
  CHECK(test::default_of(methods).error < 1e-13);
  for (std::size_t s = 0; s < 3; ++s) {
    CHECK(methods.series[s].points.front().error < 1e-13);
    CHECK(balance.series[s].points.front().error < 1e-14);
  }
  // The condition squared: worse, but not in sight of what a check needs.
  const double normal = methods.series[3].points.front().error;
  CHECK(normal > methods.series[1].points.front().error);
  CHECK(normal < 1e-8);
  // In balance to round-off, and wrong.
  const double wrong = methods.series[4].points.front().error;
  CHECK(balance.series[4].points.front().error < 1e-14);
  CHECK(wrong > 1e-5);
  CHECK(wrong < 1e-1);

  const Chart& tolerance = test::chart_named(result, "reactions-tolerance");
  const std::vector<Point>& points = tolerance.series[0].points;
  CHECK(points.front().error > 1e3 * points.back().error);
  for (const Point& point : points) {
    CHECK(point.error < 100.0 * point.parameter * point.parameter + 1e-13);
  }
  CHECK(test::default_of(tolerance).error < 1e-13);

  const Chart& differences = test::chart_named(result, "reactions-differences");
  CHECK(test::falling_slope_of(differences.series[0]) == Approx(-2.0).margin(0.1));
  CHECK(test::falling_slope_of(differences.series[1]) == Approx(-4.0).margin(0.2));
}

}  // namespace

TEST_CASE("reactions of the sledge rig: methods, tolerances, and the same errors twice") {
  const TopicResult result = reactions(reference_scenes(), {true});
  check_reactions(result);
  CHECK(test::errors_of(reactions(reference_scenes(), {true})) == test::errors_of(result));
}

TEST_CASE("reactions of another shipped mechanism") {
  check_reactions(reactions(test::shipped_scene("four-bar-rocker/rocker.toml"), {true}));
}

}  // namespace reactions_test
