#include "stress_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "boxbeam/report/format.hpp"
#include "boxbeam/section/level_shear.hpp"
#include "derivation_text.hpp"
#include "section_steps.hpp"

namespace boxbeam::report {
namespace {

constexpr std::array<const char*, cut_force::count> in_the_plane{"N", "V_y", "V", "T", "M", "M_z"};
constexpr std::array<const char*, cut_force::count> in_all{"N", "V_y", "V_z", "T", "M_y", "M_z"};

/// Stresses below are round-off [Pa].
constexpr double no_stress = 1.0;

std::string kN(double force) { return text::kN(std::abs(force) < 1e-3 ? 0.0 : force); }
std::string kNm(double moment) { return text::kNm(std::abs(moment) < 1e-3 ? 0.0 : moment); }

std::string cut_force_text(const CutForces& cut, std::size_t which) {
  const double value = value_of(cut, static_cast<cut_force::Index>(which));
  return which < cut_force::T ? kN(value) : kNm(value);
}

/// Stress per cut force, "4.572e-4 mm^-2".
std::string coefficient_text(double influence, std::size_t which) {
  return which < cut_force::T ? scientific(influence * 1e-6, 4) + " mm^-2"
                              : scientific(influence * 1e-9, 4) + " mm^-3";
}

std::string name_of(std::size_t which, bool space) {
  return space ? in_all[which] : in_the_plane[which];
}

/// "k_Vy": the normal stress per V_y; "c_Vy" the shear stress.
std::string coefficient_name(char letter, std::size_t which, bool space) {
  std::string index = name_of(which, space);
  std::erase(index, '_');
  return fmt::format("{}_{}", letter, index);
}

/// A cut force, what it contributes to a stress, and how that is written.
struct Contribution {
  std::size_t which = 0;
  double stress = 0.0;  ///< [Pa]
  std::string symbols;  ///< "V S/(I_y b)"
  std::string values;   ///< "104.8 kN x 2.1500e6 mm^3/(3.8657e9 mm^4 x 40.00 mm)"
};

/// A part of the coefficient of a cut force that has a symbol of its own.
struct CoefficientPart {
  std::string symbol;
  double value = 0.0;
};

using CoefficientParts = std::function<std::vector<CoefficientPart>(std::size_t)>;

/// The cut forces that have a part in a stress above round-off, with their coefficients.
std::vector<Contribution> contributions_of(const std::array<double, cut_force::count>& influence,
                                           char letter, const CutForces& cut, bool space,
                                           const CoefficientParts& parts_of = {}) {
  std::vector<Contribution> parts;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const double force = value_of(cut, static_cast<cut_force::Index>(k));
    if (force == 0.0 || std::abs(influence[k] * force) < no_stress) continue;
    std::vector<CoefficientPart> coefficients;
    if (parts_of) coefficients = parts_of(k);
    if (coefficients.empty()) coefficients = {{coefficient_name(letter, k, space), influence[k]}};
    for (const CoefficientPart& of : coefficients) {
      parts.push_back({k, of.value * force, fmt::format("{} {}", name_of(k, space), of.symbol),
                       fmt::format("{} x {}", term(cut_force_text(cut, k)),
                                   term(coefficient_text(of.value, k)))});
    }
  }
  return parts;
}

/// The sum of contributions as a step: symbols where none are given, values, stresses, sum.
Step sum_step(const std::string& symbol, const std::vector<Contribution>& parts,
              std::string symbols = "") {
  Step step{symbol, {}, {}};
  if (parts.empty()) {
    if (!symbols.empty()) step.formulas.push_back(symbols);
    step.formulas.emplace_back("0 MPa");
    return step;
  }
  const bool own = symbols.empty();
  std::string values;
  std::vector<double> stresses;
  for (const Contribution& part : parts) {
    if (own) {
      if (!symbols.empty()) symbols += " + ";
      symbols += part.symbols;
    }
    if (!values.empty()) values += " + ";
    values += part.values;
    stresses.push_back(part.stress);
  }
  const StressSum sum = sum_of(stresses);
  step.formulas = {symbols, values};
  if (parts.size() > 1) step.formulas.push_back(sum.terms);
  step.formulas.push_back(parts.size() > 1 ? sum.sum : text::MPa(stresses.front()));
  return step;
}

/// The coefficients of a stress as steps, without those that are round-off.
Steps coefficient_steps(const std::array<double, cut_force::count>& influence, char letter,
                        bool space, const std::function<std::string(std::size_t)>& note) {
  Steps steps;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    if (!space && k != cut_force::N && k != cut_force::V_z && k != cut_force::M_y) continue;
    const bool force = k < cut_force::T;
    double largest = 0.0;
    for (std::size_t other = 0; other < cut_force::count; ++other) {
      if ((other < cut_force::T) == force) largest = std::max(largest, std::abs(influence[other]));
    }
    constexpr double round_off = 1e-9;
    const std::string words = note(k);
    if (words.empty() || std::abs(influence[k]) <= round_off * largest) continue;
    steps.push_back(
        {coefficient_name(letter, k, space), {coefficient_text(influence[k], k)}, {words}});
  }
  return steps;
}

