#include "mechanism_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"

namespace boxbeam::plot {
namespace {

constexpr double ring = 12.0;               ///< radius of a couple's arrow [px]
constexpr double longest_load_name = 90.0;  ///< [px]
constexpr const char* load_ink = "#202020";

/// Strokes one behind the other as lines, as far as each goes on from the last without a corner.
std::vector<std::vector<Eigen::Vector3d>> chains_of(
    const std::vector<PostureFigure::Stroke>& strokes) {
  constexpr double bend = 0.7;  // cosine
  std::vector<std::vector<Eigen::Vector3d>> chains;
  for (const auto& [from, to] : strokes) {
    if (!chains.empty()) {
      std::vector<Eigen::Vector3d>& last = chains.back();
      const Eigen::Vector3d way = last.back() - last[last.size() - 2];
      const Eigen::Vector3d next = to - from;
      if ((from - last.back()).norm() <= 1e-9 * way.norm() &&
          way.dot(next) > bend * way.norm() * next.norm()) {
        last.push_back(to);
        continue;
      }
    }
    chains.push_back({from, to});
  }
  return chains;
}

void draw_body(Drawing& drawing, const PostureFigure::Line& body, const Projection& projection,
               const std::string& colour) {
  const Pen pen = body.beam ? Pen{colour, 4.0, {}, "", "beam"} : Pen{colour, 1.6, {}, "", "body"};
  const Pen full{"", 1.0, {}, colour, "joint"};
  if (body.points.size() == 1 && !body.beam) {
    constexpr double half = 5.0;
    const Pixel at = projection.at(body.points.front());
    Line block{{}, {"", 1.0, {}, colour, "block"}, true};
    for (const Pixel& corner : {Pixel(-half, -half), {half, -half}, {half, half}, {-half, half}})
      block.points.push_back(at + corner);
    drawing.shapes.emplace_back(std::move(block));
    return;
  }
  auto chains = chains_of(body.strokes);
  if (chains.empty() && body.points.size() > 1) chains.push_back(body.points);
  for (const auto& chain : chains) {
    Line line{{}, pen};
    for (const Eigen::Vector3d& place : chain) line.points.push_back(projection.at(place));
    drawing.shapes.emplace_back(std::move(line));
  }
  for (const Eigen::Vector3d& point : body.points)
    drawing.shapes.emplace_back(Dot{projection.at(point), 2.5, full});
}

/// Three quarters of a circle about a place with a head at its end, open below.
void put_couple(Drawing& drawing, const Pixel& at, bool counter_clockwise, const Pen& pen) {
  constexpr int parts = 16;
  constexpr double quarter = 0.5 * std::numbers::pi;
  const double side = counter_clockwise ? 1.0 : -1.0;
  const auto angle_of = [&](int k) { return -quarter + side * quarter * (0.5 + 3.0 * k / parts); };
  Line arc{{}, pen};
  for (int k = 0; k <= parts; ++k)
    arc.points.push_back(at + ring * Pixel(std::cos(angle_of(k)), std::sin(angle_of(k))));
  const Eigen::Vector2d onwards =
      side * Eigen::Vector2d(-std::sin(angle_of(parts)), std::cos(angle_of(parts)));
  const Pixel end = arc.points.back();
  drawing.shapes.emplace_back(std::move(arc));
  put_head(drawing, end + 6.0 * onwards, onwards, 8.0, pen.stroke);
}

}  // namespace

View flat_view(int across, int up) {
  View view = View::Zero();
  view(0, across) = view(1, up) = 1.0;
  return view;
}

Pixel Projection::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector2d seen = view * place;
  return panel.at(seen.x(), seen.y());
}

Eigen::Vector3d Projection::normal() const {
  return Eigen::Vector3d(view.row(0)).cross(Eigen::Vector3d(view.row(1)));
}

void each_place(const PostureFigure& posture,
                const std::function<void(const Eigen::Vector3d&)>& take) {
  const auto ends = [&](const std::vector<PostureFigure::Stroke>& strokes) {
    for (const auto& [from, to] : strokes) {
      take(from);
      take(to);
    }
  };
  for (const auto& body : posture.bodies) {
    std::for_each(body.points.begin(), body.points.end(), take);
    ends(body.strokes);
  }
  ends(posture.rods);
  std::for_each(posture.grounds.begin(), posture.grounds.end(), take);
}

