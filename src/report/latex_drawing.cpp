#include "drawing_forms.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/latex_writer.hpp"

namespace boxbeam::plot {
namespace {

/// "#0b5fa5" as three parts of one.
std::string parts_of(const std::string& colour) {
  std::string out;
  for (const std::size_t at : {1U, 3U, 5U}) {
    out += fmt::format("{:.3g} ", std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0);
  }
  return out;
}

std::string numbers_of(const Pixel& place) {
  return fmt::format("{} {} ", pixels(place.x()), pixels(place.y()));
}

/// A circle as four curves.
std::string circle(const Dot& dot) {
  const double r = dot.radius;
  const double k = 0.5523 * r;  // of Bézier curves nearest to a quarter of a circle
  const Pixel& c = dot.at;
  const auto curve = [&](const Pixel& a, const Pixel& b, const Pixel& end) {
    return fmt::format("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c ", c.x() + a.x(), c.y() + a.y(),
                       c.x() + b.x(), c.y() + b.y(), c.x() + end.x(), c.y() + end.y());
  };
  return fmt::format("{:.2f} {:.2f} m\n", c.x() + r, c.y()) + curve({r, k}, {k, r}, {0, r}) +
         curve({-k, r}, {-r, k}, {-r, 0}) + curve({-r, -k}, {-k, -r}, {0, -r}) +
         curve({k, -r}, {r, -k}, {r, 0}) + "h\n";
}

/// Source: ISO 32000-1, 8.4.4, 8.5.2, 8.5.3.
std::string latex(const PenStroke& of) {
  const Pen& pen = of.pen;
  const bool filled = !pen.fill.empty();
  const bool stroked = !pen.stroke.empty();
  std::string out = "\\strokes{";
  if (filled) out += parts_of(pen.fill) + "rg ";
  if (stroked) {
    out += parts_of(pen.stroke) + fmt::format("RG {:.3g} w ", pen.width);
    std::string dashes;
    for (const double dash : pen.dashes) dashes += pixels(dash) + " ";
    out += fmt::format("[{}] 0 d\n", dashes);
  }
  for (const Line& line : of.lines) {
    const char* command = "m ";
    for (const Pixel& point : line.points) {
      out += numbers_of(point) + command;
      command = "l ";
    }
    if (line.points.size() == 1) out += numbers_of(line.points.front()) + "l ";
    out += line.closed ? "h\n" : "\n";
  }
  for (const Dot& dot : of.dots) out += circle(dot);
  return out + (filled && stroked ? "B" : filled ? "f" : "S") + "}\n";
}

std::string latex(const Words& of) {
  static constexpr char anchors[] = {'l', 'c', 'r'};
  std::string text;
  for (const Run& run : of.runs) {
    constexpr double usual = 12.0;
    // Spaces at its ends and in rows are kept.
    std::string kept;
    for (std::size_t at = 0; at <= run.text.size();) {
      const std::size_t end = std::min(run.text.find(' ', at), run.text.size());
      kept += (at == 0 ? "" : "~") + report::latex_escaped(run.text.substr(at, end - at));
      at = end + 1;
    }
    text += run.size == usual && run.rise == 0.0
                ? kept
                : fmt::format("\\run{{{}}}{{{}}}{{{}}}", pixels(run.rise), pixels(run.size), kept);
  }
  return fmt::format("\\words{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", pixels(of.at.x()),
                     pixels(of.at.y()), anchors[static_cast<int>(of.anchor)], of.colour.substr(1),
                     text);
}

}  // namespace

std::string latex_of(const Drawing& drawing) {
  std::string out = fmt::format("\\begin{{drawing}}{{{}}}{{{}}}\n", pixels(drawing.width),
                                pixels(drawing.height));
  for (const Mark& mark : in_few_strokes(drawing)) {
    out += std::visit([](const auto& of) { return latex(of); }, mark);
  }
  return out + "\\end{drawing}\n";
}

}  // namespace boxbeam::plot
