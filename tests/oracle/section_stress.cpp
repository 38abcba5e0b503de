#include "section_stress.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "boxbeam/section/torsion.hpp"

namespace oracle {
namespace {

using boxbeam::Box;
using boxbeam::BoxPlate;
using boxbeam::Hole;
using boxbeam::HoleWalls;
using boxbeam::Plate;
using boxbeam::Profile;
using boxbeam::RectangularTube;
using boxbeam::RoundTube;
using boxbeam::Section;
using boxbeam::Stiffener;
namespace cut_force = boxbeam::cut_force;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

std::optional<Box> box_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) return *box;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    if (tube->outer_radius.value() > 0.0) return std::nullopt;
    return Box{tube->width, tube->height, tube->wall, tube->wall, tube->wall, tube->wall, {}, {}};
  }
  return std::nullopt;
}

/// A rectangle of material, upright; of negative sign where it is taken out.
struct Rectangle {
  double y, z, width, height, sign = 1.0;
};

/// int dA, y dA, z dA, y^2 dA, z^2 dA, y z dA.
struct Sums {
  double A = 0.0, y = 0.0, z = 0.0, yy = 0.0, zz = 0.0, yz = 0.0;

  void add(const Rectangle& r) {
    const double a = r.sign * r.width * r.height;
    A += a;
    y += a * r.y;
    z += a * r.z;
    yy += a * (r.y * r.y + r.width * r.width / 12.0);
    zz += a * (r.z * r.z + r.height * r.height / 12.0);
    yz += a * r.y * r.z;
  }
  void add_ring(double outer, double inner) {
    A += pi / 4.0 * (outer * outer - inner * inner);
    const double I = pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4));
    yy += I;
    zz += I;
  }
};

Rectangle between(double y_a, double y_b, double z_a, double z_b, double sign = 1.0) {
  return {0.5 * (y_a + y_b), 0.5 * (z_a + z_b), std::abs(y_b - y_a), std::abs(z_b - z_a), sign};
}

/// The numbers of a box.
struct BoxSizes {
  double W, H, top, bottom, left, right;
  double y_left, y_right, z_top, z_bottom;      ///< mid-lines
  double in_left, in_right, in_top, in_bottom;  ///< inner faces

  explicit BoxSizes(const Box& box)
      : W(box.width.value()),
        H(box.height.value()),
        top(box.top_flange.value()),
        bottom(box.bottom_flange.value()),
        left(box.left_web.value()),
        right(box.right_web.value()),
        y_left(0.5 * (W - left)),
        y_right(-0.5 * (W - right)),
        z_top(0.5 * (H - top)),
        z_bottom(-0.5 * (H - bottom)),
        in_left(0.5 * W - left),
        in_right(-0.5 * W + right),
        in_top(0.5 * H - top),
        in_bottom(-0.5 * H + bottom) {}
};

/// A stiffener as a rectangle, with the end of its mid-line and its foot on the ring.
struct Bar {
  BoxPlate plate;
  double place, thickness;
  Vector2d foot_mid, root, tip;  ///< on the plate's mid-line, on its inner face, the free edge
};

std::vector<Bar> bars_of(const Box& box) {
  const BoxSizes s(box);
  std::vector<Bar> bars;
  for (const Stiffener& of : box.stiffeners) {
    Bar bar{of.plate, of.place.value(), of.thickness.value(), {}, {}, {}};
    const double p = bar.place, d = of.depth.value();
    switch (of.plate) {
      case BoxPlate::top_flange:
        bar.foot_mid = {p, s.z_top};
        bar.root = {p, s.in_top};
        bar.tip = {p, s.in_top - d};
        break;
      case BoxPlate::bottom_flange:
        bar.foot_mid = {p, s.z_bottom};
        bar.root = {p, s.in_bottom};
        bar.tip = {p, s.in_bottom + d};
        break;
      case BoxPlate::left_web:
        bar.foot_mid = {s.y_left, p};
        bar.root = {s.in_left, p};
        bar.tip = {s.in_left - d, p};
        break;
      case BoxPlate::right_web:
        bar.foot_mid = {s.y_right, p};
        bar.root = {s.in_right, p};
        bar.tip = {s.in_right + d, p};
        break;
    }
    bars.push_back(bar);
  }
  return bars;
}

/// What is idle of a plate between low and high in spite of its bars: a strip in its middle.
std::pair<double, double> idle_strip(double low, double high, double part) {
  const double middle = 0.5 * (low + high), half = 0.5 * (1.0 - part) * (high - low);
  return {middle - half, middle + half};
}

