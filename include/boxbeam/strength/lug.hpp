#pragma once

#include <optional>

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {

/// A plate with a hole for a pin, pulled by it.
struct Lug {
  Length width;               ///< w, across the force at the middle of the hole
  Length hole;                ///< its diameter d_0
  Length thickness;           ///< t
  std::optional<Length> end;  ///< a, from the hole's edge to the end of the plate before the force
};

/// The ratio of hole to width between which `lug_concentration` is known.
inline constexpr double narrowest_hole = 0.15, widest_hole = 0.5;

/// The net section of a lug beside its hole, A_net = (w - d_0) t, of which no more of the width
/// counts than d_0/0.15.
template <class Record>
auto lug_net_area(Record& record, const Lug& lug) {
  const Length most = lug.hole / narrowest_hole;
  const auto w = lug.width > most
                     ? record.given("w", most, "of the plate, as much as counts, d_0/0.15")
                     : record.given("w", lug.width, "of the plate");
  const auto d_0 = record.given("d_0", lug.hole, "hole");
  const auto t = record.given("t", lug.thickness);
  return record.define("A_net", (w - d_0) * t, "beside the hole");
}

/// The largest stress at the hole of a lug that a close pin pulls, over that of its net section.
///
///     K_t = 12.882 - 52.714 x + 89.762 x^2 - 51.667 x^3,  x = d_0/w
///
/// Valid for 0.15 <= x <= 0.5 and a round or square end no shorter than the plate is wide beside
/// the hole; a pin with play, or one that bends, raises it. The polynomial is recalled, not
/// confirmed; a chart of the same ratio that a public program has digitised lies 8 % below to 5 %
/// above it. Source: Pilkey, Peterson's Stress Concentration Factors, lugs with pins, after Frocht
/// and Hill.
template <class Record>
auto lug_concentration(Record& record, const Lug& lug) {
  const auto w = record.known("w", std::min(lug.width, Length(lug.hole / narrowest_hole)));
  const auto x = record.define("x", record.known("d_0", lug.hole) / w);
  return record.define("K_t", 12.882 - 52.714 * x + 89.762 * x * x - 51.667 * x * x * x,
                       "stress at the hole over that of the net section");
}

Area lug_net_area(const Lug& lug);
double lug_concentration(const Lug& lug);

/// The force with which a lug is used up.
///
///     F_c = 2 t f_y (c - d_0/3)/gamma_M0,  c = (w - d_0)/2
///     F_a = 2 t f_y (a - 2 d_0/3)/gamma_M0, where the end is known
///
/// Zero where it is too narrow or too short for any. Source: EN 1993-1-8:2005, 3.13.1, table 3.9,
/// type A, solved for the force.
Force lug_resistance_of(const Lug& lug, Stress yield_strength, double gamma_M0);
Traced derive_lug_resistance(Derivation& steps, const Lug& lug, Stress yield_strength,
                             double gamma_M0);

}  // namespace boxbeam
