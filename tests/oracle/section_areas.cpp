#include "section_areas.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace oracle {

using boxbeam::Box;
using boxbeam::BoxPlate;
using boxbeam::Hole;
using boxbeam::HoleWalls;
using boxbeam::Profile;
using boxbeam::RectangularTube;
using boxbeam::RoundTube;
using boxbeam::Section;
using boxbeam::Stiffener;
namespace cut_force = boxbeam::cut_force;

namespace {

constexpr double pi = std::numbers::pi;

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
    const auto& plate = std::get<boxbeam::Plate>(profile);
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

}  // namespace

std::optional<Box> box_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) return *box;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    if (tube->outer_radius.value() > 0.0) return std::nullopt;
    return Box{tube->width, tube->height, tube->wall, tube->wall, tube->wall, tube->wall, {}, {}};
  }
  return std::nullopt;
}

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

}  // namespace oracle
