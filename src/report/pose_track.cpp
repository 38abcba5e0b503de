#include "boxbeam/report/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam::report {
namespace {

using Numbers = std::array<long, 7>;

Numbers in_steps(const BodyPose& pose, const PoseSteps& steps, const Eigen::Vector4d& before) {
  Eigen::Vector4d turn = Eigen::Quaterniond(pose.axes).normalized().coeffs();
  if (turn.dot(before) < 0.0)
    turn = -turn;  // the same turn, by the shorter way from the one before
  Numbers of{};
  for (Eigen::Index i = 0; i < 3; ++i)
    of[static_cast<std::size_t>(i)] = std::lround(pose.origin[i] / steps.place);
  for (Eigen::Index i = 0; i < 4; ++i)
    of[static_cast<std::size_t>(i + 3)] = std::lround(turn[i] / steps.turn);
  return of;
}

Eigen::Vector3d place_in(const Numbers& numbers, const PoseSteps& steps) {
  return steps.place * Eigen::Vector3d(static_cast<double>(numbers[0]),
                                       static_cast<double>(numbers[1]),
                                       static_cast<double>(numbers[2]));
}

Eigen::Vector4d turn_in(const Numbers& numbers, const PoseSteps& steps) {
  return steps.turn *
         Eigen::Vector4d(static_cast<double>(numbers[3]), static_cast<double>(numbers[4]),
                         static_cast<double>(numbers[5]), static_cast<double>(numbers[6]));
}

Eigen::Isometry3d pose_between(const Numbers& from, const Numbers& to, const PoseSteps& steps,
                               double part) {
  const Eigen::Vector4d turn_from = turn_in(from, steps);
  Eigen::Vector4d turn_to = turn_in(to, steps);
  if (turn_to.dot(turn_from) < 0.0) turn_to = -turn_to;
  const Eigen::Vector4d turn = (1.0 - part) * turn_from + part * turn_to;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  pose.translation() = (1.0 - part) * place_in(from, steps) + part * place_in(to, steps);
  return pose;
}

double part_between(double from, double to, double at) {
  return to > from ? std::clamp((at - from) / (to - from), 0.0, 1.0) : 0.0;
}

}  // namespace

Eigen::Isometry3d pose_at(const PoseTrack& track, const PoseSteps& steps,
                          const std::vector<double>& times, double time) {
  const auto behind = std::find_if(track.keys.begin(), track.keys.end(),
                                   [&](std::size_t key) { return times[key] > time; });
  const auto next = static_cast<std::size_t>(behind - track.keys.begin());
  const std::size_t to = std::min(next, track.keys.size() - 1);
  const std::size_t from = next == 0 ? 0 : next - 1;
  return pose_between(track.poses[from], track.poses[to], steps,
                      part_between(times[track.keys[from]], times[track.keys[to]], time));
}

PoseTrack track_of(const std::vector<double>& times, const std::vector<BodyPose>& poses,
                   const Eigen::AlignedBox3d& room, const PoseSteps& steps, double tolerance,
                   std::optional<std::size_t> also) {
  std::vector<Numbers> all;
  Eigen::Vector4d before = Eigen::Quaterniond::Identity().coeffs();
  for (const BodyPose& pose : poses) {
    all.push_back(in_steps(pose, steps, before));
    before = turn_in(all.back(), steps);
  }
  const auto astray = [&](std::size_t k, const Eigen::Isometry3d& shown) {
    double worst = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d p = room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      worst = std::max(worst, (shown * p - poses[k].origin - poses[k].axes * p).norm());
    }
    return worst;
  };
  std::vector<bool> is_key(poses.size(), false);
  is_key.front() = is_key.back() = true;
  if (also) is_key[*also] = true;
  // Halves of which the worst instant between their ends is not yet known.
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, poses.size() - 1}};
  if (also) open = {{0, *also}, {*also, poses.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t split = from;
    for (std::size_t k = from + 1; k < to; ++k) {
      const double off = astray(k, pose_between(all[from], all[to], steps,
                                                part_between(times[from], times[to], times[k])));
      if (off <= worst) continue;
      worst = off;
      split = k;
    }
    if (split == from) continue;
    is_key[split] = true;
    open.emplace_back(from, split);
    open.emplace_back(split, to);
  }
  PoseTrack track;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (!is_key[k]) continue;
    track.keys.push_back(k);
    track.poses.push_back(all[k]);
  }
  return track;
}

}  // namespace boxbeam::report
