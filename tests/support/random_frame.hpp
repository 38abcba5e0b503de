#pragma once

#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/statics.hpp"

namespace test {

/// Numbers for a property of RapidCheck.
struct Dice {
  double between(double low, double high) const {
    return low + (high - low) * *rc::gen::resize(100, rc::gen::inRange(0, 1001)) / 1000.0;
  }
  int upto(int last) const { return *rc::gen::resize(100, rc::gen::inRange(0, last + 1)); }
  bool one_in(int count) const { return upto(count - 1) == 0; }
};

/// Frames and loads of any kind, held so that nothing can move: a tree of members, each joined to
/// one before it, and what a joint leaves free is held at a support of the member. Solid, round and
/// doubly symmetric box sections.
class RandomFrame {
 public:
  RandomFrame(bool plane, bool tapered) : tapered_(tapered) {
    of.plane = plane;
    of.gravity = 9.81 * direction();
    const int count = 1 + dice_.upto(5);
    for (int m = 0; m < count; ++m) add_member(m);
    const int more = dice_.upto(2);
    for (int k = 0; k < more; ++k) add_support(dice_.upto(count - 1), any_hold());
  }

  boxbeam::frame::ActingLoads loads() const {
    using namespace boxbeam::frame;
    ActingLoads acting;
    acting.weight = dice_.one_in(2) ? dice_.between(-1.5, 1.5) : 0.0;
    const auto pick = [&] { return dice_.upto(static_cast<int>(of.members.size()) - 1); };
    for (int k = dice_.upto(2); k > 0; --k) {
      const int member = pick();
      acting.points.push_back({"force", {place_on(member), 2e4 * vector(), 1e4 * turn_vector()}});
    }
    for (int k = dice_.upto(2); k > 0; --k) {
      LineAction line{pick(), 0.0, 0.0, 5e3 * vector(), 5e3 * vector()};
      line.from = station(line.member, 0.0, 0.6);
      line.to = station(line.member, 0.7, 1.0);
      acting.lines.push_back(line);
    }
    if (dice_.one_in(2)) {
      acting.heat.push_back({pick(), dice_.between(-40.0, 40.0),
                             of.plane ? 0.0 : dice_.between(-200.0, 200.0),
                             dice_.between(-200.0, 200.0)});
    }
    if (dice_.one_in(2)) {
      const int joint = dice_.upto(static_cast<int>(of.joints.size()) - 1);
      acting.settlements.push_back({joint, 0.005 * vector(), 0.002 * turn_vector()});
    }
    return acting;
  }

  /// A place of a member for a load, often where something else is.
  boxbeam::frame::Place place_on(int member) const {
    std::vector<double> special = used_[static_cast<std::size_t>(member)];
    special.insert(special.end(), {0.0, length_of(member)});
    for (const auto& segment : of.members[static_cast<std::size_t>(member)].beam.segments)
      special.push_back(segment.end().value());
    const int which = dice_.upto(static_cast<int>(special.size()) - 1);
    const double s =
        dice_.one_in(3) ? special[static_cast<std::size_t>(which)] : station(member, 0.0, 1.0);
    return {member, {s, of.plane ? 0.0 : dice_.between(-0.2, 0.2), dice_.between(-0.2, 0.2)}};
  }

  boxbeam::frame::Structure of;

 private:
  static constexpr double rigid = std::numeric_limits<double>::infinity();

  Eigen::Vector3d vector() const {
    return {dice_.between(-1.0, 1.0), dice_.between(-1.0, 1.0),
            of.plane ? 0.0 : dice_.between(-1.0, 1.0)};
  }
  Eigen::Vector3d turn_vector() const {
    if (of.plane) return {0.0, 0.0, dice_.between(-1.0, 1.0)};
    return vector();
  }
  Eigen::Vector3d direction() const {
    const Eigen::Vector3d v = vector();
    return v.norm() > 0.1 ? Eigen::Vector3d(v.normalized()) : Eigen::Vector3d(0.0, -1.0, 0.0);
  }
  /// Turned anyhow, in the plane about z.
  Eigen::Matrix3d axes() const {
    if (dice_.one_in(4)) return Eigen::Matrix3d::Identity();
    const Eigen::Vector3d about = of.plane ? Eigen::Vector3d::UnitZ() : direction();
    return Eigen::AngleAxisd(dice_.between(-3.0, 3.0), about).toRotationMatrix();
  }

  double length_of(int member) const {
    return of.members[static_cast<std::size_t>(member)].beam.length().value();
  }
  double station(int member, double low, double high) const {
    return dice_.between(low, high) * length_of(member);
  }

