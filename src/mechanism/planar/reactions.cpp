#include "boxbeam/mechanism/planar/reactions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

Eigen::Vector2d left_of(const Eigen::Vector2d& vector) { return {-vector.y(), vector.x()}; }

double angle_of(int body, const Eigen::VectorXd& q) {
  return body == ground ? 0.0 : q[3 * static_cast<Eigen::Index>(body) + 2];
}

/// Collects the reactions of one joint; `lambda` are its own multipliers.
struct Collector {
  const State& state;
  std::vector<Reaction>& reactions;
  int joint;
  const double* lambda;
  const FrictionContact* contact;

  void add(const Attachment& at, const Eigen::Vector2d& force, double moment) const {
    if (at.body != ground) reactions.push_back({joint, at.body, force, moment, at.p});
  }

  /// Where a place of the world is on a body.
  Attachment place_on(int body, const Eigen::Vector2d& place) const {
    if (body == ground) return {};
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body);
    return {body, Eigen::Rotation2Dd(-state.q[i + 2]) * (place - state.q.segment<2>(i))};
  }

  Eigen::Vector2d turned(double angle, int body) const {
    const double direction = angle + angle_of(body, state.q);
    return {std::cos(direction), std::sin(direction)};
  }

  /// A point pushed across a line of another body, along it by friction, and turned by a moment.
  template <class Slide>
  void add_sliding(const Slide& slide, double moment) const {
    const Eigen::Vector2d along = turned(slide.direction, slide.guide.body);
    Eigen::Vector2d force = -lambda[0] * left_of(along);
    if (contact != nullptr) {
      force += friction_force_of(*contact, state.lambda,
                                 sliding_velocity_of(*contact, state.q, state.v)) *
               along;
    }
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
        lambda[0] * (gear.radius_a + gear.radius_b) / between.squaredNorm() * left_of(between);
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

}  // namespace

std::vector<Reaction> reactions_of(const Mechanism& mechanism, const State& state) {
  std::vector<Reaction> reactions;
  reactions.reserve(2 * mechanism.joints.size());
  const std::vector<FrictionContact> contacts = friction_contacts_of(mechanism);
  auto contact = contacts.begin();
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const bool rubs = contact != contacts.end() && contact->joint == static_cast<int>(i);
    std::visit(Collector{state, reactions, static_cast<int>(i), state.lambda.data() + row,
                         rubs ? &*contact : nullptr},
               joint.kind);
    if (rubs) ++contact;
    row += equations_of(joint);
  }
  return reactions;
}

std::vector<Reaction> reactions_per_joint(const Mechanism& mechanism, const State& state,
                                          int preferred) {
  std::vector<Reaction> chosen;
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (chosen.empty() || chosen.back().joint != reaction.joint) {
      chosen.push_back(reaction);
    } else if (reaction.on == preferred) {
      chosen.back() = reaction;
    }
  }
  return chosen;
}

}  // namespace boxbeam::planar
