#include "boxbeam/strength/box_distortion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "gauss_rule.hpp"
#include "path_cell.hpp"

namespace boxbeam {
namespace {

using AtCorners = Eigen::Vector4d;

/// A plate of a cell from a corner to the next one around it.
struct CellPlate {
  BoxPlate plate;
  bool web;
};

constexpr std::array around{
    CellPlate{BoxPlate::left_web, true}, CellPlate{BoxPlate::bottom_flange, false},
    CellPlate{BoxPlate::right_web, true}, CellPlate{BoxPlate::top_flange, false}};

constexpr Eigen::Index next_corner(std::size_t corner) {
  return static_cast<Eigen::Index>((corner + 1) % 4);
}

double thickness_of(const BoxCell& cell, BoxPlate plate) {
  return cell.thickness[static_cast<std::size_t>(plate)].value();
}

double length_of(const BoxCell& cell, const CellPlate& plate) {
  return (plate.web ? cell.height : cell.width).value();
}

/// The integral of f g over the plates, both linear along each.
double product(const BoxCell& cell, const AtCorners& f, const AtCorners& g) {
  double sum = 0.0;
  for (std::size_t p = 0; p < 4; ++p) {
    const auto i = static_cast<Eigen::Index>(p), j = next_corner(p);
    const double area = length_of(cell, around[p]) * thickness_of(cell, around[p].plate);
    sum += area / 6.0 * (2.0 * f[i] * g[i] + f[i] * g[j] + f[j] * g[i] + 2.0 * f[j] * g[j]);
  }
  return sum;
}

AtCorners warping_of(const BoxCell& cell) {
  const double y = 0.5 * cell.width.value(), z = 0.5 * cell.height.value();
  Eigen::Matrix<double, 4, 3> plane;
  plane << 1.0, y, z, 1.0, y, -z, 1.0, -y, -z, 1.0, -y, z;
  const AtCorners yz = plane.col(1).cwiseProduct(plane.col(2));
  Eigen::Matrix3d products;
  Eigen::Vector3d with_yz;
  for (Eigen::Index i = 0; i < 3; ++i) {
    with_yz[i] = product(cell, plane.col(i), yz);
    for (Eigen::Index j = 0; j < 3; ++j) products(i, j) = product(cell, plane.col(i), plane.col(j));
  }
  return yz - plane * products.fullPivLu().solve(with_yz);
}

/// The flow of distortion and what the cell is worth in shear by it.
struct ShearOfDistortion {
  double stiffness = 0.0;
  std::array<double, 4> flow{};  ///< at the corners
};

/// Along a plate, of Q = 1, beyond what it is at its start.
double flow_along(const BoxCell& cell, const CellDistortion& of, std::size_t plate, double part) {
  const double from = of.warping[plate], to = of.warping[(plate + 1) % 4];
  const double per = -2.0 * thickness_of(cell, around[plate].plate) *
                     length_of(cell, around[plate]) / of.warping_inertia;
  return per * part * (from + 0.5 * part * (to - from));
}

/// S: of M_D' = 1 the shear flow q' = -2 t omega/I_w around the cell, plus what leaves no torque.
ShearOfDistortion shear_of(const BoxCell& cell, const CellDistortion& warped, double G) {
  const double lever_web = 0.5 * cell.width.value(), lever_flange = 0.5 * cell.height.value();
  double start = 0.0, torque = 0.0, by_flow = 0.0, by_even = 0.0, even = 0.0;
  ShearOfDistortion of;
  for (std::size_t p = 0; p < 4; ++p) {
    const double L = length_of(cell, around[p]), t = thickness_of(cell, around[p].plate);
    of.flow[p] = start;
    for (std::size_t g = 0; g < gauss_place.size(); ++g) {
      const double q = start + flow_along(cell, warped, p, gauss_place[g]);
      const double length = gauss_weight[g] * L;
      torque += length * q * (around[p].web ? lever_web : lever_flange);
      by_flow += length * q * q / (G * t);
      by_even += length * q / (G * t);
      even += length / (G * t);
    }
    start += flow_along(cell, warped, p, 1.0);
  }
  const double added = -torque / (2.0 * cell.width.value() * cell.height.value());
  of.stiffness = 1.0 / (by_flow + 2.0 * added * by_even + added * added * even);
  for (double& q : of.flow) q += added;
  return of;
}

/// Moments at the ends of the webs when the cell is racked by gamma = 1.
AtCorners moments_of(const BoxCell& cell, double E, double nu) {
  Eigen::Matrix4d turning = Eigen::Matrix4d::Zero();
  AtCorners racked = AtCorners::Zero();
  std::array<double, 4> stiffness;  // 2 D/L
  for (std::size_t p = 0; p < 4; ++p) {
    const auto i = static_cast<Eigen::Index>(p), j = next_corner(p);
    const double D =
        E * std::pow(thickness_of(cell, around[p].plate), 3) / (12.0 * (1.0 - nu * nu));
    const double k = stiffness[p] = 2.0 * D / length_of(cell, around[p]);
    turning(i, i) += 2.0 * k;
    turning(j, j) += 2.0 * k;
    turning(i, j) += k;
    turning(j, i) += k;
    if (!around[p].web) continue;
    racked[i] += 3.0 * k;
    racked[j] += 3.0 * k;
  }
  const AtCorners turns = turning.ldlt().solve(racked);
  AtCorners moments;
  for (const std::size_t p : {std::size_t{0}, std::size_t{2}}) {
    const auto i = static_cast<Eigen::Index>(p), j = next_corner(p);
    moments[i] = stiffness[p] * (3.0 - 2.0 * turns[i] - turns[j]);
    moments[j] = stiffness[p] * (3.0 - 2.0 * turns[j] - turns[i]);
  }
  return moments;
}

/// Of a path: in its corners both plates, as far as each of them is thick; of what leads a plate
/// on, parts below 0 and above 1, for omega goes on as it is along the plate. What the plate bends
/// is less there than so.
std::vector<CellPlace> places_in(const PathCell& of, Length y, Length z) {
  using enum BoxPlate;
  const Length near = 1e-9 * (of.cell.width + of.cell.height);
  const auto in = [&](Length from, BoxPlate plate) {
    return abs(from) <= 0.5 * of.cell.thickness[static_cast<std::size_t>(plate)] + near;
  };
  const bool left = in(of.left - y, left_web), right = in(y - of.right, right_web);
  const bool top = in(of.top - z, top_flange), bottom = in(z - of.bottom, bottom_flange);
  if ((left || right) && (top || bottom)) {
    const std::size_t corner = left ? (top ? 0 : 1) : (top ? 3 : 2);
    return {{corner, 0.0}, {(corner + 3) % 4, 1.0}};
  }
  const double down = ((of.top - z) / of.cell.height).value();
  const double across = ((of.left - y) / of.cell.width).value();
  if (left) return {{0, down}};
  if (bottom) return {{1, across}};
  if (right) return {{2, 1.0 - down}};
  if (top) return {{3, 1.0 - across}};
  return {};
}

}  // namespace

std::optional<BoxCell> box_cell_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    return BoxCell{box->width - 0.5 * (box->left_web + box->right_web),
                   box->height - 0.5 * (box->top_flange + box->bottom_flange),
                   {box->top_flange, box->bottom_flange, box->left_web, box->right_web}};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const Length t = tube->wall;
    return BoxCell{tube->width - t, tube->height - t, {t, t, t, t}};
  }
  if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    if (const auto of = path_cell_of(*path)) return of->cell;
  }
  return std::nullopt;
}

