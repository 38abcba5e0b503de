#include "model_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "elastic_motion_in_space.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

/// A joint of a mechanism in space that slides with dry friction, by name; "" where there is none.
std::string dry_friction_in_space(const std::deque<SituationRun>& rigid) {
  for (const SituationRun& run : rigid) {
    const spatial::Mechanism& mechanism = chain_of(run).mechanism();
    for (const spatial::Joint& joint : mechanism.joints)
      if (joint.friction.coulomb > 0.0) return joint.name;
    for (const spatial::ClosingJoint& joint : mechanism.closing)
      if (joint.friction.coulomb > 0.0) return joint.name;
  }
  return "";
}

/// Of the situation in which rigid bodies miss most, or of the first whose beam has no modes; where
/// that is not `estimated`, of the one with the lowest frequency. `bends_known`: as of each.
VibrationInSpace worst_estimate_in_space(const Project& project,
                                         const std::deque<SituationRun>& rigid, bool estimated,
                                         bool bends_known) {
  std::optional<VibrationInSpace> worst;
  const auto rank = [&](const VibrationEstimate& of) {
    const double slow = of.frequencies.empty() ? 0.0 : 1.0 / of.frequencies.front();
    return std::pair(estimated ? of.without_modes.front() : 0.0, slow);
  };
  for (const SituationRun& run : rigid) {
    constexpr int parts = 8;
    VibrationInSpace of = estimate_vibration_in_space(project, run, parts, bends_known);
    if (!of.obstacle.empty()) return of;
    if (!worst || rank(of.estimate) > rank(worst->estimate)) worst = std::move(of);
  }
  return *worst;
}

bool forces_move(const std::deque<SituationRun>& runs) {
  return std::any_of(runs.begin(), runs.end(),
                     [](const SituationRun& run) { return chain_of(run).forced() != nullptr; });
}

/// Why the beam of a case in space has no modes that hold over its motion; "" where it has.
std::string obstacle_to_modes_in_space(const Project& project,
                                       const std::deque<SituationRun>& rigid) {
  for (const SituationRun& run : rigid) {
    const spatial::Mechanism& mechanism = chain_of(run).mechanism();
    std::string obstacle = obstacle_to_modes(mechanism, elastic_placements(project, mechanism));
    if (!obstacle.empty()) return obstacle;
  }
  return "";
}

/// A beam in space whose vibration is known.
struct WeighedInSpace {
  VibrationEstimate estimate;
  std::string against;  ///< `against_frequencies`
};

/// Its vibration; nothing where that is not known, which the choice then says.
std::optional<WeighedInSpace> weigh_in_space(const Project& project,
                                             const std::deque<SituationRun>& rigid,
                                             const std::string& obstacle, ModelChoice& choice) {
  const SecondOrderEstimate& second = choice.second_order;
  if (second.in_plane.part >= 1.0) {
    choose_unvibrated(project, obstacle.empty() ? "the beam buckles" : obstacle, choice);
    return std::nullopt;
  }
  const VibrationInSpace found =
      worst_estimate_in_space(project, rigid, obstacle.empty(), second.whole);
  if (!found.obstacle.empty()) {
    choose_unvibrated(project, found.obstacle, choice);
    return std::nullopt;
  }
  VibrationEstimate estimate = found.estimate;
  if (estimate.frequencies.empty()) {
    choice.reason = "rigid bodies: no load and no mass is there that could make the beam vibrate";
    return std::nullopt;
  }
  // Of other situations there may be some.
  if (!obstacle.empty()) estimate.harmonics.clear();
  choice.frequencies = estimate.frequencies;
  choice.harmonics = estimate.harmonics;
  const std::string against = against_frequencies(
      estimate, fmt::format(" ({}, of the mechanism stopped at {:.4g} s){}", found.shape,
                            found.lowest_at.value(), elastic_beside_text(project)));
  if (!obstacle.empty()) {
    choose_unvibrated(project, obstacle, choice);
    choice.reason += "; " + against;
    return std::nullopt;
  }
  return WeighedInSpace{std::move(estimate), against};
}

/// Which modes a larger tolerance would admit, of those that can be looked at.
std::string admitted_by_more(const ModelChoice& choice,
                             const std::function<bool(std::size_t modes)>& seen) {
  const ModelEstimate* best = nullptr;
  for (const ModelEstimate& of : choice.weighed) {
    if (of.model.level != ModelLevel::modal || of.found) continue;
    if (of.error > choice.tolerance && (best == nullptr || of.error < best->error) &&
        seen(static_cast<std::size_t>(of.model.modes)))
      best = &of;
  }
  if (best == nullptr || best->error > 0.5 * choice.weighed.front().error) return "";
  return fmt::format("; {} mode{} estimated to miss {}, which a larger [model] tolerance admits",
                     best->model.modes, best->model.modes == 1 ? " is" : "s are",
                     percent_text(best->error));
}