void draw_bodies(Drawing& drawing, const PostureFigure& posture, const Projection& projection,
                 const std::string& colour, double guide) {
  for (const auto& [place, along] : posture.guides) {
    const Pixel middle = projection.at(place);
    const Eigen::Vector2d half = guide * (projection.view * along);
    put_line(drawing, middle - half, middle + half, {colour, 0.9, {2.0, 3.0}, "", "guide"});
  }
  for (const Eigen::Vector3d& place : posture.grounds) {
    const Pixel tip = projection.at(place);
    drawing.shapes.emplace_back(Line{{tip, tip + Pixel(-6.0, -10.0), tip + Pixel(6.0, -10.0)},
                                     {"", 1.0, {}, quiet_ink, "ground"},
                                     true});
  }
  for (const auto& [from, to] : posture.rods) {
    put_line(drawing, projection.at(from), projection.at(to), {colour, 1.6, {8.0, 5.0}, "", "rod"});
  }
  for (const bool front : {false, true}) {
    for (const auto& body : posture.bodies) {
      if (body.beam == front) draw_body(drawing, body, projection, colour);
    }
  }
}

void draw_traces(Drawing& drawing, const Verification& verification, const Projection& projection) {
  if (verification.pictures.cycles.empty()) return;
  const std::vector<CycleFrame>& frames = verification.pictures.cycles.front().frames;
  for (std::size_t b = 0; b < frames.front().posture.bodies.size(); ++b) {
    for (std::size_t k = 0; k < frames.front().posture.bodies[b].points.size(); ++k) {
      Line line{{}, {"#9a9a9a", 0.6, {}, "", "trace"}};
      for (const CycleFrame& frame : frames)
        line.points.push_back(projection.at(frame.posture.bodies[b].points[k]));
      if (verification.pictures.cycles.front().repeats) line.points.push_back(line.points.front());
      drawing.shapes.emplace_back(std::move(line));
    }
  }
}

void keep_off_bodies(Labels& labels, const PostureFigure& posture, const Projection& projection) {
  const auto line = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    labels.keep_off(projection.at(from), projection.at(to));
  };
  const auto keep_free = [&](const Eigen::Vector3d& place, double below) {
    const Pixel at = projection.at(place);
    labels.keep_free({at.x() - 7.0, at.y() - below, at.x() + 7.0, at.y() + 7.0});
  };
  for (const auto& body : posture.bodies) {
    for (const auto& [from, to] : body.strokes) line(from, to);
    for (std::size_t k = 1; body.strokes.empty() && k < body.points.size(); ++k)
      line(body.points[k - 1], body.points[k]);
    if (body.points.size() == 1) keep_free(body.points.front(), 7.0);
  }
  for (const auto& [from, to] : posture.rods) line(from, to);
  for (const Eigen::Vector3d& place : posture.grounds) keep_free(place, 11.0);
}

std::string name_of(const BeamLoadRow& load) {
  return load.name.empty() ? fmt::format("s = {} m", text::significant(load.s.value(), 3))
                           : load.name;
}

void draw_loads(Drawing& drawing, Labels& labels, const PostureFigure& posture,
                const Projection& projection, const LoadInk& look) {
  const Pen push{load_ink, 1.6, {}, "", "load"};
  const Pen turn{load_ink, 1.6, {}, "", "couple"};
  double longest = 0.0;
  for (const BeamLoadRow& row : posture.loads) longest = std::max(longest, row.world.norm());
  struct Beside {
    std::string text;
    Pixel at;
    double gap;
    Eigen::Vector2d towards;
  };
  std::vector<Beside> words;
  for (const BeamLoadRow& row : posture.loads) {
    const Eigen::Vector2d force = projection.view * row.world;
    const double couple = projection.normal().dot(row.couple);
    const bool pushes = force.norm() > 0.0 &&
                        (force.norm() >= 0.05 * longest || force.norm() >= 0.3 * row.world.norm());
    const bool turns = std::abs(couple) > look.least_couple;
    if (!pushes && !turns) continue;
    const Pixel tip = projection.at(row.place);
    const Pixel tail = tip - look.pixels_per_newton * force;
    if (pushes) {
      labels.keep_off(tail, tip);
      put_arrow(drawing, tail, tip, push);
    }
    if (turns) {
      labels.keep_free({tip.x() - ring, tip.y() - ring, tip.x() + ring, tip.y() + ring});
      put_couple(drawing, tip, couple > 0.0, turn);
    }
    std::string text = fitted(name_of(row), longest_load_name);
    if (look.with_size && pushes) text += "  " + text::kN(row.world.norm());
    if (look.with_size && turns) text += (pushes ? ", " : "  ") + text::kNm(std::abs(couple));
    words.push_back({std::move(text), pushes ? tail : tip, pushes ? 4.0 : ring + 3.0,
                     pushes ? Eigen::Vector2d(-force.normalized()) : Eigen::Vector2d(0.0, 1.0)});
  }
  // When all that must not be hit is known.
  for (const Beside& of : words)
    labels.put(drawing, of.text, of.at, projection.panel.frame, load_ink, of.gap, of.towards);
}

