#include "boxbeam/strength/shear_buckling.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "boxbeam/strength/section_class.hpp"
#include "plate_formulas.hpp"

namespace boxbeam {
namespace {

/// All numbers of a panel, whatever they are recorded by.
template <class Number>
struct PanelNumbers {
  Number k_tau, lambda_w, chi_w;
};

template <class Number, class Record>
PanelNumbers<Number> numbers_of(Record& record, const ShearPanel& panel, double eta) {
  const auto depth = record.known("h_w", panel.depth);
  const auto ratio = depth / record.known("t", panel.thickness);
  const auto epsilon = plate::epsilon(record, record.known("f_y", panel.yield_strength));
  const auto k_tau = [&]() -> Number {
    if (!panel.length) {
      return Number(record.given("k_tau", 5.34, {ValueKind::factor},
                                 "between the ends of the beam: nothing shortens the panel"));
    }
    const auto length = record.given("a", *panel.length, "between diaphragms");
    return Number(plate::shear_factor(record, depth / length, *panel.length >= panel.depth));
  }();
  const Number lambda_w(plate::shear_slenderness(record, ratio, epsilon, k_tau));
  return {k_tau, lambda_w, plate::shear_reduction(record, lambda_w, eta, panel.rigid_end_post)};
}

}  // namespace

double shear_hardening_factor(Stress yield_strength) {
  return yield_strength.value() <= 460e6 ? 1.2 : 1.0;
}

ShearBucklingNeed shear_buckling_need(Length clear_depth, Length thickness, Stress yield_strength,
                                      double eta) {
  return {clear_depth / thickness, 72.0 * epsilon_of(yield_strength) / eta};
}

bool is_rigid_end_post(const EndPost& post, Length deepest, Length thickness,
                       Stress yield_strength) {
  const Length width =
      std::min(post.width, 15.0 * epsilon_of(yield_strength) * post.thickness, std::less<>());
  return post.apart >= 0.1 * deepest &&
         width * post.thickness >= 4.0 * deepest * thickness * thickness / post.apart;
}

ShearResistance shear_resistance_of(const ShearPanel& panel, double gamma_M1) {
  constexpr NoDerivation plainly;
  const double eta = shear_hardening_factor(panel.yield_strength);
  const auto of = numbers_of<double>(plainly, panel, eta);
  return {of.k_tau, of.lambda_w, of.chi_w,
          plate::shear_resistance(plainly, of.chi_w, panel.yield_strength, panel.depth,
                                  panel.thickness, gamma_M1)};
}

Traced derive_shear_resistance(Derivation& steps, const ShearPanel& panel, double gamma_M1) {
  const double eta = shear_hardening_factor(panel.yield_strength);
  const auto of = numbers_of<Traced>(steps, panel, eta);
  return plate::shear_resistance(steps, of.chi_w, steps.known("f_y", panel.yield_strength),
                                 steps.known("h_w", panel.depth), steps.known("t", panel.thickness),
                                 gamma_M1);
}

double interaction_factor(double eta_1, double eta_3) {
  constexpr double none = std::numeric_limits<double>::infinity();
  // Up to half of the resistance to shear the normal stress is alone.
  if (eta_1 >= 2.0 * eta_3) return eta_1 > 0.0 ? 1.0 / eta_1 : none;
  return plate::interaction_factor(eta_1, eta_3);
}

Traced derive_interaction_factor(Derivation& steps, const Traced& eta_1, const Traced& eta_3) {
  const Traced factor =
      eta_1 >= 2.0 * eta_3 ? Traced(1.0 / eta_1) : Traced(plate::interaction_factor(eta_1, eta_3));
  return steps.define("factor", factor);
}

}  // namespace boxbeam
