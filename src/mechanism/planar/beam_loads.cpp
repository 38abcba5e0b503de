#include "boxbeam/mechanism/planar/beam_loads.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {

BeamBody beam_body_of(const TaperedBeam& beam, int body) {
  return {body, &beam, mass_distribution_of(beam), places_of(beam),
          mass_properties_of(beam).centre.value()};
}

Eigen::Vector3d in_beam_axes(const Eigen::Vector2d& world, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * world.x() + s * world.y(), 0.0, -s * world.x() + c * world.y()};
}

BeamLoads beam_loads_of(const Mechanism& mechanism, const State& state, const BeamBody& beam) {
  const Eigen::Index i = 3 * static_cast<Eigen::Index>(beam.body);
  const double angle = state.q[i + 2] + beam.angle;
  const double omega = state.v[i + 2];
  const double alpha = state.a[i + 2];

  BeamLoads loads;
  const Eigen::Rotation2Dd to_axis(-beam.angle);
  const auto add = [&](std::string_view name, const Eigen::Vector2d& at,
                       const Eigen::Vector2d& force, double moment) {
    const Eigen::Vector2d point = to_axis * at;
    PointLoad load;
    load.name = name;
    load.s = place_near(beam.places, si<Length>(beam.centre + point.x()));
    load.at.y() = point.y();
    load.force = in_beam_axes(force, angle);
    // y points into the plane: a counter-clockwise moment is negative about it.
    load.moment.y() = -moment + point.y() * load.force.x();
    loads.points.push_back(load);
  };
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (reaction.on != beam.body) continue;
    add(mechanism.joints[static_cast<std::size_t>(reaction.joint)].name, reaction.point,
        reaction.force, reaction.moment);
  }
  for (const AppliedLoad& load :
       applied_loads_of(mechanism, state.time, state.q, state.v, state.touches)) {
    if (load.on != beam.body) continue;
    add(mechanism.forces[static_cast<std::size_t>(load.force)].name, load.point, load.vector,
        load.moment);
  }

  // y points into the plane: counter-clockwise is negative about it.
  BeamMotion motion;
  motion.omega.y() = -omega;
  motion.alpha.y() = -alpha;
  motion.acceleration = in_beam_axes(state.a.segment<2>(i), angle) -
                        beam.centre * Eigen::Vector3d(-omega * omega, 0.0, alpha);
  loads.lines = weight_and_inertia(*beam.beam, beam.distribution,
                                   in_beam_axes(mechanism.gravity, angle), motion);
  // What keeps a plane mechanism in its plane is no part of it, and takes the couples that I_yz
  // gives out of the plane where they arise.
  for (LineLoad& line : loads.lines) line.couple[0] = line.couple[2] = {};
  return loads;
}

}  // namespace boxbeam::planar
