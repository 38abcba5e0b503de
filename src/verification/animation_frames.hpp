#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/animation.hpp"

/// Instants of an animation: how many show its motion, and what is where in them.
namespace boxbeam {

/// Steps of an animation at most.
inline constexpr std::size_t most_frames = 3840;

/// The poses of all bodies at instants, the ground behind them.
using FramePoses = std::vector<std::vector<BodyPose>>;
using FramesAt = std::function<FramePoses(const std::vector<double>&)>;

/// An animation in the making: all but the motion.
struct StillScene {
  Animation animation;
  std::vector<std::pair<spatial::Attachment, spatial::Attachment>> rods;  ///< in their order
  int seen_from = spatial::ground;

  void add_rod(const std::string& name, const spatial::Attachment& a,
               const spatial::Attachment& b) {
    animation.rods.push_back({name, {}, a, b});
    rods.emplace_back(a, b);
    for (const spatial::Attachment& end : {a, b}) {
      if (end.body == spatial::ground) animation.joints.push_back({name, end});
    }
  }
};

/// The motion at so many evenly divided instants, doubled until they show it or 3841 are not
/// enough, in the last of which they are not; whether they show it.
bool take_motion(StillScene& scene, double begin, double length, std::size_t steps,
                 const FramesAt& frames_at);

/// The same for a whole motion. Throws AnalysisError where so many instants do not show it.
Animation animated(StillScene scene, const TimeSpan& span, const FramesAt& frames_at);

/// One more instant, in its place among the others.
void add_instant(StillScene& scene, double time, const FramesAt& frames_at);

/// The box around what is drawn at an instant of an animation.
Eigen::AlignedBox3d box_at(const Animation& animation, std::size_t instant);

/// The longest side of a box, a metre of an empty one [m].
double longest_side(const Eigen::AlignedBox3d& box);

}  // namespace boxbeam
