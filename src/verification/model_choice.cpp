#include "boxbeam/verification/model_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/verification/balance_defect.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"

namespace boxbeam {
namespace {

LadderCase ladder_case(const Project& project, const Situation& situation) {
  return {&flexible_in(project, situation), project.beam_body, &project.beam};
}

bool runs(const Situation& situation) { return situation.between.empty(); }

/// A model that the user demands, with the error that it is found to have.
ModelChoice demanded(const Project& project, const ElasticModel& model) {
  ModelChoice choice;
  choice.chosen = model;
  choice.tolerance = project.model.tolerance;
  ModelEstimate& estimate = choice.weighed.emplace_back();
  estimate.model = model;
  estimate.basis = "as demanded";
  for (const Situation& situation : project.situations) {
    if (!runs(situation)) continue;
    const LadderCase of = ladder_case(project, situation);
    estimate.error = std::max(estimate.error, error_of(of, model));
    choice.harmonics = {{of.mechanism->frequency, 1.0}};
  }
  estimate.found = estimate.error;
  choice.reason = fmt::format(
      "{}, as demanded: found {} from all elements of a finer division with all elasticity, "
      "where {} would be the tolerance",
      describe(model), percent_text(estimate.error), percent_text(choice.tolerance));
  return choice;
}

/// What either of two models counts.
ElasticModel both(const ElasticModel& a, const ElasticModel& b) {
  ElasticModel most;
  most.level = std::max(a.level, b.level);
  most.modes = most.level == ModelLevel::modal ? std::max(a.modes, b.modes) : 0;
  most.parts = std::max(a.parts, b.parts);
  most.element = a.element ? a.element : b.element;
  most.axial = a.axial || b.axial;
  return most;
}

/// One model for situations that each ask for their own: what any of them counts. Where that is
/// not good enough for all, whose errors may cancel, all elements of the finer division that each
/// was verified against.
ModelChoice for_all(const Project& project, const std::vector<ModelChoice>& choices,
                    const std::vector<const Situation*>& of) {
  const auto cost = [](const ElasticModel& model) {
    return std::tuple(model.level, model.modes, model.parts, model.axial);
  };
  const auto costliest = std::max_element(
      choices.begin(), choices.end(),
      [&](const ModelChoice& a, const ModelChoice& b) { return cost(a.chosen) < cost(b.chosen); });
  ModelChoice choice = *costliest;
  choice.harmonics.clear();
  for (const ModelChoice& one : choices) {
    choice.chosen = both(choice.chosen, one.chosen);
    for (const LoadHarmonic& harmonic : one.harmonics) {
      const bool known =
          std::any_of(choice.harmonics.begin(), choice.harmonics.end(),
                      [&](const auto& other) { return other.frequency == harmonic.frequency; });
      if (!known) choice.harmonics.push_back(harmonic);
    }
  }
  const std::string& asking = of[static_cast<std::size_t>(costliest - choices.begin())]->name;
  choice.reason = fmt::format("situation \"{}\" asks for most: {}", asking, costliest->reason);
  const bool same = std::all_of(choices.begin(), choices.end(), [&](const ModelChoice& one) {
    return cost(one.chosen) == cost(choice.chosen);
  });
  if (same) return choice;
  const auto largest_error = [&] {
    double error = 0.0;
    for (const Situation* situation : of) {
      error = std::max(error, error_of(ladder_case(project, *situation), choice.chosen));
    }
    return error;
  };
  double found = largest_error();
  if (found > choice.tolerance) {
    constexpr int fewest = 32;
    const int parts = std::max(fewest, 2 * choice.chosen.parts);
    choice.chosen = {ModelLevel::flexible, 0, parts, flexible::Element::corrected, true};
    found = largest_error();
  }
  choice.weighed.push_back({choice.chosen, "the most that any situation asks for", found, found});
  choice.reason += fmt::format("; all situations together: {}, found {} at most",
                               describe(choice.chosen), percent_text(found));
  return choice;
}

ModelChoice choose_elastic(const Project& project) {
  if (project.model.demand == ModelDemand::rigid) return demanded(project, {});
  if (project.model.demand == ModelDemand::flexible) {
    return demanded(project, {ModelLevel::flexible, 0, 0, {}, false});
  }
  std::vector<ModelChoice> choices;
  std::vector<const Situation*> of;
  for (const Situation& situation : project.situations) {
    if (!runs(situation)) continue;
    choices.push_back(climb_ladder(ladder_case(project, situation), project.model.tolerance));
    of.push_back(&situation);
  }
  if (choices.size() == 1) return choices.front();
  return for_all(project, choices, of);
}

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

/// Why the vibration of the beam is not estimated; "" where it is.
std::string not_estimated(const Project& project, const std::deque<SituationRun>& rigid) {
  if (in_space(project)) return "elastic links are counted in the plane only";
  if (project.dynamics == Dynamics::newton_chain) {
    return "the Newton chain's loads are not in balance with the beam's inertia";
  }
  if (project.beam_body == planar::ground) return "the beam is none of the mechanism's bodies";
  for (const SituationRun& run : rigid) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    const std::string obstacle = obstacle_to_links(mechanism);
    if (!obstacle.empty()) {
      return fmt::format(
          "joint {} couples two turns by a ratio, which no joint of elastic links does", obstacle);
    }
    const planar::DegreesOfFreedom& freedom = planar_motion_of(run).freedom;
    if (freedom.undriven > 0) {
      return "forces decide the motion: with its drivers held the mechanism is free to move";
    }
    if (!planar_motion_of(run).closed) return "the motion does not repeat";
    if (freedom.redundant > 0) {
      return fmt::format(
          "joints repeat each other ({}), and without play they leave elastic links no unique "
          "forces",
          fmt::join(planar::names_of_joints(mechanism, freedom.repeating), ", "));
    }
  }
  return "";
}

RigidMotion rigid_motion_of(const Project& project, const SituationRun& run) {
  return {&planar_in(project, *run.situation), &planar_motion_of(run), &project.beam,
          [&run](Time time) { return run.loads.loads_at(time); }};
}

/// The estimate of the situation in which rigid bodies miss most.
VibrationEstimate worst_estimate(const Project& project, const std::deque<SituationRun>& rigid) {
  const ElasticBody elastic = elastic_body_of(project, 8);
  VibrationEstimate worst;
  for (const SituationRun& run : rigid) {
    VibrationEstimate estimate =
        estimate_vibration(rigid_motion_of(project, run), elastic, run.loads);
    if (worst.without_modes.empty() ||
        estimate.without_modes.front() > worst.without_modes.front()) {
      worst = std::move(estimate);
    }
  }
  return worst;
}

/// How far the stresses of two histories are apart, as `difference_between`.
double difference_between(const LoadHistory& model, const LoadHistory& better,
                          const std::vector<ComparedPlace>& places) {
  const Eigen::MatrixXd of_better = stress_history(better, places);
  const Eigen::MatrixXd difference = stress_history(model, places) - of_better;
  const double range = largest_range(of_better);
  const double apart = difference.cwiseAbs().maxCoeff() / of_better.cwiseAbs().maxCoeff();
  return range > 0.0 ? std::max(apart, largest_range(difference) / range) : apart;
}

/// A modal model with another mode and twice the parts; of rigid bodies one with one mode.
ElasticModel better_than(const ElasticModel& model) {
  constexpr int parts = 8;
  return {ModelLevel::modal, model.modes + 1, std::max(parts, 2 * model.parts), {}, false};
}

/// Largest difference of a model from the better one.
double error_found(const Project& project, const ElasticModel& model) {
  const ElasticModel better = better_than(model);
  const std::deque<SituationRun> by_model = run_situations(project, model);
  const std::deque<SituationRun> by_better = run_situations(project, better);
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  double found = 0.0;
  for (std::size_t i = 0; i < by_model.size(); ++i) {
    found = std::max(found, difference_between(by_model[i].loads, by_better[i].loads, places));
  }
  return found;
}

std::string against_frequencies(const VibrationEstimate& estimate) {
  std::string text = fmt::format(
      "the lowest natural frequency of the beam in its mechanism, with all masses attached, is "
      "{:.4g} Hz",
      estimate.frequencies.front());
  if (!estimate.harmonics.empty()) {
    const LoadHarmonic& highest = estimate.harmonics.back();
    text += fmt::format(
        ", {:.3g} times the highest harmonic with more than 1 % of its bending moment, {:.4g} Hz",
        estimate.frequencies.front() / highest.frequency, highest.frequency);
  }
  return text;
}

/// "second order changes it by 0.3 %, N/N_cr = 0.012 at most in the plane, 0.004 across it".
std::string second_order_text(const SecondOrderEstimate& of) {
  if (of.in_plane.part == 0.0 && of.change.value_or(0.0) == 0.0) {
    return "second order changes nothing, for the beam bears no axial force";
  }
  std::string text = of.change ? fmt::format("second order is estimated to change it by {}",
                                             percent_text(*of.change))
                               : std::string("the beam buckles");
  if (of.in_plane.part > 0.0) {
    text += fmt::format(", N/N_cr = {:.3g} at most in the plane", of.in_plane.part);
  }
  if (of.across && of.across->part > 0.0)
    text += fmt::format(", {:.3g} across it", of.across->part);
  return text;
}

/// Bodies that bend statically under their axial force, without vibration.
constexpr ElasticModel bent{ModelLevel::quasi_static, 0, 16, {}, false};

/// Where vibration is not estimated: rigid bodies, or bent ones where second order asks for them.
void choose_unvibrated(const Project& project, const std::string& obstacle, ModelChoice& choice,
                       const std::string& known = "what vibration adds is not estimated: ") {
  if (project.model.demand == ModelDemand::flexible) {
    throw AnalysisError({fmt::format("the model that was demanded cannot be had, for the beam's "
                                     "vibration is not computed here: {}; use --model auto or "
                                     "--model rigid",
                                     obstacle),
                         "beam",
                         {},
                         {},
                         {}});
  }
  const SecondOrderEstimate& second = choice.second_order;
  const std::string why = fmt::format("{}{}; {}", known, obstacle, second_order_text(second));
  if (second.whole && second.change) {
    choice.weighed.push_back({{}, "second order alone", *second.change, {}});
    if (*second.change > choice.tolerance && project.model.demand == ModelDemand::automatic) {
      choice.chosen = bent;
      choice.counts_second_order = true;
      choice.weighed.push_back({bent, "second order is in it", 0.0, {}});
      choice.reason = fmt::format("{}: {}", describe(bent), why);
      return;
    }
  }
  choice.reason = "rigid bodies; " + why;
}

/// Names of the forces that follow a table, "wind, pull"; "" where none does.
std::string tabled_forces_in(const Project& project) {
  std::vector<std::string> names;
  const auto look = [&](const planar::Mechanism& mechanism) {
    for (const planar::AppliedForce& force : mechanism.forces) {
      const auto* push = std::get_if<planar::PointForce>(&force.kind);
      const auto* couple = std::get_if<planar::Couple>(&force.kind);
      const Driver* size = push != nullptr     ? &push->size
                           : couple != nullptr ? &couple->size
                                               : nullptr;
      if (size == nullptr || !std::holds_alternative<TableDriver>(*size)) continue;
      if (std::find(names.begin(), names.end(), force.name) == names.end()) {
        names.push_back(force.name);
      }
    }
  };
  for (const Situation& situation : project.situations) {
    if (runs(situation)) look(planar_in(project, situation));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Climbs from rigid bodies to bent ones and to ever more modes.
ModelChoice choose_by_estimate(const Project& project, const std::deque<SituationRun>& rigid) {
  ModelChoice choice;
  choice.tolerance = project.model.tolerance;
  choice.second_order = estimate_second_order(project, rigid);
  const SecondOrderEstimate& second = choice.second_order;
  const std::string obstacle = not_estimated(project, rigid);
  if (!obstacle.empty()) {
    choose_unvibrated(project, obstacle, choice);
    return choice;
  }
  if (second.in_plane.part >= 1.0) {
    choice.reason = "rigid bodies: " + second_order_text(second);
    return choice;
  }
  const VibrationEstimate estimate = worst_estimate(project, rigid);
  if (estimate.frequencies.empty()) {
    choice.reason = "rigid bodies: no load and no mass is there that could make the beam vibrate";
    return choice;
  }
  choice.frequencies = estimate.frequencies;
  choice.harmonics = estimate.harmonics;
  const double of_bending = second.change.value_or(0.0);
  const ModelEstimate by_rigid{
      {},
      fmt::format("harmonics of the loads against the modes of six postures {}, second order {}",
                  percent_text(estimate.without_modes.front()), percent_text(of_bending)),
      estimate.without_modes.front() + of_bending,
      {}};
  choice.weighed.push_back(by_rigid);
  const std::string missed =
      fmt::format("vibration is estimated to change the governing stress by {}, {}; tolerance {}",
                  percent_text(estimate.without_modes.front()), second_order_text(second),
                  percent_text(choice.tolerance));
  bool enough = by_rigid.error <= choice.tolerance;
  // An estimate far below the tolerance is not worth the modes of every posture.
  constexpr double verified_above = 0.7;
  std::string found;
  if (enough && by_rigid.error > verified_above * choice.tolerance &&
      project.model.demand == ModelDemand::automatic) {
    const double against_mode = error_found(project, {}) + estimate.left_out;
    choice.weighed.back().found = against_mode;
    found = fmt::format(", found {} against one mode in every posture", percent_text(against_mode));
    enough = against_mode <= choice.tolerance;
  }
  if (project.model.demand == ModelDemand::rigid ||
      (enough && project.model.demand == ModelDemand::automatic)) {
    choice.reason = fmt::format("rigid bodies{}: {}; {}{}",
                                project.model.demand == ModelDemand::rigid ? ", as demanded" : "",
                                against_frequencies(estimate), missed, found);
    return choice;
  }
  if (project.model.demand == ModelDemand::automatic) {
    ModelEstimate& by_bending = choice.weighed.emplace_back();
    by_bending.model = bent;
    by_bending.error = estimate.without_modes.front();
    by_bending.basis = "vibration left out";
    if (by_bending.error <= choice.tolerance) {
      if (by_bending.error > verified_above * choice.tolerance) {
        by_bending.found = error_found(project, bent) + estimate.left_out;
      }
      if (by_bending.found.value_or(0.0) <= choice.tolerance) {
        choice.chosen = bent;
        choice.counts_second_order = true;
        choice.reason = fmt::format("{}: {}; rigid bodies: {}", describe(bent),
                                    against_frequencies(estimate), missed);
        return choice;
      }
    }
  }
  // A few modes do not hold what friction that turns round excites, nor how it damps it.
  const std::string rubbing = dry_friction_in(project, rigid);
  if (!rubbing.empty() && project.model.demand == ModelDemand::automatic) {
    choice.reason = fmt::format(
        "rigid bodies; what vibration adds is not known: dry friction in joint {} turns round "
        "with the motion, and without damping {}; {}",
        rubbing, missed, against_frequencies(estimate));
    return choice;
  }
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k) {
    ModelEstimate& by_modes = choice.weighed.emplace_back();
    by_modes.model = {ModelLevel::modal, static_cast<int>(k), 8, {}, false};
    by_modes.error = estimate.without_modes[k];
    by_modes.basis =
        fmt::format("modes left out, and {} that the beam's rotation couples with its vibration",
                    percent_text(estimate.left_out));
    if (by_modes.error > choice.tolerance) continue;
    by_modes.found = error_found(project, by_modes.model) + estimate.left_out;
    if (*by_modes.found > choice.tolerance) continue;
    choice.chosen = by_modes.model;
    choice.counts_second_order = true;
    choice.reason = fmt::format(
        "{}: {}; rigid bodies: {}; {} estimated to miss {}, found {} against one mode "
        "more and twice the parts",
        describe(choice.chosen), against_frequencies(estimate), missed,
        k == 1 ? "this mode is" : "these modes are", percent_text(by_modes.error),
        percent_text(*by_modes.found));
    return choice;
  }
  const std::string why =
      estimate.left_out > choice.tolerance
          ? fmt::format(
                "what the beam's rotation couples with its vibration, of the order of {}, "
                "is in none of them and is the least error that can be asked for",
                percent_text(estimate.left_out))
          : fmt::format("{} modes of the beam are not known to be within {} either",
                        estimate.without_modes.size() - 1, percent_text(choice.tolerance));
  throw AnalysisError(
      {fmt::format("rigid bodies miss an estimated {} of the governing stress, and {}; ask for a "
                   "larger tolerance, or use --model rigid to have the loads of rigid bodies",
                   percent_text(by_rigid.error), why),
       "beam",
       {},
       choice.weighed.back().found.value_or(choice.weighed.back().error),
       {}});
}

}  // namespace

const char* to_text(ModelLevel level) {
  switch (level) {
    case ModelLevel::rigid: return "rigid";
    case ModelLevel::quasi_static: return "quasi-static";
    case ModelLevel::modal: return "modal";
    case ModelLevel::flexible: return "flexible";
  }
  return "";
}

bool knows_second_order(const ModelChoice& model) {
  const SecondOrderEstimate& of = model.second_order;
  return model.counts_second_order || (of.whole && of.change && *of.change <= model.tolerance);
}

namespace {

/// Rigid bodies for loads that were measured; else what the estimate says, and where it says that
/// the beam vibrates under loads from a table, that they may have been measured.
ModelChoice choose_planar(const Project& project, const std::deque<SituationRun>& rigid) {
  if (project.model.measured_loads && project.model.demand != ModelDemand::flexible) {
    ModelChoice choice;
    choice.tolerance = project.model.tolerance;
    choice.second_order = estimate_second_order(project, rigid);
    choose_unvibrated(project, "the loads are measured, they contain the vibration", choice, "");
    return choice;
  }
  ModelChoice choice = choose_by_estimate(project, rigid);
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

/// States what the chosen model's loads leave unbalanced when the beam bends as far as it does.
void weigh_balance(const Project& project, const std::deque<SituationRun>& rigid,
                   const std::deque<SituationRun>& by_model, ModelChoice& choice) {
  if (choice.weighed.empty() || !not_estimated(project, rigid).empty()) return;
  const ElasticBody elastic = elastic_body_of(project, 8);
  double unbalanced = 0.0;
  for (std::size_t i = 0; i < rigid.size(); ++i) {
    // Series of Fourier have no second derivative where something jumps or bends.
    const std::string obstacle =
        by_model[i].loads.span().breaks.empty()
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

}  // namespace

ModelledRuns run_by_chosen_model(const Project& project) {
  if (is_flexible(project)) {
    ModelChoice model = choose_elastic(project);
    std::deque<SituationRun> runs = run_situations(project, model.chosen);
    model.second_order = estimate_second_order(project, runs);
    return {std::move(model), std::move(runs)};
  }
  std::deque<SituationRun> rigid = run_situations(project);
  ModelChoice model = choose_planar(project, rigid);
  if (model.chosen.level == ModelLevel::rigid) return {std::move(model), std::move(rigid)};
  std::deque<SituationRun> runs = run_situations(project, model.chosen);
  weigh_balance(project, rigid, runs, model);
  return {std::move(model), std::move(runs)};
}

ModelChoice choose_model(const Project& project) {
  if (is_flexible(project)) return choose_elastic(project);
  return choose_planar(project, run_situations(project));
}

}  // namespace boxbeam
