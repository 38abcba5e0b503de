#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "boxbeam/report/format.hpp"
#include "ink.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::plot {
namespace {

constexpr double arrow = 40.0;  ///< the longest [px]
constexpr double width = 0.5 * figure_width;
constexpr double title_row = 16.0;
constexpr double highest = 220.0, lowest = 110.0;  ///< of the frame [px]

/// The situation in which the governing check has its stress, by name.
std::string situation_of(const Project& project, const CheckResult& governing) {
  return governing.basis ? project.situations[governing.basis->running].name
                         : governing.check.situation;
}

/// The posture that is nearest to the instant of the governing check.
const PostureFigure& governing_posture(const Project& project, const Verification& verification) {
  const CheckResult& governing = verification.checks.front();
  const std::string situation = situation_of(project, governing);
  const std::vector<PostureFigure>& postures = verification.pictures.postures;
  const auto distance = [&](const PostureFigure& posture) {
    return std::pair(posture.situation != situation,
                     std::abs(posture.time.value() - governing.check.time.value()));
  };
  return *std::min_element(
      postures.begin() + (postures.size() > 1 ? 1 : 0), postures.end(),
      [&](const PostureFigure& a, const PostureFigure& b) { return distance(a) < distance(b); });
}

/// The view that shows most; of bodies in a line that against which the largest couple turns.
View view_of(const Project& project, const PostureFigure& posture) {
  if (!project.in_space) return flat_view(0, 1);
  const auto area = [&](const View& view) {
    Room room(view);
    room.take(posture);
    const Eigen::Vector2d size = room.size();
    const Projection seen{view, {}};
    double couple = 0.0;
    for (const BeamLoadRow& row : posture.loads)
      couple = std::max(couple, std::abs(seen.normal().dot(row.couple)));
    const bool line = size.minCoeff() < 1e-3 * size.maxCoeff();
    return std::tuple(size.maxCoeff() > 0.0, line ? 0.0 : size.prod(), couple);
  };
  const std::array views{flat_view(0, 2), flat_view(1, 2), flat_view(0, 1)};
  return *std::max_element(views.begin(), views.end(),
                           [&](const View& a, const View& b) { return area(a) < area(b); });
}

/// Where a station of the beam is in a posture: along the strokes of its axis, which go on from
/// each other; nothing where no body is the beam.
std::optional<Eigen::Vector3d> place_at(const PostureFigure& posture, double part) {
  const auto beam = std::find_if(posture.bodies.begin(), posture.bodies.end(),
                                 [](const PostureFigure::Line& line) { return line.beam; });
  if (beam == posture.bodies.end() || beam->strokes.empty()) return std::nullopt;
  const std::vector<PostureFigure::Stroke>& strokes = beam->strokes;
  std::size_t count = 1;
  double length = (strokes[0].to - strokes[0].from).norm();
  for (; count < strokes.size(); ++count) {
    const double step = (strokes[count].to - strokes[count].from).norm();
    if ((strokes[count].from - strokes[count - 1].to).norm() > 1e-9 * step) break;
    length += step;
  }
  double left = part * length;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d way = strokes[i].to - strokes[i].from;
    if (left <= way.norm() || i + 1 == count)
      return strokes[i].from + std::min(1.0, left / way.norm()) * way;
    left -= way.norm();
  }
  return std::nullopt;
}

}  // namespace

Drawing sketch(const Project& project, const Verification& verification) {
  const CheckResult& governing = verification.checks.front();
  const PostureFigure& posture = governing_posture(project, verification);
  const View view = view_of(project, posture);
  LoadSizes sizes;
  sizes.take(posture);
  Room room(view);
  room.take(posture);
  const LoadInk look{arrow / sizes.force(), sizes.least_couple(room.size().maxCoeff()), true};
  room.take_loads(posture, look);
  const double scale = finest_scale(room.size().maxCoeff(), [&](double metres_per_pixel) {
    const Frame at = room.at(metres_per_pixel);
    return at.right - at.left <= width - 8.0 && at.top - at.bottom <= highest;
  });
  const Frame at = room.at(scale);
  const double height = std::clamp(at.top - at.bottom, lowest, highest);
  Drawing drawing{width, height + 2.0 * title_row + 8.0, {}};
  const Projection projection{
      view, panel_to_scale({4.0, 4.0, width - 4.0, 4.0 + height}, scale,
                           scale * Pixel(0.5 * (at.left + at.right), 0.5 * (at.bottom + at.top)))};
  put_text(drawing, fitted(time_label(posture.time, posture.situation), width - 8.0),
           {4.0, drawing.height - 0.5 * title_row}, Anchor::left, "#202020");
  const std::string enlarged =
      posture.magnified > 0.0
          ? fmt::format("displacements {:g} times as large; ", posture.magnified)
          : "";
  put_text(drawing, fitted(enlarged + "arrows: loads on the beam", width - 8.0),
           {4.0, drawing.height - 1.5 * title_row}, Anchor::left, quiet_ink);
  Labels labels;
  keep_off_bodies(labels, posture, projection);
  draw_bodies(drawing, posture, projection, colour(0), 0.4 * arrow);
  const auto place = governing.check.on_beam
                         ? place_at(posture, governing.check.station.s / project.beam.length())
                         : std::nullopt;
  if (place) {
    const Pixel mark = projection.at(*place);
    drawing.shapes.emplace_back(Dot{mark, 6.0, {"#202020", 1.6, {}, "", ""}});
    labels.keep_free({mark.x() - 7.0, mark.y() - 7.0, mark.x() + 7.0, mark.y() + 7.0});
  }
  draw_loads(drawing, labels, posture, projection, look);
  if (place)
    labels.put(drawing, text::percent(governing.check.utilisation()), projection.at(*place),
               projection.panel.frame, "#202020", 9.0);
  return drawing;
}

}  // namespace boxbeam::plot