std::vector<CellPlace> places_in_cell(const Profile& profile, Length y, Length z) {
  const std::optional<BoxCell> cell = box_cell_of(profile);
  if (!cell) return {};
  if (const auto* path = std::get_if<ThinWalled>(&profile))
    return places_in(*path_cell_of(*path), y, z);
  const auto t = [&](BoxPlate plate) { return thickness_of(*cell, plate); };
  const auto* const tube = std::get_if<RectangularTube>(&profile);
  const double round = tube != nullptr ? tube->outer_radius.value() : 0.0;
  const Extent extent = extent_of(profile);
  constexpr double round_off = 1e-9;
  // How far a place lies inside the outer face of each plate.
  const double left = (extent.y_high - y).value(), right = (y - extent.y_low).value();
  const double top = (extent.z_high - z).value(), bottom = (z - extent.z_low).value();
  const auto in = [&](double depth, BoxPlate plate) { return depth <= t(plate) + round_off; };
  const auto near = [&](double depth, BoxPlate plate) {
    return depth <= std::max(t(plate), round) + round_off;
  };
  using enum BoxPlate;
  const bool by_left = near(left, left_web), by_right = near(right, right_web);
  const bool by_top = near(top, top_flange), by_bottom = near(bottom, bottom_flange);
  if ((by_left || by_right) && (by_top || by_bottom)) {
    const std::size_t corner = by_left ? (by_top ? 0 : 1) : (by_top ? 3 : 2);
    return {{corner, 0.0}, {(corner + 3) % 4, 1.0}};
  }
  const double b = cell->width.value(), h = cell->height.value();
  const auto part = [&](double depth, BoxPlate from, double length) {
    return std::clamp((depth - 0.5 * t(from)) / length, 0.0, 1.0);
  };
  if (in(left, left_web)) return {{0, part(top, top_flange, h)}};
  if (in(bottom, bottom_flange)) return {{1, part(left, left_web, b)}};
  if (in(right, right_web)) return {{2, part(bottom, bottom_flange, h)}};
  if (in(top, top_flange)) return {{3, part(right, right_web, b)}};
  return {};
}

