#include "boxbeam/section/outline.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/core/angle.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;
using Loop = std::vector<Vector2d>;

Vector2d on_circle(const Vector2d& centre, double radius, double angle) {
  return centre + radius * Vector2d(std::cos(angle), std::sin(angle));
}

void add_line(Outline& outline, const Vector2d& from, const Vector2d& to) {
  BorderPiece piece;
  piece.from = from;
  piece.to = to;
  outline.push_back(piece);
}

void add_arc(Outline& outline, const Vector2d& centre, double radius, double angle, double sweep) {
  outline.push_back({on_circle(centre, radius, angle), on_circle(centre, radius, angle + sweep),
                     centre, radius, angle, sweep});
}

/// The same border walked the other way: material becomes hollow.
BorderPiece reversed(const BorderPiece& piece) {
  return {piece.to,    piece.from, piece.centre, piece.radius, piece.angle + piece.sweep,
          -piece.sweep};
}

void add(Outline& outline, const Outline& other, double sign) {
  if (outline.empty()) outline.reserve(2 * other.size());  // mostly a border and a hollow
  for (const BorderPiece& piece : other) outline.push_back(sign > 0.0 ? piece : reversed(piece));
}

/// `sign` is that of the area wanted, whatever the loop's sense.
void add_loop(Outline& outline, const Loop& loop, double sign) {
  Outline border;
  border.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    add_line(border, loop[i], loop[(i + 1) % loop.size()]);
  }
  add(outline, border, sign * sums_of(border).area);
}

void add_circle(Outline& outline, double diameter, double sign) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  Outline border;
  for (int k = 0; k < 4; ++k)
    add_arc(border, Vector2d::Zero(), 0.5 * diameter, k * quarter, quarter);
  add(outline, border, sign);
}

void add_rounded_rectangle(Outline& outline, double width, double height, double radius,
                           double sign) {
  if (radius == 0.0) {
    add_rectangle(outline, -0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height, sign);
    return;
  }
  constexpr double quarter = 0.5 * std::numbers::pi;
  const Vector2d corner(0.5 * width - radius, 0.5 * height - radius);
  const Vector2d centres[] = {
      corner, {-corner.x(), corner.y()}, -corner, {corner.x(), -corner.y()}};
  Outline border;
  for (int k = 0; k < 4; ++k) {
    add_arc(border, centres[k], radius, k * quarter, quarter);
    add_line(border, border.back().to, on_circle(centres[(k + 1) % 4], radius, (k + 1) * quarter));
  }
  add(outline, border, sign);
}

Vector2d si_of(const SectionPlace& place) { return {place.y.value(), place.z.value()}; }

Loop si_of(const std::vector<SectionPlace>& places) {
  Loop loop;
  for (const SectionPlace& place : places) loop.push_back(si_of(place));
  return loop;
}

Outline outline_of(const Box& box) {
  const double y = 0.5 * box.width.value();
  const double z = 0.5 * box.height.value();
  const double left = y - box.left_web.value();
  const double right = -y + box.right_web.value();
  const double top = z - box.top_flange.value();
  const double bottom = -z + box.bottom_flange.value();
  Outline outline;
  add_rectangle(outline, -y, y, -z, z, 1.0);
  add_rectangle(outline, right, left, bottom, top, -1.0);
  for (const Stiffener& bar : box.stiffeners) {
    const double low = (bar.place - 0.5 * bar.thickness).value();
    const double high = (bar.place + 0.5 * bar.thickness).value();
    const double depth = bar.depth.value();
    switch (bar.plate) {
      case BoxPlate::top_flange: add_rectangle(outline, low, high, top - depth, top, 1.0); break;
      case BoxPlate::bottom_flange:
        add_rectangle(outline, low, high, bottom, bottom + depth, 1.0);
        break;
      case BoxPlate::left_web: add_rectangle(outline, left - depth, left, low, high, 1.0); break;
      case BoxPlate::right_web: add_rectangle(outline, right, right + depth, low, high, 1.0); break;
    }
  }
  return outline;
}

Outline outline_of(const RectangularTube& tube) {
  Outline outline;
  add_rounded_rectangle(outline, tube.width.value(), tube.height.value(), tube.outer_radius.value(),
                        1.0);
  add_rounded_rectangle(outline, (tube.width - 2.0 * tube.wall).value(),
                        (tube.height - 2.0 * tube.wall).value(), tube.inner_radius.value(), -1.0);
  return outline;
}

