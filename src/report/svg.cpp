#include "drawing_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "html_text.hpp"

namespace boxbeam::plot {
namespace {

using report::html::escaped;

long tenths(double value) { return std::lround(10.0 * value); }

std::string number(long tenths) {
  const long whole = std::abs(tenths) / 10;
  const long rest = std::abs(tenths) % 10;
  std::string out = tenths < 0 ? "-" : "";
  if (whole != 0 || rest == 0) out += std::to_string(whole);
  if (rest != 0) out += fmt::format(".{}", rest);
  return out;
}

/// Numbers one behind the other, with a space where they would be one.
void append(std::string& out, long tenths) {
  const std::string text = number(tenths);
  const char last = out.empty() ? 'M' : out.back();
  if (text[0] != '-' && (last == '.' || (last >= '0' && last <= '9'))) out += ' ';
  out += text;
}

/// Paths, one behind the other; y upwards in a picture so high.
class Data {
 public:
  explicit Data(double height) : height_(height) {}

  void add(const Line& line) {
    bool first = true;
    for (const Pixel& point : line.points) {
      const long x = tenths(point.x());
      const long y = tenths(height_ - point.y());
      if (first)
        begin(x, y);
      else
        go(x, y);
      first = false;
    }
    if (line.closed) {
      out_ += 'z';
      command_ = 'z';
    } else if (line.points.size() == 1) {
      out_ += "h0";
      command_ = 'h';
    }
  }
  const std::string& text() const { return out_; }

 private:
  void begin(long x, long y) {
    out_ += 'M';
    append(out_, x);
    append(out_, y);
    x_ = x;
    y_ = y;
    command_ = 'M';
  }
  void go(long x, long y) {
    const long dx = x - x_;
    const long dy = y - y_;
    if (dx == 0 && dy == 0) return;
    const char command = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
    if (command != command_) out_ += command;
    command_ = command;
    if (command != 'v') append(out_, dx);
    if (command != 'h') append(out_, dy);
    x_ = x;
    y_ = y;
  }

  double height_;
  std::string out_;
  char command_ = ' ';
  long x_ = 0, y_ = 0;
};

std::string short_colour(const std::string& colour) {
  const bool doubled = colour.size() == 7 && colour[1] == colour[2] && colour[3] == colour[4] &&
                       colour[5] == colour[6];
  return doubled ? fmt::format("#{}{}{}", colour[1], colour[3], colour[5]) : colour;
}

std::string paint(const Pen& pen) {
  std::string out;
  if (!pen.fill.empty()) out += fmt::format(" fill=\"{}\"", short_colour(pen.fill));
  if (pen.stroke.empty()) return out;
  out += fmt::format(" stroke=\"{}\"", short_colour(pen.stroke));
  if (pen.width != 1.0) out += fmt::format(" stroke-width=\"{:.3g}\"", pen.width);
  std::string dashes;
  for (const double dash : pen.dashes) append(dashes, tenths(dash));
  return dashes.empty() ? out : out + fmt::format(" stroke-dasharray=\"{}\"", dashes);
}

class Writer {
 public:
  Writer(double height, bool by_kind) : height_(height), by_kind_(by_kind) {}

  void write(const PenStroke& of) {
    const std::string look = by_kind_ ? fmt::format(" class=\"{}\"", of.pen.kind) : paint(of.pen);
    Data data(height_);
    for (const Line& line : of.lines) data.add(line);
    if (!data.text().empty()) out_ += fmt::format("<path{} d=\"{}\"/>\n", look, data.text());
    for (const Dot& dot : of.dots) {
      out_ += fmt::format("<circle{} cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", look, pixels(dot.at.x()),
                          pixels(height_ - dot.at.y()), pixels(dot.radius));
    }
  }

  void write(const Words& of) {
    static constexpr const char* anchors[] = {"", " text-anchor=\"middle\"",
                                              " text-anchor=\"end\""};
    const bool spaced = std::any_of(of.runs.begin(), of.runs.end(), [](const Run& run) {
      return run.text.find("  ") != std::string::npos;
    });
    out_ += fmt::format("<text x=\"{}\" y=\"{}\"{}{}{}>", pixels(of.at.x()),
                        pixels(height_ - of.at.y()), anchors[static_cast<int>(of.anchor)],
                        by_kind_ ? of.kind.empty() ? "" : fmt::format(" class=\"{}\"", of.kind)
                                 : fmt::format(" fill=\"{}\"", short_colour(of.colour)),
                        spaced ? " xml:space=\"preserve\"" : "");
    double rise = 0.0;
    for (const Run& run : of.runs) {
      constexpr double usual = 12.0;
      if (run.size == usual && run.rise == rise) {
        out_ += escaped(run.text);
        continue;
      }
      out_ += fmt::format("<tspan dy=\"{}\" font-size=\"{}\">{}</tspan>", pixels(rise - run.rise),
                          pixels(run.size), escaped(run.text));
      rise = run.rise;
    }
    out_ += "</text>\n";
  }

  std::string take() { return std::move(out_); }

 private:
  double height_;
  bool by_kind_;
  std::string out_;
};

std::string content_of(const Drawing& drawing, bool by_kind) {
  Writer writer(drawing.height, by_kind);
  for (const Mark& mark : in_few_strokes(drawing)) {
    std::visit([&](const auto& of) { writer.write(of); }, mark);
  }
  return writer.take();
}

}  // namespace

std::string pixels(double value) { return number(tenths(value)); }

std::string svg_of(const Drawing& drawing) {
  const std::string width = pixels(drawing.width);
  const std::string height = pixels(drawing.height);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" fill=\"none\" "
             "stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"DejaVu "
             "Sans,sans-serif\" font-size=\"12\">\n"
             "<path fill=\"#fff\" d=\"M0 0h{0}v{1}h-{0}z\"/>\n",
             width, height) +
         content_of(drawing, false) + "</svg>\n";
}

std::string svg_in_page(const Drawing& drawing, const std::string& attributes) {
  return fmt::format("<svg {} viewBox=\"0 0 {} {}\">\n", attributes, pixels(drawing.width),
                     pixels(drawing.height)) +
         content_of(drawing, true) + "</svg>\n";
}

}  // namespace boxbeam::plot
