#include "boxbeam/verification/neighbours.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <type_traits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/peak_over_time.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {
namespace {

/// The modulus of structural steel. Source: EN 1993-1-1:2005, 3.2.6.
constexpr Stress of_steel = 210e9 * pascal;

/// The moduli of rods and pins: of the case's material or of structural steel, which they may be
/// of, the one that makes rods softer and contact harder.
Stress rod_modulus_of(const Project& project) {
  return std::min(of_steel, si<Stress>(project.model.youngs_modulus), std::less<>());
}
Stress pin_modulus_of(const Project& project) {
  return std::max(of_steel, si<Stress>(project.model.youngs_modulus), std::less<>());
}

/// Largest value of a function of the state over the motion, found between the instants.
Extreme largest_over(const Project& project, const SituationRun& run,
                     const std::function<double(const planar::State&)>& f) {
  const planar::Motion& motion = planar_motion_of(run);
  planar::StateFinder finder(planar_in(project, *run.situation), motion);
  const double end = motion.begin + motion.period;
  const auto value_at = [&](double time) {
    return f(finder.at(motion.closed ? time : std::clamp(time, motion.begin, end)));
  };
  // At the instants of the loads: they know where drivers and forces jump or bend.
  const SampledTime span = sampled_time_of(run.loads);
  std::vector<double> values;
  for (const SampledInstant& instant : span.instants) values.push_back(value_at(instant.at));
  const Extremum peak = peak_over_time(values, span, value_at);
  return {si<Time>(peak.at), peak.value, index_of(project, *run.situation)};
}

/// The largest value over all situations, times their load factors where these count.
Extreme worst_of(const Project& project, const std::deque<SituationRun>& runs,
                 const std::function<double(const SituationRun&, const planar::State&)>& f,
                 bool factored = true) {
  Extreme worst;
  for (const SituationRun& run : runs) {
    Extreme in =
        largest_over(project, run, [&](const planar::State& state) { return f(run, state); });
    if (factored) in.value *= run.situation->load_factor;
    if (&run == &runs.front() || in.value > worst.value) worst = in;
  }
  return worst;
}

}  // namespace

void check_unique(const Project& project, const std::deque<SituationRun>& runs, int joint,
                  const std::string& of) {
  for (const SituationRun& run : runs) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    if (planar::is_unique(mechanism, planar_motion_of(run).freedom, joint)) continue;
    throw AnalysisError({fmt::format("the load on {} is not determined by rigid bodies: joints "
                                     "repeat each other, and how they share their load depends on "
                                     "their stiffness; release one of them",
                                     of),
                         "joint " + mechanism.joints[static_cast<std::size_t>(joint)].name,
                         {},
                         {},
                         {}});
  }
}

namespace {

double force_in(const Project& project, const SituationRun& run, const planar::State& state,
                int joint) {
  for (const planar::Reaction& reaction :
       planar::reactions_of(planar_in(project, *run.situation), state)) {
    if (reaction.joint == joint) return reaction.force.norm();
  }
  return 0.0;
}

}  // namespace

double negligible_force(const Project& project, const std::deque<SituationRun>& runs) {
  double largest = 0.0;
  for (const SituationRun& run : runs) {
    for (const planar::State& state : planar_motion_of(run).states) {
      for (const planar::Reaction& reaction :
           planar::reactions_of(planar_in(project, *run.situation), state)) {
        largest = std::max(largest, run.situation->load_factor * reaction.force.norm());
      }
    }
  }
  return 1e-9 * largest;
}

