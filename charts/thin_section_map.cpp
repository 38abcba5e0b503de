#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "boxbeam/section/section_defect.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "charts/digits_left.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

/// A box of one wall, its sizes in long double: 1 wide.
struct ThinBox {
  long double H, t;  ///< height and wall

  Section section() const {
    const auto wall = si<Length>(static_cast<double>(t));
    return {symmetric_box(si<Length>(1.0), si<Length>(static_cast<double>(H)), wall, wall), {}};
  }
};

/// Sums of the four plates, where nothing cancels.
struct ClosedForm {
  long double area, I_y, I_z, S;  ///< S of the half beyond z = 0
};

ClosedForm closed_form_of(const ThinBox& box) {
  const long double H = box.H, t = box.t;
  const long double h = H - 2 * t, b = 1.0L - 2 * t;
  ClosedForm form{};
  form.area = 2 * t + 2 * t * h;
  form.I_y = t * (H - t) * (H - t) / 2 + t * t * t / 6 + t * h * h * h / 6;
  form.I_z = t * H * (1.0L - t) * (1.0L - t) / 2 + H * t * t * t / 6 + t * b * b * b / 6;
  form.S = t * (H - t) / 2 + t * h * h / 4;
  return form;
}

/// I_T = J_0 + 4 (A_h + W)^2/C for four equal corners. Their shares are those of a square corner.
long double torsion_constant_of(const ThinBox& box) {
  const long double t = box.t;
  const long double h = box.H - 2 * t, b = 1.0L - 2 * t;
  constexpr long double pi = 3.141592653589793238462643L;
  const long double C = 2 * (h + b) / t + 4 * (1.0L - 2 * std::log(2.0L) / pi);
  const long double W = t * (h + b) + 4 * t * t * 0.144829L;
  const long double J = 2 * (h + b) * t * t * t / 3 + 4 * t * t * t * t * 0.406273L;
  const long double enclosed = h * b + W;
  return J + 4 * enclosed * enclosed / C;
}

/// Bredt's formula on mid-lines.
long double bredt_of(const ThinBox& box) {
  const long double h = box.H - box.t, b = 1.0L - box.t;
  return 2 * h * h * b * b * box.t / (h + b);
}

double properties_error(const ThinBox& box) {
  const SectionProperties found = properties_of(box.section());
  const ClosedForm exact = closed_form_of(box);
  return std::max({relative_error(found.area.value(), exact.area),
                   relative_error(found.I_y.value(), exact.I_y),
                   relative_error(found.I_z.value(), exact.I_z),
                   relative_error(found.W_y.value(), 2 * exact.I_y / box.H),
                   relative_error(found.W_z.value(), 2 * exact.I_z)});
}

double torsion_error(const ThinBox& box) {
  return relative_error(torsion_properties_of(box.section()).I_T->value(),
                        torsion_constant_of(box));
}

/// Shear at the neutral axis: V S/(2 I t).
double shear_error(const ThinBox& box) {
  const StressField field = stress_field_of(box.section(), {}, {});
  const auto points = points_at_level(field, "", Length{}, PointSet::in_plane);
  const ClosedForm exact = closed_form_of(box);
  return relative_error(points.at(0).influence.shear[cut_force::V_z],
                        exact.S / (2 * exact.I_y * box.t));
}

double bredt_error(const ThinBox& box) {
  return relative_error(static_cast<double>(bredt_of(box)), torsion_constant_of(box));
}

MapPanel panel_of(std::string method, const std::function<double(const ThinBox&)>& error,
                  bool yardstick) {
  MapPanel panel;
  panel.method = std::move(method);
  panel.yardstick = yardstick;
  for (int j = -6; j <= 6; ++j) {
    for (int i = -12; i <= -1; ++i) {
      const double x = std::pow(10.0, i), y = std::pow(10.0, j);
      // The section's own doubles are the truth, not the powers of ten that they come from.
      const ThinBox box{static_cast<long double>(y), static_cast<long double>(x)};
      if (const auto defect = defect_of(box.section())) {
        panel.cells.push_back({x, y, Outcome::refused, {}, *defect});
      } else {
        panel.cells.push_back(digits_cell(x, y, error(box)));
      }
    }
  }
  return panel;
}

double fewest_digits(const MapPanel& panel) {
  double fewest = most_digits;
  for (const Cell& cell : panel.cells) fewest = std::min(fewest, cell.value.value_or(most_digits));
  return fewest;
}

}  // namespace

Map thin_section_map(const Scenes&, const Effort&) {
  Map map;
  map.name = "stability-thin-section";
  map.title = "Thin walls: digits left of section properties";
  map.scene = "a box of one wall, its height and its wall over its width";
  map.reference = "sums over the four plates and Prandtl's torsion formula, long double";
  map.x.title = "wall over width";
  map.y.title = "height over width";
  map.value = "digits left";
  map.panels.push_back(panel_of("A, I and W, along the border", properties_error, false));
  map.panels.push_back(panel_of("torsion constant", torsion_error, false));
  map.panels.push_back(panel_of("shear at the neutral axis", shear_error, false));
  map.panels.push_back(panel_of("torsion constant, Bredt on mid-lines", bredt_error, true));
  map.lesson = fmt::format(
      "Where the wall is a millionth of a millionth of the width, the difference of outer and "
      "inner rectangle leaves {:.0f} digits; no wall that can be made comes near that. Bredt's "
      "mid-lines, by contrast, are more than 0.1 % off in {} of {} boxes that can be made.",
      std::floor(std::min({fewest_digits(map.panels[0]), fewest_digits(map.panels[1]),
                           fewest_digits(map.panels[2])})),
      map.panels[3].count(Outcome::wrong),
      map.panels[3].cells.size() - map.panels[3].count(Outcome::refused));
  return map;
}

}  // namespace boxbeam::charts
