#include "sheet_steps.hpp"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "boxbeam/report/format.hpp"
#include "boxbeam/strength/yield.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/path_checks.hpp"
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
Traced loaded(Derivation& steps, double load_factor, const Traced& acting) {
  if (load_factor == 1.0) return acting;
  return steps.known("gamma_F", load_factor, {ValueKind::factor}) * acting;
}

struct ActsAndResists {
  Traced acting, resisting;
};

/// Resistance of the corner used most, and the stress that acts there.
template <class Basis>
ActsAndResists derive_corner(Derivation& steps, const Project& project, const Check& check,
                             const Basis& basis, const EffectiveBox& box) {
  const Traced stress = abs(derive_corner_stress(steps, box, basis.cut, basis.corner));
  steps.note([&] { return instant_of(check); });
  steps.note([&] {
    const BoxCorner& of = basis.corner.corner;
    return std::string(to_text(of.flange)) + " at the " + to_text(of.web);
  });
  const Traced f_y = steps.given("f_y", basis.corner.yield_strength);
  return {loaded(steps, basis.load_factor, stress),
          yield_resistance(steps, f_y, project.strength.gamma_M0)};
}

template <class Basis>
ActsAndResists derive_place(Derivation& steps, const Project& project, const Check& check,
                            const Basis& basis, const EffectivePath& path, const PathUse& use) {
  const Traced stress = abs(derive_path_stress(steps, path, basis.cut, use));
  steps.note([&] { return instant_of(check); });
  steps.note([&] { return path.places()[use.place].name; });
  const Traced f_y = steps.given("f_y", use.yield_strength);
  return {loaded(steps, basis.load_factor, stress),
          yield_resistance(steps, f_y, project.strength.gamma_M0)};
}

template <class Basis>
ActsAndResists derive_shear(Derivation& steps, const Project& project, const Check& check,
                            const Basis& basis, const ShearedWall& plate) {
  // The sum of shear flows that cancel each other leaves round-off.
  const Force sum = plate.force_of(basis.cut);
  const Force acting = sum < 1e-9 * plate.resists.resistance ? Force{} : sum;
  const Traced V =
      steps.given("V_w", acting, "the shear flow of the section over the clear width of the plate");
  if (plate.as_flange)
    steps.note([] { return "of at least half of its largest shear stress, 7.1(5)"; });
  steps.note([&] { return plate.name; });
  steps.note([&] { return instant_of(check); });
  steps.given("h_w", plate.panel.depth);
  steps.given("t", plate.panel.thickness);
  steps.given("f_y", plate.panel.yield_strength);
  return {loaded(steps, basis.load_factor, V),
          derive_shear_resistance(steps, plate.panel, project.strength.gamma_M1)};
}

/// Normal stress of the gross section at an edge of a plate, compression positive.
Traced derive_plate_edge(Derivation& steps, const char* symbol, const ReducedPlate& plate,
                         bool high, const CutForces& cut, bool pulled, const char* note) {
  const StressInfluence& at = plate.ends.at(high);
  const auto part = [&](const char* force, const char* resists, auto index, auto acting,
                        auto unit) -> std::optional<Traced> {
    const double influence = at.normal[index];
    if (acting.value() == 0.0 || influence == 0.0) return std::nullopt;
    return steps.known(force, acting) / steps.given(resists, unit / influence);
  };
  std::optional<Traced> sum;
  const auto add = [&](const std::optional<Traced>& of) {
    if (of) sum.emplace(sum ? *sum + *of : *of);
  };
  add(part("N", "A", cut_force::N, cut.N, si<Area>(1.0)));
  add(part("M_y", "W_y", cut_force::M_y, cut.M_y, si<SectionModulus>(1.0)));
  add(part("M_z", "W_z", cut_force::M_z, cut.M_z, si<SectionModulus>(1.0)));
  const Traced stress = pulled ? *sum : Traced(-*sum);
  if (plate.along_edge == 1.0) return steps.define(symbol, stress, note);
  const Traced along = steps.given("1/cos^2", plate.along_edge, {ValueKind::number},
                                   "along the steepest edge, inclined by more than 10 deg");
  return steps.define(symbol, along * stress, note);
}