/// What is left of a stretch where others are taken out of it.
using Stretches = std::vector<std::pair<double, double>>;
Stretches without(Stretches of, const Stretches& taken) {
  for (const auto& [from, to] : taken) {
    Stretches left;
    for (const auto& [low, high] : of) {
      if (std::min(high, from) > low) left.emplace_back(low, std::min(high, from));
      if (high > std::max(low, to)) left.emplace_back(std::max(low, to), high);
    }
    of = left;
  }
  return of;
}

/// The places of holes along the plates that they go through.
Stretches hollows_of(const std::vector<Hole>& holes, HoleWalls walls) {
  Stretches hollows;
  for (const Hole& hole : holes) {
    if (hole.walls != walls) continue;
    const double at = hole.position.value(), r = 0.5 * hole.diameter.value();
    hollows.emplace_back(at - r, at + r);
    if (walls == HoleWalls::flanges && at > 0.0) hollows.emplace_back(-at - r, -at + r);
  }
  return hollows;
}

void add_box(Sums& sums, const Box& box, const std::vector<Hole>& holes, double flange_part,
             double web_part) {
  const BoxSizes s(box);
  sums.add(between(-0.5 * s.W, 0.5 * s.W, s.in_top, 0.5 * s.H));
  sums.add(between(-0.5 * s.W, 0.5 * s.W, -0.5 * s.H, s.in_bottom));
  sums.add(between(s.in_left, 0.5 * s.W, s.in_bottom, s.in_top));
  sums.add(between(-0.5 * s.W, s.in_right, s.in_bottom, s.in_top));
  const auto across = idle_strip(s.in_right, s.in_left, flange_part);
  const auto up = idle_strip(s.in_bottom, s.in_top, web_part);
  const auto take_from_flanges = [&](double low, double high) {
    sums.add(between(low, high, s.in_top, 0.5 * s.H, -1.0));
    sums.add(between(low, high, -0.5 * s.H, s.in_bottom, -1.0));
  };
  const auto take_from_webs = [&](double low, double high) {
    sums.add(between(s.in_left, 0.5 * s.W, low, high, -1.0));
    sums.add(between(-0.5 * s.W, s.in_right, low, high, -1.0));
  };
  const Stretches in_flanges = hollows_of(holes, HoleWalls::flanges);
  const Stretches in_webs = hollows_of(holes, HoleWalls::webs);
  for (const auto& [low, high] : in_flanges) take_from_flanges(low, high);
  for (const auto& [low, high] : in_webs) take_from_webs(low, high);
  // What a hole has taken is not idle once more.
  if (flange_part < 1.0) {
    for (const auto& [low, high] : without({across}, in_flanges)) take_from_flanges(low, high);
  }
  if (web_part < 1.0) {
    for (const auto& [low, high] : without({up}, in_webs)) take_from_webs(low, high);
  }
  for (const Bar& bar : bars_of(box)) {
    const bool flange = bar.plate == BoxPlate::top_flange || bar.plate == BoxPlate::bottom_flange;
    // Of a bar, what stands on the idle strip is idle too.
    const auto& strip = flange ? across : up;
    const double part = flange ? flange_part : web_part;
    const Stretches whole{{bar.place - 0.5 * bar.thickness, bar.place + 0.5 * bar.thickness}};
    for (const auto& [low, high] : part < 1.0 ? without(whole, {strip}) : whole) {
      if (flange)
        sums.add(between(low, high, bar.root.y(), bar.tip.y()));
      else
        sums.add(between(bar.root.x(), bar.tip.x(), low, high));
    }
  }
}

void add_profile(Sums& sums, const Profile& profile, const std::vector<Hole>& holes,
                 double flange_part, double web_part) {
  if (const auto box = box_of(profile)) {
    add_box(sums, *box, holes, flange_part, web_part);
  } else if (const auto* round = std::get_if<RoundTube>(&profile)) {
    sums.add_ring(round->diameter.value(), (round->diameter - 2.0 * round->wall).value());
  } else {
    const auto& plate = std::get<Plate>(profile);
    sums.add({0.0, 0.0, plate.width.value(), plate.height.value()});
  }
}

/// (a, b, c) per N, M_y, M_z as columns.
Eigen::Matrix3d plane_for(const Sums& s) {
  Eigen::Matrix3d gram;
  gram << s.A, s.y, s.z, s.y, s.yy, s.yz, s.z, s.yz, s.zz;
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();  // of int sigma (1, y, z) dA = (N, -M_z, M_y)
  right(0, 0) = 1.0;
  right(2, 1) = 1.0;
  right(1, 2) = -1.0;
  return gram.colPivHouseholderQr().solve(right);
}

