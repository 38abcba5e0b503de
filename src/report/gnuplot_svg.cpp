#include "drawing_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "boxbeam/core/error.hpp"

namespace boxbeam::plot {
namespace {

/// One tag, with the text behind it.
struct Tag {
  std::string_view name;  ///< "/g" where it ends an element
  std::map<std::string_view, std::string_view> attributes;
  std::string_view text;

  std::string_view operator[](std::string_view attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? std::string_view() : found->second;
  }
};

class Tags {
 public:
  explicit Tags(std::string_view rest) : rest_(rest) {}

  /// False behind the last.
  bool next(Tag& tag) {
    const std::size_t begin = rest_.find('<');
    if (begin == std::string_view::npos) return false;
    // No attribute of gnuplot's holds ">".
    const std::size_t end = std::min(rest_.find('>', begin), rest_.size() - 1);
    std::string_view inside = rest_.substr(begin + 1, end - begin - 1);
    rest_.remove_prefix(end + 1);
    tag = {};
    const std::size_t name = std::min(inside.find_first_of(" \n\t/", 1), inside.size());
    tag.name = inside.substr(0, name);
    for (inside.remove_prefix(name);;) {
      const std::size_t from = inside.find_first_not_of(" \n\t/");
      const std::size_t equals = inside.find('=');
      if (from == std::string_view::npos || equals == std::string_view::npos) break;
      const std::size_t open = inside.find_first_of("'\"", equals);
      if (open == std::string_view::npos) break;
      const std::size_t close = std::min(inside.find(inside[open], open + 1), inside.size());
      const std::size_t last = inside.find_last_not_of(' ', equals - 1);
      tag.attributes[inside.substr(from, last + 1 - from)] =
          inside.substr(open + 1, close - open - 1);
      inside.remove_prefix(std::min(close + 1, inside.size()));
    }
    tag.text = rest_.substr(0, rest_.find('<'));
    return true;
  }

 private:
  std::string_view rest_;
};

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t at = text.find_first_of("0123456789.-");
    if (at == std::string_view::npos) return numbers;
    text.remove_prefix(at);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc()) numbers.push_back(number);
    text.remove_prefix(std::max<std::size_t>(1, static_cast<std::size_t>(end - text.data())));
  }
}

std::string unescaped(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string out;
  while (!text.empty()) {
    std::size_t length = 1;
    char sign = text.front();
    for (const auto& [entity, meant] : entities) {
      if (!text.starts_with(entity)) continue;
      length = entity.size();
      sign = meant;
    }
    out += sign;
    text.remove_prefix(length);
  }
  return out;
}

/// A place in the shape of a mark, in halves of its size, y down.
using Corner = std::array<double, 2>;

/// A kind of mark, as gnuplot's terminal numbers them.
struct MarkShape {
  std::vector<std::vector<Corner>> lines;
  bool filled = false;
  bool round = false;
};

MarkShape turned(MarkShape shape, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0);
  const double s = std::sin(degrees * std::numbers::pi / 180.0);
  for (auto& line : shape.lines) {
    for (Corner& at : line) at = {c * at[0] - s * at[1], s * at[0] + c * at[1]};
  }
  return shape;
}

/// Source: what gnuplot writes into <defs>; each second is the first, filled.
MarkShape mark_shape(int number) {
  static const MarkShape square{{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}};
  static const MarkShape triangle{{{{0, -1.33}, {-1.33, 0.67}, {1.33, 0.67}}}};
  static const MarkShape pentagon{
      {{{0, 1.33}, {1.265, 0.411}, {0.782, -1.067}, {-0.782, -1.076}, {-1.265, 0.411}}}};
  const std::vector<std::vector<Corner>> plus{{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}};
  const std::vector<std::vector<Corner>> times{{{-1, -1}, {1, 1}}, {{1, -1}, {-1, 1}}};
  switch (number) {
    case 0: return {plus};
    case 1: return {times};
    case 2: return {{plus[0], plus[1], times[0], times[1]}};
    default: break;
  }
  MarkShape shape = number < 5    ? square
                    : number < 7  ? MarkShape{{}, false, true}
                    : number < 9  ? triangle
                    : number < 11 ? turned(triangle, 180.0)
                    : number < 13 ? turned(square, 45.0)
                                  : pentagon;
  shape.filled = number % 2 == 0;
  return shape;
}

