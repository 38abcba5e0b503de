#include "boxbeam/verification/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bent_flanges.hpp"
#include "boxbeam/core/append.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {
namespace {

/// Of the case's material or of structural steel, which pins may be of, the one that makes contact
/// harder.
Stress pin_modulus_of(const Project& project) {
  return std::max(steel_modulus, si<Stress>(project.model.youngs_modulus), std::less<>());
}

/// The largest value over all situations, times their load factors where these count.
Extreme worst_of(const Project& project, const NeighbourRuns& runs,
                 const std::function<double(NeighbourLoads&, double)>& f, bool factored = true) {
  Extreme worst;
  for (const auto& run : runs) {
    Extreme in = run->largest(project, [&](double time) { return f(*run, time); });
    if (factored) in.value *= run->run().situation->load_factor;
    if (run == runs.front() || in.value > worst.value) worst = in;
  }
  return worst;
}

}  // namespace

void check_unique(const NeighbourRuns& runs, int joint, const std::string& of) {
  for (const auto& run : runs) {
    if (run->determines(joint)) continue;
    throw AnalysisError({fmt::format("the load on {} is not determined by rigid bodies: joints "
                                     "repeat each other, and how they share their load depends on "
                                     "their stiffness; release one of them",
                                     of),
                         "joint " + run->joint_name(joint)});
  }
}

double negligible_force(const NeighbourRuns& runs) {
  double largest = 0.0;
  for (const auto& run : runs) {
    for (const SampledInstant& instant : run->span().instants)
      largest =
          std::max(largest, run->run().situation->load_factor * run->largest_force(instant.at));
  }
  return 1e-9 * largest;
}

namespace {

Gate rod_gate(const RodInput& rod, const std::string& finding) {
  return {"", "", fmt::format("rod {}: {}", rod.name, finding), true};
}

}  // namespace

Check check_begun(Criterion criterion, const std::string& name, const Project& project,
                  const Extreme& worst) {
  Check check;
  check.criterion = criterion;
  check.point = name;
  check.on_beam = false;
  check.situation = project.situations[worst.situation].name;
  check.time = worst.time;
  check.acting = si<Force>(worst.value);
  check.id = fmt::format("{}/{}", to_text(criterion), name);
  std::replace(check.id.begin(), check.id.end(), ' ', '-');
  return check;
}

namespace {

/// A plate of a pin under the largest force.
NeighbourResult check_lug(const Project& project, const PinInput& pin, const LugInput& lug,
                          const Extreme& worst) {
  const LoadedLug loaded{share_of(lug), lug.plate, lug.yield_strength, pin.strength.gamma_M0};
  NeighbourResult result{check_begun(Criterion::pin, name_of(pin, lug), project, worst), loaded};
  Check& check = result.check;
  check.resisting =
      Force(lug_resistance_of(loaded.plate, loaded.yield_strength, loaded.gamma_M0) / loaded.share);
  check.safety_factor = check.resisting / check.acting;
  check.required = pin.required;
  check.source = "EN 1993-1-8:2005, 3.13.1, table 3.9, type A";
  return result;
}

/// A pin that is to be replaceable, under its largest force without load factors.
NeighbourResult check_in_service(const Project& project, const PinInput& pin,
                                 const Extreme& worst) {
  const double largest = governing_utilisation(replaceable_pin_utilisation(
      si<Force>(worst.value), pin_modulus_of(project), pin.geometry, pin.strength));
  NeighbourResult result{check_begun(Criterion::pin, pin.name + " in service", project, worst),
                         ServedPin{pin.geometry, pin.strength, pin_modulus_of(project)}};
  Check& check = result.check;
  check.safety_factor = 1.0 / largest;
  check.resisting = si<Force>(worst.value / largest);
  check.required = pin.required;
  check.source = "EN 1993-1-8:2005, 3.13.2(3), table 3.10, equations 3.14 to 3.16";
  return result;
}

}  // namespace

