#include "boxbeam/verification/flexible_motion_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t frequencies_shown = 8;

/// Everything of one division.
struct Solved {
  std::vector<double> frequencies;
  std::vector<Eigen::Vector3d> joint_constants;
  std::vector<Eigen::Vector3cd> joint_amplitudes;
  std::vector<Eigen::Vector2d> point_constants;
  std::vector<Eigen::Vector2cd> point_amplitudes;
};

/// On the beam where the joint holds its end b, else on a; the ground feels nothing.
bool on_b(const flexible::Joint& joint, int beam_link) {
  return joint.a.link == flexible::ground || (joint.b.link == beam_link && beam_link >= 0);
}

Solved solve(const flexible::Structure& structure, int beam_link) {
  const flexible::Mechanism& mechanism = *structure.mechanism;
  Solved solved;
  for (const flexible::Mode& mode : flexible::modes_of(structure, frequencies_shown)) {
    solved.frequencies.push_back(mode.frequency);
  }
  const flexible::Response response = flexible::response_of(structure);
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const double sign = on_b(mechanism.joints[j], beam_link) ? -1.0 : 1.0;
    solved.joint_constants.push_back(sign * flexible::joint_force(structure, j, response.constant));
    solved.joint_amplitudes.push_back(sign *
                                      flexible::joint_force(structure, j, response.harmonic));
  }
  const flexible::FieldAlong<double> weight{mechanism.gravity, 0.0};
  flexible::FieldAlong<flexible::Complex> inertia;
  inertia.square = std::pow(full_turn * response.frequency, 2);
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    for (const BodyPoint& point : mechanism.links[k].points) {
      const flexible::Attachment at{static_cast<int>(k), point.p};
      solved.point_constants.push_back(
          flexible::motion_at(structure, at, response.constant, weight).head<2>());
      solved.point_amplitudes.push_back(
          flexible::motion_at(structure, at, response.harmonic, inertia).head<2>());
    }
  }
  return solved;
}

/// Coordinates (x, y) as a vector of real numbers.
Eigen::VectorXd parts_of(const Eigen::Vector2d& v) { return v; }
Eigen::VectorXd parts_of(const Eigen::Vector2cd& v) {
  Eigen::VectorXd parts(4);
  parts << v.real(), v.imag();
  return parts;
}

template <int Size>
using Constants = std::vector<Eigen::Matrix<double, Size, 1>>;
template <int Size>
using Amplitudes = std::vector<Eigen::Matrix<std::complex<double>, Size, 1>>;

/// Item i of the lists that three divisions gave.
template <int Size>
Vibration<Size> vibration_of(const std::array<const Solved*, 3>& solved, std::size_t i,
                             Constants<Size> Solved::*constants,
                             Amplitudes<Size> Solved::*amplitudes) {
  const auto constant = [&](std::size_t k) { return (solved[k]->*constants)[i]; };
  const auto amplitude = [&](std::size_t k) { return (solved[k]->*amplitudes)[i]; };
  const auto error_of = [](const auto& of) {
    return discretisation_error(parts_of(of(0)), parts_of(of(1)), parts_of(of(2)));
  };
  Vibration<Size> vibration;
  vibration.constant = constant(0);
  vibration.amplitude = amplitude(0);
  vibration.magnitude = vibration.constant.template head<2>().norm();
  vibration.largest = flexible::largest_length(vibration.amplitude[0], vibration.amplitude[1]);
  vibration.constant_error =
      error_of([&](std::size_t k) -> Eigen::Vector2d { return constant(k).template head<2>(); });
  vibration.amplitude_error =
      error_of([&](std::size_t k) -> Eigen::Vector2cd { return amplitude(k).template head<2>(); });
  return vibration;
}

/// Generalised coordinates of a link: a rigid motion, and what each spring adds.
std::size_t coordinates_of(flexible::LinkKind kind, std::size_t springs) {
  switch (kind) {
    case flexible::LinkKind::rigid: return 3;
    case flexible::LinkKind::axial: return 3 + springs;
    case flexible::LinkKind::bending: return 3 + 2 * springs;
    case flexible::LinkKind::full: return 3 + 3 * springs;
  }
  return 0;
}

}  // namespace

FlexibleMotionResult flexible_motion_of(const Project& project) {
  const flexible::Mechanism& mechanism = flexible_of(project);
  const flexible::Structure structure = flexible::structure_of(mechanism);
  const flexible::Mechanism by_2 = refined(structure, 2);
  const flexible::Mechanism by_4 = refined(structure, 4);
  const Solved own = solve(structure, project.beam_body);
  const Solved finer = solve(flexible::structure_of(by_2), project.beam_body);
  const Solved finest = solve(flexible::structure_of(by_4), project.beam_body);
  const std::array<const Solved*, 3> solved{&own, &finer, &finest};

  FlexibleMotionResult result;
  result.elements = structure.elements();
  result.frequency = mechanism.frequency;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    result.degrees_of_freedom +=
        coordinates_of(mechanism.links[k].kind, structure.links[k].springs.size());
  }
  const auto number = [](double value) { return Eigen::VectorXd::Constant(1, value); };
  for (std::size_t i = 0; i < own.frequencies.size(); ++i) {
    result.frequencies.push_back(
        {own.frequencies[i],
         discretisation_error(number(own.frequencies[i]), number(finer.frequencies[i]),
                              number(finest.frequencies[i]))});
  }
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const flexible::Joint& joint = mechanism.joints[j];
    const int on = on_b(joint, project.beam_body) ? joint.b.link : joint.a.link;
    result.joints.push_back(
        {joint.name, mechanism.links[static_cast<std::size_t>(on)].name,
         vibration_of<3>(solved, j, &Solved::joint_constants, &Solved::joint_amplitudes)});
  }
  std::size_t i = 0;
  for (const flexible::Link& link : mechanism.links) {
    for (const BodyPoint& point : link.points) {
      result.points.push_back(
          {link.name + "." + point.name,
           vibration_of<2>(solved, i++, &Solved::point_constants, &Solved::point_amplitudes)});
    }
  }
  return result;
}

}  // namespace boxbeam