void Room::take(const Eigen::Vector3d& place) {
  low_ = low_.cwiseMin(view_ * place);
  high_ = high_.cwiseMax(view_ * place);
}

void Room::take(const PostureFigure& posture) {
  each_place(posture, [&](const Eigen::Vector3d& place) { take(place); });
}

void Room::take_loads(const PostureFigure& posture, const LoadInk& look) {
  for (const BeamLoadRow& row : posture.loads) {
    const Eigen::Vector2d back = -look.pixels_per_newton * (view_ * row.world);
    const double name = std::min(text_width(name_of(row)), longest_load_name) + 4.0;
    // Behind a name alone there is always room on one side; with its size it stands where it can.
    const double half = 0.5 * (name + text_width("  00.00 kN"));
    const bool rightwards = back.x() > 0.0;
    arrows_.push_back({view_ * row.place, back,
                       look.with_size ? half
                       : rightwards   ? 0.0
                                      : name,
                       look.with_size ? half
                       : rightwards   ? name
                                      : 0.0});
  }
}

Frame Room::at(double metres_per_pixel) const {
  constexpr double margin = 12.0, beside = 20.0;
  const Eigen::Vector2d low = low_ / metres_per_pixel;
  const Eigen::Vector2d high = high_ / metres_per_pixel;
  Frame frame{low.x() - margin, low.y() - margin, high.x() + margin, high.y() + margin};
  for (const Arrow& arrow : arrows_) {
    const Pixel tail = arrow.tip / metres_per_pixel + arrow.back;
    frame = {std::min(frame.left, tail.x() - arrow.left), std::min(frame.bottom, tail.y() - beside),
             std::max(frame.right, tail.x() + arrow.right), std::max(frame.top, tail.y() + beside)};
  }
  return frame;
}

double finest_scale(double size, const std::function<bool(double)>& fits) {
  double fine = 1e-3 * size / figure_width;
  double coarse = 1e6 * fine;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(fine * coarse);
    (fits(middle) ? coarse : fine) = middle;
  }
  return coarse;
}

void LoadSizes::take(const PostureFigure& posture) {
  for (const BeamLoadRow& row : posture.loads) {
    force_ = std::max(force_, row.world.norm());
    couple_ = std::max(couple_, row.couple.norm());
  }
}

double LoadSizes::least_couple(double size) const {
  return std::max(0.02 * couple_, 1e-6 * force_ * size);
}

LoadSizes load_sizes_of(const Verification& verification) {
  LoadSizes sizes;
  for (const PostureFigure& posture : verification.pictures.postures) sizes.take(posture);
  return sizes;
}

Room room_of(const Verification& verification, const View& view) {
  Room room(view);
  for (const PostureFigure& posture : verification.pictures.postures) room.take(posture);
  if (verification.pictures.cycles.empty()) return room;
  for (const CycleFrame& frame : verification.pictures.cycles.front().frames)
    room.take(frame.posture);
  return room;
}

Panel panel_to_scale(const Frame& frame, double metres_per_pixel, const Eigen::Vector2d& middle) {
  const double half_width = 0.5 * metres_per_pixel * (frame.right - frame.left);
  const double half_height = 0.5 * metres_per_pixel * (frame.top - frame.bottom);
  return {frame, middle.x() - half_width, middle.x() + half_width, middle.y() - half_height,
          middle.y() + half_height};
}

}  // namespace boxbeam::plot
