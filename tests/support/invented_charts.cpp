#include "invented_charts.hpp"

#include <cmath>
#include <limits>

namespace test {

using boxbeam::charts::Cell;
using boxbeam::charts::Chart;
using boxbeam::charts::ErrorLevel;
using boxbeam::charts::Map;
using boxbeam::charts::MapPanel;
using boxbeam::charts::Outcome;
using boxbeam::charts::Point;
using boxbeam::charts::Series;
using boxbeam::charts::Timing;

namespace {

/// A point whose time grows with its work.
Point point_of(double work, double error) {
  Point point;
  point.setting = "n = " + std::to_string(static_cast<int>(work));
  point.parameter = work;
  point.operations = work;
  point.time = Timing{1e-8 * work, 0.9e-8 * work, 1.3e-8 * work};
  point.error = error;
  return point;
}

/// error = n^-order, n = 2, 4, 8, ...
Series series_of(const std::string& method, double order, int settings) {
  Series series{method, {}, false};
  for (int i = 1; i <= settings; ++i) {
    const double n = std::pow(2.0, i);
    series.points.push_back(point_of(n, std::pow(n, -order)));
  }
  return series;
}

/// What a shell, gnuplot's strings, its enhanced text, formats, XML, LaTeX or CSV would take apart.
constexpr const char* hostile =
    "a_b^c{x}@d&e~f, '; system('touch x') # `touch x` \"q\" 100 % %g \\n <b>&amp; $1 \\def "
    "\xC3\xB8";

}  // namespace

Chart invented_chart(std::string name) {
  Chart chart;
  chart.name = std::move(name);
  chart.title = "Integral of a polynomial";
  chart.scene = "a beam of three segments";
  chart.error = "largest relative error";
  chart.reference = "the antiderivative, long double";
  chart.operations = "evaluations";
  chart.unit = "integral";
  chart.series = {series_of("trapezoid", 2.0, 8), series_of("Simpson", 4.0, 8)};
  chart.series[0].yardstick = true;
  chart.series[1].points[4].is_default = true;
  chart.floor = ErrorLevel{1.1e-16, "round-off"};
  chart.lesson = "Simpson's rule converges with the fourth order.";
  return chart;
}

Chart crowded_chart() {
  Chart chart = invented_chart("crowded");
  chart.series.clear();
  chart.title +=
      ", by ten methods of which each has a name, and with a title that needs more than one line";
  for (int k = 0; k < 10; ++k) {
    Series series{
        "method " + std::to_string(k) + ", of order " + std::to_string(k % 5 + 1), {}, k >= 6};
    for (int i = 1; i <= 8; ++i) {
      Point point = point_of((10.0 + k) * i, std::pow(10.0, 3.0 - 0.3 * k - 0.5 * (k % 5 + 1) * i));
      if (k == 3 && i > 6) point.error = 0.0;
      if (k == 4 && i > 5) point.failure = "no convergence after 60 iterations";
      series.points.push_back(point);
    }
    chart.series.push_back(series);
  }
  chart.series[2].points[3].is_default = true;
  chart.guides = {{2.0, 1}, {3.0, 2}};
  return chart;
}

namespace {

Chart hostile_chart() {
  Chart chart = invented_chart("hostile");
  for (std::string* text :
       {&chart.title, &chart.scene, &chart.error, &chart.reference, &chart.operations, &chart.unit,
        &chart.lesson, &chart.floor->name, &chart.series[0].method, &chart.series[1].method,
        &chart.series[1].points[7].failure, &chart.series[1].points[7].setting})
    *text = hostile;
  return chart;
}

Chart failed_chart() {
  Chart chart = invented_chart("failed");
  for (Series& series : chart.series) {
    for (Point& point : series.points) {
      point.failure = "singular matrix at setting " + point.setting;
      point.time.reset();
    }
  }
  chart.series[0].points[0].operations.reset();
  return chart;
}

Chart single_chart() {
  Chart chart = invented_chart("single");
  chart.series.resize(1);
  chart.series[0].points.resize(1);
  chart.series[0].points[0].error = 0.0;
  return chart;
}

Chart untimed_chart() {
  Chart chart = invented_chart("untimed");
  for (Series& series : chart.series) {
    for (Point& point : series.points) point.time.reset();
  }
  return chart;
}

Chart uncounted_chart() {
  Chart chart = invented_chart("uncounted");
  chart.operations.clear();
  for (Series& series : chart.series) {
    for (Point& point : series.points) point.operations.reset();
  }
  return chart;
}

/// Neither work nor time; and numbers that no axis can hold.
Chart wide_chart() {
  Chart chart = uncounted_chart();
  chart.name = "wide";
  for (Point& point : chart.series[0].points) point.time.reset();
  chart.series[1].points = {point_of(0.0, 1e-18), point_of(1.0, 1e3), point_of(3.0, 1e300),
                            point_of(1e12, 5e-324), point_of(1e13, 1e-17)};
  chart.series[1].points[1].time = Timing{1e-9, 1e-9, 1e4};
  chart.series[1].points[4].error = std::numeric_limits<double>::quiet_NaN();
  return chart;
}

}  // namespace

std::vector<Chart> all_charts() {
  return {invented_chart("plain"), hostile_chart(), crowded_chart(),   failed_chart(),
          single_chart(),          untimed_chart(), uncounted_chart(), wide_chart()};
}

Map invented_map(std::string name, std::size_t panels) {
  Map map;
  map.name = std::move(name);
  map.title = "Assembly near a limit of the motion";
  map.scene = "a four-bar";
  map.reference = "closed form by circles";
  map.x = {"distance to the limit [rad]", true};
  map.y = {"error of the start [rad]", true};
  map.value = "digits left";
  map.lesson = "Nothing is silently wrong.";
  for (std::size_t p = 0; p < panels; ++p) {
    MapPanel panel{"method " + std::to_string(p), {}, p > 0};
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 12; ++i) {
        Cell cell{std::pow(10.0, -12 + i), std::pow(10.0, -6 + 0.5 * j), Outcome::solved, {}, ""};
        if (i < 2) {
          cell.outcome = Outcome::refused;
          cell.reason = "nearer than round-off";
        } else if (p > 0 && j > i) {
          cell.outcome = Outcome::wrong;
        } else {
          cell.value = 16.0 - i;
        }
        panel.cells.push_back(cell);
      }
    }
    map.panels.push_back(panel);
  }
  return map;
}

namespace {

Map hostile_map() {
  Map map = invented_map("hostile-map", 3);
  for (std::string* text : {&map.title, &map.scene, &map.reference, &map.x.title, &map.y.title,
                            &map.value, &map.panels[0].method, &map.panels[0].cells[0].reason})
    *text = hostile;
  return map;
}

Map plain_map() {
  Map map = invented_map("plain-map", 2);
  map.value.clear();
  map.x.log = false;
  // Zero is on a logarithmic axis that says it is none.
  for (MapPanel& panel : map.panels) {
    for (Cell& cell : panel.cells) cell.y -= 1e-6;
  }
  return map;
}

}  // namespace

std::vector<Map> all_maps() {
  return {invented_map("one-panel", 1), invented_map("four-panels", 4), hostile_map(), plain_map()};
}

}  // namespace test
