#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/fatigue/reduced_range.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/section/equivalent_stress.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/strength/yield.hpp"
#include "derivation_text.hpp"
#include "sheet_steps.hpp"

namespace boxbeam {

using namespace report;

namespace {

std::string at_extreme(const Project& project, const Extreme& extreme) {
  const std::string& name = project.situations[extreme.situation].name;
  return fmt::format("at t = {}{}", text::seconds(extreme.time.value()),
                     name.empty() ? "" : ", " + name);
}

Step time_step(const Check& check, const char* what) {
  return {"t",
          {text::seconds(check.time.value())},
          {fmt::format("{}{}", what, check.situation.empty() ? "" : ", " + check.situation)}};
}

/// A stress under the load factor of its situation, as itself where that is one.
Traced loaded(Derivation& steps, const Project& project, const CheckBasis& basis,
              const Traced& stress) {
  const double factor = project.situations[basis.running].load_factor;
  return factor == 1.0 ? stress
                       : Traced(steps.known("gamma_F", factor, {ValueKind::factor}) * stress);
}

std::string plate_text(const PlateOf& plate) {
  return fmt::format("{}, plate {}", plate.material->name, text::mm(plate.thickness.value()));
}

/// f_y/(gamma_M0 acting) from the yield strength of the plate on.
void derive_yield_factor(Derivation& steps, const Project& project, Stress yield_strength,
                         const PlateOf& plate, const Traced& acting) {
  const Traced f_y = steps.given("f_y", yield_strength, plate_text(plate));
  steps.define("factor", yield_resistance(steps, f_y, project.strength.gamma_M0) / acting);
}

Steps yield_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  Steps steps{time_step(check, "where the equivalent stress is largest")};
  const StressPoint& point = basis.point;
  // In Pa, and of the normal stress, beside which it would be lost.
  constexpr double no_stress = 1e-3, lost_beside = 1e-7;
  const bool sheared =
      std::abs(basis.stress_at_time.shear.value()) >=
      std::max(no_stress, lost_beside * std::abs(basis.stress_at_time.normal.value()));
  Derivation of;
  derive_normal_section(of, project, point);
  const Traced sigma = derive_normal_stress(of, "sigma", project, point, basis.cut_at_time);
  if (sheared) derive_shear_section(of, project, point);
  const Traced tau = derive_shear_stress(of, "tau", project, point, basis.cut_at_time);
  const Traced alone = equivalent_stress(sigma, tau);
  const Traced acting = loaded(of, project, basis, alone);
  const bool factored = acting.value() != alone.value();
  const Traced sigma_v =
      of.define("sigma_v", acting, factored ? "gamma_F: load factor of the situation" : "");
  derive_yield_factor(of, project, point.yield_strength, point.first_to_yield, sigma_v);
  append(steps, steps_of(of));
  return steps;
}

/// Both extremes of a stress.
struct Extremes {
  Traced highest, lowest;
};

/// The steps that lead to both extremes of the stress of a check.
Extremes derive_extremes(Derivation& steps, const Project& project, const CheckBasis& basis) {
  const StressPoint& point = basis.point;
  const bool shear = basis.kind == StressKind::shear;
  shear ? derive_shear_section(steps, project, point)
        : derive_normal_section(steps, project, point);
  const auto extreme = [&](const std::string& symbol, const Extreme& at, const CutForces& cut) {
    const std::string when = at_extreme(project, at);
    return shear ? derive_shear_stress(steps, symbol, project, point, cut, when)
                 : derive_normal_stress(steps, symbol, project, point, cut, when);
  };
  const std::string name = shear ? "tau" : "sigma";
  const Traced highest = extreme(name + "_max", basis.highest, basis.cut_at_highest);
  return {highest, extreme(name + "_min", basis.lowest, basis.cut_at_lowest)};
}

/// The range of a stress, as a check has it; its steps behind those of its extremes.
Traced derive_range(Derivation& steps, const CheckBasis& basis, const Extremes& stress) {
  const StressPoint& point = basis.point;
  const bool shear = basis.kind == StressKind::shear;
  const Traced nominal = stress.highest - stress.lowest;
  const Traced k_f = steps.known("k_f", basis.stress_factor, {ValueKind::factor});
  const bool factored = basis.stress_factor != 1.0;
  Traced range =
      steps.define(shear ? "d_tau" : "d_sigma", factored ? Traced(k_f * nominal) : nominal,
                   shear ? "range of the shear stress" : "range of the direct stress");
  if (factored) steps.note([] { return "k_f: stress of the detail over the nominal one, 6.3"; });
  if (!shear && point.lag && !point.concentration) {
    const auto whole = [&](const CutForces& cut) { return stress_at(point.prismatic, cut).normal; };
    steps.note([] { return "{} without shear lag"; },
               steps.known("d_sigma", Stress(basis.stress_factor * (whole(basis.cut_at_highest) -
                                                                    whole(basis.cut_at_lowest)))));
  }
  return range;
}

/// 60 % of compression, where the detail is not welded.
void derive_reduced_range(Derivation& steps, const CheckBasis& basis, const Extremes& stress,
                          const Traced& range) {
  const Traced k_f = steps.known("k_f", basis.stress_factor, {ValueKind::factor});
  const auto counted = [&](const Traced& of) {
    return basis.stress_factor == 1.0 ? of : Traced(k_f * of);
  };
  steps.define("d_sigma_red", reduced_range(counted(stress.highest), counted(stress.lowest), range),
               "compression counts 60 %, 7.2.1: so in the ranges of all cycles");
}

Steps fatigue_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  Derivation of;
  const Extremes extremes = derive_extremes(of, project, basis);
  const Traced range = derive_range(of, basis, extremes);
  if (basis.kind == StressKind::direct && basis.point.compression_reduced)
    derive_reduced_range(of, basis, extremes, range);
  for (const SnCurve& curve : basis.curves)
    derive_curve(of, curve, curve.kind == StressKind::direct ? basis.point.detail : nullptr);
  Steps steps = steps_of(of);
  append(steps, life_steps(project, check, basis));
  return steps;
}

