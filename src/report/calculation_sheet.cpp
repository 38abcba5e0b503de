#include "calculation_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "stress_lines.hpp"

namespace boxbeam {
namespace {

std::string place_line(const Project& project, const Check& check, const CheckBasis& basis) {
  if (in_space(project)) {
    return fmt::format("    at s = {} m, {} (y = {}, z = {})\n", to_text(check.station),
                       check.point, text::mm(basis.point.y.value()),
                       text::mm(basis.point.z.value()));
  }
  return fmt::format("    at s = {} m, {} (z = {}, section height {})\n", to_text(check.station),
                     check.point, text::mm(basis.point.z.value()),
                     text::mm(2.0 * basis.point.gross.z_top.value()));
}

std::string factor_line(const Check& check, const std::string& formula) {
  return line(
      "factor",
      fmt::format("{} = {}   required {}   utilisation {}   {}", formula,
                  text::significant(check.safety_factor, 4), text::significant(check.required, 3),
                  text::percent(check.utilisation()), check.passes() ? "passes" : "FAILS"));
}

std::string yield_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  std::string out = place_line(project, check, basis);
  out += line("t", text::seconds(check.time.value()) + ", where the equivalent stress is largest");
  out += normal_stress_lines("sigma", basis.point, basis.cut_at_time, in_space(project));
  out += shear_stress_lines("tau", basis.point, basis.cut_at_time, in_space(project));
  const double load_factor = project.situations[basis.running].load_factor;
  out += line("sigma_v",
              fmt::format("{}sqrt(sigma^2 + 3 tau^2) = {}{}",
                          load_factor == 1.0 ? "" : text::significant(load_factor, 3) + " x ",
                          text::MPa(check.acting.value()),
                          check.situation.empty() ? "" : " (" + check.situation + ")"));
  out += line("f_y", fmt::format("{} ({}, plate {})", text::MPa(basis.point.yield_strength.value()),
                                 project.material.name, text::mm(basis.point.plate.value())));
  out += factor_line(
      check, fmt::format("f_y/(gamma_M0 sigma_v), gamma_M0 = {}:  {}/{}",
                         text::significant(project.strength.gamma_M0, 3),
                         text::MPa(check.resisting.value()), text::MPa(check.acting.value())));
  return out;
}

/// Both extremes of the stress that a fatigue check looks at.
std::string extreme_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  std::string out;
  const bool space = in_space(project);
  const auto at = [&](const Extreme& extreme) {
    const std::string& name = project.situations[extreme.situation].name;
    return after(fmt::format("at t = {}{}", text::seconds(extreme.time.value()),
                             name.empty() ? "" : fmt::format(" ({})", name)));
  };
  if (check.criterion == Criterion::shear_fatigue) {
    out +=
        shear_stress_lines("tau_max", basis.point, basis.cut_at_highest, space) + at(basis.highest);
    out +=
        shear_stress_lines("tau_min", basis.point, basis.cut_at_lowest, space) + at(basis.lowest);
    return out + line("range", fmt::format("tau_max - tau_min = {}",
                                           text::MPa(basis.highest.value - basis.lowest.value)));
  }
  out += normal_stress_lines("sigma_max", basis.point, basis.cut_at_highest, space) +
         at(basis.highest);
  out +=
      normal_stress_lines("sigma_min", basis.point, basis.cut_at_lowest, space) + at(basis.lowest);
  const double factor = basis.point.detail->stress_factor;
  out += line("range", fmt::format("{}(sigma_max - sigma_min) = {}",
                                   factor == 1.0 ? "" : text::significant(factor, 4) + " ",
                                   text::MPa(basis.highest.value - basis.lowest.value)));
  if (basis.point.lag && !basis.point.concentration) {
    const auto whole = [&](const CutForces& cut) {
      return stress_at(basis.point.prismatic, cut).normal.value();
    };
    out += after(fmt::format("{} without shear lag (beta = {}, L_e = {} m)",
                             text::MPa(whole(basis.cut_at_highest) - whole(basis.cut_at_lowest)),
                             text::significant(basis.point.lag->beta, 3),
                             text::significant(basis.point.lag->effective_length.value(), 3)));
  }
  return out;
}

std::string curve_lines(const Project& project, const CheckBasis& basis) {
  std::string out;
  for (const SnCurve& curve : basis.curves) {
    const bool direct = curve.kind == StressKind::direct;
    std::string category =
        fmt::format("{} ({}), {} at 2e6 cycles", curve.name, direct ? "direct" : "shear",
                    text::MPa(strength_at(curve, 2e6, Loading::spectrum).value()));
    if (direct && basis.point.detail != nullptr) {
      const Detail& detail = basis.point.detail->detail;
      if (!detail.row.empty()) category += fmt::format(", row {}: {}", detail.row, detail.name);
      if (detail.size_factor != 1.0)
        category += fmt::format(", k_s = {}", text::significant(detail.size_factor));
      if (detail.compression_reduced) category += ", compression 60 %";
      if (!basis.point.detail->assumed.empty()) category += ", ASSUMED";
    }
    if (curve.unconfirmed) category += ", UNCONFIRMED";
    out += line("category", category);
    if (project.fatigue.published_step) continue;
    if (curve.constant_amplitude_limit) {
      out += line("d_sigma_D", fmt::format("{} at {} (constant-amplitude limit)",
                                           text::MPa(knee_of(curve).value()),
                                           text::cycles(*curve.constant_amplitude_limit)));
    }
    if (curve.cut_off) {
      out += line(direct ? "d_sigma_L" : "d_tau_L",
                  fmt::format("{} at {} (cut-off)", text::MPa(cut_off_of(curve).value()),
                              text::cycles(*curve.cut_off)));
    }
  }
  return out;
}

