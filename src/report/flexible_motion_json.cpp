#include "boxbeam/report/json.hpp"
#include "json_number.hpp"

namespace boxbeam {
namespace {

Json complex_json(const std::complex<double>& value) {
  return Json::array({finite(value.real()), finite(value.imag())});
}

Json error_json(const DiscretisationError& error) {
  return {{"error", finite(error.error)},
          {"order", error.order ? Json(finite(*error.order)) : Json()}};
}

/// Errors of the forces and of the displacements, whichever `error` says.
template <class Error>
Json errors_json(const FlexibleMotionResult& motion, const Error& error) {
  Json joints = Json::object();
  for (const JointVibration& joint : motion.joints) {
    joints[joint.name] = error_json(error(joint.force));
  }
  Json points = Json::object();
  for (const PointVibration& point : motion.points) {
    points[point.name] = error_json(error(point.motion));
  }
  return {{"joints", std::move(joints)}, {"points", std::move(points)}};
}

Json static_json(const FlexibleMotionResult& motion) {
  Json joints = Json::object();
  for (const JointVibration& joint : motion.joints) {
    const Eigen::Vector3d& force = joint.force.constant;
    joints[joint.name] = {{"on", joint.on},
                          {"fx", finite(force.x())},
                          {"fy", finite(force.y())},
                          {"moment", finite(force.z())},
                          {"magnitude", finite(joint.force.magnitude)}};
  }
  Json points = Json::object();
  for (const PointVibration& point : motion.points) {
    points[point.name] = {{"x", finite(point.motion.constant.x())},
                          {"y", finite(point.motion.constant.y())}};
  }
  return {{"joints", std::move(joints)}, {"points", std::move(points)}};
}

Json harmonic_json(const FlexibleMotionResult& motion) {
  Json joints = Json::object();
  for (const JointVibration& joint : motion.joints) {
    const Eigen::Vector3cd& force = joint.force.amplitude;
    joints[joint.name] = {{"on", joint.on},
                          {"fx", complex_json(force.x())},
                          {"fy", complex_json(force.y())},
                          {"moment", complex_json(force.z())},
                          {"magnitude", finite(joint.force.largest)}};
  }
  Json points = Json::object();
  for (const PointVibration& point : motion.points) {
    points[point.name] = {{"x", complex_json(point.motion.amplitude.x())},
                          {"y", complex_json(point.motion.amplitude.y())},
                          {"magnitude", finite(point.motion.largest)}};
  }
  return {{"frequency", finite(motion.frequency)},
          {"joints", std::move(joints)},
          {"points", std::move(points)}};
}

Json discretisation_json(const FlexibleMotionResult& motion) {
  Json frequencies = Json::array();
  for (const NaturalFrequency& of : motion.frequencies) {
    frequencies.push_back(error_json(of.error));
  }
  Json all = {{"elements", motion.elements},
              {"compared_with", Json::array({2, 4})},
              {"frequencies", std::move(frequencies)},
              {"static", errors_json(motion, [](const auto& of) { return of.constant_error; })}};
  if (motion.frequency > 0.0) {
    all["harmonic"] = errors_json(motion, [](const auto& of) { return of.amplitude_error; });
  }
  return all;
}

}  // namespace

std::string motion_json(const FlexibleMotionResult& motion) {
  Json frequencies = Json::array();
  for (const NaturalFrequency& of : motion.frequencies) {
    frequencies.push_back(finite(of.frequency));
  }
  Json document = {{"schema", "boxbeam.motion/1"},
                   {"kind", "flexible"},
                   {"degrees_of_freedom", motion.degrees_of_freedom},
                   {"frequencies", std::move(frequencies)},
                   {"static", static_json(motion)}};
  if (motion.frequency > 0.0) document["harmonic"] = harmonic_json(motion);
  document["discretisation"] = discretisation_json(motion);
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
