#include "boxbeam/mechanism/planar/newton_chain.hpp"

#include <Eigen/Geometry>

#include <cassert>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {

std::vector<std::optional<double>> chain_moments_at(const Mechanism& mechanism,
                                                    const NewtonChain& chain, const State& state) {
  std::vector<std::optional<double>> moments;
  std::optional<double> n = 0.0;
  for (const ChainStep& step : chain.steps) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(step.body)];
    const bool whole = step.name == body.name;
    if (n && whole) {
      *n += body.inertia * state.a[3 * static_cast<Eigen::Index>(step.body) + 2];
    } else {
      n.reset();
    }
    moments.push_back(n);
  }
  return moments;
}

ChainForces chain_of(const NewtonChain& chain, const std::vector<Eigen::Vector2d>& accelerations) {
  assert(accelerations.size() == chain.steps.size() + 1);
  ChainForces result;
  Eigen::Vector2d g = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    g += chain.steps[i].mass * accelerations[i];
    result.g.push_back(g);
  }
  // The last body is pushed by the chain, so that it accelerates against the chain's sign.
  const double a_x = accelerations.back().x();
  if (a_x != 0.0) result.sought_mass = -g.x() / a_x;
  return result;
}

ChainForces chain_at(const NewtonChain& chain, const State& state) {
  std::vector<Eigen::Vector2d> accelerations;
  const auto add = [&](const ChainStep& step) {
    accelerations.push_back(acceleration_of({step.body, step.centre}, state.q, state.v, state.a));
  };
  for (const ChainStep& step : chain.steps) add(step);
  add(chain.last);
  return chain_of(chain, accelerations);
}

BeamLoads beam_loads_of(const NewtonChain& chain, const TaperedBeam& beam,
                        const std::vector<SegmentMass>& distribution,
                        const Eigen::Vector2d& gravity, const State& state) {
  const double angle = state.q[3 * chain.axis_body + 2];
  const ChainForces forces = chain_at(chain, state);

  BeamLoads loads;
  PointLoad first, second, pivot;
  first.s = chain.first_station;
  first.force = in_beam_axes(forces.g[chain.first_end], angle);
  second.s = chain.second_station;
  second.force = in_beam_axes(forces.g[chain.second_end], angle);
  pivot.s = chain.pivot;
  loads.points = {first, second};
  loads.lines = weight_and_inertia(beam, distribution, in_beam_axes(gravity, angle), {});

  const Imbalance open = imbalance_of(loads);
  pivot.force = -open.force;
  pivot.moment = -open.moment - Eigen::Vector3d(pivot.s.value(), 0, 0).cross(pivot.force);
  loads.points.push_back(pivot);
  return loads;
}

}  // namespace boxbeam::planar
