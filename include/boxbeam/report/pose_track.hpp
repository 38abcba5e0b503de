#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "boxbeam/verification/animation.hpp"

/// The motion of a body by few instants, for a page.
namespace boxbeam::report {

/// In how small steps places and turns are told.
struct PoseSteps {
  double place = 1e-4;  ///< [m]
  double turn = 1e-4;   ///< of a unit quaternion
};

/// Where a body stands at some instants, its keys, as multiples of `PoseSteps`: x, y, z of its
/// origin, x, y, z, w of its turn. Between two keys places lie on the straight line, and turns on
/// that of their quaternions made of unit length, on the side of the first.
struct PoseTrack {
  std::vector<std::size_t> keys;  ///< indices of instants, the first and the last among them
  std::vector<std::array<long, 7>> poses;
};

/// The pose of a body at a time of the instants.
Eigen::Isometry3d pose_at(const PoseTrack& track, const PoseSteps& steps,
                          const std::vector<double>& times, double time);

/// So few keys that no place of the body within `room`, in its axes, is farther than `tolerance`
/// from where it truly is, at none of the instants, steps included. A place of the body is an
/// affine function of its place in the room, so that the corners are the farthest off. `also`: an
/// instant that is a key in any case. Source of the choice: Douglas, Peucker, Cartographica 10
/// (1973). Where the steps alone lead farther astray than the tolerance every instant is a key.
PoseTrack track_of(const std::vector<double>& times, const std::vector<BodyPose>& poses,
                   const Eigen::AlignedBox3d& room, const PoseSteps& steps, double tolerance,
                   std::optional<std::size_t> also = {});

}  // namespace boxbeam::report
