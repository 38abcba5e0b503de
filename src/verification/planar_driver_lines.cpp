#include <cmath>
#include <optional>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "front_ends.hpp"
#include "planar_pictures.hpp"

namespace boxbeam {
namespace {

/// The solved states, thinned where they are many, with the one at the end.
std::vector<const planar::State*> shown_states(const planar::Motion& motion) {
  constexpr std::size_t most = 400;
  const std::size_t stride = motion.states.size() / most + 1;
  std::vector<const planar::State*> shown;
  for (std::size_t i = 0; i < motion.states.size(); i += stride) shown.push_back(&motion.states[i]);
  shown.push_back(&motion.end);
  return shown;
}

/// A joint's driver and its multiplier's row.
DriverLine line_of(const planar::Joint& joint, Eigen::Index row, const planar::Motion& motion,
                   bool with_force) {
  const auto& driven = std::get<planar::Driven>(joint.kind);
  DriverLine line;
  line.name = joint.name;
  line.turns = driven.coordinate == planar::Coordinate::angle;
  for (const planar::State* state : shown_states(motion)) {
    // The equation is coordinate - driver = 0, and what holds it is -J^T lambda.
    add_sample(line, state->time, driver_at(driven.driver, state->time),
               with_force ? std::optional(-state->lambda[row]) : std::nullopt);
  }
  return line;
}

/// The path of a force's point along its direction; the coordinate turns with the force.
DriverState along(const planar::PointForce& force, const planar::State& state) {
  const bool turns = force.turns && force.at.body != planar::ground;
  const Eigen::Index angle = 3 * static_cast<Eigen::Index>(force.at.body) + 2;
  const double direction = force.direction + (turns ? state.q[angle] : 0.0);
  const Eigen::Vector2d u(std::cos(direction), std::sin(direction));
  return {u.dot(planar::position_of(force.at, state.q)),
          u.dot(planar::velocity_of(force.at, state.q, state.v)),
          u.dot(planar::acceleration_of(force.at, state.q, state.v, state.a))};
}

/// The angle of one body against another, or against the ground.
DriverState angle_between(int a, int b, const planar::State& state) {
  DriverState angle;
  for (const auto& [body, sign] : {std::pair(a, 1.0), std::pair(b, -1.0)}) {
    if (body == planar::ground) continue;
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body) + 2;
    angle.value += sign * state.q[i];
    angle.rate += sign * state.v[i];
    angle.acceleration += sign * state.a[i];
  }
  return angle;
}

std::vector<DriverLine> lines_of_forces(const planar::Mechanism& mechanism,
                                        const planar::Motion& motion) {
  std::vector<DriverLine> lines;
  for (const planar::AppliedForce& force : mechanism.forces) {
    const auto* push = std::get_if<planar::PointForce>(&force.kind);
    const auto* couple = std::get_if<planar::Couple>(&force.kind);
    // Of a force that turns with its body no coordinate is the path.
    if ((push == nullptr || push->turns) && couple == nullptr) continue;
    DriverLine& line = lines.emplace_back();
    line.name = force.name;
    line.turns = couple != nullptr;
    for (const planar::State* state : shown_states(motion)) {
      const double size =
          driver_at(couple != nullptr ? couple->size : push->size, state->time).value;
      add_sample(line, state->time,
                 couple != nullptr ? angle_between(couple->a.body, couple->b.body, *state)
                                   : along(*push, *state),
                 size);
    }
  }
  if (!lines.empty() || motion.freedom.moving.empty()) return lines;
  const int body = motion.freedom.moving.front();
  DriverLine& line = lines.emplace_back();
  line.name = "angle of " + mechanism.bodies[static_cast<std::size_t>(body)].name;
  line.turns = true;
  for (const planar::State* state : shown_states(motion)) {
    add_sample(line, state->time, angle_between(body, planar::ground, *state), std::nullopt);
  }
  return lines;
}

}  // namespace

std::vector<DriverLine> driver_lines_of(const Project& project, const planar::Mechanism& mechanism,
                                        const planar::Motion& motion) {
  std::vector<DriverLine> lines;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    if (planar::is_driver(joint)) {
      const bool with_force = project.dynamics == Dynamics::rigorous &&
                              planar::is_unique(motion.freedom, static_cast<int>(i));
      lines.push_back(line_of(joint, row, motion, with_force));
    }
    row += planar::equations_of(joint);
  }
  if (motion.freedom.undriven > 0) {
    for (DriverLine& line : lines_of_forces(mechanism, motion)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace boxbeam
