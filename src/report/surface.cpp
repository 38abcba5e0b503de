#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/report/gltf.hpp"
#include "boxbeam/section/outline.hpp"

namespace boxbeam {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

constexpr int pieces_of_quarter = 12;

std::uint32_t corner_index(std::size_t i) { return static_cast<std::uint32_t>(i); }

double turn_across(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The corners of a closed border from piece `first` to before `end`, counter-clockwise around
/// material; its pieces may stand in the other order (see add in outline.cpp).
Ring ring_of(const Outline& outline, std::size_t first, std::size_t end, bool backward) {
  Ring ring;
  for (std::size_t k = 0; k < end - first; ++k) {
    const BorderPiece& piece = outline[backward ? end - 1 - k : first + k];
    ring.push_back(piece.from);
    if (piece.radius == 0.0) continue;
    for (int j = 1; j < pieces_of_quarter; ++j) {
      const double angle = piece.angle + piece.sweep * j / pieces_of_quarter;
      ring.push_back(piece.centre +
                     piece.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  return ring;
}

/// The outer borders of a profile: one, of a thin-walled path that of every wall.
std::vector<Ring> rings_of(const Profile& profile) {
  const Outline outline = outline_of(profile);
  double size = 0.0;
  for (const BorderPiece& piece : outline) size = std::max(size, piece.from.norm());
  const auto meet = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() <= 1e-12 * size;
  };
  std::vector<Ring> rings;
  for (std::size_t first = 0; first < outline.size();) {
    std::size_t end = first + 1;
    const bool backward = end < outline.size() && !meet(outline[end].from, outline[first].to);
    const auto closed = [&] {
      return backward ? meet(outline[end - 1].from, outline[first].to)
                      : meet(outline[end - 1].to, outline[first].from);
    };
    while (end < outline.size() && !closed()) ++end;
    rings.push_back(ring_of(outline, first, end, backward));
    if (!std::holds_alternative<ThinWalled>(profile)) break;
    first = end;
  }
  return rings;
}

/// The area within a ring as triangles, by cutting off corners inside whose triangle there is no
/// other. Source: Meisters, Polygons have ears, Amer. Math. Monthly 82 (1975).
std::vector<std::array<std::uint32_t, 3>> triangles_in(const Ring& ring) {
  std::vector<std::uint32_t> left;
  for (std::size_t i = 0; i < ring.size(); ++i) left.push_back(corner_index(i));
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto triangle_at = [&](std::size_t k) {
    const std::size_t n = left.size();
    return std::array{left[(k + n - 1) % n], left[k], left[(k + 1) % n]};
  };
  const auto is_ear = [&](const std::array<std::uint32_t, 3>& of) {
    const Eigen::Vector2d &a = ring[of[0]], &b = ring[of[1]], &c = ring[of[2]];
    if (turn_across(b - a, c - b) <= 0.0) return false;
    return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
      if (i == of[0] || i == of[1] || i == of[2]) return false;
      const Eigen::Vector2d& p = ring[i];
      return turn_across(b - a, p - a) >= 0.0 && turn_across(c - b, p - b) >= 0.0 &&
             turn_across(a - c, p - c) >= 0.0;
    });
  };
  while (left.size() > 2) {
    std::size_t k = 0;
    while (k < left.size() && !is_ear(triangle_at(k))) ++k;
    if (k == left.size()) k = 0;  // corners in a line: flat triangles close the surface
    triangles.push_back(triangle_at(k));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return triangles;
}

/// The body between two sections of as many corners.
void add_between(Surface& surface, double from, const Ring& at_from, double to, const Ring& at_to) {
  const std::uint32_t first = corner_index(surface.corners.size()),
                      n = corner_index(at_from.size());
  for (const Eigen::Vector2d& p : at_from) surface.corners.emplace_back(from, p.x(), p.y());
  for (const Eigen::Vector2d& p : at_to) surface.corners.emplace_back(to, p.x(), p.y());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % n;
    surface.triangles.push_back({a, b, b + n});
    surface.triangles.push_back({a, b + n, a + n});
  }
  for (const auto& [a, b, c] : triangles_in(at_from))
    surface.triangles.push_back({first + a, first + c, first + b});
  for (const auto& [a, b, c] : triangles_in(at_to))
    surface.triangles.push_back({first + n + a, first + n + b, first + n + c});
}

/// A part, each of its corners at its place.
template <class Place>
void add_placed(const Surface& part, const Place& place, Surface& surface) {
  const std::uint32_t first = corner_index(surface.corners.size());
  for (const Eigen::Vector3d& p : part.corners) surface.corners.emplace_back(place(p));
  for (const auto& [a, b, c] : part.triangles)
    surface.triangles.push_back({first + a, first + b, first + c});
}

bool same_corners(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Ring& p, const Ring& q) { return p.size() == q.size(); });
}

}  // namespace

Surface surface_of(const TaperedBeam& beam) {
  Surface surface;
  for (const Segment& segment : beam.segments) {
    const auto rings_at = [&](double fraction) {
      return rings_of(interpolate(segment.from, segment.to, fraction).outer);
    };
    std::vector<Ring> from = rings_at(0.0), to = rings_at(1.0);
    if (!same_corners(from, to)) {  // a radius begins or ends: just beside that it is there
      constexpr double aside = 1e-6;
      from = rings_at(aside);
      to = rings_at(1.0 - aside);
    }
    for (std::size_t i = 0; i < from.size(); ++i)
      add_between(surface, segment.start.value(), from[i], segment.end().value(), to[i]);
  }
  return surface;
}

void add_rod(Surface& surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
             double radius) {
  const Eigen::Vector3d along = (to - from).normalized();
  Ring ring;
  for (int i = 0; i < 6; ++i) {
    const double angle = full_turn * i / 6;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  Surface prism;
  add_between(prism, 0.0, ring, (to - from).norm(), ring);
  const Eigen::Vector3d y = along.unitOrthogonal(), z = along.cross(y);
  const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return from + p.x() * along + p.y() * y + p.z() * z;
  };
  add_placed(prism, place, surface);
}

void add_block(Surface& surface, const Eigen::Vector3d& centre, double side) {
  const double half = 0.5 * side;
  Surface block;
  const Ring ring{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  add_between(block, -half, ring, half, ring);
  const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return centre + p; };
  add_placed(block, place, surface);
}

}  // namespace boxbeam