Steps stress_range_steps(const Project& project, const CheckBasis& basis) {
  Derivation of;
  const Extremes extremes = derive_extremes(of, project, basis);
  const Traced range = derive_range(of, basis, extremes);
  const Traced f_y =
      of.given("f_y", basis.point.yield_strength, plate_text(basis.point.first_to_yield));
  const Traced limit = of.define("limit", range_limit(of, f_y, basis.kind));
  const Traced gamma_Ff =
      of.known("gamma_Ff", project.fatigue.demand.gamma_Ff, {ValueKind::factor});
  of.define("factor", limit / (gamma_Ff * range));
  return steps_of(of);
}

Steps throat_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  Steps steps{time_step(check, "where the shear flow is largest")};
  Derivation of;
  derive_shear_section(of, project, basis.point);
  const Traced tau = derive_shear_stress(of, "tau_par", project, basis.point, basis.cut_at_time);
  of.given("f_u", basis.weld.tensile_strength, plate_text(basis.point.joined));
  const Traced limit = weld_shear_strength(of, basis.weld);
  of.define("factor", limit / loaded(of, project, basis, abs(tau)));
  append(steps, steps_of(of));
  return steps;
}

/// The throat of a weld around a profile: its stresses from N, M, V and T in the weld's line.
Steps weld_line_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const StressPoint& point = basis.point;
  Steps steps{time_step(check, "where the throat is used most")};
  Derivation of;
  derive_normal_section(of, project, point);
  const Traced sigma_w = derive_normal_stress(of, "sigma_w", project, point, basis.cut_at_time);
  derive_shear_section(of, project, point);
  const Traced tau_par = derive_shear_stress(of, "tau_par", project, point, basis.cut_at_time);
  const Traced sigma_v = derive_throat_stress(of, sigma_w, tau_par);
  of.note([&] {
    return fmt::format(
        "the weld's line is a {} section as thick as its throat with what it penetrates beyond, "
        "its middle the root on the outline of the profile, or so deep below it",
        std::holds_alternative<RoundTube>(point.section.outer) ? "round" : "rectangular");
  });
  of.given("f_u", basis.weld.tensile_strength, plate_text(point.joined));
  const Traced limit = weld_strength(of, basis.weld);
  of.define("factor", limit / loaded(of, project, basis, sigma_v));
  append(steps, steps_of(of));
  return steps;
}

