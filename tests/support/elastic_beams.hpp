#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <string>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "support/random_tree.hpp"

/// Elastic beams and mechanisms of them: uniform ones with textbook solutions, and any by chance
/// from a seed.
namespace test {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// A uniform bar. Without shear as it stands (Euler and Bernoulli), and without rotary inertia.
struct Bar {
  double L = 1.0;       ///< [m]
  double EA = 1.0;      ///< [N]
  double GA = 1e30;     ///< with the shear area [N]
  double EI = 1.0;      ///< [N m^2]
  double mass = 1.0;    ///< per length [kg/m]
  double rotary = 0.0;  ///< rho I [kg m]
};

/// A steel bar of rectangular section: h high, b wide, shear area 5/6 of the area. SI.
inline Bar steel_bar(double L, double h, double b) {
  const double E = 2.1e11, G = 8.1e10, rho = 7850.0;
  const double A = b * h, I = b * h * h * h / 12.0;
  return {L, E * A, G * A * 5.0 / 6.0, E * I, rho * A, rho * I};
}

inline boxbeam::flexible::Link link_of(const Bar& bar, int parts,
                                       boxbeam::flexible::LinkKind kind) {
  boxbeam::flexible::Link link;
  link.name = "beam";
  link.kind = kind;
  link.length = bar.L;
  link.parts = parts;
  boxbeam::flexible::LinkStretch stretch;
  stretch.length = bar.L;
  stretch.EA.c[0] = bar.EA;
  stretch.GA.c[0] = bar.GA;
  stretch.EI.c[0] = bar.EI;
  stretch.mass.c[0] = bar.mass;
  stretch.rotary.c[0] = bar.rotary;
  link.stretches = {stretch};
  if (kind == boxbeam::flexible::LinkKind::rigid) {
    link.stretches.clear();
    const double m = bar.mass * bar.L;
    link.rigid = {m, {bar.L / 2.0, 0.0}, m * bar.L * bar.L / 12.0 + bar.rotary * bar.L};
  }
  return link;
}

/// How an end of a beam is held.
enum class End { free, pinned, clamped };

/// A joint that holds a place of link 0's axis to the ground: rigid, in link axes.
inline boxbeam::flexible::Joint hold(const boxbeam::flexible::Mechanism& mechanism, double s,
                                     std::array<double, 3> stiffness, std::string name) {
  boxbeam::flexible::Joint joint;
  joint.name = std::move(name);
  joint.a = {0, {s, 0.0}};
  joint.b = {boxbeam::flexible::ground, boxbeam::flexible::in_world(mechanism, joint.a)};
  joint.angle = mechanism.links[0].angle;
  joint.stiffness = stiffness;
  return joint;
}

/// A beam along the world's x from its origin, held without give at its ends; along its axis at its
/// start only, unless that is free and then at its end. Not held along the axis where both are
/// free.
inline boxbeam::flexible::Mechanism beam_of(
    const Bar& bar, int parts, End start, End end, boxbeam::flexible::Element element,
    boxbeam::flexible::LinkKind kind = boxbeam::flexible::LinkKind::bending) {
  boxbeam::flexible::Mechanism mechanism;
  mechanism.element = element;
  mechanism.links = {link_of(bar, parts, kind)};
  const auto turn = [](End how) { return how == End::clamped ? infinite : 0.0; };
  if (start != End::free) {
    mechanism.joints.push_back(hold(mechanism, 0.0, {infinite, infinite, turn(start)}, "start"));
  }
  if (end != End::free) {
    const double along = start == End::free ? infinite : 0.0;
    mechanism.joints.push_back(hold(mechanism, bar.L, {along, infinite, turn(end)}, "end"));
  }
  return mechanism;
}

/// A beam clamped at its start.
inline boxbeam::flexible::Mechanism cantilever_of(
    const Bar& bar, int parts, boxbeam::flexible::Element element,
    boxbeam::flexible::LinkKind kind = boxbeam::flexible::LinkKind::bending) {
  return beam_of(bar, parts, End::clamped, End::free, element, kind);
}

inline boxbeam::flexible::Load load_at(double s, const Eigen::Vector3d& constant,
                                       const Eigen::Vector3d& amplitude = Eigen::Vector3d::Zero()) {
  return {"load", {0, {s, 0.0}}, constant, amplitude, 0.0};
}

/// A beam whose axis is that of a link of some length; its places are its ends.
inline boxbeam::TaperedBeam beam_of_length(double length) {
  using namespace boxbeam;
  const Section section{
      symmetric_box(si<Length>(0.2), si<Length>(0.3), si<Length>(0.01), si<Length>(0.01)), {}};
  TaperedBeam beam;
  beam.segments.push_back({"1", si<Length>(0.0), si<Length>(length), section, section});
  beam.density = si<Density>(7850.0);
  return beam;
}

/// What a mechanism by chance has.
struct RandomMechanism {
  int links = 4;
  bool closed = false;        ///< further joints close loops
  bool damped = false;        ///< materials and joints
  bool rigid_joints = false;  ///< some directions of the joints of the tree are rigid
  bool nodes_at_joints = true;
  boxbeam::flexible::Element element = boxbeam::flexible::Element::corrected;
};

/// Up to 10^any powers of ten.
inline double power_of_ten(Chance& chance, double low, double high) {
  return std::pow(10.0, 0.5 * (low + high) + chance.any(0.5 * (high - low)));
}

/// A link of any kind, tapered in one to three stretches.
inline boxbeam::flexible::Link random_link(Chance& chance) {
  using namespace boxbeam::flexible;
  Link link;
  link.kind = static_cast<LinkKind>(chance.one_of(4));
  link.angle = chance.any(3.0);
  link.length = 2.0 + chance.any(1.5);
  link.parts = 1 + chance.one_of(9);
  if (link.kind == LinkKind::rigid) {
    link.rigid = {100.0 + chance.any(90.0), Eigen::Vector2d(chance.any(), chance.any()),
                  50.0 + chance.any(45.0)};
    return link;
  }
  const int stretches = 1 + chance.one_of(3);
  double start = 0.0;
  for (int i = 0; i < stretches; ++i) {
    LinkStretch stretch;
    stretch.start = start;
    stretch.length = i + 1 == stretches ? link.length - start
                                        : link.length * (1.0 + chance.any(0.4)) / stretches;
    start += stretch.length;
    const auto tapered = [&](auto& p, double size) {
      // Positive: at least a tenth of `size` on the whole stretch.
      p.c[0] = size;
      p.c[1] = chance.any(0.5) * size / stretch.length;
      p.c[2] = chance.any(0.4) * size / (stretch.length * stretch.length);
    };
    tapered(stretch.EA, power_of_ten(chance, 7.0, 9.0));
    tapered(stretch.GA, power_of_ten(chance, 7.0, 9.0));
    tapered(stretch.EI, power_of_ten(chance, 5.0, 7.0));
    tapered(stretch.mass, power_of_ten(chance, 1.0, 2.0));
    tapered(stretch.rotary, power_of_ten(chance, -1.0, 0.0));
    link.stretches.push_back(stretch);
  }
  return link;
}

/// A place of a link that coincides with one of the world.
inline boxbeam::flexible::Attachment at_world(const boxbeam::flexible::Mechanism& mechanism,
                                              int link, const Eigen::Vector2d& p_W) {
  if (link == boxbeam::flexible::ground) return {link, p_W};
  const auto& of = mechanism.links[static_cast<std::size_t>(link)];
  return {link, Eigen::Rotation2Dd(-of.angle) * (p_W - of.origin)};
}

/// A mechanism by chance that nothing can move without strain: a tree of links of all kinds, each
/// held in all three directions by an earlier one or by the ground; if asked with further revolute
/// and sliding joints between any two. All joints act at one place of the world.
inline boxbeam::flexible::Mechanism random_elastic(Chance& chance, const RandomMechanism& want) {
  using namespace boxbeam::flexible;
  Mechanism mechanism;
  mechanism.element = want.element;
  mechanism.nodes_at_joints = want.nodes_at_joints;
  mechanism.gravity = {chance.any(3.0), -9.81};
  const auto stiffness = [&] { return power_of_ten(chance, 6.0, 9.0); };
  const auto damp = [&](Joint& joint) {
    if (!want.damped) return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (joint.stiffness[i] > 0.0 && joint.stiffness[i] < infinite && chance.one_of(2) == 0) {
        joint.damping[i] = 1e-3 * joint.stiffness[i];
      }
    }
  };
  for (int i = 0; i < want.links; ++i) {
    Link link = random_link(chance);
    link.name = "link " + std::to_string(i);
    if (want.damped && chance.one_of(2) == 0) link.retardation = 1e-4;
    Joint joint;
    joint.name = "tree " + std::to_string(i);
    joint.angle = chance.any(3.0);
    joint.stiffness = {stiffness(), stiffness(), stiffness()};
    if (want.rigid_joints) {
      for (double& c : joint.stiffness) {
        if (chance.one_of(2) == 0) c = infinite;
      }
    }
    damp(joint);
    const int parent = i == 0 ? ground : chance.one_of(i + 1) - 1;
    joint.b.link = parent;
    if (parent == ground) {
      joint.b.p = {chance.any(), chance.any()};
    } else {
      const double s = 0.5 * mechanism.links[static_cast<std::size_t>(parent)].length;
      joint.b.p = {s + chance.any(s), chance.one_of(2) == 0 ? 0.0 : chance.any(0.2)};
    }
    const double half = 0.5 * link.length;
    joint.a = {i, {half + chance.any(half), chance.one_of(2) == 0 ? 0.0 : chance.any(0.2)}};
    link.origin = in_world(mechanism, joint.b) - Eigen::Rotation2Dd(link.angle) * joint.a.p;
    mechanism.links.push_back(link);
    mechanism.joints.push_back(joint);
  }
  for (int i = 0; want.closed && i < want.links; ++i) {
    Joint joint;
    joint.name = "loop " + std::to_string(i);
    joint.angle = chance.any(3.0);
    const int a = chance.one_of(want.links);
    const int b = chance.one_of(want.links + 1) - 1;
    if (a == b) continue;
    const double half = 0.5 * mechanism.links[static_cast<std::size_t>(a)].length;
    joint.a = {a, {half + chance.any(half), 0.0}};
    joint.b = at_world(mechanism, b, in_world(mechanism, joint.a));
    const double c = stiffness();
    if (chance.one_of(2) == 0) {
      joint.stiffness = {c, c, 0.0};
    } else {
      joint.stiffness = {0.0, c, 0.0};
    }
    damp(joint);
    mechanism.joints.push_back(joint);
  }
  for (int i = 0; i < 2; ++i) {
    const int on = chance.one_of(want.links);
    const double half = 0.5 * mechanism.links[static_cast<std::size_t>(on)].length;
    Load load;
    load.name = "load " + std::to_string(i);
    load.at = {on, {half + chance.any(half), chance.any(0.2)}};
    load.constant = chance.vector(1e4);
    load.amplitude = chance.vector(1e3);
    load.phase = want.damped ? chance.any(3.0) : 0.0;
    mechanism.loads.push_back(load);
  }
  return mechanism;
}

/// The whole world turned about its origin.
inline boxbeam::flexible::Mechanism turned_world(boxbeam::flexible::Mechanism mechanism,
                                                 double angle) {
  using boxbeam::flexible::ground;
  const Eigen::Rotation2Dd turn(angle);
  const auto rotate = [&](auto&& v) { v = (turn * Eigen::Vector2d(v)).eval(); };
  rotate(mechanism.gravity);
  for (auto& link : mechanism.links) {
    rotate(link.origin);
    link.angle += angle;
  }
  for (auto& joint : mechanism.joints) {
    joint.angle += angle;
    for (auto* at : {&joint.a, &joint.b}) {
      if (at->link == ground) rotate(at->p);
    }
  }
  for (auto& load : mechanism.loads) {
    rotate(load.constant.head<2>());
    rotate(load.amplitude.head<2>());
  }
  return mechanism;
}

}  // namespace test
