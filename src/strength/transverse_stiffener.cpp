#include "boxbeam/strength/transverse_stiffener.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {

SecondMoment rigid_stiffener_inertia(Length depth, Length thickness, Length length) {
  const double h_w = depth.value(), t = thickness.value(), a = length.value();
  return si<SecondMoment>(a < std::numbers::sqrt2 * h_w ? 1.5 * std::pow(h_w * t, 3) / (a * a)
                                                        : 0.75 * h_w * std::pow(t, 3));
}

SecondMoment holding_stiffener_inertia(const HeldPlate& plate, Length e_max, Stress yield_strength,
                                       double gamma_M1) {
  constexpr double E = 210e9, pi = std::numbers::pi;
  const double b = plate.width.value(), a_1 = plate.before.value(), a_2 = plate.behind.value();
  const double sigma_m = plate.compression.value() / b * (1.0 / a_1 + 1.0 / a_2);
  const double u =
      std::max(1.0, pi * pi * E * e_max.value() * gamma_M1 / (yield_strength.value() * 300.0 * b));
  const double w_0 = std::min({a_1, a_2, b}) / 300.0;
  return si<SecondMoment>(sigma_m / E * std::pow(b / pi, 4) * (1.0 + w_0 * 300.0 / b * u));
}

Length working_width_of(Length beside, Length thickness, Stress yield_strength, bool whole) {
  const double epsilon = epsilon_of(yield_strength), ratio = beside / thickness;
  const double part =
      whole ? internal_reduction(
                  relative_plate_slenderness(2.0 * ratio, epsilon, *internal_buckling_factor(1.0)),
                  1.0)
            : outstand_reduction(relative_plate_slenderness(
                  ratio, epsilon, *outstand_buckling_factor(1.0, LargestCompression::at_tip)));
  return part * beside;
}

std::optional<Length> least_panel_length_of(const BearingStiffener& stiffener) {
  const double h_w = stiffener.web_depth.value(), t = stiffener.web_thickness.value();
  const double I = stiffener_inertia(stiffener).value(), long_panel = std::numbers::sqrt2 * h_w;
  if (I < rigid_stiffener_inertia(stiffener.web_depth, stiffener.web_thickness,
                                  si<Length>(2.0 * long_panel))
              .value())
    return std::nullopt;
  return si<Length>(std::min(long_panel, std::sqrt(1.5 * std::pow(h_w * t, 3) / I)));
}

std::string rigidity_obstacle(const BearingStiffener& stiffener, Length panel_length) {
  const SecondMoment there = stiffener_inertia(stiffener);
  const SecondMoment least =
      rigid_stiffener_inertia(stiffener.web_depth, stiffener.web_thickness, panel_length);
  if (there >= least) return "";
  return fmt::format("I = {:.4g} mm^4 beside the web is below {:.4g} mm^4 (9.3.3(3))",
                     1e12 * there.value(), 1e12 * least.value());
}

SecondMoment stiffener_inertia(const BearingStiffener& flats) {
  const double t = flats.web_thickness.value(), b = flats.width.value();
  const double t_s = flats.thickness.value(), most = 15.0 * epsilon_of(flats.yield_strength) * t;
  const double strip =
      std::min(flats.web_before.value(), most) + std::min(flats.web_behind.value(), most) + t_s;
  const double web = strip * t, flat = b * t_s, out = 0.5 * (t + b);
  const double own = strip * std::pow(t, 3) / 12.0, of_flat = t_s * std::pow(b, 3) / 12.0;
  if (flats.both_sides) return si<SecondMoment>(own + 2.0 * (of_flat + flat * out * out));
  // Of two areas about the centroid of both.
  return si<SecondMoment>(own + of_flat + web * flat / (web + flat) * out * out);
}

}  // namespace boxbeam
