#include "plate_steps.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "boxbeam/strength/yield.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "derivation_text.hpp"

namespace boxbeam::report {
namespace {

/// "at t = 0.75 s, lifting"
std::string instant_of(const Check& check) {
  return fmt::format("at t = {}{}", text::seconds(check.time.value()),
                     check.situation.empty() ? "" : ", " + check.situation);
}

/// What acts, under the load factor of its situation.
Traced loaded(Derivation& steps, const PlateBasis& basis, const Traced& acting) {
  if (basis.load_factor == 1.0) return acting;
  return steps.known("gamma_F", basis.load_factor, {ValueKind::factor}) * acting;
}

/// Resistance of the corner used most, and the stress that acts there.
struct CornerSteps {
  Traced acting, resisting;
};

CornerSteps derive_corner(Derivation& steps, const Project& project, const Check& check,
                          const PlateBasis& basis) {
  const Traced stress =
      abs(derive_corner_stress(steps, basis.plates->box, basis.cut, basis.corner));
  steps.note([&] { return instant_of(check); });
  steps.note([&] {
    const BoxCorner& of = basis.corner.corner;
    return std::string(to_text(of.flange)) + " at the " + to_text(of.web);
  });
  const Traced f_y = steps.given("f_y", basis.corner.yield_strength);
  return {loaded(steps, basis, stress), yield_resistance(steps, f_y, project.strength.gamma_M0)};
}

struct ShearSteps {
  Traced acting, resisting;
};

ShearSteps derive_shear(Derivation& steps, const Project& project, const Check& check,
                        const PlateBasis& basis) {
  const ShearedPlate& plate = *basis.plate;
  // The sum of shear flows that cancel each other leaves round-off.
  const Force sum = plate.force_of(basis.cut);
  const Force acting = sum < 1e-9 * plate.resists.resistance ? Force{} : sum;
  const Traced V =
      steps.given("V_w", acting, "the shear flow of the section over the clear width of the plate");
  if (is_flange(plate.plate))
    steps.note([] { return "of at least half of its largest shear stress, 7.1(5)"; });
  steps.note([&] { return plate.name; });
  steps.note([&] { return instant_of(check); });
  steps.given("h_w", plate.panel.depth);
  steps.given("t", plate.panel.thickness);
  steps.given("f_y", plate.panel.yield_strength);
  return {loaded(steps, basis, V),
          derive_shear_resistance(steps, plate.panel, project.strength.gamma_M1)};
}

}  // namespace

Steps plate_steps(const Project& project, const CheckResult& result) {
  const PlateBasis& basis = *result.plates;
  Derivation steps;
  switch (result.check.criterion) {
    case Criterion::effective_section: {
      const CornerSteps of = derive_corner(steps, project, result.check, basis);
      steps.define("factor", of.resisting / of.acting);
      break;
    }
    case Criterion::shear_buckling: {
      const ShearSteps of = derive_shear(steps, project, result.check, basis);
      steps.define("factor", of.resisting / of.acting);
      break;
    }
    default: {
      const CornerSteps normal = derive_corner(steps, project, result.check, basis);
      const Traced eta_1 = steps.define("eta_1", normal.acting / normal.resisting);
      const ShearSteps shear = derive_shear(steps, project, result.check, basis);
      const Traced eta_3 = steps.define("eta_3", shear.acting / shear.resisting);
      derive_interaction_factor(steps, eta_1, eta_3);
      steps.note([] { return "f eta_1 + (2 f eta_3 - 1)^2 = 1"; });
    }
  }
  return steps_of(steps);
}

}  // namespace boxbeam::report
