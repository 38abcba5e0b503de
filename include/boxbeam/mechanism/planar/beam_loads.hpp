#pragma once

#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam::planar {

/// The rigid body that is a beam. Its mass, centre and inertia are those of `distribution`; its
/// centre of mass lies on the beam axis, which is its own x axis turned by `angle`.
struct BeamBody {
  int body = ground;
  const TaperedBeam* beam = nullptr;
  std::vector<SegmentMass> distribution;
  std::vector<Length> places;  ///< of the beam: a joint within round-off of one stands there
  double centre = 0.0;         ///< s of the centre of mass [m]
  double angle = 0.0;          ///< of the beam axis in body axes [rad]
};

BeamBody beam_body_of(const TaperedBeam& beam, int body);

/// World vector in beam axes: x along the axis, z its left normal, y into the plane.
Eigen::Vector3d in_beam_axes(const Eigen::Vector2d& world, double angle);

/// Loads on the beam at an instant, rigorously: the reactions of its joints, the forces
/// applied to it, and its own weight and inertia per length, along and across the axis. What acts
/// off the axis adds its couple.
BeamLoads beam_loads_of(const Mechanism& mechanism, const State& state, const BeamBody& beam);

}  // namespace boxbeam::planar
