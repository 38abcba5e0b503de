#include "drawing.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"

namespace boxbeam::plot {
namespace {

constexpr double unseen = 0.1;  ///< [px], a twelfth of the usual line's width

/// What a shape covers.
Frame reach_of(const Line& line) {
  Frame reach{1e300, 1e300, -1e300, -1e300};
  const double half = line.pen.stroke.empty() ? 0.0 : 0.5 * line.pen.width;
  for (const Pixel& p : line.points) {
    reach = {std::min(reach.left, p.x() - half), std::min(reach.bottom, p.y() - half),
             std::max(reach.right, p.x() + half), std::max(reach.top, p.y() + half)};
  }
  return reach;
}

Frame reach_of(const Dot& dot) {
  const double r = dot.radius + (dot.pen.stroke.empty() ? 0.0 : 0.5 * dot.pen.width);
  return {dot.at.x() - r, dot.at.y() - r, dot.at.x() + r, dot.at.y() + r};
}

Frame reach_of(const Words& words) {
  double width = 0.0;
  for (const Run& run : words.runs) width += text_width(run.text);
  const double before = words.anchor == Anchor::left     ? 0.0
                        : words.anchor == Anchor::middle ? 0.5 * width
                                                         : width;
  const double left = words.at.x() - before;
  return {left, words.at.y() - 6.0, left + width, words.at.y() + 14.0};
}

/// Whether two overlap by more than the seam between neighbours.
bool hide_each_other(const Frame& a, const Frame& b) {
  constexpr double seam = 1.1;
  return a.left + seam < b.right && b.left + seam < a.right && a.bottom + seam < b.top &&
         b.bottom + seam < a.top;
}

/// Areas of one path that overlap may cut holes into each other.
bool may_hide_itself(const Line& line) {
  constexpr std::size_t simple = 5;
  return !line.pen.fill.empty() && line.points.size() > simple;
}

class Strokes {
 public:
  void add(const Line& of) {
    Line line{simplified(of.points, unseen), of.pen, of.closed};
    const Frame reach = reach_of(line);
    PenStroke& stroke =
        may_hide_itself(line) ? fresh(line.pen, reach) : stroke_for(line.pen, reach);
    stroke.lines.push_back(std::move(line));
  }
  void add(const Dot& dot) { stroke_for(dot.pen, reach_of(dot)).dots.push_back(dot); }
  void add(const Words& words) {
    marks_.emplace_back(words);
    reaches_.push_back({reach_of(words)});
  }
  std::vector<Mark> take() { return std::move(marks_); }

 private:
  PenStroke& fresh(const Pen& pen, const Frame& reach) {
    marks_.emplace_back(PenStroke{pen, {}, {}});
    reaches_.push_back({reach});
    return std::get<PenStroke>(marks_.back());
  }

  PenStroke& stroke_for(const Pen& pen, const Frame& reach) {
    constexpr std::size_t window = 400;
    const std::size_t first = marks_.size() - std::min(window, marks_.size());
    for (std::size_t i = marks_.size(); i-- > first;) {
      auto* stroke = std::get_if<PenStroke>(&marks_[i]);
      if (stroke != nullptr && stroke->pen == pen) {
        reaches_[i].push_back(reach);
        return *stroke;
      }
      const bool hidden =
          std::any_of(reaches_[i].begin(), reaches_[i].end(),
                      [&](const Frame& other) { return hide_each_other(reach, other); });
      if (hidden) break;
    }
    return fresh(pen, reach);
  }

  std::vector<Mark> marks_;
  std::vector<std::vector<Frame>> reaches_;  ///< of what each holds
};

}  // namespace

std::vector<Mark> in_few_strokes(const Drawing& drawing) {
  Strokes strokes;
  for (const Shape& shape : drawing.shapes) {
    std::visit([&](const auto& of) { strokes.add(of); }, shape);
  }
  return strokes.take();
}

std::vector<Pixel> simplified(const std::vector<Pixel>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> pieces{{0, points.size() - 1}};
  while (!pieces.empty()) {
    const auto [a, b] = pieces.back();
    pieces.pop_back();
    const Eigen::Vector2d way = points[b] - points[a];
    double farthest = tolerance;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const Eigen::Vector2d off = points[i] - points[a];
      const double part =
          way.squaredNorm() > 0.0 ? std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
      const double distance = (off - part * way).norm();
      if (distance <= farthest) continue;
      farthest = distance;
      at = i;
    }
    if (at == a) continue;
    kept[at] = true;
    pieces.emplace_back(a, at);
    pieces.emplace_back(at, b);
  }
  std::vector<Pixel> fewer;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) fewer.push_back(points[i]);
  }
  return fewer;
}

}  // namespace boxbeam::plot
