#include "boxbeam/section/torsion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/section/wall_cells.hpp"

namespace boxbeam {
namespace {

using std::numbers::pi;

/// What a corner between plates of thickness 1 and `ratio` <= 1 adds beyond the straight walls from
/// its inner edge on: W and J_0 by a finite-element solution (bilinear elements of 1/40 and 1/80 of
/// the thicker plate, extrapolated at the order 4/3 of the re-entrant corner).
struct CornerShare {
  double ratio, W, J;
};
constexpr std::array<CornerShare, 7> corner_table{{{0.2, -0.051567, -0.036935},
                                                   {0.3, -0.016926, -0.000174},
                                                   {0.4, 0.014230, 0.040216},
                                                   {0.5, 0.042380, 0.085377},
                                                   {0.6, 0.067811, 0.136230},
                                                   {0.8, 0.111127, 0.257459},
                                                   {1.0, 0.144829, 0.406273}}};

struct Corner {
  double C, W, J;
};

Corner corner_of(double a, double b) {
  const double thick = std::max(a, b);
  const double r = std::clamp(std::min(a, b) / thick, corner_table.front().ratio, 1.0);
  std::size_t i = 0;
  while (i + 2 < corner_table.size() && r > corner_table[i + 1].ratio) ++i;
  const CornerShare& low = corner_table[i];
  const CornerShare& high = corner_table[i + 1];
  const double part = (r - low.ratio) / (high.ratio - low.ratio);
  const double squares = a * a + b * b;
  const double C = (std::log(squares / (4.0 * b * b)) + 2.0 * b / a * std::atan(a / b) +
                    std::log(squares / (4.0 * a * a)) + 2.0 * a / b * std::atan(b / a)) /
                   pi;
  return {C, thick * thick * (low.W + part * (high.W - low.W)),
          thick * thick * thick * thick * (low.J + part * (high.J - low.J))};
}

double cube(double x) { return x * x * x; }

constexpr double zeta_5 = 1.036927755143369926;   // sum of 1/n^5
constexpr double catalan = 0.915965594177219015;  // 1 - 1/3^2 + 1/5^2 - ...

/// 1 - tanh x, without loss of digits.
double short_of_one(double x) { return 2.0 / (std::exp(2.0 * x) + 1.0); }

struct RolledMidLine {
  double length, area;
};

RolledMidLine rolled_mid_line(const RectangularTube& tube) {
  const double t = tube.wall.value();
  const double B = tube.width.value() - t, H = tube.height.value() - t;
  const double R = 0.5 * (tube.outer_radius + tube.inner_radius).value();
  return {2.0 * (B + H) - 2.0 * R * (4.0 - pi), B * H - R * R * (4.0 - pi)};
}

double torsion_constant(const ThinWalled& path) {
  const WallGraph graph = *wall_graph_of({path, {}}, {});
  const WallCells cells = wall_cells_of(graph);
  const Eigen::VectorXd flows = flows_per_twist(cells);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    sum += 2.0 * cells.cells[i].area * flows[static_cast<Eigen::Index>(i)];
  }
  for (const Wall& wall : graph.walls) sum += length_of(wall) * cube(wall.thickness) / 3.0;
  return sum;
}

Box box_of(const RectangularTube& sharp) {
  return symmetric_box(sharp.width, sharp.height, sharp.wall, sharp.wall);
}

}  // namespace

SecondMoment torsion_constant_of_rectangle(Length a, Length b) {
  const double thin = std::min(a, b).value(), wide = std::max(a, b).value();
  // The sum of 1/n^5 over odd n, less what tanh falls short of 1.
  double sum = 31.0 / 32.0 * zeta_5;
  for (int n = 1; n < 16; n += 2) sum -= short_of_one(0.5 * n * pi * wide / thin) / std::pow(n, 5);
  const double I = cube(thin) * wide / 3.0 * (1.0 - 192.0 * thin / (std::pow(pi, 5) * wide) * sum);
  return si<SecondMoment>(I);
}

double torsion_shear_of_rectangle(Length side, Length other) {
  const double I = torsion_constant_of_rectangle(side, other).value();
  const double h = side.value(), b = other.value();
  double sum = 0.0;
  if (h < b) {
    // tau = G theta' h 8/pi^2 sum (-1)^((n-1)/2) tanh(n pi b/(2 h))/n^2, in the middle of the side
    // h: the series that converges fast where that side is the short one.
    sum = catalan;
    for (int n = 1; n < 16; n += 2) {
      const double term = short_of_one(0.5 * n * pi * b / h) / (static_cast<double>(n) * n);
      sum -= n % 4 == 1 ? term : -term;
    }
    return h / I * 8.0 / (pi * pi) * sum;
  }
  // tau = G theta' b (1 - 8/pi^2 sum 1/(n^2 cosh(n pi h/(2 b)))).
  for (int n = 1; n < 32; n += 2) {
    sum += 1.0 / (static_cast<double>(n) * n * std::cosh(std::min(0.5 * n * pi * h / b, 700.0)));
  }
  return b / I * (1.0 - 8.0 / (pi * pi) * sum);
}

