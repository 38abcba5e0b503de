#include "canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ink.hpp"

namespace boxbeam::plot {
namespace {

constexpr double legend_row = 18.0;

bool meet(const Frame& a, const Frame& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

bool within(const Frame& inner, const Frame& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.bottom >= outer.bottom &&
         inner.top <= outer.top;
}

/// How long a line runs inside a box, by Liang and Barsky's clipping.
double length_inside(const Pixel& from, const Pixel& to, const Frame& box) {
  const Eigen::Vector2d way = to - from;
  double begin = 0.0;
  double end = 1.0;
  const auto clip = [&](double step, double room) {
    if (step == 0.0) {
      if (room < 0.0) end = -1.0;
      return;
    }
    if (step > 0.0)
      end = std::min(end, room / step);
    else
      begin = std::max(begin, room / step);
  };
  clip(way.x(), box.right - from.x());
  clip(-way.x(), from.x() - box.left);
  clip(way.y(), box.top - from.y());
  clip(-way.y(), from.y() - box.bottom);
  return end > begin ? (end - begin) * way.norm() : 0.0;
}

/// The box of a text of one line beside a place, on the side of a direction.
Frame box_beside(const Pixel& at, const Eigen::Vector2d& side, double gap, double width) {
  const Pixel middle =
      at + Pixel(side.x() * (gap + 0.5 * width), side.y() * (gap + 0.5 * text_line));
  return {middle.x() - 0.5 * width, middle.y() - 0.5 * text_line, middle.x() + 0.5 * width,
          middle.y() + 0.5 * text_line};
}

Pixel nearest_of(const Frame& box, const Pixel& at) {
  return {std::clamp(at.x(), box.left, box.right), std::clamp(at.y(), box.bottom, box.top)};
}

/// Whether two lines cross.
bool cross(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) {
  const auto side = [](const Pixel& from, const Pixel& to, const Pixel& at) {
    const Eigen::Vector2d way = to - from;
    const Eigen::Vector2d other = at - from;
    return way.x() * other.y() - way.y() * other.x() > 0.0;
  };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

std::string screen(Script& gp, const Pixel& at) {
  return fmt::format("screen {:.6g},{:.6g}", at.x() / gp.width(), at.y() / gp.height());
}

}  // namespace

Pixel Panel::at(double x, double y) const {
  const auto share = [](double value, double low, double high, bool log) {
    return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  };
  return {frame.left + share(x, x_low, x_high, log_x) * (frame.right - frame.left),
          frame.bottom + share(y, y_low, y_high, log_y) * (frame.top - frame.bottom)};
}

double text_width(const std::string& text) {
  constexpr double size = 12.0;
  double ems = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;  // goes on with the character before
    if (byte >= 0xE0)
      ems += 1.0;
    else if (byte >= 0x80)
      ems += 0.7;
    else if (std::string_view("ijl.,:;'|! ()[]/It-").find(c) != std::string_view::npos)
      ems += 0.39;
    else if (std::string_view("mwMW%@").find(c) != std::string_view::npos)
      ems += 0.99;
    else if (c >= 'A' && c <= 'Z')
      ems += 0.74;
    else
      ems += 0.64;
  }
  return size * ems;
}

std::string fitted(const std::string& text, double room) {
  if (text_width(text) <= room) return text;
  std::string beginning = text;
  while (!beginning.empty() && text_width(beginning + "...") > room) {
    // A character of several bytes goes as a whole.
    while (beginning.size() > 1 && (static_cast<unsigned char>(beginning.back()) & 0xC0) == 0x80)
      beginning.pop_back();
    beginning.pop_back();
  }
  return beginning + "...";
}

std::vector<std::string> wrapped(const std::string& text, double room) {
  std::vector<std::string> lines{""};
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!lines.back().empty() && text_width(lines.back() + " " + word) > room) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
    begin = end + 1;
  }
  for (std::string& line : lines) line = fitted(line, room);
  return lines;
}

std::vector<std::string> wrapped(const std::vector<std::string>& texts, double room) {
  std::vector<std::string> lines;
  for (const std::string& text : texts) {
    const std::vector<std::string> of = wrapped(text, room);
    lines.insert(lines.end(), of.begin(), of.end());
  }
  return lines;
}

double tic_step(double span, int most) {
  if (!(span > 0.0)) return 1.0;
  const double least = span / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  }
  return 10.0 * power;
}

std::pair<double, double> range_with_zero(double low, double high, double room) {
  low = std::min(low, 0.0);
  high = std::max(high, 0.0);
  if (high - low <= 0.0) return {-1.0, 1.0};
  const double more = room * (high - low);
  return {low < 0.0 ? low - more : low - 0.25 * more, high > 0.0 ? high + more : 0.25 * more};
}