Outline outline_of(const RoundTube& tube) {
  Outline outline;
  add_circle(outline, tube.diameter.value(), 1.0);
  add_circle(outline, (tube.diameter - 2.0 * tube.wall).value(), -1.0);
  return outline;
}

Outline outline_of(const Plate& plate) {
  const double y = 0.5 * plate.width.value();
  const double z = 0.5 * plate.height.value();
  Outline outline;
  add_rectangle(outline, -y, y, -z, z, 1.0);
  return outline;
}

Outline outline_of(const Polygon& polygon) {
  Outline outline;
  add_loop(outline, si_of(polygon.outer), 1.0);
  for (const auto& hollow : polygon.hollows) add_loop(outline, si_of(hollow), -1.0);
  return outline;
}

Outline outline_of(const ThinWalled& path) {
  Outline outline;
  for (const ThinWall& wall : path.walls) {
    const Vector2d a = si_of(path.nodes[wall.from]);
    const Vector2d b = si_of(path.nodes[wall.to]);
    const Vector2d along = (b - a).normalized();
    const Vector2d across = 0.5 * wall.thickness.value() * Vector2d(-along.y(), along.x());
    const Vector2d start = a + wall.trim_from.value() * along;
    const Vector2d end = b - wall.trim_to.value() * along;
    add_loop(outline, {start - across, end - across, end + across, start + across}, 1.0);
  }
  return outline;
}

/// The strips a hole takes out of the section through its centre.
/// Precondition: takes_holes, and the hole lies within its walls.
void take_out(Outline& outline, const Hole& hole, const Profile& profile) {
  const Extent extent = extent_of(profile);
  const double low = (hole.position - 0.5 * hole.diameter).value();
  const double high = (hole.position + 0.5 * hole.diameter).value();
  const bool solid = std::holds_alternative<Plate>(profile);
  const bool webs = hole.walls == HoleWalls::webs;
  const double from = (webs ? extent.y_low : extent.z_low).value();
  const double to = (webs ? extent.y_high : extent.z_high).value();
  const auto strip = [&](double across_low, double across_high) {
    if (webs) {
      add_rectangle(outline, across_low, across_high, low, high, -1.0);
      return;
    }
    add_rectangle(outline, low, high, across_low, across_high, -1.0);
    if (hole.position.value() != 0.0) {
      add_rectangle(outline, -high, -low, across_low, across_high, -1.0);
    }
  };
  if (solid) {
    strip(from, to);
    return;
  }
  double first = 0.0, second = 0.0;
  if (const auto* box = std::get_if<Box>(&profile)) {
    first = (webs ? box->right_web : box->bottom_flange).value();
    second = (webs ? box->left_web : box->top_flange).value();
  } else {
    first = second = std::get<RectangularTube>(profile).wall.value();
  }
  strip(from, from + first);
  strip(to - second, to);
}

struct Node {
  double y, z, dz;  ///< a point of the border, and its weight times the step of z there
};

/// Calls `visit` at the Gauss points of a piece between two fractions of it.
template <class Visit>
void along(const BorderPiece& piece, double from, double to, const Visit& visit) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  if (piece.radius == 0.0) {
    const double rise = piece.to.y() - piece.from.y();
    if (rise == 0.0) return;
    // Gauss' rule of three points: exact to the fifth degree; fourth is wanted.
    static const double abscissa = std::sqrt(0.6);
    const auto at = [&](double x, double weight) {
      const Vector2d p = piece.from + (middle + half * x) * (piece.to - piece.from);
      visit(Node{p.x(), p.y(), weight * half * rise});
    };
    at(-abscissa, 5.0 / 9.0);
    at(0.0, 8.0 / 9.0);
    at(abscissa, 5.0 / 9.0);
    return;
  }
  using Rule = boost::math::quadrature::gauss<double, 15>;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      if (side > 0.0 && Rule::abscissa()[i] == 0.0) continue;
      const double angle = piece.angle + piece.sweep * (middle + side * half * Rule::abscissa()[i]);
      const Vector2d p = on_circle(piece.centre, piece.radius, angle);
      visit(Node{p.x(), p.y(),
                 Rule::weights()[i] * half * piece.sweep * piece.radius * std::cos(angle)});
    }
  }
}

