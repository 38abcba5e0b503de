#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

/// A picture as a value: lines, dots and words in pixels, x to the right and y up from its lower
/// left corner. What draws, gnuplot or this program, ends in one; what shows it begins with one.
namespace boxbeam::plot {

using Pixel = Eigen::Vector2d;

/// How a shape is painted; colours are "#rrggbb", "" where nothing is.
struct Pen {
  std::string stroke = {};
  double width = 1.0;
  std::vector<double> dashes = {};
  std::string fill = {};
  std::string kind = {};  ///< its class in a page that has a style for it

  bool operator==(const Pen&) const = default;
};

struct Line {
  std::vector<Pixel> points;
  Pen pen;
  bool closed = false;
};

/// A circle.
struct Dot {
  Pixel at;
  double radius = 1.0;
  Pen pen;
};

enum class Anchor { left, middle, right };

/// Letters of one size on one height; indices are smaller and lower.
struct Run {
  std::string text;
  double size = 12.0;
  double rise = 0.0;
};

struct Words {
  std::vector<Run> runs;
  Pixel at;  ///< on the line on which the letters stand
  Anchor anchor = Anchor::left;
  std::string colour = "#202020";
  std::string kind = {};
};

using Shape = std::variant<Line, Dot, Words>;

struct Drawing {
  double width = 0.0, height = 0.0;
  std::vector<Shape> shapes;
};

/// Lines and dots that one pen paints in one go, or words.
struct PenStroke {
  Pen pen;
  std::vector<Line> lines;
  std::vector<Dot> dots;
};
using Mark = std::variant<PenStroke, Words>;

/// What is drawn, in an order that shows the same: each shape with others of its pen where nothing
/// between them touches it, lines without the points that no eye would miss.
std::vector<Mark> in_few_strokes(const Drawing& drawing);

/// A line without the points that lie so near to the line without them.
/// Source: Douglas and Peucker (1973).
std::vector<Pixel> simplified(const std::vector<Pixel>& points, double tolerance);

}  // namespace boxbeam::plot
