#include "section_stress.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "section_areas.hpp"
#include "shear_flow.hpp"

namespace oracle {
namespace {

using boxbeam::Box;
using boxbeam::BoxPlate;
using boxbeam::Hole;
using boxbeam::HoleWalls;
using boxbeam::Plate;
using boxbeam::Profile;
using boxbeam::RoundTube;
using boxbeam::Section;
namespace cut_force = boxbeam::cut_force;

using boxbeam::PlateKind;

constexpr double pi = std::numbers::pi;

/// The plate of a welded box that a piece of its ring is.
PlateKind kind_of(const std::string& piece, bool inner, bool welded) {
  if (inner) return PlateKind::inner;
  if (!welded) return PlateKind::wall;
  return piece == "top"      ? PlateKind::top_flange
         : piece == "bottom" ? PlateKind::bottom_flange
         : piece == "left"   ? PlateKind::left_web
                             : PlateKind::right_web;
}

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
    Place& place = places.emplace_back();
    place.name = name;
    place.kind = kind;
    place.y = y;
    place.z = z;
    place.plate = plate;
    place.normal = normal_at(normal_, y, z);
    place.shear = shear;
    return place;
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
            shear_at(inner, 0, f))
            .wall = inner ? PlateKind::inner : PlateKind::wall;
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
        Place& corner =
            add(fmt::format("{}corner {:+.0f} {:+.0f}", before, side, up), PlaceKind::fibre,
                side * 0.5 * s.W, up * 0.5 * s.H, up > 0.0 ? s.top : s.bottom, {});
        corner.wall = kind_of(up > 0.0 ? "top" : "bottom", inner, welded != nullptr);
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
        const PlateKind wall = kind_of(piece.name, inner, welded != nullptr);
        const bool up = (k == 0) == (piece.name == "left");
        const double flange = up ? s.top : s.bottom;
        const PlateKind flange_kind = kind_of(up ? "top" : "bottom", inner, welded != nullptr);
        const auto join = [&](Place& of) {
          of.beside = flange_kind;
          of.beside_plate = flange;
        };
        Place& here = add(fmt::format("{}{} {:.3f} m", before, piece.name, web ? z : y), kind, y, z,
                          piece.thickness, shear_at(inner, i, f));
        here.at_flat = piece.bar && k == steps;
        here.wall = wall;
        if (end) join(here);
        if (!end || welded == nullptr) continue;
        const double a = box.seam_throat.value() > 0.0 ? box.seam_throat.value() : piece.thickness;
        Factors tau = flow_at(inner, i, f);
        for (double& each : tau) each /= a;
        Place& throat = add(fmt::format("{}{} throat {:.3f} m", before, piece.name, z),
                            PlaceKind::throat, y, z, piece.thickness, tau);
        throat.normal.fill(0.0);
        throat.joined = std::max(piece.thickness, flange);
        throat.wall = wall;
        join(throat);
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
              at.x(), at.y(), branch.thickness, tau)
              .wall = PlateKind::stiffener;
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
          wall, y,
          z,    piece.thickness,
          web,  web ? s.in_top - s.in_bottom : s.in_left - s.in_right,
          {},   {},
          {},   kind_of(wall, false, std::holds_alternative<Box>(section.here.outer))};
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
