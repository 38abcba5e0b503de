#include "loop_rows.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/core/angle.hpp"

namespace boxbeam::spatial {
namespace {

using Eigen::Vector3d;

/// A vector that a body carries along, and its derivatives.
struct Carried {
  Vector3d value, rate, acceleration;
};

Carried carried(const State& state, int body, const Vector3d& vector) {
  const BodyMotion& motion = motion_of(state, body);
  const Vector3d value = motion.R_WB * vector;
  const Vector3d rate = motion.omega.cross(value);
  return {value, rate, motion.alpha.cross(value) + motion.omega.cross(rate)};
}

/// From the place on a to the place on b.
Carried between(const State& state, const ClosingJoint& joint) {
  return {position_of(state, joint.b) - position_of(state, joint.a),
          velocity_of(state, joint.b) - velocity_of(state, joint.a),
          acceleration_of(state, joint.b) - acceleration_of(state, joint.a)};
}

/// The product rule, twice.
RowMotion product(const Carried& a, const Carried& b) {
  return {a.value.dot(b.value), a.rate.dot(b.value) + a.value.dot(b.rate),
          a.acceleration.dot(b.value) + 2.0 * a.rate.dot(b.rate) + a.value.dot(b.acceleration)};
}

/// The turn of b against a about the joint's axis, from -pi to pi.
double screw_turn_of(const ClosingJoint& joint, const State& state) {
  const Vector3d v = joint.axis.unitOrthogonal(), w = joint.axis.cross(v);
  const auto of_a = [&](const Vector3d& x) { return in_world(state, joint.a.body, x); };
  const auto of_b = [&](const Vector3d& x) {
    return in_world(state, joint.b.body, joint.turn.transpose() * x);
  };
  return std::atan2(of_a(w).dot(of_b(v)) - of_a(v).dot(of_b(w)),
                    of_a(v).dot(of_b(v)) + of_a(w).dot(of_b(w)));
}

/// Along the axis less what the turn about it advances, by the nearest turn; the rates are those of
/// axes that other equations keep in line, so that b turns against a about them alone.
RowMotion thread_motion(const ClosingJoint& joint, const RowMotion& slide, const State& state) {
  const double pitch = pitch_of(joint.lead);
  const BodyMotion& a = motion_of(state, joint.a.body);
  const BodyMotion& b = motion_of(state, joint.b.body);
  const Vector3d axis = a.R_WB * joint.axis;
  return {pitch * std::remainder(slide.value / pitch - screw_turn_of(joint, state), full_turn),
          slide.rate - pitch * axis.dot(b.omega - a.omega),
          slide.acceleration - pitch * axis.dot(b.alpha - a.alpha)};
}

RowMotion teeth_motion(const Mesh& mesh, const State& state) {
  RowMotion motion{-mesh.offset, 0.0, 0.0};
  for (const Mesh::Part& part : mesh.parts) {
    const DriverState& q = state.coordinates[part.joint];
    motion.value += part.factor * q.value;
    motion.rate += part.factor * q.rate;
    motion.acceleration += part.factor * q.acceleration;
  }
  return motion;
}

class Rows {
 public:
  explicit Rows(std::vector<LoopRow>& rows) : rows_(&rows) {}

  void add(std::size_t index, const ClosingJoint& joint) {
    using Kind = ClosingKind;
    index_ = index;
    const Vector3d u = joint.axis.unitOrthogonal();
    const Vector3d v = joint.axis.cross(u);
    const auto anywhere = [&] {
      for (int k = 0; k < 3; ++k) along(Vector3d::Unit(k));
    };
    const auto on_the_axis = [&] {
      along(u);
      along(v);
    };
    const auto aligned = [&] {
      const Vector3d axis_of_b = joint.turn.transpose() * joint.axis;
      square(u, axis_of_b);
      square(v, axis_of_b);
    };
    const auto unturned = [&] {
      for (int k = 0; k < 3; ++k) square(joint.turn.col(k), Vector3d::Unit((k + 1) % 3));
    };
    switch (joint.kind) {
      case Kind::fixed: return anywhere(), unturned();
      case Kind::revolute: return anywhere(), aligned();
      case Kind::prismatic: return on_the_axis(), unturned();
      case Kind::cylindrical: return on_the_axis(), aligned();
      case Kind::universal: return anywhere(), square(joint.axis, joint.other);
      case Kind::spherical: return anywhere();
      case Kind::planar: return along(joint.axis), aligned();
      case Kind::slot: return on_the_axis();
      case Kind::distance:
        rows_->push_back({LoopRow::Kind::distance, index, Vector3d::Zero(), Vector3d::Zero()});
        return;
      case Kind::screw:
        on_the_axis(), aligned();
        rows_->push_back({LoopRow::Kind::thread, index, joint.axis, Vector3d::Zero()});
        return;
      case Kind::gear:
      case Kind::rack:
        rows_->push_back({LoopRow::Kind::mesh, index, Vector3d::Zero(), Vector3d::Zero()});
        return;
    }
  }

