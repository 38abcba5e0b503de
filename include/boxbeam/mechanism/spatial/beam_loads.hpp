#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"

namespace boxbeam::spatial {

/// Where the verified beam lies in its body.
struct BeamPlacement {
  int body = ground;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< of the axis, body axes [m]
  /// R_BS: columns are the beam's x (along the axis), y and z in body axes.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// A place in beam axes, from the beam's start.
Eigen::Vector3d in_beam(const BeamPlacement& placement, const Eigen::Vector3d& in_body);

/// Gives the beam's body the mass properties of the beam; a body has no other mass.
void give_mass(Body& body, const BeamPlacement& placement, const TaperedBeam& beam);

/// Where a joint or a load stands on the beam's body, in beam axes [m], while the mechanism moves:
/// its own points, and those of bodies that joints without motion hold to it.
struct LastingPlace {
  std::string name;  ///< of the joint or load
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

std::vector<LastingPlace> lasting_places_of(const Mechanism& mechanism,
                                            const BeamPlacement& placement);

/// Where a body is held, in its axes: by the joint that carries it, by closing joints on it, and by
/// joints of bodies that it carries and that loops hold. Teeth push, and are not counted.
std::vector<Eigen::Vector3d> holds_of(const Mechanism& mechanism, int body);

/// The rigid body that is the verified beam.
struct BeamBody {
  BeamPlacement placement;
  const TaperedBeam* beam = nullptr;
  std::vector<SegmentMass> distribution;
  /// Of the beam, and under what lasts on it off its axis: a load within round-off of one stands
  /// there, so that its jump keeps its place over time.
  std::vector<Length> places;
};

BeamBody beam_body_of(const TaperedBeam& beam, const BeamPlacement& placement,
                      const Mechanism& mechanism);
/// The same of one of many bodies, with `open_state_of` the mechanism.
BeamBody beam_body_of(const TaperedBeam& beam, const BeamPlacement& placement,
                      const Mechanism& mechanism, const State& open);

/// All bodies at t = 0 with the loops as open as they may be: what joints without motion hold
/// together stands together.
State open_state_of(const Mechanism& mechanism);

/// Loads on the beam at an instant: what its joints and the loads on it do, its line forces, and
/// its own weight and inertia per length. What acts off the axis acts at its projection on it, with
/// its moment.
/// Precondition: line forces on the beam's body lie along its axis or beside it at one distance,
/// between ends of segments.
BeamLoads beam_loads_of(const Chain& chain, const State& state, const BeamBody& beam);
/// The same of one of many bodies, with `joint_wrenches` of the chain.
BeamLoads beam_loads_of(const Chain& chain, const State& state, const BeamBody& beam,
                        const std::vector<Wrench>& joints);

}  // namespace boxbeam::spatial
