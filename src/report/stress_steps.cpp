#include "sheet_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/section/level_shear.hpp"
#include "boxbeam/section/nominal_stress.hpp"
#include "boxbeam/strength/weld_throat.hpp"

namespace boxbeam::report {
namespace {

using Influence = std::array<double, cut_force::count>;

constexpr std::array<const char*, cut_force::count> in_the_plane{"N", "V_y", "V", "T", "M", "M_z"};
constexpr std::array<const char*, cut_force::count> in_all{"N", "V_y", "V_z", "T", "M_y", "M_z"};

/// Stresses below are round-off [Pa].
constexpr double no_stress = 1e-3;
/// And shear stresses below this part of the normal stress at their place.
constexpr double lost_beside = 1e-7;

std::string name_of(std::size_t which, bool space) {
  return space ? in_all[which] : in_the_plane[which];
}

Traced cut_force_of(const CutForces& cut, std::size_t which, bool space) {
  return Derivation::known({name_of(which, space), ""},
                           value_of(cut, static_cast<cut_force::Index>(which)),
                           {which < cut_force::T ? ValueKind::force : ValueKind::moment});
}

/// A stress per cut force.
Shown coefficient_shown(std::size_t which) {
  return {which < cut_force::T ? ValueKind::per_area : ValueKind::per_volume};
}

/// "k_Vy": the normal stress per V_y; "c_Vy" the shear stress.
std::string coefficient_name(char letter, std::size_t which, bool space) {
  std::string index = name_of(which, space);
  std::erase(index, '_');
  return fmt::format("{}_{}", letter, index);
}

/// What stands in the place of a cut force's coefficient: terms of the stress.
using Instead = std::function<std::vector<Traced>(std::size_t, const Traced&)>;

/// Whether a coefficient is but the round-off of the others of its kind.
bool is_round_off(const Influence& influence, std::size_t which) {
  double largest = 0.0;
  for (std::size_t other = 0; other < cut_force::count; ++other) {
    if ((other < cut_force::T) == (which < cut_force::T))
      largest = std::max(largest, std::abs(influence[other]));
  }
  constexpr double round_off = 1e-9;
  return std::abs(influence[which]) <= round_off * largest;
}

/// The cut forces that have a part in a stress above round-off, times their coefficients.
/// `beside`: the other stress at the place, in which what is less than a ten-millionth is lost.
std::vector<Traced> contributions_of(const Influence& influence, char letter, const CutForces& cut,
                                     bool space, Stress beside, const Instead& instead = {}) {
  std::vector<Traced> terms;
  const double least = std::max(no_stress, lost_beside * std::abs(beside.value()));
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const Traced force = cut_force_of(cut, k, space);
    if (force.value() == 0.0 || std::abs(influence[k] * force.value()) < least ||
        is_round_off(influence, k))
      continue;
    std::vector<Traced> of;
    if (instead) of = instead(k, force);
    if (of.empty()) {
      of.push_back(force * Derivation::known({coefficient_name(letter, k, space), ""}, influence[k],
                                             coefficient_shown(k)));
    }
    terms.insert(terms.end(), of.begin(), of.end());
  }
  return terms;
}

/// A stress as the sum of terms.
Traced derive_sum(Derivation& steps, const std::string& symbol, const std::vector<Traced>& terms,
                  const std::string& note) {
  if (terms.empty()) return steps.given({symbol, ""}, 0.0, {ValueKind::stress}, note);
  Traced sum = 0.0;
  for (const Traced& term : terms) sum = sum + term;
  return steps.define({symbol, ""}, sum, note);
}

/// The coefficients of a stress as steps, without those that are round-off.
void give_coefficients(Derivation& steps, const Influence& influence, char letter, bool space,
                       const std::function<std::string(std::size_t)>& note) {
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    if (!space && k != cut_force::N && k != cut_force::V_z && k != cut_force::M_y) continue;
    const std::string words = note(k);
    if (words.empty() || is_round_off(influence, k)) continue;
    steps.given({coefficient_name(letter, k, space), ""}, influence[k], coefficient_shown(k),
                words);
  }
}

/// Whether the centroid lies on the beam axis.
bool is_central(const SectionProperties& properties) {
  constexpr double nothing = 1e-12;
  return std::abs(properties.centroid_y.value()) < nothing &&
         std::abs(properties.centroid_z.value()) < nothing;
}

/// Moments and distances of a place, about the centroid where that lies off the axis.
struct Bending {
  Traced M_y, e_z, M_z, e_y;
  bool about_z = false;  ///< whether M_z has a part
};