namespace {

/// Whether a point of a rod's body is one of its ends.
bool is_at(const Eigen::Vector2d& point, const planar::Attachment& end, const RodInput& rod) {
  return (point - end.p).norm() < 1e-9 * (rod.to.p - rod.from.p).norm();
}

/// The largest tension and the largest compression anywhere in a rod, below zero where it has none.
struct AxialForces {
  double tension = 0.0, compression = 0.0;
};

/// Of an even rod that turns, the tension along it is a parabola, highest above its chord, by
/// m omega^2 L/8, in the middle; the compression is largest at an end.
AxialForces axial_forces_in(const Project& project, const SituationRun& run,
                            const planar::State& state, const RodInput& rod) {
  const planar::Mechanism& mechanism = planar_in(project, *run.situation);
  const auto body = static_cast<std::size_t>(rod.from.body);
  const Eigen::Vector2d line = rod.to.p - rod.from.p;
  const Eigen::Vector2d along =
      Eigen::Rotation2Dd(state.q[3 * rod.from.body + 2]) * line.normalized();
  double at_from = 0.0;  // tension in the rod at either end
  double at_to = 0.0;
  const auto add = [&](int on, const Eigen::Vector2d& point, const Eigen::Vector2d& force) {
    if (on != rod.from.body) return;
    if (is_at(point, rod.from, rod)) at_from -= force.dot(along);
    if (is_at(point, rod.to, rod)) at_to += force.dot(along);
  };
  for (const planar::Reaction& reaction : planar::reactions_of(mechanism, state)) {
    add(reaction.on, reaction.point, reaction.force);
  }
  for (const planar::AppliedLoad& load :
       planar::applied_loads_of(mechanism, state.time, state.q, state.v)) {
    add(load.on, load.point, load.vector);
  }
  const double omega = state.v[3 * rod.from.body + 2];
  const double rise = 0.5 * mechanism.bodies[body].mass * omega * omega * line.norm();
  const auto tension_at = [&](double x) {
    return at_from + (at_to - at_from) * x + rise * x * (1.0 - x);
  };
  const double highest = rise > 0.0 ? 0.5 * (1.0 + (at_to - at_from) / rise) : 0.0;
  return {std::max({at_from, at_to, tension_at(std::clamp(highest, 0.0, 1.0))}),
          std::max(-at_from, -at_to)};
}

/// What turns a rod or loads it beside its ends, so that it bends: the names of joints and forces.
std::vector<std::string> bending_of(const planar::Mechanism& mechanism, const RodInput& rod) {
  std::vector<std::string> names;
  const auto beside = [&](const planar::Attachment& at) {
    return at.body == rod.from.body && !is_at(at.p, rod.from, rod) && !is_at(at.p, rod.to, rod);
  };
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    if (a.body != rod.from.body && b.body != rod.from.body) continue;
    const auto [hold, other] = planar::holds_of(joint);
    // In a slot the rod's end turns; what slides along the rod bends it.
    const bool turns_freely =
        hold == planar::Hold::place &&
        (other == planar::Hold::place || (other == planar::Hold::guide && b.body != rod.from.body));
    if (!turns_freely || beside(a) || beside(b)) names.push_back(joint.name);
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    const bool bends = std::visit(
        [&](const auto& kind) {
          using Kind = std::decay_t<decltype(kind)>;
          if constexpr (std::is_same_v<Kind, planar::PointForce>) {
            return beside(kind.at);
          } else if constexpr (std::is_same_v<Kind, planar::Spring>) {
            return beside(kind.a) || beside(kind.b);
          } else {
            return kind.a.body == rod.from.body || kind.b.body == rod.from.body;
          }
        },
        force.kind);
    if (bends) names.push_back(force.name);
  }
  return names;
}

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

NeighbourChecks check_pins(const Project& project, const std::deque<SituationRun>& runs) {
  NeighbourChecks checks;
  if (project.pins.empty()) return checks;
  const double nothing = negligible_force(project, runs);
  for (const PinInput& pin : project.pins) {
    check_unique(project, runs, pin.joint, "pin " + pin.name);
    const auto force = [&](const SituationRun& run, const planar::State& state) {
      return force_in(project, run, state, pin.joint);
    };
    const Extreme worst = worst_of(project, runs, force);
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
  const Length between = si<Length>((rod.to.p - rod.from.p).norm());
  PressedRod pressed{section,
                     properties.I_2,
                     properties.I_z < properties.I_y,
                     rod.buckling_length,
                     youngs_modulus,
                     rod.yield_strength,
                     rod.curve,
                     rod.gamma_M0,
                     rod.gamma_M1,
                     twisting_rod_of(rod.section, youngs_modulus, rod.buckling_length, between),
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

}  // namespace

NeighbourChecks check_rods(const Project& project, const std::deque<SituationRun>& runs) {
  NeighbourChecks checks;
  if (project.rods.empty()) return checks;
  const double nothing = negligible_force(project, runs);
  for (const RodInput& rod : project.rods) {
    const std::size_t before = checks.results.size();
    for (std::size_t i = 0; i < planar_of(project).joints.size(); ++i) {
      const auto [a, b] = planar::ends_of(planar_of(project).joints[i]);
      if (a.body != rod.from.body && b.body != rod.from.body) continue;
      check_unique(project, runs, static_cast<int>(i), "rod " + rod.name);
    }
    const auto largest = [&](double AxialForces::*which) {
      return worst_of(project, runs, [&](const SituationRun& run, const planar::State& state) {
        return axial_forces_in(project, run, state, rod).*which;
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
    add_own_bending(rod, own_bending_of(project, runs, rod), before, checks);
    std::vector<std::string> bending;
    for (const SituationRun& run : runs) {
      for (std::string& name : bending_of(planar_in(project, *run.situation), rod)) {
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
    std::move(more.results.begin(), more.results.end(), std::back_inserter(all.results));
    std::move(more.gates.begin(), more.gates.end(), std::back_inserter(all.gates));
    std::move(more.not_judged.begin(), more.not_judged.end(), std::back_inserter(all.not_judged));
  }
  return all;
}

}  // namespace boxbeam