/// Whether the centroid lies on the beam axis.
bool is_central(const SectionProperties& properties) {
  constexpr double nothing = 1e-12;
  return std::abs(properties.centroid_y.value()) < nothing &&
         std::abs(properties.centroid_z.value()) < nothing;
}

/// Steps that lead from the beam axis to the centroid: moments about it, distances from it.
Steps centroid_steps(const StressPoint& point, const CutForces& cut, bool space) {
  Steps steps;
  const double y_c = point.net.centroid_y.value();
  const double z_c = point.net.centroid_z.value();
  const double N = cut.N.value();
  const auto distance = [&](const char* symbol, const char* formula, double at, double centre) {
    steps.push_back({symbol,
                     {formula, fmt::format("{} - {}", text::mm(at * 1.0), term(text::mm(centre))),
                      text::mm(at - centre)},
                     {}});
  };
  const auto moment = [&](const char* symbol, const char* formula, double M, double sign,
                          double centre) {
    steps.push_back({symbol,
                     {formula,
                      fmt::format("{} {} {} x {}", kNm(M), sign > 0.0 ? "+" : "-", term(kN(N)),
                                  term(text::mm(centre))),
                      kNm(M + sign * N * centre)},
                     {"about the centroid"}});
  };
  moment(space ? "M_yc" : "M_c", space ? "M_y - N z_c" : "M - N z_c", cut.M_y.value(), -1.0, z_c);
  distance("e_z", "z - z_c", point.z.value(), z_c);
  if (!space && y_c == 0.0) return steps;
  moment("M_zc", "M_z + N y_c", cut.M_z.value(), 1.0, y_c);
  distance("e_y", "y - y_c", point.y.value(), y_c);
  return steps;
}

