#include "boxbeam/mechanism/spatial/beam_loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace boxbeam::spatial {

Eigen::Vector3d in_beam(const BeamPlacement& placement, const Eigen::Vector3d& in_body) {
  return placement.axes.transpose() * (in_body - placement.start);
}

void give_mass(Body& body, const BeamPlacement& placement, const TaperedBeam& beam) {
  const MassProperties properties = mass_properties_of(beam);
  body.mass = properties.mass.value();
  body.centre = placement.start + properties.centre.value() * placement.axes.col(0);
  body.inertia = placement.axes * properties.tensor * placement.axes.transpose();
}

BeamBody beam_body_of(const TaperedBeam& beam, const BeamPlacement& placement) {
  return {placement, &beam, mass_distribution_of(beam), places_of(beam)};
}

BeamLoads beam_loads_of(const Chain& chain, const State& state, const BeamBody& beam) {
  const Mechanism& mechanism = chain.mechanism();
  const int own = beam.placement.body;
  const BodyMotion& motion = state.bodies[static_cast<std::size_t>(own)];
  const Eigen::Matrix3d R_WS = motion.R_WB * beam.placement.axes;

  BeamLoads loads;
  // Place and vectors in the world.
  const auto add = [&](const Eigen::Vector3d& place, const Wrench& wrench) {
    const Eigen::Vector3d in_body = motion.R_WB.transpose() * (place - motion.position);
    const Eigen::Vector3d at = in_beam(beam.placement, in_body);
    PointLoad load;
    load.s = place_near(beam.places, si<Length>(at.x()));
    load.force = R_WS.transpose() * wrench.force;
    load.moment =
        R_WS.transpose() * wrench.moment + Eigen::Vector3d(0.0, at.y(), at.z()).cross(load.force);
    loads.points.push_back(load);
  };
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const Eigen::Vector3d place = position_of(state, {static_cast<int>(i), joint.point});
    if (static_cast<int>(i) == own) add(place, joints[i]);
    if (joint.parent == own) add(place, {-joints[i].force, -joints[i].moment});
  }
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on != own) continue;
    const Eigen::Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    const bool force = load.kind == LoadKind::force;
    add(position_of(state, load.at),
        force ? Wrench{vector, Eigen::Vector3d::Zero()} : Wrench{Eigen::Vector3d::Zero(), vector});
  }

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
    const double one = in_beam(beam.placement, line.from).x();
    const double other = in_beam(beam.placement, line.to).x();
    for (LineLoad& stretch : loads.lines) {
      const double middle = (stretch.start + 0.5 * stretch.length).value();
      if (middle < std::min(one, other) || middle > std::max(one, other)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        stretch.force[static_cast<std::size_t>(axis)].c[0] += force[axis];
      }
    }
  }
  return loads;
}

std::vector<std::string> names_of_beam_loads(const Mechanism& mechanism, int beam_body) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == beam_body || joint.parent == beam_body) names.push_back(joint.name);
  }
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on == beam_body) names.push_back(load.name);
  }
  return names;
}

}  // namespace boxbeam::spatial
