#include "boxbeam/mechanism/flexible/modes.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "dense_modes.hpp"
#include "exact_modes.hpp"
#include "lowest_modes.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// So many coordinates, or elasticities, or fewer: all modes, by dense matrices, where a few of
/// them are not found by themselves.
constexpr Index few = 150;
/// So many or fewer: by these from the first, for nothing is faster.
constexpr Index very_few = 24;
/// Few of the modes: one in so many elasticities, and coordinates.
constexpr Index one_in = 6;
/// omega^2 over |shift|, below which a motion is without strain.
constexpr double no_strain = 1e-8;
/// Largest residual |q - (omega^2 - shift) (K - shift M)^-1 M q| of a mode, by its mass.
constexpr double accepted = 1e-6;

/// At most so many modes bend anything: one for each elasticity.
Index elasticities_of(const Structure& structure) {
  Index count = 0;
  for (const DividedLink& link : structure.links) {
    for (const SpringElement& spring : link.springs) {
      count += (spring.axial > 0.0 ? 1 : 0) + (spring.bending.isZero(0.0) ? 0 : 2);
    }
  }
  for (const Joint& joint : structure.mechanism->joints) {
    count += std::count_if(joint.stiffness.begin(), joint.stiffness.end(),
                           [](double k) { return k > 0.0 && std::isfinite(k); });
  }
  return count;
}

FoundModes found_modes(const ModalProblem& problem, Index asked) {
  const Index size = problem.coordinates.size();
  if (size <= few || one_in * asked > size) return all_modes(whole_problem(problem));
  if (elasticities_of(problem.structure) <= few) {
    if (const auto small = few_motions(problem, 2 * few)) return all_modes(*small);
  }
  return lowest_modes(problem, asked);
}

/// One more step of inverse iteration, that gives the joint forces and takes out motions without
/// mass; Rayleigh's quotient for the frequency.
Mode finished(const ModalProblem& problem, const VectorXd& q) {
  const MotionVector& coordinates = problem.coordinates;
  const VectorXd M_q = problem.mass_times(q);
  const double mass = q.dot(M_q);
  Mode mode;
  mode.shape = problem.stiffness.solve(coordinates.columns(M_q.data()));
  const VectorXd next = coordinates.vector(mode.shape.motion);
  const double shifted = mass / next.dot(M_q);  // omega^2 - shift
  const VectorXd error = shifted * next - q;
  const double residual = std::sqrt(std::abs(error.dot(problem.mass_times(error))) / mass);
  if (!(residual < accepted)) {
    throw AnalysisError(
        {"a natural frequency was not found as exactly as it must be; ask for fewer",
         "",
         {},
         residual});
  }
  const double square = shifted - problem.below;
  if (square > no_strain * problem.below) {
    mode.frequency = std::sqrt(square) / full_turn;
  } else {
    mode.shape.joints.setZero();
  }
  Index largest = 0;
  next.cwiseAbs().maxCoeff(&largest);
  const double factor =
      std::copysign(1.0 / std::sqrt(std::abs(next.dot(problem.mass_times(next)))), next[largest]);
  for (auto& link : mode.shape.motion) link *= factor;
  mode.shape.joints *= factor;
  return mode;
}

std::vector<Mode> finished(const ModalProblem& problem, const FoundModes& found, Index asked) {
  std::vector<Mode> modes;
  const Index wanted = std::min(asked, found.theta.size());
  for (Index i = 0; i < wanted; ++i) modes.push_back(finished(problem, found.q.col(i)));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

/// Whether links vibrate by themselves, in as many modes as one likes.
bool is_continuous(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  return mechanism.element == Element::exact &&
         std::any_of(mechanism.links.begin(), mechanism.links.end(), [](const Link& link) {
           return link.kind != LinkKind::rigid && rigid_mass_of(link).mass > 0.0;
         });
}

}  // namespace

std::vector<Mode> modes_of(const Structure& structure, std::size_t count) {
  if (count == 0 || structure.elements() == 0) return {};
  if (is_continuous(structure)) return exact_modes_of(structure, count);
  const ModalProblem problem = modal_problem_of(structure);
  const Index size = problem.coordinates.size();
  const auto asked = static_cast<Index>(count);
  const Index fewer = std::min(size, elasticities_of(structure));
  if (size > very_few && fewer <= few && one_in * asked <= fewer) {
    try {
      return finished(problem, lowest_modes(problem, asked, false), asked);
    } catch (const AnalysisError&) {
      // Stiffnesses or masses far apart, frequencies that repeat: all modes together tell.
    }
  }
  return finished(problem, found_modes(problem, asked), asked);
}

}  // namespace boxbeam::flexible
