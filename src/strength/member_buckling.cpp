#include "boxbeam/strength/member_buckling.hpp"

#include "boxbeam/core/derivation.hpp"
#include "column_formulas.hpp"

namespace boxbeam {
namespace {

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
  return Number(record.define("use", gamma() * (n / chi + m)));
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
  constexpr NoDerivation plainly;
  return flexural(plainly, load, curve, gamma_M1);
}

Traced derive_flexural_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                           double gamma_M1) {
  return flexural(steps, load, curve, gamma_M1);
}

double lateral_use(const MemberLoad& load, BucklingCurve curve, double gamma_M1) {
  constexpr NoDerivation plainly;
  if (!(load.compressed + load.bent > 0.0)) return 0.0;
  return lateral(plainly, load, curve, gamma_M1);
}

Traced derive_lateral_use(Derivation& steps, const MemberLoad& load, BucklingCurve curve,
                          double gamma_M1) {
  return lateral(steps, load, curve, gamma_M1);
}

}  // namespace boxbeam