void Labels::keep_off(const std::vector<Pixel>& polyline) {
  for (std::size_t i = 1; i < polyline.size(); ++i) keep_off(polyline[i - 1], polyline[i]);
}

void Labels::keep_off(const Panel& panel, const std::vector<Row2>& rows) {
  std::vector<Pixel> polyline;
  polyline.reserve(rows.size());
  for (const auto& [x, y] : rows) polyline.push_back(panel.at(x, y));
  keep_off(polyline);
}

double Labels::disturbance(const Pixel& from, const Pixel& to) const {
  constexpr double crossing = 10.0;
  double sum = 0.0;
  for (const Frame& box : boxes_) sum += length_inside(from, to, box);
  for (const auto& [begin, end] : lines_) sum += cross(from, to, begin, end) ? crossing : 0.0;
  return sum;
}

std::optional<Labels::Spot> Labels::spot_for(const std::string& text, const Pixel& at,
                                             const Frame& bounds, double gap,
                                             const Eigen::Vector2d& towards) {
  const double width = text_width(text);
  constexpr double half = 0.7071;
  static const std::array<Eigen::Vector2d, 12> sides{{{1.0, half},
                                                      {-1.0, half},
                                                      {1.0, -half},
                                                      {-1.0, -half},
                                                      {0.0, 1.0},
                                                      {0.0, -1.0},
                                                      {1.0, 0.0},
                                                      {-1.0, 0.0},
                                                      {half, 1.0},
                                                      {-half, 1.0},
                                                      {half, -1.0},
                                                      {-half, -1.0}}};
  constexpr double turned_away = 6.0;
  double least = 1e300;
  Frame best;
  for (const double more : {0.0, 6.0, 14.0, 24.0, 36.0, 50.0, 70.0}) {
    for (const Eigen::Vector2d& side : sides) {
      const Frame box = box_beside(at, side, gap * side.cwiseAbs().maxCoeff() + more, width);
      if (!within(box, bounds)) continue;
      if (std::any_of(boxes_.begin(), boxes_.end(), [&](const Frame& b) { return meet(b, box); }))
        continue;
      double cost = more + turned_away * (1.0 - side.normalized().dot(towards));
      for (const auto& [from, to] : lines_) cost += 3.0 * length_inside(from, to, box);
      if (cost >= least) continue;
      least = cost;
      best = box;
    }
  }
  if (least == 1e300) return std::nullopt;
  boxes_.push_back(best);
  Spot spot{{best.left, 0.5 * (best.bottom + best.top)}, std::nullopt};
  const Pixel near = nearest_of(best, at);
  if ((near - at).norm() > gap + 12.0) {
    spot.lead = near;
    keep_off(near, at);
  }
  return spot;
}

bool Labels::put(Script& gp, const std::string& text, const Pixel& at, const Frame& bounds,
                 const char* colour, double gap) {
  const auto spot = spot_for(text, at, bounds, gap, {0.0, 0.0});
  if (!spot) return false;
  put_text(gp, text, spot->left, "left", colour);
  if (spot->lead) put_line(gp, *spot->lead, at, fmt::format("lw 0.6 lc rgb '{}'", colour));
  return true;
}

bool Labels::put(Drawing& drawing, const std::string& text, const Pixel& at, const Frame& bounds,
                 const std::string& colour, double gap, const Eigen::Vector2d& towards) {
  const auto spot = spot_for(text, at, bounds, gap, towards);
  if (!spot) return false;
  put_text(drawing, text, spot->left, Anchor::left, colour);
  if (spot->lead) put_line(drawing, *spot->lead, at, {colour, 0.6, {}, "", "lead"});
  return true;
}

void put_text(Script& gp, const std::string& text, const Pixel& at, const char* side,
              const char* colour) {
  gp << "set label " << quoted(text) << " at " << screen(gp, at) << " " << side
     << " noenhanced front tc rgb '" << colour << "'\n";
}

double put_lines(Script& gp, const std::vector<std::string>& lines, const Pixel& top,
                 const char* side, const char* colour) {
  double y = top.y();
  for (const std::string& text : lines) {
    put_text(gp, text, {top.x(), y - 0.5 * text_line}, side, colour);
    y -= text_line;
  }
  return y;
}

void put_line(Script& gp, const Pixel& from, const Pixel& to, const std::string& style) {
  gp << "set arrow from " << screen(gp, from) << " to " << screen(gp, to) << " nohead " << style
     << "\n";
}

void put_arrow(Script& gp, const Pixel& from, const Pixel& to, const std::string& style) {
  gp << "set arrow from " << screen(gp, from) << " to " << screen(gp, to) << " " << style << "\n";
}