 private:
  void along(const Vector3d& u) {
    rows_->push_back({LoopRow::Kind::along, index_, u, Vector3d::Zero()});
  }
  void square(const Vector3d& u, const Vector3d& w) {
    rows_->push_back({LoopRow::Kind::square, index_, u, w});
  }

  std::vector<LoopRow>* rows_;
  std::size_t index_ = 0;
};

}  // namespace

std::vector<LoopRow> rows_of(const Mechanism& mechanism) {
  std::vector<LoopRow> rows;
  Rows maker(rows);
  for (std::size_t i = 0; i < mechanism.closing.size(); ++i) maker.add(i, mechanism.closing[i]);
  return rows;
}

RowMotion motion_of(const Mechanism& mechanism, const LoopRow& row, const State& state) {
  const ClosingJoint& joint = mechanism.closing[row.joint];
  switch (row.kind) {
    case LoopRow::Kind::along:
      return product(carried(state, joint.a.body, row.u), between(state, joint));
    case LoopRow::Kind::thread:
      return thread_motion(
          joint, product(carried(state, joint.a.body, row.u), between(state, joint)), state);
    case LoopRow::Kind::mesh: return teeth_motion(joint.mesh, state);
    case LoopRow::Kind::square:
      return product(carried(state, joint.a.body, row.u), carried(state, joint.b.body, row.w));
    case LoopRow::Kind::distance: break;
  }
  const Carried d = between(state, joint);
  const DriverState length = driver_at(joint.length, state.time);
  const double now = d.value.norm();
  const double rate = d.value.dot(d.rate) / now;
  return {now - length.value, rate - length.rate,
          (d.value.dot(d.acceleration) + d.rate.squaredNorm() - rate * rate) / now -
              length.acceleration};
}

Wrench wrench_of(const Mechanism& mechanism, const LoopRow& row, const State& state) {
  const ClosingJoint& joint = mechanism.closing[row.joint];
  const Vector3d u = in_world(state, joint.a.body, row.u);
  switch (row.kind) {
    case LoopRow::Kind::along: return {u, Vector3d::Zero()};
    case LoopRow::Kind::square:
      return {Vector3d::Zero(), in_world(state, joint.b.body, row.w).cross(u)};
    case LoopRow::Kind::thread: return {u, -pitch_of(joint.lead) * u};
    case LoopRow::Kind::mesh:
      return {in_world(state, joint.mesh.at.body, joint.mesh.along), Vector3d::Zero()};
    case LoopRow::Kind::distance: break;
  }
  return {(position_of(state, joint.b) - position_of(state, joint.a)).normalized(),
          Vector3d::Zero()};
}

std::vector<Wrench> closing_wrenches(const Mechanism& mechanism, const std::vector<LoopRow>& rows,
                                     const Eigen::VectorXd& multipliers, const State& state) {
  std::vector<Wrench> closing(mechanism.closing.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double multiplier = multipliers[static_cast<Eigen::Index>(r)];
    if (multiplier == 0.0) continue;
    const Wrench of = wrench_of(mechanism, rows[r], state);
    closing[rows[r].joint].force += multiplier * of.force;
    closing[rows[r].joint].moment += multiplier * of.moment;
    if (rows[r].kind != LoopRow::Kind::mesh) continue;
    const Mesh& teeth = mechanism.closing[rows[r].joint].mesh;
    closing[rows[r].joint].force +=
        std::abs(multiplier) * in_world(state, teeth.at.body, teeth.apart);
  }
  return closing;
}

std::vector<BodyWrench> on_both_bodies(const Mechanism& mechanism,
                                       const std::vector<Wrench>& closing, const State& state) {
  std::vector<BodyWrench> wrenches;
  for (std::size_t i = 0; i < closing.size(); ++i) {
    const ClosingJoint& joint = mechanism.closing[i];
    const Vector3d place = position_of(state, place_of(joint));
    wrenches.push_back({joint.b.body, place, closing[i]});
    wrenches.push_back({joint.a.body, place, {-closing[i].force, -closing[i].moment}});
  }
  return wrenches;
}

bool stands_right(const ClosingJoint& joint, const State& state) {
  const auto same = [&](const Vector3d& of_a) {
    const Vector3d of_b = joint.turn.transpose() * of_a;
    return in_world(state, joint.a.body, of_a).dot(in_world(state, joint.b.body, of_b)) > 0.0;
  };
  switch (joint.kind) {
    case ClosingKind::fixed:
    case ClosingKind::prismatic:
      return same(Vector3d::UnitX()) && same(Vector3d::UnitY()) && same(Vector3d::UnitZ());
    case ClosingKind::revolute:
    case ClosingKind::cylindrical:
    case ClosingKind::planar:
    case ClosingKind::screw: return same(joint.axis);
    case ClosingKind::universal:
    case ClosingKind::spherical:
    case ClosingKind::slot:
    case ClosingKind::distance:
    case ClosingKind::gear:
    case ClosingKind::rack: return true;
  }
  return true;
}

std::string open_text(const LoopRow& row, double value) {
  if (row.kind == LoopRow::Kind::square) return fmt::format("{:.3g} rad askew", std::abs(value));
  return fmt::format("{:.3g} m apart", std::abs(value));
}

}  // namespace boxbeam::spatial