/// Each size of cycle in the life, the loads taken safety_factor times.
std::string spectrum_lines(const CheckBasis& basis) {
  std::string out;
  for (const SpectrumRow& row : basis.spectrum) {
    const double n = row.cycle.count;
    const double N = row.endured;
    out += more(fmt::format(
        "{}range {}: n = {}, N = {}, n/N = {}{}",
        basis.curves.size() > 1 ? (row.kind == StressKind::direct ? "direct " : "shear ") : "",
        text::MPa(row.cycle.range.value()), text::cycles(n),
        std::isfinite(N) ? text::cycles(N) : "unlimited", text::significant(n / N, 3),
        row.situation.empty() ? "" : " (" + row.situation + ")"));
  }
  return out;
}

std::string fatigue_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  const FatigueInput& fatigue = project.fatigue;
  std::string out = place_line(project, check, basis) + extreme_lines(project, check, basis);
  out += curve_lines(project, basis);
  const std::string gammas =
      fmt::format("gamma_Ff = {}, gamma_Mf = {}", text::significant(fatigue.demand.gamma_Ff, 3),
                  text::significant(fatigue.demand.gamma_Mf, 3));
  if (basis.spectrum.size() == 1) {
    out += line("allowed",
                fmt::format("{} for {} cycles, {} applied", text::MPa(check.resisting.value()),
                            text::cycles(basis.spectrum.front().cycle.count), gammas));
    out +=
        factor_line(check, fmt::format("allowed/range = {}/{}", text::MPa(check.resisting.value()),
                                       text::MPa(check.acting.value())));
  } else {
    out += line(
        "factor k",
        fmt::format("the largest with sum n/N <= 1, N for k gamma_Ff gamma_Mf range; {}", gammas));
    out += spectrum_lines(basis);
    out += factor_line(check, "k");
  }
  out += line("damage", fmt::format("{} in the wanted life", text::significant(basis.damage, 3)));
  if (basis.equivalent.value() > 0.0) {
    out += after(fmt::format("as much as 2e6 cycles of {}", text::MPa(basis.equivalent.value())));
  }
  if (basis.curves.front().constant_amplitude_limit) {
    out += line("beside", fmt::format("{} under constant amplitude (7.1(2): limit d_sigma_D)",
                                      text::significant(basis.constant_amplitude_factor, 4)));
  }
  return out;
}

std::string range_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  return place_line(project, check, basis) +
         line("range",
              fmt::format("gamma_Ff (highest - lowest) = {} x ({} - {}) = {}",
                          text::significant(project.fatigue.demand.gamma_Ff, 3),
                          text::MPa(basis.highest.value), term(text::MPa(basis.lowest.value)),
                          text::MPa(check.acting.value()))) +
         line("limit", fmt::format("1.5 f_y (direct), 1.5 f_y/sqrt(3) (shear) = {}, f_y = {}",
                                   text::MPa(check.resisting.value()),
                                   text::MPa(basis.point.yield_strength.value()))) +
         factor_line(check, "limit/range");
}

std::string throat_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  return place_line(project, check, basis) +
         line("t", text::seconds(check.time.value()) + ", where the shear flow is largest") +
         shear_stress_lines("tau_par", basis.point, basis.cut_at_time, in_space(project)) +
         line("limit", fmt::format("f_u/(sqrt(3) beta_w gamma_M2) = {}, beta_w = {}, gamma_M2 = {}",
                                   text::MPa(check.resisting.value()),
                                   text::significant(project.material.beta_w, 3),
                                   text::significant(project.strength.gamma_M2, 3))) +
         factor_line(check, "limit/tau_par");
}

std::string given_lines(const Project& project, const Check& check) {
  std::string out = fmt::format("    at s = {} m, point {}, stresses given\n",
                                to_text(check.station), check.point);
  for (const GivenStress& given : project.given_stresses) {
    if (given.name != check.point) continue;
    if (check.criterion == Criterion::yield) {
      out += line("sigma", text::MPa(check.acting.value()) + " (given)");
      out += line("f_y", fmt::format("{} ({}, plate {})", text::MPa(check.resisting.value()),
                                     project.material.name, text::mm(given.thickness.value())));
    } else {
      out += line("range",
                  fmt::format("{} + {} = {} (given)", text::MPa(given.peak.value()),
                              text::MPa(given.opposite->value()), text::MPa(check.acting.value())));
      out += line("d_sigma_R", fmt::format("d_sigma_C (5e6/N)^(1/5) = {} at {} cycles",
                                           text::MPa(check.resisting.value()),
                                           text::cycles(most_cycles_of(project))));
    }
  }
  return out + factor_line(check, fmt::format("{}/{}", text::MPa(check.resisting.value()),
                                              text::MPa(check.acting.value())));
}