Eigen::Matrix3d plane_for(const Section& section, const std::vector<Hole>& holes,
                          double flange_part, double web_part) {
  Sums sums;
  add_profile(sums, section.outer, holes, flange_part, web_part);
  if (section.inner) add_profile(sums, *section.inner, {}, 1.0, 1.0);
  return plane_for(sums);
}

Factors normal_at(const Eigen::Matrix3d& plane, double y, double z) {
  const Eigen::RowVector3d at = Eigen::RowVector3d(1.0, y, z) * plane;
  Factors factors{};
  factors[cut_force::N] = at[0];
  factors[cut_force::M_y] = at[1];
  factors[cut_force::M_z] = at[2];
  return factors;
}

// --------------------------------------------------------------------------- shear flow in a ring

/// A stretch of the ring between two of its nodes, straight or round: material as first moments up
/// to a fraction of it, geometry along the mid-line. What hangs on its start (an overhang of a
/// flange, a stiffener) is a lump.
struct Piece {
  std::string name;             ///< of the plate; "" in rounds
  Vector2d from, to;            ///< of the material, on the mid-line
  Vector2d node_from, node_to;  ///< mid-lines meet here
  double thickness = 0.0;
  bool solid = true;
  double radius = 0.0, angle = 0.0, sweep = 0.0;  ///< rounds
  Vector3d lump = Vector3d::Zero();
  bool bar = false;  ///< one stands at its end

  double length() const { return radius > 0.0 ? radius * std::abs(sweep) : (to - from).norm(); }
  Vector2d at(double f) const {
    if (radius == 0.0) return from + f * (to - from);
    const double a = angle + f * sweep;
    return {radius * std::cos(a), radius * std::sin(a)};
  }
  Vector2d along(double f) const {
    if (radius == 0.0) return (to - from).normalized();
    const double a = angle + f * sweep;
    return {-std::sin(a), std::cos(a)};
  }
  Vector3d material(double f) const {
    if (!solid) return Vector3d::Zero();
    if (radius == 0.0) {
      const double area = f * thickness * length();
      const Vector2d centre = at(0.5 * f);
      return {area, area * centre.x(), area * centre.y()};
    }
    // int over the ring's sector of r dr dphi (1, r cos, r sin).
    const double r3 = thickness * (radius * radius + thickness * thickness / 12.0);
    const double b = angle + f * sweep;
    return {thickness * radius * f * sweep, r3 * (std::sin(b) - std::sin(angle)),
            -r3 * (std::cos(b) - std::cos(angle))};
  }
};

/// A wall that hangs on the ring: its material begins at `free` and ends at `foot`, whence its flow
/// goes on to the ring's node.
struct Branch {
  Vector2d free, foot, node;
  double thickness = 0.0;

  Vector3d material(double f) const {
    const double area = f * thickness * (foot - free).norm();
    const Vector2d centre = free + 0.5 * f * (foot - free);
    return {area, area * centre.x(), area * centre.y()};
  }
};

/// V_y, V_z and T per cut force.
using Carried = Eigen::Matrix<double, 3, 6>;

/// A closed ring of walls with its branches: a box or a round tube.
struct Ring {
  std::vector<Piece> pieces;
  std::vector<Branch> branches;
  double own_torsion = 0.0;  ///< sum of s t^3/3
  double I_T = 0.0;

  /// All material before each piece, its own lump included; set when all pieces are there.
  std::vector<Vector3d> before_piece;
  void add_up() {
    Vector3d sum = Vector3d::Zero();
    for (const Piece& piece : pieces) {
      sum += piece.lump;
      before_piece.push_back(sum);
      sum += piece.material(1.0);
    }
  }
  Vector3d before(std::size_t index) const { return before_piece[index]; }
  Vector3d total() const { return before(pieces.size() - 1) + pieces.back().material(1.0); }
};

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

/// A profile of the section with the change of its forces along the beam, and its flows.
class Flow {
 public:
  Flow(const LocalSection& section, bool inner) {
    const Profile& profile = inner ? *section.here.inner : section.here.outer;
    const std::vector<Hole> none;
    ring_ = ring_of(profile, inner ? none : section.holes);
    plane_ = plane_for(section.here, section.holes, 1.0, 1.0);
    for (const auto& [near, weight] : section.nearby) {
      nearby_.push_back({ring_of(inner ? *near.inner : near.outer, inner ? none : section.holes),
                         plane_for(near, section.holes, 1.0, 1.0), weight});
    }
    whole_I_T_ = ring_.I_T;
    const std::optional<Profile> other =
        inner ? std::optional<Profile>(section.here.outer) : section.here.inner;
    if (other) whole_I_T_ += ring_of(*other, {}).I_T;
    total_ = ring_.total();
    bredt_ = constant_flow();
    total_change_ = change_of([](const Ring& ring) { return ring.total(); });
    close();
  }

