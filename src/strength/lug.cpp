#include "boxbeam/strength/lug.hpp"

#include <algorithm>

namespace boxbeam {
namespace {

template <class Value, class Record>
Value resistance_of(Record& record, const Lug& lug, Stress yield_strength, double gamma_M0) {
  const auto t = record.given("t", lug.thickness);
  const auto d_0 = record.given("d_0", lug.hole, "hole");
  const auto f_y = record.given("f_y", yield_strength);
  const auto gamma = record.known("gamma_M0", gamma_M0, {ValueKind::factor});
  const auto c = record.given("c", 0.5 * (lug.width - lug.hole), "beside the hole");
  const Value beside(
      record.define("F_c", 2.0 * t * f_y * (c - d_0 / 3.0) / gamma, "table 3.9, by the width"));
  if (!lug.end) return Value(record.define("F_Rd", beside));
  const auto a = record.given("a", *lug.end, "from the hole to the end of the plate");
  const Value before(
      record.define("F_a", 2.0 * t * f_y * (a - 2.0 * d_0 / 3.0) / gamma, "table 3.9, by the end"));
  return Value(record.define("F_Rd", least_of<Value>({beside, before})));
}

}  // namespace

Area lug_net_area(const Lug& lug) { return lug_net_area(plainly, lug); }

double lug_concentration(const Lug& lug) { return lug_concentration(plainly, lug); }

Force lug_resistance_of(const Lug& lug, Stress yield_strength, double gamma_M0) {
  return std::max(Force{}, resistance_of<Force>(plainly, lug, yield_strength, gamma_M0));
}

Traced derive_lug_resistance(Derivation& steps, const Lug& lug, Stress yield_strength,
                             double gamma_M0) {
  return resistance_of<Traced>(steps, lug, yield_strength, gamma_M0);
}

}  // namespace boxbeam
