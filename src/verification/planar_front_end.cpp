#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "front_ends.hpp"
#include "planar_pictures.hpp"

namespace boxbeam {
namespace {

/// Where the loads on the beam come from at any time: the mechanism's reactions or the chain.
LoadsAt loads_of(const Project& project, const planar::Mechanism& mechanism,
                 const planar::Motion& motion) {
  auto finder = std::make_shared<planar::StatesAround>(mechanism, motion);
  if (project.dynamics == Dynamics::newton_chain) {
    auto distribution = mass_distribution_of(project.beam);
    return [&project, &mechanism, finder, distribution](Time time) {
      return planar::beam_loads_of(*project.chain, project.beam, distribution, mechanism.gravity,
                                   finder->at(time.value()));
    };
  }
  auto body = planar::beam_body_of(project.beam, project.beam_body);
  return staying_on(project.beam, [&mechanism, finder, body](Time time) {
    return planar::beam_loads_of(mechanism, finder->at(time.value()), body);
  });
}

/// Stops where rigid bodies do not determine what acts on the beam.
void check_unique_loads(const planar::Mechanism& mechanism, const planar::Motion& motion,
                        int beam_body) {
  std::string names;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const auto [a, b] = planar::ends_of(mechanism.joints[i]);
    const bool on_beam = a.body == beam_body || b.body == beam_body;
    const bool rubs = planar::rubs(mechanism.joints[i]);
    if (!on_beam && !rubs) continue;
    if (planar::is_unique(motion.freedom, static_cast<int>(i))) continue;
    names += (names.empty() ? "joint " : ", ") + mechanism.joints[i].name;
  }
  if (names.empty() || beam_body == planar::ground) return;
  throw AnalysisError(
      {fmt::format("the loads on the beam are not determined by rigid bodies: joints repeat each "
                   "other ({}), and how they share their load depends on their stiffness; release "
                   "one of them (a slot for a pin, a slider without its angle)",
                   fmt::join(planar::names_of_joints(mechanism, motion.freedom.repeating), ", ")),
       names});
}

DigitsLeft digits_left_over(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  const auto worst = std::min_element(
      motion.states.begin(), motion.states.end(),
      [](const planar::State& a, const planar::State& b) { return a.pivot < b.pivot; });
  return {planar::digits_left_at(planar::condition_of(mechanism, worst->q)), si<Time>(worst->time)};
}

ClosureSummary closure_of(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  ClosureSummary closure;
  closure.freedom = motion.freedom;
  closure.branch = planar::branch_of(mechanism, motion.states.front().q);
  if (motion.freedom.undriven == 0) closure.digits = digits_left_over(mechanism, motion);
  closure.change_points = motion.change_points;
  for (const planar::State& state : motion.states) {
    closure.largest_residual = std::max(closure.largest_residual, state.residual);
  }
  return closure;
}

/// Where joints and springs that bear something take hold; a force that comes from nowhere does
/// not.
std::vector<double> places_of_holds(const planar::Mechanism& mechanism, const BeamLoads& loads) {
  const auto only_acts = [&](const PointLoad& load) {
    return std::any_of(
        mechanism.forces.begin(), mechanism.forces.end(), [&](const planar::AppliedForce& force) {
          return force.name == load.name && std::holds_alternative<planar::PointForce>(force.kind);
        });
  };
  double largest = 0.0;
  for (const PointLoad& load : loads.points) largest = std::max(largest, load.force.norm());
  std::vector<double> places;
  constexpr double nothing = 1e-9;
  for (const PointLoad& load : loads.points) {
    if (load.force.norm() > nothing * largest && !only_acts(load)) places.push_back(load.s.value());
  }
  return places;
}

class PlanarMotion : public SolvedMotion {
  std::shared_ptr<const planar::Motion> solved_;

 public:
  PlanarMotion(const Project& project, const Situation& situation, const ElasticModel& model,
               const SharedMotions& shared)
      : solved_(shared.once<planar::Motion>(
            index_of(project, situation),
            [&] { return planar::solve_motion(planar_in(project, situation)); })),
        motion(*solved_),
        project_(&project),
        mechanism_(&planar_in(project, situation)),
        model_(model) {
    check_unique_loads(*mechanism_, motion, project.beam_body);
  }

  LoadHistory loads() const override {
    LoadSpan span{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(),
                  motion.closed,
                  break_times_in(planar::functions_of(*mechanism_), motion.begin, motion.period)};
    // States between instants are integrated anew, and come to it a little earlier or later.
    constexpr double aside = 2e-9;
    for (const double at : times_of(motion.slip_changes))
      for (const double side : {-aside, aside})
        span.breaks.push_back(si<Time>(at + side * motion.period));
    for (const double at : motion.changes) span.breaks.push_back(si<Time>(at));
    std::sort(span.breaks.begin(), span.breaks.end());
    return elastic_loads_of(*project_, *mechanism_, motion, model_, span,
                            loads_of(*project_, *mechanism_, motion));
  }

  double gravity() const override { return mechanism_->gravity.norm(); }

  PostureAt postures(const LoadHistory& loads) const override {
    auto finder = std::make_shared<planar::StatesAround>(*mechanism_, motion);
    return [this, &loads, finder](Time time, const std::string& why) {
      return posture_figure(*project_, *mechanism_, finder->at(time.value()), loads.loads_at(time),
                            why);
    };
  }

  std::vector<DriverLine> driver_lines(const LoadHistory&) const override {
    return driver_lines_of(*project_, *mechanism_, motion);
  }

  std::vector<double> supports(const BeamLoads& loads) const override {
    return places_of_holds(*mechanism_, loads);
  }

