#include "boxbeam/mechanism/spatial/beam_loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace boxbeam::spatial {
namespace {

bool is_constant(const Driver& driver) {
  const DriverTiming timing = timing_of(driver, false);
  return timing.repeats && timing.omegas.empty();
}

/// The body nearest to the ground that joints without motion hold to this one.
int first_held_with(const Mechanism& mechanism, int body) {
  while (body != ground) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(body)];
    if (joint.kind != JointKind::fixed && (!is_driven(joint) || !is_constant(joint.driver))) break;
    body = joint.parent;
  }
  return body;
}

/// A place in beam axes; of the beam's own body without the way round by the world, which would
/// leave round-off that changes over time.
Eigen::Vector3d in_beam(const BeamPlacement& placement, const State& state, const Attachment& at) {
  if (at.body == placement.body) return in_beam(placement, at.p);
  const BodyMotion& own = state.bodies[static_cast<std::size_t>(placement.body)];
  return in_beam(placement, own.R_WB.transpose() * (position_of(state, at) - own.position));
}

/// Where a joint takes hold of the body that carries it: one that slides where the carried body has
/// its point.
Attachment place_on_carrier(const Mechanism& mechanism, std::size_t i) {
  const Joint& joint = mechanism.joints[i];
  switch (joint.kind) {
    case JointKind::prismatic:
    case JointKind::screw: return {static_cast<int>(i), joint.point};
    case JointKind::fixed:
    case JointKind::revolute: break;
  }
  return {joint.parent, joint.at};
}

/// Where a closing joint takes hold of its body a: where b has its place, if it slides along a.
Attachment place_on_a(const ClosingJoint& joint) {
  switch (joint.kind) {
    case ClosingKind::prismatic:
    case ClosingKind::cylindrical:
    case ClosingKind::planar:
    case ClosingKind::slot:
    case ClosingKind::screw: return joint.b;
    case ClosingKind::gear:
    case ClosingKind::rack: return place_of(joint);
    case ClosingKind::fixed:
    case ClosingKind::revolute:
    case ClosingKind::universal:
    case ClosingKind::spherical:
    case ClosingKind::distance: break;
  }
  return joint.a;
}

/// Calls f(name, place, joint, sign) for the joints that take hold of the beam's body: their index
/// among the wrenches of all joints, and 1 where the wrench is that on this body.
template <class Function>
void each_hold(const Mechanism& mechanism, int own, const Function& f) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == own) f(joint.name, Attachment{own, joint.point}, i, 1.0);
    if (joint.parent == own) f(joint.name, place_on_carrier(mechanism, i), i, -1.0);
  }
  for (std::size_t k = 0; k < mechanism.closing.size(); ++k) {
    const ClosingJoint& joint = mechanism.closing[k];
    const std::size_t i = mechanism.joints.size() + k;
    if (joint.b.body == own) f(joint.name, place_of(joint), i, 1.0);
    if (joint.a.body == own) f(joint.name, place_on_a(joint), i, -1.0);
  }
}

/// Calls f(spring, place, sign) for the torsion springs at the beam's body, 1 where their couple is
/// that on this body.
template <class Function>
void each_torsion_spring(const Mechanism& mechanism, int own, const Function& f) {
  for (const TorsionSpring& spring : mechanism.torsion_springs) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(spring.joint)];
    if (spring.joint == own) f(spring, Attachment{own, joint.point}, 1.0);
    if (joint.parent == own) f(spring, Attachment{own, joint.at}, -1.0);
  }
}

/// Calls f(name, place) for what acts at a point of the beam's body, in the order of its loads.
template <class Function>
void each_place(const Mechanism& mechanism, int own, const Function& f) {
  each_hold(
      mechanism, own,
      [&](const std::string& name, const Attachment& at, std::size_t, double) { f(name, at); });
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on == own) f(load.name, load.at);
  }
  for (const Spring& spring : mechanism.springs) {
    for (const Attachment& end : {spring.a, spring.b})
      if (end.body == own) f(spring.name, end);
  }
  each_torsion_spring(
      mechanism, own,
      [&](const TorsionSpring& spring, const Attachment& at, double) { f(spring.name, at); });
}

}  // namespace

