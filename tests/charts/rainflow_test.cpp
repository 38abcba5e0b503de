#include <cmath>
#include <string>

#include "catch.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace rainflow_test {

using namespace boxbeam::charts;

TEST_CASE("chart rainflow: orders of classes, and that the program needs none", "[charts]") {
  const TopicResult result = rainflow(reference_scenes(), {true});
  REQUIRE(result.charts.size() == 4);
  const Chart& classes = result.charts[0];
  const Chart& histories = result.charts[1];
  const Chart& filter = result.charts[2];
  const Chart& stream = result.charts[3];

  for (const Chart* chart : {&classes, &filter, &stream}) {
    CAPTURE(chart->name);
    REQUIRE(default_point(*chart) != nullptr);
    // Cycle by cycle nothing is lost but round-off.
    CHECK(default_point(*chart)->error < chart->floor->error);
  }
  // By the upper edge every range is too large by half a class on average: order 1.
  const auto& edge = classes.series[2].points;
  CHECK(order_over_work(edge.front(), edge.back()) == Approx(1.0).margin(0.1));
  // By the middle, what is too large and too small cancels: order 2 of a history with as many
  // cycles in each class as a smooth density asks for.
  const auto& middle = histories.series[3].points;
  CHECK(order_over_work(middle.front(), middle.back()) == Approx(2.0).margin(0.3));
  for (std::size_t i = 0; i < edge.size(); ++i) {
    CHECK(classes.series[1].points[i].error < edge[i].error);
  }

  // The damage of what is left out: the less, the steeper the curve; nothing below the cut-off of
  // category 100, 0.4045 of it, which is 17 % of the largest range, for the smallest filters.
  for (std::size_t i = 0; i < filter.series[1].points.size(); ++i) {
    CHECK(filter.series[2].points[i].error < filter.series[1].points[i].error);
  }
  for (const Point& point : filter.series[3].points) {
    if (point.parameter <= 0.05) CHECK(point.error < filter.floor->error);
  }
  // However a history is cut, the cycles are the same.
  for (const std::size_t own : {0U, 1U, 3U}) {
    for (const Point& point : stream.series[own].points) CHECK(point.error < stream.floor->error);
  }
  // Counted apart, chunks lose their largest cycles: a fixed damage per cut.
  const auto& apart = stream.series[2].points;
  CHECK(order_over_work(apart[1], apart[2]) == Approx(1.0).margin(0.25));

  const TopicResult again = rainflow(reference_scenes(), {true});
  for (std::size_t c = 0; c < result.charts.size(); ++c) {
    for (std::size_t s = 0; s < result.charts[c].series.size(); ++s) {
      const auto& points = result.charts[c].series[s].points;
      for (std::size_t p = 0; p < points.size(); ++p) {
        CHECK(points[p].error == again.charts[c].series[s].points[p].error);
      }
    }
  }
}

}  // namespace rainflow_test