  boxbeam::Section section(int kind) const {
    using boxbeam::Length;
    using boxbeam::si;
    const auto m = [](double x) { return si<Length>(x); };
    if (kind == 0)
      return {boxbeam::Plate{m(dice_.between(0.05, 0.2)), m(dice_.between(0.05, 0.3))}, {}};
    if (kind == 1)
      return {boxbeam::RoundTube{m(dice_.between(0.1, 0.3)), m(dice_.between(0.005, 0.02))}, {}};
    return {boxbeam::symmetric_box(m(dice_.between(0.1, 0.4)), m(dice_.between(0.1, 0.6)),
                                   m(dice_.between(0.006, 0.02)), m(dice_.between(0.006, 0.02))),
            {}};
  }

  void add_member(int m) {
    using namespace boxbeam;
    frame::Member& member = of.members.emplace_back();
    member.name = "member " + std::to_string(m + 1);
    member.beam.density = si<Density>(dice_.one_in(5) ? 0.0 : 7850.0);
    double start = 0.0;
    for (int k = dice_.upto(3); k >= 0; --k) {
      const int kind = dice_.upto(2);
      const Section from = section(kind);
      Section to = from;
      if (tapered_) {
        to = section(kind);
        // The torsion of boxes kinks where the ratio of thicknesses passes an entry of a table.
        if (auto* box = std::get_if<Box>(&to.outer)) {
          const Box& first = std::get<Box>(from.outer);
          *box = symmetric_box(box->width, box->height, first.top_flange, first.left_web);
        }
      }
      const double length = dice_.between(0.4, 3.0);
      member.beam.segments.push_back({"", si<Length>(start), si<Length>(length), from, to});
      start += length;
    }
    member.axes = axes();
    if (of.plane)
      member.axes =
          member.axes * Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX());
    if (of.plane) clean(member.axes);
    used_.emplace_back();
    if (m == 0) {
      member.start = 3.0 * vector();
      add_support(m, firm());
      return;
    }
    // Its place meets one of a member before it.
    frame::Joint joint;
    joint.name = "joint " + std::to_string(m);
    const int other = dice_.upto(m - 1);
    const double ends[] = {0.0, 0.37, 1.0};
    joint.a = {other, {ends[dice_.upto(2)] * length_of(other), 0.0, 0.0}};
    joint.b = {m, {ends[dice_.upto(2)] * length_of(m), 0.0, 0.0}};
    if (dice_.one_in(3)) {
      joint.a.p.tail<2>() =
          Eigen::Vector2d(of.plane ? 0.0 : dice_.between(-0.3, 0.3), dice_.between(-0.3, 0.3));
      joint.b.p.z() = dice_.between(-0.3, 0.3);
    }
    member.start = frame::in_world(of, joint.a) - member.axes * joint.b.p;
    joint.axes = axes();
    joint.stiffness.fill(rigid);
    const int kind = dice_.upto(3);
    if (kind == 1) joint.stiffness[5] = 0.0;                                            // a hinge
    if (kind == 2) joint.stiffness[3] = joint.stiffness[4] = joint.stiffness[5] = 0.0;  // a ball
    if (kind == 3) joint.stiffness = any_hold();
    of.joints.push_back(joint);
    used_[static_cast<std::size_t>(other)].push_back(joint.a.p.x());
    used_.back().push_back(joint.b.p.x());
    if (kind > 0) add_support(m, firm());
  }

  /// Turned about x by a quarter: exactly.
  static void clean(Eigen::Matrix3d& axes) {
    for (int k = 0; k < 9; ++k) {
      if (std::abs(axes(k)) < 1e-15) axes(k) = 0.0;
    }
  }

  double spring() const { return std::pow(10.0, dice_.between(5.0, 8.0)); }

  std::array<double, 6> any_hold() const {
    std::array<double, 6> hold{};
    for (double& k : hold) k = dice_.one_in(3) ? rigid : dice_.one_in(2) ? spring() : 0.0;
    return hold;
  }
  /// Nothing is free.
  std::array<double, 6> firm() const {
    std::array<double, 6> hold{};
    for (double& k : hold) k = dice_.one_in(2) ? rigid : spring();
    return hold;
  }

  /// Where no other is.
  void add_support(int member, const std::array<double, 6>& hold) {
    std::vector<double>& used = used_[static_cast<std::size_t>(member)];
    double s = dice_.one_in(4) ? 0.0 : station(member, 0.0, 1.0);
    const double close = 0.02 * length_of(member);
    const auto taken = [&](double other) { return std::abs(other - s) < close; };
    while (std::any_of(used.begin(), used.end(), taken))
      s = std::fmod(s + 1.3 * close, length_of(member));
    boxbeam::frame::Joint joint;
    joint.name = "support " + std::to_string(of.joints.size() + 1);
    joint.a = {member, {s, of.plane ? 0.0 : dice_.between(-0.2, 0.2), dice_.between(-0.2, 0.2)}};
    joint.b.p = boxbeam::frame::in_world(of, joint.a);
    joint.axes = axes();
    joint.stiffness = hold;
    of.joints.push_back(joint);
    used.push_back(s);
  }

  Dice dice_;
  bool tapered_;
  std::vector<std::vector<double>> used_;  ///< stations of joints, by member
};

}  // namespace test
