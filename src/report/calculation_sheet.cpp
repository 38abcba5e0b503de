#include "calculation_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"

namespace boxbeam {
namespace {

std::string line(const std::string& symbol, const std::string& text) {
  return fmt::format("    {:<13}= {}\n", symbol, text);
}

std::string more(const std::string& text) { return fmt::format("    {:<13}= {}\n", "", text); }

std::string after(const std::string& text) { return fmt::format("    {:<13}  {}\n", "", text); }

/// A number behind a plus sign or a factor: negative ones in brackets.
std::string term(const std::string& number) {
  return number.starts_with('-') ? "(" + number + ")" : number;
}

std::string area(double m2) { return fmt::format("{:.5g} mm^2", m2 * 1e6); }
std::string second_moment(double m4) { return fmt::format("{:.5e} mm^4", m4 * 1e12); }

/// The normal stress of a point under given cut forces, written out.
std::string normal_stress_lines(const std::string& symbol, const StressPoint& point,
                                const CutForces& cut) {
  const double N = cut.N.value();
  const double M = cut.M_y.value();
  const double axial = point.influence.normal[cut_force::N] * N;
  const double bending = point.influence.normal[cut_force::M_y] * M;
  std::string out;
  if (!point.concentration) {
    const bool central = std::abs(point.net.centroid_z.value()) < 1e-12;
    const char* net = point.net.area == point.gross.area ? "" : ",net";
    if (point.net.I_yz.value() != 0.0) {
      out += line(symbol, "N/A + M_y and N z_c, N y_c with I_y, I_z and I_yz at");
      out += after(
          fmt::format("(y, z) = ({}, {})", text::mm(point.y.value()), text::mm(point.z.value())));
      return out + more(fmt::format("{} + {} = {}", text::MPa(axial), term(text::MPa(bending)),
                                    text::MPa(axial + bending)));
    }
    out += line(symbol, central ? fmt::format("N/A{0} + M z/I_y{0}", net)
                                : fmt::format("N/A{0} + (M - N z_c)(z - z_c)/I_y{0}", net));
    out += more(fmt::format("{}/{} + {} x {}/{}", text::kN(N), area(point.net.area.value()),
                            term(text::kNm(M)),
                            term(text::mm((point.z - point.net.centroid_z).value())),
                            second_moment(point.net.I_y.value())));
  } else {
    const EdgeConcentration& k = *point.concentration;
    switch (k.hole_case) {
      case HoleCase::in_plane_bending:
        out +=
            line(symbol,
                 "K_g/3 (N/A + M z_0/I)(1 - 2 cos 2theta) + (M r/I_net)(sin theta - sin 3theta)");
        out += after(
            fmt::format("- 4/(1 - d/w) tau_0 sin 2theta, K_g = {}, d/w = {}, theta = {:.0f} deg",
                        text::significant(k.factor), text::significant(k.diameter_to_width, 3),
                        k.angle * 180.0 / std::numbers::pi));
        break;
      case HoleCase::membrane_tension:
        out += line(symbol, fmt::format("K_g (N/A + M z_f/I), K_g = {} (d/w = {})",
                                        text::significant(k.factor),
                                        text::significant(k.diameter_to_width, 3)));
        break;
      case HoleCase::published_exponential:
        out += line(
            symbol,
            fmt::format(
                "K_t (N/A_net + M z/I_net), K_t = 2.68750 exp(-0.7128 x {}) = {}, as published",
                text::significant(k.diameter_to_width, 3), text::significant(k.factor)));
        break;
    }
    out += more(fmt::format("with N = {}, M = {}, V = {}", text::kN(N), text::kNm(M),
                            text::kN(cut.V_z.value())));
  }
  const double per_V = point.influence.normal[cut_force::V_z];
  const double shear = per_V * cut.V_z.value();
  std::string sum = fmt::format("{} + {}", text::MPa(axial), term(text::MPa(bending)));
  if (per_V != 0.0) sum += " + " + term(text::MPa(shear));
  out += more(fmt::format("{} = {}", sum, text::MPa(axial + bending + shear)));
  return out;
}

std::string place_line(const Check& check, const CheckBasis& basis) {
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
  std::string out = place_line(check, basis);
  out += line("t", text::seconds(check.time.value()) + ", where the equivalent stress is largest");
  out += normal_stress_lines("sigma", basis.point, basis.cut_at_time);
  const double prismatic = stress_at(basis.point.prismatic, basis.cut_at_time).shear.value();
  const double tau = basis.stress_at_time.shear.value();
  const std::string V = text::kN(basis.cut_at_time.V_z.value());
  if (text::MPa(tau) == text::MPa(prismatic)) {
    out += line("tau", fmt::format("V S/(I_y b) = {} (V = {})", text::MPa(tau), V));
  } else {
    out += line("tau", fmt::format("d/dx(M S/I_y)/b = {} in the taper; V S/(I_y b) = {} (V = {})",
                                   text::MPa(tau), text::MPa(prismatic), V));
  }
  out += line("sigma_v", "sqrt(sigma^2 + 3 tau^2) = " + text::MPa(check.acting.value()));
  out += line("f_y", fmt::format("{} ({}, plate {})", text::MPa(basis.point.yield_strength.value()),
                                 project.material.name, text::mm(basis.point.plate.value())));
  out += factor_line(
      check, fmt::format("f_y/(gamma_M0 sigma_v), gamma_M0 = {}:  {}/{}",
                         text::significant(project.strength.gamma_M0, 3),
                         text::MPa(check.resisting.value()), text::MPa(check.acting.value())));
  return out;
}

std::string fatigue_lines(const Project& project, const Check& check, const CheckBasis& basis) {
  const FatigueInput& fatigue = project.fatigue;
  std::string out = place_line(check, basis);
  out += normal_stress_lines("sigma_max", basis.point, basis.cut_at_highest);
  out += after(fmt::format("at t = {}", text::seconds(basis.highest.time.value())));
  out += normal_stress_lines("sigma_min", basis.point, basis.cut_at_lowest);
  out += after(fmt::format("at t = {}", text::seconds(basis.lowest.time.value())));
  out += line("range", fmt::format("sigma_max - sigma_min = {}", text::MPa(check.acting.value())));
  for (const Situation& situation : project.situations) {
    const auto rows =
        std::count_if(basis.spectrum.begin(), basis.spectrum.end(),
                      [&](const SpectrumRow& row) { return row.situation == situation.name; });
    if (rows == 0) continue;
    out += line("cycles",
                fmt::format("{} periods, {} cycle{} in each{}", text::cycles(situation.cycles),
                            rows, rows == 1 ? "" : "s (rainflow, periodic)",
                            situation.name.empty() ? "" : " (" + situation.name + ")"));
  }
  out += line("category", fmt::format("{} MPa at 2e6 cycles{}", basis.point.category,
                                      basis.point.category_assumed.empty() ? "" : ", ASSUMED"));
  if (!fatigue.published_step) {
    out += line("d_sigma_D",
                fmt::format("(2/5)^(1/3) d_sigma_C = {} at 5e6", text::MPa(basis.knee.value())));
    out += line("d_sigma_L", fmt::format("(5/100)^(1/5) d_sigma_D = {} at 1e8",
                                         text::MPa(basis.cut_off.value())));
  }
  const std::string gammas =
      fmt::format("gamma_Ff = {}, gamma_Mf = {}", text::significant(fatigue.demand.gamma_Ff, 3),
                  text::significant(fatigue.demand.gamma_Mf, 3));
  if (basis.spectrum.size() == 1) {
    out += line("d_sigma_R", fmt::format("{} allowed for {} cycles, {} applied",
                                         text::MPa(check.resisting.value()),
                                         text::cycles(basis.spectrum.front().cycle.count), gammas));
    out += factor_line(check,
                       fmt::format("d_sigma_R/range = {}/{}", text::MPa(check.resisting.value()),
                                   text::MPa(check.acting.value())));
  } else {
    out += line(
        "factor k",
        fmt::format("the largest with sum n/N <= 1, N for k gamma_Ff gamma_Mf range; {}", gammas));
    for (const SpectrumRow& row : basis.spectrum) {
      const double n = row.cycle.count;
      const double N = row.endured;
      out += more(fmt::format(
          "range {}: n = {}, N = {}, n/N = {}{}", text::MPa(row.cycle.range.value()),
          text::cycles(n), std::isfinite(N) ? text::cycles(N) : "unlimited",
          text::significant(n / N, 3), row.situation.empty() ? "" : " (" + row.situation + ")"));
    }
    out += factor_line(check, "k");
  }
  out += line("beside", fmt::format("{} under constant amplitude (7.1(2): limit d_sigma_D)",
                                    text::significant(basis.constant_amplitude_factor, 4)));
  return out;
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

}  // namespace

std::string calculation_sheet(const Project& project, const CheckResult& result) {
  const Check& check = result.check;
  std::string out = fmt::format("  {}\n", check.id);
  if (!result.basis)
    out += given_lines(project, check);
  else if (check.criterion == Criterion::yield)
    out += yield_lines(project, check, *result.basis);
  else
    out += fatigue_lines(project, check, *result.basis);
  return out + fmt::format("    source: {}\n", check.source);
}

}  // namespace boxbeam
