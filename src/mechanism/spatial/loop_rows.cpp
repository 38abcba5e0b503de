#include "loop_rows.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

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
    const Wrench of = wrench_of(mechanism, rows[r], state);
    closing[rows[r].joint].force += multiplier * of.force;
    closing[rows[r].joint].moment += multiplier * of.moment;
  }
  return closing;
}

std::vector<BodyWrench> on_both_bodies(const Mechanism& mechanism,
                                       const std::vector<Wrench>& closing, const State& state) {
  std::vector<BodyWrench> wrenches;
  for (std::size_t i = 0; i < closing.size(); ++i) {
    const ClosingJoint& joint = mechanism.closing[i];
    const Vector3d place = position_of(state, joint.b);
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
    case ClosingKind::planar: return same(joint.axis);
    case ClosingKind::universal:
    case ClosingKind::spherical:
    case ClosingKind::slot:
    case ClosingKind::distance: return true;
  }
  return true;
}

std::string open_text(const LoopRow& row, double value) {
  if (row.kind == LoopRow::Kind::square) return fmt::format("{:.3g} rad askew", std::abs(value));
  return fmt::format("{:.3g} m apart", std::abs(value));
}

}  // namespace boxbeam::spatial
