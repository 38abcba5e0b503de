#include "stress_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "boxbeam/report/format.hpp"
#include "hole_steps.hpp"
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

/// The cut forces that have a part in a stress above round-off, with their coefficients.
std::vector<Contribution> contributions_of(const std::array<double, cut_force::count>& influence,
                                           char letter, const CutForces& cut, bool space) {
  std::vector<Contribution> parts;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const double force = value_of(cut, static_cast<cut_force::Index>(k));
    if (force == 0.0 || std::abs(influence[k] * force) < no_stress) continue;
    parts.push_back({k, influence[k] * force,
                     fmt::format("{} {}", name_of(k, space), coefficient_name(letter, k, space)),
                     fmt::format("{} x {}", term(cut_force_text(cut, k)),
                                 term(coefficient_text(influence[k], k)))});
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

/// The wall that a level crosses, and the first moment beyond it, in a section in the plane.
struct LevelShear {
  double S, b;
};

SectionProperties net_without_lag(const Project& project, const StressPoint& point) {
  return properties_of(point.section, holes_at(project.beam, point.station.s));
}

/// S and b for which V S/(I_y b) is the stress of a level; nothing where the flow at the point is
/// not that of a level across equal walls.
std::optional<LevelShear> level_shear_of(const Project& project, const StressPoint& point,
                                         const SectionProperties& net) {
  if (in_space(project) || point.on_throat || !is_symmetric_about_z(point.section)) {
    return std::nullopt;
  }
  const std::vector<Hole> holes = holes_at(project.beam, point.station.s);
  const double b = width_at(point.section, holes, point.z).value();
  const double S = point.prismatic.shear[cut_force::V_z] * net.I_y.value() * b;
  const double exact = first_moment_beyond(point.section, holes, point.z, net.centroid_z).value();
  // Mid-lines of walls leave out what is of second order in the thickness.
  constexpr double second_order = 0.05;
  if (b <= 0.0 || S <= 0.0 || std::abs(S - exact) > second_order * exact) return std::nullopt;
  return LevelShear{S, b};
}

double throat_of(const StressPoint& point) {
  const auto& box = std::get<Box>(point.section.outer);
  if (box.seam_throat.value() > 0.0) return box.seam_throat.value();
  return (point.y.value() < 0.0 ? box.right_web : box.left_web).value();
}

bool is_free(const StressPoint& point, const CutForces& cut) {
  return std::abs(stress_at(point.influence, cut).shear.value()) < no_stress;
}

/// V S/(I_y b) and, in a taper, what N and M add.
Steps planar_shear_steps(const std::string& symbol, const Project& project,
                         const StressPoint& point, const CutForces& cut) {
  if (is_free(point, cut)) return {{symbol, {"0 MPa"}, {"free of shear"}}};
  std::vector<Contribution> parts = contributions_of(point.influence.shear, 'c', cut, false);
  const SectionProperties net = net_without_lag(project, point);
  const std::string I_y = net.area == point.gross.area ? "I_y" : "I_y,net";
  for (Contribution& part : parts) {
    if (part.which != cut_force::V_z) continue;
    const std::string V = term(kN(cut.V_z.value()));
    if (point.on_throat) {
      const double a = throat_of(point);
      const double S = point.influence.shear[cut_force::V_z] * a * net.I_y.value();
      part.symbols = fmt::format("V S/({} a)", I_y);
      part.values =
          fmt::format("{} x {}/({} x {})", V, term(mm3(S)), mm4(net.I_y.value()), text::mm(a));
    } else if (const auto at = level_shear_of(project, point, net)) {
      part.symbols = fmt::format("V S/({} b)", I_y);
      part.values =
          fmt::format("{} x {}/({} x {})", V, mm3(at->S), mm4(net.I_y.value()), text::mm(at->b));
    }
  }
  return {sum_step(symbol, parts)};
}

Steps spatial_shear_steps(const std::string& symbol, const StressPoint& point,
                          const CutForces& cut) {
  if (is_free(point, cut)) return {{symbol, {"0 MPa"}, {"free of shear"}}};
  return {sum_step(symbol, contributions_of(point.influence.shear, 'c', cut, true))};
}

/// What a coefficient of shear stress means.
std::string shear_coefficient_note(std::size_t which, bool space, bool on_throat) {
  const char* const where = on_throat ? "in the throat" : "in the wall";
  switch (which) {
    case cut_force::V_y:
    case cut_force::V_z:
      return fmt::format("shear stress per {} {}, by the flow of the section",
                         name_of(which, space), where);
    case cut_force::T: return fmt::format("shear stress per T {}, by Bredt's flow in cells", where);
    default:
      return fmt::format("shear stress per {} {}: the section changes along the taper",
                         name_of(which, space), where);
  }
}

}  // namespace

Steps normal_section_steps(const Project& project, const StressPoint& point) {
  if (point.concentration) return hole_factor_steps(project, point);
  Steps steps = section_steps(project, point);
  if (point.net.I_yz.value() != 0.0)
    append(steps, skew_coefficient_steps(point, in_space(project)));
  return steps;
}

Steps normal_stress_steps(const std::string& symbol, const Project& project,
                          const StressPoint& point, const CutForces& cut) {
  const bool space = in_space(project);
  if (point.concentration) {
    return {sum_step(symbol, contributions_of(point.influence.normal, 'k', cut, space))};
  }
  if (point.net.I_yz.value() != 0.0) {
    return {sum_step(symbol, contributions_of(point.influence.normal, 'k', cut, space))};
  }
  return bending_steps(symbol, point, cut, space);
}

Steps shear_section_steps(const Project& project, const StressPoint& point) {
  const bool space = in_space(project);
  const SectionProperties net = net_without_lag(project, point);
  const auto at = level_shear_of(project, point, net);
  const bool by_S = !space && (at || point.on_throat);
  Steps steps;
  if (by_S) {
    const bool whole = net.area == point.gross.area;
    steps.push_back({whole ? "I_y" : "I_y,net", {mm4(net.I_y.value())}, {}});
  }
  if (by_S && point.on_throat) {
    const double a = throat_of(point);
    steps.push_back({"S",
                     {mm3(point.influence.shear[cut_force::V_z] * a * net.I_y.value())},
                     {"first moment of what hangs on this seam, along the walls' mid-lines"}});
    steps.push_back({"a", {text::mm(a)}, {"throat of the seam, all its welds together"}});
  } else if (by_S) {
    steps.push_back({"S",
                     {mm3(at->S)},
                     {fmt::format("first moment beyond z = {}, along the walls' mid-lines",
                                  text::mm(point.z.value()))}});
    steps.push_back({"b", {text::mm(at->b)}, {"width of the material at that level"}});
  }
  append(steps, coefficient_steps(point.influence.shear, 'c', space, [&](std::size_t which) {
           if (by_S && which == cut_force::V_z) return std::string();
           return shear_coefficient_note(which, space, point.on_throat);
         }));
  return steps;
}

Steps shear_stress_steps(const std::string& symbol, const Project& project,
                         const StressPoint& point, const CutForces& cut) {
  return in_space(project) ? spatial_shear_steps(symbol, point, cut)
                           : planar_shear_steps(symbol, project, point, cut);
}

}  // namespace boxbeam::report
