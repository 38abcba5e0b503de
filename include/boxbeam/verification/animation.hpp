#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/posture.hpp"

/// How a mechanism moves, for those who look at it.
namespace boxbeam {

namespace spatial {
class Chain;
}

/// What is drawn of a body, in its axes [m].
struct DrawnBody {
  std::vector<Eigen::Vector3d> points;         ///< joints and named points, each place once
  std::vector<PostureFigure::Stroke> strokes;  ///< from its joint, or the axis of the beam, to them
};

DrawnBody drawn_body_of(const Project& project, const spatial::Mechanism& mechanism, int body);
/// In the plane, whose z is zero.
DrawnBody drawn_body_of(const Project& project, const planar::Mechanism& mechanism, int body);

/// How a body stands at an instant.
struct BodyPose {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< in the plane its centre of mass [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();     ///< [rad/s]
};

/// A body over the instants of an animation.
struct AnimatedBody {
  std::string name;
  bool has_mass = true;  ///< else it only carries others
  DrawnBody drawn;
  std::vector<BodyPose> poses;
  /// The shape of a member of a frame, along x of its axes, or of the verified beam in a page, as
  /// `Animation::beam` places it.
  std::optional<TaperedBeam> member = {};
};

/// Where a joint is, on a body or the ground.
struct AnimatedJoint {
  std::string name;
  spatial::Attachment at;
};

/// What stretches between two places without being a body: a rod, a cylinder, a spring.
struct AnimatedRod {
  std::string name;
  std::vector<PostureFigure::Stroke> ends;  ///< at each instant [m]
  spatial::Attachment a, b;                 ///< where they are fixed
};

/// A mechanism over the time that is looked at, from its begin to its end, in the axes of the world
/// or as it is seen from one of its bodies.
struct Animation {
  std::vector<double> times;  ///< ascending, evenly but for one more of `AnimatedSpan` [s]
  bool z_up = true;           ///< whether z of the world is up, in space; else y, in the plane
  double size = 1.0;          ///< longest side of the box around bodies and rods at the begin [m]
  std::vector<AnimatedBody> bodies;
  /// How the ground stands; empty where it stays, in the axes of the world.
  std::vector<BodyPose> ground;
  std::vector<AnimatedJoint> joints;
  std::vector<AnimatedRod> rods;
  spatial::BeamPlacement beam;  ///< of the verified beam; on the ground where it is no body
  /// Whether places are counted from the joint that carries the beam, which travels with it all.
  bool follows = false;
  bool resolved = true;  ///< whether between two instants nothing moves otherwise than evenly
};

/// The box around bodies and rods over all instants, the axis of the beam among them [m].
Eigen::AlignedBox3d room_of(const Animation& animation);

/// The mechanism of a case, at 61 instants or more: sixteen to every wave of the fastest driver or
/// force, at most 3841; doubled until no body turns by more than 90 degrees from one to the next,
/// and stands half-way between two, within 1 % of the mechanism's size and 2/100 rad, where the
/// straight line and the even turn between them lead. `seen_from`: a body that stays where it is
/// while all else moves about it, in space; "" or "world" for none. Throws InputError where there
/// is no such body or nothing moves through instants, AnalysisError where the motion cannot be
/// followed, its length is not known, or 3841 instants are not enough.
Animation animation_of(const Project& project, const std::string& seen_from = "");

/// What is looked at of a motion.
struct AnimatedSpan {
  double begin = 0.0, length = 0.0;  ///< [s]
  std::size_t steps = 96;            ///< at least; doubled as `animation_of` does
  std::optional<double> also = {};   ///< an instant that is shown as it is, too [s]
};

/// A mechanism in space whose motion is known, whole or, where it travels over more than four times
/// its own size, as it is seen from the joint that carries the beam, without what it leaves behind.
/// Not resolved where 3841 instants are not enough.
Animation scene_of(const Project& project, const spatial::Chain& chain, const AnimatedSpan& span);

}  // namespace boxbeam
