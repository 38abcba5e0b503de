#include "svg_posture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "boxbeam/report/format.hpp"
#include "html_text.hpp"

namespace boxbeam::report::html {
namespace {

constexpr double width = 640.0;     // of the drawing, its units
constexpr double margin = 30.0;     // free at every side
constexpr double reach = 0.28;      // longest arrow, part of the mechanism's size
constexpr double head = 10.0;       // length of an arrow's head
constexpr double ring = 15.0;       // radius of a couple's arrow
constexpr double letter = 7.0;      // width of one, roughly
constexpr double line_high = 15.0;  // of text

using Point = Eigen::Vector2d;

/// Every place of a posture that the drawing must hold.
void each_place(const PostureFigure& posture,
                const std::function<void(const Eigen::Vector3d&)>& take) {
  for (const auto& body : posture.bodies) {
    for (const Eigen::Vector3d& point : body.points) take(point);
    for (const auto& stroke : body.strokes) {
      take(stroke.from);
      take(stroke.to);
    }
  }
  for (const auto& rod : posture.rods) {
    take(rod.from);
    take(rod.to);
  }
  for (const Eigen::Vector3d& ground : posture.grounds) take(ground);
}

/// The world on the drawing.
struct Sheet {
  Eigen::Matrix<double, 2, 3> view;
  Point low = Point::Constant(1e300), high = Point::Constant(-1e300);  ///< [m]
  double metres_per_newton = 0.0;
  double least_couple = 0.0;  ///< that is drawn [N m]
  double guide = 0.0;         ///< half of what is shown of a line [m]
  double scale = 1.0;         ///< per m
  double height = 0.0;

  /// Towards the viewer: couples about it turn counter-clockwise.
  Eigen::Vector3d normal() const {
    return Eigen::Vector3d(view.row(0)).cross(Eigen::Vector3d(view.row(1)));
  }

  Point at(const Eigen::Vector3d& place) const {
    const Point p = view * place;
    const Point middle = 0.5 * (low + high);
    return {0.5 * width + scale * (p.x() - middle.x()),
            0.5 * height - scale * (p.y() - middle.y())};
  }
};

Sheet sheet_for(const CycleFigure& cycle) {
  Sheet sheet;
  sheet.view = view_of(is_in_space(cycle));
  const auto take = [&](const Eigen::Vector3d& place) {
    sheet.low = sheet.low.cwiseMin(sheet.view * place);
    sheet.high = sheet.high.cwiseMax(sheet.view * place);
  };
  double largest = 0.0;
  double largest_couple = 0.0;
  for (const CycleFrame& frame : cycle.frames) {
    each_place(frame.posture, take);
    for (const BeamLoadRow& load : frame.posture.loads) {
      largest = std::max(largest, load.world.norm());
      largest_couple = std::max(largest_couple, load.couple.norm());
    }
  }
  const double size = std::max((sheet.high - sheet.low).maxCoeff(), 1e-9);
  if (largest > 0.0) sheet.metres_per_newton = reach * size / largest;
  // What rounding leaves of lever arms is no couple.
  sheet.least_couple = std::max(0.02 * largest_couple, 1e-6 * largest * size);
  sheet.guide = 0.12 * size;
  for (const CycleFrame& frame : cycle.frames) {
    for (const BeamLoadRow& load : frame.posture.loads) {
      take(load.place - sheet.metres_per_newton * load.world);
    }
  }
  const Point extent = (sheet.high - sheet.low).cwiseMax(1e-3 * size);
  sheet.height =
      std::clamp((width - 2 * margin) * extent.y() / extent.x() + 2 * margin, 200.0, 480.0);
  sheet.scale =
      std::min((width - 2 * margin) / extent.x(), (sheet.height - 2 * margin) / extent.y());
  return sheet;
}

std::string line(const char* style, const Point& from, const Point& to) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style,
      from.x(), from.y(), to.x(), to.y());
}

std::string circle(const char* style, const Point& at, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", style, at.x(),
                     at.y(), radius);
}

std::string body(const Sheet& sheet, const PostureFigure::Line& of) {
  const char* style = of.beam ? "beam" : "body";
  std::string out;
  for (const auto& stroke : of.strokes) {
    out += line(style, sheet.at(stroke.from), sheet.at(stroke.to));
  }
  if (of.points.size() == 1) {
    const Point at = sheet.at(of.points.front());
    return out + fmt::format(
                     "<rect class=\"block\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" "
                     "height=\"14\"/>\n",
                     at.x() - 7.0, at.y() - 7.0);
  }
  for (std::size_t k = 1; of.strokes.empty() && k < of.points.size(); ++k) {
    out += line(style, sheet.at(of.points[k - 1]), sheet.at(of.points[k]));
  }
  for (const Eigen::Vector3d& point : of.points) out += circle("joint", sheet.at(point), 3.5);
  return out;
}

std::string ground(const Point& at) {
  return fmt::format("<path class=\"ground\" d=\"M{0:.1f} {1:.1f}l-8 13h16z\"/>\n", at.x(), at.y());
}

std::string arrow_head(const Point& tip, const Point& along, double size) {
  const Point across(-along.y(), along.x());
  const Point left = tip - size * along + 0.35 * size * across;
  const Point right = tip - size * along - 0.35 * size * across;
  return fmt::format("<path class=\"head\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\"/>\n",
                     tip.x(), tip.y(), left.x(), left.y(), right.x(), right.y());
}

