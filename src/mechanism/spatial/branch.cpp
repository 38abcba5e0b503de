#include "boxbeam/mechanism/spatial/branch.hpp"

#include <Eigen/Geometry>

namespace boxbeam::spatial {

double measure_of(const Branch& branch, const State& state) {
  const Eigen::Vector3d from = position_of(state, branch.from);
  Eigen::Vector3d along = position_of(state, branch.to) - from;
  if (branch.via) along = (position_of(state, *branch.via) - from).cross(along);
  return along.dot(in_world(state, branch.axes, branch.direction));
}

std::vector<std::pair<std::string, int>> branch_signs_of(const Mechanism& mechanism,
                                                         const State& state) {
  std::vector<std::pair<std::string, int>> signs;
  for (const Branch& branch : mechanism.branches) {
    const double measure = measure_of(branch, state);
    signs.emplace_back(branch.name, measure > 0.0 ? 1 : (measure < 0.0 ? -1 : 0));
  }
  return signs;
}

std::string loops_off_branch(const Mechanism& mechanism, const State& state) {
  std::string names;
  for (const Branch& branch : mechanism.branches) {
    if (measure_of(branch, state) * branch.sign > 0.0) continue;
    names += (names.empty() ? "loop " : ", loop ") + branch.name;
  }
  return names;
}

}  // namespace boxbeam::spatial
