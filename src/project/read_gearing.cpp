#include "read_gearing.hpp"

#include <fmt/format.h>

#include <numbers>

namespace boxbeam::readers {
namespace {

using spatial::ClosingKind;
using spatial::Mechanism;

void read_meshing_joints(TableReader& table, ClosingKind kind, GearingDraft& draft) {
  if (kind == ClosingKind::rack) {
    draft.first = table.text({"pinion", "the revolute joint that carries it"});
    draft.second = table.text({"rack", "the prismatic joint that carries it"});
    return;
  }
  const std::vector<std::string> names =
      table.texts({"joints", "the revolute joints that carry the two wheels"}, true);
  if (names.size() == 2) {
    draft.first = names[0];
    draft.second = names[1];
  } else if (table.has("joints")) {
    table.problem("joints", "a gear has two wheels, each carried by a joint",
                  "write joints = [\"sun\", \"planet\"]");
  }
}

void read_ratio(TableReader& table, ClosingKind kind, spatial::Gearing& gearing) {
  if (kind == ClosingKind::rack) {
    gearing.ratio = table.not_zero(
        {"radius", "of the pinion; the rack advances along its axis by it in a radian"},
        wanted::length);
    gearing.offset = table.quantity({"offset", "along the rack where the pinion is at zero"},
                                    wanted::length, 0.0);
    return;
  }
  gearing.ratio = table.any_number(
      {"ratio",
       "turn of the second wheel over that of the first, about the axes of their joints, seen from "
       "the body that keeps both; negative where axes point alike, positive in an annulus"});
  if (gearing.ratio == 0.0) {
    table.problem(
        "ratio", "\"ratio\" must not be zero",
        "write for example ratio = -0.5, the teeth of the first over those of the second");
  }
  gearing.offset =
      table.quantity({"offset", "of the second where the first is at zero"}, wanted::angle, 0.0);
}

/// Where teeth meet, in the axes of a body that is known by its name.
void read_mesh(TableReader& table, const Mechanism& mechanism, GearingDraft& draft) {
  const Key mesh{"mesh",
                 "where teeth meet: a point of the body that keeps both axes, or \"ground\"; of "
                 "parallel axes where not said at the level of their joints"};
  const std::string place = table.text(mesh, "");
  if (place.empty()) return;
  table.wants_with("at", "mesh", "ground");
  if (place == "ground") {
    draft.gearing.at = {spatial::ground,
                        table.triple({"at", "the place on the ground"}, wanted::length)};
    return;
  }
  const spatial::Attachment at = point_named(table, "mesh", place, mechanism);
  if (at.body < 0) return;
  draft.gearing.at = at;
  draft.body = mechanism.bodies[static_cast<std::size_t>(at.body)].name;
}

/// The index of a joint that carries a body. Notes one that is not there.
std::optional<std::size_t> carrying_joint(TableReader& joints, const std::string& gear,
                                          const std::string& name, const Mechanism& mechanism) {
  const int index = joint_index(mechanism, name);
  if (index >= 0) return static_cast<std::size_t>(index);
  std::vector<std::string> known;
  for (const spatial::Joint& joint : mechanism.joints)
    if (joint.kind != spatial::JointKind::fixed) known.push_back(joint.name);
  joints.problem(gear,
                 fmt::format("\"{}\": there is no joint \"{}\" that carries a body", gear, name),
                 unknown_hint(name, known));
  return {};
}

}  // namespace

GearingDraft read_gearing(TableReader& table, ClosingKind kind, const Mechanism& mechanism) {
  GearingDraft draft;
  read_meshing_joints(table, kind, draft);
  read_ratio(table, kind, draft.gearing);
  constexpr double standard = std::numbers::pi / 9.0;  // 20 deg, ISO 53
  const Key pressure_angle{"pressure_angle",
                           "of the teeth, in the section across them: its tangent times the force "
                           "along the pitch circle pushes the wheels apart"};
  draft.gearing.pressure_angle = table.quantity(pressure_angle, wanted::angle, standard);
  if (!(draft.gearing.pressure_angle >= 0.0 &&
        draft.gearing.pressure_angle < 0.25 * std::numbers::pi))
    table.problem(pressure_angle.name, "a pressure angle is from 0 to 45 deg",
                  "write pressure_angle = \"20 deg\"");
  read_mesh(table, mechanism, draft);
  return draft;
}

void mesh_gearings(TableReader& root, const std::vector<GearingDraft>& drafts,
                   Mechanism& mechanism) {
  if (drafts.empty()) return;
  TableReader joints = root.table("joints");
  for (const GearingDraft& draft : drafts) {
    spatial::ClosingJoint& closing = mechanism.closing[draft.closing];
    const auto first = carrying_joint(joints, closing.name, draft.first, mechanism);
    const auto second = carrying_joint(joints, closing.name, draft.second, mechanism);
    if (!first || !second) continue;
    const bool rack = closing.kind == ClosingKind::rack;
    const spatial::JointKind wanted =
        rack ? spatial::JointKind::prismatic : spatial::JointKind::revolute;
    if (const spatial::Joint& of = mechanism.joints[*second]; of.kind != wanted) {
      joints.problem(closing.name,
                     fmt::format("\"{}\": joint \"{}\" is of kind \"{}\": it carries no {}",
                                 closing.name, of.name, to_text(of.kind), rack ? "rack" : "wheel"),
                     rack
                         ? "a rack is carried by a prismatic joint"
                         : "wheels are carried by revolute joints; kind = \"rack\" for a pinion on "
                           "a rack");
      continue;
    }
    spatial::Gearing gearing = draft.gearing;
    gearing.first = *first;
    gearing.second = *second;
    if (gearing.at && !draft.body.empty()) gearing.at->body = body_index(mechanism, draft.body);
    spatial::MeshFound found = mesh_of(mechanism, gearing);
    if (!found.mesh) {
      joints.problem(closing.name, fmt::format("\"{}\": {}", closing.name, found.problem),
                     found.hint);
      continue;
    }
    closing.mesh = *std::move(found.mesh);
    closing.a = {static_cast<int>(*first), mechanism.joints[*first].point};
    closing.b = {static_cast<int>(*second), mechanism.joints[*second].point};
  }
}

}  // namespace boxbeam::readers
