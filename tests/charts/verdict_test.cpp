// Whole verifications by every model against the finest one that the program computes.

#include <algorithm>
#include <string>

#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "charts/topics.hpp"
#include "support/program.hpp"

namespace verdict_test {

using namespace boxbeam;
using charts::Chart;
using charts::Point;
using charts::Series;

namespace {

charts::TopicResult charted(const std::string& file, double tolerance = 0.0) {
  Project project = read_project(test::project_file("sections/" + file));
  if (tolerance > 0.0) project.model.tolerance = tolerance;
  charts::Effort effort;
  effort.quick = effort.once = true;
  return charts::verdict(charts::scenes_of(std::move(project)), effort);
}

const Series& series_of(const Chart& chart, const std::string& method) {
  const auto found = std::find_if(chart.series.begin(), chart.series.end(),
                                  [&](const Series& series) { return series.method == method; });
  REQUIRE(found != chart.series.end());
  return *found;
}

}  // namespace

TEST_CASE("whatever moves or carries a beam: what is chosen is within the tolerance", "[charts]") {
  const std::string file =
      GENERATE("sledge-rig/rig.toml", "sledge-rig/slender.toml", "four-bar-rocker/rocker.toml",
               "stewart-rig/rig.toml", "excavator-boom/boom.toml", "drill-truck/truck.toml");
  INFO(file);
  const charts::TopicResult result = charted(file);
  CHECK(result.not_applicable.empty());
  REQUIRE(result.charts.size() == 1);
  // The reference is surer than what is measured by it.
  CHECK(result.charts.front().floor->error <= 1e-3);
  const Point* const chosen = charts::default_point(result.charts.front());
  REQUIRE(chosen != nullptr);
  CHECK(chosen->failure.empty());
  CHECK(chosen->error <= 0.01);
}

TEST_CASE("where a beam vibrates, more modes are closer and rigid bodies are not", "[charts]") {
  const Chart chart = charted("stewart-rig/rig.toml").charts.at(0);
  const Point& rigid = series_of(chart, "rigid bodies, not estimated").points.at(0);
  const Series& modes = series_of(chart, "so many modes, not estimated");
  REQUIRE(modes.points.size() == 2);
  CHECK(modes.yardstick);
  CHECK(modes.points[1].error < modes.points[0].error);
  CHECK(modes.points[0].error < rigid.error);
  CHECK(rigid.error > 0.01);
}

TEST_CASE("a tolerance of a case's own is the one that is ringed", "[charts]") {
  const Chart chart = charted("sledge-rig/slender.toml", 0.04).charts.at(0);
  CHECK(charts::default_point(chart)->setting == "4 %");
  CHECK(chart.needed_high == 0.04);
}

TEST_CASE("a case that has rigid bodies only says why there is nothing to compare", "[charts]") {
  const charts::TopicResult rubbing = charted("sledge-rig/friction.toml");
  CHECK(rubbing.charts.empty());
  CHECK_THAT(rubbing.not_applicable, Catch::Contains("dry friction in joint rail"));
  const charts::TopicResult published = charted("sledge-rig/published.toml");
  CHECK(published.charts.empty());
  CHECK_THAT(published.not_applicable, Catch::Contains("Newton chain"));
}

}  // namespace verdict_test
