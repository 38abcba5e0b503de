#include "mechanism_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {

std::vector<std::string> draw_bodies(Script& gp, const PostureFigure& posture, const View& view,
                                     const Ink& ink) {
  std::vector<std::string> plots;
  const auto strokes = [&](const std::string& name, const std::vector<PostureFigure::Stroke>& lines,
                           const std::string& style) {
    if (lines.empty()) return;
    std::vector<Row4> rows;
    for (const auto& line : lines) {
      const Eigen::Vector3d along = line.to - line.from;
      rows.emplace_back(line.from[view.across], line.from[view.up], along[view.across],
                        along[view.up]);
    }
    gp.block(name, rows);
    plots.push_back(fmt::format("${} using 1:2:3:4 with vectors nohead {} lc rgb '{}'", name, style,
                                ink.colour));
  };
  const auto points = [&](const std::string& name, const std::vector<Eigen::Vector3d>& places,
                          const std::string& style, const std::string& rgb) {
    if (places.empty()) return;
    std::vector<Row2> rows;
    for (const Eigen::Vector3d& place : places)
      rows.emplace_back(place[view.across], place[view.up]);
    gp.block(name, rows);
    plots.push_back(fmt::format("${} using 1:2 with {} lc rgb '{}'", name, style, rgb));
  };
  std::vector<PostureFigure::Stroke> guides;
  for (const auto& guide : posture.guides) {
    guides.push_back(
        {guide.from - ink.guide_length * guide.to, guide.from + ink.guide_length * guide.to});
  }
  strokes(ink.prefix + "_guides", guides, "lw 0.9 dt (2,3)");
  strokes(ink.prefix + "_rods", posture.rods, "lw 1.6 dt (5,3)");
  for (std::size_t b = 0; b < posture.bodies.size(); ++b) {
    const auto& body = posture.bodies[b];
    const std::string name = fmt::format("{}_{}", ink.prefix, b);
    if (body.beam) {
      strokes(name + "_axis", body.strokes, "lw 4");
      points(name, body.points, "points pt 7 ps 0.5", ink.colour);
    } else if (body.points.size() == 1) {
      points(name, body.points, "points pt 5 ps 1.1", ink.colour);
    } else if (!body.strokes.empty()) {
      strokes(name + "_lines", body.strokes, "lw 1.6");
      points(name, body.points, "points pt 7 ps 0.5", ink.colour);
    } else {
      points(name, body.points, "linespoints lw 1.6 pt 7 ps 0.5", ink.colour);
    }
  }
  points(ink.prefix + "_grounds", posture.grounds, "points pt 9 ps 1.1", "#505050");
  return plots;
}

std::vector<std::string> draw_traces(Script& gp, const Verification& verification, const View& view,
                                     const std::string& prefix) {
  std::vector<std::string> plots;
  if (verification.cycles.empty()) return plots;
  const std::vector<CycleFrame>& frames = verification.cycles.front().frames;
  const bool closed = verification.cycles.front().repeats;
  for (std::size_t b = 0; b < frames.front().posture.bodies.size(); ++b) {
    for (std::size_t k = 0; k < frames.front().posture.bodies[b].points.size(); ++k) {
      std::vector<Row2> rows;
      for (std::size_t i = 0; i < frames.size() + (closed ? 1 : 0); ++i) {
        const Eigen::Vector3d& place = frames[i % frames.size()].posture.bodies[b].points[k];
        rows.emplace_back(place[view.across], place[view.up]);
      }
      const std::string name = fmt::format("{}_{}_{}", prefix, b, k);
      gp.block(name, rows);
      plots.push_back(fmt::format("${} using 1:2 with lines lw 0.6 lc rgb '#9a9a9a'", name));
    }
  }
  return plots;
}

namespace {

Eigen::Vector2d seen(const Eigen::Vector3d& v, const View& view) {
  return {v[view.across], v[view.up]};
}

Pixel pixel_of(const Panel& panel, const Eigen::Vector3d& place, const View& view) {
  return panel.at(place[view.across], place[view.up]);
}

}  // namespace

void keep_off_bodies(Labels& labels, const Panel& panel, const PostureFigure& posture,
                     const View& view) {
  const auto line = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    labels.keep_off(pixel_of(panel, from, view), pixel_of(panel, to, view));
  };
  for (const auto& body : posture.bodies) {
    for (const PostureFigure::Stroke& stroke : body.strokes) line(stroke.from, stroke.to);
    if (!body.strokes.empty()) continue;
    for (std::size_t k = 1; k < body.points.size(); ++k) line(body.points[k - 1], body.points[k]);
  }
  for (const PostureFigure::Stroke& rod : posture.rods) line(rod.from, rod.to);
  const auto keep_free = [&](const Eigen::Vector3d& place) {
    const Pixel at = pixel_of(panel, place, view);
    labels.keep_free({at.x() - 7.0, at.y() - 7.0, at.x() + 7.0, at.y() + 7.0});
  };
  for (const auto& body : posture.bodies) {
    if (body.points.size() == 1) keep_free(body.points.front());
  }
  for (const Eigen::Vector3d& place : posture.grounds) keep_free(place);
}