const NeighbourResult& neighbour_of(const Verification& verification, const Check& check) {
  return *std::find_if(
      verification.neighbours.begin(), verification.neighbours.end(),
      [&](const NeighbourResult& neighbour) { return neighbour.check.id == check.id; });
}

template <class Inputs>
const auto& named(const Inputs& inputs, const std::string& name) {
  return *std::find_if(inputs.begin(), inputs.end(),
                       [&](const auto& input) { return input.name == name; });
}

std::string pin_lines(const Project& project, const NeighbourResult& result) {
  const Check& check = result.check;
  const PinInput& pin = named(project.pins, check.point);
  const PinJoint& joint = pin.geometry;
  std::string out =
      line("F", fmt::format("{} at t = {}, the largest force of the joint",
                            text::kN(check.acting.value()), text::seconds(check.time.value())));
  out +=
      line("pin", fmt::format("d = {}, plates b = {} (inner) and a = {} (outer), gap c = {}",
                              text::mm(joint.diameter.value()), text::mm(joint.inner_plate.value()),
                              text::mm(joint.outer_plate.value()), text::mm(joint.gap.value())));
  const auto use = [&](const char* name, const char* formula, double value) {
    out += line(name, fmt::format("{} = {}", formula, text::significant(value, 3)));
  };
  use("shear", "F/2 / (0.6 A f_up/gamma_M2)", result.pin.shear);
  use("bearing", "F/(1.5 b d f_y/gamma_M0), inner plate", result.pin.bearing_inner);
  use("bearing", "F/2 / (1.5 a d f_y/gamma_M0), outer plates", result.pin.bearing_outer);
  use("bending", "F/8 (b + 4c + 2a) / (1.5 W_el f_yp/gamma_M0)", result.pin.bending);
  use("combined", "bending^2 + shear^2", result.pin.combined);
  return out + factor_line(check, "1/largest (square root of combined)");
}

std::string rod_lines(const Project& project, const NeighbourResult& result) {
  const Check& check = result.check;
  const RodInput& rod = named(project.rods, check.point);
  std::string out =
      line("N", fmt::format("{} at t = {}, the largest compression", text::kN(check.acting.value()),
                            text::seconds(check.time.value())));
  out += line("lambda",
              fmt::format("sqrt(A f_y/N_cr) = {}, L_cr = {}, about the {} axis",
                          text::significant(result.slenderness, 3),
                          text::mm(rod.buckling_length.value()), result.weak_axis ? "z" : "y"));
  out +=
      line("chi",
           fmt::format("{}, curve {}", text::significant(result.reduction, 3),
                       std::array{"a0", "a", "b", "c", "d"}[static_cast<std::size_t>(rod.curve)]));
  out += line("N_b,Rd",
              fmt::format("chi A f_y/gamma_M1 = {} (f_y = {}, gamma_M1 = {})",
                          text::kN(check.resisting.value()), text::MPa(rod.yield_strength.value()),
                          text::significant(rod.gamma_M1, 3)));
  return out + factor_line(check, "N_b,Rd/N");
}

std::string deflection_lines(const Project& project, const Check& check) {
  const DeflectionInput& input = *project.deflection;
  return line("w", fmt::format("{} at s = {} m, t = {}", text::mm(check.acting.value()),
                               to_text(check.station), text::seconds(check.time.value()))) +
         line("", fmt::format("int m M/(E I_y) ds + int v V/(G A_v) ds, E = {}, G = {}",
                              text::MPa(input.youngs_modulus.value()),
                              text::MPa(input.shear_modulus.value()))) +
         line("limit", text::mm(check.resisting.value())) + factor_line(check, "limit/w");
}

std::string lines_of(const Project& project, const Check& check, const CheckBasis& basis) {
  switch (check.criterion) {
    case Criterion::yield: return yield_lines(project, check, basis);
    case Criterion::stress_range: return range_lines(project, check, basis);
    case Criterion::weld: return throat_lines(project, check, basis);
    default: return fatigue_lines(project, check, basis);
  }
}

}  // namespace

std::string calculation_sheet(const Project& project, const Verification& verification,
                              const CheckResult& result) {
  const Check& check = result.check;
  std::string out = fmt::format("  {}\n", check.id);
  switch (check.criterion) {
    case Criterion::pin: out += pin_lines(project, neighbour_of(verification, check)); break;
    case Criterion::buckling: out += rod_lines(project, neighbour_of(verification, check)); break;
    case Criterion::deflection: out += deflection_lines(project, check); break;
    default:
      out += result.basis ? lines_of(project, check, *result.basis) : given_lines(project, check);
  }
  return out + fmt::format("    source: {}\n", check.source);
}

}  // namespace boxbeam