Eigen::Vector3d in_beam(const BeamPlacement& placement, const Eigen::Vector3d& in_body) {
  return placement.axes.transpose() * (in_body - placement.start);
}

void give_mass(Body& body, const BeamPlacement& placement, const TaperedBeam& beam) {
  const MassProperties properties = mass_properties_of(beam);
  body.mass = properties.mass.value();
  body.centre = placement.start + properties.centre.value() * placement.axes.col(0);
  body.inertia = placement.axes * properties.tensor * placement.axes.transpose();
}

State open_state_of(const Mechanism& mechanism) {
  const Tree tree(mechanism);
  State state;
  tree.drive(state, 0.0);
  tree.move(state);
  return state;
}

namespace {

/// Where the loops stand is of no matter: only what holds together is compared.
std::vector<LastingPlace> lasting_places_in(const State& state, const Mechanism& mechanism,
                                            const BeamPlacement& placement) {
  const int held_with = first_held_with(mechanism, placement.body);
  std::vector<LastingPlace> places;
  each_place(mechanism, placement.body, [&](const std::string& name, const Attachment& at) {
    if (first_held_with(mechanism, at.body) != held_with) return;
    places.push_back({name, in_beam(placement, state, at)});
  });
  return places;
}

}  // namespace

std::vector<LastingPlace> lasting_places_of(const Mechanism& mechanism,
                                            const BeamPlacement& placement) {
  return lasting_places_in(open_state_of(mechanism), mechanism, placement);
}

std::vector<Eigen::Vector3d> holds_of(const Mechanism& mechanism, int body) {
  // Whether a body is the other one or carried by it.
  const auto is_beyond = [&](int of, int carrier) {
    while (of > carrier) of = mechanism.joints[static_cast<std::size_t>(of)].parent;
    return of == carrier;
  };
  std::vector<Eigen::Vector3d> places{mechanism.joints[static_cast<std::size_t>(body)].point};
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (mechanism.joints[i].parent != body) continue;
    const auto leaves_here = [&](const ClosingJoint& joint) {
      if (has_teeth(joint.kind)) return false;
      const int child = static_cast<int>(i);
      return is_beyond(joint.a.body, child) != is_beyond(joint.b.body, child);
    };
    if (std::any_of(mechanism.closing.begin(), mechanism.closing.end(), leaves_here))
      places.push_back(mechanism.joints[i].at);
  }
  for (const ClosingJoint& joint : mechanism.closing) {
    if (has_teeth(joint.kind)) continue;
    if (joint.a.body == body) places.push_back(joint.a.p);
    if (joint.b.body == body) places.push_back(joint.b.p);
  }
  return places;
}

namespace {

/// Where teeth that mesh with the beam's body stand along its axis, while it turns about that.
std::vector<Length> meshed_places_in(const State& state, const Mechanism& mechanism,
                                     const BeamPlacement& placement) {
  std::vector<Length> places;
  const Joint& joint = mechanism.joints[static_cast<std::size_t>(placement.body)];
  const Eigen::Vector3d axis = joint.turn.transpose() * joint.axis;
  if (axis.cross(placement.axes.col(0)).norm() > 1e-9) return places;
  for (const ClosingJoint& closing : mechanism.closing) {
    if (!has_teeth(closing.kind)) continue;
    if (closing.a.body != placement.body && closing.b.body != placement.body) continue;
    places.push_back(si<Length>(in_beam(placement, state, place_of(closing)).x()));
  }
  return places;
}

}  // namespace

BeamBody beam_body_of(const TaperedBeam& beam, const BeamPlacement& placement,
                      const Mechanism& mechanism) {
  return beam_body_of(beam, placement, mechanism, open_state_of(mechanism));
}