double least_couple_of(const Verification& verification) {
  double force = 0.0;
  double couple = 0.0;
  for (const PostureFigure& posture : verification.postures) {
    for (const BeamLoadRow& row : posture.loads) {
      force = std::max(force, row.world.norm());
      couple = std::max(couple, row.couple.norm());
    }
  }
  return std::max(0.02 * couple, 1e-6 * force * extents_of(verification).size().maxCoeff());
}

namespace {

constexpr double ring = 12.0;  ///< radius of a couple's arrow [px]

/// Three quarters of a circle about a place with a head at its end, open below.
void put_couple(Script& gp, const Pixel& at, bool counter_clockwise, const std::string& style) {
  constexpr int parts = 12;
  constexpr double quarter = 0.5 * std::numbers::pi;
  const double side = counter_clockwise ? 1.0 : -1.0;
  const auto on_ring = [&](int k) -> Pixel {
    const double angle = -quarter + side * quarter * (0.5 + 3.0 * k / parts);
    return at + ring * Pixel(std::cos(angle), std::sin(angle));
  };
  for (int k = 1; k < parts; ++k) put_line(gp, on_ring(k - 1), on_ring(k), style);
  put_arrow(gp, on_ring(parts - 1), on_ring(parts), style + " front size screen 0.012,20 filled");
}

/// The component of a couple about the line of sight, counter-clockwise.
double turning(const Eigen::Vector3d& couple, const View& view) {
  return Eigen::Vector3d::Unit(view.across).cross(Eigen::Vector3d::Unit(view.up)).dot(couple);
}

}  // namespace

void draw_loads(Script& gp, Labels& labels, const Panel& panel, const PostureFigure& posture,
                const View& view, const LoadInk& look) {
  constexpr const char* ink = "#202020";
  const std::string style = fmt::format("lw 1.6 lc rgb '{}'", ink);
  double longest = 0.0;
  for (const BeamLoadRow& row : posture.loads) longest = std::max(longest, row.world.norm());
  struct Words {
    std::string text;
    Pixel at;
    double gap;
  };
  std::vector<Words> words;
  for (const BeamLoadRow& row : posture.loads) {
    const Eigen::Vector2d force = seen(row.world, view);
    const double couple = turning(row.couple, view);
    const bool pushes = force.norm() >= 0.05 * longest ||
                        (row.world.norm() > 0.0 && force.norm() >= 0.3 * row.world.norm());
    const bool turns = std::abs(couple) > look.least_couple;
    if (!pushes && !turns) continue;
    const Pixel tip = pixel_of(panel, row.place, view);
    const Pixel tail = tip - look.pixels_per_newton * force;
    if (pushes) {
      labels.keep_off(tail, tip);
      put_arrow(gp, tail, tip, style + " front size screen 0.012,20 filled");
    }
    if (turns) {
      labels.keep_free({tip.x() - ring, tip.y() - ring, tip.x() + ring, tip.y() + ring});
      put_couple(gp, tip, couple > 0.0, style);
    }
    std::string text = fitted(
        row.name.empty() ? fmt::format("s = {} m", text::significant(row.s.value(), 3)) : row.name,
        longest_load_name);
    if (look.with_size && pushes) text += "  " + text::kN(row.world.norm());
    if (look.with_size && turns) text += (pushes ? ", " : "  ") + text::kNm(std::abs(couple));
    words.push_back({std::move(text), pushes ? tail : tip, pushes ? 4.0 : ring + 3.0});
  }
  // When all that must not be hit is known.
  for (const Words& of : words) labels.put(gp, of.text, of.at, panel.frame, ink, of.gap);
}

void Extents::take(const Eigen::Vector3d& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

void Extents::take(const PostureFigure& posture) {
  for (const auto& body : posture.bodies) {
    for (const Eigen::Vector3d& point : body.points) take(point);
    for (const PostureFigure::Stroke& stroke : body.strokes) {
      take(stroke.from);
      take(stroke.to);
    }
  }
  for (const Eigen::Vector3d& place : posture.grounds) take(place);
}

Extents extents_of(const Verification& verification) {
  Extents extents;
  for (const PostureFigure& posture : verification.postures) extents.take(posture);
  if (!verification.cycles.empty()) {
    for (const CycleFrame& frame : verification.cycles.front().frames) extents.take(frame.posture);
  }
  return extents;
}

Panel panel_to_scale(const Frame& frame, double metres_per_pixel, double across, double up) {
  const double half_width = 0.5 * metres_per_pixel * (frame.right - frame.left);
  const double half_height = 0.5 * metres_per_pixel * (frame.top - frame.bottom);
  return {frame, across - half_width, across + half_width, up - half_height, up + half_height};
}

}  // namespace boxbeam::plot
