#include "boxbeam/strength/patch_loading.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <type_traits>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "column_formulas.hpp"

namespace boxbeam {
namespace {

constexpr double steel = 210e9;  ///< E of clause 6 [Pa]

/// Above it the flange's own bending between the stiff length and its hinges counts with the web's.
constexpr double slender = 0.5;

Length flange_width_of(const PatchedWeb& web) {
  const Length most = 15.0 * epsilon_of(web.flange_strength) * web.flange_thickness;
  return std::min(web.flange_inside, most, std::less<>()) + web.thickness +
         std::min(web.flange_outside, most, std::less<>());
}

template <class Record>
auto force_factor(Record& record, const PatchedWeb& web) {
  const auto depth = record.known("h_w", web.depth);
  using Number = decltype(depth / record.known("t", web.thickness) * 1.0);
  const auto far = [&](double factor) -> Number {
    if (!web.length)
      return Number(record.given("k_F", factor, {ValueKind::factor}, "no stiffener is near"));
    const auto ratio = depth / record.given("a", *web.length, "between diaphragms");
    return Number(record.define("k_F", factor + 2.0 * ratio * ratio));
  };
  switch (web.entry) {
    case ForceEntry::one_flange: return far(6.0);
    case ForceEntry::both_flanges: return far(3.5);
    case ForceEntry::near_end: break;
  }
  const auto reach = record.known("s_s", std::min(web.stiff_length, web.depth)) +
                     record.given("c", web.to_end, "to the end of the beam");
  return Number(
      record.define("k_F", least_of<Number>({Number(2.0 + 6.0 * reach / depth), Number(6.0)})));
}

template <class Record, class Number>
auto patch_critical_force(Record& record, const PatchedWeb& web, const Number& k_F) {
  const auto t = record.known("t", web.thickness);
  return record.define("F_cr", 0.9 * k_F * record.constant("210 GPa", steel * pascal) * t * t * t /
                                   record.known("h_w", web.depth));
}

/// All numbers of a web, whatever they are recorded by.
template <class Number, class Span, class Load>
struct PatchNumbers {
  Number k_F, m_1, m_2, lambda_F, chi_F;
  Span l_y;
  Load F_cr;
};

template <class Number, class Span, class Load, class Record>
PatchNumbers<Number, Span, Load> numbers_of(Record& record, const PatchedWeb& web,
                                            bool with_flange) {
  using std::sqrt;
  const auto depth = record.known("h_w", web.depth), t = record.known("t", web.thickness);
  const auto f_yw = record.known("f_yw", web.yield_strength);
  const auto t_f = record.known("t_f", web.flange_thickness);
  const auto s_s = record.known("s_s", std::min(web.stiff_length, web.depth));
  const auto E = record.constant("210 GPa", steel * pascal);
  const Number k_F(force_factor(record, web));
  const Load F_cr(patch_critical_force(record, web, k_F));
  const auto b_f = record.given("b_f", flange_width_of(web),
                                "of the flange, at most 15 eps t_f beside each face of the web");
  const Number m_1(
      record.define("m_1", record.known("f_yf", web.flange_strength) * b_f / (f_yw * t)));
  const auto slope = depth / t_f;
  const Number m_2 =
      with_flange ? Number(record.define("m_2", 0.02 * slope * slope))
                  : Number(record.given("m_2", 0.0, {ValueKind::factor},
                                        web.pulled ? "pulled" : "lambda_F is not above 0.5"));
  Span level(s_s + 2.0 * t_f * (1.0 + sqrt(m_1 + m_2)));
  const auto length = [&]() -> Span {
    if (web.entry != ForceEntry::near_end) {
      if (!web.length) return level;
      return least_of<Span>({level, Span(record.known("a", *web.length))});
    }
    const Span reach(s_s + record.known("c", web.to_end));
    const Span l_e(record.define(
        "l_e", least_of<Span>({Span(k_F * E * t * t / (2.0 * f_yw * depth)), reach})));
    const auto part = l_e / t_f;
    return least_of<Span>({level, Span(l_e + t_f * sqrt(m_1 / 2.0 + part * part + m_2)),
                           Span(l_e + t_f * sqrt(m_1 + m_2))});
  };
  const Span l_y(record.define("l_y", length()));
  const Number lambda_F(record.define("lambda_F", sqrt(l_y * t * f_yw / F_cr)));
  const Number chi_F = lambda_F > slender && !web.pulled
                           ? Number(record.define("chi_F", 0.5 / lambda_F))
                           : Number(record.given("chi_F", 1.0, {ValueKind::factor},
                                                 web.pulled ? "pulled, it does not buckle"
                                                            : "lambda_F is not above 0.5"));
  return {k_F, m_1, m_2, lambda_F, chi_F, l_y, F_cr};
}

/// Whether lambda_F, found with m_2, is above the limit from which m_2 counts.
bool counts_flange(const PatchedWeb& web) {
  return !web.pulled && numbers_of<double, Length, Force>(plainly, web, true).lambda_F > slender;
}

template <class Record, class Number, class Span>
auto resistance(Record& record, const PatchedWeb& web, const Number& chi_F, const Span& l_y,
                double gamma_M1) {
  return record.define("F_Rd", chi_F * record.known("f_yw", web.yield_strength) * l_y *
                                   record.known("t", web.thickness) /
                                   record.known("gamma_M1", gamma_M1, {ValueKind::factor}));
}

template <class Record, class Number>
Number factor_of(Record& record, const Number& eta_2, const Number& eta_1) {
  return record.define(
      "factor", least_of<Number>({Number(1.0 / eta_2), Number(1.4 / (eta_2 + 0.8 * eta_1))}));
}

/// The column of a bearing stiffener: a T of a strip of the web and the diaphragm's part.
template <class Record>
auto bearing(Record& record, const BearingStiffener& of, double gamma_M1) {
  using std::sqrt;
  const double eps = epsilon_of(of.yield_strength);
  const auto within = [&](Length there, Length thickness) {
    return std::min(there, 15.0 * eps * thickness, std::less<>());
  };
  const auto t = record.given("t", of.web_thickness), t_d = record.given("t_d", of.thickness);
  const auto strip = record.given("b_w",
                                  within(of.web_before, of.web_thickness) +
                                      within(of.web_behind, of.web_thickness) + of.thickness,
                                  "of the web beside the diaphragm, at most 15 eps t on each side");
  const auto b_d =
      record.given("b_d", within(of.width, of.thickness),
                   of.both_sides ? "of the diaphragm on each side of the web, at most 15 eps t_d"
                                 : "of the diaphragm, at most 15 eps t_d");
  const auto both = [&] {
    const auto A = record.define("A", strip * t + 2.0 * b_d * t_d);
    const auto out = record.define("d", (t + b_d) / 2.0);
    return std::tuple(
        A,
        record.define("I", strip * t * t * t / 12.0 +
                               2.0 * (t_d * b_d * b_d * b_d / 12.0 + b_d * t_d * out * out)),
        t * 0.0);
  };
  const auto one = [&] {
    const auto A = record.define("A", strip * t + b_d * t_d);
    const auto from_web = record.define("e", b_d * t_d * (t + b_d) / (2.0 * A));
    const auto out = record.define("d", (t + b_d) / 2.0 - from_web);
    return std::tuple(
        A,
        record.define("I", strip * t * t * t / 12.0 + strip * t * from_web * from_web +
                               t_d * b_d * b_d * b_d / 12.0 + b_d * t_d * out * out),
        from_web);
  };
  const auto [A, I, e] = of.both_sides ? both() : one();
  const auto length =
      record.define("L_cr", (of.ends_clamped ? 0.75 : 1.0) * record.given("h_w", of.web_depth));
  if (!of.ends_clamped)
    record.note([] { return "no [[beam.restraints]] hold the flanges sideways here"; });
  const auto f_y = record.given("f_y", of.yield_strength);
  const auto N_cr =
      column::euler_force(record, record.constant("210 GPa", steel * pascal), I, length);
  const auto lambda = column::slenderness(record, A, f_y, N_cr);
  using Number = decltype(lambda * 1.0);
  const Number chi = column::reduction<Record, Number>(record, Number(lambda), BucklingCurve::c);
  const auto N_b = column::resistance(record, chi, A, f_y, gamma_M1);
  using Load = std::decay_t<decltype(N_b * 1.0)>;
  if (!of.bows) return Load(N_b);
  // The edge of the web, or the tip of the flat.
  using Span = std::decay_t<decltype(e * 1.0)>;
  const auto edge = largest_of({Span(e + t / 2.0), Span(b_d + t / 2.0 - e)});
  const Number r(record.define("r", chi * A * e * edge / I, "chi A e/W"));
  const Number q(record.define("q", 0.6 * least_of<Number>({Number(lambda), Number(1.0)}) * r));
  const Number s(1.0 + r);
  return Load(record.define("N_e,Rd", 2.0 * N_b / (s + sqrt(s * s + 4.0 * q)),
                            "6.3.3 with k_yy = 1 + 0.6 lambda n, C_m = 1"));
}

template <class Record, class Load>
auto factor_of_stiffener(Record& record, const Load& F, const Load& V, const Load& V_cr,
                         const Load& N_b) {
  using Number = std::decay_t<decltype(N_b / F * 1.0)>;
  if (!(F.value() > 0.0)) return record.define("factor", Number((N_b + V_cr) / (F + V)));
  return record.define("factor",
                       least_of<Number>({Number(N_b / F), Number((N_b + V_cr) / (F + V))}));
}

template <class Record>
auto weld_resistance(Record& record, const StiffenerWeld& of) {
  using std::sqrt;
  const auto a = record.given("a", of.throat, "throat of each weld");
  const auto l = record.given("l", of.length, of.to_flange ? "with the flange" : "along the web");
  const auto n = record.constant(std::to_string(of.welds), static_cast<double>(of.welds));
  const auto alone = [&] {
    if (!of.to_flange)
      return record.define("F_w,Rd",
                           n * a * (l - 2.0 * a) * weld_shear_strength(record, of.strength),
                           "along the welds, on both faces, less a throat at each end");
    const auto sqrt_2 = record.constant("sqrt(2)", std::numbers::sqrt2);
    return record.define("F_w,Rd",
                         n * a * (l - 2.0 * a) * weld_strength(record, of.strength) / sqrt_2,
                         "across the welds, on both faces, less a throat at each end; no contact");
  }();
  using Load = std::decay_t<decltype(alone * 1.0)>;
  if (of.beside == 0.0) return Load(alone);
  const auto k = record.given("k", of.beside, {ValueKind::factor},
                              "use of the welds by what comes in square to it, over that by it");
  return Load(record.define("F_w,Rd,k", alone / sqrt(1.0 + k * k)));
}

}  // namespace

Length loaded_length_of(const PatchedWeb& web) {
  const Length length =
      std::min(web.stiff_length, web.depth, std::less<>()) + 2.0 * web.flange_thickness;
  return web.length ? std::min(length, *web.length, std::less<>()) : length;
}

PatchResistance patch_resistance_of(const PatchedWeb& web, double gamma_M1) {
  const auto of = numbers_of<double, Length, Force>(plainly, web, counts_flange(web));
  return {of.k_F,   of.m_1,  of.m_2, of.lambda_F,
          of.chi_F, of.F_cr, of.l_y, resistance(plainly, web, of.chi_F, of.l_y, gamma_M1)};
}

Traced derive_critical_force(Derivation& steps, const PatchedWeb& web) {
  steps.given("h_w", web.depth);
  steps.given("t", web.thickness);
  return patch_critical_force(steps, web, force_factor(steps, web));
}

Traced derive_patch_resistance(Derivation& steps, const PatchedWeb& web, double gamma_M1) {
  steps.given("h_w", web.depth);
  steps.given("t", web.thickness);
  steps.given("f_yw", web.yield_strength);
  steps.given("t_f", web.flange_thickness);
  steps.given("f_yf", web.flange_strength);
  steps.given("s_s", std::min(web.stiff_length, web.depth, std::less<>()),
              "stiff length on the flange");
  const auto of = numbers_of<Traced, Traced, Traced>(steps, web, counts_flange(web));
  return resistance(steps, web, of.chi_F, of.l_y, gamma_M1);
}

double patch_factor(double eta_2, double eta_1) {
  if (!(eta_2 > 0.0)) return std::numeric_limits<double>::infinity();
  return factor_of(plainly, eta_2, eta_1);
}

Traced derive_patch_factor(Derivation& steps, const Traced& eta_2, const Traced& eta_1) {
  return factor_of(steps, eta_2, eta_1);
}

Force bearing_resistance_of(const BearingStiffener& stiffener, double gamma_M1) {
  return bearing(plainly, stiffener, gamma_M1);
}

Traced derive_bearing_resistance(Derivation& steps, const BearingStiffener& stiffener,
                                 double gamma_M1) {
  return bearing(steps, stiffener, gamma_M1);
}

Force stiffener_weld_resistance_of(const StiffenerWeld& weld) {
  return weld_resistance(plainly, weld);
}

Traced derive_stiffener_weld_resistance(Derivation& steps, const StiffenerWeld& weld) {
  return weld_resistance(steps, weld);
}

std::optional<Length> sufficient_throat_of(const StiffenerWeld& weld, Force force) {
  // n a (l - 2 a) f = F, the smaller root.
  const Stress f = weld.to_flange ? Stress(weld_strength(plainly, weld.strength) / std::sqrt(2.0))
                                  : weld_shear_strength(weld.strength);
  const Area asked = std::hypot(1.0, weld.beside) * force / (static_cast<double>(weld.welds) * f);
  const double rest = 1.0 - 8.0 * (asked / (weld.length * weld.length)).value();
  if (!(rest >= 0.0)) return std::nullopt;
  return std::max(least_throat(), Length(0.25 * (1.0 - std::sqrt(rest)) * weld.length));
}

double stiffener_factor(Force comes_in, Force shear, Force buckling_shear, Force resistance) {
  return factor_of_stiffener(plainly, comes_in, shear, buckling_shear, resistance);
}

Traced derive_stiffener_factor(Derivation& steps, const Traced& comes_in, const Traced& shear,
                               const Traced& buckling_shear, const Traced& resistance) {
  return factor_of_stiffener(steps, comes_in, shear, buckling_shear, resistance);
}

}  // namespace boxbeam
