#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "boxbeam/report/report.hpp"
#include "curve_steps.hpp"
#include "fatigue_steps.hpp"
#include "neighbour_steps.hpp"
#include "stress_steps.hpp"

namespace boxbeam {

using namespace report;

namespace {

/// The factor of a check as "formula = values = result".
Step factor_step(const Check& check, const std::string& formula, const std::string& values) {
  return {"factor", {formula, values, text::significant(check.safety_factor, 4)}, {}};
}

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

/// "1.10 x " for loads taken with a factor, "" else.
std::string load_factor_text(const Project& project, const CheckBasis& basis) {
  const double factor = project.situations[basis.running].load_factor;
  return factor == 1.0 ? "" : number(factor) + " x ";
}

Step yield_strength_step(const Project& project, Stress strength, Length plate) {
  return {"f_y",
          {text::MPa(strength.value())},
          {fmt::format("{}, plate {}", project.material.name, text::mm(plate.value()))}};
}

Steps yield_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  Steps steps{time_step(check, "where the equivalent stress is largest")};
  constexpr double no_stress = 1.0;  // Pa
  const bool sheared = std::abs(basis.stress_at_time.shear.value()) >= no_stress;
  append(steps, normal_section_steps(project, basis.point));
  append(steps, normal_stress_steps("sigma", project, basis.point, basis.cut_at_time));
  if (sheared) append(steps, shear_section_steps(project, basis.point));
  append(steps, shear_stress_steps("tau", project, basis.point, basis.cut_at_time));
  const std::string gamma = load_factor_text(project, basis);
  const std::string sigma = text::MPa(basis.stress_at_time.normal.value());
  const std::string tau = sheared ? text::MPa(basis.stress_at_time.shear.value()) : "0 MPa";
  const std::string acting = text::MPa(check.acting.value());
  Step equivalent{"sigma_v",
                  {(gamma.empty() ? "" : "gamma_F ") + std::string("sqrt(sigma^2 + 3 tau^2)"),
                   fmt::format("{}sqrt(({})^2 + 3 x ({})^2)", gamma, sigma, tau), acting},
                  {}};
  if (!gamma.empty()) equivalent.notes.emplace_back("gamma_F: load factor of the situation");
  steps.push_back(equivalent);
  steps.push_back(yield_strength_step(project, basis.point.yield_strength, basis.point.plate));
  steps.push_back(
      factor_step(check, "f_y/(gamma_M0 sigma_v)",
                  fmt::format("{}/({} x {})", text::MPa(basis.point.yield_strength.value()),
                              number(project.strength.gamma_M0), acting)));
  return steps;
}

/// Both extremes of a stress and their range.
/// `factor`: of the detail, on the direct stress.
Steps range_steps(const Project& project, const CheckBasis& basis, bool shear, double factor) {
  const StressPoint& point = basis.point;
  Steps steps = shear ? shear_section_steps(project, point) : normal_section_steps(project, point);
  const auto stress = [&](const std::string& symbol, const Extreme& extreme, const CutForces& cut) {
    Steps of = shear ? shear_stress_steps(symbol, project, point, cut)
                     : normal_stress_steps(symbol, project, point, cut);
    of.back().notes.insert(of.back().notes.begin(), at_extreme(project, extreme));
    append(steps, of);
  };
  const std::string name = shear ? "tau" : "sigma";
  stress(name + "_max", basis.highest, basis.cut_at_highest);
  stress(name + "_min", basis.lowest, basis.cut_at_lowest);
  const StressSum difference =
      difference_of(basis.highest.value / factor, basis.lowest.value / factor);
  Step range{"d_" + name,
             {fmt::format("{0}_max - {0}_min", name), difference.terms},
             {fmt::format("range of the {} stress", shear ? "shear" : "direct")}};
  if (factor != 1.0) {
    range.formulas = {fmt::format("k_f ({0}_max - {0}_min)", name),
                      fmt::format("{} x ({})", number(factor), difference.terms)};
    range.notes.emplace_back("k_f: stress of the detail over the nominal one, 6.3");
  }
  range.formulas.push_back(text::MPa(basis.highest.value - basis.lowest.value));
  if (!shear && point.lag && !point.concentration) {
    const auto whole = [&](const CutForces& cut) {
      return stress_at(point.prismatic, cut).normal.value();
    };
    range.notes.push_back(fmt::format(
        "{} without shear lag",
        text::MPa(factor * (whole(basis.cut_at_highest) - whole(basis.cut_at_lowest)))));
  }
  steps.push_back(range);
  return steps;
}

/// 60 % of compression, where the detail is not welded.
Steps compression_steps(const CheckBasis& basis) {
  const double factor = basis.point.detail->stress_factor;
  const double high = basis.highest.value, low = basis.lowest.value;
  const double tensile = std::max(high, 0.0) - std::max(low, 0.0);
  const double compressive = std::min(high, 0.0) - std::min(low, 0.0);
  Step step{"d_sigma_red", {}, {"compression counts 60 %, 7.2.1: so in the ranges of all cycles"}};
  if (compressive == 0.0) {
    step.formulas = {"d_sigma"};
  } else if (tensile == 0.0) {
    step.formulas = {"0.6 d_sigma", "0.6 x " + text::MPa(compressive)};
  } else {
    step.formulas = {"sigma_max - 0.6 sigma_min",
                     fmt::format("{} + 0.6 x {}", text::MPa(tensile), text::MPa(compressive))};
    // The factor of the detail is in both values.
    if (factor != 1.0) step.formulas.front() = "k_f (sigma_max - 0.6 sigma_min)";
  }
  step.formulas.push_back(text::MPa(tensile + 0.6 * compressive));
  return {step};
}

Steps fatigue_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const bool shear = check.criterion == Criterion::shear_fatigue;
  Steps steps = range_steps(project, basis, shear, shear ? 1.0 : basis.point.detail->stress_factor);
  if (!shear && basis.point.compression_reduced) append(steps, compression_steps(basis));
  for (const SnCurve& curve : basis.curves) {
    append(steps,
           curve_steps(curve, curve.kind == StressKind::direct ? basis.point.detail : nullptr));
  }
  append(steps, life_steps(project, check, basis));
  return steps;
}

