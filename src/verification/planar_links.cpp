#include "boxbeam/verification/planar_links.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A stopped mechanism while it is made.
struct StoppedMechanism {
  const planar::Mechanism& mechanism;
  const planar::State& state;
  const ElasticBody& elastic;
  flexible::Mechanism* added;  ///< lines that stretch and wheels of elastic links, with what holds
                               ///< them
  double angle_of(int body) const {
    return body == planar::ground ? 0.0 : state.q[3 * static_cast<Eigen::Index>(body) + 2];
  }

  Eigen::Vector2d place_of(const planar::Attachment& at) const {
    return planar::position_of(at, state.q);
  }

  /// Elastic links begin where their beams do, others at their centres.
  flexible::Attachment on_link(const planar::Attachment& at) const {
    const ElasticBody* bends = elastic_at(elastic, at.body);
    return {at.body, bends != nullptr ? bends->on_axis(at.p) : at.p};
  }

  /// The place of a body that is at a place of the world.
  flexible::Attachment on_link_at(int body, const Eigen::Vector2d& world) const {
    if (body == planar::ground) return {flexible::ground, world};
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body);
    const double c = std::cos(state.q[i + 2]);
    const double s = std::sin(state.q[i + 2]);
    const Eigen::Vector2d d = world - state.q.segment<2>(i);
    return on_link({body, {c * d.x() + s * d.y(), -s * d.x() + c * d.y()}});
  }

  /// Direction from one place to another; 0 where they are the same.
  double direction_between(const planar::Attachment& a, const planar::Attachment& b) const {
    const Eigen::Vector2d d = place_of(b) - place_of(a);
    return d.norm() > 0.0 ? std::atan2(d.y(), d.x()) : 0.0;
  }

  flexible::Joint held(const planar::Attachment& a, const planar::Attachment& b, double angle,
                       const std::array<double, 3>& stiffness) const {
    flexible::Joint joint;
    joint.a = on_link(a);
    joint.b = on_link(b);
    joint.angle = angle;
    joint.stiffness = stiffness;
    return joint;
  }

  flexible::Joint guided(const planar::Attachment& point, const planar::Attachment& guide,
                         double direction, double viscous, double turning) const {
    flexible::Joint joint;
    joint.a = on_link(point);
    joint.b = on_link_at(guide.body, place_of(point));
    joint.angle = angle_of(guide.body) + direction;
    joint.stiffness = {0.0, infinite, turning};
    joint.damping = {viscous, 0.0, 0.0};
    return joint;
  }

  /// Where a toothed wheel has its pitch point. On an elastic link it is a rigid body without mass
  /// on the section at its hub, for what lies under its teeth bends freely.
  flexible::Attachment on_wheel(const planar::Attachment& hub,
                                const Eigen::Vector2d& pitch_point) const {
    if (elastic_at(elastic, hub.body) == nullptr) return on_link_at(hub.body, pitch_point);
    flexible::Link wheel;
    wheel.name = "wheel";
    wheel.kind = flexible::LinkKind::rigid;
    wheel.origin = place_of(hub);
    const auto index = static_cast<int>(mechanism.bodies.size() + added->links.size());
    flexible::Joint fixed;
    fixed.name = "hub";
    fixed.a = on_link(hub);
    fixed.b = {index, Eigen::Vector2d::Zero()};
    fixed.stiffness = {infinite, infinite, infinite};
    const Eigen::Vector2d arm = pitch_point - wheel.origin;
    added->links.push_back(std::move(wheel));
    added->joints.push_back(std::move(fixed));
    return {index, arm};
  }

  /// Teeth in mesh at a place move alike along the pitch line.
  static flexible::Joint meshed(const flexible::Attachment& a, const flexible::Attachment& b,
                                double line) {
    flexible::Joint joint;
    joint.a = a;
    joint.b = b;
    joint.angle = line;
    joint.stiffness = {infinite, 0.0, 0.0};
    return joint;
  }

  flexible::Joint of(const planar::Pin& pin) const {
    return held(pin.a, pin.b, 0.0, {infinite, infinite, 0.0});
  }
  flexible::Joint of(const planar::Slider& slider) const {
    return guided(slider.point, slider.guide, slider.direction, slider.friction.viscous, infinite);
  }
  flexible::Joint of(const planar::PinInSlot& slot) const {
    return guided(slot.point, slot.guide, slot.direction, slot.friction.viscous, 0.0);
  }
  flexible::Joint of(const planar::Rigid& rigid) const {
    return held(rigid.a, rigid.b, 0.0, {infinite, infinite, infinite});
  }
  flexible::Joint of(const planar::Distance& rod) const { return kept_apart(rod.a, rod.b); }
  flexible::Joint kept_apart(const planar::Attachment& a, const planar::Attachment& b) const {
    return held(a, b, direction_between(a, b), {infinite, 0.0, 0.0});
  }
  flexible::Joint of(const planar::AngleCoupling& coupling) const {
    return held(coupling.a, coupling.b, 0.0, {0.0, 0.0, infinite});
  }
  flexible::Joint of(const planar::Gear& gear) const {
    const Eigen::Vector2d a = place_of(gear.a);
    const Eigen::Vector2d apart = place_of(gear.b) - a;
    const Eigen::Vector2d pitch = a + gear.radius_a / (gear.radius_a + gear.radius_b) * apart;
    return meshed(on_wheel(gear.a, pitch), on_wheel(gear.b, pitch),
                  std::atan2(apart.x(), -apart.y()));
  }
  flexible::Joint of(const planar::Rack& rack) const {
    const double direction = angle_of(rack.rack.body) + rack.direction;
    const Eigen::Vector2d left(-std::sin(direction), std::cos(direction));
    const Eigen::Vector2d pitch = place_of(rack.pinion) - rack.radius * left;
    return meshed(on_wheel(rack.pinion, pitch), on_link_at(rack.rack.body, pitch), direction);
  }

  flexible::Joint of(const planar::Driven& driven) const {
    const planar::Attachment& a = driven.point;
    const planar::Attachment here{planar::ground, place_of(a)};
    switch (driven.coordinate) {
      case planar::Coordinate::x: return held(a, here, 0.0, {infinite, 0.0, 0.0});
      case planar::Coordinate::y: return held(a, here, 0.0, {0.0, infinite, 0.0});
      case planar::Coordinate::angle: return held(a, driven.other, 0.0, {0.0, 0.0, infinite});
      case planar::Coordinate::length: return kept_apart(a, driven.other);
    }
    return {};
  }

  flexible::Joint of(const planar::Spring& spring) const {
    flexible::Joint joint = held(spring.a, spring.b, direction_between(spring.a, spring.b),
                                 {spring.stiffness, 0.0, 0.0});
    joint.damping = {spring.damping, 0.0, 0.0};
    return joint;
  }
  flexible::Joint of(const planar::TorsionSpring& spring) const {
    flexible::Joint joint = held(spring.a, spring.b, 0.0, {0.0, 0.0, spring.stiffness});
    joint.damping = {0.0, 0.0, spring.damping};
    return joint;
  }
};

