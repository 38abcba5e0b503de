#include "boxbeam/verification/model_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/balance_defect.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "elastic_motion_in_space.hpp"
#include "frame_vibration.hpp"
#include "modal_transient.hpp"
#include "second_order_growth.hpp"
#include "vibration_in_space.hpp"

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

/// The same of a mechanism in space.
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

/// Stresses of two histories at the even instants of the better one. A motion that ends at rest has
/// stresses behind its end by every model.
struct StressesOfBoth {
  Eigen::MatrixXd model, better;
};

StressesOfBoth stresses_of_both(const Project& project, const LoadHistory& model,
                                const LoadHistory& better) {
  const LoadSpan& span = better.span();
  const bool alike = model.span().instants == span.instants && model.period() == better.period();
  if (project.in_space)
    return {alike ? stress_history_in_space(model, project.beam)
                  : stress_history_in_space(model, project.beam, span),
            stress_history_in_space(better, project.beam)};
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  Eigen::MatrixXd of_better = stress_history(better, places);
  if (alike) return {stress_history(model, places), std::move(of_better)};
  Eigen::MatrixXd of_model(of_better.rows(), of_better.cols());
  for (Eigen::Index i = 0; i < of_model.rows(); ++i) {
    const Time time =
        span.begin + span.period * static_cast<double>(i) / static_cast<double>(span.instants);
    of_model.row(i) = fibre_stresses(model.diagram_at(time), places).transpose();
  }
  return {std::move(of_model), std::move(of_better)};
}

/// How far two histories of stresses are apart, as `difference_between`.
double difference_between(const Eigen::MatrixXd& model, const Eigen::MatrixXd& of_better) {
  const Eigen::MatrixXd difference = model - of_better;
  const double range = largest_range(of_better);
  const double apart = difference.cwiseAbs().maxCoeff() / of_better.cwiseAbs().maxCoeff();
  return range > 0.0 ? std::max(apart, largest_range(difference) / range) : apart;
}

/// Why so many modes of motions that do not repeat cannot be looked at; "" where they can.
std::string too_fast(const std::deque<SituationRun>& rigid, const std::vector<double>& frequencies,
                     std::size_t modes) {
  // Other postures and finer parts have somewhat faster modes.
  constexpr double elsewhere = 1.3;
  const double fastest = frequencies[std::min(modes, frequencies.size()) - 1];
  for (const SituationRun& run : rigid) {
    const double period = run.loads.period().value();
    constexpr double least_behind = 3.0;  // periods of the lowest mode
    const double length = period + least_behind / frequencies.front();
    if (run.loads.closed() ||
        elsewhere * instants_to_a_period * fastest * length <= most_vibrating_instants)
      continue;
    return fmt::format(
        "the motion holds {:.0f} periods of {:.4g} Hz, more than {:.0f} instants "
        "resolve; a shorter time can be looked at",
        period * fastest, fastest, most_vibrating_instants);
  }
  return "";
}

/// A modal model with another mode and twice the parts; of rigid bodies one with one mode.
ElasticModel better_than(const ElasticModel& model) {
  constexpr int parts = 8;
  return {ModelLevel::modal, model.modes + 1, std::max(parts, 2 * model.parts), {}, false};
}

bool are_same(const ElasticModel& some, const ElasticModel& other) {
  const auto& [level, modes, parts, element, axial] = some;
  return level == other.level && modes == other.modes && parts == other.parts &&
         element == other.element && axial == other.axial;
}

/// Runs a case by elastic models, and keeps those of the last one that was asked how good it is:
/// mostly it is the one chosen.
class TriedModels {
 public:
  TriedModels(const Project& project, const SharedMotions& shared)
      : project_(&project), shared_(&shared) {}

