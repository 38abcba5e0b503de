#include <vector>

#include "boxbeam/report/files.hpp"
#include "charts/accuracy.hpp"
#include "charts/topics.hpp"
#include "peers/answers.hpp"

namespace peers {
namespace {

using namespace boxbeam;

charts::Point point_of(const Json& json) {
  charts::Point point;
  point.setting = json.at("setting");
  point.parameter = json.at("parameter");
  if (json.contains("operations")) point.operations = json.at("operations").get<double>();
  if (json.contains("time")) {
    const Json& time = json.at("time");
    point.time = charts::Timing{time.at(0), time.at(1), time.at(2)};
  }
  if (json.contains("error")) point.error = json.at("error");
  point.failure = json.value("failure", "");
  point.is_default = json.value("default", false);
  return point;
}

charts::Chart chart_of(const Json& json) {
  charts::Chart chart;
  chart.name = json.at("name");
  chart.title = json.at("title");
  chart.scene = json.at("scene");
  chart.error = json.at("error");
  chart.reference = json.at("reference");
  chart.operations = json.at("operations");
  chart.unit = json.at("unit");
  for (const Json& one : json.at("series")) {
    charts::Series series;
    series.method = one.at("method");
    series.yardstick = one.at("yardstick");
    for (const Json& point : one.at("points")) series.points.push_back(point_of(point));
    chart.series.push_back(series);
  }
  for (const Json& guide : json.at("guides")) {
    chart.guides.push_back({guide.at("order"), guide.at("series")});
  }
  if (json.contains("floor")) {
    const Json& floor = json.at("floor");
    chart.floor = charts::ErrorLevel{floor.at("error"), floor.at("name")};
  }
  chart.lesson = json.at("lesson");
  return chart;
}

charts::Map map_of(const Json& json) {
  charts::Map map;
  map.name = json.at("name");
  map.title = json.at("title");
  map.scene = json.at("scene");
  map.reference = json.at("reference");
  map.x = {json.at("x").at("title"), json.at("x").at("log")};
  map.y = {json.at("y").at("title"), json.at("y").at("log")};
  map.lesson = json.at("lesson");
  for (const Json& one : json.at("panels")) {
    charts::MapPanel panel;
    panel.method = one.at("method");
    panel.yardstick = one.at("yardstick");
    for (const Json& cell : one.at("cells")) {
      const std::string outcome = cell.at("outcome");
      panel.cells.push_back({cell.at("x"),
                             cell.at("y"),
                             outcome == "solved"  ? charts::Outcome::solved
                             : outcome == "wrong" ? charts::Outcome::wrong
                                                  : charts::Outcome::refused,
                             {},
                             cell.value("reason", "")});
    }
    map.panels.push_back(panel);
  }
  return map;
}

}  // namespace

void draw(const Json& shown, const std::string& folder) {
  const charts::Topic topic{"peers", "Other programs", nullptr};
  TopicShown peers{&topic, {}};
  for (const Json& chart : shown.at("charts")) peers.result.charts.push_back(chart_of(chart));
  for (const Json& map : shown.at("maps")) peers.result.maps.push_back(map_of(map));
  for (const charts::Chart& chart : peers.result.charts) {
    write_file(folder + "/" + chart.name + ".csv", chart_csv(chart));
  }
  for (const charts::Map& map : peers.result.maps) {
    write_file(folder + "/" + map.name + ".csv", map_csv(map));
  }
  draw_charts({peers}, folder);
}

}  // namespace peers
