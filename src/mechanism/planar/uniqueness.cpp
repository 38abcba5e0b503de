#include "boxbeam/mechanism/planar/uniqueness.hpp"

#include <algorithm>
#include <iterator>

namespace boxbeam::planar {

void judge_uniqueness(const Mechanism& mechanism, const Eigen::VectorXd& q,
                      DegreesOfFreedom& freedom) {
  if (freedom.redundant == 0) return;
  const DegreesOfFreedom here = degrees_of_freedom_of(mechanism, q);
  // A position that is singular itself says nothing of the others.
  if (here.redundant != freedom.redundant) return;
  for (std::size_t row = 0; row < here.unique.size(); ++row) {
    if (here.unique[row] == 0) freedom.unique[row] = 0;
  }
  std::vector<int> both;
  std::set_union(here.repeating.begin(), here.repeating.end(), freedom.repeating.begin(),
                 freedom.repeating.end(), std::back_inserter(both));
  freedom.repeating = both;
}

}  // namespace boxbeam::planar
