#include "sheet_steps.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/report/format.hpp"
#include "boxbeam/strength/yield.hpp"
#include "derivation_text.hpp"

namespace boxbeam::report {
namespace {

void give_torque(Derivation& steps, const CheckResult& result) {
  const DistortionBasis& basis = *result.distortion;
  const Check& check = result.check;
  steps.given("T_d", basis.torque, "the torque that does most of it");
  steps.note([&] {
    return fmt::format("comes at s = {:.6g} m, at t = {}{}", basis.introduced.value() + 0.0,
                       text::seconds(check.time.value()),
                       check.situation.empty() ? "" : ", " + check.situation);
  });
}

/// 6 m/t^2 of the moment that bends a plate, or the throat of its seam, across.
Traced derive_across(Derivation& steps, const char* symbol, const DistortionBasis& basis,
                     bool throat) {
  const Traced m =
      steps.given("m_t", si<Force>(basis.at.moment * basis.size.angle),
                  "moment across per length of the beam, N m/m: the cell as a frame of its plates");
  steps.note([&] { return fmt::format("racked by gamma = {:.4g} mrad", 1e3 * basis.size.angle); });
  const char* const letter = throat ? "a" : "t";
  const Traced t = steps.given(letter, basis.at.thickness);
  return steps.define(symbol, 6.0 * m / (t * t));
}

/// q/t of the shear of distortion.
Traced give_shear(Derivation& steps, const DistortionBasis& basis) {
  Traced tau = steps.given("tau_D", si<Stress>(std::abs(basis.at.shear) * basis.size.shear),
                           "of the flow q by which the stress along the edges changes");
  steps.note([&] {
    return fmt::format("Q = {:.4g} kN m, q = {:.4g} kN/m", 1e-3 * basis.size.shear,
                       1e-3 * std::abs(basis.at.flow) * basis.size.shear);
  });
  return tau;
}

/// 2 M_D omega/I_w.
Traced give_along(Derivation& steps, const char* symbol, const DistortionBasis& basis) {
  const double factor = basis.stress.stress_factor;
  Traced sigma =
      steps.given(symbol, si<Stress>(factor * std::abs(basis.at.along) * basis.size.moment),
                  "2 M_D omega/I_w, the edges bent with both their plates");
  steps.note([&] {
    return fmt::format("M_D = {:.4g} kN m^2, 2 omega/I_w = {:.4g} 1/m^4", 1e-3 * basis.size.moment,
                       std::abs(basis.at.along));
  });
  return sigma;
}

Traced shear_alone(Derivation& steps, const Project& project, const DistortionBasis& basis) {
  constexpr double no_stress = 1e-3;  // Pa
  const CheckBasis& stress = basis.stress;
  if (std::abs(stress.stress_at_time.shear.value()) >= no_stress)
    derive_shear_section(steps, project, stress.point);
  return abs(derive_shear_stress(steps, "tau", project, stress.point, stress.cut_at_time));
}

Traced under_load_factor(Derivation& steps, const DistortionBasis& basis, const Traced& stress) {
  if (basis.load_factor == 1.0) return stress;
  return steps.known("gamma_F", basis.load_factor, {ValueKind::factor}) * stress;
}

void derive_throat(Derivation& steps, const Project& project, const CheckResult& result) {
  const DistortionBasis& basis = *result.distortion;
  const Traced tau = shear_alone(steps, project, basis);
  const Traced sigma_t = derive_across(steps, "sigma_t", basis, true);
  const Traced tau_par = steps.define("tau_par", tau + give_shear(steps, basis));
  const Traced sigma_v = steps.define(
      "sigma_v", under_load_factor(steps, basis, bent_throat_stress(sigma_t, tau_par)));
  const WeldStrength& weld = basis.stress.weld;
  steps.given("f_u", weld.tensile_strength);
  const Traced limit = weld_strength(steps, weld);
  // sigma_perp alone is held as well.
  constexpr double of_tensile = 0.9;
  const Traced across = under_load_factor(steps, basis, sigma_t);
  const Traced limit_across =
      steps.define("limit_t", of_tensile * steps.known("f_u", weld.tensile_strength) /
                                  steps.known("gamma_M2", weld.gamma_M2, {ValueKind::factor}));
  steps.define("factor", least_of({Traced(limit / sigma_v), Traced(limit_across / across)}));
}

void derive_plate(Derivation& steps, const Project& project, const CheckResult& result) {
  const DistortionBasis& basis = *result.distortion;
  const StressPoint& point = basis.stress.point;
  derive_normal_section(steps, project, point);
  const Traced sigma =
      derive_normal_stress(steps, "sigma", project, point, basis.stress.cut_at_time);
  const Traced tau = shear_alone(steps, project, basis);
  const Traced sigma_x = steps.define("sigma_x", abs(sigma) + give_along(steps, "sigma_D", basis),
                                      "along the beam, signs taken so that they add up");
  const Traced sigma_t = derive_across(steps, "sigma_t", basis, false);
  const Traced tau_x = steps.define("tau_x", tau + give_shear(steps, basis));
  const Traced sigma_v = steps.define(
      "sigma_v", under_load_factor(steps, basis, bent_across_stress(sigma_x, sigma_t, tau_x)),
      "on the face where stresses along and across have unlike signs");
  const Traced f_y = steps.given("f_y", point.yield_strength,
                                 fmt::format("{}, plate {}", point.first_to_yield.material->name,
                                             text::mm(point.first_to_yield.thickness.value())));
  steps.define("factor", yield_resistance(steps, f_y, project.strength.gamma_M0) / sigma_v);
}

Steps range_steps(const Project& project, const CheckResult& result) {
  const DistortionBasis& basis = *result.distortion;
  const CheckBasis& stress = basis.stress;
  Derivation steps;
  give_torque(steps, result);
  const BeamDetail* detail = nullptr;
  if (basis.across) {
    derive_across(steps, "d_sigma", basis, false);
    steps.note([&] { return "range, " + project.fatigue.corner.name; });
  } else {
    const bool direct = stress.kind == StressKind::direct;
    const Traced by_distortion =
        direct ? give_along(steps, "d_sigma_D", basis) : give_shear(steps, basis);
    const Stress all = si<Stress>(stress.highest.value - stress.lowest.value);
    const Traced alone =
        steps.given(direct ? "d_sigma_0" : "d_tau_0", all - si<Stress>(by_distortion.value()),
                    "largest range without distortion");
    steps.define(direct ? "d_sigma" : "d_tau", alone + by_distortion,
                 "every range with that of distortion, and what of distortion is left over alone");
    if (direct) detail = stress.point.detail;
  }
  for (const SnCurve& curve : stress.curves)
    derive_curve(steps, curve, curve.kind == StressKind::direct ? detail : nullptr);
  Steps all = steps_of(steps);
  append(all, life_steps(project, result.check, stress));
  return all;
}

}  // namespace

Steps distortion_steps(const Project& project, const CheckResult& result) {
  if (result.check.criterion == Criterion::distortion_fatigue) return range_steps(project, result);
  Derivation steps;
  give_torque(steps, result);
  if (result.distortion->in_throat)
    derive_throat(steps, project, result);
  else
    derive_plate(steps, project, result);
  return steps_of(steps);
}

}  // namespace boxbeam::report
