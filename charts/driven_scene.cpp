#include "charts/driven_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "boxbeam/core/error.hpp"

namespace boxbeam::charts {
namespace {

planar::Mechanism without_friction(planar::Mechanism mechanism) {
  for (planar::Joint& joint : mechanism.joints) {
    if (auto* slider = std::get_if<planar::Slider>(&joint.kind)) slider->friction = {};
    if (auto* slot = std::get_if<planar::PinInSlot>(&joint.kind)) slot->friction = {};
  }
  return mechanism;
}

}  // namespace

std::vector<double> DrivenScene::times(std::size_t instants) const {
  std::vector<double> times(instants);
  for (std::size_t i = 0; i < instants; ++i) {
    times[i] =
        motion.begin + motion.period * static_cast<double>(i) / static_cast<double>(instants);
  }
  return times;
}

std::optional<DrivenScene> driven_scene_of(const Scenes& scenes, std::string& why) {
  if (!scenes.planar) {
    why = scenes.missing;
    return std::nullopt;
  }
  DrivenScene scene;
  scene.mechanism = without_friction(planar_of(*scenes.planar));
  try {
    const planar::StateSolver solver(scene.mechanism);
    if (solver.integrates()) {
      why = fmt::format("forces, not drivers, decide the motion of {}", scenes.planar->name);
      return std::nullopt;
    }
    scene.motion = planar::solve_motion(scene.mechanism);
  } catch (const AnalysisError& error) {
    why = fmt::format("{}: {}", scenes.planar->name, error.failure().what);
    return std::nullopt;
  }
  scene.dyads = plan_dyads(scene.mechanism, scene.motion.states.front().q);
  scene.name = fmt::format("{}, {} of {:.5g} s", scenes.planar->name,
                           scene.motion.closed ? "one period" : "a motion", scene.motion.period);
  return scene;
}

ReferenceMotion newton_reference_of(const DrivenScene& scene, std::size_t instants) {
  ReferenceMotion reference;
  reference.name = "Newton's method in long double, orthogonal decomposition";
  reference.times = scene.times(instants);
  planar::InstantSolver near(scene.mechanism);
  TextbookSolver<long double> solver(scene.mechanism, LinearMethod::orthogonal);
  planar::State state = scene.motion.states.front();
  for (const double time : reference.times) {
    if (time != state.time) state = near.solve_near(time, state);
    InstantIn<long double> instant;
    instant.q = state.q.cast<long double>();
    solver.equations().set_time(time);
    solver.solve_position(instant.q, 0.0);
    solver.solve_rates(instant);
    solver.solve_multipliers(time, instant);
    reference.instants.push_back(std::move(instant));
  }
  return reference;
}

ReferenceMotion reference_of(const DrivenScene& scene, std::size_t instants) {
  ReferenceMotion reference = newton_reference_of(scene, instants);
  if (!scene.dyads.failure.empty()) return reference;
  reference.name = "closed-form dyads in long double";
  TextbookSolver<long double> solver(scene.mechanism, LinearMethod::orthogonal);
  for (std::size_t i = 0; i < instants; ++i) {
    InstantIn<long double>& instant = reference.instants[i];
    solver.equations().set_time(reference.times[i]);
    const Eigen::VectorXd near = instant.q.cast<double>();
    solve_dyads(scene.dyads, solver.equations().driver_states(), near, instant);
    InstantIn<long double> balance = instant;
    solver.solve_rates(balance);
    balance.a = instant.a;
    solver.solve_multipliers(reference.times[i], balance);
    instant.lambda = balance.lambda;
  }
  return reference;
}

const char* to_text(Quantity quantity) {
  switch (quantity) {
    case Quantity::position: return "positions";
    case Quantity::velocity: return "velocities";
    case Quantity::acceleration: return "accelerations";
    default: return "reactions";
  }
}

ErrorOf::ErrorOf(const planar::Mechanism& mechanism, const ReferenceMotion& reference)
    : reference_(&reference) {
  const planar::ConstraintEquations equations(mechanism);
  col_weight_ = equations.col_scale().cwiseInverse().cast<long double>();
  // The multiplier of a length is a force, that of an angle a moment.
  row_weight_ = equations.row_scale().cwiseInverse().cast<long double>();
  row_weight_ /= row_weight_.maxCoeff();
  for (const InstantIn<long double>& instant : reference.instants) {
    for (const Quantity quantity :
         {Quantity::position, Quantity::velocity, Quantity::acceleration, Quantity::reaction}) {
      if (part(quantity, instant).size() == 0) continue;  // not asked for
      const Vector& weight = quantity == Quantity::reaction ? row_weight_ : col_weight_;
      long double& largest = largest_[static_cast<int>(quantity)];
      largest =
          std::max(largest, part(quantity, instant).cwiseProduct(weight).lpNorm<Eigen::Infinity>());
    }
  }
}

const ErrorOf::Vector& ErrorOf::part(Quantity quantity, const InstantIn<long double>& instant) {
  switch (quantity) {
    case Quantity::position: return instant.q;
    case Quantity::velocity: return instant.v;
    case Quantity::acceleration: return instant.a;
    default: return instant.lambda;
  }
}

double ErrorOf::at(Quantity quantity, std::size_t index,
                   const InstantIn<long double>& instant) const {
  Vector difference = part(quantity, instant) - part(quantity, reference_->instants[index]);
  if (quantity == Quantity::position) {
    for (Eigen::Index i = 2; i < difference.size(); i += 3) {
      difference[i] = std::remainder(difference[i], 2.0L * std::numbers::pi_v<long double>);
    }
  }
  // A norm of numbers that are none may be one.
  if (!difference.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const Vector& weight = quantity == Quantity::reaction ? row_weight_ : col_weight_;
  return static_cast<double>(difference.cwiseProduct(weight).lpNorm<Eigen::Infinity>() /
                             largest_[static_cast<int>(quantity)]);
}

double ErrorOf::operator()(Quantity quantity,
                           const std::vector<InstantIn<long double>>& instants) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double error = at(quantity, i, instants[i]);
    if (!std::isfinite(error)) return error;
    worst = std::max(worst, error);
  }
  return worst;
}

InstantIn<long double> instant_of(const planar::State& state) {
  return InstantIn<double>{state.q, state.v, state.a, state.lambda}.in<long double>();
}

}  // namespace boxbeam::charts
