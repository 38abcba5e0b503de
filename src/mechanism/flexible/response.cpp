#include "boxbeam/mechanism/flexible/response.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "frequency.hpp"

namespace boxbeam::flexible {
namespace {

void add_loads(const Structure& structure, const auto& amount, auto& columns) {
  const Mechanism& mechanism = *structure.mechanism;
  for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
    const Grip& grip = structure.loads[i];
    if (grip.link == ground) continue;
    columns[static_cast<std::size_t>(grip.link)].col(static_cast<Eigen::Index>(grip.element)) +=
        grip.motion.transpose() * amount(mechanism.loads[i]);
  }
}

/// Length of a motion by the sizes of masses and inertia in the nodes, of which single ones may be
/// below zero; of the exact form by its mass.
template <class Scalar>
double size_of(const Structure& structure, const LinkColumns<Scalar>& motion,
               const LinkColumns<Scalar>& inertia) {
  double square = 0.0;
  if (structure.mechanism->element == Element::exact) {
    for (std::size_t k = 0; k < motion.size(); ++k) {
      square += std::real(motion[k].conjugate().cwiseProduct(inertia[k]).sum());
    }
    return std::sqrt(std::max(0.0, square));
  }
  for (std::size_t k = 0; k < motion.size(); ++k) {
    for (Eigen::Index i = 0; i < motion[k].cols(); ++i) {
      const RigidElement& of = structure.links[k].elements[static_cast<std::size_t>(i)];
      const auto q = motion[k].col(i);
      square += std::abs(of.mass) * (std::norm(q[0]) + std::norm(q[1])) +
                std::abs(of.inertia) * std::norm(q[2]);
    }
  }
  return std::sqrt(square);
}

/// At least |omega_j^2 - omega^2 + i omega c_j|/omega^2 of the nearest mode that takes part in a
/// response, and not much more where it is what the response is made of: one step of inverse
/// iteration.
template <class Scalar>
double distance_from_resonance(const Structure& structure,
                               const DynamicStiffness<Scalar>& stiffness,
                               const LinkColumns<Scalar>& motion, double omega) {
  const double square = omega * omega;
  const auto inertia = mass_times(structure, motion, square);
  const double size = size_of(structure, motion, inertia);
  const LinkColumns<Scalar> again = stiffness.solve(inertia).motion;
  const double next = size_of(structure, again, mass_times(structure, again, square));
  return next > 0.0 ? size / (square * next) : 1.0;
}

/// The response at a frequency that is none of the structure's own. Throws AnalysisError.
template <class Scalar>
Deformation<Scalar> response_off_resonance(const Structure& structure,
                                           const DynamicStiffness<Scalar>& stiffness,
                                           const LinkColumns<Scalar>& loads, double frequency) {
  Deformation<Scalar> result = stiffness.solve(loads);
  if (distance_from_resonance(structure, stiffness, result.motion, omega_of(frequency)) >=
      resonance) {
    return result;
  }
  const char* damping = is_damped(*structure.mechanism)
                            ? "whose damping is less than a millionth of the critical one"
                            : "which has no damping";
  throw AnalysisError(
      {fmt::format("{:.6g} Hz is a natural frequency of the structure, {}: the amplitude has no "
                   "limit; take another frequency or give damping to links or joints",
                   frequency, damping),
       ""});
}

Deformation<Complex> undamped_response(const Structure& structure,
                                       const LinkColumns<Complex>& loads, double frequency) {
  const double omega = omega_of(frequency);
  const DynamicStiffness<double> stiffness(structure, omega * omega, omega);
  LinkColumns<double> part(loads.size());
  const auto solved = [&](const auto& of) {
    for (std::size_t k = 0; k < loads.size(); ++k) part[k] = of(loads[k]);
    const bool nothing = std::all_of(part.begin(), part.end(),
                                     [](const auto& columns) { return columns.isZero(0.0); });
    if (nothing) {  // loads in one phase have no other part
      return Deformation<double>{
          part, Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(structure.joints.size()))};
    }
    return response_off_resonance(structure, stiffness, part, frequency);
  };
  const Deformation<double> real = solved([](const auto& of) { return of.real().eval(); });
  const Deformation<double> imaginary = solved([](const auto& of) { return of.imag().eval(); });
  Deformation<Complex> result;
  const Complex i(0.0, 1.0);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    result.motion.push_back(real.motion[k] + i * imaginary.motion[k]);
  }
  result.joints = real.joints + i * imaginary.joints;
  return result;
}

}  // namespace

