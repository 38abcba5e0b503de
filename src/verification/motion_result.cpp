#include "boxbeam/verification/motion_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/newton_chain.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam {
namespace {

using Branch = std::vector<std::pair<std::string, int>>;

Branch named_branch_of(const planar::Mechanism& mechanism, const Eigen::VectorXd& q) {
  Branch branch;
  const std::vector<int> signs = planar::branch_of(mechanism, q);
  for (std::size_t i = 0; i < signs.size(); ++i) {
    branch.emplace_back(mechanism.loops[i].name, signs[i]);
  }
  return branch;
}

ChainResult chain_result_of(const planar::Mechanism& mechanism, const planar::NewtonChain& chain,
                            const planar::State& state) {
  const planar::ChainForces forces = planar::chain_at(chain, state);
  const auto moments = planar::chain_moments_at(mechanism, chain, state);
  ChainResult result;
  result.sought_mass = forces.sought_mass;
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    result.steps.push_back({chain.steps[i].name, forces.g[i], moments[i]});
  }
  return result;
}

InstantResult instant_of(const Project& project, const planar::State& state,
                         const planar::DegreesOfFreedom& freedom) {
  const planar::Mechanism& mechanism = planar_of(project);
  InstantResult result;
  result.time = state.time;
  result.residual = state.residual;
  result.condition = planar::condition_of(mechanism, state.q);
  result.digits = planar::digits_left_at(result.condition);
  result.branch = named_branch_of(mechanism, state.q);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const auto k = static_cast<Eigen::Index>(3 * i);
    result.bodies.push_back(
        {body.name, state.q.segment<3>(k), state.v.segment<3>(k), state.a.segment<3>(k)});
    for (const BodyPoint& point : body.points) {
      const planar::Attachment at{static_cast<int>(i), point.p};
      result.points.push_back({body.name + "." + point.name, planar::position_of(at, state.q),
                               planar::velocity_of(at, state.q, state.v),
                               planar::acceleration_of(at, state.q, state.v, state.a)});
    }
  }
  for (const planar::Reaction& reaction :
       planar::reactions_per_joint(mechanism, state, project.beam_body)) {
    result.reactions.push_back({mechanism.joints[static_cast<std::size_t>(reaction.joint)].name,
                                mechanism.bodies[static_cast<std::size_t>(reaction.on)].name,
                                reaction.force, reaction.moment,
                                planar::is_unique(freedom, reaction.joint)});
  }
  // What a pin in its clearance does to the beam, else to the first of its bodies.
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    const auto* const pin = std::get_if<planar::PinWithClearance>(&mechanism.forces[i].kind);
    if (pin == nullptr) continue;
    const bool second = pin->b.body == project.beam_body || pin->a.body == planar::ground;
    const int on = second ? pin->b.body : pin->a.body;
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    for (const planar::AppliedLoad& load :
         planar::applied_loads_of(mechanism, state.time, state.q, state.v, state.touches)) {
      if (load.force == static_cast<int>(i) && load.on == on) force = load.vector;
    }
    result.reactions.push_back({mechanism.forces[i].name,
                                mechanism.bodies[static_cast<std::size_t>(on)].name, force, 0.0,
                                true});
  }
  if (project.chain) result.chain = chain_result_of(mechanism, *project.chain, state);
  return result;
}

/// What contacts that can stick do in a state.
std::vector<FirstSlip> first_slips(const planar::Mechanism& mechanism, const planar::State& state) {
  const std::vector<planar::FrictionContact> contacts = planar::friction_contacts_of(mechanism);
  return first_slips_of(planar::laws_of(contacts), planar::names_of(mechanism, contacts),
                        state.slips);
}

/// What forces decide, at asked times only: integrated up to the last of them, and looked at in
/// between by nobody.
MotionResult integrated_motion(const Project& project, planar::StateSolver& solver,
                               const std::vector<double>& times) {
  const planar::Mechanism& mechanism = planar_of(project);
  const TimeSpan span = planar::time_span_of(mechanism);
  std::vector<double> ascending = times;
  std::sort(ascending.begin(), ascending.end());
  std::map<double, planar::State> states;
  planar::State state = solver.start();
  const std::vector<FirstSlip> first = first_slips(mechanism, state);
  for (const double time : ascending) {
    if (time < span.begin || time > (span.begin + span.length) * (1.0 + 1e-12)) {
      throw AnalysisError({fmt::format("the motion lasts from {:.6g} s to {:.6g} s", span.begin,
                                       span.begin + span.length),
                           "mechanism", time});
    }
    if (time > state.time) state = solver.near(time, state);
    states.emplace(time, state);
  }
  MotionResult result;
  result.freedom = solver.freedom();
  result.sticking = sticking_contacts(first, 0.0, solver.slip_changes());
  for (const auto& [time, at] : states) {
    planar::judge_uniqueness(mechanism, at.q, result.freedom);
  }
  result.redundant = planar::names_of_joints(mechanism, result.freedom.repeating);
  for (const double time : times) {
    result.states.push_back(instant_of(project, states.at(time), result.freedom));
  }
  return result;
}

}  // namespace

MotionResult motion_of(const Project& project, std::vector<double> times) {
  if (!times.empty()) {
    planar::StateSolver solver(planar_of(project));
    if (solver.integrates()) return integrated_motion(project, solver, times);
  }
  const planar::Motion motion = planar::solve_motion(planar_of(project));
  if (times.empty()) {
    for (int i = 0; i < 12; ++i) times.push_back(motion.begin + motion.period * i / 12.0);
  }
  MotionResult result;
  result.freedom = motion.freedom;
  result.redundant = planar::names_of_joints(planar_of(project), motion.freedom.repeating);
  result.change_points = motion.change_points;
  result.sticking = sticking_contacts(first_slips(planar_of(project), motion.states.front()),
                                      motion.begin, motion.slip_changes);
  planar::StateFinder finder(planar_of(project), motion);
  for (const double time : times) {
    planar::State state = finder.at(time);
    state.time = time;
    result.states.push_back(instant_of(project, state, motion.freedom));
  }
  return result;
}

std::vector<AssemblyResult> assemblies_of(const Project& project, double time) {
  const planar::Mechanism& mechanism = planar_of(project);
  std::vector<AssemblyResult> results;
  for (const Eigen::VectorXd& q : planar::list_assemblies(mechanism, time)) {
    AssemblyResult& result = results.emplace_back();
    result.branch = named_branch_of(mechanism, q);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      result.bodies.emplace_back(mechanism.bodies[i].name,
                                 q.segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
  }
  return results;
}

}  // namespace boxbeam