/// A lower bound for walls of any thickness: Prandtl's stress function is the maximiser of
/// (2 V)^2/(integral of its squared slope), and a frustum that rises over each plate to the hollow
/// is one of those it is compared with,
///
///     I_T >= 4 V^2/sum(s/t),  V = hollow + sum t (outer/6 + inner/3)
///
/// s  mean of a plate's outer and inner length. Source: Timoshenko, Goodier, Theory of Elasticity
/// (1970), art. 111.
double least_torsion_constant(const Box& box, const double (&t)[4], double width, double height) {
  const double outer[4] = {box.height.value(), box.width.value(), box.height.value(),
                           box.width.value()};
  const double inner[4] = {height, width, height, width};
  double volume = width * height;
  double slopes = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    volume += t[k] * (outer[k] / 6.0 + inner[k] / 3.0);
    slopes += 0.5 * (outer[k] + inner[k]) / t[k];
  }
  return 4.0 * volume * volume / slopes;
}

SecondMoment torsion_constant_of_box(const Box& box) {
  const double t[4] = {box.right_web.value(), box.top_flange.value(), box.left_web.value(),
                       box.bottom_flange.value()};
  const double width = box.width.value() - t[0] - t[2];
  const double height = box.height.value() - t[1] - t[3];
  double C = 0.0, W = 0.0, J = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double s = k % 2 == 0 ? height : width;
    const Corner corner = corner_of(t[k], t[(k + 1) % 4]);
    C += s / t[k] + corner.C;
    W += 0.5 * s * t[k] + corner.W;
    J += s * cube(t[k]) / 3.0 + corner.J;
  }
  const double enclosed = width * height + W;
  // Where a plate is hardly longer than its neighbours are thick, the corners meet and what they
  // add is no longer known.
  double I =
      std::max(J + 4.0 * enclosed * enclosed / C, least_torsion_constant(box, t, width, height));
  for (const Stiffener& bar : box.stiffeners) {
    I += bar.depth.value() * cube(bar.thickness.value()) / 3.0;
  }
  return si<SecondMoment>(I);
}

std::optional<SecondMoment> torsion_constant_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) return torsion_constant_of_box(*box);
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    if (tube->outer_radius.value() == 0.0) return torsion_constant_of_box(box_of(*tube));
    const auto [length, area] = rolled_mid_line(*tube);
    const double t = tube->wall.value();
    return si<SecondMoment>(cube(t) * length / 3.0 + 4.0 * area * area * t / length);
  }
  if (const auto* tube = std::get_if<RoundTube>(&profile)) {
    const double outer = tube->diameter.value();
    const double inner = outer - 2.0 * tube->wall.value();
    return si<SecondMoment>(pi / 32.0 * (std::pow(outer, 4) - std::pow(inner, 4)));
  }
  if (const auto* plate = std::get_if<Plate>(&profile)) {
    return torsion_constant_of_rectangle(plate->width, plate->height);
  }
  if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    return si<SecondMoment>(torsion_constant(*path));
  }
  return std::nullopt;
}

Area enclosed_area_of(const Profile& profile) {
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    return si<Area>(rolled_mid_line(*tube).area);
  }
  const auto graph = wall_graph_of({profile, {}}, {});
  double area = 0.0;
  if (graph) {
    for (const Cell& cell : wall_cells_of(*graph).cells) area += cell.area;
  }
  return si<Area>(area);
}

std::optional<SecondMoment> torsion_constant_of(const Section& section) {
  auto outer = torsion_constant_of(section.outer);
  if (!outer || !section.inner) return outer;
  const auto inner = torsion_constant_of(*section.inner);
  return inner ? std::optional(*outer + *inner) : std::nullopt;
}

TorsionProperties torsion_properties_of(const Section& section) {
  TorsionProperties result;
  result.I_T = torsion_constant_of(section);
  result.enclosed = enclosed_area_of(section.outer);
  result.shear_centre = shear_centre_of(section);
  return result;
}

}  // namespace boxbeam
