// What loops hold without any load.
#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <map>

#include "loop_factors.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {

/// Forces that loops can hold without any load make what they reach not unique: those of an
/// equation that is left over, with what the chosen ones hold against it.
void Loops::judge_uniqueness(const Tree& tree, const State& state) {
  constexpr double nothing = 1e-9;
  const Mechanism& mechanism = tree.mechanism();
  const std::size_t bodies = mechanism.bodies.size();
  if (unique_.empty()) unique_.assign(bodies + mechanism.closing.size(), 1);
  Rows over;
  std::set_difference(all_.begin(), all_.end(), chosen_.begin(), chosen_.end(),
                      std::back_inserter(over));
  if (over.empty()) return;
  const SparsePattern pattern = pattern_of(over);
  const std::vector<double> values = entries(tree, state, over, free_);
  const LoopFactors J = factors(tree, state);
  const auto judge = [&](std::size_t index, const Wrench& change) {
    if (change.force.norm() + change.moment.norm() / size_ > 1e-6) unique_[index] = 0;
  };
  for (std::size_t c = 0; c < over.size(); ++c) {
    Eigen::VectorXd asked = Eigen::VectorXd::Zero(pattern.cols);
    for (int e = pattern.row_start[c]; e < pattern.row_start[c + 1]; ++e)
      asked[pattern.col[static_cast<std::size_t>(e)]] = -values[static_cast<std::size_t>(e)];
    Eigen::VectorXd held = Eigen::VectorXd::Zero(row_scale_.size());
    if (pattern.cols > 0) held(chosen_) = J.solve_transposed(asked);
    held[static_cast<Eigen::Index>(over[c])] = 1.0;
    held.normalize();
    held = (held.array().abs() < nothing).select(0.0, held);
    const std::vector<Wrench> closing =
        closing_wrenches(mechanism, rows_, size_ * row_scale_.cwiseProduct(held), state);
    std::map<std::size_t, Wrench> carried;  // by the joints between the bodies of closing ones
    for (std::size_t k = 0; k < closing.size(); ++k) {
      if (closing[k].force.isZero(0.0) && closing[k].moment.isZero(0.0)) continue;
      judge(bodies + k, closing[k]);
      const Eigen::Vector3d place = position_of(state, place_of(mechanism.closing[k]));
      each_between(mechanism, mechanism.closing[k], [&](std::size_t i, double sign) {
        Wrench& at = carried[i];
        at.force += sign * closing[k].force;
        at.moment +=
            sign * (closing[k].moment + (place - state.bodies[i].joint).cross(closing[k].force));
      });
    }
    for (const auto& [i, wrench] : carried) judge(i, wrench);
  }
}

}  // namespace boxbeam::spatial