Bending derive_bending(Derivation& steps, const StressPoint& point, const CutForces& cut,
                       bool space) {
  const Traced M_y = cut_force_of(cut, cut_force::M_y, space);
  const Traced M_z = cut_force_of(cut, cut_force::M_z, space);
  const Traced z = steps.known("z", point.z), y = steps.known("y", point.y);
  if (is_central(point.net)) return {M_y, z, M_z, y, space || M_z.value() != 0.0};
  const Traced N = cut_force_of(cut, cut_force::N, space);
  const Traced y_c = steps.known("y_c", point.net.centroid_y);
  const Traced z_c = steps.known("z_c", point.net.centroid_z);
  const char* const about = "about the centroid";
  const Traced M_yc = steps.define(space ? "M_yc" : "M_c", M_y - N * z_c, about);
  const Traced e_z = steps.define("e_z", z - z_c);
  if (!space && y_c.value() == 0.0) return {M_yc, e_z, M_z, y, M_z.value() != 0.0};
  const Traced M_zc = steps.define("M_zc", M_z + N * y_c, about);
  return {M_yc, e_z, M_zc, steps.define("e_y", y - y_c), space || M_zc.value() != 0.0};
}

/// N/A + M_y z/I_y - M_z y/I_z about the centroid.
Traced derive_bending_stress(Derivation& steps, const std::string& symbol, const StressPoint& point,
                             const CutForces& cut, bool space, const std::string& note) {
  const auto inertia = [&](const char* of, SecondMoment value) {
    return steps.known({inertia_symbol(of, point), ""}, value);
  };
  const Bending by = derive_bending(steps, point, cut, space);
  const Traced N = cut_force_of(cut, cut_force::N, space);
  const Traced A = steps.known({area_symbol(point), ""}, point.net.area);
  const Traced I_y = inertia("I_y", point.net.I_y);
  const Traced stress = by.about_z ? bending_stress(N, A, by.M_y, by.e_z, I_y, by.M_z, by.e_y,
                                                    inertia("I_z", point.net.I_z))
                                   : bending_stress(N, A, by.M_y, by.e_z, I_y);
  return steps.define({symbol, ""}, stress, note);
}

SectionProperties net_without_lag(const Project& project, const StressPoint& point) {
  return properties_of(point.section, holes_in_section(project, point.station));
}

/// S and b for which V S/(I_y b) is the stress at a point in the plane; nothing where the flow
/// there is another one.
std::optional<LevelMoment> level_moment_at(const Project& project, const StressPoint& point) {
  if (project.in_space) return std::nullopt;
  const auto at = level_moment_of(point.section, holes_in_section(project, point.station), point.z,
                                  point.prismatic.shear[cut_force::V_z]);
  // A seam takes the flow of its web.
  constexpr double round_off = 1e-9;
  const bool both_webs =
      at && point.torsion && std::abs(at->b.value() - 2.0 * point.torsion->thickness) <= round_off;
  return point.on_throat && !both_webs ? std::nullopt : at;
}

/// Thickness over which a wall's flow is spread.
Length spread_of(const StressPoint& point) {
  return point.on_throat ? seam_throat_of(point) : si<Length>(point.torsion->thickness);
}

/// Bredt's flow over the thickness [1/m^3].
double cell_shear_of(const StressPoint& point) {
  return point.torsion->flow / spread_of(point).value();
}

/// Saint-Venant's stress on the face of the wall; a weld carries the flow only.
double face_shear_of(const StressPoint& point) {
  return point.on_throat ? 0.0 : point.torsion->face;
}

/// What T makes in a wall: the flow of its cell and its own torsion.
std::vector<Traced> torsion_terms_of(const StressPoint& point, const Traced& T) {
  std::vector<Traced> terms;
  if (!point.torsion) return terms;
  const auto add = [&](const char* symbol, double value) {
    if (value != 0.0)
      terms.push_back(T * Derivation::known(symbol, value, {ValueKind::per_volume}));
  };
  add("c_TB", cell_shear_of(point));
  add("c_TV", face_shear_of(point));
  return terms;
}

/// T/(2 A_m t) and T t/I_T, which add up on the face of a wall.
void derive_torsion(Derivation& steps, const StressPoint& point) {
  const WallTorsion& torsion = *point.torsion;
  const double cell = cell_shear_of(point), face = face_shear_of(point);
  if (cell == 0.0 && face == 0.0) return;
  const auto signed_as = [](double value, const Traced& size) {
    return value < 0.0 ? -size : size;
  };
  const Traced I_T =
      steps.given("I_T", si<SecondMoment>(torsion.I_T), "torsion constant, free warping");
  const Traced t = point.on_throat ? steps.given("a", spread_of(point),
                                                 "throat of the seam, all its welds together")
                                   : steps.given("t", spread_of(point), "thickness of the wall");
  if (cell != 0.0 && torsion.enclosed > 0.0) {
    const Traced A_m =
        steps.given("A_m", si<Area>(torsion.enclosed), "inside the walls' mid-lines");
    const Traced I_w =
        steps.given("I_w", si<SecondMoment>(torsion.I_w),
                    "sum of s t^3/3 over the walls: their own part of the torsion constant");
    steps.define("c_TB", signed_as(cell, cell_shear(I_w, I_T, A_m, t)),
                 "shear stress per T of the cell's flow, after Bredt, of what of T the walls do "
                 "not carry themselves");
  } else if (cell != 0.0) {
    steps.given("c_TB", cell, {ValueKind::per_volume},
                "shear stress per T of the flow in this wall, after Bredt: all cells twist alike");
  }
  if (face == 0.0) return;
  steps.define("c_TV", signed_as(face, face_shear(t, I_T)),
               "per T on the face of the wall, after Saint-Venant: the wall's own torsion");
}

