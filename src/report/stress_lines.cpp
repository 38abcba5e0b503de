#include "stress_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "boxbeam/report/format.hpp"

namespace boxbeam {

std::string line(const std::string& symbol, const std::string& text) {
  return fmt::format("    {:<13}= {}\n", symbol, text);
}

std::string more(const std::string& text) { return fmt::format("    {:<13}= {}\n", "", text); }

std::string after(const std::string& text) { return fmt::format("    {:<13}  {}\n", "", text); }

std::string term(const std::string& number) {
  return number.starts_with('-') ? "(" + number + ")" : number;
}

namespace {

std::string area(double m2) { return fmt::format("{:.5g} mm^2", m2 * 1e6); }
std::string second_moment(double m4) { return fmt::format("{:.5e} mm^4", m4 * 1e12); }

/// The stress at a hole's edge.
std::string hole_formula(const std::string& symbol, const EdgeConcentration& k) {
  std::string out;
  switch (k.hole_case) {
    case HoleCase::in_plane_bending:
      out += line(symbol,
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
    case HoleCase::out_of_plane_bending:
      out += line(symbol, fmt::format("K_t 6 M/[(w - d) h^2] + K_g N/A, K_g = {} (d/w = {})",
                                      text::significant(k.factor),
                                      text::significant(k.diameter_to_width, 3)));
      break;
    case HoleCase::published_exponential:
      out +=
          line(symbol,
               fmt::format(
                   "K_t (N/A_net + M z/I_net), K_t = 2.68750 exp(-0.7128 x {}) = {}, as published",
                   text::significant(k.diameter_to_width, 3), text::significant(k.factor)));
      break;
  }
  return out;
}

std::string planar_normal_lines(const std::string& symbol, const StressPoint& point,
                                const CutForces& cut) {
  const double N = cut.N.value();
  const double M = cut.M_y.value();
  const double axial = point.influence.normal[cut_force::N] * N;
  const double bending = point.influence.normal[cut_force::M_y] * M;
  std::string out;
  if (!point.concentration) {
    const bool central = std::abs(point.net.centroid_z.value()) < 1e-12;
    const char* net = point.lag ? ",eff" : (point.net.area == point.gross.area ? "" : ",net");
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
    out += hole_formula(symbol, *point.concentration);
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

constexpr std::array<const char*, cut_force::count> names{"N", "V_y", "V_z", "T", "M_y", "M_z"};

std::string cut_force_text(const CutForces& cut, std::size_t which) {
  const double value = value_of(cut, static_cast<cut_force::Index>(which));
  return which < cut_force::T ? text::kN(value) : text::kNm(value);
}

/// What each cut force contributes to a stress, and their sum.
std::string contributions(const std::array<double, cut_force::count>& influence,
                          const CutForces& cut) {
  std::vector<std::string> by, stresses;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const double value = value_of(cut, static_cast<cut_force::Index>(k));
    largest = std::max(largest, std::abs(influence[k] * value));
  }
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const double value = value_of(cut, static_cast<cut_force::Index>(k));
    if (std::abs(influence[k] * value) <= 1e-9 * largest) continue;  // round-off
    by.push_back(fmt::format("{} = {}", names[k], cut_force_text(cut, k)));
    const std::string stress = text::MPa(influence[k] * value);
    stresses.push_back(stresses.empty() ? stress : term(stress));
    sum += influence[k] * value;
  }
  if (by.empty()) return more("0");
  std::string out = after(fmt::format("of {}", fmt::join(by, ", ")));
  if (by.size() == 1) return out + more(text::MPa(sum));
  return out + more(fmt::format("{} = {}", fmt::join(stresses, " + "), text::MPa(sum)));
}

/// The stress at a hole's edge under all six cut forces, u along the wall across the beam.
std::string spatial_hole_formula(const std::string& symbol, const EdgeConcentration& k) {
  return line(symbol,
              "K_g/3 sigma_0 (1 - 2 cos 2theta) + r dsigma/du (sin theta - sin 3theta) - 4/(1 - "
              "d/w) tau_0 sin 2theta") +
         after(
             "sigma_0 = N/A + M_y z/I_y - M_z y/I_z at the hole's centre, tau_0 there of V_y, V_z "
             "and T") +
         after(fmt::format("K_g = {}, d/w = {}, theta = {:.0f} deg", text::significant(k.factor),
                           text::significant(k.diameter_to_width, 3),
                           k.angle * 180.0 / std::numbers::pi));
}

std::string spatial_normal_lines(const std::string& symbol, const StressPoint& point,
                                 const CutForces& cut) {
  if (point.concentration) {
    return spatial_hole_formula(symbol, *point.concentration) +
           contributions(point.influence.normal, cut);
  }
  const bool whole = point.net.area == point.gross.area;
  const char* net = point.lag || point.web_lag ? ",eff" : (whole ? "" : ",net");
  const auto second_moment_line = [](const char* name, SecondMoment I) {
    return fmt::format("{} = {}", name, second_moment(I.value()));
  };
  std::string out = line(symbol, fmt::format("N/A{0} + M_y z/I_y{0} - M_z y/I_z{0}{1}", net,
                                             point.net.I_yz.value() != 0.0 ? ", with I_yz" : ""));
  out += after(fmt::format("y = {}, z = {} from the centroid, A = {}, {}, {}",
                           text::mm((point.y - point.net.centroid_y).value()),
                           text::mm((point.z - point.net.centroid_z).value()),
                           area(point.net.area.value()), second_moment_line("I_y", point.net.I_y),
                           second_moment_line("I_z", point.net.I_z)));
  return out + contributions(point.influence.normal, cut);
}

std::string spatial_shear_lines(const std::string& symbol, const StressPoint& point,
                                const CutForces& cut) {
  const auto& shear = point.influence.shear;
  const bool tapers =
      shear[cut_force::N] != 0.0 || shear[cut_force::M_y] != 0.0 || shear[cut_force::M_z] != 0.0;
  const std::string formula =
      point.on_throat ? "q/a in the throat, q = V_z S_y/I_y + V_y S_z/I_z + q_T of the torque"
                      : "V_z S_y/(I_y t) + V_y S_z/(I_z t) + torsion";
  return line(symbol, formula + (tapers ? "; N, M_y, M_z: d/dx of the section" : "")) +
         contributions(point.influence.shear, cut);
}

std::string planar_shear_lines(const std::string& symbol, const StressPoint& point,
                               const CutForces& cut) {
  const double tau = stress_at(point.influence, cut).shear.value();
  const double prismatic = stress_at(point.prismatic, cut).shear.value();
  const std::string V = text::kN(cut.V_z.value());
  if (point.on_throat) {
    return line(symbol, fmt::format("q/a = {} in the throat, q = d/dx(M S/I_y) (V = {}, M = {})",
                                    text::MPa(tau), V, text::kNm(cut.M_y.value())));
  }
  if (text::MPa(tau) == text::MPa(prismatic)) {
    return line(symbol, fmt::format("V S/(I_y b) = {} (V = {})", text::MPa(tau), V));
  }
  return line(symbol, fmt::format("d/dx(M S/I_y)/b = {} in the taper; V S/(I_y b) = {} (V = {})",
                                  text::MPa(tau), text::MPa(prismatic), V));
}

}  // namespace

std::string normal_stress_lines(const std::string& symbol, const StressPoint& point,
                                const CutForces& cut, bool in_space) {
  return in_space ? spatial_normal_lines(symbol, point, cut)
                  : planar_normal_lines(symbol, point, cut);
}

std::string shear_stress_lines(const std::string& symbol, const StressPoint& point,
                               const CutForces& cut, bool in_space) {
  return in_space ? spatial_shear_lines(symbol, point, cut)
                  : planar_shear_lines(symbol, point, cut);
}

}  // namespace boxbeam
