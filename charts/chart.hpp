#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Accuracy against cost: experiments on the program's own methods and on those that others use,
/// and where methods fail. Errors do not depend on the machine; times do.
namespace boxbeam::charts {

/// Time of one unit of a chart's work, of several measurements [s].
struct Timing {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< lower and upper quartile
};

/// One setting of a method and what it came to.
struct Point {
  std::string setting;               ///< "tolerance 1e-6", "8 parts"
  double parameter = 0.0;            ///< the number in it: what the series runs over
  std::optional<double> operations;  ///< how often the chart's unit of counting was done
  std::optional<Timing> time;        ///< of one unit of work
  double error = 0.0;                ///< against the chart's reference; not used where it failed
  std::string failure;               ///< why there is no result, "" where there is one
  bool is_default = false;           ///< what the program does unless it is told otherwise
};

/// One method over its settings, in their order.
struct Series {
  std::string method;  ///< "Newton, sparse order"
  std::vector<Point> points;
  bool yardstick = false;    ///< for comparison only: the program does not offer it
  bool other_scene = false;  ///< of another scene than the default: not weighed against it
};

/// A line of known order for the eye: error in proportion to operations^-order.
struct SlopeGuide {
  double order = 0.0;
  std::size_t series = 0;  ///< beside which it is drawn
};

/// A level of error with its name: "round-off", "digits of the case's data".
struct ErrorLevel {
  double error = 0.0;
  std::string name;
};

/// A work-precision diagram: error over work and over time, both logarithmic.
struct Chart {
  std::string name;        ///< of its files: "cut-forces-moment"
  std::string title;       ///< "Cut forces: largest moment"
  std::string scene;       ///< on what: "sledge-rig, one period of 1.4286 s"
  std::string error;       ///< what the ordinate is: "largest relative error of M along the beam"
  std::string reference;   ///< against what: "exact integrals, long double"
  std::string operations;  ///< unit of counting: "evaluations of the load"; "" where nothing counts
  /// Whether operations are what a result costs; else they are a circumstance, a frequency or a
  /// tolerance, in which all methods are alike.
  bool operations_cost = true;
  std::string unit;  ///< of work that is timed: "beam at one instant"
  std::vector<Series> series;
  std::vector<SlopeGuide> guides;
  /// Below this, errors are those of the arithmetic; drawn as a line.
  std::optional<ErrorLevel> floor;
  /// The accuracy that a strength check needs: errors inside or below are good enough.
  double needed_low = 1e-4, needed_high = 1e-3;
  std::string lesson;  ///< one or two sentences: what is seen, and what to choose
  /// Why the program takes its default where the chart shows better ones; "" where none is.
  std::string off_front;
};

/// The setting that is as the program does it; nullptr where a chart has none.
const Point* default_point(const Chart& chart);

/// How a trial of a map ended.
enum class Outcome {
  solved,
  wrong,    ///< silently: a result, but not the one that was asked for
  refused,  ///< no result, and the reason is said
};

const char* to_text(Outcome outcome);

/// One trial of a map.
struct Cell {
  double x = 0.0, y = 0.0;
  Outcome outcome = Outcome::solved;
  std::optional<double> value;  ///< of a solved one: the map's measure, "digits left"
  std::string reason;           ///< of a refusal
};

/// All trials of one method on the grid of a map, row by row of equal y, from the lowest; x
/// ascending in each.
struct MapPanel {
  std::string method;
  std::vector<Cell> cells;
  bool yardstick = false;  ///< for comparison only: the program does not offer it

  std::size_t count(Outcome outcome) const;
};

struct MapAxis {
  std::string title;  ///< with unit: "distance to the toggle [rad]"
  bool log = true;
};

/// Where methods solve, fail and refuse.
struct Map {
  std::string name;  ///< of its files: "stability-toggle"
  std::string title;
  std::string scene;
  std::string reference;  ///< how it is known what is right
  MapAxis x, y;
  std::string value;  ///< what `Cell::value` is, "" where there is none: "digits left"
  std::vector<MapPanel> panels;
  std::string lesson;
};

/// What one topic showed.
struct TopicResult {
  std::vector<Chart> charts;
  std::vector<Map> maps;
  /// Why the topic has nothing to say of the case: "the mechanism is a chain, explicit in space".
  std::string not_applicable;
};

}  // namespace boxbeam::charts
