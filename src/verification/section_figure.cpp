#include <algorithm>
#include <cmath>
#include <deque>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/outline.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/pictures.hpp"

namespace boxbeam {
namespace {

using Loop = std::vector<std::pair<double, double>>;

/// The pieces of a border loop by loop. A hollow's pieces may stand in the other order than the one
/// they are walked in.
std::vector<std::deque<BorderPiece>> loops_of_pieces(const Outline& outline) {
  std::vector<std::deque<BorderPiece>> loops;
  const auto meet = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() <= 1e-12 + 1e-9 * a.norm();
  };
  bool closed = true;
  for (const BorderPiece& piece : outline) {
    if (!closed && meet(loops.back().back().to, piece.from))
      loops.back().push_back(piece);
    else if (!closed && meet(piece.to, loops.back().front().from))
      loops.back().push_front(piece);
    else
      loops.push_back({piece});
    closed = meet(loops.back().back().to, loops.back().front().from);
  }
  return loops;
}

/// The loops of a border as polygons: arcs in steps of at most three degrees.
std::vector<Loop> loops_of(const Outline& outline) {
  constexpr double step = 0.05;  // [rad]
  std::vector<Loop> loops;
  for (const std::deque<BorderPiece>& pieces : loops_of_pieces(outline)) {
    Loop& loop = loops.emplace_back();
    for (const BorderPiece& piece : pieces) {
      const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(piece.sweep) / step)));
      loop.emplace_back(piece.from.x(), piece.from.y());
      for (int k = 1; k < parts; ++k) {
        const double angle = piece.angle + piece.sweep * k / parts;
        loop.emplace_back(piece.centre.x() + piece.radius * std::cos(angle),
                          piece.centre.y() + piece.radius * std::sin(angle));
      }
    }
  }
  return loops;
}

/// The strips that holes take out: what the border with holes has more than that without.
std::vector<SectionFigure::Hole> strips_of(const Section& section, const std::vector<Hole>& holes) {
  const Section outer{section.outer, {}};
  const std::size_t whole = outline_of(outer, {}).size();
  Outline border = outline_of(outer, holes);
  border.erase(border.begin(), border.begin() + static_cast<std::ptrdiff_t>(whole));
  std::vector<SectionFigure::Hole> strips;
  for (const Loop& loop : loops_of(border)) {
    const auto [left, right] = std::minmax_element(loop.begin(), loop.end());
    const auto [low, high] = std::minmax_element(
        loop.begin(), loop.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    strips.push_back({0.5 * (left->first + right->first), 0.5 * (low->second + high->second),
                      right->first - left->first, high->second - low->second});
  }
  return strips;
}

/// The seams of a welded box: where its webs meet its flanges, on the outside.
std::vector<SectionFigure::Weld> welds_of(const Section& section) {
  std::vector<SectionFigure::Weld> welds;
  const auto* box = std::get_if<Box>(&section.outer);
  if (box == nullptr) return welds;
  const double y = 0.5 * box->width.value();
  for (const double side : {1.0, -1.0}) {
    const std::string web = side > 0.0 ? "+y" : "-y";
    welds.push_back({side * y, clear_top_of(section.outer).value(), web + " +z"});
    welds.push_back({side * y, clear_bottom_of(section.outer).value(), web + " -z"});
  }
  return welds;
}

/// Where the left web of a section stands; zero where it has none.
double web_of(const Section& section) {
  const double half = extent_of(section.outer).y_high.value();
  if (const auto* box = std::get_if<Box>(&section.outer)) {
    return half - 0.5 * box->left_web.value();
  }
  if (const auto* tube = std::get_if<RectangularTube>(&section.outer)) {
    return half - 0.5 * tube->wall.value();
  }
  return 0.0;
}

/// What is checked at the station: each place once, with its worst check.
std::vector<SectionFigure::Point> points_of(const std::vector<CheckResult>& checks,
                                            const CheckResult& governing) {
  std::vector<SectionFigure::Point> points;
  for (const CheckResult& result : checks) {
    if (!result.basis || result.check.station != governing.check.station) continue;
    const bool known = std::any_of(
        points.begin(), points.end(),
        [&](const SectionFigure::Point& point) { return point.name == result.check.point; });
    if (known) continue;
    const StressPoint& place = result.basis->point;
    SectionFigure::Point point;
    point.name = place.name;
    point.y = place.y.value();
    point.z = place.z.value();
    // In the plane both webs are one.
    const bool in_both_webs =
        place.concentration && point.y == 0.0 && place.concentration->edge.walls == HoleWalls::webs;
    if (in_both_webs) point.y = web_of(place.section);
    point.stress = stress_at(place.influence, governing.basis->cut_at_time).normal.value();
    point.utilisation = result.check.utilisation();
    point.governs = &result == &governing;
    points.push_back(std::move(point));
  }
  return points;
}

/// The outermost places of the material at a level; nothing where there is none.
std::optional<std::pair<double, double>> width_at(const std::vector<Loop>& loops, double z) {
  std::optional<std::pair<double, double>> ends;
  const auto take = [&](double y) {
    if (!ends) ends = {y, y};
    ends = {std::min(ends->first, y), std::max(ends->second, y)};
  };
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y_a, z_a] = loop[i];
      const auto& [y_b, z_b] = loop[(i + 1) % loop.size()];
      if (std::min(z_a, z_b) > z || std::max(z_a, z_b) < z) continue;
      if (z_a == z_b) {
        take(y_a);
        take(y_b);
      } else {
        take(y_a + (z - z_a) / (z_b - z_a) * (y_b - y_a));
      }
    }
  }
  return ends;
}

