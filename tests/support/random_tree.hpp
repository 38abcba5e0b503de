#pragma once

#include <Eigen/Geometry>
#include <random>
#include <string>

#include "boxbeam/mechanism/spatial/mechanism.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"

/// Bodies in space by chance, from a seed: the same on every machine.
namespace test {

/// Numbers and vectors by chance. From the generator's bits alone, for the distributions of the
/// standard library differ from one library to another.
class Chance {
 public:
  explicit Chance(unsigned seed) : bits_(seed) {}

  /// Between -size and size.
  double any(double size = 1.0) { return size * (static_cast<double>(bits_()) / 2147483648.0 - 1); }
  /// From 0 to count - 1.
  int one_of(int count) { return static_cast<int>(bits_() % static_cast<unsigned>(count)); }
  Eigen::Vector3d vector(double size = 1.0) {
    const double x = any(size), y = any(size);
    return {x, y, any(size)};
  }
  Eigen::Vector3d direction() {
    while (true) {
      Eigen::Vector3d v = vector();
      if (v.norm() > 0.1) return v.normalized();
    }
  }
  Eigen::Matrix3d rotation() { return boxbeam::spatial::rotation_about(any(3.0) * direction()); }
  /// Inertia of 20 points of mass: one that a real body can have, without any symmetry.
  Eigen::Matrix3d inertia(double mass, double size) {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d p = vector(size);
      tensor +=
          mass / 20 * (p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose()).eval();
    }
    return tensor;
  }
  /// A harmonic of two waves, a polynomial or a step that is on its way at 0.2 s to 0.8 s.
  boxbeam::Driver driver(double size) {
    const int kind = one_of(3);
    if (kind == 0) {
      const double mean = any(size), swing = any(size), omega = 2.0 + any(1.5), phase = any(3.0);
      return boxbeam::HarmonicDriver{mean, swing, omega, phase, {{any(0.2 * size), 7.0, 0.4}}};
    }
    if (kind == 1) {
      const double start = any(size), rate = any(size), second = any(size);
      return boxbeam::PolynomialDriver{{start, rate, second, any(size)}};
    }
    const double from = any(size);
    return boxbeam::StepDriver{from, from + any(size), -0.3, 1.2};
  }

 private:
  std::mt19937 bits_;
};

/// A tree of bodies with all kinds of joints, branches, offsets, whole inertia tensors, frames
/// without mass, loads whose place and direction belong to other bodies, and line forces.
inline boxbeam::spatial::Mechanism random_tree(Chance& chance, int bodies) {
  using namespace boxbeam::spatial;
  Mechanism tree;
  tree.gravity = chance.vector(10.0);
  for (int i = 0; i < bodies; ++i) {
    Body body;
    body.name = "body " + std::to_string(i);
    if (i == 0 || chance.one_of(5) != 0) {  // else a frame
      body.mass = 2.0 + chance.any(1.5);
      body.centre = chance.vector(0.4);
      body.inertia = chance.inertia(body.mass, 0.5);
    }
    tree.bodies.push_back(body);
    Joint joint;
    joint.name = "joint " + std::to_string(i);
    joint.kind = static_cast<JointKind>(i < 3 ? i : chance.one_of(3));
    joint.parent = i == 0 ? ground : std::max(ground, i - 1 - chance.one_of(4));
    joint.at = chance.vector();
    if (chance.one_of(3) != 0) joint.point = chance.vector(0.5);
    joint.turn = chance.rotation();
    joint.axis = chance.direction();
    joint.driver = chance.driver(joint.kind == JointKind::revolute ? 2.0 : 0.5);
    tree.joints.push_back(joint);
  }
  for (int i = 0; i < bodies; ++i) {
    const int on = chance.one_of(bodies), where = chance.one_of(bodies + 1) - 1;
    const int axes = chance.one_of(bodies + 1) - 1;
    tree.loads.push_back({"load",
                          i % 2 == 0 ? LoadKind::force : LoadKind::couple,
                          on,
                          {where, chance.vector()},
                          axes,
                          chance.direction(),
                          chance.driver(20.0)});
  }
  for (int i = 0; i < bodies / 4; ++i) {
    const int on = chance.one_of(bodies), axes = chance.one_of(bodies + 1) - 1;
    const Eigen::Vector3d from = chance.vector();
    tree.line_forces.push_back(
        {"line", on, from, chance.vector(), axes, chance.direction(), chance.driver(20.0)});
  }
  tree.duration.length = 1.0;
  return tree;
}

/// The whole world turned: the joints on the ground, gravity, and of the loads what is given in the
/// world's axes.
inline boxbeam::spatial::Mechanism turned_world(boxbeam::spatial::Mechanism mechanism,
                                                const Eigen::Matrix3d& turn) {
  using boxbeam::spatial::ground;
  const auto rotate = [&](Eigen::Vector3d& v) { v = (turn * v).eval(); };
  rotate(mechanism.gravity);
  for (auto& joint : mechanism.joints) {
    if (joint.parent != ground) continue;
    rotate(joint.at);
    rotate(joint.axis);
    joint.turn = (turn * joint.turn).eval();
  }
  for (auto& load : mechanism.loads) {
    if (load.at.body == ground) rotate(load.at.p);
    if (load.axes == ground) rotate(load.direction);
  }
  for (auto& line : mechanism.line_forces) {
    if (line.axes == ground) rotate(line.direction);
  }
  return mechanism;
}

}  // namespace test
