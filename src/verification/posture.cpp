#include "boxbeam/verification/posture.hpp"

namespace boxbeam {

std::vector<BeamLoadRow> load_rows(const BeamLoads& loads, Time time, const Eigen::Matrix3d& R_WS) {
  std::vector<BeamLoadRow> rows;
  for (const PointLoad& load : loads.points) {
    BeamLoadRow& row = rows.emplace_back();
    row.time = time;
    row.name = load.name;
    row.s = load.s;
    row.force = load.force;
    row.moment = load.moment;
    row.world = R_WS * load.force;
    row.couple = R_WS * load.moment;
  }
  return rows;
}

}  // namespace boxbeam