/// N/A + M_y z/I_y - M_z y/I_z about the centroid.
Steps bending_steps(const std::string& symbol, const StressPoint& point, const CutForces& cut,
                    bool space) {
  const SectionProperties& net = point.net;
  const bool central = is_central(net);
  const double N = cut.N.value();
  const double z = (point.z - net.centroid_z).value();
  const double y = (point.y - net.centroid_y).value();
  const double M_y = cut.M_y.value() - N * net.centroid_z.value();
  const double M_z = cut.M_z.value() + N * net.centroid_y.value();
  Steps steps;
  if (!central) append(steps, centroid_steps(point, cut, space));
  const std::string A = area_symbol(point);
  const std::string I_y = inertia_symbol("I_y", point);
  std::vector<Contribution> parts;
  parts.push_back({cut_force::N, N / net.area.value(), "N/" + A,
                   fmt::format("{}/{}", kN(N), mm2(net.area.value()))});
  const std::string M = central ? (space ? "M_y" : "M") : (space ? "M_yc" : "M_c");
  parts.push_back(
      {cut_force::M_y, M_y * z / net.I_y.value(),
       fmt::format("{} {}/{}", M, central ? "z" : "e_z", I_y),
       fmt::format("{} x {}/{}", term(kNm(M_y)), term(text::mm(z)), mm4(net.I_y.value()))});
  std::string symbols = fmt::format("{} + {}", parts[0].symbols, parts[1].symbols);
  if (space || M_z != 0.0) {
    // The minus stands before the term, so that the values read like the formula.
    const std::string I_z = inertia_symbol("I_z", point);
    symbols += fmt::format(" - {}/{}", central ? "M_z y" : "M_zc e_y", I_z);
    parts.push_back(
        {cut_force::M_z, -M_z * y / net.I_z.value(), "",
         fmt::format("{} x {}/{}", term(kNm(M_z)), term(text::mm(y)), mm4(net.I_z.value()))});
  }
  std::string values = fmt::format("{} + {}", parts[0].values, parts[1].values);
  std::vector<double> stresses{parts[0].stress, parts[1].stress};
  if (parts.size() > 2) {
    values += " - " + parts[2].values;
    stresses.push_back(parts[2].stress);
  }
  const StressSum sum = sum_of(stresses);
  steps.push_back({symbol, {symbols, values, sum.terms, sum.sum}, {}});
  return steps;
}

/// Per cut force, where the axes are not principal ones.
Steps skew_coefficient_steps(const StressPoint& point, bool space) {
  return coefficient_steps(point.influence.normal, 'k', space, [&](std::size_t which) {
    return fmt::format("normal stress per {} at y = {}, z = {}, by the moments about both axes",
                       name_of(which, space), text::mm(point.y.value()), text::mm(point.z.value()));
  });
}

SectionProperties net_without_lag(const Project& project, const StressPoint& point) {
  return properties_of(point.section, holes_at(project.beam, point.station.s));
}

/// S and b for which V S/(I_y b) is the stress at a point in the plane; nothing where the flow
/// there is another one.
std::optional<LevelMoment> level_moment_at(const Project& project, const StressPoint& point) {
  if (project.in_space) return std::nullopt;
  const auto at = level_moment_of(point.section, holes_at(project.beam, point.station.s), point.z,
                                  point.prismatic.shear[cut_force::V_z]);
  // A seam takes the flow of its web.
  constexpr double round_off = 1e-9;
  const bool both_webs =
      at && point.torsion && std::abs(at->b.value() - 2.0 * point.torsion->thickness) <= round_off;
  return point.on_throat && !both_webs ? std::nullopt : at;
}

double throat_of(const StressPoint& point) {
  const auto& box = std::get<Box>(point.section.outer);
  if (box.seam_throat.value() > 0.0) return box.seam_throat.value();
  return (point.y.value() < 0.0 ? box.right_web : box.left_web).value();
}

/// Thickness over which a wall's flow is spread.
double spread_of(const StressPoint& point) {
  return point.on_throat ? throat_of(point) : point.torsion->thickness;
}

/// Bredt's flow over the thickness [1/m^3].
double cell_shear_of(const StressPoint& point) { return point.torsion->flow / spread_of(point); }

/// Saint-Venant's stress on the face of the wall; a weld carries the flow only.
double face_shear_of(const StressPoint& point) {
  return point.on_throat ? 0.0 : point.torsion->face;
}

/// What the coefficient of T is made of in a wall.
std::vector<CoefficientPart> torsion_parts_of(const StressPoint& point) {
  std::vector<CoefficientPart> parts;
  if (!point.torsion) return parts;
  if (const double cell = cell_shear_of(point); cell != 0.0) parts.push_back({"c_TB", cell});
  if (const double face = face_shear_of(point); face != 0.0) parts.push_back({"c_TV", face});
  return parts;
}