flexible::Link link_of(const StoppedMechanism& posture, std::size_t index) {
  const Body& body = posture.mechanism.bodies[index];
  const Eigen::Index i = 3 * static_cast<Eigen::Index>(index);
  flexible::Link link;
  link.name = body.name;
  link.origin = posture.state.q.segment<2>(i);
  link.angle = posture.state.q[i + 2];
  const ElasticBody* bends = elastic_at(posture.elastic, static_cast<int>(index));
  if (bends == nullptr) {
    link.kind = flexible::LinkKind::rigid;
    link.rigid = {body.mass, Eigen::Vector2d::Zero(), body.inertia};
    return link;
  }
  const ElasticBody& elastic = *bends;
  link.kind = elastic.kind;
  link.angle += elastic.angle;
  link.origin -= elastic.centre * Eigen::Vector2d(std::cos(link.angle), std::sin(link.angle));
  link.length = elastic.length;
  link.stretches = elastic.stretches;
  link.retardation = elastic.retardation;
  link.parts = elastic.parts;
  return link;
}

/// A line that stretches between its ends, which its second end holds by a pin; the first one
/// follows.
flexible::Joint stretched_line(const StoppedMechanism& posture, const ElasticLine& line,
                               const planar::Joint& joint, int index) {
  const auto [a, b] = planar::ends_of(joint);
  flexible::Link& link = posture.added->links.emplace_back();
  link.name = joint.name;
  link.kind = flexible::LinkKind::axial;
  link.parts = 1;
  link.retardation = line.retardation;
  link.origin = posture.place_of(a);
  link.angle = posture.direction_between(a, b);
  constexpr double no_length = 1e-9;  // a driven one may pass it
  link.length = std::max(no_length, (posture.place_of(b) - link.origin).norm());
  flexible::LinkStretch& stretch = link.stretches.emplace_back();
  stretch.length = link.length;
  stretch.EA.c[0] = line.EA;
  const auto pin_to = [&](const planar::Attachment& end, double s) {
    flexible::Joint pin;
    pin.name = joint.name;
    pin.a = posture.on_link(end);
    pin.b = {index, {s, 0.0}};
    pin.stiffness = {infinite, infinite, 0.0};
    return pin;
  };
  posture.added->joints.push_back(pin_to(b, link.length));
  return pin_to(a, 0.0);
}

