#include "boxbeam/strength/stiffened_plate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "boxbeam/strength/section_class.hpp"
#include "out_of_plate.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {

bool resists_torsional_buckling(const FlatStiffener& flat, Stress yield_strength) {
  const double d = flat.depth.value(), t = flat.thickness.value();
  const double I_T = d * t * t * t / 3.0;
  const double I_p = d * d * d * t / 3.0 + d * t * t * t / 12.0;
  return I_T / I_p >= 5.3 * yield_strength / stiffened::youngs_modulus;
}

double relative_stiffness(const StiffenedPlate& plate) {
  const double t = plate.thickness.value(), b = (plate.high - plate.low).value();
  const std::vector<FlatStiffener>& all = plate.stiffeners;
  double sum = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Length low = k == 0 ? plate.low : all[k - 1].place;
    const Length high = k + 1 == all.size() ? plate.high : all[k + 1].place;
    OutOfPlate of;
    of.add_plate(0.5 * (high - low).value(), t);
    of.add(all[k], t);
    // Less the plate's own.
    sum += of.inertia() - 0.5 * (high - low).value() * t * t * t / 12.0;
  }
  return sum / (b * t * t * t / (12.0 * stiffened::one_less_nu_squared));
}

bool are_stiff_enough(const StiffenedPlate& plate) {
  constexpr double least = 25.0;
  return relative_stiffness(plate) >= least;
}

Length held_column_wave(SecondMoment inertia, Length b_1, Length b_2, Length thickness) {
  return stiffened::held_wave(plainly, inertia, b_1, b_2, thickness);
}

Stress held_column_stress(Area area, SecondMoment inertia, Length b_1, Length b_2, Length thickness,
                          std::optional<Length> length) {
  if (!length || *length >= held_column_wave(inertia, b_1, b_2, thickness)) {
    return stiffened::long_held_stress(plainly, stiffened::youngs_modulus, area, inertia, b_1, b_2,
                                       thickness);
  }
  return stiffened::short_held_stress(plainly, stiffened::youngs_modulus, area, inertia, b_1, b_2,
                                      thickness, *length);
}

Stress column_stress(Area area, SecondMoment inertia, Length length) {
  return stiffened::column_stress(plainly, "", stiffened::youngs_modulus, area, inertia, length);
}

Stress plate_column_stress(Length thickness, Length length) {
  return stiffened::euler_stress(plainly, "", stiffened::youngs_modulus, thickness, length);
}

double orthotropic_buckling_factor(std::optional<double> alpha, double psi, double gamma,
                                   double delta) {
  assert(psi <= 1.0);
  constexpr double least_ratio = 0.5, least_aspect = 0.5;
  const double within = std::max(least_ratio, psi);
  const auto at = [&](double aspect, double ratio) {
    return aspect > std::sqrt(std::sqrt(gamma))
               ? stiffened::long_orthotropic_factor(plainly, ratio, gamma, delta)
               : stiffened::short_orthotropic_factor(plainly, aspect, ratio, gamma, delta);
  };
  if (!alpha) return stiffened::long_orthotropic_factor(plainly, within, gamma, delta);
  if (*alpha >= least_aspect) return at(*alpha, within);
  return std::max(at(*alpha, 1.0), at(least_aspect, within));
}

double column_imperfection(Length e, Length radius_of_gyration) {
  return stiffened::imperfection(plainly, e, radius_of_gyration);
}

double column_like_reduction(double lambda_c, double imperfection) {
  return stiffened::column_reduction(plainly, lambda_c, imperfection);
}

double interpolated_reduction(double rho, double chi_c, double xi) {
  assert(xi >= 0.0 && xi <= 1.0);
  return stiffened::interpolated(rho, chi_c, xi);
}

std::optional<ShortPlate> short_plate_of(Length width, Length thickness, double k_sigma,
                                         Stress yield_strength, std::optional<Length> length) {
  if (!length) return std::nullopt;
  const Stress sigma_cr_c = plate_column_stress(thickness, *length);
  const Stress sigma_cr_p = k_sigma * plate_column_stress(thickness, width);
  const double xi = (sigma_cr_p / sigma_cr_c).value() - 1.0;
  if (xi >= 1.0) return std::nullopt;
  constexpr double bare_plate = 0.21;
  return ShortPlate{
      column_like_reduction(std::sqrt((yield_strength / sigma_cr_c).value()), bare_plate),
      std::max(0.0, xi)};
}

std::optional<EffectiveWidth> panel_effective_width(Length width, Length thickness, double psi,
                                                    Stress yield_strength,
                                                    std::optional<Length> length,
                                                    const StressLevel& level) {
  auto of = internal_effective_width(width, thickness, psi, epsilon_of(yield_strength));
  if (!of) return std::nullopt;
  const auto column = short_plate_of(width, thickness, of->k_sigma, yield_strength, length);
  const double rho = column ? interpolated_reduction(of->rho, column->chi_c, column->xi)
                            : internal_reduction(of->lambda_p, psi, level);
  const double change = rho / of->rho;
  of->rho = rho;
  of->b_eff = change * of->b_eff;
  of->b_e1 = change * of->b_e1;
  of->b_e2 = change * of->b_e2;
  return of;
}

}  // namespace boxbeam