namespace {

/// Plates of a pin that are not given, which are weakest beside and before its hole.
void add_unknown_plates(const PinInput& pin, NeighbourChecks& checks) {
  const std::string unknown = unknown_plates_of(pin);
  if (unknown.empty()) return;
  checks.not_judged.push_back({Criterion::pin,
                               fmt::format("{} of {} beside and before its hole (EN 1993-1-8, "
                                           "table 3.9)",
                                           unknown, pin.name),
                               "[[pins.lugs]] are not given"});
}

/// What the joint of a pin bears that no check of the pin counts: a moment across it, which its
/// outer plates take as two forces, and a force along it.
void look_beside(const Project& project, const NeighbourRuns& runs, const PinInput& pin,
                 const Extreme& worst, NeighbourChecks& checks) {
  const double moment = worst_of(project, runs, [&](NeighbourLoads& of, double time) {
                          return of.beside_pin(pin.joint, time).moment;
                        }).value;
  const double along = worst_of(project, runs, [&](NeighbourLoads& of, double time) {
                         return of.beside_pin(pin.joint, time).along;
                       }).value;
  const PinJoint& of = pin.geometry;
  const double lever = (of.inner_plate + 2.0 * of.gap + of.outer_plate).value();
  // Beside half of the pin's force, in either of its outer plates.
  constexpr double hardly = 0.04;
  if (2.0 * moment > hardly * worst.value * lever) {
    checks.gates.push_back(
        {"", "",
         fmt::format(
             "pin {}: its joint bears a moment of {:.3g} kN m across the pin as well, which "
             "is not judged; a joint that leaves it free says so (\"spherical\")",
             pin.name, 1e-3 * moment),
         true});
  }
  if (along > hardly * worst.value) {
    checks.not_judged.push_back(
        {Criterion::pin, "pin " + pin.name,
         fmt::format("{:.3g} kN along it, which what keeps it in its hole bears", 1e-3 * along)});
  }
}

}  // namespace

NeighbourChecks check_pins(const Project& project, const std::deque<SituationRun>& solved) {
  NeighbourChecks checks;
  if (project.pins.empty()) return checks;
  const NeighbourRuns runs = neighbour_loads_of(project, solved);
  const double nothing = negligible_force(runs);
  for (const PinInput& pin : project.pins) {
    check_unique(runs, pin.joint, "pin " + pin.name);
    const auto force = [&](NeighbourLoads& of, double time) {
      return of.force_in(pin.joint, time);
    };
    const Extreme worst = worst_of(project, runs, force);
    look_beside(project, runs, pin, worst, checks);
    if (worst.value <= nothing) {
      checks.not_judged.push_back({Criterion::pin, "pin " + pin.name, "no force"});
      continue;
    }
    const double largest =
        governing_utilisation(pin_utilisation(si<Force>(worst.value), pin.geometry, pin.strength));
    NeighbourResult result{check_begun(Criterion::pin, pin.name, project, worst),
                           LoadedPin{pin.geometry, pin.strength}};
    Check& check = result.check;
    check.safety_factor = 1.0 / largest;
    check.resisting = si<Force>(worst.value / largest);
    check.required = pin.required;
    check.source = "EN 1993-1-8:2005, 3.13.2, table 3.10";
    checks.results.push_back(std::move(result));
    add_unknown_plates(pin, checks);
    for (const LugInput& lug : pin.lugs) {
      checks.results.push_back(check_lug(project, pin, lug, worst));
      if (!lug.plate.end)
        checks.not_judged.push_back({Criterion::pin, name_of(pin, lug) + ", end before its hole",
                                     "the lug has no \"end\""});
    }
    if (pin.replaceable)
      checks.results.push_back(
          check_in_service(project, pin, worst_of(project, runs, force, false)));
  }
  return checks;
}