/// T/(2 A_m t) and T t/I_T, which add up on the face of a wall.
Steps torsion_steps(const StressPoint& point) {
  const WallTorsion& torsion = *point.torsion;
  const double cell = cell_shear_of(point), face = face_shear_of(point);
  const char* const spread = point.on_throat ? "a" : "t";
  const std::string thickness = text::mm(spread_of(point));
  const std::string I_T = mm4(torsion.I_T);
  Steps steps;
  if (cell != 0.0 || face != 0.0) {
    steps.push_back({"I_T", {I_T}, {"torsion constant, free warping"}});
    steps.push_back({spread,
                     {thickness},
                     {point.on_throat ? "throat of the seam, all its welds together"
                                      : "thickness of the wall"}});
  }
  if (cell != 0.0 && torsion.enclosed > 0.0) {
    const std::string A_m = mm2(torsion.enclosed), I_w = mm4(torsion.I_w);
    const char* const sign = cell < 0.0 ? "-" : "";
    steps.push_back({"A_m", {A_m}, {"inside the walls' mid-lines"}});
    steps.push_back(
        {"I_w", {I_w}, {"sum of s t^3/3 over the walls: their own part of the torsion constant"}});
    steps.push_back(
        {"c_TB",
         {fmt::format("{}(1 - I_w/I_T)/(2 A_m {})", sign, spread),
          fmt::format("{}(1 - {}/{})/(2 x {} x {})", sign, I_w, I_T, A_m, thickness),
          coefficient_text(cell, cut_force::T)},
         {"shear stress per T of the cell's flow, after Bredt, of what of T the walls do "
          "not carry themselves"}});
  } else if (cell != 0.0) {
    steps.push_back({"c_TB",
                     {coefficient_text(cell, cut_force::T)},
                     {"shear stress per T of the flow in this wall, after Bredt: all cells twist "
                      "alike"}});
  }
  if (face != 0.0) {
    const char* const sign = face < 0.0 ? "-" : "";
    steps.push_back(
        {"c_TV",
         {fmt::format("{}t/I_T", sign), fmt::format("{}{}/{}", sign, thickness, I_T),
          coefficient_text(face, cut_force::T)},
         {"per T on the face of the wall, after Saint-Venant: the wall's own torsion"}});
  }
  return steps;
}

bool is_free(const StressPoint& point, const CutForces& cut) {
  return std::abs(stress_at(point.influence, cut).shear.value()) < no_stress;
}

std::string inertia_without_lag(const StressPoint& point, const SectionProperties& net) {
  return net.area == point.gross.area ? "I_y" : "I_y,net";
}

/// V S/(I_y b) and, in a taper, what N and M add.
Steps planar_shear_steps(const std::string& symbol, const Project& project,
                         const StressPoint& point, const CutForces& cut) {
  if (is_free(point, cut)) return {{symbol, {"0 MPa"}, {"free of shear"}}};
  std::vector<Contribution> parts = contributions_of(point.influence.shear, 'c', cut, false);
  const SectionProperties net = net_without_lag(project, point);
  const std::string I_y = inertia_without_lag(point, net);
  const auto at = level_moment_at(project, point);
  for (Contribution& part : parts) {
    if (part.which != cut_force::V_z || !at) continue;
    const std::string V = term(kN(cut.V_z.value()));
    const std::string S = mm3(at->S.value()), I = mm4(net.I_y.value());
    if (point.on_throat) {
      part.symbols = fmt::format("V S/(2 {} a)", I_y);
      part.values = fmt::format("{} x {}/(2 x {} x {})", V, S, I, text::mm(throat_of(point)));
    } else {
      part.symbols = fmt::format("V S/({} b)", I_y);
      part.values = fmt::format("{} x {}/({} x {})", V, S, I, text::mm(at->b.value()));
    }
  }
  return {sum_step(symbol, parts)};
}

Steps spatial_shear_steps(const std::string& symbol, const StressPoint& point,
                          const CutForces& cut) {
  if (is_free(point, cut)) return {{symbol, {"0 MPa"}, {"free of shear"}}};
  return {sum_step(
      symbol, contributions_of(point.influence.shear, 'c', cut, true, [&](std::size_t which) {
        return which == cut_force::T ? torsion_parts_of(point) : std::vector<CoefficientPart>{};
      }))};
}