  const Ring& ring() const { return ring_; }
  double per_whole_I_T() const { return 1.0 / whole_I_T_; }

  /// V_y, V_z and T, per cut force, that flows without twist and inclined stresses carry.
  Carried carried() const {
    Carried sum = Carried::Zero();
    const auto add = [&](const Vector2d& at, const Vector2d& way, const Factors& q) {
      for (std::size_t k = 0; k < q.size(); ++k) add_force(sum, k, at, q[k] * way);
    };
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      const int steps = piece.radius > 0.0 ? 96 : 8;
      simpson(steps, [&](double f, double weight) {
        add(piece.at(f), weight * piece.length() * piece.along(f), transverse(i, f));
      });
      add(piece.node_from, piece.from - piece.node_from, transverse(i, 0.0));
      add(piece.to, piece.node_to - piece.to, transverse(i, 1.0));
    }
    for (std::size_t b = 0; b < ring_.branches.size(); ++b) {
      const Branch& branch = ring_.branches[b];
      simpson(8, [&](double f, double weight) {
        add(branch.free + f * (branch.foot - branch.free), weight * (branch.foot - branch.free),
            in_branch(b, f));
      });
      add(branch.foot, branch.node - branch.foot, in_branch(b, 1.0));
    }
    add_inclined(sum);
    return sum;
  }

  /// What walls carry by bending across their thickness: a stretch's share of such a force is
  /// t^3/12 n (n . force), in its middle. Forces as columns give V_y, V_z and T of a unit share.
  Eigen::Matrix<double, 3, 2> across() const {
    Eigen::Matrix<double, 3, 2> sum = Eigen::Matrix<double, 3, 2>::Zero();
    const auto add = [&](const Vector2d& at, const Vector2d& along, double length, double t) {
      const Vector2d n(-along.y(), along.x());
      const Eigen::RowVector2d of = length * t * t * t / 12.0 * n.transpose();
      sum.topRows<2>() += n * of;
      sum.row(2) += (at.x() * n.y() - at.y() * n.x()) * of;
    };
    for (const Piece& piece : ring_.pieces) {
      if (!piece.solid) continue;
      simpson(piece.radius > 0.0 ? 96 : 8, [&](double f, double weight) {
        add(piece.at(f), piece.along(f), weight * piece.length(), piece.thickness);
      });
    }
    for (const Branch& branch : ring_.branches) {
      const Vector2d way = branch.foot - branch.free;
      if (way.norm() == 0.0) continue;
      add(0.5 * (branch.free + branch.foot), way.normalized(), way.norm(), branch.thickness);
    }
    return sum;
  }

  /// Flow in the ring without twist, positive along it.
  Factors transverse(std::size_t index, double f) const {
    Factors q = open(index, f);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += closing_[k];
    return q;
  }

  /// Flow from the free end towards the ring.
  Factors in_branch(std::size_t index, double f) const {
    return flow_of([=](const Ring& ring) -> Vector3d { return ring.branches[index].material(f); });
  }

  /// Constant flow per torque, positive along the ring.
  double bredt() const { return bredt_; }

 private:
  double constant_flow() const {
    // T r/I_p where the ring is round.
    const Piece& first = ring_.pieces.front();
    if (first.radius > 0.0) return first.radius * first.thickness / whole_I_T_;
    double twice_area = 0.0;  // negative where the ring runs clockwise
    for (const Piece& piece : ring_.pieces) {
      twice_area +=
          piece.node_from.x() * piece.node_to.y() - piece.node_from.y() * piece.node_to.x();
    }
    return (ring_.I_T - ring_.own_torsion) / whole_I_T_ / twice_area;
  }

  struct Nearby {
    Ring ring;
    Eigen::Matrix3d plane;
    double weight;
  };

  template <class Visit>
  static void simpson(int steps, const Visit& visit) {
    for (int i = 0; i <= steps; ++i) {
      const double weight = (i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) / (3.0 * steps);
      visit(static_cast<double>(i) / steps, weight);
    }
  }

  /// d/ds of the force of some material per N, M_y, M_z.
  template <class Material>
  Eigen::RowVector3d change_of(const Material& material) const {
    Eigen::RowVector3d change = Eigen::RowVector3d::Zero();
    for (const Nearby& near : nearby_) {
      change += near.weight * (material(near.ring).transpose() * near.plane);
    }
    return change;
  }

  /// What leaves some material of the ring by shear: its share of what the whole ring gives to the
  /// other profile comes in, the change of its own normal force goes out.
  template <class Material>
  Factors flow_of(const Material& material) const {
    const Vector3d of = material(ring_);
    const double share = of[0] / total_[0];
    const Eigen::RowVector3d force =
        of.transpose() * plane_ - share * (total_.transpose() * plane_);
    const Eigen::RowVector3d change = change_of(material) - share * total_change_;
    Factors q{};
    q[cut_force::V_z] = -force[1];
    q[cut_force::V_y] = force[2];
    q[cut_force::N] = -change[0];
    q[cut_force::M_y] = -change[1];
    q[cut_force::M_z] = -change[2];
    return q;
  }

  Factors open(std::size_t index, double f) const {
    return flow_of([=](const Ring& ring) -> Vector3d {
      return ring.before(index) + ring.pieces[index].material(f);
    });
  }

  void close() {
    Factors around{};
    double per_flow = 0.0;
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      const auto add = [&](double length, const Factors& q) {
        for (std::size_t k = 0; k < q.size(); ++k) around[k] += length / piece.thickness * q[k];
        per_flow += length / piece.thickness;
      };
      simpson(piece.radius > 0.0 ? 96 : 8,
              [&](double f, double weight) { add(weight * piece.length(), open(i, f)); });
      add((piece.from - piece.node_from).norm(), open(i, 0.0));
      add((piece.node_to - piece.to).norm(), open(i, 1.0));
    }
    for (std::size_t k = 0; k < around.size(); ++k) closing_[k] = -around[k] / per_flow;
  }

  static void add_force(Carried& sum, std::size_t of, const Vector2d& at, const Vector2d& force) {
    sum.col(static_cast<Eigen::Index>(of)) +=
        Vector3d(force.x(), force.y(), at.x() * force.y() - at.y() * force.x());
  }

  /// Normal stresses that follow the inclined material.
  void add_inclined(Carried& sum) const {
    if (nearby_.empty()) return;
    const auto add = [&](const Vector2d& at, const Vector2d& slope, double area) {
      const Eigen::RowVector3d force = area * Eigen::RowVector3d(1.0, at.x(), at.y()) * plane_;
      add_force(sum, cut_force::N, at, force[0] * slope);
      add_force(sum, cut_force::M_y, at, force[1] * slope);
      add_force(sum, cut_force::M_z, at, force[2] * slope);
    };
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      if (!piece.solid) continue;
      simpson(piece.radius > 0.0 ? 96 : 8, [&](double f, double weight) {
        Vector2d slope = Vector2d::Zero();
        for (const Nearby& near : nearby_) slope += near.weight * near.ring.pieces[i].at(f);
        add(piece.at(f), slope, weight * piece.length() * piece.thickness);
      });
    }
    for (std::size_t b = 0; b < ring_.branches.size(); ++b) {
      const Branch& branch = ring_.branches[b];
      const double area = (branch.foot - branch.free).norm() * branch.thickness;
      simpson(8, [&](double f, double weight) {
        Vector2d slope = Vector2d::Zero();
        for (const Nearby& near : nearby_) {
          const Branch& other = near.ring.branches[b];
          slope += near.weight * (other.free + f * (other.foot - other.free));
        }
        add(branch.free + f * (branch.foot - branch.free), slope, weight * area);
      });
    }
  }

  Ring ring_;
  Eigen::Matrix3d plane_;
  std::vector<Nearby> nearby_;
  Vector3d total_;
  Eigen::RowVector3d total_change_;
  Factors closing_{};
  double whole_I_T_ = 0.0, bredt_ = 0.0;
};

