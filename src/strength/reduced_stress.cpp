#include "boxbeam/strength/reduced_stress.hpp"

#include <cmath>
#include <limits>

#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "plate_formulas.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

double plain(double number) { return number; }
double plain(const Traced& number) { return number.value(); }

/// Stresses at a place of a plate beside shear.
template <class Number, class S>
struct PlaceStress {
  std::optional<S> along, across = {};
  std::optional<Number> together = {};  ///< V of 10.5, the part of their product; of none 1

  /// Square of what they are equivalent to.
  double square() const {
    const double x = along ? along->value() : 0.0, z = across ? across->value() : 0.0;
    return x * x + z * z - (together ? plain(*together) : 1.0) * x * z;
  }
};

template <class Number, class S, class Record>
S von_mises(Record& record, Symbol symbol, const PlaceStress<Number, S>& at, const S& tau) {
  using std::sqrt;
  if (!at.along) return S(record.define(symbol, sqrt(3.0 * tau * tau)));
  const S& x = *at.along;
  if (!at.across) return S(record.define(symbol, sqrt(x * x + 3.0 * tau * tau)));
  const S& z = *at.across;
  if (at.together) {
    const Number& V = *at.together;
    return S(record.define(symbol, sqrt(x * x + z * z - V * x * z + 3.0 * tau * tau)));
  }
  return S(record.define(symbol, sqrt(x * x + z * z - x * z + 3.0 * tau * tau)));
}

/// All numbers of a plate, whatever they are recorded by.
template <class Number>
struct ReducedNumbers {
  Number alpha_ult, per_critical, lambda, rho_x, rho_z, chi_w, use;
};

/// Equations 10.2 to 10.6 over a recorder.
template <class Number, class S, class Record>
class ReducedPanel {
 public:
  ReducedPanel(Record& record, const ShearPanel& panel, const PanelStress& on)
      : record_(&record),
        panel_(&panel),
        on_(&on),
        f_y_(record.given("f_y", panel.yield_strength)),
        tau_(record.known("tau", Stress(abs(on.shear)))) {
    if (on.compression != Stress{}) pressed_.emplace(record.known("sigma_x", on.compression));
    if (on.tension != Stress{}) pulled_.emplace(record.known("sigma_t", on.tension));
    if (!on.across) return;
    across_.emplace(record.known("sigma_z", on.across->stress));
    const auto& [one, other] = on.across->along;
    beside_[0].emplace(record.known("sigma_x,F", one));
    if (other != one) beside_[1].emplace(record.known("sigma_x,G", other));
  }

  ReducedNumbers<Number> numbers(double gamma_M1) {
    using std::sqrt;
    const auto as_it_is = [](const S& stress) { return stress; };
    const S acting = von_mises(*record_, "sigma_v", worst(as_it_is, across_, {}), tau_);
    const Number alpha_ult(record_->define("alpha_ult", f_y_ / acting));
    const Number per_critical = part_of_critical();
    const Number lambda(
        record_->define("lambda", sqrt(alpha_ult * per_critical), "of all reductions"));
    const Number rho_x = along(lambda), rho_z = across(lambda), chi_w = sheared(lambda);
    const auto reduced = [&](const S& stress) {
      return stress > S(0.0 * f_y_) ? S(stress / rho_x) : stress;
    };
    std::optional<S> z;
    if (across_) z.emplace(*across_ / rho_z);
    const S all = von_mises(*record_, "sigma_red", worst(reduced, z, pressed_twice(rho_x, rho_z)),
                            S(tau_ / chi_w));
    record_->note([] { return "equation 10.5"; });
    const Number use(record_->define(
        "use", all * record_->known("gamma_M1", gamma_M1, {ValueKind::factor}) / f_y_));
    return {alpha_ult, per_critical, lambda, rho_x, rho_z, chi_w, use};
  }

 private:
  /// V = rho_x rho_z, where sigma_x presses where sigma_z does and either is reduced.
  std::optional<Number> pressed_twice(const Number& rho_x, const Number& rho_z) {
    const auto presses = [](const std::optional<S>& beside) {
      return beside && beside->value() > 0.0;
    };
    const bool reduced = plain(rho_x) < 1.0 || plain(rho_z) < 1.0;
    if (!reduced || !across_ || (!presses(beside_[0]) && !presses(beside_[1]))) return {};
    return Number(record_->define("V", rho_x * rho_z, "both press: 10(5), A1:2017"));
  }

  /// `together`: V where both press.
  template <class Reduced>
  PlaceStress<Number, S> worst(const Reduced& reduced, const std::optional<S>& across,
                               const std::optional<Number>& together) const {
    PlaceStress<Number, S> worst;
    const auto take = [&](const PlaceStress<Number, S>& at) {
      if (at.square() > worst.square()) worst = at;
    };
    if (pressed_) take({reduced(*pressed_)});
    if (pulled_) take({*pulled_});
    for (const std::optional<S>& beside : beside_) {
      if (!beside || !across) continue;
      PlaceStress<Number, S> at{reduced(*beside), across};
      if (together && beside->value() > 0.0) at.together.emplace(*together);
      take(at);
    }
    return worst;
  }

