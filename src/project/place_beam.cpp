#include <fmt/format.h>
#include <Eigen/Geometry>

#include <Eigen/Geometry>
#include <algorithm>

#include "readers.hpp"

namespace boxbeam::readers {

spatial::BeamPlacement read_placement(TableReader& beam, const spatial::Mechanism& mechanism,
                                      int body) {
  spatial::BeamPlacement placement;
  placement.body = body;
  const std::string start =
      beam.text({"start", "a point of the body at s = 0; its origin where not said"}, "");
  const Eigen::Vector3d axis = beam.direction({"axis", "the beam's axis in the body"});
  const Eigen::Vector3d z = beam.direction({"z", "the beam's z in the body"});
  if (!beam.problems().empty() || body < 0) return placement;
  const spatial::Body& of = mechanism.bodies[static_cast<std::size_t>(body)];
  if (!start.empty()) {
    const auto point = std::find_if(of.points.begin(), of.points.end(),
                                    [&](const auto& p) { return p.name == start; });
    if (point == of.points.end()) {
      beam.problem("start", fmt::format("body \"{}\" has no point \"{}\"", of.name, start),
                   unknown_hint(start, names_of(of.points)));
      return placement;
    }
    placement.start = point->p;
  }
  if (std::abs(axis.dot(z)) > 1e-9) {
    beam.problem("z", "the section's z stands square on the beam's axis",
                 "choose a direction square to \"axis\"; both are in the axes of the beam's body");
  }
  placement.axes.col(0) = axis;
  placement.axes.col(2) = (z - axis.dot(z) * axis).normalized();
  placement.axes.col(1) = placement.axes.col(2).cross(placement.axes.col(0));
  return placement;
}

namespace {

/// Notes joints and loads on the beam's body that stand beyond the ends of the beam.
void check_on_beam(TableReader& root, const TaperedBeam& beam,
                   const spatial::BeamPlacement& placement, const spatial::Mechanism& mechanism) {
  const double whole = beam.length().value();
  const auto look = [&](const char* table, const std::string& name, const Eigen::Vector3d& place) {
    const double s = in_beam(placement, place).x();
    if (s >= -1e-9 * whole && s <= (1.0 + 1e-9) * whole) return;
    root.table(table).problem(
        name.substr(0, name.find('.')),
        fmt::format("\"{}\" acts beyond the end of the beam, at s = {:.6g} m", name, s),
        fmt::format("s goes from 0 to {:.6g} m; what stands farther belongs to a body of its own, "
                    "fixed to the beam",
                    whole));
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == placement.body) look("joints", joint.name, joint.point);
    if (joint.parent == placement.body) look("joints", joint.name, joint.at);
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    // The wheels of teeth stand where their joints do.
    if (spatial::has_teeth(joint.kind)) continue;
    for (const spatial::Attachment& end : {joint.a, joint.b}) {
      if (end.body == placement.body) look("joints", joint.name, end.p);
    }
  }
  for (const spatial::Spring& spring : mechanism.springs) {
    for (const spatial::Attachment& end : {spring.a, spring.b}) {
      if (end.body == placement.body) look("forces", spring.name, end.p);
    }
  }
  for (const spatial::AppliedLoad& load : mechanism.loads) {
    if (load.on == placement.body && load.at.body == placement.body) {
      look("forces", load.name, load.at.p);
    }
  }
}

}  // namespace

void place_beam(TableReader& root, const TaperedBeam& beam, const spatial::BeamPlacement& placement,
                spatial::Mechanism& mechanism) {
  spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(placement.body)];
  give_mass(body, placement, beam);
  check_on_beam(root, beam, placement, mechanism);
  const double whole = beam.length().value();
  std::vector<Length> ends{Length{}};
  for (const Segment& segment : beam.segments) ends.push_back(segment.end());
  for (const spatial::LineForce& line : mechanism.line_forces) {
    if (line.on != placement.body) continue;
    const Eigen::Vector3d from = in_beam(placement, line.from);
    const Eigen::Vector3d to = in_beam(placement, line.to);
    const bool beside = (from - to).tail<2>().norm() < 1e-9 * whole;
    for (const Eigen::Vector3d& at : {from, to}) {
      const bool at_end = std::any_of(ends.begin(), ends.end(), [&](Length end) {
        return std::abs(at.x() - end.value()) < 1e-9 * whole;
      });
      if (at_end && (beside || at.tail<2>().norm() < 1e-9 * whole)) continue;
      root.table("forces").problem(
          line.name,
          fmt::format("line force \"{}\" reaches to s = {:.6g} m of the beam, {:.6g} m off its "
                      "axis: it lies along the axis, or beside it at one distance, over whole "
                      "segments",
                      line.name, at.x(), at.tail<2>().norm()),
          "end it where segments end, or split the segment there");
      break;
    }
  }
}

}  // namespace boxbeam::readers
