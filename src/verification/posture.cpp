#include "boxbeam/verification/posture.hpp"

#include <algorithm>

namespace boxbeam {

std::vector<BeamLoadRow> load_rows(const BeamLoads& loads, Time time, const Eigen::Matrix3d& R_WS) {
  constexpr double round_off = 1e-12;
  double force = 0.0, moment = 0.0;
  for (const PointLoad& load : loads.points) {
    force = std::max(force, load.force.norm());
    moment = std::max(moment, load.moment.norm());
  }
  std::vector<BeamLoadRow> rows;
  for (const PointLoad& load : loads.points) {
    BeamLoadRow& row = rows.emplace_back();
    row.time = time;
    row.name = load.name;
    row.s = load.s;
    // What is round-off beside the others is none.
    if (load.force.norm() > round_off * force) row.force = load.force;
    if (load.moment.norm() > round_off * moment) row.moment = load.moment;
    row.world = R_WS * row.force;
    row.couple = R_WS * row.moment;
  }
  return rows;
}

}  // namespace boxbeam
