#include "sliding_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace boxbeam {

bool slides_along(spatial::ClosingKind kind) {
  using Kind = spatial::ClosingKind;
  switch (kind) {
    case Kind::prismatic:
    case Kind::cylindrical:
    case Kind::planar:
    case Kind::slot:
    case Kind::screw: return true;
    case Kind::fixed:
    case Kind::revolute:
    case Kind::universal:
    case Kind::spherical:
    case Kind::distance:
    case Kind::gear:
    case Kind::rack: return false;
  }
  return false;
}

bool slides_along(spatial::JointKind kind) {
  switch (kind) {
    case spatial::JointKind::prismatic:
    case spatial::JointKind::screw: return true;
    case spatial::JointKind::fixed:
    case spatial::JointKind::revolute: return false;
  }
  return false;
}

std::vector<std::string> joints_sliding_along(const spatial::Mechanism& mechanism, int body) {
  std::vector<std::string> names;
  for (const spatial::Joint& joint : mechanism.joints)
    if (joint.parent == body && slides_along(joint.kind)) names.push_back(joint.name);
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    if (joint.a.body == body && slides_along(joint.kind)) names.push_back(joint.name);
  return names;
}

std::string moving_along(const spatial::Mechanism& mechanism, int body) {
  for (const spatial::Joint& joint : mechanism.joints)
    if (joint.parent == body && slides_along(joint.kind)) return joint.name;
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    const bool meshes = spatial::has_teeth(joint.kind);
    if ((meshes || slides_along(joint.kind)) && joint.a.body == body) return joint.name;
    if (!meshes) continue;
    for (const spatial::Mesh::Part& part : joint.mesh.parts)
      if (static_cast<int>(part.joint) == body || mechanism.joints[part.joint].parent == body)
        return joint.name;
  }
  return "";
}

double sliding_along(const spatial::Mechanism& mechanism, const spatial::State& state,
                     const std::vector<spatial::BeamPlacement>& beams, double length) {
  double fastest = 0.0;
  const auto look_at = [&](int along, const spatial::Attachment& of) {
    if (std::none_of(beams.begin(), beams.end(),
                     [&](const spatial::BeamPlacement& beam) { return beam.body == along; }))
      return;
    const spatial::BodyMotion& body = state.bodies[static_cast<std::size_t>(along)];
    const Eigen::Vector3d there =
        body.R_WB.transpose() * (spatial::position_of(state, of) - body.position);
    const Eigen::Vector3d passing =
        spatial::velocity_of(state, of) - spatial::velocity_of(state, {along, there});
    fastest = std::max(fastest, passing.norm() / length);
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (slides_along(joint.kind)) look_at(joint.parent, {static_cast<int>(i), joint.point});
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    if (slides_along(joint.kind)) look_at(joint.a.body, joint.b);
  return fastest;
}

}  // namespace boxbeam
