#include "boxbeam/mechanism/planar/chain_moments.hpp"

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

}  // namespace boxbeam::planar