/// What acts on a plate of the gross section, without load factor.
void say_stresses(Derivation& steps, const ReducedPlate& plate, const PanelStress& stress,
                  const CutForces& cut, const Check& check) {
  if (cut.N.value() != 0.0) steps.given("N", cut.N);
  if (cut.M_y.value() != 0.0) steps.given("M_y", cut.M_y);
  if (cut.M_z.value() != 0.0) steps.given("M_z", cut.M_z);
  const auto [low, high] = plate.edges_under(cut);
  const bool more_at_high = high > low;
  if (stress.compression > Stress{}) {
    derive_plate_edge(steps, "sigma_x", plate, more_at_high, cut, false,
                      "along the beam, of the edge compressed more, gross section");
  }
  if (stress.tension > Stress{}) {
    derive_plate_edge(steps, "sigma_t", plate, !more_at_high, cut, true,
                      "of the edge stretched most");
  }
  steps.given("tau", Stress(abs(stress.shear)),
              "the shear flow of the section over the clear width of the plate, mean");
  if (plate.sheared.as_flange)
    steps.note([] { return "at least half of its largest shear stress, as 7.1(5)"; });
  steps.note([&] { return plate.sheared.name; });
  steps.note([&] { return instant_of(check); });
}

void derive_reduced_factor(Derivation& steps, const Project& project, const ReducedPlate& plate,
                           const PanelStress& stress, double load_factor) {
  if (plate.panel.depth > plate.sheared.panel.depth) {
    steps.given("b_s", plate.sheared.panel.depth,
                "here; taken for a rectangle of its largest width, 2.3(1)");
  }
  const Traced use = derive_reduced_use(steps, plate.panel, stress, project.strength.gamma_M1);
  steps.define("factor", 1.0 / loaded(steps, load_factor, use));
}

template <class Basis>
void derive_reduced_plate(Derivation& steps, const Project& project, const Check& check,
                          const Basis& basis) {
  const ReducedPlate& plate = *basis.reduced;
  const PanelStress stress = plate.under(basis.cut);
  say_stresses(steps, plate, stress, basis.cut, check);
  derive_reduced_factor(steps, project, plate, stress, basis.load_factor);
}

void derive_reduced_web(Derivation& steps, const Project& project, const Check& check,
                        const ReducedWeb& of, const PatchBasis& basis, const Traced& F) {
  const EdgeForce& across = *of.stress.across;
  say_stresses(steps, *of.plate, of.stress, basis.cut, check);
  const Traced l =
      steps.given("l", loaded_length_of(of.web), "of the edge, s_s + 2 t_f, at most a");
  steps.define("sigma_z", F / (l * steps.given("t", of.web.thickness)));
  steps.given("sigma_x,F", across.along[0], "sigma_x where it comes in, compression positive");
  if (across.along[1] != across.along[0])
    steps.given("sigma_x,G", across.along[1], "where it goes out");
  derive_critical_force(steps, of.web);
  derive_reduced_factor(steps, project, *of.plate, of.stress, basis.load_factor);
}

/// The throat of a seam under a force across it and the beam's own shear flow.
void derive_seam(Derivation& steps, const Project& project, const PatchedSeam& of,
                 const PatchBasis& basis, const Traced& F) {
  const StressPoint& point = *of.point;
  const Traced a = steps.given("a_w", seam_throat_of(point), "throat of the seam, all its welds");
  steps.note([&] { return "with the " + std::string(to_text(of.flange)); });
  const Traced l = steps.given("l", of.loaded, "of the seam, s_s + 2 t_f, within a and the beam");
  const Traced own = F / (l * a);
  const Traced sigma_w =
      of.beside > Stress{}
          ? steps.define("sigma_w", own + steps.given("sigma_n", of.beside,
                                                      "of other forces whose spread meets it"))
          : steps.define("sigma_w", own);
  steps.note([] { return "across the seam, by the welds alone: no contact"; });
  derive_shear_section(steps, project, point);
  const Traced tau_par = derive_shear_stress(steps, "tau_par", project, point, basis.cut);
  const Traced sigma_v = derive_throat_stress(steps, sigma_w, tau_par);
  steps.given("f_u", of.strength.tensile_strength, "of the weaker part joined");
  const Traced limit = weld_strength(steps, of.strength);
  steps.define("factor", limit / loaded(steps, basis.load_factor, sigma_v));
}

