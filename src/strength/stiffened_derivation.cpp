#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/strength/stiffened_plate.hpp"
#include "plate_formulas.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

constexpr Shown plain_number{ValueKind::number};

/// Subpanels of which something is idle, each width and stress ratio once.
void derive_subpanels(Derivation& steps, const StiffenedPlate& plate, const StiffenedWidths& of,
                      const Traced& t, const Traced& epsilon) {
  std::vector<const Subpanel*> said;
  for (const Subpanel& panel : of.subpanels) {
    if (!panel.pressed || panel.width.rho >= 1.0) continue;
    constexpr double same = 1e-9;
    const bool again = std::any_of(said.begin(), said.end(), [&](const Subpanel* other) {
      return std::abs(other->psi - panel.psi) < same &&
             std::abs(((other->high - other->low) - (panel.high - panel.low)).value()) < same;
    });
    if (again) continue;
    said.push_back(&panel);
    const Traced c = steps.given("c_i", panel.high - panel.low, "subpanel between stiffeners");
    steps.note([&] { return fmt::format("from {:.4g} mm on", 1e3 * panel.low.value()); });
    steps.given("psi_i", panel.psi, plain_number);
    const Traced psi = steps.known("psi_i", panel.psi, plain_number);
    const Traced k_sigma = steps.given("k_sigma,i", panel.width.k_sigma, plain_number);
    const Traced lambda = plate::slenderness(steps, c / t, epsilon, k_sigma);
    if (short_plate_of(panel.high - panel.low, plate.thickness, panel.width.k_sigma,
                       plate.yield_strength, plate.length)) {
      steps.given("rho_i", panel.width.rho, plain_number, "short: column-like, 4.4(6)");
    } else {
      plate::internal_reduction(steps, lambda, psi);
    }
  }
}

Traced derive_plate_stress(Derivation& steps, const StiffenedPlate& plate,
                           const StiffenedWidths& widths, const Traced& t, const Traced& E) {
  const StiffenerBuckling& of = widths.buckling;
  if (of.model == PlateModel::orthotropic) {
    const Traced b = steps.given("b", plate.high - plate.low);
    const Traced gamma = steps.given("gamma", of.gamma, plain_number,
                                     "second moment of the whole stiffened plate over b t^3/10.92");
    const Traced delta =
        steps.given("delta", of.delta, plain_number, "area of the stiffeners over b t");
    const Traced k = steps.given("k_sigma,p", of.k_sigma_p, plain_number,
                                 "A.1(2) of alpha = a/b, psi, gamma and delta");
    (void)gamma;
    (void)delta;
    return steps.define("sigma_cr,p", k * stiffened::euler_stress(steps, "sigma_E", E, t, b));
  }
  const Traced A = steps.given("A_sl", of.held.area,
                               of.compressed == 2 ? "of A.2, of the worst of each stiffener by "
                                                    "itself and both as one, with the plate beside"
                                                  : "the stiffener and the plate beside it");
  const Traced I = steps.given("I_sl", of.held.inertia, "of these, out of the plate");
  const Traced b_1 = steps.given("b_1", of.b_1), b_2 = steps.given("b_2", of.b_2);
  const Traced wave = stiffened::held_wave(steps, I, b_1, b_2, t);
  const bool is_long = !plate.length || plate.length->value() >= wave.value();
  const Traced at_stiffener =
      is_long ? stiffened::long_held_stress(steps, E, A, I, b_1, b_2, t)
              : stiffened::short_held_stress(steps, E, A, I, b_1, b_2, t,
                                             Traced(steps.known("a", *plate.length)));
  if (of.held.stress == 1.0) return steps.define("sigma_cr,p", at_stiffener);
  const Traced share =
      steps.given("b_sl,1/b_c", of.held.stress, plain_number, "stress there over that of the edge");
  return steps.define("sigma_cr,p", at_stiffener / share);
}

}  // namespace

Traced derive_stiffened(Derivation& steps, const StiffenedPlate& plate,
                        const StiffenedWidths& widths) {
  const StiffenerBuckling& of = widths.buckling;
  const Traced t = steps.given("t", plate.thickness);
  const Traced f_y = steps.known("f_y", plate.yield_strength);
  const Traced epsilon = plate::epsilon(steps, f_y);
  const Traced E = steps.known("E", stiffened::youngs_modulus);
  const Traced psi = steps.given("psi", widths.psi, plain_number, "of the whole plate");
  if (plate.length) steps.given("a", *plate.length, "between supports across");
  derive_subpanels(steps, plate, widths, t, epsilon);
  const Traced gross =
      steps.given("A_c", of.gross, "compressed, without what the edges of the plate hold");
  const Traced local =
      steps.given("A_c,eff,loc", of.local, "of it what the subpanels leave, stiffeners included");
  const Traced beta = steps.define("beta_A,c", local / gross);
  const auto column_like = [&] {
    const Traced A = steps.given("A_sl,1", of.column.area,
                                 of.model == PlateModel::column
                                     ? "the weakest stiffener with the plate beside it"
                                     : "the stiffener nearest to the edge, with the plate beside");
    const Traced I = steps.given("I_sl,1", of.column.inertia);
    const Traced effective = steps.given("A_sl,1,eff", of.column.effective);
    const Traced e = steps.given("e", of.column.e);
    Traced stress = stiffened::column_stress(steps, "sigma_cr,sl", E, A, I,
                                             Traced(steps.known("a", *plate.length)));
    if (of.column.stress != 1.0) {
      stress = stress / steps.given("b_sl,1/b_c", of.column.stress, plain_number,
                                    "stress there over that of the edge");
    }
    if (of.sigma_cr_c >= of.sigma_cr_p && of.model != PlateModel::column) {
      stress = steps.given("sigma_cr,c", of.sigma_cr_c,
                           "no more than sigma_cr,p, which holds the weakest stiffener");
    } else {
      stress = steps.define("sigma_cr,c", stress);
    }
    const Traced radius = steps.define("i", sqrt(I / A));
    const Traced imperfection = stiffened::imperfection(steps, e, radius);
    const Traced lambda = steps.define("lambda_c", sqrt(effective / A * f_y / stress));
    return std::pair{stress, stiffened::column_reduction(steps, lambda, imperfection)};
  };
  if (of.model == PlateModel::column) {
    if (!plate.length) return steps.given("rho_c", of.rho_c, plain_number);
    return steps.define("rho_c", column_like().second,
                        "unlike stiffeners: the plate counts as no support");
  }
  const Traced plate_stress = derive_plate_stress(steps, plate, widths, t, E);
  const Traced lambda = steps.define("lambda_p", sqrt(beta * f_y / plate_stress));
  const Traced rho =
      of.rho < 1.0 ? plate::internal_reduction(steps, lambda, psi)
                   : steps.given("rho", 1.0, {ValueKind::factor}, "lambda_p is small, 4.4(2)");
  if (of.xi >= 1.0)
    return steps.define("rho_c", rho, "sigma_cr,p is twice sigma_cr,c or more: no column");
  const auto [column_stress, chi] = column_like();
  const Traced xi = of.xi > 0.0 ? steps.define("xi", plate_stress / column_stress - 1.0)
                                : steps.given("xi", 0.0, {ValueKind::factor}, "like a column");
  if (of.xi == 0.0) return steps.define("rho_c", chi);
  return steps.define("rho_c", stiffened::interpolated(rho, chi, xi), "4.5.4");
}

}  // namespace boxbeam