Steps stress_range_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const double f_y = basis.point.yield_strength.value();
  // Which of the two ranges governs shows in the limit.
  const bool shear = check.resisting.value() < 1.4 * f_y;
  Steps steps = range_steps(project, basis, shear, shear ? 1.0 : basis.point.range_factor);
  steps.push_back(yield_strength_step(project, basis.point.yield_strength, basis.point.plate));
  const std::string limit = text::MPa(check.resisting.value());
  steps.push_back({"limit",
                   {shear ? "1.5 f_y/sqrt(3)" : "1.5 f_y",
                    fmt::format("1.5 x {}{}", text::MPa(f_y), shear ? "/sqrt(3)" : ""), limit},
                   {}});
  steps.push_back(
      factor_step(check, shear ? "limit/(gamma_Ff d_tau)" : "limit/(gamma_Ff d_sigma)",
                  fmt::format("{}/({} x {})", limit, number(project.fatigue.demand.gamma_Ff),
                              text::MPa(basis.highest.value - basis.lowest.value))));
  return steps;
}

Steps throat_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  Steps steps{time_step(check, "where the shear flow is largest")};
  append(steps, shear_section_steps(project, basis.point));
  append(steps, shear_stress_steps("tau_par", project, basis.point, basis.cut_at_time));
  const std::string f_u =
      text::MPa(tensile_strength_of(project.material, basis.point.plate)->value());
  steps.push_back(
      {"f_u",
       {f_u},
       {fmt::format("{}, plate {}", project.material.name, text::mm(basis.point.plate.value()))}});
  const std::string limit = text::MPa(check.resisting.value());
  steps.push_back({"limit",
                   {"f_u/(sqrt(3) beta_w gamma_M2)",
                    fmt::format("{}/(sqrt(3) x {} x {})", f_u, number(project.material.beta_w),
                                number(project.strength.gamma_M2)),
                    limit},
                   {}});
  const std::string gamma = load_factor_text(project, basis);
  const std::string tau = text::MPa(basis.stress_at_time.shear.value());
  steps.push_back(factor_step(check,
                              gamma.empty() ? "limit/abs(tau_par)" : "limit/(gamma_F abs(tau_par))",
                              gamma.empty() ? fmt::format("{}/abs({})", limit, tau)
                                            : fmt::format("{}/({}abs({}))", limit, gamma, tau)));
  return steps;
}

