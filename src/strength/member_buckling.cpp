#include "boxbeam/strength/member_buckling.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "boxbeam/core/derivation.hpp"
#include "column_formulas.hpp"

namespace boxbeam {
namespace {

double chi_at(double lambda, BucklingCurve curve) {
  return column::reduction<const NoDerivation, double>(plainly, lambda, curve);
}

/// What bends about an axis, which has a letter.
struct BentAbout {
  std::string_view axis;
  double m = 0.0, C_m = 1.0;
};

/// k of a member that buckles about one axis, of the moment about the other or the same.
Symbol k_of(const BentAbout& by, const BentAbout& about) {
  if (by.axis == "y") return {"k_y", about.axis};
  return {"k_z", about.axis};
}

/// k_yy or k_zz. Source: EN 1993-1-1:2005, table B.1, class 3 and 4.
template <class Record, class Number>
auto moment_factor(Record& record, Symbol name, const BentAbout& about, const Number& lambda,
                   const Number& n_b) {
  const auto C = record.given({"C_m", about.axis}, about.C_m, {ValueKind::factor},
                              "table B.3; 1 on the safe side");
  return Number(record.define(name, C * (1.0 + 0.6 * least_of<Number>({lambda, 1.0}) * n_b)));
}

/// By the moments of the straight beam, s its stronger axis and w the other: k_ss m_s/chi_LT + k_sw
/// m_w, or k_ws m_s/chi_LT + k_ww m_w.
template <class Record, class Number>
Number straight_moments(Record& record, const MemberLoad& load, const Number& lambda,
                        const Number& chi, BucklingCurve curve, double gamma_M1) {
  const MemberLoad::Straight& of = load.straight;
  const double n = load.compressed;
  const Number n_b(record.define(
      "n_b", record.known("gamma_M1", gamma_M1, {ValueKind::factor}) * record.known("n", n) / chi,
      "N/N_b,Rd"));
  BentAbout strong{"y", of.m_y, of.C_my}, weak{"z", of.m_z, of.C_mz};
  if (of.lies) std::swap(strong, weak);
  const bool by_weak = of.about_z != of.lies;
  // Of the other plane, whose own check says how it comes to this.
  const bool buckles = of.other > no_buckling_below;
  const auto other_factor = [&](Symbol name, const BentAbout& about) {
    const std::string_view axis = of.about_z ? "y" : "z";
    const double slender = std::sqrt(of.other / n);
    const auto lambda_o = record.given({"lambda_", axis}, slender, {});
    const auto n_o = record.given(
        {"n_", axis}, gamma_M1 * n / (buckles ? chi_at(slender, curve) : 1.0), {},
        buckles ? "N/N_b,Rd in the other plane" : "in the other plane it cannot buckle");
    return moment_factor(record, name, about, Number(lambda_o), Number(n_o));
  };
  const auto own_factor = [&](Symbol name, const BentAbout& about) {
    return moment_factor(record, name, about, lambda, n_b);
  };
  const auto moment_of = [&](const BentAbout& about) {
    return record.given({"m_", about.axis}, about.m, {},
                        about.axis == "y" ? "largest M_y/(W_y f_y) of the straight beam"
                                          : "largest M_z/(W_z f_y) of the straight beam");
  };
  const auto by_strong = [&] {
    const auto m = moment_of(strong);
    Number k(1.0);
    if (!by_weak)
      k = own_factor(k_of(strong, strong), strong);
    else if (of.twists)
      k = Number(record.given(k_of(weak, strong), 1.0, {ValueKind::factor}, "table B.2, at most"));
    else
      k = Number(
          record.define(k_of(weak, strong), 0.8 * other_factor(k_of(strong, strong), strong)));
    if (of.turning <= no_turning_over_below) return Number(k * m);
    const double slender = std::sqrt(of.turning / strong.m);
    return Number(k * m /
                  record.given("chi_LT", chi_at(slender, BucklingCurve::d), {ValueKind::factor},
                               of.lies ? "curve d, lambda_LT = sqrt((M/M_cr)/m_z)"
                                       : "curve d, lambda_LT = sqrt((M/M_cr)/m_y)"));
  };
  const auto by_other = [&] {
    const auto m = moment_of(weak);
    return Number(
        (by_weak ? own_factor(k_of(weak, weak), weak) : other_factor(k_of(strong, weak), weak)) *
        m);
  };
  Number sum(0.0);
  if (strong.m > 0.0) sum = by_strong();
  if (weak.m > 0.0) sum = Number(sum + by_other());
  return Number(record.define("m_k", sum, by_weak ? "equation 6.62" : "equation 6.61"));
}

template <class Record>
auto flexural(Record& record, const MemberLoad& load, BucklingCurve curve, double gamma_M1) {
  using std::sqrt;
  const auto n = record.given("n", load.compressed, {}, "largest N/(A f_y)");
  const auto critical = record.given("n_cr", load.critical, {}, "largest N/N_cr");
  const auto m = record.given("m", load.bent, {}, "largest M/(W f_y) of the bent beam");
  using Number = decltype(n * 1.0);
  const auto gamma = [&] { return record.known("gamma_M1", gamma_M1, {ValueKind::factor}); };
  // A mechanism may buckle by what compresses others of its bodies.
  if (!(load.compressed > 0.0))
    return Number(record.define("use", gamma() * m, "nothing compresses the beam itself"));
  const Number lambda(record.define("lambda", sqrt(critical / n)));
  const Number chi = column::reduction<Record, Number>(record, lambda, curve);
  if (!(load.straight.m_y + load.straight.m_z > 0.0))
    return Number(record.define("use", gamma() * (n / chi + m)));
  const Number m_k = straight_moments<Record, Number>(record, load, lambda, chi, curve, gamma_M1);
  return Number(record.define("use", gamma() * (n / chi + largest_of<Number>({Number(m), m_k}))));
}

template <class Record>
auto lateral(Record& record, const MemberLoad& load, BucklingCurve curve, double gamma_M1) {
  using std::sqrt;
  const auto n = record.given("n", load.compressed, {}, "largest N/(A f_y)");
  const auto m = record.given("m", load.bent, {}, "largest M/(W f_y) of the bent beam");
  const auto critical =
      record.given("n_cr", load.critical, {}, "N/N_cr about the weaker axis and M/M_cr together");
  using Number = decltype(n * 1.0);
  const Number alpha_ult(record.define("alpha_ult", 1.0 / (n + m)));
  const Number lambda(record.define("lambda", sqrt(alpha_ult * critical)));
  const Number chi = column::reduction<Record, Number>(record, lambda, curve);
  return Number(record.define(
      "use", record.known("gamma_M1", gamma_M1, {ValueKind::factor}) / (chi * alpha_ult)));
}

}  // namespace

double flexural_use(const MemberLoad& load, BucklingCurve curve, double gamma_M1) {
  return flexural(plainly, load, curve, gamma_M1);
}

Traced derive_flexural_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                           double gamma_M1) {
  return flexural(steps, load, curve, gamma_M1);
}

double lateral_use(const MemberLoad& load, BucklingCurve curve, double gamma_M1) {
  if (!(load.compressed + load.bent > 0.0)) return 0.0;
  return lateral(plainly, load, curve, gamma_M1);
}

Traced derive_lateral_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                          double gamma_M1) {
  return lateral(steps, load, curve, gamma_M1);
}

}  // namespace boxbeam
