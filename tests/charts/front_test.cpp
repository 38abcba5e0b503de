// The default of every chart against all other settings of the chart, by counted work.

#include "charts/front.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "charts/topics.hpp"
#include "support/program.hpp"

namespace front_test {

using namespace boxbeam;
using charts::Chart;
using charts::CostBy;
using charts::Point;

namespace {

Chart two_methods() {
  Chart chart;
  chart.series = {{"ours", {}}, {"other", {}, true}};
  Point own;
  own.setting = "own";
  own.operations = 100.0;
  own.error = 1e-3;
  own.is_default = true;
  chart.series[0].points = {own};
  return chart;
}

std::size_t better_than_own(double operations, double error) {
  Chart chart = two_methods();
  Point point;
  point.operations = operations;
  point.error = error;
  chart.series[1].points = {point};
  return charts::better_than_default(chart).size();
}

/// Every chart of every topic, on the cases that `boxbeam chart` takes by itself.
const std::map<std::string, Chart>& all_charts() {
  static const std::map<std::string, Chart> all = [] {
    std::map<std::string, Chart> found;
    charts::Scenes scenes =
        charts::scenes_of(read_project(test::project_file("sections/sledge-rig/rig.toml")));
    const charts::Scenes truck =
        charts::scenes_of(read_project(test::project_file("sections/drill-truck/truck.toml")));
    scenes.flexible = truck.flexible;
    charts::Effort effort;
    effort.quick = effort.once = true;  // work is counted here, not timed
    for (const charts::Topic& topic : charts::topics()) {
      if (std::string(topic.name) == "stability") continue;  // maps only
      for (Chart& chart : topic.run(scenes, effort).charts) found[chart.name] = std::move(chart);
    }
    return found;
  }();
  return all;
}

}  // namespace

TEST_CASE("a setting is better that costs or errs less than two thirds", "[front]") {
  CHECK(better_than_own(60.0, 1e-3) == 1);
  CHECK(better_than_own(70.0, 1e-3) == 0);
  CHECK(better_than_own(60.0, 1.1e-3) == 0);
  CHECK(better_than_own(100.0, 0.6e-3) == 1);
  CHECK(better_than_own(100.0, 0.7e-3) == 0);
  CHECK(better_than_own(101.0, 0.1e-3) == 0);
  CHECK(better_than_own(60.0, -0.9e-3) == 1);
}

TEST_CASE("what failed, what is of another scene or not counted beats no default", "[front]") {
  Chart chart = two_methods();
  Point point;
  point.operations = 1.0;
  point.error = 1e-9;
  chart.series[1].points = {point};
  REQUIRE(charts::better_than_default(chart).size() == 1);
  CHECK(charts::better_than_default(chart).front().series == &chart.series[1]);
  CHECK(charts::better_than_default(chart, CostBy::time).empty());
  Chart failed = chart;
  failed.series[1].points[0].failure = "singular";
  CHECK(charts::better_than_default(failed).empty());
  Chart other = chart;
  other.series[1].other_scene = true;
  CHECK(charts::better_than_default(other).empty());
  Chart circumstance = chart;
  circumstance.operations_cost = false;
  CHECK(charts::better_than_default(circumstance).empty());
  circumstance.series[0].points[0].time = circumstance.series[1].points[0].time =
      charts::Timing{2e-6, 2e-6, 2e-6};
  CHECK(charts::better_than_default(circumstance).empty());
  circumstance.series[1].points[0].operations = 100.0;
  CHECK(charts::better_than_default(circumstance).size() == 1);
  Chart alike = chart;
  alike.floor = {1e-2, "what the case is known to"};
  alike.series[1].points[0].operations = 90.0;
  CHECK(charts::better_than_default(alike).empty());
}

TEST_CASE("by time a default is weighed where work is not counted", "[front]") {
  Chart chart = two_methods();
  chart.series[0].points[0].operations.reset();
  chart.series[0].points[0].time = charts::Timing{3e-6, 3e-6, 3e-6};
  Point point;
  point.time = charts::Timing{1e-6, 1e-6, 1e-6};
  point.error = 1e-3;
  chart.series[1].points = {point};
  CHECK(charts::better_than_default(chart).size() == 1);
  chart.series[1].points[0].time->median = 2.5e-6;
  CHECK(charts::better_than_default(chart).empty());
}

TEST_CASE("every default lies on the front of its chart, or the chart says why not",
          "[front][unsanitized]") {
  // Where no work is counted for the program itself, time alone tells: not here.
  const std::set<std::string> not_counted = {"kinematics-positions",     "kinematics-velocities",
                                             "kinematics-accelerations", "reactions-balance",
                                             "reactions-methods",        "reactions-tolerance"};
  std::size_t weighed = 0;
  for (const auto& [name, chart] : all_charts()) {
    CAPTURE(name);
    const Point* const own = default_point(chart);
    if (own == nullptr || !chart.operations_cost || chart.operations.empty()) continue;
    if (!own->operations) {
      CHECK(not_counted.count(name) == 1);
      continue;
    }
    ++weighed;
    for (const charts::Better& better : charts::better_than_default(chart, CostBy::operations)) {
      INFO(fmt::format("{}, {}: {} for {}, the default {} for {}", better.series->method,
                       better.point->setting, better.point->error, *better.point->operations,
                       own->error, *own->operations));
      CHECK(!chart.off_front.empty());
    }
  }
  CHECK(weighed >= 20);
}

}  // namespace front_test