/// What holds inside a group.
struct Group {
  std::string colour = "#000000";  ///< that "currentColor" means
  std::string stroke = "#000000";
  double width = 1.0;
  std::string fill = {};
  double x = 0.0, y = 0.0;  ///< of its words
  double size = 12.0;
  Anchor anchor = Anchor::left;
};

class Reader {
 public:
  Drawing read(const std::string& svg) {
    Tags tags(svg);
    bool defining = false;
    for (Tag tag; tags.next(tag);) {
      if (tag.name == "defs" || tag.name == "/defs") defining = tag.name == "defs";
      if (!defining) take(tag);
    }
    return std::move(drawing_);
  }

 private:
  void take(const Tag& tag) {
    static constexpr std::array<std::string_view, 11> no_shapes{
        "?xml", "/defs", "title", "/title", "desc", "/desc",
        "rect", "/svg",  "tspan", "/tspan", "!--"};
    if (tag.name == "svg") {
      const std::vector<double> box = numbers_in(tag["viewBox"]);
      if (box.size() != 4) throw OutputError("a figure of gnuplot without a size");
      drawing_.width = box[2];
      drawing_.height = box[3];
    } else if (tag.name == "g") {
      groups_.push_back(group_of(tag));
    } else if (tag.name == "/g") {
      if (groups_.size() > 1) groups_.pop_back();
    } else if (tag.name == "path") {
      path(tag);
    } else if (tag.name == "polygon") {
      const std::vector<double> at = numbers_in(tag["points"]);
      Line area{{}, {"", 1.0, {}, colour_of(tag["fill"]), ""}, true};
      for (std::size_t i = 1; i < at.size(); i += 2) area.points.push_back(place(at[i - 1], at[i]));
      drawing_.shapes.emplace_back(std::move(area));
    } else if (tag.name == "use") {
      mark(tag);
    } else if (tag.name == "text") {
      words(tag.text);
    } else if (tag.name == "/text") {
      end_words();
    } else if (std::find(no_shapes.begin(), no_shapes.end(), tag.name) == no_shapes.end()) {
      throw OutputError(
          fmt::format("a figure of gnuplot holds <{}>, which is not known here", tag.name));
    }
    if (tag.name == "tspan") run(tag);
  }

  Pixel place(double x, double y) const { return {x, drawing_.height - y}; }

  std::string colour_of(std::string_view text) const {
    if (text == "currentColor") return groups_.back().colour;
    if (text == "none" || text == "black") return text == "none" ? "" : "#000000";
    if (!text.starts_with("rgb")) return std::string(text);
    const std::vector<double> parts = numbers_in(text);
    std::string out = "#";
    for (const double part : parts) out += fmt::format("{:02x}", static_cast<int>(part));
    return out;
  }

  Group group_of(const Tag& tag) const {
    Group group = groups_.back();
    if (const auto colour = tag["color"]; !colour.empty()) group.colour = colour_of(colour);
    if (const auto stroke = tag["stroke"]; !stroke.empty()) {
      group.stroke = stroke == "currentColor" ? group.colour : colour_of(stroke);
    }
    if (const auto width = numbers_in(tag["stroke-width"]); !width.empty()) group.width = width[0];
    if (const auto at = numbers_in(tag["transform"]); at.size() > 1) {
      group.x = at[0];
      group.y = at[1];
      group.fill = colour_of(tag["fill"]);
    }
    if (const auto size = numbers_in(tag["font-size"]); !size.empty()) group.size = size[0];
    if (const auto anchor = tag["text-anchor"]; !anchor.empty()) {
      group.anchor = anchor == "start"    ? Anchor::left
                     : anchor == "middle" ? Anchor::middle
                                          : Anchor::right;
    }
    return group;
  }

  void path(const Tag& tag) {
    const std::string_view stroke = tag["stroke"];
    const Pen pen{stroke.empty() ? groups_.back().stroke : colour_of(stroke), groups_.back().width,
                  numbers_in(tag["stroke-dasharray"]), "", ""};
    std::string_view rest = tag["d"];
    while (!rest.empty()) {
      const std::size_t from = rest.find('M');
      if (from == std::string_view::npos) break;
      const std::size_t next = std::min(rest.find('M', from + 1), rest.size());
      line(rest.substr(from, next - from), pen);
      rest.remove_prefix(next);
    }
  }

