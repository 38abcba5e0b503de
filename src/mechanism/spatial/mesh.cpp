#include "boxbeam/mechanism/spatial/mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "boxbeam/mechanism/spatial/tree.hpp"

namespace boxbeam::spatial {
namespace {

using Eigen::Vector3d;

constexpr double in_line = 1e-9;  // sines, and lengths over that of the mechanism

/// The joints between two bodies: 1 where they carry towards the second, -1 where away.
std::vector<std::pair<std::size_t, double>> joints_between(const Mechanism& mechanism, int from,
                                                           int to) {
  std::vector<std::pair<std::size_t, double>> joints;
  while (from != to) {
    int& further = from > to ? from : to;  // parents come first
    joints.emplace_back(static_cast<std::size_t>(further), from > to ? -1.0 : 1.0);
    further = mechanism.joints[static_cast<std::size_t>(further)].parent;
  }
  return joints;
}

/// A line of the world where all coordinates are zero.
struct MeshAxis {
  Vector3d at, along;

  Vector3d foot_of(const Vector3d& p) const { return at + along.dot(p - at) * along; }
};

class MeshFinder {
 public:
  MeshFinder(const Mechanism& mechanism, const Gearing& gearing)
      : mechanism_(&mechanism), gearing_(&gearing), size_(size_of(mechanism)) {
    state_.coordinates.resize(mechanism.joints.size());
    Tree(mechanism).move(state_);
    first_ = axis_of(gearing.first);
    second_ = axis_of(gearing.second);
  }

  MeshFound find() {
    const Joint& first = joint(gearing_->first);
    const Joint& second = joint(gearing_->second);
    const bool rack = second.kind == JointKind::prismatic;
    if (!find_carrier()) {
      return refused(
          fmt::format("no body keeps the axes of joints \"{}\" and \"{}\" where they are",
                      first.name, second.name),
          "one body carries both wheels, or one of them from a body that turns about "
          "the other's axis (sun and planet)");
    }
    if (!(rack ? find_beside_rack() : find_between_wheels()) || !find_level()) return found_;
    return meshed(rack);
  }

 private:
  const Joint& joint(std::size_t i) const { return mechanism_->joints[i]; }

  MeshAxis axis_of(std::size_t i) const {
    return {state_.bodies[i].joint, in_world(state_, joint(i).parent, joint(i).axis)};
  }

  MeshFound refused(std::string problem, std::string hint) {
    found_ = {{}, std::move(problem), std::move(hint)};
    return found_;
  }
  bool refuse(std::string problem, std::string hint) {
    refused(std::move(problem), std::move(hint));
    return false;
  }

  /// The coordinate of a joint's body seen from another body: a sum of coordinates of joints that
  /// move in line. Nothing where others are between them.
  std::optional<std::vector<Mesh::Part>> coordinate_from(int carrier, std::size_t of) const {
    const MeshAxis axis = axis_of(of);
    std::vector<Mesh::Part> parts;
    for (const auto& [i, sign] : joints_between(*mechanism_, carrier, static_cast<int>(of))) {
      if (joint(i).kind == JointKind::fixed) continue;
      const MeshAxis own = axis_of(i);
      if (joint(i).kind != joint(of).kind || own.along.cross(axis.along).norm() > in_line)
        return std::nullopt;
      const bool apart = (own.at - axis.foot_of(own.at)).norm() > in_line * size_;
      if (joint(i).kind == JointKind::revolute && apart) return std::nullopt;
      parts.push_back({i, std::copysign(sign, sign * own.along.dot(axis.along))});
    }
    return parts;
  }

  bool find_carrier() {
    for (const std::size_t of : {gearing_->second, gearing_->first}) {
      const int carrier = joint(of).parent;
      const auto first = coordinate_from(carrier, gearing_->first);
      const auto second = coordinate_from(carrier, gearing_->second);
      if (!first || !second) continue;
      mesh_.at.body = carrier;
      of_first_ = *first;
      of_second_ = *second;
      return true;
    }
    return false;
  }

  bool find_beside_rack() {
    if (std::abs(first_.along.dot(second_.along)) > in_line) {
      return refuse("the pinion's axis does not stand square to the rack",
                    "a rack shifts square to the axis of its pinion");
    }
    pitch_ = {first_.at + gearing_->ratio * second_.along.cross(first_.along), first_.along};
    return true;
  }

  bool find_between_wheels() {
    const Vector3d across = first_.along.cross(second_.along), between = second_.at - first_.at;
    if (across.norm() > in_line) {
      if (std::abs(between.dot(across)) > in_line * size_ * across.norm()) {
        return refuse(
            "the axes of the two wheels cross without meeting: how their teeth push does "
            "not follow from the ratio",
            "gears have parallel axes, or axes that meet (bevel gears); of worms and "
            "hypoid gears give the forces themselves");
      }
      // Where they meet: (between - s a_1) x a_2 = 0.
      const double s = between.cross(second_.along).dot(across) / across.squaredNorm();
      pitch_ = {first_.at + s * first_.along,
                (first_.along - gearing_->ratio * second_.along).normalized()};
      meet_ = true;
      return true;
    }
    const double ratio = gearing_->ratio * first_.along.dot(second_.along);
    const Vector3d apart = second_.at - first_.foot_of(second_.at);
    if (apart.norm() <= in_line * size_) {
      return refuse("the axes of the two wheels lie in line: they do not mesh with each other",
                    "write the wheels between them, each with the one that it meshes with");
    }
    if (std::abs(ratio - 1.0) <= in_line) {
      return refuse("both wheels turn alike: they cannot roll on each other",
                    "the ratio is negative of two wheels whose axes point alike, and positive and "
                    "not 1 of a wheel in an annulus");
    }
    pitch_ = {first_.at + ratio / (ratio - 1.0) * apart, first_.along};
    return true;
  }