DistortionInfluence distortion_at(const BoxCell& cell, const CellDistortion& of,
                                  const CellPlace& place) {
  const std::size_t next = (place.plate + 1) % 4;
  const double t = thickness_of(cell, around[place.plate].plate);
  DistortionInfluence at;
  at.along =
      2.0 * std::lerp(of.warping[place.plate], of.warping[next], place.part) / of.warping_inertia;
  // Nothing bends what leads a plate on and ends freely.
  if (place.part >= 0.0 && place.part <= 1.0)
    at.moment = std::abs((1.0 - place.part) * of.corner_moments[place.plate] -
                         place.part * of.corner_moments[next]);
  at.across = 6.0 * at.moment / (t * t);
  at.flow = of.flow[place.plate] + flow_along(cell, of, place.plate, place.part);
  at.shear = at.flow / t;
  at.thickness = si<Length>(t);
  return at;
}

DistortionInfluence DistortionInfluence::in_throat(Length throat) const {
  const double a = throat.value();
  return {0.0, moment, 6.0 * moment / (a * a), flow, flow / a, throat};
}

CellDistortion cell_distortion_of(const BoxCell& cell, double E, double nu) {
  const AtCorners warping = warping_of(cell), moments = moments_of(cell, E, nu);
  CellDistortion of;
  of.warping_inertia = product(cell, warping, warping);
  // The work of the racked webs: corners turn without any, for moments there are in balance.
  of.frame_stiffness = moments.sum();
  of.decay = std::pow(of.frame_stiffness / (E * of.warping_inertia), 0.25);
  std::copy(warping.begin(), warping.end(), of.warping.begin());
  std::copy(moments.begin(), moments.end(), of.corner_moments.begin());
  const ShearOfDistortion shear = shear_of(cell, of, 0.5 * E / (1.0 + nu));
  of.shear_stiffness = shear.stiffness;
  of.flow = shear.flow;
  return of;
}

double diaphragm_stiffness(const BoxCell& cell, Length thickness, Length opening, double E,
                           double nu) {
  const double b = cell.width.value(), h = cell.height.value(), t = thickness.value();
  const double G = 0.5 * E / (1.0 + nu), o = opening.value();
  if (o <= 0.0) return G * t * b * h;
  if (o >= std::min(b, h)) return 0.0;
  const double beside = 0.5 * (b - o), above = 0.5 * (h - o);
  double per_moment = 0.0;
  const auto add = [&](double length, double depth) {
    const double I = t * depth * depth * depth / 12.0, A_s = 5.0 / 6.0 * t * depth;
    per_moment += length / (6.0 * E * I) + 2.0 / (length * G * A_s);
  };
  add(h - above, beside);
  add(b - beside, above);
  return 4.0 / per_moment;
}

double Distortion::warping_stress(std::size_t node, const CellDistortion& cell,
                                  CellCorner corner) const {
  return 2.0 * moment[node] * cell.warping[static_cast<std::size_t>(corner)] / cell.warping_inertia;
}

double Distortion::frame_stress(std::size_t node, const CellDistortion& cell, const BoxCell& of,
                                CellCorner corner) const {
  const auto i = static_cast<std::size_t>(corner);
  const double t =
      std::min(thickness_of(of, around[i].plate), thickness_of(of, around[(i + 3) % 4].plate));
  return 6.0 * std::abs(angle[node] * cell.corner_moments[i]) / (t * t);
}

}  // namespace boxbeam