  /// Largest difference of a model from the better one.
  double error_found(const ElasticModel& model) {
    runs_.clear();
    tried_ = model;
    runs_ = run_situations(*project_, model, *shared_);
    const std::deque<SituationRun> by_better =
        run_situations(*project_, better_than(model), *shared_);
    double found = 0.0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const StressesOfBoth of = stresses_of_both(*project_, runs_[i].loads, by_better[i].loads);
      found = std::max(found, difference_between(of.model, of.better));
    }
    return found;
  }

  std::deque<SituationRun> take_runs(const ElasticModel& model) {
    if (!runs_.empty() && are_same(model, tried_)) return std::move(runs_);
    return run_situations(*project_, model, *shared_);
  }

 private:
  const Project* project_;
  const SharedMotions* shared_;
  ElasticModel tried_;
  std::deque<SituationRun> runs_;
};

/// `beside`: of the frequency, behind its number.
std::string against_frequencies(const VibrationEstimate& estimate, const std::string& beside = "") {
  std::string text = fmt::format(
      "the lowest natural frequency of the beam in its mechanism, with all masses attached, is "
      "{:.4g} Hz{}",
      estimate.frequencies.front(), beside);
  if (!estimate.harmonics.empty()) {
    const LoadHarmonic& highest = estimate.harmonics.back();
    text += fmt::format(
        ", {:.3g} times the highest harmonic with more than 1 % of its bending moment, {:.4g} Hz",
        estimate.frequencies.front() / highest.frequency, highest.frequency);
  }
  return text;
}

/// Part of the tolerance from which on an estimate is looked at: far below, it is not worth the
/// modes of every posture.
constexpr double verified_above = 0.7;

/// Bodies that bend statically under their axial force, without vibration.
constexpr ElasticModel bent{ModelLevel::quasi_static, 0, 16, {}, false};

/// Whether bodies in space are pressed so far that theory of the first order does not hold, and
/// how they bend is known. Source: EN 1993-1-1, 5.2.1(3).
bool is_pressed_in_space(const Project& project, const SecondOrderEstimate& second) {
  if (!std::holds_alternative<spatial::Mechanism>(project.mechanism) || !second.whole) return false;
  const double across = second.across ? second.across->part : 0.0;
  return second.change && std::max(second.in_plane.part, across) > first_order_below;
}

/// What the second order of beams in space has not, in words; "" where it has all.
std::string left_out_of_bending(const Project& project) {
  if (!std::holds_alternative<spatial::Mechanism>(project.mechanism)) return "";
  const auto open = [](const Section& section) {
    return std::holds_alternative<ThinWalled>(section.outer) &&
           !(enclosed_area_of(section.outer).value() > 0.0);
  };
  const bool warps =
      std::any_of(project.beam.segments.begin(), project.beam.segments.end(),
                  [&](const Segment& segment) { return open(segment.from) || open(segment.to); });
  return warps
             ? "; of open sections it has the axial force alone, not what moments do to them when "
               "they twist, which M/M_cr judges by itself"
             : "";
}

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
    if ((*second.change > choice.tolerance || is_pressed_in_space(project, second)) &&
        project.model.demand == ModelDemand::automatic) {
      choice.chosen = bent;
      choice.counts_second_order = true;
      choice.weighed.push_back({bent, "second order is in it", 0.0, {}});
      choice.reason = fmt::format("{}: {}{}", describe(bent), why, left_out_of_bending(project));
      return;
    }
  }
  choice.reason = "rigid bodies; " + why;
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

/// Of the situation in which rigid bodies miss most, or of the first whose beam has no modes; where
/// that is not `estimated`, of the one with the lowest frequency.
VibrationInSpace worst_estimate_in_space(const Project& project,
                                         const std::deque<SituationRun>& rigid, bool estimated) {
  std::optional<VibrationInSpace> worst;
  const auto rank = [&](const VibrationEstimate& of) {
    const double slow = of.frequencies.empty() ? 0.0 : 1.0 / of.frequencies.front();
    return std::pair(estimated ? of.without_modes.front() : 0.0, slow);
  };
  for (const SituationRun& run : rigid) {
    VibrationInSpace of = estimate_vibration_in_space(project, run);
    if (!of.obstacle.empty()) return of;
    if (!worst || rank(of.estimate) > rank(worst->estimate)) worst = std::move(of);
  }
  return *worst;
}