  void line(std::string_view data, const Pen& pen) {
    const std::vector<double> at = numbers_in(data);
    Line line{{}, pen, data.find_first_of("Zz") != std::string_view::npos};
    for (std::size_t i = 1; i < at.size(); i += 2) line.points.push_back(place(at[i - 1], at[i]));
    if (line.points.size() < 2) return;  // only moved to
    if (line.closed && line.points.front() == line.points.back()) line.points.pop_back();
    if (is_border_of_last(line)) {
      // As wide as hides the seams between neighbours.
      std::get<Line>(drawing_.shapes.back()).pen.stroke = pen.stroke;
      return;
    }
    drawing_.shapes.emplace_back(std::move(line));
  }

  /// A box and the line around it in its colour are one shape; both are rounded in ways of their
  /// own, and run in ways of their own.
  bool is_border_of_last(const Line& line) const {
    if (!line.closed || drawing_.shapes.empty()) return false;
    const auto* area = std::get_if<Line>(&drawing_.shapes.back());
    constexpr std::size_t corners = 4;
    if (area == nullptr || area->pen.fill != line.pen.stroke || !area->pen.stroke.empty() ||
        area->points.size() != corners || line.points.size() != corners)
      return false;
    constexpr double rounding = 0.5;
    const auto is_corner = [&](const Pixel& place) {
      return std::any_of(line.points.begin(), line.points.end(), [&](const Pixel& other) {
        return (place - other).cwiseAbs().maxCoeff() < rounding;
      });
    };
    return std::all_of(area->points.begin(), area->points.end(), is_corner);
  }

  void mark(const Tag& tag) {
    std::string_view kind = tag["xlink:href"];
    const std::string ink = colour_of(tag["color"]);
    if (kind == "#gpDot") {
      const auto x = numbers_in(tag["x"]);
      const auto y = numbers_in(tag["y"]);
      drawing_.shapes.emplace_back(Dot{place(x.at(0), y.at(0)), 0.75, {"", 1.0, {}, ink, ""}});
      return;
    }
    const std::vector<double> at = numbers_in(tag["transform"]);
    kind.remove_prefix(std::string_view("#gpPt").size());
    const MarkShape shape = mark_shape(static_cast<int>(numbers_in(kind).at(0)));
    const double size = at.at(2);
    constexpr double width = 0.222;  // of a mark's lines, times its size
    const Pixel centre = place(at[0], at[1]);
    if (shape.round) {
      // All of a filled one is its area.
      const double radius = shape.filled ? (1.0 + 0.5 * width) * size : size;
      const Pen pen = shape.filled ? Pen{"", 1.0, {}, ink, ""} : Pen{ink, width * size, {}, "", ""};
      drawing_.shapes.emplace_back(Dot{centre, radius, pen});
    }
    for (const auto& corners : shape.lines) {
      Line line{{}, {ink, width * size, {}, shape.filled ? ink : "", ""}, corners.size() > 2};
      for (const Corner& corner : corners) {
        line.points.push_back(centre + size * Pixel(corner[0], -corner[1]));
      }
      drawing_.shapes.emplace_back(std::move(line));
    }
  }

  void words(std::string_view text) {
    const Group& group = groups_.back();
    words_ = {{}, place(group.x, group.y), group.anchor, group.fill, ""};
    rise_ = 0.0;
    add_run(text, group.size);
  }

  void run(const Tag& tag) {
    const auto size = numbers_in(tag["font-size"]);
    const auto down = numbers_in(tag["dy"]);
    rise_ -= down.empty() ? 0.0 : down[0];
    add_run(tag.text, size.empty() ? groups_.back().size : size[0]);
  }

  void add_run(std::string_view text, double size) {
    // Numbers that end at an axis begin with a space.
    if (words_.runs.empty() && words_.anchor == Anchor::right)
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (!text.empty()) words_.runs.push_back({unescaped(text), size, rise_});
  }

  void end_words() {
    const bool blank = std::all_of(words_.runs.begin(), words_.runs.end(), [](const Run& run) {
      return run.text.find_first_not_of(' ') == std::string::npos;
    });
    if (!blank) drawing_.shapes.emplace_back(words_);
  }

  Drawing drawing_;
  std::vector<Group> groups_{Group{}};
  Words words_;
  double rise_ = 0.0;
};

}  // namespace

Drawing drawing_of_gnuplot(const std::string& svg) { return Reader().read(svg); }

}  // namespace boxbeam::plot