Steps given_yield_steps(const Project& project, const GivenBasis& basis) {
  Derivation of;
  const Traced sigma = of.given("sigma", basis.stress.peak, "given, largest");
  const PlateOf plate =
      first_to_yield(plates_around(project, basis.stress.s, basis.stress.thickness));
  derive_yield_factor(of, project, basis.strength, plate, sigma);
  return steps_of(of);
}

Steps given_fatigue_steps(const Project& project, const GivenBasis& basis) {
  const FatigueInput& fatigue = project.fatigue;
  const BeamDetail& detail = *basis.resisting.detail;
  const SnCurve curve = curve_of(detail.detail);
  Derivation of;
  const Traced range = of.define(
      "d_sigma",
      of.known("sigma_1", basis.stress.peak) + of.known("sigma_2", *basis.stress.opposite),
      "range of the direct stress, both extremes given as positive numbers");
  derive_curve(of, curve, &detail);
  derive_strength(of, curve, most_cycles_of(project), fatigue.demand.loading);
  const Traced strength = of.known("d_sigma_R", basis.strength);
  if (fatigue.round_strength_to) {
    of.note([] { return "taken as {}, rounded to multiples of {} as published"; }, strength,
            of.known("step", *fatigue.round_strength_to));
  }
  const Traced gamma_Ff = of.known("gamma_Ff", fatigue.demand.gamma_Ff, {ValueKind::factor});
  const Traced gamma_Mf = of.known("gamma_Mf", fatigue.demand.gamma_Mf, {ValueKind::factor});
  const Traced allowed = of.define("d_sigma_Rd", strength / (gamma_Ff * gamma_Mf),
                                   "limit: the range that the life allows");
  of.define("factor", allowed / range);
  return steps_of(of);
}

/// A deflection under the loads times one: in space of both directions together.
Traced bent(Derivation& of, const DeflectionBasis& basis, bool in_space) {
  if (!in_space) return of.known("int m M/(E I_y) ds + int v V/(G A_v) ds", basis.alone);
  const Traced along_y = of.define(
      "w_y", of.known("int m M_z/(E I_z) ds + int v V_y/(G A_y) ds", si<Length>(basis.along[0])));
  const Traced along_z = of.define(
      "w_z", of.known("int m M_y/(E I_y) ds + int v V_z/(G A_z) ds", si<Length>(basis.along[1])));
  return sqrt(along_y * along_y + along_z * along_z);
}

Steps deflection_steps(const Project& project, const Check& check, const DeflectionBasis& basis) {
  const DeflectionInput& input = *project.deflection;
  Derivation of;
  Traced w = of.known("w", basis.alone);
  if (basis.load_factor != 1.0) {
    const Traced w_1 = of.given("w_1", basis.alone, "without load factor");
    const Traced gamma_F = of.given("gamma_F", basis.load_factor, {ValueKind::factor},
                                    "load factor of the situation, as the case asks");
    w = of.define("w", gamma_F * w_1);
  } else {
    w = of.define("w", bent(of, basis, project.in_space));
  }
  of.note([&] {
    return fmt::format("at s = {} m, t = {}{}", to_text(check.station),
                       text::seconds(check.time.value()),
                       check.situation.empty() ? "" : ", " + check.situation);
  });
  of.note([&] { return "measured from " + input.measured_from; });
  of.note([&] {
    return fmt::format(
        "m, v: cut forces of a unit force there on the beam, held as that line says; E = {}, "
        "G = {}",
        text::MPa(input.youngs_modulus.value()), text::MPa(input.shear_modulus.value()));
  });
  const Traced limit = of.given("w_lim", input.limit, "limit, given by the case");
  of.define("factor", limit / w);
  return steps_of(of);
}

const NeighbourResult& neighbour_of(const Verification& verification, const Check& check) {
  return *std::find_if(
      verification.neighbours.begin(), verification.neighbours.end(),
      [&](const NeighbourResult& neighbour) { return neighbour.check.id == check.id; });
}