/// A diaphragm as a column under what comes in and what a panel beside it pulls.
void derive_stiffener(Derivation& steps, const Project& project, const CheckResult& result,
                      const Traced& F) {
  const PatchBasis& basis = *result.patch;
  const double gamma_M1 = project.strength.gamma_M1;
  const auto& stiffener = std::get<BearingStiffener>(basis.bears);
  if (!basis.pulls) {
    steps.define("factor", derive_bearing_resistance(steps, stiffener, gamma_M1) / F);
    return;
  }
  const PullingPanel& of = *basis.pulls;
  const Traced V = steps.given("V_w", of.shear,
                               "of the plate of the panel beside it, half of its "
                               "depth from the panel's edge or in its middle");
  steps.note([&] { return "at s = " + to_text(of.at) + " m"; });
  steps.note([&] { return instant_of(result.check); });
  const Traced V_Ed = steps.define("V_Ed", loaded(steps, basis.load_factor, V));
  const Traced V_cr = derive_buckling_shear(steps, of.panel, gamma_M1);
  const Traced N_b = derive_bearing_resistance(steps, stiffener, gamma_M1);
  derive_stiffener_factor(steps, F, V_Ed, V_cr, N_b);
  steps.note([] { return "F_w, and with it N_st = V_Ed - V_cr, within the column's resistance"; });
}

/// A check of plates that buckle. `normal`: derives what the stress along the beam is and what it
/// may be; `together`: the factor of it and shear by how far each is used.
template <class Basis, class Normal, class Together>
Steps slender_steps(const Project& project, const Check& check, const Basis& basis,
                    const ShearedWall* wall, const Normal& normal, const Together& together) {
  Derivation steps;
  const auto shear = [&] { return derive_shear(steps, project, check, basis, *wall); };
  const auto factor_of = [&](const ActsAndResists& of) {
    steps.define("factor", of.resisting / of.acting);
  };
  const auto use_of = [&](const char* symbol, const ActsAndResists& of) {
    return steps.define(symbol, of.acting / of.resisting);
  };
  switch (check.criterion) {
    case Criterion::effective_section: factor_of(normal(steps)); break;
    case Criterion::shear_buckling: factor_of(shear()); break;
    case Criterion::reduced_stress: derive_reduced_plate(steps, project, check, basis); break;
    default: {
      const Traced eta_1 = use_of("eta_1", normal(steps));
      together(steps, eta_1, use_of("eta_3", shear()));
    }
  }
  return steps_of(steps);
}

/// Of a path, both together as 7.1(5) has it.
Steps path_steps(const Project& project, const Check& check, const PathBasis& basis) {
  return slender_steps(
      project, check, basis, basis.wall,
      [&](Derivation& steps) {
        return derive_place(steps, project, check, basis, *basis.section, basis.use);
      },
      [&](Derivation& steps, const Traced& eta_1, const Traced& eta_3) {
        const double gamma_M0 = project.strength.gamma_M0;
        WebInteraction of =
            interaction_of(*basis.path, *basis.wall, basis.use, basis.cut, gamma_M0);
        of.factor /= basis.load_factor;
        if (!basis.path->plastic || !(of.share > 0.0))
          derive_interaction_factor(steps, eta_1, eta_3);
        else
          derive_web_interaction(steps, *basis.path->plastic, of, basis.cut,
                                 basis.load_factor * gamma_M0, eta_1, eta_3);
      });
}

}  // namespace