bool forces_move(const std::deque<SituationRun>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const SituationRun& run) {
    const std::vector<spatial::Joint>& joints = chain_of(run).mechanism().joints;
    return std::any_of(joints.begin(), joints.end(), spatial::is_forced);
  });
}

/// What a climb to ever more modes asks and says.
struct Climb {
  std::string missed;   ///< by rigid bodies, in words
  std::string against;  ///< `against_frequencies`
  /// Error of a model against a better one.
  std::function<double(const ElasticModel&)> found_by;
  /// Says of so many modes why they cannot be looked at; of those that can it is false.
  std::function<bool(std::size_t)> unseen = {};
};

/// Sets the first modes that are known to be within the tolerance; else why none are, "" where that
/// is said already.
std::string climb_modes(const VibrationEstimate& estimate, const Climb& climb,
                        ModelChoice& choice) {
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k) {
    ModelEstimate& by_modes = choice.weighed.emplace_back();
    by_modes.model = {ModelLevel::modal, static_cast<int>(k), 8, {}, false};
    by_modes.error = estimate.without_modes[k];
    by_modes.basis =
        fmt::format("modes left out, and {} that the beam's rotation couples with its vibration",
                    percent_text(estimate.left_out));
    if (by_modes.error > choice.tolerance) continue;
    if (climb.unseen && climb.unseen(k)) return "";
    by_modes.found = climb.found_by(by_modes.model) + estimate.left_out;
    if (*by_modes.found > choice.tolerance) continue;
    choice.chosen = by_modes.model;
    choice.reason = fmt::format(
        "{}: {}; rigid bodies: {}; {} estimated to miss {}, found {} against one mode "
        "more and twice the parts",
        describe(choice.chosen), climb.against, climb.missed,
        k == 1 ? "this mode is" : "these modes are", percent_text(by_modes.error),
        percent_text(*by_modes.found));
    return "";
  }
  return estimate.left_out > choice.tolerance
             ? fmt::format(
                   "what the beam's rotation couples with its vibration, of the order of {}, "
                   "is in none of them and is the least error that can be asked for",
                   percent_text(estimate.left_out))
             : fmt::format("{} modes of the beam are not known to be within {} either",
                           estimate.without_modes.size() - 1, percent_text(choice.tolerance));
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

bool has_springs(const std::deque<SituationRun>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const SituationRun& run) {
    const spatial::Mechanism& mechanism = chain_of(run).mechanism();
    return !mechanism.springs.empty() || !mechanism.torsion_springs.empty();
  });
}

