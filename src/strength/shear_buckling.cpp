#include "boxbeam/strength/shear_buckling.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "boxbeam/strength/section_class.hpp"
#include "plate_formulas.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

/// All numbers of a panel, whatever they are recorded by.
template <class Number>
struct PanelNumbers {
  Number k_tau, lambda_w, chi_w;
};

/// k_tau of a plate with its stiffeners. Source: EN 1993-1-5:2006, A.3.
template <class Number, class Record, class L>
Number stiffened_factor(Record& record, const ShearPanel& panel, const L& depth,
                        const L& thickness) {
  const auto inertia = record.given("I_sl", panel.stiffeners.inertia,
                                    "stiffeners, each with 15 epsilon t of the plate beside it");
  const Number theta(record.define("theta", inertia / (thickness * thickness * thickness * depth),
                                   "stiffeners to plate"));
  constexpr double few = 3.0;
  if (panel.length && panel.stiffeners.count <= 2 && *panel.length < few * panel.depth) {
    const Number ratio(depth / record.given("a", *panel.length, "between diaphragms"));
    return plate::few_stiffeners_shear_factor(record, theta, ratio);
  }
  const Number bare =
      plate::bare_shear_factor<Number>(record, "k_tau,0", depth, panel.depth, panel.length);
  if (!panel.length) {
    return record.define("k_tau",
                         Number(bare + plate::shear_factor_of_stiffeners<Number>(record, theta)));
  }
  const Number ratio(depth / record.known("a", *panel.length));
  return record.define(
      "k_tau", Number(bare + plate::shear_factor_of_stiffeners<Number>(record, theta, ratio)));
}

template <class Number>
struct Slenderness {
  Number k_tau, lambda_w;
};

template <class Number, class Record>
Slenderness<Number> slenderness_of(Record& record, const ShearPanel& panel) {
  const auto depth = record.known("h_w", panel.depth);
  const auto thickness = record.known("t", panel.thickness);
  const auto ratio = depth / thickness;
  const auto epsilon = plate::epsilon(record, record.known("f_y", panel.yield_strength));
  if (panel.stiffeners.count == 0) {
    const Number k_tau =
        plate::bare_shear_factor<Number>(record, "k_tau", depth, panel.depth, panel.length);
    return {k_tau, Number(plate::shear_slenderness(record, "lambda_w", ratio, epsilon, k_tau))};
  }
  const Number k_tau = stiffened_factor<Number>(record, panel, depth, thickness);
  const Number whole(plate::shear_slenderness(record, "lambda_w,0", ratio, epsilon, k_tau));
  const Length widest = panel.stiffeners.widest_subpanel;
  const auto subpanel = record.given("h_w,i", widest, "the widest subpanel");
  const Number k_tau_i =
      plate::bare_shear_factor<Number>(record, "k_tau,i", subpanel, widest, panel.length, true);
  const Number part(plate::shear_slenderness(record, "lambda_w,i", Number(subpanel / thickness),
                                             Number(epsilon), k_tau_i));
  return {k_tau, record.define("lambda_w", largest_of({whole, part}),
                               "the panel or its widest subpanel, 5.3(5)")};
}

template <class Number, class Record>
PanelNumbers<Number> numbers_of(Record& record, const ShearPanel& panel, double eta) {
  const auto [k_tau, lambda_w] = slenderness_of<Number>(record, panel);
  return {k_tau, lambda_w, plate::shear_reduction(record, lambda_w, eta, panel.rigid_end_post)};
}

template <class Record, class Number>
auto buckling_shear(Record& record, const ShearPanel& panel, const Number& lambda_w,
                    double gamma_M1) {
  using std::sqrt;
  const auto force = record.known("h_w", panel.depth) * record.known("t", panel.thickness) *
                     record.known("f_y", panel.yield_strength);
  return record.define("V_cr", force / (lambda_w * lambda_w * sqrt(record.constant("3", 3.0)) *
                                        record.known("gamma_M1", gamma_M1, {ValueKind::factor})));
}

}  // namespace

double shear_hardening_factor(Stress yield_strength) {
  return yield_strength.value() <= 460e6 ? 1.2 : 1.0;
}

ShearBucklingNeed shear_buckling_need(Length clear_depth, Length thickness, Stress yield_strength,
                                      double eta) {
  return {clear_depth / thickness, 72.0 * epsilon_of(yield_strength) / eta};
}

double flange_induced_limit(Area web, Area flange, Stress flange_strength) {
  constexpr double k = 0.55;
  return k * (stiffened::youngs_modulus / flange_strength).value() *
         std::sqrt((web / flange).value());
}

bool is_rigid_end_post(const EndPost& post, Length deepest, Length thickness,
                       Stress yield_strength) {
  const Length width =
      std::min(post.width, 15.0 * epsilon_of(yield_strength) * post.thickness, std::less<>());
  return post.apart >= 0.1 * deepest &&
         width * post.thickness >= 4.0 * deepest * thickness * thickness / post.apart;
}

ShearResistance shear_resistance_of(const ShearPanel& panel, double gamma_M1) {
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

Force buckling_shear_of(const ShearPanel& panel, double gamma_M1) {
  return buckling_shear(plainly, panel, slenderness_of<double>(plainly, panel).lambda_w, gamma_M1);
}

Traced derive_buckling_shear(Derivation& steps, const ShearPanel& panel, double gamma_M1) {
  steps.given("h_w", panel.depth);
  steps.given("t", panel.thickness);
  steps.given("f_y", panel.yield_strength);
  return buckling_shear(steps, panel, slenderness_of<Traced>(steps, panel).lambda_w, gamma_M1);
}

double interaction_factor(double eta_1, double eta_3, double part) {
  constexpr double none = std::numeric_limits<double>::infinity();
  // Up to half of the resistance to shear the normal stress is alone.
  if (eta_1 >= 2.0 * eta_3) return eta_1 > 0.0 ? 1.0 / eta_1 : none;
  return part < 1.0 ? plate::interaction_factor(eta_1, eta_3, part)
                    : plate::interaction_factor(eta_1, eta_3);
}

Traced derive_interaction_factor(Derivation& steps, const Traced& eta_1, const Traced& eta_3) {
  const Traced factor =
      eta_1 >= 2.0 * eta_3 ? Traced(1.0 / eta_1) : Traced(plate::interaction_factor(eta_1, eta_3));
  return steps.define("factor", factor);
}

}  // namespace boxbeam
