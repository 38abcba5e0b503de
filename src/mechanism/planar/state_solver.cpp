#include "boxbeam/mechanism/planar/state_solver.hpp"

#include <fmt/format.h>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::planar {
namespace {

/// What no driver moves, where the first position is regular or nothing moves it at all.
DegreesOfFreedom freedom_at_start(const Mechanism& mechanism) {
  Assembler assembler(mechanism);
  const Assembly first = assembler.assemble(0.0, sketch_of(mechanism));
  if (!first.closed) throw AnalysisError(failure_of_assembly(mechanism, 0.0, first));
  DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, first.q);
  if (freedom.undriven == 0 || mechanism.equations() < mechanism.coordinates()) return freedom;
  // A dead point looks like a freedom without driver: a little later it is none.
  const double later = 1e-3 * time_span_of(mechanism).length;
  const Assembly second = assembler.assemble(later, first.q);
  return second.closed ? degrees_of_freedom_of(mechanism, second.q) : freedom;
}

std::variant<InstantSolver, FreeSolver> solver_for(const Mechanism& mechanism,
                                                   const DegreesOfFreedom& freedom) {
  if (freedom.undriven == 0) {
    for (const OneSided& of : one_sided_in(mechanism)) {
      if (!of.law.impact) continue;
      throw AnalysisError(
          {"drivers decide the whole motion, and nothing parts from a stop by itself, nor moves in "
           "a clearance; let forces move what it stops, or write damping instead of restitution",
           "force " + mechanism.forces[of.force].name});
    }
    return InstantSolver(mechanism);
  }
  if (mechanism.duration.length > 0.0) return FreeSolver(mechanism);
  std::string names;
  for (const int body : freedom.moving) {
    names +=
        (names.empty() ? "body " : ", ") + mechanism.bodies[static_cast<std::size_t>(body)].name;
  }
  // By count they may do: then the position that the sketch led to may be a singular one.
  const bool enough = mechanism.equations() >= mechanism.coordinates();
  throw AnalysisError(
      {fmt::format("the motion is not determined: {} {} no driver moves{}; {}add a driver, or give "
                   "[motion] duration to let the forces move it",
                   freedom.undriven, freedom.undriven == 1 ? "freedom that" : "freedoms that",
                   enough ? " in the position that the sketch leads to" : "",
                   enough ? "draw the sketch nearer to the position that is meant, for joints and "
                            "drivers are enough by their number; else "
                          : ""),
       names});
}

}  // namespace

StateSolver::StateSolver(const Mechanism& mechanism)
    : StateSolver(mechanism, freedom_at_start(mechanism)) {}

StateSolver::StateSolver(const Mechanism& mechanism, DegreesOfFreedom freedom)
    : mechanism_(&mechanism),
      freedom_(std::move(freedom)),
      solver_(solver_for(mechanism, freedom_)) {}

State StateSolver::start() {
  if (auto* free = std::get_if<FreeSolver>(&solver_)) {
    if (const auto fitting = without_clearance(*mechanism_)) {
      const State begin = StateSolver(*fitting).start();
      return free->start(0.0, begin.q, begin.v);
    }
    return free->start(0.0, sketch_of(*mechanism_), start_velocity_of(*mechanism_));
  }
  return std::get<InstantSolver>(solver_).solve_from_sketch(0.0, sketch_of(*mechanism_));
}

State StateSolver::near(double time, const State& known) {
  if (auto* free = std::get_if<FreeSolver>(&solver_)) return free->advance(time, known);
  return std::get<InstantSolver>(solver_).solve_near(time, known);
}

std::vector<double> StateSolver::change_points() const {
  const auto* driven = std::get_if<InstantSolver>(&solver_);
  return driven != nullptr ? driven->change_points() : std::vector<double>{};
}

std::vector<double> StateSolver::changes() const {
  const auto* free = std::get_if<FreeSolver>(&solver_);
  return free != nullptr ? free->changes() : std::vector<double>{};
}

std::vector<SlipChange> StateSolver::slip_changes() const {
  const auto* free = std::get_if<FreeSolver>(&solver_);
  return free != nullptr ? free->slip_changes() : std::vector<SlipChange>{};
}

}  // namespace boxbeam::planar
