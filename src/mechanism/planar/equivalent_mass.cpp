#include "boxbeam/mechanism/planar/equivalent_mass.hpp"

#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam::planar {
namespace {

/// Fourier coefficients of the first harmonic of a planar vector.
struct FirstHarmonic {
  Eigen::Vector2d cosine = Eigen::Vector2d::Zero();
  Eigen::Vector2d sine = Eigen::Vector2d::Zero();

  void add(const Eigen::Vector2d& value, double phase) {
    cosine += value * std::cos(phase);
    sine += value * std::sin(phase);
  }

  double dot(const FirstHarmonic& other) const {
    return cosine.dot(other.cosine) + sine.dot(other.sine);
  }
};

/// States at equal steps over one period.
double equivalent_mass_in(const Mechanism& mechanism, const std::vector<State>& states, int joint,
                          int on) {
  FirstHarmonic force, acceleration;
  const auto count = static_cast<double>(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State& state = states[i];
    const double phase = full_turn * static_cast<double>(i) / count;
    for (const Reaction& reaction : reactions_of(mechanism, state)) {
      if (reaction.joint != joint || reaction.on != on) continue;
      force.add(reaction.force, phase);
      acceleration.add(acceleration_of({on, reaction.point}, state.q, state.v, state.a), phase);
    }
  }
  const double squared = acceleration.dot(acceleration);
  if (!(squared > 0.0)) {
    throw AnalysisError({"no equivalent mass: the driven point has no acceleration",
                         mechanism.joints[static_cast<std::size_t>(joint)].name});
  }
  return force.dot(acceleration) / squared;
}

/// The same positions with the reactions of other masses.
std::vector<State> states_with(const Mechanism& mechanism, const Motion& motion) {
  InstantSolver solver(mechanism);
  std::vector<State> states;
  states.reserve(motion.states.size());
  for (const State& state : motion.states) states.push_back(solver.solve_near(state.time, state));
  return states;
}

}  // namespace

EquivalentMass equivalent_mass_of(const Mechanism& mechanism, const Motion& motion, int joint,
                                  int on, int adjustable, double wanted) {
  EquivalentMass result;
  result.given = equivalent_mass_in(mechanism, motion.states, joint, on);
  Mechanism heavier = mechanism;
  Body& body = heavier.bodies[static_cast<std::size_t>(adjustable)];
  const double more = body.mass > 0.0 ? body.mass : 1.0;
  body.mass += more;
  result.per_mass =
      (equivalent_mass_in(heavier, states_with(heavier, motion), joint, on) - result.given) / more;
  if (std::abs(result.per_mass) < 1e-9) {
    throw AnalysisError(
        {"no mass of this body gives the wanted equivalent mass: it has no influence", body.name});
  }
  result.needed = mechanism.bodies[static_cast<std::size_t>(adjustable)].mass +
                  (wanted - result.given) / result.per_mass;
  return result;
}

}  // namespace boxbeam::planar
