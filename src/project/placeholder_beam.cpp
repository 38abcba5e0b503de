#include "placeholder_beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam::robots {

std::size_t beam_link_of(const Robot& robot, const std::string& wanted) {
  const std::vector<Link>& links = robot.links;
  const auto mass_of = [&](std::size_t i) {
    return links[i].inertial ? links[i].inertial->mass : 0.0;
  };
  if (wanted.empty()) {
    std::optional<std::size_t> heaviest;
    for (std::size_t i = 0; i < links.size(); ++i)
      if (i != robot.root && (!heaviest || mass_of(i) > mass_of(*heaviest))) heaviest = i;
    if (heaviest) return *heaviest;
    throw InputError(fmt::format("{} has no link but its root: nothing moves", robot.file),
                     robot.is_ground(robot.root)
                         ? "a beam is a link that a joint carries"
                         : "name it where it is the beam: --beam " + links[robot.root].name);
  }
  std::vector<std::string> known;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (robot.is_ground(i)) continue;
    if (links[i].name == wanted) return i;
    known.push_back(links[i].name);
  }
  throw InputError(fmt::format("{} has no link \"{}\" that could be the beam", robot.file, wanted),
                   fmt::format("its links: {}", fmt::join(known, ", ")));
}

PlaceholderBeam placeholder_beam(const Robot& robot, std::size_t link) {
  constexpr double nothing = 1e-6;  // [m]
  PlaceholderBeam beam;
  for (const Joint& joint : robot.joints)
    if (joint.child == link) beam.joint = joint.point;
  std::vector<Eigen::Vector3d> places;  // from the joint that carries it
  for (const Joint& joint : robot.joints)
    if (joint.parent == link) places.push_back(joint.xyz - beam.joint);
  for (const Closing& closing : robot.closings) {
    if (closing.a == link) places.push_back(closing.p_a - beam.joint);
    if (closing.b == link) places.push_back(closing.p_b - beam.joint);
  }
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : places)
    if (place.norm() > end.norm()) end = place;
  beam.why = "from the link's joint to the farthest one that it carries";
  const std::optional<Inertial>& inertial = robot.links[link].inertial;
  if (end.norm() <= nothing && inertial) {
    end = 2.0 * (inertial->centre - beam.joint);
    places.push_back(end);
    beam.why = "from the link's joint through its centre of mass, and as far again";
  }
  if (end.norm() > nothing) {
    beam.axis = end.normalized();
    double low = 0.0, high = 0.0;
    for (const Eigen::Vector3d& place : places) {
      low = std::min(low, place.dot(beam.axis));
      high = std::max(high, place.dot(beam.axis));
    }
    beam.start = low;
    beam.length = high - low;
  } else {
    beam.why = "1 m along x: joints and centre of mass of the link are at one place";
  }
  const Eigen::Vector3d up =
      std::abs(beam.axis.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  beam.z = (up - up.dot(beam.axis) * beam.axis).normalized();
  // Walls of a twentieth of the width: A = w^2 - (0.9 w)^2, m = density A L.
  const double mass = inertial ? inertial->mass : 0.0;
  beam.width =
      mass > 0.0 ? std::sqrt(mass / (0.19 * steel_density * beam.length)) : beam.length / 20.0;
  beam.wall = beam.width / 20.0;
  return beam;
}

}  // namespace boxbeam::robots