// ------------------------------------------------------------------------------------- the places

/// The places of a section's walls.
class Gathering {
 public:
  Gathering(const LocalSection& section, int around) : section_(section), around_(around) {
    normal_ = plane_for(section.here, section.holes, section.flange_part, section.web_part);
    if (std::holds_alternative<Plate>(section.here.outer)) {
      add_solid();
      return;
    }
    flows_.emplace_back(section, false);
    if (section.here.inner) flows_.emplace_back(section, true);
    set_torque();
    add_walls(false);
    if (section.here.inner) add_walls(true);
  }

  std::vector<Place> places;
  const std::vector<Flow>& flows() const { return flows_; }

  /// Shear stress in a piece of a ring on its outer face: flow over thickness, and what twist adds.
  Factors shear_at(bool inner, std::size_t piece, double f) const {
    const Flow& flow = flows_[inner ? 1 : 0];
    const double t = flow.ring().pieces[piece].thickness;
    const double circulating = flow.bredt();
    // A flat wall turns with the section and adds t/I_T on its face; a round one t/(2 I_T).
    const double sign = circulating < 0.0 ? -1.0 : 1.0;
    const double face = flow.ring().pieces[piece].radius > 0.0 ? 0.5 * t : t;
    Factors tau = flow.transverse(piece, f);
    for (std::size_t k = 0; k < tau.size(); ++k) {
      tau[k] =
          (tau[k] + circulating * torque_[k]) / t + sign * face * flow.per_whole_I_T() * torque_[k];
    }
    return tau;
  }