  MakePosture stopped(Time time, const BeamLoads& loads) const override {
    const planar::DegreesOfFreedom& freedom = motion.freedom;
    const bool holds = project_->dynamics == Dynamics::rigorous &&
                       project_->beam_body != planar::ground && freedom.undriven == 0 &&
                       freedom.redundant == 0 && obstacle_to_links(*mechanism_).empty() &&
                       !has_too_many_bodies(*mechanism_);
    if (!holds) return {};
    if (!stopped_) {
      constexpr int parts = 16;
      stopped_.emplace(Stopped{elastic_body_of(*project_, parts).with_straight_rods(),
                               planar::StatesAround(*mechanism_, motion)});
      // Nothing moves: no mass counts.
      const auto without_mass = [](ElasticBody& body) {
        for (flexible::LinkStretch& of : body.stretches) {
          of.mass = {};
          of.rotary = {};
        }
      };
      without_mass(stopped_->elastic);
      for (ElasticBody& other : stopped_->elastic.beside) without_mass(other);
    }
    // Where loads break, the history has instants that the motion has not.
    const planar::State state = stopped_->finder.at(time.value());
    MakePosture whole = [this, state, loads](double factor) {
      return loaded_posture(*mechanism_, state, stopped_->elastic, project_->beam, loads, factor);
    };
    // Where the rigid mechanism is far from a dead point the elastic one is held as well.
    constexpr double far_from_dead_point = 1e-3;
    if (state.pivot > far_from_dead_point) return whole;
    try {
      require_held(whole(0.0));
    } catch (const AnalysisError&) {
      return {};  // a dead point: the stopped mechanism is free to move there
    }
    return whole;
  }

  std::optional<ClosureSummary> closure() const override { return closure_of(*mechanism_, motion); }

  const planar::Motion& motion;

 private:
  const Project* project_;
  const planar::Mechanism* mechanism_;
  ElasticModel model_;
  /// What all postures in which it is stopped have in common, from the first of them on.
  struct Stopped {
    ElasticBody elastic;
    planar::StatesAround finder;
  };
  mutable std::optional<Stopped> stopped_;
};

/// Why an open motion that drivers fix is not held where it begins or ends; "" where it is.
std::string obstacle_to_start(const planar::Motion& motion) {
  constexpr double dead_point = 1e-6;
  if (motion.closed || motion.freedom.undriven > 0) return "";
  for (const planar::State* const state : {&motion.states.front(), &motion.end}) {
    if (state->pivot > dead_point) continue;
    return fmt::format(
        "at {:.6g} s the mechanism is at a dead point, in which its drivers do not "
        "hold it",
        state->time);
  }
  return "";
}

class PlanarFrontEnd : public FrontEnd {
 public:
  using FrontEnd::FrontEnd;

  std::unique_ptr<const SolvedMotion> solve(const Situation& situation, const ElasticModel& model,
                                            const SharedMotions& shared) const override {
    return std::make_unique<PlanarMotion>(*project_, situation, model, shared);
  }

  std::string obstacle_to_vibration(const std::deque<SituationRun>& rigid) const override {
    if (has_too_many_bodies(planar_of(*project_)))
      return fmt::format("the mechanism has more than {} bodies", most_elastic_bodies);
    if (project_->dynamics == Dynamics::newton_chain) {
      return "the Newton chain's loads are not in balance with the beam's inertia";
    }
    if (project_->beam_body == planar::ground) return "the beam is none of the mechanism's bodies";
    for (const SituationRun& run : rigid) {
      const planar::Mechanism& mechanism = planar_in(*project_, *run.situation);
      const std::string obstacle = obstacle_to_links(mechanism);
      if (!obstacle.empty()) {
        return fmt::format(
            "joint {} couples two turns by a ratio, which no joint of elastic links does",
            obstacle);
      }
      const planar::Motion& motion = planar_motion_of(run);
      const planar::DegreesOfFreedom& freedom = motion.freedom;
      for (const planar::AppliedForce& force : mechanism.forces) {
        if (std::holds_alternative<planar::PinWithClearance>(force.kind))
          return fmt::format("joint {} has a clearance, in which it is held by no mode",
                             force.name);
      }
      if (motion.closed && !motion.changes.empty()) {
        return fmt::format(
            "a stop or a cable begins or ends to act at t = {:.4g} s of a motion that repeats, and "
            "the modes of the beam change at once",
            motion.changes.front());
      }
      std::string held = obstacle_to_start(motion);
      if (!held.empty()) return held;
      if (planar::time_span_of(mechanism).steeper)
        return "the edges of a table of forces are steeper than the instants looked at";
      if (freedom.redundant > 0) {
        return fmt::format(
            "joints repeat each other ({}), and without play they leave elastic links no unique "
            "forces",
            fmt::join(planar::names_of_joints(mechanism, freedom.repeating), ", "));
      }
    }
    return "";
  }

  void require_elastic_model() const override {
    if (project_->dynamics != Dynamics::newton_chain) return;
    throw InputError("the published Newton chain is one of rigid bodies",
                     "use --model auto or --model rigid, or --dynamics rigorous");
  }

  AnyMotionResult motion(const std::vector<double>& times, const std::string& axes) const override {
    if (!axes.empty()) {
      throw InputError("the motion of a planar case is given in world axes only",
                       "leave out --axes");
    }
    return motion_of(*project_, times);
  }

  std::vector<AssemblyResult> assemblies(double time) const override {
    return assemblies_of(*project_, time);
  }
};

}  // namespace

std::unique_ptr<const FrontEnd> front_end_for(const planar::Mechanism&, const Project& project) {
  return std::make_unique<PlanarFrontEnd>(project);
}

const planar::Motion& planar_motion_of(const SituationRun& run) {
  return dynamic_cast<const PlanarMotion&>(*run.motion).motion;
}

}  // namespace boxbeam
