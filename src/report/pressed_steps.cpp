#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "derivation_text.hpp"
#include "sheet_steps.hpp"

namespace boxbeam::report {

Steps pressed_steps(const Project& project, const CheckResult& result) {
  const PressedBasis& basis = *result.pressed;
  const CheckBasis& life = basis.life;
  Derivation steps;
  const auto thickness = [&] {
    if (basis.welds == 0) return steps.given("t", basis.thickness, "of the web");
    const Traced a = steps.given("a", basis.throat, "of each fillet of the diaphragm");
    return steps.define("t", a * static_cast<double>(basis.welds), "of all of them");
  };
  const Traced t = thickness();
  const Traced F = steps.given("F", basis.force, "the largest force into this web there");
  const Traced l = steps.given("l", basis.loaded,
                               basis.welds == 0 ? "s_s + 2 t_f, within the ends of the beam"
                                                : "of each, less a throat at both ends");
  steps.define("sigma_z", F / (t * l));
  const auto extreme = [&](const char* symbol, const Extreme& at) {
    return steps.given(
        symbol, si<Stress>(at.value / life.stress_factor),
        fmt::format("of all that reach the place, at t = {}", text::seconds(at.time.value())));
  };
  const Traced highest = extreme("sigma_z,max", life.highest);
  const Traced range = highest - extreme("sigma_z,min", life.lowest);
  if (basis.throat > Length{} && basis.welds == 0) {
    const Traced a = steps.given("a", basis.throat, "all throats of the seam");
    steps.define("d_sigma", t / a * range, "range of sigma_w in the throat");
  } else {
    steps.define("d_sigma", range,
                 basis.welds == 0 ? "range of sigma_z in the web" : "range in the fillets");
  }
  for (const SnCurve& curve : life.curves)
    derive_curve(steps, curve, curve.kind == StressKind::direct ? life.point.detail : nullptr);
  if (life.curves.size() > 1) steps.note([] { return "of the shear stress along the seam there"; });
  Steps all = steps_of(steps);
  append(all, life_steps(project, result.check, life));
  return all;
}

}  // namespace boxbeam::report