namespace {

/// The check of a rod by the least of its resistances.
Check check_of(Criterion criterion, const Project& project, const RodInput& rod,
               const Extreme& worst, Force resistance, const char* source) {
  Check check = check_begun(criterion, rod.name, project, worst);
  check.resisting = resistance;
  check.safety_factor = check.resisting / check.acting;
  check.required = rod.required;
  check.source = source;
  return check;
}

NeighbourResult check_tension(const Project& project, const RodInput& rod, const Extreme& worst) {
  const PulledRod pulled{properties_of(rod.section).area,
                         rod.net_area,
                         rod.yield_strength,
                         rod.tensile_strength,
                         rod.gamma_M0,
                         rod.gamma_M2,
                         eccentric_force_of(rod.section, rod.yield_strength)};
  return {check_of(Criterion::rod, project, rod, worst, tension_resistance_of(pulled).least,
                   "EN 1993-1-1:2005, 6.2.3"),
          pulled};
}

std::optional<EccentricForce> force_beside(const RodInput& rod, const CompressedSection& section) {
  return eccentric_force_of(rod.section, rod.yield_strength, section.shift_y, section.shift_z);
}

/// Why a rod is not judged under tension, "" where it is.
std::string tension_obstacle_of(const RodInput& rod) {
  return eccentric_force_of(rod.section, rod.yield_strength)
             ? bent_plates_obstacle_of(rod.section, rod.yield_strength)
             : std::string();
}

/// Why a rod is not judged under compression, "" where it is.
std::string compression_obstacle_of(const RodInput& rod, const CompressedSection& section,
                                    Stress youngs_modulus) {
  if (!section.obstacle.empty()) return section.obstacle;
  const auto is_path = [](const Profile& of) { return std::holds_alternative<ThinWalled>(of); };
  const bool thin =
      is_path(rod.section.outer) || (rod.section.inner && is_path(*rod.section.inner));
  if (thin && !twisting_rod_of(rod.section, youngs_modulus, rod.buckling_length, {}))
    return "how it twists is not known, and so its torsional buckling is not (EN 1993-1-1, "
           "6.3.1.4)";
  const auto beside = force_beside(rod, section);
  if (!beside) return "";
  const std::string why = bent_plates_obstacle_of(rod.section, rod.yield_strength);
  return why.empty() ? turning_obstacle_of(rod.section, section.shift_y, section.shift_z) : why;
}

NeighbourResult check_compression(const Project& project, const RodInput& rod,
                                  const CompressedSection& section, const Extreme& worst) {
  const Stress youngs_modulus = rod_modulus_of(project);
  const SectionProperties properties = properties_of(rod.section);
  const char* const source = section.class_4
                                 ? "EN 1993-1-1:2005, 6.3.1; effective area EN 1993-1-5:2006, 4.4"
                                 : "EN 1993-1-1:2005, 6.3.1";
  PressedRod pressed{section,
                     properties.I_2,
                     properties.I_z < properties.I_y,
                     rod.buckling_length,
                     youngs_modulus,
                     rod.yield_strength,
                     rod.curve,
                     rod.gamma_M0,
                     rod.gamma_M1,
                     twisting_rod_of(rod.section, youngs_modulus, rod.buckling_length, rod.length),
                     force_beside(rod, section)};
  const Force resistance = compression_resistance_of(pressed).least;
  return {check_of(Criterion::buckling, project, rod, worst, resistance, source),
          std::move(pressed)};
}

/// What bends a rod beside its force: no verdict where a check of it, of those from `before` on,
/// passes and would not with it; else said where it is as much as a second order that counts.
void add_own_bending(const RodInput& rod, Stress bending, std::size_t before,
                     NeighbourChecks& checks) {
  double most = 1.0, alone = 0.0;
  for (std::size_t i = before; i < checks.results.size(); ++i) {
    const NeighbourResult& result = checks.results[i];
    const double use = use_with_bending(rod, result, bending);
    if (!result.check.passes() || use <= most) continue;
    most = use;
    alone = result.check.utilisation();
  }
  const std::string text =
      fmt::format("its own weight and inertia bend it, by {:.3g} MPa at most about its weaker axis",
                  1e-6 * bending.value());
  if (most > 1.0) {
    checks.gates.push_back(rod_gate(
        rod, fmt::format("{}, with which {} used by its force becomes {} (EN 1993-1-1, 6.3.3)",
                         text, percent_text(alone), percent_text(most))));
    return;
  }
  // EN 1993-1-1, 6.3.1.2(4).
  constexpr double hardly = 0.04;
  if (bending > hardly * rod.yield_strength)
    checks.not_judged.push_back(
        {Criterion::rod, "rod " + rod.name, text + ", which is not counted"});
}

/// Fatigue that is asked for and that no detail of a rod judges.
void add_unjudged_range(const Project& project, const NeighbourRuns& runs, const RodInput& rod,
                        NeighbourChecks& checks) {
  const auto largest = [&](double AxialForces::*which) {
    constexpr bool factored = false;
    return worst_of(
               project, runs,
               [&](NeighbourLoads& of, double time) {
                 return of.axial_forces_in(rod, time).*which;
               },
               factored)
        .value;
  };
  const Area area = rod.net_area.value_or(properties_of(rod.section).area);
  const Stress range =
      si<Force>(largest(&AxialForces::tension) + largest(&AxialForces::compression)) / area;
  if (range > hardly_changes)
    checks.not_judged.push_back(
        {Criterion::rod, "rod " + rod.name,
         fmt::format("in fatigue; its force changes its stress by {:.3g} MPa",
                     1e-6 * range.value())});
}

}  // namespace

