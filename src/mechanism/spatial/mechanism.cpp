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

std::string driver_text(const Joint& joint) {
  if (joint.driver_name.empty() || joint.driver_name == joint.name) return joint.name;
  return joint.driver_name + " (joint " + joint.name + ")";
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
    if (joint.kind == JointKind::fixed) continue;
    uses.push_back(
        {&joint.driver, joint.kind == JointKind::revolute, DriverUse::On::joint, joint.name});
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
