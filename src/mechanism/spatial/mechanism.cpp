#include "boxbeam/mechanism/spatial/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/core/index_by_name.hpp"

namespace boxbeam::spatial {
const char* to_text(JointKind kind) {
  switch (kind) {
    case JointKind::fixed: return "fixed";
    case JointKind::revolute: return "revolute";
    case JointKind::prismatic: return "prismatic";
    case JointKind::screw: return "screw";
  }
  return "";
}

bool is_angle(JointKind kind) {
  switch (kind) {
    case JointKind::revolute:
    case JointKind::screw: return true;
    case JointKind::fixed:
    case JointKind::prismatic: return false;
  }
  return false;
}

double pitch_of(double lead) { return lead / full_turn; }

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
    case ClosingKind::screw: return "screw";
    case ClosingKind::gear: return "gear";
    case ClosingKind::rack: return "rack";
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
    uses.push_back({&joint.driver, is_angle(joint.kind), DriverUse::On::joint, joint.name});
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

double size_of(const Mechanism& mechanism) {
  double size = 1e-3;
  for (const Joint& joint : mechanism.joints)
    size = std::max({size, joint.at.norm(), joint.point.norm()});
  for (const ClosingJoint& joint : mechanism.closing)
    size = std::max({size, joint.a.p.norm(), joint.b.p.norm()});
  return size;
}

TimeSpan time_span_of(const Mechanism& mechanism) {
  const auto forced = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), is_forced);
  if (forced == mechanism.joints.end())
    return boxbeam::time_span_of(functions_of(mechanism), mechanism.duration);
  if (!(mechanism.duration.length > 0.0)) {
    throw AnalysisError({fmt::format("forces move joint \"{}\": [motion] duration says how long "
                                     "that is looked at",
                                     forced->name),
                         "joint " + forced->name});
  }
  TimeSpan span = boxbeam::time_span_of(functions_of(mechanism), mechanism.duration);
  span.begin = mechanism.duration.settle;
  span.closed = false;
  return span;
}

std::optional<int> carrier_of_ball(const Mechanism& mechanism, int joint) {
  const auto turns = [&](int at) {
    return mechanism.joints[static_cast<std::size_t>(at)].kind == JointKind::revolute;
  };
  // A body between two movements of one joint is called as the first of them is, "ball.1".
  const auto is_between = [&](int body) {
    if (body == ground) return false;
    const auto index = static_cast<std::size_t>(body);
    const std::string& name = mechanism.bodies[index].name;
    return name == mechanism.joints[index].name && name.find('.') != std::string::npos;
  };
  int at = joint;
  for (int before = 0; before < 2; ++before) {
    const int parent = mechanism.joints[static_cast<std::size_t>(at)].parent;
    if (!turns(at) || !is_between(parent)) return std::nullopt;
    at = parent;
  }
  const int carrier = mechanism.joints[static_cast<std::size_t>(at)].parent;
  if (!turns(at) || is_between(carrier) || is_between(joint)) return std::nullopt;
  return carrier;
}

}  // namespace boxbeam::spatial