/// Climbs from rigid bodies to ever more modes; where none are known to be within the tolerance,
/// rigid bodies with what they are estimated to miss, unless elastic ones were demanded.
ModelChoice choose_in_space(const Project& project, const std::deque<SituationRun>& rigid,
                            const std::string& obstacle, TriedModels& tried,
                            SecondOrderEstimate estimated) {
  ModelChoice choice;
  choice.bends_rigid_motion = true;
  choice.tolerance = project.model.tolerance;
  choice.second_order = std::move(estimated);
  const SecondOrderEstimate& second = choice.second_order;
  if (forces_move(rigid) || second.in_plane.part >= 1.0) {
    choose_unvibrated(project, obstacle.empty() ? "the beam buckles" : obstacle, choice);
    return choice;
  }
  const VibrationInSpace found = worst_estimate_in_space(project, rigid, obstacle.empty());
  if (!found.obstacle.empty()) {
    choose_unvibrated(project, found.obstacle, choice);
    return choice;
  }
  VibrationEstimate estimate = found.estimate;
  if (estimate.frequencies.empty()) {
    choice.reason = "rigid bodies: no load and no mass is there that could make the beam vibrate";
    return choice;
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
    return choice;
  }
  const double missed = estimate.without_modes.front();
  // Elsewhere it is weighed where checks are used.
  const double of_bending = second.whole ? second.change.value_or(0.0) : 0.0;
  const bool repeats = std::all_of(rigid.begin(), rigid.end(),
                                   [](const SituationRun& run) { return run.loads.closed(); });
  choice.weighed.push_back(
      {{},
       fmt::format("{} the modes of the mechanism stopped in postures over its motion {}{}",
                   repeats ? "harmonics of the loads against" : "response over time of",
                   percent_text(missed),
                   second.whole ? ", second order " + percent_text(of_bending) : std::string()),
       missed + of_bending,
       {}});
  const std::string misses =
      fmt::format("vibration is estimated to change the governing stress by {}, {}; tolerance {}",
                  percent_text(missed), second_order_text(second), percent_text(choice.tolerance));
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
    const std::string periods = too_fast(rigid, estimate.frequencies, modes + 1);
    if (!periods.empty()) refused = periods;
    return !periods.empty();
  };
  if (missed <= choice.tolerance && demand == ModelDemand::automatic) {
    bool enough = true;
    std::string found_once;
    if (missed > verified_above * choice.tolerance && why.empty() && !unseen(0)) {
      const double against_mode = found_by({}) + estimate.left_out;
      if (refused.empty()) {
        choice.weighed.back().found = against_mode;
        found_once =
            fmt::format(", found {} against one mode in every posture", percent_text(against_mode));
        choice.reason += found_once;
        enough = against_mode <= choice.tolerance;
      }
    }
    if (enough && !(missed + of_bending > choice.tolerance || is_pressed_in_space(project, second)))
      return choice;
    if (enough) {
      choice.chosen = bent;
      choice.counts_second_order = true;
      choice.weighed.push_back({bent, "vibration left out", missed, {}});
      choice.reason = fmt::format("{}: {}; rigid bodies: {}{}{}", describe(bent), against, misses,
                                  found_once, left_out_of_bending(project));
      return choice;
    }
  }
  // A few modes do not hold what friction that turns round excites, nor how it damps it.
  if (why.empty() && demand == ModelDemand::automatic) {
    const std::string rubbing = dry_friction_in_space(rigid);
    if (!rubbing.empty())
      why = fmt::format("dry friction in joint {} turns round with the motion", rubbing);
  }
  if (why.empty()) {
    why = climb_modes(estimate, {misses, against, found_by, unseen}, choice);
    if (choice.chosen.level == ModelLevel::modal) {
      choice.reason +=
          "; what it leaves unbalanced on the bent beam is computed in the plane only, and not "
          "known";
      if (has_springs(rigid))
        choice.reason += ", nor is what springs take over when the beam bends";
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
  choice.weighed.resize(1);
  choice.reason += fmt::format("; no modes of the beam are used: {}", why);
  return choice;
}

/// Climbs from rigid bodies to bent ones and to ever more modes.
ModelChoice choose_by_estimate(const Project& project, const std::deque<SituationRun>& rigid,
                               const std::string& obstacle, TriedModels& tried,
                               SecondOrderEstimate estimated) {
  ModelChoice choice;
  choice.bends_rigid_motion = true;
  choice.tolerance = project.model.tolerance;
  choice.second_order = std::move(estimated);
  const SecondOrderEstimate& second = choice.second_order;
  if (!obstacle.empty()) {
    choose_unvibrated(project, obstacle, choice);
    return choice;
  }
  if (second.in_plane.part >= 1.0) {
    choice.reason = "rigid bodies: " + second_order_text(second);
    return choice;
  }
  const std::string pressed = rod_beyond_euler(project, rigid);
  if (!pressed.empty()) {
    choose_unvibrated(
        project, fmt::format("body {}, a rod, buckles by itself in the plane of motion", pressed),
        choice);
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
  const bool repeats = std::all_of(rigid.begin(), rigid.end(), [](const SituationRun& run) {
    return planar_motion_of(run).closed;
  });
  const ModelEstimate by_rigid{
      {},
      fmt::format("{} {}, second order {}",
                  repeats ? "harmonics of the loads against the modes of six postures"
                          : "response of the modes of six postures over time",
                  percent_text(estimate.without_modes.front()), percent_text(of_bending)),
      estimate.without_modes.front() + of_bending,
      {}};
  choice.weighed.push_back(by_rigid);
  const std::string missed =
      fmt::format("vibration is estimated to change the governing stress by {}, {}; tolerance {}",
                  percent_text(estimate.without_modes.front()), second_order_text(second),
                  percent_text(choice.tolerance));
  const std::string against = against_frequencies(estimate, elastic_beside_text(project));
  const auto unseen = [&](std::size_t modes) {
    const std::string why = too_fast(rigid, estimate.frequencies, modes + 1);
    if (!why.empty())
      choice.reason = fmt::format("rigid bodies; what vibration adds is not known: {}; {}; {}", why,
                                  missed, against);
    return !why.empty();
  };
  bool enough = by_rigid.error <= choice.tolerance;
  std::string found;
  if (enough && by_rigid.error > verified_above * choice.tolerance &&
      project.model.demand == ModelDemand::automatic && !unseen(0)) {
    const double against_mode = tried.error_found({}) + estimate.left_out;
    choice.weighed.back().found = against_mode;
    found = fmt::format(", found {} against one mode in every posture", percent_text(against_mode));
    enough = against_mode <= choice.tolerance;
  }
  if (project.model.demand == ModelDemand::rigid ||
      (enough && project.model.demand == ModelDemand::automatic)) {
    choice.reason = fmt::format("rigid bodies{}: {}; {}{}",
                                project.model.demand == ModelDemand::rigid ? ", as demanded" : "",
                                against, missed, found);
    return choice;
  }
  if (project.model.demand == ModelDemand::automatic) {
    ModelEstimate& by_bending = choice.weighed.emplace_back();
    by_bending.model = bent;
    by_bending.error = estimate.without_modes.front();
    by_bending.basis = "vibration left out";
    if (by_bending.error <= choice.tolerance) {
      if (by_bending.error > verified_above * choice.tolerance && !unseen(0)) {
        by_bending.found = tried.error_found(bent) + estimate.left_out;
      }
      if (by_bending.found.value_or(0.0) <= choice.tolerance) {
        choice.chosen = bent;
        choice.counts_second_order = true;
        choice.reason = fmt::format("{}: {}; rigid bodies: {}", describe(bent), against, missed);
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
        rubbing, missed, against);
    return choice;
  }
  const auto passes_unseen = [&](std::size_t modes) {
    return project.model.demand == ModelDemand::automatic && unseen(modes);
  };
  const std::string why = climb_modes(
      estimate,
      {missed, against, [&](const ElasticModel& model) { return tried.error_found(model); },
       passes_unseen},
      choice);
  if (why.empty() && choice.chosen.level != ModelLevel::modal) return choice;
  if (choice.chosen.level == ModelLevel::modal) {
    choice.counts_second_order = true;
    return choice;
  }
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

/// Rigid bodies for loads that were measured; else what the estimate says, and where it says that
/// the beam vibrates under loads from a table, that they may have been measured.
ModelChoice choose_for_rigid(const Project& project, const std::deque<SituationRun>& rigid,
                             const std::string& obstacle, TriedModels& tried) {
  if (project.model.measured_loads && project.model.demand != ModelDemand::flexible) {
    ModelChoice choice;
    choice.bends_rigid_motion = true;
    choice.tolerance = project.model.tolerance;
    DesignedSecondOrder second = estimate_designed_second_order(project, rigid);
    choice.second_order = std::move(second.estimate);
    choose_unvibrated(project, "the loads are measured, they contain the vibration", choice, "");
    if (choice.counts_second_order) choice.second_order.growth = std::move(second.beyond_once);
    return choice;
  }
  DesignedSecondOrder second = estimate_designed_second_order(project, rigid);
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism)) {
    ModelChoice choice =
        choose_in_space(project, rigid, obstacle, tried, std::move(second.estimate));
    if (choice.counts_second_order) choice.second_order.growth = std::move(second.beyond_once);
    return choice;
  }
  ModelChoice choice =
      choose_by_estimate(project, rigid, obstacle, tried, std::move(second.estimate));
  if (choice.counts_second_order) {
    // What its cut forces hold is the second order of the loads times one.
    choice.second_order.growth = std::move(second.beyond_once);
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

/// States what the chosen model's loads leave unbalanced when the beam bends as far as it does.
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

/// Whether a frame at rest vibrates under loads over time by more than is tolerated, and if so the
/// first modes that are known to hold what does; loads act slowly where none are.
void choose_for_frame(const Project& project, TriedModels& tried, ModelChoice& choice,
                      std::deque<SituationRun>& runs) {
  FrameVibration worst;
  for (const SituationRun& run : runs) {
    FrameVibration of = estimate_vibration_of_frame(project, run);
    if (!of.obstacle.empty()) {
      choice.reason += "; loads act slowly: what vibration adds is not estimated: " + of.obstacle;
      return;
    }
    if (of.estimate.frequencies.empty()) continue;
    if (worst.estimate.frequencies.empty() ||
        of.estimate.without_modes.front() > worst.estimate.without_modes.front())
      worst = std::move(of);
  }
  const VibrationEstimate& estimate = worst.estimate;
  if (estimate.frequencies.empty()) return;
  const double missed = estimate.without_modes.front();
  choice.frequencies = estimate.frequencies;
  choice.harmonics = estimate.harmonics;
  choice.weighed.push_back(
      {choice.chosen,
       fmt::format("response over time of the frame's modes {}", percent_text(missed)),
       missed,
       {}});
  const ModelDemand demand = project.model.demand;
  choice.reason += fmt::format(
      "; the lowest natural frequency of the frame is {:.4g} Hz ({}), vibration is estimated to "
      "change the governing stress by {}, tolerance {}",
      estimate.frequencies.front(), worst.shape, percent_text(missed),
      percent_text(choice.tolerance));
  if (project.model.measured_loads || demand == ModelDemand::rigid ||
      (demand == ModelDemand::automatic && missed <= choice.tolerance)) {
    choice.reason += ": loads act slowly";
    return;
  }
  std::string why = fmt::format("{} modes are not known to be within {} either",
                                estimate.frequencies.size(), percent_text(choice.tolerance));
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k) {
    const ElasticModel model{ModelLevel::modal, static_cast<int>(k), 8, {}, false};
    if (estimate.without_modes[k] > choice.tolerance) continue;
    why = too_fast(runs, estimate.frequencies, k + 1);
    if (!why.empty()) break;
    try {
      const double found = tried.error_found(model);
      if (found > choice.tolerance) continue;
      choice.weighed.push_back({model, "modes left out", estimate.without_modes[k], found});
      choice.chosen = model;
      choice.reason += fmt::format(
          "; loads over time by {}, found {} against one mode more and "
          "twice the parts; reactions of supports are those of statics",
          describe(model), percent_text(found));
      runs = tried.take_runs(model);
      return;
    } catch (const AnalysisError& error) {
      why = error.failure().what;
    }
  }
  choice.reason += "; loads act slowly, no modes are used: " + why;
}

}  // namespace

ModelledRuns run_by_chosen_model(const Project& project, const SharedMotions& shared) {
  const std::unique_ptr<const FrontEnd> front_end = front_end_of(project);
  TriedModels tried(project, shared);
  if (std::optional<ModelChoice> own = front_end->own_model()) {
    std::deque<SituationRun> runs = run_situations(project, own->chosen, shared);
    own->second_order = estimate_second_order(project, runs);
    own->reason += "; " + second_order_text(own->second_order);
    if (has_loads_over_time(project)) choose_for_frame(project, tried, *own, runs);
    return {std::move(*own), std::move(runs)};
  }
  std::deque<SituationRun> rigid = run_situations(project, {}, shared);
  const std::string obstacle = front_end->obstacle_to_vibration(rigid);
  ModelChoice model = choose_for_rigid(project, rigid, obstacle, tried);
  if (model.chosen.level == ModelLevel::rigid) return {std::move(model), std::move(rigid)};
  std::deque<SituationRun> runs = tried.take_runs(model.chosen);
  const bool in_plane = std::holds_alternative<planar::Mechanism>(project.mechanism);
  if (obstacle.empty() && in_plane) weigh_balance(project, rigid, runs, model);
  return {std::move(model), std::move(runs)};
}

ModelChoice choose_model(const Project& project) { return run_by_chosen_model(project, {}).model; }

}  // namespace boxbeam