template <class Scalar>
LinkColumns<Scalar> no_loads(const Structure& structure) {
  LinkColumns<Scalar> columns;
  for (const DividedLink& link : structure.links) {
    columns.push_back(Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(
        3, static_cast<Eigen::Index>(link.elements.size())));
  }
  return columns;
}

LinkColumns<double> static_loads(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  // What weight does to the nodes is their inertia in an acceleration without turning.
  LinkColumns<double> columns = no_loads<double>(structure);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Eigen::Vector2d g = Eigen::Rotation2Dd(-mechanism.links[k].angle) * mechanism.gravity;
    columns[k].topRows<2>().colwise() = g;
  }
  columns = mass_times(structure, columns);
  add_loads(
      structure, [](const Load& load) { return load.constant; }, columns);
  return columns;
}

LinkColumns<Complex> harmonic_loads(const Structure& structure) {
  LinkColumns<Complex> columns = no_loads<Complex>(structure);
  add_loads(
      structure,
      [](const Load& load) -> Eigen::Vector3cd {
        return std::polar(1.0, load.phase) * load.amplitude;
      },
      columns);
  return columns;
}

bool is_damped(const Mechanism& mechanism) {
  return std::any_of(mechanism.links.begin(), mechanism.links.end(),
                     [](const Link& link) { return link.retardation != 0.0; }) ||
         std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [](const Joint& joint) {
           return std::any_of(joint.damping.begin(), joint.damping.end(),
                              [](double damping) { return damping != 0.0; });
         });
}

Deformation<double> static_response(const Structure& structure) {
  return DynamicStiffness<double>(structure, 0.0, 0.0).solve(static_loads(structure));
}

Deformation<Complex> harmonic_response(const Structure& structure, double frequency) {
  const int pieces = pieces_at(structure, std::pow(omega_of(frequency), 2));
  if (pieces > 1) {
    const FinerStructure finer = cut(structure, pieces);
    return at_coarse_nodes(finer, harmonic_response(finer.structure, frequency));
  }
  const LinkColumns<Complex> loads = harmonic_loads(structure);
  if (!is_damped(*structure.mechanism)) return undamped_response(structure, loads, frequency);
  const double omega = omega_of(frequency);
  const DynamicStiffness<Complex> stiffness(structure, omega * omega, omega);
  return response_off_resonance(structure, stiffness, loads, frequency);
}

Response response_of(const Structure& structure) {
  Response response;
  response.frequency = structure.mechanism->frequency;
  response.constant = static_response(structure);
  if (response.frequency > 0.0) {
    response.harmonic = harmonic_response(structure, response.frequency);
    return response;
  }
  response.harmonic.motion = no_loads<Complex>(structure);
  response.harmonic.joints =
      Eigen::Matrix3Xcd::Zero(3, static_cast<Eigen::Index>(structure.joints.size()));
  return response;
}

Deformation<double> at(const Response& response, double time) {
  const Complex turn = std::polar(1.0, omega_of(response.frequency) * time);
  Deformation<double> now = response.constant;
  for (std::size_t k = 0; k < now.motion.size(); ++k) {
    now.motion[k] += (turn * response.harmonic.motion[k]).imag();
  }
  now.joints += (turn * response.harmonic.joints).imag();
  return now;
}

double largest_length(Complex x, Complex y) {
  // |Im(f e^it)|^2 = (|x|^2 + |y|^2)/2 - Re((x^2 + y^2) e^2it)/2.
  return std::sqrt(0.5 * (std::norm(x) + std::norm(y) + std::abs(x * x + y * y)));
}

template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> joint_force(const Structure& structure, std::size_t joint,
                                        const Deformation<Scalar>& of) {
  return structure.joints[joint].axes.transpose() * of.joints.col(static_cast<Eigen::Index>(joint));
}

template LinkColumns<double> no_loads<double>(const Structure&);
template LinkColumns<Complex> no_loads<Complex>(const Structure&);
template Eigen::Vector3d joint_force<double>(const Structure&, std::size_t,
                                             const Deformation<double>&);
template Eigen::Vector3cd joint_force<Complex>(const Structure&, std::size_t,
                                               const Deformation<Complex>&);

}  // namespace boxbeam::flexible