void place(Script& gp, const Panel& panel) {
  const Frame& f = panel.frame;
  gp << "set lmargin at screen " << f.left / gp.width() << "\nset rmargin at screen "
     << f.right / gp.width() << "\nset bmargin at screen " << f.bottom / gp.height()
     << "\nset tmargin at screen " << f.top / gp.height() << "\nset xrange [" << panel.x_low << ":"
     << panel.x_high << "]\nset yrange [" << panel.y_low << ":" << panel.y_high << "]\n";
  if (!panel.log_x) {
    const int most = std::max(2, static_cast<int>((f.right - f.left) / 55.0));
    gp << "set xtics " << tic_step(std::abs(panel.x_high - panel.x_low), most) << "\n";
  }
  if (!panel.log_y) {
    const int most = std::max(2, static_cast<int>((f.top - f.bottom) / 21.0));
    gp << "set ytics " << tic_step(panel.y_high - panel.y_low, most) << "\n";
  }
}

const char* note_of_beginning(const Panel& panel) {
  const bool zero = panel.log_y || (panel.y_low <= 0.0 && panel.y_high >= 0.0);
  return zero ? "" : "  (axis not from 0)";
}

void put_heading(Script& gp, const Panel& panel, const std::string& text) {
  gp << "set label " << quoted(text) << " at "
     << screen(gp, {panel.frame.left - 44.0, panel.frame.top + 15.0})
     << " left enhanced front tc rgb '#202020'\n";
}

void put_footing(Script& gp, const Panel& panel, const std::string& text) {
  put_text(gp, text, {0.5 * (panel.frame.left + panel.frame.right), panel.frame.bottom - 34.0},
           "center");
}

namespace {

constexpr double widest = figure_width - 20.0;  ///< of an entry

/// Entries that are too long for a line go on in the next, without a stroke.
std::vector<LegendEntry> broken(const std::vector<LegendEntry>& entries) {
  std::vector<LegendEntry> rows;
  for (const LegendEntry& entry : entries) {
    const std::vector<std::string> lines = wrapped(entry.title, widest - legend_stroke - 20.0);
    rows.push_back({lines.front(), entry.style, entry.point, entry.pen});
    for (std::size_t i = 1; i < lines.size(); ++i) rows.push_back({lines[i], ""});
  }
  return rows;
}

/// Entries that stand beside each other, and the width of one [px].
std::pair<std::size_t, double> columns_of(const std::vector<LegendEntry>& entries) {
  double longest = 0.0;
  for (const LegendEntry& entry : entries) longest = std::max(longest, text_width(entry.title));
  const double one = std::min(legend_stroke + 20.0 + longest, widest);
  const auto fit = static_cast<std::size_t>((figure_width - 10.0) / one);
  return {std::clamp<std::size_t>(fit, 1, std::max<std::size_t>(1, entries.size())), one};
}

std::size_t rows_of(const std::vector<LegendEntry>& entries) {
  const std::size_t columns = columns_of(entries).first;
  return (entries.size() + columns - 1) / columns;
}

}  // namespace

double height_of_legend(const std::vector<LegendEntry>& entries) {
  return legend_row * static_cast<double>(rows_of(broken(entries))) + 4.0;
}

std::vector<LegendRow> rows_of_legend(const std::vector<LegendEntry>& of, double bottom) {
  const std::vector<LegendEntry> entries = broken(of);
  const auto [columns, one] = columns_of(entries);
  const std::size_t rows = std::max<std::size_t>(1, rows_of(entries));
  const double left = 0.5 * (figure_width - one * static_cast<double>(columns)) + 6.0;
  std::vector<LegendRow> legend;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    // Down the columns, so that what belongs together stands together.
    const std::size_t row = i % rows;
    const std::size_t column = i / rows;
    legend.emplace_back(entries[i],
                        Pixel(left + one * static_cast<double>(column),
                              bottom + legend_row * (static_cast<double>(rows - 1 - row) + 0.5)));
  }
  return legend;
}

void draw_legend(Script& gp, const std::vector<LegendEntry>& entries, double bottom) {
  for (const auto& [entry, at] : rows_of_legend(entries, bottom)) {
    if (!entry.style.empty()) put_line(gp, at, at + Pixel(legend_stroke, 0.0), entry.style);
    if (!entry.point.empty()) {
      gp << "set label '' at " << screen(gp, at + Pixel(0.5 * legend_stroke, 0.0)) << " point "
         << entry.point << "\n";
    }
    put_text(gp, entry.title, at + Pixel(legend_words, 0.0));
  }
}

}  // namespace boxbeam::plot
