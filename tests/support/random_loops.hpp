#pragma once

#include <optional>

#include "boxbeam/mechanism/spatial/tree.hpp"
#include "support/random_tree.hpp"

/// Closed loops in space by chance, from a seed.
namespace test {

/// Chains by chance, each from the second body of the one before: the end of the first is joined to
/// the ground and those of the others to the fourth body of the one before, closed at t = 0 where
/// the coordinates are those of their starts; in each as many joints are free as its joint has
/// equations.
/// `always`: the kind of those joints, where it is not by chance.
inline boxbeam::spatial::Mechanism random_loops(
    Chance& chance, std::optional<boxbeam::spatial::ClosingKind> always = {}, int chains = 2) {
  using namespace boxbeam;
  using namespace boxbeam::spatial;
  using Eigen::Vector3d;
  constexpr int chain = 8;
  Mechanism mechanism = random_tree(chance, chains * chain);
  mechanism.line_forces.clear();  // the balance does not know them
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    Joint& joint = mechanism.joints[i];
    const int number = static_cast<int>(i);
    joint.parent = number > 0 && number % chain == 0 ? number - chain + 1 : number - 1;
    if (joint.kind == JointKind::fixed) joint.kind = JointKind::revolute;
    joint.start = chance.any(joint.kind == JointKind::revolute ? 2.0 : 0.5);
    joint.driver = HarmonicDriver{joint.start, chance.any(0.05), 3.0 + chance.any(2.0), 0.0, {}};
  }
  const Tree tree(mechanism);
  State state;
  state.coordinates.resize(mechanism.joints.size());
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    state.coordinates[i].value = driver_at(mechanism.joints[i].driver, 0.0).value;
  tree.move(state);
  for (int i = 0; i < 3; ++i) {
    const int a = chance.one_of(chains * chain + 1) - 1;
    const int b = (a + 1 + chance.one_of(chains * chain - 1)) % (chains * chain);
    if (a == b) continue;
    const double stiffness = 50.0 + chance.any(40.0), length = 2.0 + chance.any();
    const double damping = 5.0 + chance.any(4.0);
    mechanism.springs.push_back({"spring",
                                 {a, chance.vector()},
                                 {b, chance.vector()},
                                 stiffness,
                                 length,
                                 damping,
                                 static_cast<Spring::Acts>(i)});
  }
  for (int first = 0; first < chains * chain; first += chain) {
    constexpr int equations_of[] = {6, 5, 5, 4, 4, 3, 3, 2, 1, 5};  // in the order of the kinds
    ClosingJoint joint;
    joint.name = "closing";
    joint.kind = static_cast<ClosingKind>(chance.one_of(9));
    if (always) joint.kind = *always;
    joint.lead = first / chain % 2 == 0 ? 0.5 : -2.0;
    const int a = first == 0 ? ground : first - chain + 3;
    const int b = first + chain - 1;
    joint.b = {b, chance.vector(0.5)};
    Vector3d place = position_of(state, joint.b);
    joint.axis = chance.direction();
    joint.turn = motion_of(state, a).R_WB.transpose() * motion_of(state, b).R_WB;
    joint.other = joint.turn.transpose() * joint.axis.cross(chance.direction()).normalized();
    if (joint.kind == ClosingKind::distance) {
      const Vector3d away = 1.5 * chance.direction();
      place += away;
      joint.length = HarmonicDriver{away.norm(), 0.05, 2.0, 0.0, {}};
    }
    joint.a = {a, in_axes(state, a, place - motion_of(state, a).position)};
    mechanism.closing.push_back(joint);
    for (int left = equations_of[static_cast<std::size_t>(joint.kind)]; left > 0;) {
      Joint& freed = mechanism.joints[static_cast<std::size_t>(first + chance.one_of(chain))];
      if (freed.moved_by == MovedBy::loops) continue;
      freed.moved_by = MovedBy::loops;
      --left;
    }
  }
  return mechanism;
}

}  // namespace test
