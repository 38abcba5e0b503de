#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "support/held_bar.hpp"

namespace test {

/// What acts on the free end of a cantilever: a force and a torque about its axis, both
/// mean + amplitude sin(2 pi t + phase), t in seconds.
struct EndLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< beam axes, at a size of 1 [N]
  double torque = 0.0;                              ///< [N m]
  double mean = 1.0, amplitude = 0.5, phase = 0.0;
};

/// A bar of 2 m without weight, held at its start, x along it, y and z as its section has them.
/// `section`: lines of the bar's section.
inline boxbeam::Project cantilever(const std::string& section, const std::vector<EndLoad>& loads) {
  using namespace boxbeam;
  Project project = held_bar(true, section);
  spatial::Mechanism mechanism;
  mechanism.bodies.push_back({"bar", 0.0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), {}});
  mechanism.joints.push_back({});
  mechanism.joints.back().name = "clamp";
  for (const EndLoad& load : loads) {
    const auto add = [&](spatial::LoadKind kind, const Eigen::Vector3d& vector) {
      if (vector.norm() == 0.0) return;
      spatial::AppliedLoad applied;
      applied.name = "end";
      applied.kind = kind;
      applied.on = 0;
      applied.at = {0, Eigen::Vector3d(2.0, 0.0, 0.0)};
      applied.direction = vector.normalized();
      applied.size = HarmonicDriver{load.mean * vector.norm(), load.amplitude * vector.norm(),
                                    2.0 * std::numbers::pi, load.phase};
      mechanism.loads.push_back(applied);
    };
    add(spatial::LoadKind::force, load.force);
    add(spatial::LoadKind::couple, load.torque * Eigen::Vector3d::UnitX());
  }
  project.beam.density = si<Density>(7850.0);  // at rest and without gravity it weighs nothing
  project.mechanism = mechanism;
  project.in_space = true;
  project.placement = {0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  return project;
}

}  // namespace test