/// What a coefficient of shear stress means.
std::string shear_coefficient_note(std::size_t which, bool space, const StressPoint& point) {
  const std::string name = name_of(which, space);
  const bool wall = point.torsion.has_value();
  const char* const part = wall ? "what hangs on the wall" : "the part beyond the level";
  const char* const closed =
      wall ? "; cells closed without twist, the torque about the axis balanced" : "";
  const char* over = wall ? "the wall's thickness" : "the width";
  if (point.on_throat) over = "the throat";
  switch (which) {
    case cut_force::V_y:
    case cut_force::V_z:
      return fmt::format("shear stress per {}: S/I of {}, by equilibrium, over {}{}", name, part,
                         over, closed);
    case cut_force::T:
      return "shear stress per T of a solid rectangle in the middle of a side, after Saint-Venant";
    default:
      return fmt::format(
          "shear stress per {0} in the taper: the derivative along the axis, from sections close "
          "by, of the share of {0} that {1} carries ({2}), over {3}{4}",
          name, part, which == cut_force::N ? "its area over A" : "its S/I", over, closed);
  }
}

}  // namespace

Steps normal_section_steps(const Project& project, const StressPoint& point) {
  if (point.concentration) {
    Derivation of;
    derive_edge_stress(of, point.concentration->edge);
    return steps_of(of);
  }
  Steps steps = section_steps(project, point);
  if (point.net.I_yz.value() != 0.0) append(steps, skew_coefficient_steps(point, project.in_space));
  return steps;
}

Steps normal_stress_steps(const std::string& symbol, const Project& project,
                          const StressPoint& point, const CutForces& cut) {
  const bool space = project.in_space;
  if (point.concentration) {
    return {sum_step(symbol, contributions_of(point.influence.normal, 'k', cut, space))};
  }
  if (point.net.I_yz.value() != 0.0) {
    return {sum_step(symbol, contributions_of(point.influence.normal, 'k', cut, space))};
  }
  return bending_steps(symbol, point, cut, space);
}

Steps shear_section_steps(const Project& project, const StressPoint& point) {
  const bool space = project.in_space;
  const SectionProperties net = net_without_lag(project, point);
  const auto at = level_moment_at(project, point);
  const std::string z = text::mm(point.z.value());
  Steps steps;
  if (at) {
    steps.push_back({inertia_without_lag(point, net), {mm4(net.I_y.value())}, {}});
    std::string what = "first moment of what lies beyond z = " + z;
    if (at->on_webs) {
      what = fmt::format(
          "first moment of what hangs on both webs beyond z = {}, stiffeners of the "
          "flange with it, nothing of an inner profile",
          z);
    }
    steps.push_back({"S", {mm3(at->S.value())}, {what + ", about the centroid"}});
    if (point.on_throat) {
      steps.push_back({"a",
                       {text::mm(throat_of(point))},
                       {"throat of the seam, all its welds together; there are two seams"}});
    } else {
      steps.push_back({"b",
                       {text::mm(at->b.value())},
                       {at->on_webs ? "both webs" : "width of the material at that level"}});
    }
  }
  append(steps, coefficient_steps(point.influence.shear, 'c', space, [&](std::size_t which) {
           const bool shown =
               (at && which == cut_force::V_z) || (point.torsion && which == cut_force::T);
           return shown ? std::string() : shear_coefficient_note(which, space, point);
         }));
  if (space && point.torsion) append(steps, torsion_steps(point));
  return steps;
}

Steps shear_stress_steps(const std::string& symbol, const Project& project,
                         const StressPoint& point, const CutForces& cut) {
  return project.in_space ? spatial_shear_steps(symbol, point, cut)
                          : planar_shear_steps(symbol, project, point, cut);
}

}  // namespace boxbeam::report