BeamBody beam_body_of(const TaperedBeam& beam, const BeamPlacement& placement,
                      const Mechanism& mechanism, const State& open) {
  BeamBody body{placement, &beam, mass_distribution_of(beam), places_of(beam)};
  const Length end = body.places.back();
  std::vector<Length> lasting = meshed_places_in(open, mechanism, placement);
  for (const LastingPlace& place : lasting_places_in(open, mechanism, placement))
    lasting.push_back(si<Length>(place.at.x()));
  for (const Length& at : lasting) {
    const Length s = place_near(body.places, at);
    // Beyond the ends nothing is known of the beam; the last of the places is its length.
    if (s > Length{} && s < end) body.places.insert(body.places.end() - 1, s);
  }
  return body;
}

BeamLoads beam_loads_of(const Chain& chain, const State& state, const BeamBody& beam) {
  return beam_loads_of(chain, state, beam, chain.joint_wrenches(state));
}

BeamLoads beam_loads_of(const Chain& chain, const State& state, const BeamBody& beam,
                        const std::vector<Wrench>& joints) {
  const Mechanism& mechanism = chain.mechanism();
  const int own = beam.placement.body;
  const BodyMotion& motion = state.bodies[static_cast<std::size_t>(own)];
  const Eigen::Matrix3d R_WS = motion.R_WB * beam.placement.axes;

  BeamLoads loads;
  // Vectors in the world.
  const auto add = [&](std::string_view name, const Attachment& place, const Wrench& wrench) {
    const Eigen::Vector3d at = in_beam(beam.placement, state, place);
    PointLoad load;
    load.name = name;
    load.s = place_near(beam.places, si<Length>(at.x()));
    load.at = at.tail<2>();
    load.force = R_WS.transpose() * wrench.force;
    load.moment =
        R_WS.transpose() * wrench.moment + Eigen::Vector3d(0.0, at.y(), at.z()).cross(load.force);
    loads.points.push_back(load);
  };
  each_hold(mechanism, own,
            [&](const std::string& name, const Attachment& at, std::size_t i, double sign) {
              add(name, at, {sign * joints[i].force, sign * joints[i].moment});
            });
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on != own) continue;
    const Eigen::Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    const bool force = load.kind == LoadKind::force;
    add(load.name, load.at,
        force ? Wrench{vector, Eigen::Vector3d::Zero()} : Wrench{Eigen::Vector3d::Zero(), vector});
  }

  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    const Spring& spring = mechanism.springs[i];
    const Eigen::Vector3d force = force_of(mechanism, i, state);
    if (spring.b.body == own) add(spring.name, spring.b, {force, Eigen::Vector3d::Zero()});
    if (spring.a.body == own) add(spring.name, spring.a, {-force, Eigen::Vector3d::Zero()});
  }

  each_torsion_spring(mechanism, own,
                      [&](const TorsionSpring& spring, const Attachment& at, double sign) {
                        const Eigen::Vector3d couple = sign * couple_of(mechanism, spring, state);
                        add(spring.name, at, {Eigen::Vector3d::Zero(), couple});
                      });

  BeamMotion in_axes;
  in_axes.omega = R_WS.transpose() * motion.omega;
  in_axes.alpha = R_WS.transpose() * motion.alpha;
  in_axes.acceleration = R_WS.transpose() * acceleration_of(state, {own, beam.placement.start});
  loads.lines = weight_and_inertia(*beam.beam, beam.distribution,
                                   R_WS.transpose() * mechanism.gravity, in_axes);
  for (const LineForce& line : mechanism.line_forces) {
    if (line.on != own) continue;
    const Eigen::Vector3d force = driver_at(line.size, state.time).value *
                                  (R_WS.transpose() * in_world(state, line.axes, line.direction));
    const Eigen::Vector3d from = in_beam(beam.placement, line.from);
    const double one = from.x();
    const double other = in_beam(beam.placement, line.to).x();
    const Eigen::Vector3d couple = Eigen::Vector3d(0.0, from.y(), from.z()).cross(force);
    for (LineLoad& stretch : loads.lines) {
      const double middle = (stretch.start + 0.5 * stretch.length).value();
      if (middle < std::min(one, other) || middle > std::max(one, other)) continue;
      add_from_outside(force, force, stretch);
      for (int axis = 0; axis < 3; ++axis)
        stretch.couple[static_cast<std::size_t>(axis)].c[0] += couple[axis];
    }
  }
  return loads;
}

}  // namespace boxbeam::spatial
