#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

/// What each kind of joint is: its ends, its equations, what it holds and with what it pushes. A
/// new kind answers here; who asks goes through mechanism.hpp.
namespace boxbeam::planar {

/// The two attachments of a kind of joint, by the names that they have there.
auto attachments_in(auto& of) requires requires {
  of.a;
  of.b;
}
{ return std::pair(&of.a, &of.b); }
auto attachments_in(auto& of) requires requires { of.guide; }
{ return std::pair(&of.point, &of.guide); }
auto attachments_in(auto& of) requires requires { of.rack; }
{ return std::pair(&of.pinion, &of.rack); }
auto attachments_in(auto& of) requires requires { of.other; }
{ return std::pair(&of.point, &of.other); }

/// Tells a sink the equations of a joint in their order, one call each: `coincide` (two equations),
/// `across` and `along` a line of the second body, `coordinate` of the world, `turn`, `length`,
/// `mesh`; and `follows` behind one that is equal to what a driver says.
template <class Sink>
struct EquationsOfKind {
  Sink& to;

  void operator()(const Pin& pin) const { to.coincide(pin.a, pin.b); }

  void operator()(const Slider& slider) const {
    to.across(slider.point, slider.guide, slider.direction);
    to.turn(slider.point, slider.guide, 1.0, slider.angle);
  }

  void operator()(const PinInSlot& slot) const {
    to.across(slot.point, slot.guide, slot.direction);
  }

  void operator()(const Rigid& rigid) const {
    to.coincide(rigid.a, rigid.b);
    to.turn(rigid.a, rigid.b, 1.0, rigid.angle);
  }

  void operator()(const Distance& distance) const {
    to.length(distance.a, distance.b, distance.length);
  }

  void operator()(const AngleCoupling& coupling) const {
    to.turn(coupling.a, coupling.b, coupling.ratio, coupling.offset);
  }

  void operator()(const Gear& gear) const {
    to.mesh(gear.a, gear.b, gear.radius_a, gear.radius_b, gear.offset);
  }

  void operator()(const Rack& rack) const {
    to.along(rack.pinion, rack.rack, rack.direction, rack.radius, rack.offset);
  }

  void operator()(const Driven& driven) const {
    switch (driven.coordinate) {
      case Coordinate::x: to.coordinate(driven.point, 0); break;
      case Coordinate::y: to.coordinate(driven.point, 1); break;
      case Coordinate::angle: to.turn(driven.point, driven.other, 1.0, 0.0); break;
      case Coordinate::length: to.length(driven.point, driven.other, 0.0); break;
    }
    to.follows(driven.driver);
  }
};

/// What a kind of joint wants of the bodies at its two ends.
struct HoldsOfKind {
  using Holds = std::pair<Hold, Hold>;

  Holds operator()(const Pin&) const { return {Hold::place, Hold::place}; }
  Holds operator()(const Slider&) const { return {Hold::clamp, Hold::guide}; }
  Holds operator()(const PinInSlot&) const { return {Hold::place, Hold::guide}; }
  Holds operator()(const Rigid&) const { return {Hold::clamp, Hold::clamp}; }
  Holds operator()(const Distance&) const { return {Hold::place, Hold::place}; }
  Holds operator()(const AngleCoupling&) const { return {Hold::angle, Hold::angle}; }
  Holds operator()(const Gear&) const { return {Hold::clamp, Hold::clamp}; }
  Holds operator()(const Rack&) const { return {Hold::clamp, Hold::teeth}; }
  Holds operator()(const Driven& driven) const {
    const Hold hold = driven.coordinate == Coordinate::angle ? Hold::angle : Hold::place;
    return {hold, hold};
  }
};

/// The reactions of one joint of a kind; `lambda` are its own multipliers.
struct ReactionsOfKind {
  const State& state;
  std::vector<Reaction>& reactions;
  int joint;
  const double* lambda;
  double friction;  ///< on what slides, along its guide [N]

