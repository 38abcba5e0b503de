#include <Eigen/Core>

#include "boxbeam/report/json.hpp"
#include "json_number.hpp"

namespace boxbeam {
namespace {

const char* sign_text(int sign) { return sign > 0 ? "+" : (sign < 0 ? "-" : "0"); }

Json body_json(const BodyMotion& body) {
  return {{"x", finite(body.position.x())},        {"y", finite(body.position.y())},
          {"angle", finite(body.position.z())},    {"vx", finite(body.velocity.x())},
          {"vy", finite(body.velocity.y())},       {"omega", finite(body.velocity.z())},
          {"ax", finite(body.acceleration.x())},   {"ay", finite(body.acceleration.y())},
          {"alpha", finite(body.acceleration.z())}};
}

Json point_json(const PointMotion& point) {
  return {{"x", finite(point.position.x())},      {"y", finite(point.position.y())},
          {"vx", finite(point.velocity.x())},     {"vy", finite(point.velocity.y())},
          {"ax", finite(point.acceleration.x())}, {"ay", finite(point.acceleration.y())}};
}

Json chain_json(const ChainResult& chain) {
  Json steps = Json::object();
  for (const ChainStepLoad& load : chain.steps) {
    steps[load.step] = {{"fx", finite(load.force.x())},
                        {"fy", finite(load.force.y())},
                        {"moment", load.moment ? Json(finite(*load.moment)) : Json()}};
  }
  return {{"steps", std::move(steps)}, {"sought_mass", finite(chain.sought_mass)}};
}

Json state_json(const InstantResult& state) {
  Json branch = Json::object();
  for (const auto& [loop, sign] : state.branch) branch[loop] = sign_text(sign);
  Json bodies = Json::object();
  for (const BodyMotion& body : state.bodies) bodies[body.name] = body_json(body);
  Json points = Json::object();
  for (const PointMotion& point : state.points) points[point.name] = point_json(point);
  Json reactions = Json::object();
  for (const JointReaction& reaction : state.reactions) {
    // What joints that repeat each other share is not determined: no number is invented.
    const auto number = [&](double value) {
      return reaction.unique ? Json(finite(value)) : Json();
    };
    reactions[reaction.joint] = {{"on", reaction.on},
                                 {"fx", number(reaction.force.x())},
                                 {"fy", number(reaction.force.y())},
                                 {"moment", number(reaction.moment)},
                                 {"unique", reaction.unique}};
  }
  return {{"time", finite(state.time)},
          {"branch", std::move(branch)},
          {"residual", finite(state.residual)},
          {"condition", finite(state.condition)},
          {"digits", finite(state.digits)},
          {"bodies", std::move(bodies)},
          {"points", std::move(points)},
          {"reactions", std::move(reactions)},
          {"newton_chain", state.chain ? chain_json(*state.chain) : Json()}};
}

Json vector_json(const Eigen::Vector3d& v) {
  return Json::array({finite(v.x()), finite(v.y()), finite(v.z())});
}

Json state_json(const ChainInstant& state) {
  Json bodies = Json::object();
  for (const ChainBody& body : state.bodies) {
    Json rotation = Json::array();  // by rows
    for (int i = 0; i < 3; ++i) rotation.push_back(vector_json(body.rotation.row(i)));
    bodies[body.name] = {{"omega", vector_json(body.omega)},
                         {"alpha", vector_json(body.alpha)},
                         {"rotation", std::move(rotation)},
                         {"inertia_force", vector_json(body.inertia_force)},
                         {"inertia_moment", vector_json(body.inertia_moment)},
                         {"gyroscopic_moment", vector_json(body.gyroscopic_moment)}};
  }
  Json points = Json::object();
  for (const ChainPoint& point : state.points) {
    points[point.name] = {{"position", vector_json(point.position)},
                          {"velocity", vector_json(point.velocity)},
                          {"acceleration", vector_json(point.acceleration)}};
  }
  Json joints = Json::object();
  for (const ChainJoint& joint : state.joints) {
    joints[joint.name] = {{"on", joint.on},
                          {"force", vector_json(joint.force)},
                          {"moment", vector_json(joint.moment)},
                          {"drive", joint.drive ? Json(finite(*joint.drive)) : Json()}};
  }
  // A chain is explicit: it has no branch, and nothing is left open.
  return {{"time", finite(state.time)},
          {"branch", Json::object()},
          {"residual", 0},
          {"condition", 1},
          {"bodies", std::move(bodies)},
          {"points", std::move(points)},
          {"joints", std::move(joints)}};
}

Json hand_formula_json(const HandComparison& hand) {
  return {{"name", hand.formula.name},
          {"time", finite(hand.formula.time.value())},
          {"quantity", to_text(hand.formula.quantity)},
          {"of", hand.of},
          {"formula", hand.formula.formula},
          {"value", vector_json(hand.formula.value)},
          {"computed", vector_json(hand.computed)},
          {"difference", vector_json(hand.formula.value - hand.computed)},
          {"note", hand.formula.note}};
}

}  // namespace

std::string motion_json(const MotionResult& motion) {
  Json states = Json::array();
  for (const InstantResult& state : motion.states) states.push_back(state_json(state));
  const Json document = {{"schema", "boxbeam.motion/1"},
                         {"kind", "planar"},
                         {"degrees_of_freedom", motion.freedom.by_rank},
                         {"redundant", motion.redundant},
                         {"change_points", motion.change_points},
                         {"states", std::move(states)}};
  return document.dump(2) + "\n";
}

std::string motion_json(const ChainMotionResult& motion) {
  Json states = Json::array();
  for (const ChainInstant& state : motion.states) states.push_back(state_json(state));
  Json hand_formulas = Json::array();
  for (const HandComparison& hand : motion.hand_formulas) {
    hand_formulas.push_back(hand_formula_json(hand));
  }
  const Json document = {
      {"schema", "boxbeam.motion/1"}, {"kind", "spatial"},
      {"axes", motion.axes},          {"degrees_of_freedom", motion.driven},
      {"states", std::move(states)},  {"hand_formulas", std::move(hand_formulas)}};
  return document.dump(2) + "\n";
}

std::string assemblies_json(const std::vector<AssemblyResult>& assemblies, double time) {
  Json list = Json::array();
  for (const AssemblyResult& assembly : assemblies) {
    Json branch = Json::object();
    for (const auto& [loop, sign] : assembly.branch) branch[loop] = sign_text(sign);
    Json bodies = Json::object();
    for (const auto& [name, at] : assembly.bodies) {
      bodies[name] = {{"x", finite(at.x())}, {"y", finite(at.y())}, {"angle", finite(at.z())}};
    }
    list.push_back({{"branch", std::move(branch)}, {"bodies", std::move(bodies)}});
  }
  const Json document = {{"schema", "boxbeam.assemblies/1"},
                         {"kind", "planar"},
                         {"time", finite(time)},
                         {"assemblies", std::move(list)}};
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
