#include "bent_dynamics.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

double moment_about_origin(const Vector2d& arm, const Vector2d& force) {
  return arm.x() * force.y() - arm.y() * force.x();
}

}  // namespace

VectorXd places_of(const BentAxis& axis, int body, const VectorXd& q) {
  const Index i = 3 * static_cast<Index>(body);
  const Eigen::Rotation2Dd turn(q[i + 2]);
  VectorXd places(3 * axis.middle.cols());
  for (Index k = 0; k < axis.middle.cols(); ++k) {
    places.segment<2>(3 * k) = q.segment<2>(i) + turn * Vector2d(axis.middle.col(k));
    places[3 * k + 2] = q[i + 2] + axis.middle_angle[k];
  }
  return places;
}

VectorXd BentDynamics::multipliers_of(const planar::Mechanism& mechanism,
                                      const planar::State& state, const Matrix3Xd& own,
                                      const VectorXd& where) const {
  const Index at_beam = 3 * static_cast<Index>(beam_);
  VectorXd Q = VectorXd::Zero(mechanism.coordinates());
  planar::add_applied_forces(mechanism, state.time, state.q, state.v, Q);
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    if (static_cast<int>(body) == beam_) continue;
    const Index i = 3 * static_cast<Index>(body);
    const Body& of = mechanism.bodies[body];
    Q.segment<2>(i) += of.mass * (mechanism.gravity - state.a.segment<2>(i));
    Q[i + 2] -= of.inertia * state.a[i + 2];
  }
  for (Index k = 0; k < own.cols(); ++k) {
    const Vector3d load = own.col(k);
    Q.segment<2>(at_beam) += load.head<2>();
    Q[at_beam + 2] +=
        load[2] +
        moment_about_origin(where.segment<2>(3 * k) - state.q.segment<2>(at_beam), load.head<2>());
  }
  planar::ConstraintEquations equations(mechanism);
  equations.set_time(state.time);
  equations.set_position(state.q);
  VectorXd phi(equations.rows());
  std::vector<double> values(equations.pattern().entries());
  equations.evaluate(phi, values);
  return equations.pattern().dense(values).transpose().partialPivLu().solve(Q);
}

Matrix3Xd BentDynamics::acting_at_nodes(const planar::Mechanism& mechanism,
                                        const planar::State& state) const {
  const Vector2d origin = state.q.segment<2>(3 * static_cast<Index>(beam_));
  Matrix3Xd acting = Matrix3Xd::Zero(3, static_cast<Index>(axis_->nodes().size()));
  // Of the straight mechanism it is the same in the same order, there it is known where along the
  // beam.
  const auto act = [&](const Vector2d& straight, const Vector2d& point, const Vector2d& force,
                       double moment) {
    const Vector2d arm = planar::position_of({beam_, point}, state.q) - origin;
    acting.col(axis_->node_of({beam_, straight})) +=
        Vector3d(force.x(), force.y(), moment + moment_about_origin(arm, force));
  };
  const auto reactions = planar::reactions_of(mechanism, state);
  const auto unbent = planar::reactions_of(*straight_, state);
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    if (reactions[i].on == beam_)
      act(unbent[i].point, reactions[i].point, reactions[i].force, reactions[i].moment);
  }
  const auto applied = planar::applied_loads_of(mechanism, state.time, state.q, state.v);
  const auto unbent_applied = planar::applied_loads_of(*straight_, state.time, state.q, state.v);
  for (std::size_t i = 0; i < applied.size(); ++i) {
    if (applied[i].on == beam_)
      act(unbent_applied[i].point, applied[i].point, applied[i].vector, applied[i].moment);
  }
  return acting;
}

std::vector<ElementCut> BentDynamics::cuts_of(const planar::Mechanism& mechanism,
                                              planar::State state, const BentAxis& axis,
                                              const VectorXd& accelerations) const {
  const Index at_beam = 3 * static_cast<Index>(beam_), count = axis.middle.cols();
  const VectorXd where = places_of(axis, beam_, state.q);
  const Vector2d origin = state.q.segment<2>(at_beam);
  Matrix3Xd own(3, count);
  for (Index k = 0; k < count; ++k) {
    const DividedAxis::Element& element = axis_->elements()[static_cast<std::size_t>(k)];
    own.col(k) << element.mass * (mechanism.gravity - accelerations.segment<2>(3 * k)),
        -element.rotary * accelerations[3 * k + 2];
  }
  state.lambda = multipliers_of(mechanism, state, own, where);
  const Matrix3Xd acting = acting_at_nodes(mechanism, state);
  const double angle = state.q[at_beam + 2];
  const Eigen::Rotation2Dd turn(angle);
  std::vector<ElementCut> cuts;
  Vector3d sum = Vector3d::Zero();
  for (Index k = 0; k < count; ++k) {
    sum += acting.col(k);
    const auto couple_at = [&](const Vector2d& place) {
      return -(sum[2] - moment_about_origin(turn * place + state.q.segment<2>(at_beam) - origin,
                                            sum.head<2>()));
    };
    ElementCut cut;
    cut.from = couple_at(axis.node.col(k));
    const Vector3d load = own.col(k);
    const Vector2d force = sum.head<2>() + 0.5 * load.head<2>();
    const Vector2d along = Eigen::Rotation2Dd(-angle - axis.middle_angle[k]) * force;
    cut.N = -along.x();
    cut.V = -along.y();
    sum.head<2>() += load.head<2>();
    sum[2] += load[2] + moment_about_origin(where.segment<2>(3 * k) - origin, load.head<2>());
    cut.to = couple_at(axis.node.col(k + 1));
    cuts.push_back(cut);
  }
  return cuts;
}

}  // namespace boxbeam