  void add(const Attachment& at, const Eigen::Vector2d& force, double moment) const {
    if (at.body != ground) reactions.push_back({joint, at.body, force, moment, at.p});
  }

  static Eigen::Vector2d left_side_of(const Eigen::Vector2d& vector) {
    return {-vector.y(), vector.x()};
  }

  double angle_at(int body) const {
    return body == ground ? 0.0 : state.q[3 * static_cast<Eigen::Index>(body) + 2];
  }

  /// Where a place of the world is on a body.
  Attachment place_on(int body, const Eigen::Vector2d& place) const {
    if (body == ground) return {};
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body);
    return {body, Eigen::Rotation2Dd(-state.q[i + 2]) * (place - state.q.segment<2>(i))};
  }

  Eigen::Vector2d turned(double angle, int body) const {
    const double direction = angle + angle_at(body);
    return {std::cos(direction), std::sin(direction)};
  }

  /// A point pushed across a line of another body, along it by friction, and turned by a moment.
  template <class Slide>
  void add_sliding(const Slide& slide, double moment) const {
    const Eigen::Vector2d along = turned(slide.direction, slide.guide.body);
    const Eigen::Vector2d force = friction * along - lambda[0] * left_side_of(along);
    add(slide.point, force, moment);
    add(place_on(slide.guide.body, position_of(slide.point, state.q)), -force, -moment);
  }

  /// A force between two points along their connection.
  void add_between(const Attachment& a, const Attachment& b) const {
    const Eigen::Vector2d u = (position_of(a, state.q) - position_of(b, state.q)).normalized();
    add(a, -lambda[0] * u, 0.0);
    add(b, lambda[0] * u, 0.0);
  }

  void operator()(const Pin& pin) const {
    const Eigen::Vector2d force(lambda[0], lambda[1]);
    add(pin.a, -force, 0.0);
    add(pin.b, force, 0.0);
  }

  void operator()(const Slider& slider) const { add_sliding(slider, -lambda[1]); }
  void operator()(const PinInSlot& slot) const { add_sliding(slot, 0.0); }

  void operator()(const Rigid& rigid) const {
    const Eigen::Vector2d force(lambda[0], lambda[1]);
    add(rigid.a, -force, -lambda[2]);
    add(rigid.b, force, lambda[2]);
  }

  void operator()(const Distance& distance) const { add_between(distance.a, distance.b); }

  void operator()(const AngleCoupling& coupling) const {
    add(coupling.a, Eigen::Vector2d::Zero(), -lambda[0]);
    add(coupling.b, Eigen::Vector2d::Zero(), coupling.ratio * lambda[0]);
  }

  void operator()(const Gear& gear) const {
    // The tooth force acts where the pitch circles touch: at the centres it is itself and a moment.
    const Eigen::Vector2d between = position_of(gear.b, state.q) - position_of(gear.a, state.q);
    const Eigen::Vector2d tooth =
        lambda[0] * (gear.radius_a + gear.radius_b) / between.squaredNorm() * left_side_of(between);
    add(gear.a, -tooth, -gear.radius_a * lambda[0]);
    add(gear.b, tooth, -gear.radius_b * lambda[0]);
  }

  void operator()(const Rack& rack) const {
    const Eigen::Vector2d along = turned(rack.direction, rack.rack.body);
    add(rack.pinion, -lambda[0] * along, -lambda[0] * rack.radius);
    add(place_on(rack.rack.body, position_of(rack.pinion, state.q)), lambda[0] * along,
        lambda[0] * rack.radius);
  }

  void operator()(const Driven& driven) const {
    switch (driven.coordinate) {
      case Coordinate::x: return add(driven.point, {-lambda[0], 0.0}, 0.0);
      case Coordinate::y: return add(driven.point, {0.0, -lambda[0]}, 0.0);
      case Coordinate::angle:
        add(driven.point, {0.0, 0.0}, -lambda[0]);
        return add(driven.other, {0.0, 0.0}, lambda[0]);
      case Coordinate::length: return add_between(driven.point, driven.other);
    }
  }
};

}  // namespace boxbeam::planar
