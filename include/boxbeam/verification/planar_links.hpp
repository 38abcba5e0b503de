#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/elastic_joint.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam {

/// A rod without mass that stretches, a joint that keeps or drives the distance of two points.
struct ElasticLine {
  std::string joint;
  double EA = 0.0;           ///< [N]
  double retardation = 0.0;  ///< [s]
};

/// The verified beam as an elastic body of a planar mechanism, and what is elastic with it.
struct ElasticBody {
  int body = planar::ground;
  double centre = 0.0;  ///< distance of its centre of mass from its start, along its axis [m]
  double length = 0.0;  ///< [m]
  std::vector<flexible::LinkStretch> stretches;
  double retardation = 0.0;  ///< [s]
  int parts = 8;
  double angle = 0.0;  ///< of its axis in the body's axes [rad]
  flexible::LinkKind kind = flexible::LinkKind::full;
  bool between_pins = false;             ///< a rod that nothing bends but its own mass
  planar::BeamBody laid_out = {};        ///< of those beside: its mass along its axis
  std::vector<ElasticBody> beside = {};  ///< other beams of the mechanism, and rods that are bodies
  std::vector<ElasticLine> lines = {};
  std::vector<planar::ElasticJoint> joints = {};

  /// Whether the beam alone is elastic.
  bool alone() const { return beside.empty() && lines.empty() && joints.empty(); }
  /// The same where nothing vibrates: rods between pins stay straight, for how these bow is felt by
  /// nothing else, and whether they buckle is their own check.
  ElasticBody with_straight_rods() const;
  /// A place of the body, from its centre of mass in its axes, from the start of its axis.
  Eigen::Vector2d on_axis(const Eigen::Vector2d& p) const;
};

/// The elastic body of this index, that of the beam or one beside it; null: it is rigid.
const ElasticBody* elastic_at(const ElasticBody& elastic, int body);

/// Why small elastic motions of a mechanism about its postures cannot be described by elastic
/// links: the gearbox that couples two turns by a ratio, by name; "" where they can.
std::string obstacle_to_links(const planar::Mechanism& mechanism);

/// With more bodies nothing is computed of its elasticity: the work grows with the third power of
/// their number.
inline constexpr std::size_t most_elastic_bodies = 50;
bool has_too_many_bodies(const planar::Mechanism& mechanism);

/// A planar mechanism stopped in a posture: every body a rigid link of the same index with its
/// mass, elastic ones full links; behind them come the elastic lines in their order, links along
/// their axis between pins, and behind these toothed wheels on elastic links; joints without play
/// and drivers held. Springs and dampers between points count along their line, with the length
/// that they have. No loads and no weight: what the rigid motion asks for is not part of it.
/// Toothed wheels and racks are joints without play along the pitch line, at the pitch point.
/// Left out: dry friction, whose size does not change with the speed of sliding (beyond the creep
/// velocity, within which it damps; what its change with the pressure makes is of the order of its
/// coefficient times the vibration), and what forces that are there add to the stiffness across
/// their line (of the order of the force over the one that buckles). Precondition: no obstacle.
flexible::Mechanism links_of(const planar::Mechanism& mechanism, const planar::State& state,
                             const ElasticBody& elastic);

/// What an elastic joint does to its first body in the rigid motion where it holds, along the axes
/// of the joint of the links and about it; these turn with one of its bodies. [N, N, N m]
Eigen::Vector3d force_in(const planar::Mechanism& mechanism, const planar::State& state,
                         const ElasticBody& elastic, const planar::ElasticJoint& of);

}  // namespace boxbeam
