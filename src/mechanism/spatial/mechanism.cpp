#include "boxbeam/mechanism/spatial/mechanism.hpp"

#include <algorithm>

#include "boxbeam/core/index_by_name.hpp"

namespace boxbeam::spatial {
const char* to_text(JointKind kind) {
  switch (kind) {
    case JointKind::fixed: return "fixed";
    case JointKind::revolute: return "revolute";
    case JointKind::prismatic: return "prismatic";
  }
  return "";
}

const char* to_text(ClosingKind kind) {
  switch (kind) {
    case ClosingKind::fixed: return "fixed";
    case ClosingKind::revolute: return "revolute";
    case ClosingKind::prismatic: return "prismatic";
    case ClosingKind::cylindrical: return "cylindrical";
    case ClosingKind::universal: return "universal";
    case ClosingKind::spherical: return "spherical";
    case ClosingKind::planar: return "planar";
    case ClosingKind::slot: return "slot";
    case ClosingKind::distance: return "distance";
  }
  return "";
}

namespace {

std::string driver_and_joint(const std::string& driver, const std::string& joint) {
  return driver.empty() || driver == joint ? joint : driver + " (joint " + joint + ")";
}

}  // namespace

std::string driver_text(const Joint& joint) {
  return driver_and_joint(joint.driver_name, joint.name);
}

std::string driver_text(const ClosingJoint& joint) {
  return driver_and_joint(joint.driver_name, joint.name);
}

int body_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.bodies, name);
}

int joint_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.joints, name);
}

std::vector<DriverUse> functions_of(const Mechanism& mechanism) {
  std::vector<DriverUse> uses;
  for (const Joint& joint : mechanism.joints) {
    if (!is_driven(joint)) continue;
    uses.push_back(
        {&joint.driver, joint.kind == JointKind::revolute, DriverUse::On::joint, joint.name});
  }
  for (const ClosingJoint& joint : mechanism.closing) {
    if (joint.kind != ClosingKind::distance) continue;
    uses.push_back({&joint.length, false, DriverUse::On::joint, joint.name});
  }
  for (const AppliedLoad& load : mechanism.loads)
    uses.push_back({&load.size, false, DriverUse::On::force, load.name});
  for (const LineForce& line : mechanism.line_forces)
    uses.push_back({&line.size, false, DriverUse::On::force, line.name});
  return uses;
}

TimeSpan time_span_of(const Mechanism& mechanism) {
  return boxbeam::time_span_of(functions_of(mechanism), mechanism.duration);
}

}  // namespace boxbeam::spatial
