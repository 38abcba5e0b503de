#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace test {

/// What is missing to Newton's and Euler's equations of any body, by the largest force in it.
inline double imbalance_of(const boxbeam::planar::Mechanism& mechanism,
                           const boxbeam::planar::State& state) {
  using namespace boxbeam;
  using namespace boxbeam::planar;
  const auto reactions = reactions_of(mechanism, state);
  const auto loads = applied_loads_of(mechanism, state.time, state.q, state.v, state.touches);
  const double size = size_of(mechanism);
  double worst = 0.0;
  double largest = 1e-300;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const auto k = static_cast<Eigen::Index>(3 * i);
    Eigen::Vector2d force = body.mass * (mechanism.gravity - state.a.segment<2>(k));
    double moment = -body.inertia * state.a[k + 2];
    largest = std::max({largest, force.norm(), std::abs(moment) / size});
    const auto add = [&](int on, const Eigen::Vector2d& f, double own, const Eigen::Vector2d& p) {
      if (on != static_cast<int>(i)) return;
      const Eigen::Vector2d arm = Eigen::Rotation2Dd(state.q[k + 2]) * p;
      force += f;
      moment += own + arm.x() * f.y() - arm.y() * f.x();
      largest = std::max({largest, f.norm(), std::abs(own) / size});
    };
    for (const Reaction& r : reactions) add(r.on, r.force, r.moment, r.point);
    for (const AppliedLoad& load : loads) add(load.on, load.vector, load.moment, load.point);
    worst = std::max({worst, force.norm(), std::abs(moment) / size});
  }
  return worst / largest;
}

}  // namespace test
