#include "model_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/verification/balance_defect.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"

namespace boxbeam {
namespace {

/// A joint that slides with dry friction, by name; "" where there is none.
std::string dry_friction_in(const Project& project, const std::deque<SituationRun>& rigid) {
  for (const SituationRun& run : rigid) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    for (const planar::FrictionContact& contact : planar::friction_contacts_of(mechanism)) {
      if (contact.law.coulomb == 0.0) continue;
      return mechanism.joints[static_cast<std::size_t>(contact.joint)].name;
    }
  }
  return "";
}

/// Whether forces decide any of the motions.
bool forces_decide(const std::deque<SituationRun>& rigid) {
  return std::any_of(rigid.begin(), rigid.end(), [](const SituationRun& run) {
    return planar_motion_of(run).freedom.undriven > 0;
  });
}

RigidMotion rigid_motion_of(const Project& project, const SituationRun& run) {
  return {&planar_in(project, *run.situation), &planar_motion_of(run), &project.beam,
          [&run](Time time) { return run.loads.loads_at(time); }};
}

/// A rod between pins that is pressed by more than what buckles it in the plane of motion by
/// itself, pi^2 E I/l^2; "" where there is none.
std::string rod_beyond_euler(const Project& project, const std::deque<SituationRun>& rigid) {
  constexpr double nearly = 0.98;
  const ElasticBody elastic = elastic_body_of(project, 8);
  for (const ElasticBody& rod : elastic.beside) {
    if (!rod.between_pins) continue;
    const double critical =
        std::pow(std::numbers::pi / rod.length, 2) * rod.stretches.front().EI(0.0);
    for (const SituationRun& run : rigid) {
      const planar::Mechanism& mechanism = planar_in(project, *run.situation);
      for (const planar::State& state : planar_motion_of(run).states) {
        const CutForceDiagram cut =
            cut_forces_of(planar::beam_loads_of(mechanism, state, rod.laid_out));
        for (const CutForcePiece& piece : cut.pieces) {
          if (-std::min(piece.N(0.0), piece.N(piece.length.value())) > nearly * critical)
            return mechanism.bodies[static_cast<std::size_t>(rod.body)].name;
        }
      }
    }
  }
  return "";
}

/// The estimate of the situation in which rigid bodies miss most.
VibrationEstimate worst_estimate(const Project& project, const std::deque<SituationRun>& rigid,
                                 double slower = 1.0) {
  const ElasticBody elastic = elastic_body_of(project, 8);
  VibrationEstimate worst;
  for (const SituationRun& run : rigid) {
    VibrationEstimate estimate =
        estimate_vibration(rigid_motion_of(project, run), elastic, run.loads, slower);
    if (worst.without_modes.empty() ||
        estimate.without_modes.front() > worst.without_modes.front()) {
      worst = std::move(estimate);
    }
  }
  return worst;
}

/// Names of the forces that follow a table, "wind, pull"; "" where none does.
std::string tabled_forces_in(const Project& project) {
  std::vector<std::string> names;
  const auto look = [&](const planar::Mechanism& mechanism) {
    for (const DriverUse& function : functions_of(mechanism)) {
      if (function.on == DriverUse::On::joint) continue;
      if (!std::holds_alternative<TableDriver>(*function.driver)) continue;
      if (std::find(names.begin(), names.end(), function.name) == names.end()) {
        names.emplace_back(function.name);
      }
    }
  };
  for (const Situation& situation : project.situations) {
    if (situation.runs()) look(planar_in(project, situation));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// What vibration adds to rigid bodies; nothing where that is not estimated, which the choice then
/// says.
std::optional<VibrationEstimate> estimate_in_plane(const Project& project,
                                                   const std::deque<SituationRun>& rigid,
                                                   const std::string& obstacle,
                                                   ModelChoice& choice) {
  if (!obstacle.empty()) {
    choose_unvibrated(project, obstacle, choice);
    return std::nullopt;
  }
  if (choice.second_order.in_plane.part >= 1.0) {
    choice.reason = "rigid bodies: " + second_order_text(choice.second_order);
    return std::nullopt;
  }
  const std::string pressed = rod_beyond_euler(project, rigid);
  if (!pressed.empty()) {
    choose_unvibrated(
        project, fmt::format("body {}, a rod, buckles by itself in the plane of motion", pressed),
        choice);
    return std::nullopt;
  }
  VibrationEstimate estimate;
  try {
    estimate = worst_estimate(project, rigid);
  } catch (const AnalysisError& error) {
    if (!forces_decide(rigid)) throw;
    choose_unvibrated(project, error.failure().what, choice);
    return std::nullopt;
  }
  if (estimate.frequencies.empty()) {
    choice.reason = "rigid bodies: no load and no mass is there that could make the beam vibrate";
    return std::nullopt;
  }
  choice.frequencies = estimate.frequencies;
  choice.harmonics = estimate.harmonics;
  return estimate;
}

/// Rigid bodies, weighed.
ModelEstimate rigid_in_plane(const std::deque<SituationRun>& rigid,
                             const VibrationEstimate& estimate, const SecondOrderEstimate& second) {
  const double of_bending = second.change.value_or(0.0);
  const bool repeats = std::all_of(rigid.begin(), rigid.end(), [](const SituationRun& run) {
    return planar_motion_of(run).closed;
  });
  return {{},
          fmt::format("{} {}, second order {}",
                      repeats ? "harmonics of the loads against the modes of six postures"
                              : "response of the modes of six postures over time",
                      percent_text(estimate.without_modes.front()), percent_text(of_bending)),
          estimate.without_modes.front() + of_bending,
          {}};
}

/// Whether bodies that bend under their axial force are enough, which the choice then says.
bool bending_is_enough(const VibrationEstimate& estimate, const Climb& climb, ModelChoice& choice) {
  ModelEstimate& by_bending = choice.weighed.emplace_back();
  by_bending.model = bent;
  by_bending.error = estimate.without_modes.front();
  by_bending.basis = "vibration left out";
  if (by_bending.error <= choice.tolerance) {
    if (by_bending.error > verified_above * choice.tolerance && !climb.unseen(0)) {
      by_bending.found = missed_beside_mode(climb.found_by(bent), estimate);
    }
    if (by_bending.found.value_or(0.0) <= choice.tolerance) {
      choice.chosen = bent;
      choice.counts_second_order = true;
      choice.reason =
          fmt::format("{}: {}; rigid bodies: {}", describe(bent), climb.against, climb.missed);
      return true;
    }
  }
  return false;
}

/// Climbs to bent bodies and to ever more modes, where rigid ones are not enough. `refused`: why
/// models could not be looked at, known when they are asked.
void climb_beyond_rigid(const Project& project, const std::deque<SituationRun>& rigid,
                        const VibrationEstimate& estimate, const Climb& climb,
                        const std::string& refused, ModelChoice& choice) {
  const bool forced = forces_decide(rigid);
  // Statics do not hold what forces move.
  if (project.model.demand == ModelDemand::automatic && !forced &&
      bending_is_enough(estimate, climb, choice))
    return;
  // A few modes do not hold what friction that turns round excites, nor how it damps it.
  const std::string rubbing = dry_friction_in(project, rigid);
  if (!rubbing.empty() && project.model.demand == ModelDemand::automatic) {
    choice.reason = fmt::format(
        "rigid bodies; what vibration adds is not known: dry friction in joint {} turns round "
        "with the motion, and without damping {}; {}",
        rubbing, climb.missed, climb.against);
    return;
  }
  std::string why = climb_modes(estimate, climb, choice);
  if (why.empty() && choice.chosen.level != ModelLevel::modal) return;
  if (choice.chosen.level == ModelLevel::modal) {
    choice.counts_second_order = true;
    return;
  }
  if (!refused.empty()) {
    why = refused;
    choice.weighed.resize(1);
  }
  if (forced && project.model.demand == ModelDemand::automatic) {
    choice.weighed.resize(1);
    choice.reason = fmt::format("rigid bodies: {}; {}; no modes of the beam are used: {}",
                                climb.against, climb.missed, why);
    return;
  }
  throw AnalysisError(
      {fmt::format("rigid bodies miss an estimated {} of the governing stress, and {}; ask for a "
                   "larger tolerance, or use --model rigid to have the loads of rigid bodies",
                   percent_text(choice.weighed.front().error), why),
       "beam",
       {},
       choice.weighed.back().found.value_or(choice.weighed.back().error),
       {}});
}

/// Climbs from rigid bodies to bent ones and to ever more modes.
ModelChoice choose_by_estimate(const Project& project, const std::deque<SituationRun>& rigid,
                               const std::string& obstacle, TriedModels& tried,
                               SecondOrderEstimate estimated) {
  ModelChoice choice = begun_choice(project, std::move(estimated));
  const std::optional<VibrationEstimate> vibrating =
      estimate_in_plane(project, rigid, obstacle, choice);
  if (!vibrating) return choice;
  const VibrationEstimate& estimate = *vibrating;
  const ModelEstimate by_rigid = rigid_in_plane(rigid, estimate, choice.second_order);
  choice.weighed.push_back(by_rigid);
  const std::string missed = missed_text(estimate, choice);
  const std::string against = against_frequencies(estimate, elastic_beside_text(project));
  const auto unseen = [&](std::size_t modes) {
    const std::string why = too_fast(rigid, estimate.frequencies, modes + 1);
    if (!why.empty())
      choice.reason = fmt::format("rigid bodies; what vibration adds is not known: {}; {}; {}", why,
                                  missed, against);
    return !why.empty();
  };
  const bool forced = forces_decide(rigid);
  // What forces move may pass postures in which its modes are others: that is known only then.
  std::string refused;
  const auto unless_refused = [&](const auto& ask) {
    if (!forced) return ask();
    try {
      return ask();
    } catch (const AnalysisError& error) {
      refused = error.failure().what;
      return std::numeric_limits<double>::infinity();
    }
  };
  const auto found_by = [&](const ElasticModel& model) {
    return unless_refused([&] { return tried.error_found(model); });
  };
  bool enough = by_rigid.error <= choice.tolerance;
  std::string found;
  if (enough && by_rigid.error > verified_above * choice.tolerance &&
      project.model.demand == ModelDemand::automatic && !unseen(0)) {
    const double against_mode = missed_beside_mode(found_by({}), estimate);
    if (refused.empty()) {
      choice.weighed.back().found = against_mode;
      found = fmt::format(", found {} with one mode in every posture and what that misses",
                          percent_text(against_mode));
      enough = against_mode <= choice.tolerance;
    }
  }
  if (project.model.demand == ModelDemand::rigid ||
      (enough && project.model.demand == ModelDemand::automatic)) {
    choice.reason = fmt::format("rigid bodies{}: {}; {}{}",
                                project.model.demand == ModelDemand::rigid ? ", as demanded" : "",
                                against, missed, found);
    return choice;
  }
  const Climb climb{missed, against, found_by,
                    [&](std::size_t modes) {
                      return project.model.demand == ModelDemand::automatic && unseen(modes);
                    },
                    [&] { return unless_refused([&] { return tried.error_of_parts(); }); }};
  climb_beyond_rigid(project, rigid, estimate, climb, refused, choice);
  return choice;
}

/// The largest of all situations.
double largest_design_factor_of(const Project& project) {
  double factor = 1.0;
  for (const Situation& situation : project.situations)
    if (situation.runs()) factor = std::max(factor, design_factor_of(project, situation));
  return factor;
}

/// What the lowest mode adds to the stress where the axial force of the design loads makes the beam
/// softer than that of the loads times one, of a beam that vibrates:
///
///     sum of share (|D| - |D_1|),  D = 1/(1 - (f/f_1)^2),  f_1^2 ~ 1 - N/N_cr
///
/// share, f  of the harmonics of the loads. Where a frequency is met on the way there is no bound.
/// Of a motion that does not repeat it is what the response over time grows by (`slower`).
/// Source: Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974), section 5.12.
void add_slower_vibration(const Project& project, const std::deque<SituationRun>& rigid,
                          double factor, ModelChoice& choice) {
  SecondOrderEstimate& of = choice.second_order;
  if (choice.chosen.level == ModelLevel::quasi_static || choice.frequencies.empty()) return;
  if (factor == 1.0 || of.in_plane.part <= 0.0 || of.in_plane.part >= 1.0) return;
  const double softer = (1.0 - of.in_plane.part) / (1.0 - of.in_plane.part / factor);
  double adds = 0.0;
  const bool open = std::any_of(rigid.begin(), rigid.end(),
                                [](const SituationRun& run) { return !run.loads.closed(); });
  if (open) {
    const double once = worst_estimate(project, rigid).without_modes.front();
    adds = std::max(0.0,
                    worst_estimate(project, rigid, std::sqrt(softer)).without_modes.front() - once);
  }
  for (const LoadHarmonic& load : choice.harmonics) {
    const double square = std::pow(load.frequency / choice.frequencies.front(), 2);
    const double once = 1.0 - square, designed = 1.0 - square / softer;
    if (once * designed <= 0.0) adds = std::numeric_limits<double>::infinity();
    adds += std::max(0.0, load.share * (1.0 / std::abs(designed) - 1.0 / std::abs(once)));
  }
  for (StressGrowth& at : of.growth) at.stress += adds;
}

}  // namespace

ModelChoice choose_in_plane(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            DesignedSecondOrder designed) {
  ModelChoice choice =
      choose_by_estimate(project, rigid, obstacle, tried, std::move(designed.estimate));
  if (choice.counts_second_order) {
    // What its cut forces hold is the second order of the loads times one.
    choice.second_order.growth = std::move(designed.beyond_once);
    add_slower_vibration(project, rigid, largest_design_factor_of(project), choice);
  }
  if (choice.chosen.level == ModelLevel::rigid) return choice;
  const std::string tabled = tabled_forces_in(project);
  if (!tabled.empty()) {
    choice.reason += fmt::format(
        "; load {} comes from a table: if it was measured on the machine it contains the "
        "vibration, which counts twice here, and [model] wants loads = \"measured\"",
        tabled);
  }
  return choice;
}

void weigh_balance(const Project& project, const std::deque<SituationRun>& rigid,
                   const std::deque<SituationRun>& by_model, ModelChoice& choice) {
  if (choice.weighed.empty()) return;
  const ElasticBody elastic = elastic_body_of(project, 8);
  double unbalanced = 0.0;
  for (std::size_t i = 0; i < rigid.size(); ++i) {
    // Series of Fourier have no second derivative where something jumps or bends.
    const std::string obstacle =
        !elastic.alone()           ? "what is beside it is elastic as well"
        : !rigid[i].loads.closed() ? "the motion does not repeat"
        : by_model[i].loads.span().breaks.empty()
            ? obstacle_to_balance(planar_in(project, *rigid[i].situation), elastic.body)
            : "its loads jump or bend at points of a table or ends of a step";
    if (!obstacle.empty()) {
      choice.reason +=
          fmt::format("; what it leaves unbalanced on the bent beam is not known: {}", obstacle);
      return;
    }
    unbalanced =
        std::max(unbalanced, error_by_balance(rigid_motion_of(project, rigid[i]), elastic,
                                              static_cast<std::size_t>(choice.chosen.modes),
                                              by_model[i].loads));
  }
  ModelEstimate& last = choice.weighed.back();
  last.found = std::max(last.found.value_or(last.error), unbalanced);
  choice.reason +=
      unbalanced < unknown_balance
          ? fmt::format("; on the beam as far bent as it is, {} of the stress is unbalanced",
                        percent_text(unbalanced))
          : "; on the beam as far bent as it is nothing is in balance";
}

}  // namespace boxbeam
