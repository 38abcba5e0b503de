#include "boxbeam/mechanism/planar/mechanism.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/index_by_name.hpp"
#include "joint_kinds.hpp"

namespace boxbeam::planar {
namespace {

/// Counts the equations that EquationsOfKind tells.
struct Equations {
  int count = 0;
  int of_distances = 0;    ///< how many are of the distance of two points
  unsigned of_angles = 0;  ///< bit by bit, which are of angles

  void coincide(const Attachment&, const Attachment&) { count += 2; }
  void across(const Attachment&, const Attachment&, double) { ++count; }
  void along(const Attachment&, const Attachment&, double, double, double) { ++count; }
  void coordinate(const Attachment&, int) { ++count; }
  void turn(const Attachment&, const Attachment&, double, double) { of_angles |= 1U << count++; }
  void length(const Attachment&, const Attachment&, double) {
    ++of_distances;
    ++count;
  }
  void mesh(const Attachment&, const Attachment&, double, double, double) { ++count; }
  void follows(const Driver&) {}
};

Equations equations_in(const Joint& joint) {
  Equations equations;
  std::visit(EquationsOfKind<Equations>{equations}, joint.kind);
  return equations;
}

}  // namespace

int equations_of(const Joint& joint) { return equations_in(joint).count; }

bool is_length_equation(const Joint& joint, int row) {
  return (equations_in(joint).of_angles & (1U << row)) == 0U;
}

bool is_rod(const Joint& joint) {
  const Equations equations = equations_in(joint);
  return equations.count == 1 && equations.of_distances == 1;
}

std::pair<Attachment, Attachment> ends_of(const Joint& joint) {
  const auto [first, second] = ends_in(joint);
  return {*first, *second};
}

std::pair<Attachment*, Attachment*> ends_in(Joint& joint) {
  return std::visit([](auto& kind) { return attachments_in(kind); }, joint.kind);
}

std::pair<const Attachment*, const Attachment*> ends_in(const Joint& joint) {
  return std::visit([](const auto& kind) { return attachments_in(kind); }, joint.kind);
}

std::pair<Hold, Hold> holds_of(const Joint& joint) { return std::visit(HoldsOfKind{}, joint.kind); }

Eigen::Index Mechanism::equations() const {
  Eigen::Index sum = 0;
  for (const Joint& joint : joints) sum += equations_of(joint);
  return sum;
}

int body_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.bodies, name);
}

int joint_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.joints, name);
}

std::vector<std::string> names_of_joints(const Mechanism& mechanism,
                                         const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints) {
    names.push_back(mechanism.joints[static_cast<std::size_t>(joint)].name);
  }
  return names;
}

Eigen::VectorXd sketch_of(const Mechanism& mechanism) {
  Eigen::VectorXd q(mechanism.coordinates());
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    q.segment<2>(i) = body.sketch.centre;
    q[i + 2] = body.sketch.angle;
    i += 3;
  }
  return q;
}

Eigen::VectorXd start_velocity_of(const Mechanism& mechanism) {
  Eigen::VectorXd v(mechanism.coordinates());
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    v.segment<3>(i) = body.start_velocity;
    i += 3;
  }
  return v;
}

double size_of(const Mechanism& mechanism) {
  double size = 0.0;
  std::vector<Attachment> on_ground;
  for (const Joint& joint : mechanism.joints) {
    if (!is_length_equation(joint, 0)) continue;  // its points only say where moments act
    const auto [a, b] = ends_of(joint);
    for (const Attachment& end : {a, b}) {
      if (end.body != ground) {
        size = std::max(size, end.p.norm());
      } else if (!is_driver(joint)) {
        on_ground.push_back(end);
      }
    }
    if (const auto* distance = std::get_if<Distance>(&joint.kind)) {
      size = std::max(size, distance->length);
    }
  }
  for (const Attachment& end : on_ground) {
    size = std::max(size, (end.p - on_ground.front().p).norm());
  }
  return size > 0.0 ? size : 1.0;
}

namespace {

/// What a force follows over time; a spring follows the motion.
struct FollowedBy {
  std::string_view name;
  std::vector<DriverUse>& uses;

  void operator()(const Spring&) const {}
  void operator()(const TorsionSpring&) const {}
  void operator()(const PinWithClearance&) const {}
  void operator()(const PointForce& force) const {
    uses.push_back({&force.size, false, DriverUse::On::force, name});
  }
  void operator()(const Couple& couple) const {
    uses.push_back({&couple.size, false, DriverUse::On::couple, name});
  }
};

}  // namespace

std::vector<DriverUse> functions_of(const Mechanism& mechanism) {
  std::vector<DriverUse> uses;
  for (const Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<Driven>(&joint.kind);
    if (driven == nullptr) continue;
    uses.push_back({&driven->driver, driven->coordinate == Coordinate::angle, DriverUse::On::joint,
                    joint.name});
  }
  for (const AppliedForce& force : mechanism.forces)
    std::visit(FollowedBy{force.name, uses}, force.kind);
  return uses;
}

std::optional<Mechanism> without_clearance(const Mechanism& mechanism) {
  std::optional<Mechanism> fitting;
  for (const AppliedForce& force : mechanism.forces) {
    const auto* const pin = std::get_if<PinWithClearance>(&force.kind);
    if (pin == nullptr) continue;
    if (!fitting) fitting = mechanism;
    fitting->joints.push_back({force.name, Pin{{pin->a.body, pin->a.p + pin->start}, pin->b}});
  }
  if (!fitting) return fitting;
  std::erase_if(fitting->forces, [](const AppliedForce& force) {
    return std::holds_alternative<PinWithClearance>(force.kind);
  });
  return fitting;
}

TimeSpan time_span_of(const Mechanism& mechanism) {
  return boxbeam::time_span_of(functions_of(mechanism), mechanism.duration);
}

}  // namespace boxbeam::planar
