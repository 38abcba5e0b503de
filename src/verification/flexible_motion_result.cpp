#include "boxbeam/verification/flexible_motion_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {
namespace {

using flexible::LinkStretch;

/// Static response to loads and to the inertia of a motion, as phasors.
flexible::Deformation<flexible::Complex> static_response_to(
    const flexible::Structure& structure, const flexible::LinkColumns<flexible::Complex>& inertial,
    double frequency) {
  const double square = std::pow(full_turn * frequency, 2);
  flexible::LinkColumns<flexible::Complex> loads = flexible::harmonic_loads(structure);
  const auto inertia = flexible::mass_times(structure, inertial);
  for (std::size_t k = 0; k < loads.size(); ++k) loads[k] += square * inertia[k];
  return flexible::DynamicStiffness<flexible::Complex>(structure, 0.0, 0.0).solve(loads);
}

template <int Degree>
Polynomial<Degree> moved(const Polynomial<Degree>& p, double by, double length) {
  return interpolate<Degree>([&](double x) { return p(by + x); }, length);
}

/// The piece of a stretch between two places of the link.
LinkStretch piece_of(const LinkStretch& of, double from, double to) {
  const double by = from - of.start;
  const double length = to - from;
  return {from,
          length,
          moved(of.EA, by, length),
          moved(of.GA, by, length),
          moved(of.EI, by, length),
          moved(of.mass, by, length),
          moved(of.rotary, by, length)};
}

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

FlexibleMotion flexible_motion_of(const flexible::Mechanism& of, const ElasticModel& model) {
  FlexibleMotion motion;
  motion.mechanism = std::make_shared<const flexible::Mechanism>(modelled(of, model));
  motion.structure =
      std::make_shared<const flexible::Structure>(flexible::structure_of(*motion.mechanism));
  const flexible::Structure& structure = *motion.structure;
  const bool reduced = model.level == ModelLevel::quasi_static || model.level == ModelLevel::modal;
  if (!reduced || of.frequency == 0.0) {
    motion.response = flexible::response_of(structure);
    motion.inertial = motion.response.harmonic.motion;
    return motion;
  }
  motion.response.frequency = of.frequency;
  motion.response.constant = flexible::static_response(structure);
  motion.inertial = flexible::no_loads<flexible::Complex>(structure);
  if (model.level == ModelLevel::modal) {
    const flexible::ModalModel modes =
        flexible::modal_model_of(structure, static_cast<std::size_t>(model.modes));
    motion.inertial = flexible::harmonic_response(modes, of.frequency, false).motion;
  }
  motion.response.harmonic = static_response_to(structure, motion.inertial, of.frequency);
  return motion;
}

flexible::Mechanism refined(const flexible::Structure& structure, int factor) {
  flexible::Mechanism mechanism = *structure.mechanism;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    flexible::Link& link = mechanism.links[k];
    const std::vector<flexible::SpringElement>& parts = structure.links[k].springs;
    if (parts.empty()) continue;
    if (!mechanism.nodes_at_joints) {  // all parts are equal
      link.parts = static_cast<int>(parts.size()) * factor;
      continue;
    }
    // A stretch for every part, which then has one: ends of stretches are nodes.
    const std::vector<LinkStretch> whole = std::move(link.stretches);
    link.stretches.clear();
    link.parts = 1;
    auto of = whole.begin();
    for (const flexible::SpringElement& part : parts) {
      const double middle = 0.5 * (part.from + part.to);
      while (of != whole.end() - 1 && middle >= of->start + of->length) ++of;
      for (int i = 0; i < factor; ++i) {
        const double step = (part.to - part.from) / factor;
        const double to = i + 1 == factor ? part.to : part.from + step * (i + 1);
        link.stretches.push_back(piece_of(*of, part.from + step * i, to));
      }
    }
  }
  return mechanism;
}

DiscretisationError discretisation_error(const Eigen::VectorXd& own, const Eigen::VectorXd& by_2,
                                         const Eigen::VectorXd& by_4) {
  const double d_1 = (own - by_2).norm();
  const double d_2 = (by_2 - by_4).norm();
  const double p = d_1 > 0.0 && d_2 > 0.0 ? std::log2(d_1 / d_2) : 0.0;
  if (p >= 1.0 && p <= 5.0) return {1.25 * d_1 * std::exp2(p) / (std::exp2(p) - 1.0), p};
  return {3.0 * std::max({d_1, d_2, (own - by_4).norm()}), {}};
}

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
