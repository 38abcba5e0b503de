#include "verdict_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "boxbeam/project/project.hpp"

namespace boxbeam {
namespace {

/// How a support holds a frame.
enum class UpwardsHold { otherwise, roller, pin };

/// A fork holds about the member's axis beside that.
UpwardsHold holding_of(const frame::Joint& joint, bool plane) {
  const auto held = [&](std::size_t from) {
    return std::count_if(joint.stiffness.begin() + static_cast<std::ptrdiff_t>(from),
                         joint.stiffness.begin() + static_cast<std::ptrdiff_t>(from + 3),
                         [](double k) { return k > 0.0; });
  };
  if (held(3) > (plane ? 0 : 1)) return UpwardsHold::otherwise;
  return held(0) == 1 ? UpwardsHold::roller : UpwardsHold::pin;
}

/// The axis of the world nearest to what is upwards, and its sense there.
struct Upwards {
  std::size_t axis = 0;
  double sense = 1.0;
};

Upwards upwards_of(const frame::Structure& frame, const std::vector<MotionSummary>& motions) {
  Upwards up{frame.plane ? 1U : 2U, 1.0};
  if (!frame.gravity.isZero(0.0)) {
    Eigen::Index axis = 0;
    frame.gravity.cwiseAbs().maxCoeff(&axis);
    return {static_cast<std::size_t>(axis), frame.gravity[axis] > 0.0 ? -1.0 : 1.0};
  }
  // Of each situation the supports bear together what is least and what is largest of them.
  double most = 0.0;
  for (const MotionSummary& motion : motions) {
    double sum = 0.0;
    for (const SupportReaction& of : motion.reactions) sum += of.low[up.axis] + of.high[up.axis];
    if (std::abs(sum) > std::abs(most)) most = sum;
  }
  if (most < 0.0) up.sense = -1.0;
  return up;
}

}  // namespace

std::vector<NotJudged> lifted_supports_of(const Project& project,
                                          const std::vector<MotionSummary>& motions) {
  const auto* const frame = std::get_if<frame::Structure>(&project.mechanism);
  if (frame == nullptr) return {};
  const Upwards up = upwards_of(*frame, motions);
  double largest = 0.0;
  std::map<std::string, std::array<double, 2>> pulls_and_pushes;
  for (const MotionSummary& motion : motions) {
    for (const SupportReaction& of : motion.reactions) {
      auto& [pulls, pushes] = pulls_and_pushes[of.name];
      for (std::size_t k = 0; k < 3; ++k)
        largest = std::max({largest, std::abs(of.low[k]), std::abs(of.high[k])});
      for (const double force : {of.low[up.axis], of.high[up.axis]}) {
        pulls = std::max(pulls, -up.sense * force);
        pushes = std::max(pushes, up.sense * force);
      }
    }
  }
  constexpr double counts = 1e-3;
  const double least = counts * largest;
  const bool on_rollers =
      std::any_of(frame->joints.begin(), frame->joints.end(), [&](const frame::Joint& joint) {
        return joint.b.member == frame::ground &&
               holding_of(joint, frame->plane) == UpwardsHold::roller;
      });
  std::vector<std::string> lifted;
  for (const frame::Joint& joint : frame->joints) {
    const auto of = pulls_and_pushes.find(joint.name);
    if (of == pulls_and_pushes.end() || of->second[0] <= least) continue;
    const UpwardsHold holding = holding_of(joint, frame->plane);
    // A hinge that only ever pulls, or of a frame without rollers, is made for it.
    const bool lies = holding == UpwardsHold::pin && on_rollers && of->second[1] > least;
    if (lies || holding == UpwardsHold::roller)
      lifted.push_back(fmt::format("{} by {:.4g} kN", joint.name, 1e-3 * of->second[0]));
  }
  if (lifted.empty()) return {};
  return {{Criterion::yield, lifted.size() == 1 ? "a support that pulls" : "supports that pull",
           fmt::format("taken to hold the frame down: {}; what only lies there lifts off, and the "
                       "rest bears more",
                       fmt::join(lifted, ", "))}};
}

}  // namespace boxbeam
