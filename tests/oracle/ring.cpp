#include "ring.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>
#include <utility>

#include "boxbeam/section/torsion.hpp"
#include "section_areas.hpp"

namespace oracle {

using boxbeam::Box;
using boxbeam::BoxPlate;
using boxbeam::Hole;
using boxbeam::HoleWalls;
using boxbeam::Profile;
using boxbeam::RoundTube;

namespace {

constexpr double pi = std::numbers::pi;

/// Where a straight plate is cut: at the feet of stiffeners and the edges of holes.
void add_plate(Ring& ring, const std::string& name, Vector2d from, Vector2d to, Vector2d node_from,
               Vector2d node_to, double t, std::vector<std::pair<double, const Bar*>> feet,
               std::vector<std::pair<double, double>> hollow, const Vector3d& lump) {
  const Vector2d way = (to - from).normalized();
  const double length = (to - from).norm();
  std::vector<std::pair<double, const Bar*>> cuts;
  for (const auto& [at, bar] : feet) cuts.emplace_back(at, bar);
  for (const auto& [low, high] : hollow) {
    cuts.emplace_back(low, nullptr);
    cuts.emplace_back(high, nullptr);
  }
  std::sort(cuts.begin(), cuts.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  cuts.emplace_back(length, nullptr);
  double at = 0.0;
  Vector3d hanging = lump;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    Piece piece;
    piece.name = name;
    piece.from = from + at * way;
    piece.to = from + cuts[i].first * way;
    piece.node_from = i == 0 ? node_from : piece.from;
    piece.node_to = i + 1 == cuts.size() ? node_to : piece.to;
    piece.thickness = t;
    const double middle = 0.5 * (at + cuts[i].first);
    piece.solid = std::none_of(hollow.begin(), hollow.end(), [&](const auto& hole) {
      return middle > hole.first && middle < hole.second;
    });
    piece.lump = hanging;
    hanging.setZero();
    if (const Bar* bar = cuts[i].second) {
      const Branch branch{bar->tip, bar->root, bar->foot_mid, bar->thickness};
      piece.bar = true;
      hanging = branch.material(1.0);
      ring.branches.push_back(branch);
    }
    ring.pieces.push_back(piece);
    at = cuts[i].first;
  }
}

/// From the node at the top right to the left, down, to the right and up.
Ring ring_of(const Box& box, const std::vector<Hole>& holes) {
  const BoxSizes s(box);
  Ring ring;
  const std::vector<Bar> bars = bars_of(box);
  const auto feet = [&](BoxPlate plate, const auto& distance) {
    std::vector<std::pair<double, const Bar*>> of;
    for (const Bar& bar : bars) {
      if (bar.plate == plate) of.emplace_back(distance(bar.place), &bar);
    }
    return of;
  };
  const auto hollows = [&](HoleWalls walls, const auto& distance) {
    std::vector<std::pair<double, double>> of;
    for (const Hole& hole : holes) {
      if (hole.walls != walls) continue;
      const double at = hole.position.value(), r = 0.5 * hole.diameter.value();
      const auto add = [&](double p) {
        const auto [low, high] = std::minmax({distance(p - r), distance(p + r)});
        of.emplace_back(low, high);
      };
      add(at);
      if (walls == HoleWalls::flanges && at > 0.0) add(-at);
    }
    return of;
  };
  const Vector2d tr(s.y_right, s.z_top), tl(s.y_left, s.z_top), bl(s.y_left, s.z_bottom),
      br(s.y_right, s.z_bottom);
  const auto stub = [&](const Vector2d& node, double edge, double t) {
    const Branch branch{{edge, node.y()}, node, node, t};
    ring.branches.push_back(branch);
    return branch.material(1.0);
  };
  const auto to_left = [&](double p) { return p - s.y_right; };
  const auto to_right = [&](double p) { return s.y_left - p; };
  const auto down = [&](double p) { return s.in_top - p; };
  const auto up = [&](double p) { return p - s.in_bottom; };
  add_plate(ring, "top", tr, tl, tr, tl, s.top, feet(BoxPlate::top_flange, to_left),
            hollows(HoleWalls::flanges, to_left), stub(tr, -0.5 * s.W, s.top));
  add_plate(ring, "left", {s.y_left, s.in_top}, {s.y_left, s.in_bottom}, tl, bl, s.left,
            feet(BoxPlate::left_web, down), hollows(HoleWalls::webs, down),
            stub(tl, 0.5 * s.W, s.top));
  add_plate(ring, "bottom", bl, br, bl, br, s.bottom, feet(BoxPlate::bottom_flange, to_right),
            hollows(HoleWalls::flanges, to_right), stub(bl, 0.5 * s.W, s.bottom));
  add_plate(ring, "right", {s.y_right, s.in_bottom}, {s.y_right, s.in_top}, br, tr, s.right,
            feet(BoxPlate::right_web, up), hollows(HoleWalls::webs, up),
            stub(br, -0.5 * s.W, s.bottom));
  const auto cube = [](double t) { return t * t * t / 3.0; };
  ring.own_torsion = s.W * (cube(s.top) + cube(s.bottom)) +
                     (s.in_top - s.in_bottom) * (cube(s.left) + cube(s.right));
  for (const Bar& bar : bars) ring.own_torsion += (bar.tip - bar.root).norm() * cube(bar.thickness);
  return ring;
}

Ring ring_of(const RoundTube& tube) {
  Ring ring;
  const double t = tube.wall.value(), d = tube.diameter.value();
  Piece piece;
  piece.radius = 0.5 * (d - t);
  piece.thickness = t;
  piece.sweep = 2.0 * pi;
  piece.from = piece.to = piece.node_from = piece.node_to = {piece.radius, 0.0};
  ring.pieces.push_back(piece);
  ring.own_torsion = 2.0 * pi * piece.radius * t * t * t / 3.0;
  return ring;
}

}  // namespace

Ring ring_of(const Profile& profile, const std::vector<Hole>& holes) {
  const auto box = box_of(profile);
  Ring ring = box ? ring_of(*box, holes) : ring_of(std::get<RoundTube>(profile));
  if (const auto* tube = std::get_if<RoundTube>(&profile)) {
    const double d = tube->diameter.value(), in = d - 2.0 * tube->wall.value();
    ring.I_T = pi / 32.0 * (std::pow(d, 4) - std::pow(in, 4));
  } else {
    ring.I_T = boxbeam::torsion_constant_of(profile)->value();
  }
  ring.add_up();
  return ring;
}

}  // namespace oracle
