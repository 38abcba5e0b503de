#include "animation_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"

namespace boxbeam {
namespace {

using DrawnStroke = PostureFigure::Stroke;

constexpr std::size_t fewest_frames = 60;

Eigen::Vector3d place_in_frame(const std::vector<BodyPose>& poses, const spatial::Attachment& at) {
  const BodyPose& pose =
      at.body == spatial::ground ? poses.back() : poses[static_cast<std::size_t>(at.body)];
  return pose.origin + pose.axes * at.p;
}

/// Bodies and ground as one of them sees them.
void turn_into_axes_of(std::size_t body, std::vector<BodyPose>& poses) {
  const BodyPose seen_from = poses[body];
  const Eigen::Matrix3d turn = seen_from.axes.transpose();
  for (BodyPose& pose : poses) {
    pose = {turn * (pose.origin - seen_from.origin), turn * pose.axes,
            turn * (pose.omega - seen_from.omega)};
  }
}

/// Whether the straight line and the even turn from each instant to the next but one pass through
/// the one between, and no step between these is too large a turn.
bool leads_through(const FramePoses& frames, double step, double size) {
  constexpr double astray = 0.01, turned_astray = 0.02, largest_turn = 0.5 * std::numbers::pi;
  for (std::size_t k = 0; k + 2 < frames.size(); k += 2) {
    // The ground, which may be far away from what it is seen from, does not count.
    for (std::size_t i = 0; i + 1 < frames[k].size(); ++i) {
      const BodyPose &from = frames[k][i], &middle = frames[k + 1][i], &to = frames[k + 2][i];
      // By its rate, too: a whole turn from one instant to the next is none to be seen.
      const double rate = std::max({from.omega.norm(), middle.omega.norm(), to.omega.norm()});
      const Eigen::Vector3d turn = spatial::turn_of(from.axes.transpose() * to.axes);
      if (std::max(rate * step, turn.norm()) > largest_turn) return false;
      const Eigen::Matrix3d half_way = from.axes * spatial::rotation_about(0.5 * turn);
      if ((0.5 * (from.origin + to.origin) - middle.origin).norm() > astray * size) return false;
      if (spatial::turn_of(half_way.transpose() * middle.axes).norm() > turned_astray) return false;
    }
  }
  return true;
}

/// The box around what is drawn at an instant, of bodies and rods.
Eigen::AlignedBox3d box_around(
    const Animation& animation, const std::vector<BodyPose>& poses,
    const std::vector<std::pair<spatial::Attachment, spatial::Attachment>>& rods) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < animation.bodies.size(); ++i) {
    const auto take = [&](const Eigen::Vector3d& p) {
      box.extend(place_in_frame(poses, {static_cast<int>(i), p}));
    };
    for (const Eigen::Vector3d& point : animation.bodies[i].drawn.points) take(point);
    for (const DrawnStroke& stroke : animation.bodies[i].drawn.strokes) {
      take(stroke.from);
      take(stroke.to);
    }
  }
  for (const auto& [a, b] : rods) {
    box.extend(place_in_frame(poses, a));
    box.extend(place_in_frame(poses, b));
  }
  return box;
}

}  // namespace

double longest_side(const Eigen::AlignedBox3d& box) {
  return box.isEmpty() ? 1.0 : std::max(box.sizes().maxCoeff(), 1e-3);
}

bool take_motion(StillScene& scene, double begin, double length, std::size_t steps,
                 const FramesAt& frames_at) {
  Animation& of = scene.animation;
  const auto times_of = [&](std::size_t parts) {
    std::vector<double> times;
    for (std::size_t i = 0; i <= parts; ++i)
      times.push_back(begin + length * static_cast<double>(i) / static_cast<double>(parts));
    return times;
  };
  for (;; steps *= 2) {
    FramePoses frames = frames_at(times_of(2 * steps));
    const bool turned = scene.seen_from != spatial::ground;
    for (std::vector<BodyPose>& poses : frames) {
      poses.emplace_back();
      if (turned) turn_into_axes_of(static_cast<std::size_t>(scene.seen_from), poses);
    }
    of.size = longest_side(box_around(of, frames.front(), scene.rods));
    const bool shown = leads_through(frames, length / static_cast<double>(steps), of.size);
    if (!shown && 2 * steps <= most_frames) continue;
    of.times = times_of(steps);
    for (std::size_t k = 0; k < frames.size(); k += 2) {
      for (std::size_t i = 0; i < of.bodies.size(); ++i) of.bodies[i].poses.push_back(frames[k][i]);
      if (turned) of.ground.push_back(frames[k].back());
      for (std::size_t i = 0; i < of.rods.size(); ++i) {
        of.rods[i].ends.push_back({place_in_frame(frames[k], scene.rods[i].first),
                                   place_in_frame(frames[k], scene.rods[i].second)});
      }
    }
    return shown;
  }
}

Animation animated(StillScene scene, const TimeSpan& span, const FramesAt& frames_at) {
  constexpr double waves_apart = 16.0;
  const double wanted = waves_apart * std::ceil(span.highest_omega * span.length / full_turn);
  const auto steps = static_cast<std::size_t>(
      std::clamp(wanted, static_cast<double>(fewest_frames), static_cast<double>(most_frames)));
  if (!take_motion(scene, span.begin, span.length, steps, frames_at)) {
    throw AnalysisError({fmt::format("{} instants do not show the motion, which lasts {:.6g} s: "
                                     "ask for less of it, [motion] duration",
                                     most_frames + 1, span.length),
                         "mechanism"});
  }
  return std::move(scene.animation);
}

void add_instant(StillScene& scene, double time, const FramesAt& frames_at) {
  Animation& of = scene.animation;
  const auto at = std::lower_bound(of.times.begin(), of.times.end(), time);
  if (at != of.times.end() && *at == time) return;
  const auto place = at - of.times.begin();
  std::vector<BodyPose> poses = frames_at({time}).front();
  poses.emplace_back();
  of.times.insert(at, time);
  for (std::size_t i = 0; i < of.bodies.size(); ++i)
    of.bodies[i].poses.insert(of.bodies[i].poses.begin() + place, poses[i]);
  for (std::size_t i = 0; i < of.rods.size(); ++i) {
    of.rods[i].ends.insert(
        of.rods[i].ends.begin() + place,
        {place_in_frame(poses, scene.rods[i].first), place_in_frame(poses, scene.rods[i].second)});
  }
}

Eigen::AlignedBox3d box_at(const Animation& animation, std::size_t instant) {
  std::vector<BodyPose> poses;
  for (const AnimatedBody& body : animation.bodies) poses.push_back(body.poses[instant]);
  Eigen::AlignedBox3d box = box_around(animation, poses, {});
  for (const AnimatedRod& rod : animation.rods) {
    box.extend(rod.ends[instant].from);
    box.extend(rod.ends[instant].to);
  }
  return box;
}

}  // namespace boxbeam