/// The throat of a weld around a profile: its stresses from N, M, V and T in the weld's line.
Steps weld_line_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const StressPoint& point = basis.point;
  Steps steps{time_step(check, "where the throat is used most")};
  append(steps, normal_section_steps(project, point));
  append(steps, normal_stress_steps("sigma_w", project, point, basis.cut_at_time));
  append(steps, shear_section_steps(project, point));
  append(steps, shear_stress_steps("tau_par", project, point, basis.cut_at_time));
  const double normal = basis.stress_at_time.normal.value();
  const double shear = basis.stress_at_time.shear.value();
  const std::string sigma = text::MPa(normal), tau = text::MPa(shear);
  const std::string acting =
      text::MPa(std::hypot(std::numbers::sqrt2 * normal, std::numbers::sqrt3 * shear));
  steps.push_back(
      {"sigma_v",
       {"sqrt(2 sigma_w^2 + 3 tau_par^2)", fmt::format("sqrt(2 x ({})^2 + 3 x ({})^2)", sigma, tau),
        acting},
       {"sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) with sigma_perp = tau_perp = "
        "sigma_w/sqrt(2) of equal legs; sigma_perp alone is held with it",
        fmt::format(
            "the weld's line is a {} section as thick as its throat, its middle the "
            "outline of the profile",
            std::holds_alternative<RoundTube>(point.section.outer) ? "round" : "rectangular")}});
  const std::string f_u = text::MPa(tensile_strength_of(project.material, point.plate)->value());
  steps.push_back(
      {"f_u",
       {f_u},
       {fmt::format("{}, plate {}", project.material.name, text::mm(point.plate.value()))}});
  const std::string limit = text::MPa(check.resisting.value());
  steps.push_back({"limit",
                   {"f_u/(beta_w gamma_M2)",
                    fmt::format("{}/({} x {})", f_u, number(project.material.beta_w),
                                number(project.strength.gamma_M2)),
                    limit},
                   {}});
  const std::string gamma = load_factor_text(project, basis);
  steps.push_back(factor_step(check, gamma.empty() ? "limit/sigma_v" : "limit/(gamma_F sigma_v)",
                              gamma.empty() ? fmt::format("{}/{}", limit, acting)
                                            : fmt::format("{}/({}{})", limit, gamma, acting)));
  return steps;
}

Steps given_yield_steps(const Project& project, const Check& check, const GivenStress& given) {
  const std::string sigma = text::MPa(given.peak.value());
  const Stress f_y = *yield_strength_of(project.material, given.thickness);
  return {{"sigma", {sigma}, {"given, largest"}},
          yield_strength_step(project, f_y, given.thickness),
          factor_step(check, "f_y/(gamma_M0 sigma)",
                      fmt::format("{}/({} x {})", text::MPa(f_y.value()),
                                  number(project.strength.gamma_M0), sigma))};
}

Steps given_fatigue_steps(const Project& project, const Check& check, const GivenStress& given) {
  const FatigueInput& fatigue = project.fatigue;
  const SnCurve curve = curve_of(fatigue.beam.detail);
  const std::string range = text::MPa(check.acting.value());
  Steps steps{
      {"d_sigma",
       {"sigma_1 + sigma_2",
        fmt::format("{} + {}", text::MPa(given.peak.value()), text::MPa(given.opposite->value())),
        range},
       {"range of the direct stress, both extremes given as positive numbers"}}};
  append(steps, curve_steps(curve, &fatigue.beam));
  Step strength = strength_step(curve, most_cycles_of(project), fatigue.demand.loading);
  const double rounded_strength =
      check.resisting.value() * fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf;
  const std::string R = text::MPa(rounded_strength);
  if (fatigue.round_strength_to) {
    strength.notes.push_back(fmt::format("taken as {}, rounded to multiples of {} as published", R,
                                         text::MPa(fatigue.round_strength_to->value())));
  }
  steps.push_back(std::move(strength));
  const std::string gammas =
      fmt::format("{} x {}", number(fatigue.demand.gamma_Ff), number(fatigue.demand.gamma_Mf));
  const std::string limit = text::MPa(check.resisting.value());
  steps.push_back({"d_sigma_Rd",
                   {"d_sigma_R/(gamma_Ff gamma_Mf)", fmt::format("{}/({})", R, gammas), limit},
                   {"limit: the range that the life allows"}});
  steps.push_back(factor_step(check, "d_sigma_Rd/d_sigma", fmt::format("{}/{}", limit, range)));
  return steps;
}