Steps plate_steps(const Project& project, const CheckResult& result) {
  if (result.path) return path_steps(project, result.check, *result.path);
  const PlateBasis& basis = *result.plates;
  return slender_steps(
      project, result.check, basis, basis.plate,
      [&](Derivation& steps) {
        return derive_corner(steps, project, result.check, basis, *basis.box);
      },
      [&](Derivation& steps, const Traced& eta_1, const Traced& eta_3) {
        const double gamma_M0 = project.strength.gamma_M0;
        WebInteraction of =
            interaction_of(*basis.plate, basis.plates->plastic, basis.corner, basis.cut, gamma_M0);
        of.factor /= basis.load_factor;
        derive_web_interaction(steps, basis.plates->plastic, of, basis.cut,
                               basis.load_factor * gamma_M0, eta_1, eta_3);
      });
}

Steps patch_steps(const Project& project, const CheckResult& result) {
  const PatchBasis& basis = *result.patch;
  const double gamma_M1 = project.strength.gamma_M1;
  Derivation steps;
  if (!(basis.share * basis.force > Force{})) {
    derive_stiffener(steps, project, result, Traced(0.0));
    return steps_of(steps);
  }
  const Traced all = steps.given("F", basis.force, "what comes in");
  steps.note([&] { return instant_of(result.check); });
  const bool alone = basis.path && basis.share == 1.0;
  const Traced share = steps.given(
      "p", basis.share, {},
      alone ? "of this web, above which it stands" : "of this web, by the lever between both");
  if (const auto* const web = std::get_if<ReducedWeb>(&basis.bears)) {
    derive_reduced_web(steps, project, result.check, *web, basis, steps.define("F_w", share * all));
    return steps_of(steps);
  }
  if (const auto* const seam = std::get_if<PatchedSeam>(&basis.bears)) {
    derive_seam(steps, project, *seam, basis, steps.define("F_w", share * all));
    return steps_of(steps);
  }
  const Traced F = steps.define("F_w", loaded(steps, basis.load_factor, Traced(share * all)));
  if (const auto* const weld = std::get_if<StiffenerWeld>(&basis.bears)) {
    steps.define("factor", derive_stiffener_weld_resistance(steps, *weld) / F);
    return steps_of(steps);
  }
  if (std::holds_alternative<BearingStiffener>(basis.bears)) {
    derive_stiffener(steps, project, result, F);
    return steps_of(steps);
  }
  const Traced resistance =
      derive_patch_resistance(steps, std::get<PatchedWeb>(basis.bears), gamma_M1);
  const Traced eta_2 = steps.define("eta_2", F / resistance);
  const ActsAndResists normal =
      basis.path ? derive_place(steps, project, result.check, basis, *basis.path, basis.place)
                 : derive_corner(steps, project, result.check, basis, *basis.box);
  if (basis.used_most != result.check.station.s)
    steps.note([&] {
      return fmt::format("at s = {} m, the largest on the loaded length",
                         to_text(Station{basis.used_most, Side::both}));
    });
  const Traced eta_1 = steps.define("eta_1", normal.acting / normal.resisting);
  derive_patch_factor(steps, eta_2, eta_1);
  steps.note([] { return "alone, 6.6, and with the beam's own stress, 7.2"; });
  return steps_of(steps);
}

Steps member_steps(const Project& project, const CheckResult& result) {
  const MemberBasis& basis = *result.member;
  const double gamma_M1 = project.strength.gamma_M1;
  Derivation steps;
  const Traced use = basis.turns_over
                         ? derive_lateral_use(steps, basis.load, basis.curve, gamma_M1)
                         : derive_flexural_use(steps, basis.load, basis.curve, gamma_M1);
  steps.note([&] { return "the beam " + basis.held; });
  const double demanded = demanded_of(project);
  if (demanded == 1.0) {
    steps.define("factor", 1.0 / use);
  } else {
    steps.define("factor", steps.known("required", demanded, {ValueKind::factor}) / use);
  }
  steps.note([&] {
    return "the largest of N and of M at any instant, load factors and the safety factor that is "
           "asked for counted";
  });
  return steps_of(steps);
}

}  // namespace boxbeam::report