bool is_free(const StressPoint& point, const CutForces& cut) {
  return std::abs(stress_at(point.influence, cut).shear.value()) < no_stress;
}

std::string inertia_without_lag(const StressPoint& point, const SectionProperties& net) {
  return net.area == point.gross.area ? "I_y" : "I_y,net";
}

/// V S/(I_y b), or over both throats; nothing where the flow at a point is another one.
std::vector<Traced> level_terms_of(const Project& project, const StressPoint& point,
                                   const Traced& V) {
  const auto at = level_moment_at(project, point);
  if (!at) return {};
  const SectionProperties net = net_without_lag(project, point);
  const Traced I_y = Derivation::known({inertia_without_lag(point, net), ""}, net.I_y);
  const Traced S = Derivation::known("S", at->S);
  const Traced width = point.on_throat ? 2.0 * Derivation::known("a", seam_throat_of(point))
                                       : Derivation::known("b", at->b);
  return {level_shear_stress(V, S, I_y, width)};
}

/// What a coefficient of shear stress means.
std::string shear_coefficient_note(std::size_t which, bool space, const StressPoint& point) {
  const std::string name = name_of(which, space);
  if (point.is_strip) {
    return fmt::format(
        "shear stress per {}: what the plate carries past the hole in its plane, over what holes "
        "leave of it: its whole force over its width (strip), its flow from hole to hole over the "
        "way between them (post)",
        name);
  }
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

void derive_normal_section(Derivation& steps, const Project& project, const StressPoint& point) {
  if (point.concentration) return derive_edge_stress(steps, point.concentration->edge);
  derive_section(steps, project, point);
  if (point.net.I_yz.value() == 0.0) return;
  const bool space = project.in_space;
  give_coefficients(steps, point.influence.normal, 'k', space, [&](std::size_t which) {
    return fmt::format("normal stress per {} at y = {}, z = {}, by the moments about both axes",
                       name_of(which, space), text::mm(point.y.value()), text::mm(point.z.value()));
  });
}

Traced derive_normal_stress(Derivation& steps, const std::string& symbol, const Project& project,
                            const StressPoint& point, const CutForces& cut,
                            const std::string& note) {
  const bool space = project.in_space;
  if (point.concentration || point.net.I_yz.value() != 0.0) {
    return derive_sum(steps, symbol, contributions_of(point.influence.normal, 'k', cut, space, {}),
                      note);
  }
  return derive_bending_stress(steps, symbol, point, cut, space, note);
}

void derive_shear_section(Derivation& steps, const Project& project, const StressPoint& point) {
  const bool space = project.in_space;
  const SectionProperties net = net_without_lag(project, point);
  const auto at = level_moment_at(project, point);
  if (at) {
    const std::string z = text::mm(point.z.value());
    steps.given({inertia_without_lag(point, net), ""}, net.I_y);
    steps.given(
        "S", at->S,
        at->on_webs
            ? fmt::format("first moment of what hangs on both webs beyond z = {}, "
                          "stiffeners of the flange with it, nothing of an inner profile, "
                          "about the centroid",
                          z)
            : fmt::format("first moment of what lies beyond z = {}, about the centroid", z));
    if (point.on_throat) {
      steps.given("a", seam_throat_of(point),
                  "throat of the seam, all its welds together; there are two seams");
    } else {
      steps.given("b", at->b, at->on_webs ? "both webs" : "width of the material at that level");
    }
  }
  give_coefficients(steps, point.influence.shear, 'c', space, [&](std::size_t which) {
    const bool shown = (at && which == cut_force::V_z) || (point.torsion && which == cut_force::T);
    return shown ? std::string() : shear_coefficient_note(which, space, point);
  });
  if (space && point.torsion) derive_torsion(steps, point);
}

Traced derive_shear_stress(Derivation& steps, const std::string& symbol, const Project& project,
                           const StressPoint& point, const CutForces& cut,
                           const std::string& note) {
  const bool space = project.in_space;
  if (is_free(point, cut)) {
    Traced none = steps.given({symbol, ""}, 0.0, {ValueKind::stress}, note);
    steps.note([] { return "free of shear"; });
    return none;
  }
  const Instead instead = [&](std::size_t which, const Traced& force) {
    if (space && which == cut_force::T) return torsion_terms_of(point, force);
    if (!space && which == cut_force::V_z) return level_terms_of(project, point, force);
    return std::vector<Traced>{};
  };
  return derive_sum(steps, symbol,
                    contributions_of(point.influence.shear, 'c', cut, space,
                                     stress_at(point.influence, cut).normal, instead),
                    note);
}

Traced derive_throat_stress(Derivation& steps, const Traced& sigma_w, const Traced& tau_par) {
  return steps.define(
      "sigma_v", equal_leg_stress(sigma_w, tau_par),
      "sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) with sigma_perp = tau_perp = "
      "sigma_w/sqrt(2) of equal legs; sigma_perp alone is held with it");
}

}  // namespace boxbeam::report