NeighbourChecks check_rods(const Project& project, const std::deque<SituationRun>& solved) {
  NeighbourChecks checks;
  if (project.rods.empty()) return checks;
  const NeighbourRuns runs = neighbour_loads_of(project, solved);
  const double nothing = negligible_force(runs);
  for (const RodInput& rod : project.rods) {
    const std::size_t before = checks.results.size();
    for (const int joint : runs.front()->joints_of(rod))
      check_unique(runs, joint, "rod " + rod.name);
    const auto largest = [&](double AxialForces::*which) {
      return worst_of(project, runs, [&](NeighbourLoads& of, double time) {
        return of.axial_forces_in(rod, time).*which;
      });
    };
    const Extreme tension = largest(&AxialForces::tension);
    const Extreme compression = largest(&AxialForces::compression);
    if (tension.value <= nothing && compression.value <= nothing) {
      checks.not_judged.push_back({Criterion::rod, "rod " + rod.name, "no force"});
    }
    if (tension.value > nothing) {
      const std::string obstacle = tension_obstacle_of(rod);
      if (obstacle.empty())
        checks.results.push_back(check_tension(project, rod, tension));
      else
        checks.gates.push_back(rod_gate(rod, obstacle));
    }
    if (compression.value > nothing) {
      const CompressedSection section = compressed_section_of(rod.section, rod.yield_strength);
      const std::string obstacle = compression_obstacle_of(rod, section, rod_modulus_of(project));
      if (obstacle.empty()) {
        checks.results.push_back(check_compression(project, rod, section, compression));
      } else {
        checks.gates.push_back(rod_gate(rod, obstacle));
      }
    }
    add_own_bending(rod, own_bending_of(runs, rod), before, checks);
    if (project.fatigue.asked) add_unjudged_range(project, runs, rod, checks);
    std::vector<std::string> bending;
    for (const auto& run : runs) {
      for (std::string& name : run->bending_of(rod)) {
        if (std::find(bending.begin(), bending.end(), name) == bending.end()) {
          bending.push_back(std::move(name));
        }
      }
    }
    if (bending.empty()) continue;
    checks.gates.push_back(rod_gate(
        rod, fmt::format("{} {} it beside its ends or turn{} it, and its bending is not counted",
                         fmt::join(bending, ", "), bending.size() == 1 ? "loads" : "load",
                         bending.size() == 1 ? "s" : "")));
  }
  return checks;
}

NeighbourChecks check_neighbours(const Project& project, const std::deque<SituationRun>& runs) {
  NeighbourChecks all = check_pins(project, runs);
  for (NeighbourChecks more : {check_lugs(project, runs), check_rods(project, runs)}) {
    append(std::move(more.results), all.results);
    append(std::move(more.gates), all.gates);
    append(std::move(more.not_judged), all.not_judged);
  }
  return all;
}

}  // namespace boxbeam