/// Whether rigid bodies are enough, or bent ones where the second order asks for them, which the
/// choice then says. `refused`: why better models could not be looked at; `of_bending`: what the
/// second order adds.
bool modes_are_needless(const Project& project, const VibrationEstimate& estimate,
                        const Climb& climb, bool has_modes, const std::string& refused,
                        double of_bending, ModelChoice& choice) {
  const double missed = estimate.without_modes.front();
  if (!(missed <= choice.tolerance) || project.model.demand != ModelDemand::automatic) return false;
  bool enough = true;
  std::string found_once;
  if (missed > verified_above * choice.tolerance && has_modes && !climb.unseen(0)) {
    const double against_mode = missed_beside_mode(climb.found_by({}), estimate);
    if (refused.empty()) {
      choice.weighed.back().found = against_mode;
      found_once = fmt::format(", found {} with one mode in every posture and what that misses",
                               percent_text(against_mode));
      choice.reason += found_once;
      enough = against_mode <= choice.tolerance;
    }
  }
  if (enough && !(missed + of_bending > choice.tolerance ||
                  is_pressed_in_space(project, choice.second_order)))
    return true;
  if (enough) {
    choice.chosen = bent;
    choice.counts_second_order = true;
    choice.weighed.push_back({bent, "vibration left out", missed, {}});
    choice.reason = fmt::format("{}: {}; rigid bodies: {}{}{}", describe(bent), climb.against,
                                climb.missed, found_once, left_out_of_bending(project));
    return true;
  }
  return false;
}

/// What rigid bodies miss, and how that was weighed.
ModelEstimate rigid_estimate_of(const std::deque<SituationRun>& rigid,
                                const SecondOrderEstimate& pressed, double missed,
                                double of_bending) {
  const bool repeats = std::all_of(rigid.begin(), rigid.end(),
                                   [](const SituationRun& run) { return run.loads.closed(); });
  return {{},
          fmt::format("{} the modes of the mechanism stopped in postures over its motion {}{}",
                      repeats ? "harmonics of the loads against" : "response over time of",
                      percent_text(missed),
                      pressed.whole ? ", second order " + percent_text(of_bending) : std::string()),
          missed + of_bending,
          {}};
}

}  // namespace

ModelChoice choose_in_space(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            SecondOrderEstimate estimated) {
  ModelChoice choice = begun_choice(project, std::move(estimated));
  const SecondOrderEstimate& pressed = choice.second_order;
  const std::optional<WeighedInSpace> weighed = weigh_in_space(project, rigid, obstacle, choice);
  if (!weighed) return choice;
  const VibrationEstimate& estimate = weighed->estimate;
  const std::string& against = weighed->against;
  const double missed = estimate.without_modes.front();
  // Elsewhere it is weighed where checks are used.
  const double of_bending = pressed.whole ? pressed.change.value_or(0.0) : 0.0;
  choice.weighed.push_back(rigid_estimate_of(rigid, pressed, missed, of_bending));
  const std::string misses = missed_text(estimate, choice);
  const ModelDemand demand = project.model.demand;
  choice.reason = fmt::format("rigid bodies{}: {}; {}",
                              demand == ModelDemand::rigid ? ", as demanded" : "", against, misses);
  if (demand == ModelDemand::rigid) return choice;
  std::string why = obstacle_to_modes_in_space(project, rigid);
  // Other modes may be recognised.
  std::string refused;
  const auto found_by = [&](const ElasticModel& model) {
    try {
      return tried.error_found(model);
    } catch (const AnalysisError& error) {
      refused = error.failure().what;
      return std::numeric_limits<double>::infinity();
    }
  };
  const auto unseen = [&](std::size_t modes) {
    const std::string periods =
        too_fast(rigid, estimate.frequencies, modes + 1, !forces_move(rigid));
    if (!periods.empty()) refused = periods;
    return !periods.empty();
  };
  // Far below the tolerance a posture's statics of the second order is not worth its cost.
  constexpr double worth_bending = 0.1;
  const bool bends_twice = of_bending > worth_bending * choice.tolerance ||
                           is_pressed_in_space(project, choice.second_order);
  const Climb climb{misses, against, found_by, unseen, {}, bends_twice};
  if (modes_are_needless(project, estimate, climb, why.empty(), refused, of_bending, choice))
    return choice;
  // A few modes do not hold what friction that turns round excites, nor how it damps it.
  if (why.empty() && demand == ModelDemand::automatic) {
    const std::string rubbing = dry_friction_in_space(rigid);
    if (!rubbing.empty())
      why = fmt::format("dry friction in joint {} turns round with the motion", rubbing);
  }
  if (why.empty()) {
    why = climb_modes(estimate, climb, choice);
    if (choice.chosen.level == ModelLevel::modal) {
      choice.counts_second_order = bends_twice;
      if (bends_twice)
        choice.reason +=
            "; what bends statically does so by the second order" + left_out_of_bending(project);
      choice.reason +=
          "; what it leaves unbalanced on the bent beam is computed in the plane only, and not "
          "known";
      return choice;
    }
    if (!refused.empty()) why = refused;
  }
  if (demand == ModelDemand::flexible) {
    throw AnalysisError(
        {fmt::format("the model that was demanded cannot be had: {}; use --model auto or --model "
                     "rigid",
                     why),
         "beam",
         {},
         {},
         {}});
  }
  why += admitted_by_more(choice, [&](std::size_t modes) {
    return too_fast(rigid, estimate.frequencies, modes + 1, !forces_move(rigid)).empty();
  });
  choice.weighed.resize(1);
  choice.reason += fmt::format("; no modes of the beam are used: {}", why);
  return choice;
}

}  // namespace boxbeam
