#include "boxbeam/strength/member_buckling.hpp"

#include <cmath>

#include "boxbeam/core/derivation.hpp"
#include "column_formulas.hpp"

namespace boxbeam {
namespace {

double chi_at(double lambda, BucklingCurve curve) {
  return column::reduction<const NoDerivation, double>(plainly, lambda, curve);
}

/// k_yy or k_zz. Source: EN 1993-1-1:2005, table B.1, class 3 and 4.
template <class Record, class Number>
auto moment_factor(Record& record, const char* name, const char* C_name, double C_m,
                   const Number& lambda, const Number& n_b) {
  const auto C = record.given(C_name, C_m, {ValueKind::factor}, "table B.3; 1 on the safe side");
  return Number(record.define(name, C * (1.0 + 0.6 * least_of<Number>({lambda, 1.0}) * n_b)));
}

/// By the moments of the straight beam: k_yy m_y/chi_LT + k_yz m_z, or k_zy m_y/chi_LT + k_zz m_z.
template <class Record, class Number>
Number straight_moments(Record& record, const MemberLoad& load, const Number& lambda,
                        const Number& chi, BucklingCurve curve, double gamma_M1) {
  const MemberLoad::Straight& of = load.straight;
  const double n = load.compressed;
  const Number n_b(record.define(
      "n_b", record.known("gamma_M1", gamma_M1, {ValueKind::factor}) * record.known("n", n) / chi,
      "N/N_b,Rd"));
  // Of the other plane, whose own check says how it comes to this.
  const bool buckles = of.other > no_buckling_below;
  const auto other_factor = [&](const char* name, const char* C_name, double C_m) {
    const double slender = std::sqrt(of.other / n);
    const auto lambda_o = record.given(of.about_z ? "lambda_y" : "lambda_z", slender, {});
    const auto n_o = record.given(
        of.about_z ? "n_y" : "n_z", gamma_M1 * n / (buckles ? chi_at(slender, curve) : 1.0), {},
        buckles ? "N/N_b,Rd in the other plane" : "in the other plane it cannot buckle");
    return moment_factor(record, name, C_name, C_m, Number(lambda_o), Number(n_o));
  };
  const auto k_y = [&] {
    return of.about_z ? other_factor("k_yy", "C_my", of.C_my)
                      : moment_factor(record, "k_yy", "C_my", of.C_my, lambda, n_b);
  };
  const auto by_y = [&] {
    const auto m_y = record.given("m_y", of.m_y, {}, "largest M_y/(W_y f_y) of the straight beam");
    Number k(1.0);
    if (!of.about_z)
      k = k_y();
    else if (of.twists)
      k = Number(record.given("k_zy", 1.0, {ValueKind::factor}, "table B.2, at most"));
    else
      k = Number(record.define("k_zy", 0.8 * k_y()));
    if (of.turning <= no_turning_over_below) return Number(k * m_y);
    const double slender = std::sqrt(of.turning / of.m_y);
    return Number(k * m_y /
                  record.given("chi_LT", chi_at(slender, BucklingCurve::d), {ValueKind::factor},
                               "curve d, lambda_LT = sqrt((M/M_cr)/m_y)"));
  };
  const auto by_z = [&] {
    const auto m_z = record.given("m_z", of.m_z, {}, "largest M_z/(W_z f_y) of the straight beam");
    return Number((of.about_z ? moment_factor(record, "k_zz", "C_mz", of.C_mz, lambda, n_b)
                              : other_factor("k_yz", "C_mz", of.C_mz)) *
                  m_z);
  };
  Number sum(0.0);
  if (of.m_y > 0.0) sum = by_y();
  if (of.m_z > 0.0) sum = Number(sum + by_z());
  return Number(record.define("m_k", sum, of.about_z ? "equation 6.62" : "equation 6.61"));
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
      record.given("n_cr", load.critical, {}, "N/N_cr across the plane and M/M_cr together");
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
