#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/statics.hpp"

/// Beams at rest in the plane, for tests of `frame`: x along them, y up, without shear deformation
/// unless asked for.
namespace test {

inline constexpr double rigid = std::numeric_limits<double>::infinity();
inline constexpr std::array<double, 6> fixed{rigid, rigid, rigid, rigid, rigid, rigid};
inline constexpr std::array<double, 6> pinned{rigid, rigid, rigid, 0.0, 0.0, 0.0};
inline constexpr std::array<double, 6> roller{0.0, rigid, 0.0, 0.0, 0.0, 0.0};

/// A solid section b wide and h high.
inline boxbeam::Section solid(double b, double h) {
  return {boxbeam::Plate{boxbeam::si<boxbeam::Length>(b), boxbeam::si<boxbeam::Length>(h)}, {}};
}

inline boxbeam::Segment segment(double start, double length, const boxbeam::Section& from,
                                const boxbeam::Section& to) {
  return {"", boxbeam::si<boxbeam::Length>(start), boxbeam::si<boxbeam::Length>(length), from, to};
}

/// A member along x from the origin, z up.
inline boxbeam::frame::Member level_member(const std::vector<boxbeam::Segment>& segments) {
  boxbeam::frame::Member member;
  member.name = "beam";
  member.beam.segments = segments;
  member.axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  member.shear_modulus = 1e30;
  return member;
}

/// One member in the plane, without load cases but one.
inline boxbeam::frame::Structure level_frame(const std::vector<boxbeam::Segment>& segments) {
  boxbeam::frame::Structure of;
  of.members.push_back(level_member(segments));
  of.plane = true;
  of.cases.resize(1);
  of.factors = {1.0};
  return of;
}

inline void support(boxbeam::frame::Structure& of, double s, const std::array<double, 6>& held,
                    int member = 0) {
  boxbeam::frame::Joint joint;
  joint.name = "support " + std::to_string(of.joints.size() + 1);
  joint.a = {member, {s, 0.0, 0.0}};
  joint.b.p = boxbeam::frame::in_world(of, joint.a);
  joint.stiffness = held;
  of.joints.push_back(joint);
}

template <class Kind>
void act(boxbeam::frame::Structure& of, const Kind& kind) {
  of.cases[0].actions.push_back({"load", kind});
}

inline boxbeam::frame::PointAction push(double s, double up, double couple = 0.0) {
  return {{0, {s, 0.0, 0.0}}, {0.0, up, 0.0}, {0.0, 0.0, couple}};
}

inline boxbeam::frame::LineAction uniform(double from, double to, double up) {
  return {0, from, to, {0.0, up, 0.0}, {0.0, up, 0.0}};
}

/// Solved at the start of the time.
struct AtRest {
  explicit AtRest(const boxbeam::frame::Structure& structure)
      : of(structure), statics(of), equilibrium(statics.solve(acting_at(of, 0.0))) {}

  /// Upwards on the beam.
  double reaction(std::size_t joint) const { return equilibrium.joints[joint].y(); }
  /// M_y; positive puts the upper side in tension.
  double moment(double s) const {
    return equilibrium.members[0].cut.at({boxbeam::si<boxbeam::Length>(s)}).M_y.value();
  }
  /// Of the sections, upwards.
  double rise(double s) const { return statics.motion_at(0, s, equilibrium).y(); }

  boxbeam::frame::Structure of;
  boxbeam::frame::Statics statics;
  boxbeam::frame::Equilibrium equilibrium;
};

}  // namespace test
