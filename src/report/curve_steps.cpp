#include "sheet_steps.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

/// k_s, whose formula the catalogue's row asks for; only its value is kept with the detail.
Traced derive_size_factor(Derivation& steps, const Detail& detail) {
  Traced k_s = steps.known("k_s", detail.size_factor);
  const auto as = [&](const char* formula) {
    k_s = steps.define("k_s", steps.known(formula, detail.size_factor), "size effect, 7.2.2");
  };
  switch (detail.size_effect) {
    case SizeEffect::butt: as("(25 mm/t)^0.2"); break;
    case SizeEffect::eccentric_butt:
      as("(25 mm/t_1)^0.2/(1 + (6 e/t_1) t_1^1.5/(t_1^1.5 + t_2^1.5))");
      break;
    case SizeEffect::bolt: as("(30 mm/d)^0.25"); break;
    case SizeEffect::none: steps.given("k_s", detail.size_factor, {}, "size effect, 7.2.2"); break;
  }
  return k_s;
}

}  // namespace

void derive_curve(Derivation& steps, const SnCurve& curve, const BeamDetail* detail) {
  const bool direct = curve.kind == StressKind::direct;
  const std::string symbol = symbol_of(curve) + "_C";
  if (detail != nullptr && detail->detail.size_factor != 1.0) {
    const Traced k_s = derive_size_factor(steps, detail->detail);
    steps.define({symbol, ""}, k_s * steps.known("d_sigma_cat", detail->detail.curve.reference));
  } else {
    steps.given({symbol, ""}, curve.reference);
  }
  steps.note([&] {
    return fmt::format("{} {} ({} stress): strength at {} cycles", curve.code, curve.name,
                       direct ? "direct" : "shear", text::cycles(curve.reference_cycles));
  });
  if (detail != nullptr) {
    const Detail& of = detail->detail;
    if (!of.row.empty()) steps.note([&] { return fmt::format("row {}: {}", of.row, of.name); });
    if (!detail->assumed.empty()) steps.note([&] { return "ASSUMED: " + detail->assumed; });
  }
  if (curve.unconfirmed) steps.note([] { return "UNCONFIRMED figures"; });
  derive_corners(steps, curve);
}

}  // namespace boxbeam::report
