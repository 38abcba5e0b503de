#include "joint_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace boxbeam::readers {
namespace {

using spatial::ClosingJoint;
using spatial::Mechanism;

/// The joint that carries each body. Notes bodies that no joint carries or that two carry.
std::vector<const JointDraft*> carriers_of(TableReader& root, const JointDrafts& drafts,
                                           const Mechanism& mechanism) {
  std::vector<const JointDraft*> carrier(mechanism.bodies.size(), nullptr);
  for (const JointDraft& draft : drafts.carrying) {
    if (draft.carried < 0) continue;
    const auto same_name = [&](const auto& other) { return other.name == draft.joint.name; };
    const auto alike =
        std::count_if(drafts.carrying.begin(), drafts.carrying.end(),
                      [&](const JointDraft& other) { return same_name(other.joint); }) +
        std::count_if(drafts.closing.begin(), drafts.closing.end(), same_name);
    if (alike > 1) {
      root.table("joints").problem(
          draft.joint.name, fmt::format("two joints are called \"{}\"", draft.joint.name),
          "a spherical joint \"ball\" is \"ball.1\", \"ball.2\" and \"ball.3\": give the other "
          "another name");
      return carrier;
    }
    const JointDraft*& of = carrier[static_cast<std::size_t>(draft.carried)];
    if (of != nullptr) {
      root.table("joints").problem(
          draft.joint.name.substr(0, draft.joint.name.find('.')),
          fmt::format("body \"{}\" is carried twice, by \"{}\" and by \"{}\"",
                      mechanism.bodies[static_cast<std::size_t>(draft.carried)].name,
                      of->joint.name, draft.joint.name),
          "one joint carries each body; write closes = true in the other, which closes a loop");
      return carrier;
    }
    of = &draft;
  }
  for (std::size_t i = 0; i < carrier.size(); ++i) {
    if (carrier[i] != nullptr) continue;
    root.table("bodies").problem(
        mechanism.bodies[i].name,
        fmt::format("no joint carries body \"{}\"", mechanism.bodies[i].name),
        "write a joint with connect = [\"ground\", ...] or [\"another body's point\", ...]");
    return carrier;
  }
  return carrier;
}

}  // namespace

bool sort_tree(TableReader& root, const JointDrafts& drafts, Mechanism& mechanism) {
  const std::size_t before = root.problems().size();
  const std::vector<const JointDraft*> carrier = carriers_of(root, drafts, mechanism);
  if (root.problems().size() != before) return false;
  const std::size_t count = mechanism.bodies.size();
  std::vector<int> place(count, -1);  // in the new order
  Mechanism sorted = mechanism;
  sorted.bodies.clear();
  sorted.joints.clear();
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < count; ++i) {
      const int parent = carrier[i]->joint.parent;
      if (place[i] >= 0 || (parent >= 0 && place[static_cast<std::size_t>(parent)] < 0)) continue;
      place[i] = static_cast<int>(sorted.bodies.size());
      sorted.bodies.push_back(mechanism.bodies[i]);
      sorted.joints.push_back(carrier[i]->joint);
      if (parent >= 0) sorted.joints.back().parent = place[static_cast<std::size_t>(parent)];
      more = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (place[i] >= 0) continue;
    root.table("joints").problem(
        carrier[i]->joint.name,
        fmt::format("body \"{}\" is carried by what it carries itself", mechanism.bodies[i].name),
        "the tree begins at the ground: one joint has connect = [\"ground\", ...], and the joint "
        "that closes the ring has closes = true");
    return false;
  }
  sorted.closing = drafts.closing;
  for (ClosingJoint& joint : sorted.closing) {
    for (spatial::Attachment* end : {&joint.a, &joint.b})
      if (end->body >= 0) end->body = place[static_cast<std::size_t>(end->body)];
  }
  sorted.springs = drafts.loose;
  for (spatial::Spring& ball : sorted.springs) {
    for (spatial::Attachment* end : {&ball.a, &ball.b})
      if (end->body >= 0) end->body = place[static_cast<std::size_t>(end->body)];
  }
  mechanism = std::move(sorted);
  return true;
}

}  // namespace boxbeam::readers