  std::string in_carrier(const Vector3d& v) const {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
  }
  Vector3d seen_from_carrier(const Vector3d& place) const {
    const BodyMotion& carrier = motion_of(state_, mesh_.at.body);
    return carrier.R_WB.transpose() * (place - carrier.position);
  }
  std::string carrier_name() const {
    if (mesh_.at.body == ground) return "the ground";
    return fmt::format("body \"{}\"",
                       mechanism_->bodies[static_cast<std::size_t>(mesh_.at.body)].name);
  }
  std::string pitch_line() const {
    return fmt::format("their pitch line goes through {} m along {} of {}",
                       in_carrier(seen_from_carrier(pitch_.at)),
                       in_carrier(in_axes(state_, mesh_.at.body, pitch_.along)), carrier_name());
  }

  /// Where along the pitch line.
  bool find_level() {
    constexpr double near = 1e-6;
    if (gearing_->at) {
      for (const auto& [i, sign] : joints_between(*mechanism_, mesh_.at.body, gearing_->at->body)) {
        if (joint(i).kind == JointKind::fixed) continue;
        return refuse("the place where the teeth meet does not stand still beside both axes",
                      fmt::format("name a point of {}", carrier_name()));
      }
      const Vector3d given = position_of(state_, *gearing_->at);
      place_ = pitch_.foot_of(given);
      if ((given - place_).norm() > near * size_) {
        return refuse(fmt::format("the teeth do not meet there, {:.4g} m beside the line on which "
                                  "both wheels move alike",
                                  (given - place_).norm()),
                      pitch_line());
      }
      if (!meet_ || (place_ - pitch_.at).norm() > near * size_) return true;
      return refuse("the teeth do not meet where the axes do", pitch_line());
    }
    if (meet_) {
      return refuse("where along them the teeth of bevel gears meet is not known",
                    "write mesh with a point in the middle of their width; " + pitch_line());
    }
    place_ = pitch_.at;
    if (joint(gearing_->second).kind == JointKind::prismatic) return true;
    const double level = first_.along.dot(second_.at - first_.at);
    if (std::abs(level) <= near * size_) return true;
    return refuse(fmt::format("the joints of the two wheels stand {:.4g} m apart along their axes: "
                              "where the teeth meet is not known",
                              std::abs(level)),
                  "write mesh with a point in the middle of their width; " + pitch_line());
  }

  MeshFound meshed(bool rack) {
    const Vector3d from_first = place_ - first_.foot_of(place_);
    const Vector3d from_second = place_ - second_.foot_of(place_);
    const Vector3d moved = rack ? second_.along : second_.along.cross(from_second).eval();
    // The force that drives the second wheel on does the opposite to the first.
    const double lever = moved.norm();
    const Vector3d along = moved / lever;
    Vector3d apart = pitch_.along.cross(along).normalized();
    // A wheel is pushed towards its own axis; in an annulus the smaller one is.
    const bool first_smaller = rack || from_first.norm() < from_second.norm();
    const double away = first_smaller ? apart.dot(from_first) : -apart.dot(from_second);
    apart *= std::copysign(std::tan(gearing_->pressure_angle), away);
    mesh_.at.p = seen_from_carrier(place_);
    mesh_.along = in_axes(state_, mesh_.at.body, along);
    mesh_.apart = in_axes(state_, mesh_.at.body, apart);
    mesh_.offset = lever * gearing_->offset;
    const auto add = [&](const std::vector<Mesh::Part>& parts, double factor) {
      for (const Mesh::Part& part : parts)
        mesh_.parts.push_back({part.joint, factor * part.factor});
    };
    add(of_second_, lever);
    add(of_first_, -lever * gearing_->ratio);
    return {mesh_, "", ""};
  }

  const Mechanism* mechanism_;
  const Gearing* gearing_;
  double size_;
  State state_;
  MeshAxis first_, second_;
  MeshAxis pitch_;  ///< the line on which both move alike
  bool meet_ = false;
  Vector3d place_ = Vector3d::Zero();
  std::vector<Mesh::Part> of_first_, of_second_;
  Mesh mesh_;
  MeshFound found_;
};

}  // namespace

MeshFound mesh_of(const Mechanism& mechanism, const Gearing& gearing) {
  for (const std::size_t i : {gearing.first, gearing.second}) {
    const Joint& joint = mechanism.joints[i];
    const bool wheel = joint.kind == JointKind::revolute;
    const bool rack = joint.kind == JointKind::prismatic && i == gearing.second;
    if (wheel || rack) continue;
    return {{},
            fmt::format("joint \"{}\" is of kind \"{}\": it carries no wheel", joint.name,
                        to_text(joint.kind)),
            "wheels are carried by revolute joints, a rack by a prismatic one"};
  }
  if (gearing.first == gearing.second) {
    return {
        {},
        fmt::format("joint \"{}\" cannot mesh with itself", mechanism.joints[gearing.first].name),
        "name the joints that carry the two wheels"};
  }
  return MeshFinder(mechanism, gearing).find();
}

}  // namespace boxbeam::spatial