Steps steps_of_check(const Project& project, const Verification& verification,
                     const CheckResult& result) {
  const Check& check = result.check;
  switch (check.criterion) {
    case Criterion::pin:
    case Criterion::lug_fatigue:
    case Criterion::rod:
    case Criterion::buckling: return neighbour_steps(project, neighbour_of(verification, check));
    case Criterion::deflection: return deflection_steps(project, check, *result.deflection);
    case Criterion::effective_section:
    case Criterion::shear_buckling:
    case Criterion::interaction: return plate_steps(project, result);
    case Criterion::reduced_stress:
      return result.patch ? patch_steps(project, result) : plate_steps(project, result);
    case Criterion::patch_loading: return patch_steps(project, result);
    case Criterion::patch_fatigue: return pressed_steps(project, result);
    case Criterion::distortion:
    case Criterion::distortion_fatigue: return distortion_steps(project, result);
    case Criterion::member: return member_steps(project, result);
    default: break;
  }
  if (result.given) {
    return check.criterion == Criterion::yield ? given_yield_steps(project, *result.given)
                                               : given_fatigue_steps(project, *result.given);
  }
  if (result.patch) return patch_steps(project, result);
  const CheckBasis& basis = *result.basis;
  switch (check.criterion) {
    case Criterion::yield: return yield_steps(project, check, basis);
    case Criterion::stress_range: return stress_range_steps(project, basis);
    case Criterion::weld:
      return basis.point.on_throat ? throat_steps(project, check, basis)
                                   : weld_line_steps(project, check, basis);
    default: return fatigue_steps(project, check, basis);
  }
}

/// The throat that would do, beside the one that is there.
void add_sufficient_throat(const CheckResult& result, Steps& steps) {
  if (!result.sufficient_throat) return;
  const bool forced = result.patch.has_value();
  const bool seam = !forced && result.basis->point.on_throat;
  const bool of_diaphragm = forced && std::holds_alternative<StiffenerWeld>(result.patch->bears);
  Derivation of;
  of.given(
      "a_suf", *result.sufficient_throat,
      fmt::format(
          "the throat that suffices for {}{}",
          of_diaphragm ? "these welds under this force"
          : forced     ? "the seam under this force"
          : seam       ? "the seam at this place, static and in fatigue"
                       : "all checks of this weld's throat and root",
          *result.sufficient_throat <= least_throat() ? ": the least, EN 1993-1-8, 4.5.2(2)" : ""));
  // A sheet ends with its factor.
  const Steps step = steps_of(of);
  steps.insert(steps.end() - 1, step.begin(), step.end());
}

std::string title_of(const Project& project, const CheckResult& result) {
  const Check& check = result.check;
  if (!check.on_beam) return fmt::format("{} {}", to_text(check.criterion), check.point);
  std::string title = fmt::format("{} at s = {} m, {}", to_text(check.criterion),
                                  to_text(check.station), check.point);
  if (!result.basis) return result.given ? title + ", stresses given" : title;
  const StressPoint& point = result.basis->point;
  return project.in_space ? fmt::format("{} (y = {}, z = {})", title, text::mm(point.y.value()),
                                        text::mm(point.z.value()))
                          : fmt::format("{} (z = {})", title, text::mm(point.z.value()));
}

}  // namespace

Sheet sheet_of(const Project& project, const Verification& verification,
               const CheckResult& result) {
  const Check& check = result.check;
  Sheet sheet;
  sheet.id = check.id;
  sheet.title = title_of(project, result);
  sheet.steps = steps_of_check(project, verification, result);
  add_sufficient_throat(result, sheet.steps);
  sheet.mark = check.passes() ? Mark::passes : Mark::fails;
  sheet.result =
      fmt::format("factor {}, required {}, utilisation {}: {}",
                  text::significant(check.safety_factor, 4), text::significant(check.required, 3),
                  text::percent(check.utilisation()), to_text(sheet.mark));
  sheet.utilisation = check.utilisation();
  sheet.source = check.source;
  return sheet;
}

}  // namespace boxbeam
