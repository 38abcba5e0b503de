#include "boxbeam/strength/shear_lag.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {
namespace {

/// No reduction up to this kappa; another formula above the second.
constexpr double small = 0.02, large = 0.7;

template <class Number>
Number beta_1(const Number& kappa) {
  if (kappa <= large) return 1.0 / (1.0 + 6.4 * kappa * kappa);
  return 1.0 / (5.9 * kappa);
}

template <class Number>
Number beta_2(const Number& kappa) {
  if (kappa > large) return 1.0 / (8.6 * kappa);
  return 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
}

template <class Number>
Number beta_of(const Number& kappa, BendingRegion region) {
  if (kappa <= small) return 1.0;
  switch (region) {
    case BendingRegion::sagging: return beta_1(kappa);
    case BendingRegion::end_support:
      return least_of({Number(1.0), Number(0.55 + 0.025 / kappa)}) * beta_1(kappa);
    case BendingRegion::hogging:
    case BendingRegion::cantilever: return beta_2(kappa);
  }
  return 1.0;
}

template <class L, class A>
auto alpha_of(const L& b_0, const L& thickness, const A& stiffeners) {
  using std::sqrt;
  return sqrt(1.0 + stiffeners / (b_0 * thickness));
}

template <class Number, class L>
auto kappa_of(const Number& alpha_0, const L& b_0, const L& L_e) {
  return alpha_0 * (b_0 / L_e);
}

const char* table_of(BendingRegion region) {
  switch (region) {
    case BendingRegion::sagging:
      return "beta_1 of table 3.1, sagging: no force makes a peak of the moment in this stretch";
    case BendingRegion::end_support: return "beta_0 of table 3.1, end support";
    case BendingRegion::hogging:
      return "beta_2 of table 3.1, hogging: a force makes a peak of the moment in this stretch";
    case BendingRegion::cantilever:
      return "beta_2 of table 3.1, cantilever: the moment is largest at the clamped end";
  }
  return "";
}

}  // namespace

bool shear_lag_counts(Length b_0, Length L_e) { return b_0 >= L_e / 50.0; }

double shear_lag_kappa(Length b_0, Length thickness, Area stiffeners, Length L_e) {
  return kappa_of(alpha_of(b_0, thickness, stiffeners), b_0, L_e);
}

double shear_lag_factor(double kappa, BendingRegion region) { return beta_of(kappa, region); }

Traced derive_shear_lag(Derivation& steps, const WidePlate& plate, std::string_view of,
                        std::string_view index) {
  const Traced b_0 = steps.known("b_0", plate.b_0),
               L_e = steps.known("L_e", plate.effective_length);
  Traced alpha_0 = 1.0;
  if (plate.stiffeners.value() > 0.0) {
    alpha_0 = steps.define("alpha_0", alpha_of(b_0, steps.known("t", plate.thickness),
                                               steps.known("A_sl", plate.stiffeners)));
    steps.note([&] { return fmt::format("stiffeners of the {}", of); });
  }
  const Traced kappa =
      steps.define({"kappa", index}, kappa_of(alpha_0, b_0, L_e), "", {ValueKind::number, 5});
  steps.note([&] {
    return fmt::format(
        "shear lag of the {}: half their width over the length between zero moments; EN "
        "1993-1-5, 3.2.1",
        of);
  });
  // With more digits than others, for what counts is what is missing to one.
  constexpr Shown shown{ValueKind::number, 6};
  if (kappa <= small) {
    return steps.given({"beta", index}, 1.0, shown, "no reduction for so small a kappa");
  }
  return steps.define({"beta", index}, beta_of(kappa, plate.region), table_of(plate.region), shown);
}

}  // namespace boxbeam