  /// Shear flow at the mid-line.
  Factors flow_at(bool inner, std::size_t piece, double f) const {
    const Flow& flow = flows_[inner ? 1 : 0];
    Factors q = flow.transverse(piece, f);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += flow.bredt() * torque_[k];
    return q;
  }

 private:
  Place& add(const std::string& name, PlaceKind kind, double y, double z, double plate,
             const Factors& shear) {
    places.push_back({name, kind, y, z, plate, normal_at(normal_, y, z), shear, "", 0.0});
    return places.back();
  }

  /// What is left for twist. Forces that do not flow along walls are carried across them.
  void set_torque() {
    Carried carried = Carried::Zero();
    Eigen::Matrix<double, 3, 2> across = Eigen::Matrix<double, 3, 2>::Zero();
    for (const Flow& flow : flows_) {
      carried += flow.carried();
      across += flow.across();
    }
    Carried missing = -carried;
    missing(0, cut_force::V_y) += 1.0;
    missing(1, cut_force::V_z) += 1.0;
    missing(2, cut_force::T) += 1.0;
    const Eigen::Matrix2d forces = across.topRows<2>();
    const Eigen::RowVector<double, 6> left =
        missing.row(2) - across.row(2) * forces.inverse() * missing.topRows<2>();
    for (std::size_t k = 0; k < torque_.size(); ++k)
      torque_[k] = left[static_cast<Eigen::Index>(k)];
  }

  void add_walls(bool inner) {
    const Profile& profile = inner ? *section_.here.inner : section_.here.outer;
    const std::string before = inner ? "inner " : "";
    const Ring& ring = flows_[inner ? 1 : 0].ring();
    if (const auto* round = std::get_if<RoundTube>(&profile)) {
      const double radius = 0.5 * round->diameter.value();
      for (int i = 0; i < around_; ++i) {
        const double f = static_cast<double>(i) / around_, angle = 2.0 * pi * f;
        add(fmt::format("{}wall at {:.1f} deg", before, 360.0 * f), PlaceKind::fibre,
            radius * std::cos(angle), radius * std::sin(angle), round->wall.value(),
            shear_at(inner, 0, f));
      }
      return;
    }
    const Box box = *box_of(profile);
    const BoxSizes s(box);
    bool symmetric = boxbeam::is_symmetric_about_z(section_.here);
    for (const auto& [near, weight] : section_.nearby)
      symmetric = symmetric && boxbeam::is_symmetric_about_z(near);
    const bool on_face = section_.space || !symmetric;
    const auto* welded = std::get_if<Box>(&profile);
    for (const double side : {1.0, -1.0}) {
      for (const double up : {1.0, -1.0}) {
        add(fmt::format("{}corner {:+.0f} {:+.0f}", before, side, up), PlaceKind::fibre,
            side * 0.5 * s.W, up * 0.5 * s.H, up > 0.0 ? s.top : s.bottom, {});
      }
    }
    double perimeter = 2.0 * (s.W + s.H);
    for (std::size_t i = 0; i < ring.pieces.size(); ++i) {
      const Piece& piece = ring.pieces[i];
      if (!piece.solid) continue;
      const bool web = piece.name == "left" || piece.name == "right";
      const int steps = std::max(2, static_cast<int>(around_ * piece.length() / perimeter));
      for (int k = 0; k <= steps; ++k) {
        double f = static_cast<double>(k) / steps;
        if (!web) {
          // From the inner face of one web to that of the other.
          const double y = std::clamp(piece.at(f).x(), s.in_right, s.in_left);
          if (std::abs(piece.to.x() - piece.from.x()) > 0.0)
            f = (y - piece.from.x()) / (piece.to.x() - piece.from.x());
          if (f < 0.0 || f > 1.0) continue;
        }
        const Vector2d at = piece.at(f);
        double y = at.x(), z = at.y();
        if (!web) z = piece.name == "top" ? 0.5 * s.H : -0.5 * s.H;
        const bool end = web && ((k == 0 && piece.node_from != piece.from) ||
                                 (k == steps && piece.node_to != piece.to));
        if (web && (section_.space || (on_face && !end)))
          y = piece.name == "left" ? 0.5 * s.W : -0.5 * s.W;
        const PlaceKind kind = !web ? PlaceKind::fibre : (end ? PlaceKind::seam : PlaceKind::web);
        add(fmt::format("{}{} {:.3f} m", before, piece.name, web ? z : y), kind, y, z,
            piece.thickness, shear_at(inner, i, f))
            .at_flat = piece.bar && k == steps;
        if (!end || welded == nullptr) continue;
        const double a = box.seam_throat.value() > 0.0 ? box.seam_throat.value() : piece.thickness;
        Factors tau = flow_at(inner, i, f);
        for (double& each : tau) each /= a;
        const double flange = (k == 0) == (piece.name == "left") ? s.top : s.bottom;
        Place& throat = add(fmt::format("{}{} throat {:.3f} m", before, piece.name, z),
                            PlaceKind::throat, y, z, piece.thickness, tau);
        throat.normal.fill(0.0);
        throat.joined = std::max(piece.thickness, flange);
      }
    }
    add_branches(inner, before);
  }

