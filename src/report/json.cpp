#include "boxbeam/report/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/remarks.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using Json = nlohmann::ordered_json;

/// The library writes NaN and infinity as null without a word; a result must never be one.
double finite(double value) {
  if (!std::isfinite(value))
    throw OutputError("a result is not a finite number and is not written");
  return value == 0.0 ? 0.0 : value;  // no "-0.0"
}

Json pair(const Envelope& envelope) {
  return Json::array({finite(envelope.smallest.value), finite(envelope.largest.value)});
}

Json check_json(const Check& check) {
  return {{"id", check.id},
          {"criterion", to_text(check.criterion)},
          {"point", check.point},
          {"station", check.on_beam ? Json(finite(check.station.s.value())) : Json()},
          {"side", check.on_beam ? Json(to_text(check.station.side)) : Json()},
          {"situation", check.situation},
          {"time", finite(check.time.value())},
          {"acting", finite(check.acting.value())},
          {"resisting", finite(check.resisting.value())},
          {"safety_factor", finite(check.safety_factor)},
          {"required", finite(check.required)},
          {"utilisation", finite(check.utilisation())},
          {"unit", check.acting.unit()},
          {"source", check.source}};
}

Json beam_json(const Verification& verification, const Project& project) {
  Json stations = Json::array();
  for (const StationEnvelope& station : verification.stations) {
    Json& at = stations.emplace_back(
        Json{{"s", finite(station.station.s.value())}, {"side", to_text(station.station.side)}});
    for (const auto& [which, name] : cut_forces_looked_at(project))
      at[name] = pair(station.of[which]);
  }
  return {{"length", finite(project.beam.length().value())},
          {"mass", finite(verification.beam_mass.mass.value())},
          {"centre_of_mass", finite(verification.beam_mass.centre.value())},
          {"stations", std::move(stations)}};
}

Json governing_json(const Verification& verification) {
  Json governing = Json::object();
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue}) {
    const CheckResult* result = verification.governing(criterion);
    governing[to_text(criterion)] = result != nullptr ? check_json(result->check) : Json();
  }
  return governing;
}

Json codes_json(const Verification& verification) {
  Json codes = Json::array();
  for (const CodeResult& code : verification.codes) {
    const bool found = code.missing.empty();
    codes.push_back({{"code", code.code},
                     {"curve", found ? Json(code.curve) : Json()},
                     {"unconfirmed", code.unconfirmed},
                     {"safety_factor", found ? Json(finite(code.safety_factor)) : Json()},
                     {"required", finite(code.required)},
                     {"station", found ? Json(finite(code.station.s.value())) : Json()},
                     {"point", found ? Json(code.point) : Json()},
                     {"missing", code.missing}});
  }
  return codes;
}

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
  return {{"time", finite(state.time)},         {"branch", std::move(branch)},
          {"residual", finite(state.residual)}, {"condition", finite(state.condition)},
          {"digits", finite(state.digits)},     {"bodies", std::move(bodies)},
          {"points", std::move(points)},        {"reactions", std::move(reactions)}};
}

}  // namespace

std::string results_json(const Project& project, const Verification& verification) {
  Json instants = Json::array();
  for (const CriticalInstant& instant : verification.critical_instants) {
    instants.push_back({{"quantity", instant.quantity},
                        {"station", finite(instant.station.s.value())},
                        {"side", to_text(instant.station.side)},
                        {"time", finite(instant.time.value())},
                        {"value", finite(instant.value)}});
  }
  Json checks = Json::array();
  for (const CheckResult& result : verification.checks) checks.push_back(check_json(result.check));
  const Json document = {{"schema", "boxbeam.results/1"},
                         {"case", project.name},
                         {"version", version},
                         {"input_sha256", project.sha256},
                         {"verdict", to_text(verification.verdict)},
                         {"model", {{"chosen", "rigid"}, {"reason", model_reason(project)}}},
                         {"critical_instants", std::move(instants)},
                         {"beam", beam_json(verification, project)},
                         {"checks", std::move(checks)},
                         {"governing", governing_json(verification)},
                         {"codes", codes_json(verification)},
                         {"remarks", remarks_of(project, verification)}};
  return document.dump(2) + "\n";
}

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
