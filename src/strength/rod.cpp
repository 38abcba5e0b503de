#include "boxbeam/strength/rod.hpp"

#include <algorithm>

#include "column_formulas.hpp"

namespace boxbeam {
namespace {

/// A, and A_eff in class 4.
Area area_of(const NoDerivation&, const PressedRod& rod) { return rod.section.effective; }

Traced area_of(Derivation& steps, const PressedRod& rod) {
  return derive_effective_area(steps, rod.section, rod.yield_strength);
}

/// Resistances as quantities or as expressions.
template <class Value>
struct Tension {
  Value plastic, net, least;
};
template <class Value>
Tension(Value, Value, Value) -> Tension<Value>;

template <class Record>
auto resist_tension(Record& record, const PulledRod& rod) {
  const auto A = record.given("A", rod.area);
  const auto A_net =
      record.given("A_net", rod.net_area.value_or(rod.area),
                   rod.net_area ? "given by the case" : "the case names no holes for fasteners");
  const auto f_y = record.known("f_y", rod.yield_strength);
  const auto f_u = record.known("f_u", rod.tensile_strength);
  const auto gamma_M0 = record.known("gamma_M0", rod.gamma_M0, {ValueKind::factor});
  const auto gamma_M2 = record.known("gamma_M2", rod.gamma_M2, {ValueKind::factor});
  const auto plastic = record.define("N_pl,Rd", A * f_y / gamma_M0);
  const auto net = record.define("N_u,Rd", 0.9 * A_net * f_u / gamma_M2);
  return Tension{plastic, net, record.define("N_t,Rd", least_of({plastic, net}), "limit")};
}

template <class Value, class Number>
struct Compression {
  Number slenderness, reduction;
  Value section, buckling, least;
};
template <class Value, class Number>
Compression(Number, Number, Value, Value, Value) -> Compression<Value, Number>;

template <class Record>
auto resist_compression(Record& record, const PressedRod& rod) {
  const auto A = area_of(record, rod);
  const auto I = record.given("I", rod.inertia);
  record.note([&] {
    return std::string("about the ") + (rod.weak_axis ? "z" : "y") + " axis, the weaker one";
  });
  const auto L_cr = record.given("L_cr", rod.buckling_length, "buckling length");
  const auto E = record.known("E", rod.youngs_modulus);
  const auto f_y = record.known("f_y", rod.yield_strength);
  const auto N_cr = column::euler_force(record, E, I, L_cr);
  const auto lambda = column::slenderness(record, A, f_y, N_cr);
  const auto chi = column::reduction(record, lambda, rod.curve);
  const auto buckling = column::resistance(record, chi, A, f_y, rod.gamma_M1);
  const auto gamma_M0 = record.known("gamma_M0", rod.gamma_M0, {ValueKind::factor});
  const auto of_section = A * f_y / gamma_M0;
  if (of_section < buckling) {
    const auto section = record.define("N_c,Rd", of_section, "limit: the section itself (6.2.4)");
    return Compression{lambda, chi, section, buckling, section};
  }
  record.note([] { return "limit"; });
  return Compression{lambda, chi, of_section, buckling, buckling};
}

}  // namespace

TensionResistance tension_resistance_of(const PulledRod& rod) {
  constexpr NoDerivation plainly;
  const auto of = resist_tension(plainly, rod);
  return {of.plastic, of.net, of.least};
}

void derive_tension_factor(Derivation& steps, const Traced& tension, const PulledRod& rod) {
  const Traced resistance = resist_tension(steps, rod).least;
  steps.define("factor", resistance / tension);
}

CompressionResistance compression_resistance_of(const PressedRod& rod) {
  constexpr NoDerivation plainly;
  const auto of = resist_compression(plainly, rod);
  return {of.slenderness, of.reduction, of.section, of.buckling, of.least};
}

void derive_compression_factor(Derivation& steps, const Traced& compression,
                               const PressedRod& rod) {
  const Traced resistance = resist_compression(steps, rod).least;
  steps.define("factor", resistance / compression);
}

}  // namespace boxbeam