Steps given_steps(const Project& project, const Check& check) {
  const auto given =
      std::find_if(project.given_stresses.begin(), project.given_stresses.end(),
                   [&](const GivenStress& stress) { return stress.name == check.point; });
  return check.criterion == Criterion::yield ? given_yield_steps(project, check, *given)
                                             : given_fatigue_steps(project, check, *given);
}

/// By which the deflection of a check is multiplied.
double load_factor_of(const Project& project, const Check& check) {
  if (!project.deflection->load_factor) return 1.0;
  const auto of = std::find_if(project.situations.begin(), project.situations.end(),
                               [&](const Situation& in) { return in.name == check.situation; });
  return of->load_factor;
}

Steps deflection_steps(const Project& project, const Check& check) {
  const DeflectionInput& input = *project.deflection;
  const double load_factor = load_factor_of(project, check);
  const std::string w = text::mm(check.acting.value());
  const std::string limit = text::mm(check.resisting.value());
  Steps steps;
  if (load_factor != 1.0) {
    steps.push_back(
        {"w_1", {text::mm(check.acting.value() / load_factor)}, {"without load factor"}});
    steps.push_back(
        {"gamma_F", {number(load_factor)}, {"load factor of the situation, as the case asks"}});
  }
  append(steps,
         {{"w",
           load_factor != 1.0
               ? std::vector<std::string>{"gamma_F w_1",
                                          fmt::format("{} x {}", number(load_factor),
                                                      text::mm(check.acting.value() / load_factor)),
                                          w}
               : std::vector<std::string>{"int m M/(E I_y) ds + int v V/(G A_v) ds", w},
           {fmt::format("at s = {} m, t = {}{}", to_text(check.station),
                        text::seconds(check.time.value()),
                        check.situation.empty() ? "" : ", " + check.situation),
            "measured from " + input.measured_from,
            fmt::format(
                "m, v: cut forces of a unit force there on the beam, held as that line says; "
                "E = {}, G = {}",
                text::MPa(input.youngs_modulus.value()), text::MPa(input.shear_modulus.value()))}},
          {"w_lim", {limit}, {"limit, given by the case"}},
          factor_step(check, "w_lim/w", fmt::format("{}/{}", limit, w))});
  return steps;
}

const NeighbourResult& neighbour_of(const Verification& verification, const Check& check) {
  return *std::find_if(
      verification.neighbours.begin(), verification.neighbours.end(),
      [&](const NeighbourResult& neighbour) { return neighbour.check.id == check.id; });
}

Steps steps_of(const Project& project, const Verification& verification,
               const CheckResult& result) {
  const Check& check = result.check;
  switch (check.criterion) {
    case Criterion::pin: return pin_steps(project, neighbour_of(verification, check));
    case Criterion::rod: return pulled_rod_steps(project, neighbour_of(verification, check));
    case Criterion::buckling: return pressed_rod_steps(project, neighbour_of(verification, check));
    case Criterion::deflection: return deflection_steps(project, check);
    default: break;
  }
  if (!result.basis) return given_steps(project, check);
  const CheckBasis& basis = *result.basis;
  switch (check.criterion) {
    case Criterion::yield: return yield_steps(project, check, basis);
    case Criterion::stress_range: return stress_range_steps(project, check, basis);
    case Criterion::weld:
      return basis.point.on_throat ? throat_steps(project, check, basis)
                                   : weld_line_steps(project, check, basis);
    default: return fatigue_steps(project, check, basis);
  }
}

std::string title_of(const Project& project, const CheckResult& result) {
  const Check& check = result.check;
  if (!check.on_beam) return fmt::format("{} {}", to_text(check.criterion), check.point);
  std::string title = fmt::format("{} at s = {} m, {}", to_text(check.criterion),
                                  to_text(check.station), check.point);
  if (!result.basis) {
    return check.criterion == Criterion::deflection ? title : title + ", stresses given";
  }
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
  sheet.steps = steps_of(project, verification, result);
  sheet.result =
      fmt::format("factor {}, required {}, utilisation {}: {}",
                  text::significant(check.safety_factor, 4), text::significant(check.required, 3),
                  text::percent(check.utilisation()), check.passes() ? "passes" : "FAILS");
  sheet.utilisation = check.utilisation();
  sheet.mark = check.passes() ? Mark::passes : Mark::fails;
  sheet.source = check.source;
  return sheet;
}

}  // namespace boxbeam