/// The highest and the lowest nominal stress at levels over the height, in all situations: plane
/// over the net section, so that the ends of a level's width are its worst places.
std::vector<SectionFigure::Level> stress_across(const std::vector<Loop>& loops,
                                                const SectionProperties& net,
                                                const std::vector<SituationHistory>& histories) {
  constexpr int steps = 16;
  double bottom = 1e300;
  double top = -1e300;
  for (const Loop& loop : loops) {
    for (const auto& [y, z] : loop) {
      bottom = std::min(bottom, z);
      top = std::max(top, z);
    }
  }
  const Eigen::Matrix3d plane = normal_stress_plane(sums_of(net));
  std::vector<SectionFigure::Level> levels;
  for (int k = 0; k <= steps; ++k) {
    const double z = k == steps ? top : bottom + (top - bottom) * k / steps;
    const auto ends = width_at(loops, z);
    if (!ends) continue;
    SectionFigure::Level level{z, -1e300, 1e300};
    for (const double y : {ends->first, ends->second}) {
      const Eigen::RowVector3d factors = Eigen::RowVector3d(1.0, y, z) * plane;
      const auto stress = [&](const CutForces& cut) {
        return factors.dot(Eigen::RowVector3d(cut.N.value(), cut.M_y.value(), cut.M_z.value()));
      };
      for (const SituationHistory& at : histories) {
        level.highest = std::max(level.highest, at.history.largest(stress).value);
        level.lowest =
            std::min(level.lowest,
                     -at.history.largest([&](const CutForces& cut) { return -stress(cut); }).value);
      }
    }
    levels.push_back(level);
  }
  return levels;
}

}  // namespace

std::optional<SectionFigure> section_figure_of(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               const std::vector<CheckResult>& checks) {
  const CheckResult* governing = first_by_cut_forces(checks);
  if (governing == nullptr) return std::nullopt;
  const CheckBasis& basis = *governing->basis;
  const Section& section = basis.point.section;
  SectionFigure figure;
  figure.station = governing->check.station;
  figure.time = governing->check.time;
  figure.situation = project.situations[basis.running].name;
  figure.outlines = loops_of(outline_of(section, {}));
  figure.points = points_of(checks, *governing);
  figure.holes = strips_of(section, holes_in_section(project, figure.station));
  figure.welds = welds_of(section);
  figure.across =
      stress_across(figure.outlines, basis.point.net, histories_at(runs, figure.station));
  return figure;
}

}  // namespace boxbeam
