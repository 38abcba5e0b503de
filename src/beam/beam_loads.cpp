#include "boxbeam/beam/beam_loads.hpp"

#include <Eigen/Geometry>

#include <cassert>

namespace boxbeam {

std::vector<LineLoad> weight_and_inertia(const TaperedBeam& beam,
                                         const std::vector<SegmentMass>& distribution,
                                         const Eigen::Vector3d& gravity,
                                         const AxisAcceleration& acceleration) {
  assert(distribution.size() == beam.segments.size());
  std::vector<LineLoad> loads(beam.segments.size());
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const double start = beam.segments[i].start.value();
    for (int axis = 0; axis < 3; ++axis) {
      const double constant =
          gravity[axis] - acceleration.at_start[axis] - acceleration.gradient[axis] * start;
      const Polynomial<1> field{{constant, -acceleration.gradient[axis]}};
      loads[i].force[static_cast<std::size_t>(axis)] = distribution[i].mass * field;
    }
    loads[i].couple[1] = -acceleration.alpha_y * distribution[i].rotary;
  }
  return loads;
}

Imbalance imbalance_of(const TaperedBeam& beam, const BeamLoads& loads) {
  Imbalance sum;
  for (const PointLoad& load : loads.points) {
    sum.force += load.force;
    sum.moment += load.moment + Eigen::Vector3d(load.s.value(), 0.0, 0.0).cross(load.force);
  }
  for (std::size_t i = 0; i < loads.segments.size(); ++i) {
    const Segment& segment = beam.segments[i];
    const double length = segment.length.value();
    const Polynomial<1> arm{{segment.start.value(), 1.0}};
    const LineLoad& line = loads.segments[i];
    const auto over = [&](const auto& p) { return integral_of(p)(length); };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum.force[static_cast<int>(axis)] += over(line.force[axis]);
      sum.moment[static_cast<int>(axis)] += over(line.couple[axis]);
    }
    sum.moment.y() -= over(arm * line.force[2]);
    sum.moment.z() += over(arm * line.force[1]);
  }
  return sum;
}

}  // namespace boxbeam