  /// 1/alpha_cr, equation 10.6 with psi_z = 1.
  Number part_of_critical() {
    using std::sqrt;
    const auto b = record_->given("b", panel_->depth, "clear width");
    const auto t = record_->given("t", panel_->thickness);
    const auto sigma_E = record_->define(
        "sigma_E", record_->constant("190 GPa", 190e9 * pascal) * (t / b) * (t / b));
    const Number nothing = record_->constant("0", 0.0);
    Number p_x = nothing, p_z = nothing, p_tau = nothing;
    const Number psi(pressed_ ? Number(record_->given("psi", on_->psi, {ValueKind::number}))
                              : Number(1.0));
    if (pressed_) {
      const Number k(record_->given("k_sigma", k_sigma(), {ValueKind::number}));
      p_x = Number(record_->define("p_x", *pressed_ / (k * sigma_E), "acting over critical"));
    }
    if (tau_.value() != 0.0 && !on_->outstand) {
      const Number k =
          plate::bare_shear_factor<Number>(*record_, "k_tau", b, panel_->depth, panel_->length);
      p_tau = Number(record_->define("p_tau", tau_ / (k * sigma_E), "acting over critical"));
    }
    if (across_)
      p_z = Number(record_->given("p_z", 1.0 / on_->across->critical, {ValueKind::number},
                                  "F_w/F_cr of the force across"));
    const Number m(record_->define("m", (1.0 + psi) / 4.0 * p_x + p_z / 2.0));
    return Number(record_->define(
        "p", m + sqrt(m * m + (1.0 - psi) / 2.0 * p_x * p_x + p_tau * p_tau), "1/alpha_cr, 10.6"));
  }

  Number known_psi() const { return Number(record_->known("psi", on_->psi, {ValueKind::number})); }

  double k_sigma() const {
    return on_->outstand ? *outstand_buckling_factor(on_->psi, *on_->outstand)
                         : *internal_buckling_factor(on_->psi);
  }

  Number unreduced(const char* symbol, std::string_view note) {
    return Number(record_->given(symbol, 1.0, {ValueKind::factor}, note));
  }

  Number along(const Number& lambda) {
    if (!pressed_) return Number(1.0);
    if (on_->outstand) {
      return outstand_reduction(plain(lambda)) < 1.0
                 ? Number(plate::outstand_reduction(*record_, lambda))
                 : unreduced("rho", "of sigma_x: not slender, 4.4(2)");
    }
    const bool slender = internal_reduction(plain(lambda), on_->psi) < 1.0;
    Number rho = slender ? Number(plate::internal_reduction(*record_, lambda, known_psi()))
                         : unreduced("rho", "of sigma_x: not slender, 4.4(2)");
    const auto column = short_plate_of(panel_->depth, panel_->thickness, k_sigma(),
                                       panel_->yield_strength, panel_->length);
    if (!column) return rho;
    constexpr double bare_plate = 0.21;
    const Number chi = stiffened::column_reduction(*record_, lambda, Number(bare_plate));
    const Number xi(record_->given("xi", column->xi, {ValueKind::number},
                                   "sigma_cr,p/sigma_cr,c - 1, at least 0"));
    return Number(record_->define("rho_c", stiffened::interpolated(rho, chi, xi),
                                  "short between diaphragms: 4.5.4"));
  }

  Number across(const Number& lambda) {
    using std::sqrt;
    constexpr double plateau = 0.8, imperfection = 0.34;
    if (!across_) return Number(1.0);
    if (plain(lambda) <= plateau)
      return unreduced("rho_z", "of sigma_z: lambda is not above 0.8, B.1");
    const Number phi(
        record_->define("phi_p", (1.0 + imperfection * (lambda - plateau) + lambda) / 2.0));
    return Number(record_->define("rho_z", 1.0 / (phi + sqrt(phi * phi - lambda)), "B.1"));
  }

  Number sheared(const Number& lambda) {
    if (tau_.value() == 0.0 || on_->outstand) return Number(1.0);
    return plate::shear_reduction(*record_, lambda, 1.0, panel_->rigid_end_post);
  }

  Record* record_;
  const ShearPanel* panel_;
  const PanelStress* on_;
  S f_y_, tau_;
  std::optional<S> pressed_, pulled_, across_;
  std::array<std::optional<S>, 2> beside_;
};

}  // namespace

ReducedStress reduced_stress_of(const ShearPanel& panel, const PanelStress& stress,
                                double gamma_M1) {
  constexpr double none = std::numeric_limits<double>::infinity();
  ReducedStress of{.alpha_ult = none, .alpha_cr = none};
  const bool acts = stress.compression != Stress{} || stress.tension != Stress{} ||
                    stress.shear != Stress{} || stress.across;
  if (!acts) return of;
  const auto found =
      ReducedPanel<double, Stress, const NoDerivation>(plainly, panel, stress).numbers(gamma_M1);
  of.alpha_ult = found.alpha_ult;
  if (found.per_critical > 0.0) of.alpha_cr = 1.0 / found.per_critical;
  of.lambda = found.lambda;
  of.rho_x = found.rho_x;
  of.rho_z = found.rho_z;
  of.chi_w = found.chi_w;
  of.use = found.use;
  return of;
}

Traced derive_reduced_use(Derivation& steps, const ShearPanel& panel, const PanelStress& stress,
                          double gamma_M1) {
  return ReducedPanel<Traced, Traced, Derivation>(steps, panel, stress).numbers(gamma_M1).use;
}

}  // namespace boxbeam
