#include "boxbeam/beam/beam_loads.hpp"

#include <Eigen/Geometry>

#include <cassert>

namespace boxbeam {

namespace {

/// Rate of change of the angular momentum of an inertia J.
Eigen::Vector3d spin_change(const Eigen::Matrix3d& J, const BeamMotion& motion) {
  return J * motion.alpha + motion.omega.cross(J * motion.omega);
}

}  // namespace

double torque_of(const PointLoad& load) {
  return load.moment.x() - (load.at.x() * load.force.z() - load.at.y() * load.force.y());
}

void add(std::vector<LineLoad>& sum, double factor, const std::vector<LineLoad>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      add(sum[i].force[axis], factor, lines[i].force[axis]);
      add(sum[i].couple[axis], factor, lines[i].couple[axis]);
    }
  }
}

void add(BeamLoads& sum, double factor, const BeamLoads& loads) {
  assert(loads.points.size() <= sum.points.size() && loads.lines.size() <= sum.lines.size());
  for (std::size_t i = 0; i < loads.points.size(); ++i) {
    sum.points[i].force += factor * loads.points[i].force;
    sum.points[i].moment += factor * loads.points[i].moment;
  }
  add(sum.lines, factor, loads.lines);
}

void unload(std::vector<LineLoad>& lines) {
  for (LineLoad& line : lines) {
    line.force = {};
    line.couple = {};
  }
}

void unload(BeamLoads& loads) {
  for (PointLoad& load : loads.points) {
    load.force.setZero();
    load.moment.setZero();
  }
  unload(loads.lines);
}

std::vector<LineLoad> unloaded_lines(const TaperedBeam& beam) {
  std::vector<LineLoad> lines;
  lines.reserve(beam.segments.size());
  for (const Segment& segment : beam.segments) {
    lines.push_back({segment.start, segment.length, {}, {}});
  }
  return lines;
}

void add_from_outside(const Eigen::Vector3d& at_start, const Eigen::Vector3d& at_end,
                      LineLoad& stretch) {
  const double length = stretch.length.value();
  const auto line = [&](double a, double b) { return Polynomial<1>{{a, (b - a) / length}}; };
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    stretch.force[k] = stretch.force[k] + line(at_start[axis], at_end[axis]);
    if (axis == 0) continue;
    // Where it changes its sense the straight line between the ends is above what pushes either
    // way.
    for (const std::size_t against : {0U, 1U}) {
      const double sense = against == 0 ? 1.0 : -1.0;
      Polynomial<1>& size = stretch.outside[k - 1][against];
      size =
          size + line(std::max(0.0, sense * at_start[axis]), std::max(0.0, sense * at_end[axis]));
    }
  }
}

std::vector<LineLoad> weight_and_inertia(const TaperedBeam& beam,
                                         const std::vector<SegmentMass>& distribution,
                                         const Eigen::Vector3d& gravity, const BeamMotion& motion) {
  assert(distribution.size() == beam.segments.size());
  const Eigen::Vector3d along = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d gradient =
      motion.alpha.cross(along) + motion.omega.cross(motion.omega.cross(along));
  std::vector<LineLoad> loads = unloaded_lines(beam);
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const double start = beam.segments[i].start.value();
    const Eigen::Vector3d constant = gravity - motion.acceleration - start * gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Polynomial<1> field{{constant[axis], -gradient[axis]}};
      loads[i].force[static_cast<std::size_t>(axis)] = distribution[i].mass * field;
    }
  }
  if (!beam.rotary_inertia) return loads;
  // The moments are linear in I_y, I_z and I_yz: what each of them gives.
  const Eigen::Vector3d by_y = spin_change(Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal(), motion);
  const Eigen::Vector3d by_z = spin_change(Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal(), motion);
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  product(1, 2) = product(2, 1) = -1.0;
  const Eigen::Vector3d by_yz = spin_change(product, motion);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const SegmentMass& of = distribution[i];
      loads[i].couple[static_cast<std::size_t>(axis)] =
          -by_y[axis] * of.rotary_y + -by_z[axis] * of.rotary_z + -by_yz[axis] * of.rotary_yz;
    }
  }
  return loads;
}

Imbalance imbalance_of(const BeamLoads& loads) {
  Imbalance sum;
  for (const PointLoad& load : loads.points) {
    sum.force += load.force;
    sum.moment += load.moment + Eigen::Vector3d(load.s.value(), 0.0, 0.0).cross(load.force);
  }
  for (const LineLoad& line : loads.lines) {
    const double length = line.length.value();
    const Polynomial<1> arm{{line.start.value(), 1.0}};
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