/// Three quarters of a circle about a place with a head at its end, open below.
std::string couple_arrow(const Point& at, bool counter_clockwise) {
  constexpr double half = 0.70711;  // of both ends, 45 deg below the place
  const double side = counter_clockwise ? -1.0 : 1.0;
  const Point end = at + ring * Point(side * half, half);
  const Point begin = at + ring * Point(-side * half, half);
  const Point along(-side * half, half);
  return fmt::format("<path class=\"couple\" d=\"M{:.1f} {:.1f}A{} {} 0 1 {} {:.1f} {:.1f}\"/>\n",
                     begin.x(), begin.y(), ring, ring, counter_clockwise ? 0 : 1, end.x(),
                     end.y()) +
         arrow_head(end + 0.5 * head * along, along, head);
}

/// Where the words of a load stand so that they neither leave the drawing nor hit others, as far as
/// there is room.
Point place_of_words(const Sheet& sheet, Point at, double half, std::vector<Point>& labels) {
  at.x() = std::clamp(at.x(), std::min(half + 4.0, 0.5 * width),
                      std::max(width - half - 4.0, 0.5 * width));
  at.y() = std::clamp(at.y(), line_high, sheet.height - 4.0);
  const auto taken = [&](const Point& other) {
    return std::abs(other.x() - at.x()) < 2.0 * half && std::abs(other.y() - at.y()) < line_high;
  };
  const auto crowded = [&] { return std::any_of(labels.begin(), labels.end(), taken); };
  while (crowded() && at.y() > 2.0 * line_high) at.y() -= line_high;
  while (crowded() && at.y() < sheet.height - line_high) at.y() += line_high;
  labels.push_back(at);
  return at;
}

std::string load(const Sheet& sheet, const BeamLoadRow& of, std::vector<Point>& labels) {
  const Point tip = sheet.at(of.place);
  const Point tail = sheet.at(of.place - sheet.metres_per_newton * of.world);
  const double length = (tip - tail).norm();
  const double couple = sheet.normal().dot(of.couple);
  const bool pushes = length >= 3.0;
  const bool turns = std::abs(couple) > sheet.least_couple;
  if (!pushes && !turns) return "";
  std::string words =
      of.name.empty() ? fmt::format("s = {} m", text::significant(of.s.value(), 3)) : of.name;
  if (pushes) words += "  " + text::kN(of.world.norm());
  if (turns) words += (pushes ? ", " : "  ") + text::kNm(std::abs(couple));
  std::string out;
  Point beside = tip - Point(0.0, ring + 9.0);
  if (pushes) {
    const Point along = (tip - tail) / length;
    const double size = std::min(head, length);
    out += line("load", tail, tip - 0.8 * size * along) + arrow_head(tip, along, size);
    beside = tail - 12.0 * along + Point(0.0, 4.0);
  }
  if (turns) out += couple_arrow(tip, couple > 0.0);
  const double half = 0.5 * letter * static_cast<double>(words.size());
  const Point at = place_of_words(sheet, beside, half, labels);
  return out + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                           at.x(), at.y(), escaped(words));
}

}  // namespace

bool is_in_space(const CycleFigure& cycle) {
  double flat = 0.0;
  double deep = 0.0;
  for (const CycleFrame& frame : cycle.frames) {
    each_place(frame.posture, [&](const Eigen::Vector3d& place) {
      flat = std::max(flat, place.head<2>().cwiseAbs().maxCoeff());
      deep = std::max(deep, std::abs(place.z()));
    });
  }
  return deep > 1e-9 * flat;
}

Eigen::Matrix<double, 2, 3> view_of(bool in_space) {
  Eigen::Matrix<double, 2, 3> view;
  if (in_space) {
    // Seen from the front (-y), 30 deg to the right and 25 deg above.
    view << 0.8660, 0.5000, 0.0000,  //
        -0.2113, 0.3660, 0.9063;
  } else {
    view << 1.0, 0.0, 0.0,  //
        0.0, 1.0, 0.0;
  }
  return view;
}

std::string posture_svg(const CycleFigure& cycle, std::size_t frame, const std::string& label) {
  const Sheet sheet = sheet_for(cycle);
  const PostureFigure& posture = cycle.frames[frame].posture;
  std::string out = fmt::format(
      "<svg class=\"mechanism\" viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n", width,
      sheet.height, escaped(label));
  for (const auto& guide : posture.guides) {
    out += line("guide", sheet.at(guide.from - sheet.guide * guide.to),
                sheet.at(guide.from + sheet.guide * guide.to));
  }
  for (const Eigen::Vector3d& place : posture.grounds) out += ground(sheet.at(place));
  for (const auto& rod : posture.rods) {
    out += line("rod", sheet.at(rod.from), sheet.at(rod.to));
  }
  for (const bool front : {false, true}) {  // the beam in front of the others
    for (const auto& of : posture.bodies) {
      if (of.beam == front) out += body(sheet, of);
    }
  }
  std::vector<Point> labels;
  for (const BeamLoadRow& of : posture.loads) out += load(sheet, of, labels);
  return out + "</svg>\n";
}

}  // namespace boxbeam::report::html
