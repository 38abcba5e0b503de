#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/pictures.hpp"

namespace boxbeam {
namespace {

/// Position, speed and acceleration of a coordinate, and what drives it.
void add_sample(DriverLine& line, double time, const DriverState& motion,
                std::optional<double> force) {
  line.times.push_back(time);
  line.position.push_back(motion.value);
  line.speed.push_back(motion.rate);
  line.acceleration.push_back(motion.acceleration);
  if (force) line.force.push_back(*force);
}

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

std::vector<DriverLine> planar_lines_of(const Project& project, const SituationRun& run) {
  const planar::Mechanism& mechanism = planar_in(project, *run.situation);
  const planar::Motion& motion = planar_motion_of(run);
  std::vector<DriverLine> lines;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    if (planar::is_driver(joint)) {
      const bool with_force = project.dynamics == Dynamics::rigorous &&
                              planar::is_unique(mechanism, motion.freedom, static_cast<int>(i));
      lines.push_back(line_of(joint, row, motion, with_force));
    }
    row += planar::equations_of(joint);
  }
  if (motion.freedom.undriven > 0) {
    for (DriverLine& line : lines_of_forces(mechanism, motion)) lines.push_back(std::move(line));
  }
  return lines;
}

/// So many evenly divided steps of the time looked at.
constexpr int space_steps = 192;

std::vector<DriverLine> lines_in_space_of(const Project& project, const SituationRun& run) {
  const spatial::Mechanism& mechanism = spatial_in(project, *run.situation);
  const spatial::Chain chain(mechanism);
  std::vector<DriverLine> lines(mechanism.joints.size());
  for (int k = 0; k <= space_steps; ++k) {
    const double time =
        (run.loads.begin() + run.loads.period() * (static_cast<double>(k) / space_steps)).value();
    const spatial::State state = chain.at(time);
    const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const spatial::Joint& joint = mechanism.joints[i];
      if (joint.kind == spatial::JointKind::fixed) continue;
      const Eigen::Vector3d axis = spatial::in_world(state, joint.parent, joint.axis);
      lines[i].name = spatial::driver_text(joint);
      lines[i].turns = joint.kind == spatial::JointKind::revolute;
      add_sample(lines[i], time, driver_at(joint.driver, time),
                 axis.dot(lines[i].turns ? wrenches[i].moment : wrenches[i].force));
    }
  }
  std::erase_if(lines, [](const DriverLine& line) {
    return std::all_of(line.position.begin(), line.position.end(),
                       [&](double value) { return value == line.position.front(); });
  });
  return lines;
}

/// A harmonic force or couple and the displacement along it.
DriverLine line_of(const flexible::Load& load, bool couple, const FlexibleMotion& motion) {
  constexpr int steps = 192;
  const flexible::Response& response = motion.response;
  const double omega = 2.0 * std::numbers::pi * response.frequency;
  Eigen::Vector3d along = load.amplitude;
  if (couple)
    along.head<2>().setZero();
  else
    along.z() = 0.0;
  const double size = along.norm();
  along /= size;
  const double still =
      along.dot(flexible::motion_at(*motion.structure, load.at, response.constant));
  // A real vector does not conjugate what it is multiplied with.
  const flexible::Complex moving = along.cast<flexible::Complex>().dot(
      flexible::motion_at(*motion.structure, load.at, response.harmonic));
  DriverLine line;
  line.name = couple && load.amplitude.head<2>().norm() > 0.0 ? load.name + ", couple" : load.name;
  line.turns = couple;
  for (int k = 0; k <= steps; ++k) {
    const double time = k / (steps * response.frequency);
    const flexible::Complex now = moving * std::polar(1.0, omega * time);
    const DriverState state{still + now.imag(), omega * now.real(), -omega * omega * now.imag()};
    add_sample(line, time, state,
               along.dot(load.constant) + size * std::sin(omega * time + load.phase));
  }
  return line;
}

std::vector<DriverLine> elastic_lines_of(const Project& project, const SituationRun& run) {
  const FlexibleMotion& motion = flexible_motion_of(run);
  std::vector<DriverLine> lines;
  if (motion.response.frequency == 0.0) return lines;
  for (const flexible::Load& load : flexible_in(project, *run.situation).loads) {
    if (load.amplitude.head<2>().norm() > 0.0) lines.push_back(line_of(load, false, motion));
    if (load.amplitude.z() != 0.0) lines.push_back(line_of(load, true, motion));
  }
  return lines;
}

}  // namespace

std::vector<DriverLine> driver_lines_of(const Project& project, const SituationRun& run) {
  if (is_flexible(project)) return elastic_lines_of(project, run);
  if (in_space(project)) return lines_in_space_of(project, run);
  return planar_lines_of(project, run);
}

}  // namespace boxbeam