void add_to(AreaSums& sums, const Node& p) {
  sums.area += p.y * p.dz;
  sums.z += p.y * p.z * p.dz;
  sums.y += 0.5 * p.y * p.y * p.dz;
  sums.zz += p.y * p.z * p.z * p.dz;
  sums.yy += p.y * p.y * p.y / 3.0 * p.dz;
  sums.yz += 0.5 * p.y * p.y * p.z * p.dz;
}

/// The fraction of a piece at which it stands at level z. Precondition: it crosses it.
double fraction_at(const BorderPiece& piece, double z) {
  if (piece.radius == 0.0) return (z - piece.from.y()) / (piece.to.y() - piece.from.y());
  const double sine = std::clamp((z - piece.centre.y()) / piece.radius, -1.0, 1.0);
  const double middle = piece.angle + 0.5 * piece.sweep;
  double angle = std::asin(sine);
  if (std::cos(middle) < 0.0) angle = std::numbers::pi - angle;
  const double turns = std::round((middle - angle) / full_turn);
  return std::clamp((angle + turns * full_turn - piece.angle) / piece.sweep, 0.0, 1.0);
}

/// Width just at a level that meets no corner.
double crossing_width(const Outline& outline, double z) {
  double width = 0.0;
  for (const BorderPiece& piece : outline) {
    const bool up = piece.from.y() < z && piece.to.y() > z;
    const bool down = piece.from.y() > z && piece.to.y() < z;
    if (!up && !down) continue;
    const double u = fraction_at(piece, z);
    const double y = piece.radius == 0.0
                         ? piece.from.x() + u * (piece.to.x() - piece.from.x())
                         : on_circle(piece.centre, piece.radius, piece.angle + u * piece.sweep).x();
    width += up ? y : -y;
  }
  return width;
}

}  // namespace

void add_rectangle(Outline& outline, double y_low, double y_high, double z_low, double z_high,
                   double sign) {
  constexpr std::size_t sides = 4;
  if (outline.empty()) outline.reserve(2 * sides);  // mostly a border and a hollow
  const Vector2d corners[] = {{y_low, z_low}, {y_high, z_low}, {y_high, z_high}, {y_low, z_high}};
  for (std::size_t i = 0; i < sides; ++i) {
    const Vector2d &one = corners[i], &next = corners[(i + 1) % sides];
    if (sign > 0.0)
      add_line(outline, one, next);
    else
      add_line(outline, next, one);
  }
}

Outline outline_of(const Profile& profile) {
  return std::visit([](const auto& shape) { return outline_of(shape); }, profile);
}

Outline outline_of(const Section& section, const std::vector<Hole>& holes) {
  Outline outline = outline_of(section.outer);
  for (const Hole& hole : holes) take_out(outline, hole, section.outer);
  if (section.inner) add(outline, outline_of(*section.inner), 1.0);
  return outline;
}

AreaSums sums_of(const Outline& outline) {
  AreaSums sums;
  for (const BorderPiece& piece : outline) {
    along(piece, 0.0, 1.0, [&](const Node& p) { add_to(sums, p); });
  }
  return sums;
}

AreaSums sums_beyond(const Outline& outline, double z) {
  AreaSums sums;
  const auto visit = [&](const Node& p) { add_to(sums, p); };
  for (const BorderPiece& piece : outline) {
    const bool from_beyond = piece.from.y() > z;
    const bool to_beyond = piece.to.y() > z;
    if (from_beyond && to_beyond) {
      along(piece, 0.0, 1.0, visit);
    } else if (from_beyond != to_beyond) {
      const double u = fraction_at(piece, z);
      if (from_beyond)
        along(piece, 0.0, u, visit);
      else
        along(piece, u, 1.0, visit);
    }
  }
  return sums;
}

double width_at(const Outline& outline, double z) {
  if (outline.empty()) return 0.0;
  Eigen::Vector2d low = outline.front().from, high = low;
  for (const BorderPiece& piece : outline) {
    low = low.cwiseMin(piece.from);
    high = high.cwiseMax(piece.from);
  }
  const double aside = 1e-12 * (high.y() - low.y());
  const double nothing = 1e-14 * (high.x() - low.x());
  const double above = crossing_width(outline, z + aside);
  const double below = crossing_width(outline, z - aside);
  if (above <= nothing) return std::max(0.0, below);
  if (below <= nothing) return above;
  // Where it does not jump, the mean of both sides is the width at the level itself.
  const double jump = std::abs(above - below);
  return jump < 1e-6 * above ? 0.5 * (above + below) : std::min(above, below);
}

}  // namespace boxbeam