  void add_branches(bool inner, const std::string& before) {
    const Flow& flow = flows_[inner ? 1 : 0];
    for (std::size_t b = 0; b < flow.ring().branches.size(); ++b) {
      const Branch& branch = flow.ring().branches[b];
      if (branch.foot == branch.node) continue;  // the edge of a flange, whose corner is there
      for (const double f : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vector2d at = branch.free + f * (branch.foot - branch.free);
        for (const double face : {1.0, -1.0}) {
          Factors tau = flow.in_branch(b, f);
          for (std::size_t k = 0; k < tau.size(); ++k) {
            tau[k] = tau[k] / branch.thickness +
                     face * branch.thickness * flow.per_whole_I_T() * torque_[k];
          }
          add(fmt::format("{}stiffener {:.3f} {:.3f}", before, at.x(), at.y()), PlaceKind::fibre,
              at.x(), at.y(), branch.thickness, tau);
        }
      }
    }
  }

  /// A plate: V S/(I b) with what the taper adds, over a level that keeps its part of the height,
  /// likewise across; torsion by the series along the sides.
  void add_solid() {
    const auto& plate = std::get<Plate>(section_.here.outer);
    const double b = plate.width.value(), h = plate.height.value();
    double b_change = 0.0, h_change = 0.0;
    for (const auto& [near, weight] : section_.nearby) {
      b_change += weight * std::get<Plate>(near.outer).width.value();
      h_change += weight * std::get<Plate>(near.outer).height.value();
    }
    const double thickness = std::min(b, h);
    const double I = torsion_of(b, h);
    const int steps = std::max(8, around_ / 4);
    for (int k = 0; k <= steps; ++k) {
      const double u = -1.0 + 2.0 * k / steps;
      for (const double side : {1.0, -1.0}) {
        // F beyond the level u h/2: N (1 - u)/2 + 3/2 (1 - u^2) M_y/h.
        Factors tau{};
        tau[cut_force::V_z] = 1.5 * (1.0 - u * u) / (b * h);
        tau[cut_force::M_y] = -1.5 * (1.0 - u * u) * h_change / (h * h * b);
        tau[cut_force::T] = (side < 0.0 ? -1.0 : 1.0) * series(b, h, 0.5 * u * h) / I;
        add(fmt::format("side {:+.0f} at {:.3f} m", side, 0.5 * u * h), PlaceKind::fibre,
            side * 0.5 * b, 0.5 * u * h, thickness, tau);
        if (!section_.space) continue;
        Factors across{};
        across[cut_force::V_y] = 1.5 * (1.0 - u * u) / (b * h);
        across[cut_force::M_z] = 1.5 * (1.0 - u * u) * b_change / (b * b * h);
        across[cut_force::T] = (side > 0.0 ? -1.0 : 1.0) * series(h, b, 0.5 * u * b) / I;
        add(fmt::format("face {:+.0f} at {:.3f} m", side, 0.5 * u * b), PlaceKind::fibre,
            0.5 * u * b, side * 0.5 * h, thickness, across);
      }
    }
    for (const double up : {1.0, -1.0})
      add(fmt::format("fibre {:+.0f}", up), PlaceKind::fibre, 0.0, up * 0.5 * h, thickness, {});
  }