/// A joint of the mechanism that gives way.
flexible::Joint giving_way(const StoppedMechanism& posture, const planar::ElasticJoint& of) {
  const planar::Joint& rigid = posture.mechanism.joints[static_cast<std::size_t>(of.joint)];
  flexible::Joint joint =
      std::visit([&](const auto& kind) { return posture.of(kind); }, rigid.kind);
  // Where it holds in both directions its axes are of no matter but that they turn with a body.
  if (joint.stiffness[0] > 0.0 && joint.stiffness[1] > 0.0)
    joint.angle = posture.angle_of(joint.a.link != flexible::ground ? joint.a.link : joint.b.link);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (joint.stiffness[axis] == 0.0) continue;
    joint.stiffness[axis] = axis < 2 ? of.stiffness : of.turning_stiffness;
    joint.damping[axis] = axis < 2 ? of.damping : of.turning_damping;
  }
  return joint;
}

}  // namespace

Eigen::Vector3d force_in(const planar::Mechanism& mechanism, const planar::State& state,
                         const ElasticBody& elastic, const planar::ElasticJoint& of) {
  flexible::Mechanism added;
  const flexible::Joint joint = giving_way({mechanism, state, elastic, &added}, of);
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const planar::Reaction& reaction : planar::reactions_of(mechanism, state)) {
    if (reaction.joint != of.joint) continue;
    const double sign = reaction.on == joint.a.link ? 1.0 : -1.0;
    force.head<2>() = sign * (Eigen::Rotation2Dd(-joint.angle) * reaction.force);
    force[2] = sign * reaction.moment;
    break;
  }
  for (const std::size_t axis : {0U, 1U, 2U})
    if (joint.stiffness[axis] == 0.0) force[static_cast<Eigen::Index>(axis)] = 0.0;
  return force;
}

ElasticBody ElasticBody::with_straight_rods() const {
  ElasticBody straight = *this;
  for (ElasticBody& other : straight.beside)
    if (other.between_pins) other.kind = flexible::LinkKind::axial;
  return straight;
}

Eigen::Vector2d ElasticBody::on_axis(const Eigen::Vector2d& p) const {
  return Eigen::Rotation2Dd(-angle) * p + Eigen::Vector2d(centre, 0.0);
}

const ElasticBody* elastic_at(const ElasticBody& elastic, int body) {
  if (body == elastic.body) return &elastic;
  for (const ElasticBody& other : elastic.beside)
    if (body == other.body) return &other;
  return nullptr;
}

std::string obstacle_to_links(const planar::Mechanism& mechanism) {
  for (const planar::Joint& joint : mechanism.joints) {
    const auto* coupling = std::get_if<planar::AngleCoupling>(&joint.kind);
    if (coupling != nullptr && coupling->ratio != 1.0) return joint.name;
  }
  return "";
}

bool has_too_many_bodies(const planar::Mechanism& mechanism) {
  return mechanism.bodies.size() > most_elastic_bodies;
}

flexible::Mechanism links_of(const planar::Mechanism& mechanism, const planar::State& state,
                             const ElasticBody& elastic) {
  flexible::Mechanism added;
  const StoppedMechanism posture{mechanism, state, elastic, &added};
  flexible::Mechanism links;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    links.links.push_back(link_of(posture, i));
  }
  const auto add = [&](flexible::Joint joint, const std::string& name) {
    joint.name = name;
    if (joint.a.link == flexible::ground && joint.b.link == flexible::ground) return;
    links.joints.push_back(std::move(joint));
  };
  std::vector<bool> made(mechanism.joints.size(), false);
  for (const ElasticLine& line : elastic.lines) {
    const auto at = static_cast<std::size_t>(planar::joint_index(mechanism, line.joint));
    const auto index = static_cast<int>(mechanism.bodies.size() + added.links.size());
    add(stretched_line(posture, line, mechanism.joints[at], index), line.joint);
    made[at] = true;
  }
  for (const planar::ElasticJoint& of : elastic.joints) {
    const auto at = static_cast<std::size_t>(of.joint);
    add(giving_way(posture, of), mechanism.joints[at].name);
    made[at] = true;
  }
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    if (made[i]) continue;
    add(std::visit([&](const auto& kind) { return posture.of(kind); }, joint.kind), joint.name);
  }
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    const planar::AppliedForce& force = mechanism.forces[i];
    if (std::holds_alternative<planar::Spring>(force.kind)) {
      const std::optional<planar::Spring> acting = planar::spring_in(mechanism, state, i);
      if (acting) add(posture.of(*acting), force.name);
    } else if (const auto* torsion = std::get_if<planar::TorsionSpring>(&force.kind)) {
      add(posture.of(*torsion), force.name);
    }
  }
  links.links.insert(links.links.end(), added.links.begin(), added.links.end());
  links.joints.insert(links.joints.end(), added.joints.begin(), added.joints.end());
  return links;
}

}  // namespace boxbeam
