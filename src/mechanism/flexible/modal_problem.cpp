#include "modal_problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "boxbeam/core/error.hpp"
#include "element_mass.hpp"

namespace boxbeam::flexible {

using Eigen::Index;
using Eigen::VectorXd;

void fail_modes(const std::string& why) {
  throw AnalysisError({fmt::format("the natural frequencies were not found: {}", why), ""});
}

VectorXd ModalProblem::mass_times(const VectorXd& q) const {
  VectorXd product(q.size());
  mass_times(q.data(), product.data());
  return product;
}

void ModalProblem::mass_times(const double* q, double* product) const {
  if (structure.mechanism->element == Element::exact) {
    coordinates.write(flexible::mass_times(structure, coordinates.columns(q)), product);
    return;
  }
  for (const DividedLink& link : structure.links) {
    for (const RigidElement& of : link.elements) {
      Eigen::Map<Eigen::Vector3d> result(product);
      result = flexible::mass_times(of, Eigen::Map<const Eigen::Vector3d>(q));
      q += 3;
      product += 3;
    }
  }
}

void ModalProblem::move(const double* load, double* motion) const {
  coordinates.write(stiffness.solve(coordinates.columns(load)).motion, motion);
}

VectorXd random_load(Index size, unsigned number) {
  const auto parts_of = [](Index count, unsigned seed) {
    std::mt19937 random(seed);
    VectorXd load(count);
    for (double& part : load) part = static_cast<double>(random()) / 4294967296.0 - 0.5;
    return load;
  };
  // Every posture of a motion asks for the first one.
  constexpr Index kept = 512;
  static const VectorXd first = parts_of(kept, 1U);
  return number == 1U && size <= kept ? VectorXd(first.head(size)) : parts_of(size, number);
}

ModalProblem modal_problem_of(const Structure& structure) {
  constexpr double near = 1e-3;
  constexpr int most_guesses = 8;
  double below = low_square_of(structure);
  for (int guess = 1;; ++guess) {
    ModalProblem problem(structure, below);
    const MotionVector& coordinates = problem.coordinates;
    const auto moved_by = [&](const VectorXd& load) {
      VectorXd motion(load.size());
      problem.move(load.data(), motion.data());
      return motion;
    };
    const VectorXd q = moved_by(random_load(coordinates.size(), 1U));
    const VectorXd M_q = problem.mass_times(q);
    const double theta = below * M_q.dot(moved_by(M_q)) / q.dot(M_q);
    if (!(theta > 0.0 && theta < near) || guess == most_guesses) return problem;
    below /= theta;
  }
}

double low_square_of(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  double mass = 0.0;
  double inertia = 0.0;
  double flexibility = 0.0;
  double turning = 0.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d high = -low;
  const auto reach = [&](const Eigen::Vector2d& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  };
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    const Link& link = mechanism.links[k];
    reach(link.origin);
    reach(link.origin + link.length * Eigen::Vector2d(std::cos(link.angle), std::sin(link.angle)));
    for (const RigidElement& element : structure.links[k].elements) {
      mass += element.mass;
      inertia += element.inertia;
    }
    for (const SpringElement& spring : structure.links[k].springs) {
      flexibility += spring.axial + spring.bending(0, 0);
      turning += spring.bending(1, 1);
    }
  }
  for (const Joint& joint : mechanism.joints) {
    reach(in_world(mechanism, joint.a));
    for (const std::size_t axis : {0U, 1U, 2U}) {
      if (joint.stiffness[axis] > 0.0) {
        (axis < 2 ? flexibility : turning) += 1.0 / joint.stiffness[axis];
      }
    }
  }
  flexibility += turning * (high - low).squaredNorm();
  // A flywheel turns on the springs more slowly than any mass moves.
  const double slowness = mass * flexibility + inertia * turning;
  if (!std::isfinite(slowness)) fail_modes("masses or flexibilities are beyond all numbers");
  return slowness > 0.0 ? 1.0 / slowness : 1.0;
}

}  // namespace boxbeam::flexible