  /// Prandtl's stress on the side x = thick/2 of a rectangle at a distance from its middle, over
  /// G theta': thick (1 - 8/pi^2 sum cosh(n pi at/thick)/(n^2 cosh(n pi wide/(2 thick)))), n odd.
  static double series(double thick, double wide, double at) {
    double sum = 0.0;
    for (int n = 1; n < 400; n += 2) {
      const double a = n * pi * std::abs(at) / thick, c = n * pi * wide / (2.0 * thick);
      sum += std::exp(a - c) * (1.0 + std::exp(-2.0 * a)) / (1.0 + std::exp(-2.0 * c)) / (n * n);
    }
    return thick * (1.0 - 8.0 / (pi * pi) * sum);
  }
  static double torsion_of(double b, double h) {
    const double thin = std::min(b, h), wide = std::max(b, h);
    double sum = 0.0;
    for (int n = 1; n < 200; n += 2)
      sum += std::tanh(n * pi * wide / (2.0 * thin)) / std::pow(n, 5);
    return thin * thin * thin * wide / 3.0 * (1.0 - 192.0 * thin / (std::pow(pi, 5) * wide) * sum);
  }

  const LocalSection& section_;
  int around_;
  Eigen::Matrix3d normal_;
  std::vector<Flow> flows_;
  Factors torque_{};
};

bool is_ring(const Profile& profile) {
  return box_of(profile).has_value() || std::holds_alternative<RoundTube>(profile);
}

}  // namespace

bool covers(const Section& section) {
  if (std::holds_alternative<Plate>(section.outer)) return !section.inner;
  return is_ring(section.outer) && (!section.inner || is_ring(*section.inner));
}

std::vector<Place> places_of(const LocalSection& section, int around) {
  return Gathering(section, around).places;
}

Plane plane_of(const LocalSection& section, bool with_holes, bool with_shear_lag) {
  const Eigen::Matrix3d of = plane_for(
      section.here, with_holes ? section.holes : std::vector<Hole>{},
      with_shear_lag ? section.flange_part : 1.0, with_shear_lag ? section.web_part : 1.0);
  Plane plane;
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (Eigen::Index j = 0; j < 3; ++j)
      plane.of[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] = of(j, k);
  }
  return plane;
}

std::vector<HoleCentre> centres_of(const LocalSection& section, const Hole& hole) {
  const auto box = box_of(section.here.outer);
  if (!box) return {};
  const BoxSizes s(*box);
  LocalSection gross = section;
  gross.holes.clear();
  const Gathering gathering(gross, 8);
  const Eigen::Matrix3d gross_plane = plane_for(section.here, {}, 1.0, 1.0);
  const Eigen::Matrix3d net_plane = plane_for(section.here, section.holes, 1.0, 1.0);
  std::vector<HoleCentre> centres;
  const auto add = [&](const std::string& wall, double y, double z) {
    const bool web = wall == "left" || wall == "right";
    const std::vector<Piece>& pieces = gathering.flows().front().ring().pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i];
      if (piece.name != wall) continue;
      const double from = web ? piece.from.y() : piece.from.x(),
                   to = web ? piece.to.y() : piece.to.x();
      const double f = ((web ? z : y) - from) / (to - from);
      if (f < 0.0 || f > 1.0) continue;
      HoleCentre centre{
          wall, y,  z, piece.thickness, web, web ? s.in_top - s.in_bottom : s.in_left - s.in_right,
          {},   {}, {}};
      centre.normal = normal_at(gross_plane, y, z);
      centre.shear = gathering.shear_at(false, i, f);
      const Eigen::Index row = web ? 2 : 1;
      centre.gradient[cut_force::N] = gross_plane(row, 0);
      centre.gradient[cut_force::M_y] = net_plane(row, 1);
      centre.gradient[cut_force::M_z] = net_plane(row, 2);
      centres.push_back(centre);
      return;
    }
  };
  const double at = hole.position.value();
  if (hole.walls == HoleWalls::webs) {
    add("left", section.space ? 0.5 * s.W : s.y_left, at);
    add("right", section.space ? -0.5 * s.W : s.y_right, at);
    return centres;
  }
  for (const double side : at > 0.0 ? std::vector{1.0, -1.0} : std::vector{1.0}) {
    add("top", side * at, 0.5 * s.H);
    add("bottom", side * at, -0.5 * s.H);
  }
  return centres;
}

}  // namespace oracle
