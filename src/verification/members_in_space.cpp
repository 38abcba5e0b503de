#include "members_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "boxbeam/section/section_properties.hpp"
#include "neighbour_loads.hpp"
#include "neighbour_parts.hpp"
#include "sliding_joints.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lengths that are the same, by the length of a rod.
constexpr double same_place_on_rod = 1e-6;

/// How the mass of a body lies about a rod, by its integrals.
struct LaidOut {
  RodMass along;
  double y_square = 0.0, z_square = 0.0, y_z = 0.0;  ///< integrals over the mass [kg m^2]
  double askew = 0.0;                                ///< product of inertia with the line [kg m^2]
};

LaidOut laid_out(const spatial::Body& body, const spatial::BeamPlacement& placement,
                 double length) {
  const Vector3d centre = spatial::in_beam(placement, body.centre);
  const Matrix3d J = placement.axes.transpose() * body.inertia * placement.axes;
  LaidOut of;
  // J_xx = int y^2 + z^2, and so on: int x^2 = (J_yy + J_zz - J_xx)/2.
  of.along = {body.mass, length, centre.x(), centre.tail<2>().norm(),
              0.5 * (J(1, 1) + J(2, 2) - J(0, 0))};
  of.y_square = 0.5 * (J(0, 0) + J(2, 2) - J(1, 1));
  of.z_square = 0.5 * (J(0, 0) + J(1, 1) - J(2, 2));
  of.y_z = -J(1, 2);
  of.askew = std::hypot(J(0, 1), J(0, 2));
  return of;
}

/// Mass along a rod, slices of which have what its body has of rotary inertia, by their mass.
SegmentMass mass_along(const LaidOut& of) {
  SegmentMass along;
  along.mass = of.along.along().value_or(Polynomial<2>{});
  if (!(of.along.mass > 0.0)) return along;
  const auto sliced = [&](double integral) {
    Polynomial<4> per_length;
    for (std::size_t i = 0; i < along.mass.size; ++i)
      per_length.c[i] = integral / of.along.mass * along.mass.c[i];
    return per_length;
  };
  along.rotary_y = sliced(of.z_square);
  along.rotary_z = sliced(of.y_square);
  along.rotary_yz = sliced(of.y_z);
  return along;
}

bool alike_about_both_axes(const Section& section) {
  const SectionProperties of = properties_of(section);
  constexpr double alike = 1e-6;
  return of.I_1 - of.I_2 <= alike * of.I_1;
}

/// Calls f(name, place in its axes) for all that takes hold of a body at a point of it.
template <class Function>
void each_place_on(const spatial::Mechanism& mechanism, int body, const Function& f) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == body) f(joint.name, joint.point);
    if (joint.parent == body) f(joint.name, joint.at);
  }
  const auto ends = [&](const auto& of) {
    for (const spatial::Attachment& end : {of.a, of.b})
      if (end.body == body) f(of.name, end.p);
  };
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    if (!spatial::has_teeth(joint.kind)) ends(joint);
  for (const spatial::Spring& spring : mechanism.springs) ends(spring);
  for (const spatial::AppliedLoad& load : mechanism.loads)
    if (load.on == body && load.at.body == body) f(load.name, load.at.p);
}

/// A frame without mass that joints of several movements have between these.
bool is_between_movements(const spatial::Mechanism& mechanism, int body) {
  if (body == spatial::ground) return false;
  const spatial::Body& of = mechanism.bodies[static_cast<std::size_t>(body)];
  return of.mass == 0.0 && of.inertia.isZero(0.0);
}

bool turns_freely(const spatial::Joint& joint) {
  return joint.kind == spatial::JointKind::revolute && !spatial::is_driven(joint);
}

/// Whether a body turns freely about two axes where each joint takes hold of it.
bool turns_about_two_axes(const spatial::Mechanism& mechanism, int body) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) != body && joint.parent != body) continue;
    if (!turns_freely(joint)) return false;
    if (static_cast<int>(i) == body) {
      if (!is_between_movements(mechanism, joint.parent)) return false;
      if (!turns_freely(mechanism.joints[static_cast<std::size_t>(joint.parent)])) return false;
      continue;
    }
    if (!is_between_movements(mechanism, static_cast<int>(i))) return false;
    const auto further =
        std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                     [&](const spatial::Joint& of) { return of.parent == static_cast<int>(i); });
    if (further == mechanism.joints.end() || !turns_freely(*further)) return false;
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    if (joint.a.body != body && joint.b.body != body) continue;
    using Kind = spatial::ClosingKind;
    if (joint.kind != Kind::universal && joint.kind != Kind::spherical &&
        joint.kind != Kind::distance)
      return false;
  }
  return true;
}

bool is_loaded_at_ends_alone(const spatial::Mechanism& mechanism, const ElasticMember& rod) {
  const double length = rod.beam->length().value();
  bool at_ends = true;
  each_place_on(mechanism, rod.placement.body, [&](const std::string&, const Vector3d& place) {
    const Vector3d at = spatial::in_beam(rod.placement, place);
    const double from_end = std::min(std::abs(at.x()), std::abs(at.x() - length));
    if (std::hypot(from_end, at.tail<2>().norm()) > same_place_on_rod * length) at_ends = false;
  });
  const auto on_rod = [&](const auto& load) { return load.on == rod.placement.body; };
  return at_ends &&
         std::none_of(mechanism.line_forces.begin(), mechanism.line_forces.end(), on_rod) &&
         std::none_of(mechanism.loads.begin(), mechanism.loads.end(),
                      [&](const spatial::AppliedLoad& load) {
                        return on_rod(load) && load.kind == spatial::LoadKind::couple;
                      });
}

/// The member that something elastic beside the beam is, if it is one.
struct MemberBeside {
  const Project& project;
  const spatial::Mechanism& mechanism;
  const ElasticBeside& of;

  std::optional<ElasticMember> operator()(const WholeBody& whole) const {
    return ElasticMember{&of.beam, placement_in(project, whole.placement, mechanism),
                         project.model.youngs_modulus, project.model.shear_modulus};
  }
  std::optional<ElasticMember> operator()(const RodBody& rod) const {
    if (!obstacle_to_rod(project, of, rod).empty()) return std::nullopt;
    ElasticMember member{&of.beam, placement_in(project, rod.placement, mechanism),
                         rod_modulus_of(project).value(), rod_shear_modulus_of(project).value()};
    const auto body = static_cast<std::size_t>(member.placement.body);
    member.masses = {
        mass_along(laid_out(mechanism.bodies[body], member.placement, of.beam.length().value()))};
    member.bows_alone = turns_about_two_axes(mechanism, member.placement.body) &&
                        is_loaded_at_ends_alone(mechanism, member);
    return member;
  }
  std::optional<ElasticMember> operator()(const PlanarRod&) const { return std::nullopt; }
  std::optional<ElasticMember> operator()(const RodLink&) const { return std::nullopt; }
  std::optional<ElasticMember> operator()(const planar::ElasticJoint&) const {
    return std::nullopt;
  }
  std::optional<ElasticMember> operator()(const spatial::ElasticJoint&) const {
    return std::nullopt;
  }
};

WaysToGive ways_of(const spatial::ElasticJoint& joint) {
  using Kind = spatial::ClosingKind;
  const Give shift{joint.stiffness, joint.damping},
      turn{joint.turning_stiffness, joint.turning_damping};
  switch (joint.kind) {
    case Kind::fixed: return {shift, shift, turn, turn, turn};
    case Kind::revolute: return {shift, shift, {}, turn, turn};
    case Kind::prismatic: return {{}, shift, turn, turn, turn};
    case Kind::cylindrical: return {{}, shift, {}, turn, turn};
    case Kind::universal: return {shift, shift, {}, {}, turn};
    case Kind::spherical: return {shift, shift, {}, {}, {}};
    case Kind::planar: return {shift, {}, {}, turn, turn};
    case Kind::slot: return {{}, shift, {}, {}, {}};
    case Kind::distance: return {shift, {}, {}, {}, {}};
    case Kind::screw: return {shift, shift, {}, turn, turn};
    case Kind::gear:
    case Kind::rack: return {};
  }
  return {};
}

/// By how many movements a joint of this kind carries a body.
int movements_of(spatial::ClosingKind kind) {
  using Kind = spatial::ClosingKind;
  switch (kind) {
    case Kind::cylindrical:
    case Kind::universal: return 2;
    case Kind::spherical:
    case Kind::planar: return 3;
    case Kind::fixed:
    case Kind::revolute:
    case Kind::prismatic:
    case Kind::slot:
    case Kind::distance:
    case Kind::screw:
    case Kind::gear:
    case Kind::rack: return 1;
  }
  return 1;
}

}  // namespace

spatial::BeamBody ElasticMember::body_in(const spatial::Mechanism& mechanism) const {
  spatial::BeamBody body = spatial::beam_body_of(*beam, placement, mechanism);
  if (!masses.empty()) body.distribution = masses;
  return body;
}

std::vector<ElasticMember> elastic_members(const Project& project,
                                           const spatial::Mechanism& mechanism) {
  std::vector<ElasticMember> members{{&project.beam, placement_in(project, mechanism),
                                      project.model.youngs_modulus, project.model.shear_modulus}};
  for (const ElasticBeside& of : project.elastic_beside)
    if (auto member = std::visit(MemberBeside{project, mechanism, of}, of.place))
      members.push_back(std::move(*member));
  return members;
}

std::string obstacle_to_rod(const Project& project, const ElasticBeside& of, const RodBody& rod) {
  const spatial::Mechanism& mechanism = spatial_of(project);
  const int own = rod.placement.body;
  const double length = of.beam.length().value();
  const auto on_body = [&](const ElasticBeside& other) {
    const auto* const place = std::get_if<RodBody>(&other.place);
    return place != nullptr && place->placement.body == own;
  };
  if (std::count_if(project.elastic_beside.begin(), project.elastic_beside.end(), on_body) > 1)
    return "its body has several rods";
  if (!rod.directed && !alike_about_both_axes(of.beam.segments.front().from))
    return "where its section points is not said (z)";
  const LaidOut mass =
      laid_out(mechanism.bodies[static_cast<std::size_t>(own)], rod.placement, length);
  if (mass.along.beside > same_place_on_rod * length)
    return "its centre of mass lies beside its line";
  if (mass.askew > same_place_on_rod * mass.along.mass * length * length)
    return "its line is no principal axis of inertia of its body";
  if (!mass.along.along())
    return "by its inertia its mass lies too near its ends, or too near one place, to be laid out "
           "along it";
  const std::string moves = moving_along(mechanism, own);
  if (!moves.empty()) return fmt::format("joint {} moves along it", moves);
  std::string beyond;
  each_place_on(mechanism, own, [&](const std::string& name, const Vector3d& place) {
    const double part = spatial::in_beam(rod.placement, place).x() / length;
    if (part < -same_place_on_rod || part > 1.0 + same_place_on_rod) beyond = name;
  });
  if (!beyond.empty()) return fmt::format("{} takes hold of its body beyond its ends", beyond);
  for (const spatial::LineForce& line : mechanism.line_forces)
    if (line.on == own) return fmt::format("{} acts along it", line.name);
  for (const spatial::AppliedLoad& load : mechanism.loads)
    if (load.on == own && load.at.body != own)
      return fmt::format("{} acts on it at a place of another body", load.name);
  return "";
}

GivingWay::GivingWay(const Project& project) {
  for (const ElasticBeside& of : project.elastic_beside) {
    if (const auto* const joint = std::get_if<spatial::ElasticJoint>(&of.place)) {
      joints_.push_back({of.name, *joint});
    } else if (const auto* const link = std::get_if<RodLink>(&of.place)) {
      const Section& section = of.beam.segments.front().from;
      lines_.push_back({spatial_of(project).closing[link->index].name,
                        (rod_modulus_of(project) * properties_of(section).area).value(),
                        project.model.retardation});
    }
  }
}

bool gives_way(const WaysToGive& ways) {
  const std::array<const Give*, 5> all{&ways.along, &ways.across, &ways.about, &ways.first_tilt,
                                       &ways.second_tilt};
  return std::any_of(all.begin(), all.end(),
                     [](const Give* of) { return !std::isinf(of->stiffness); });
}

bool GivingWay::is_damped() const {
  return std::any_of(joints_.begin(), joints_.end(),
                     [](const NamedJoint& given) {
                       return given.of.damping > 0.0 || given.of.turning_damping > 0.0;
                     }) ||
         std::any_of(lines_.begin(), lines_.end(),
                     [](const Line& line) { return line.retardation > 0.0; });
}

WaysToGive GivingWay::of(const spatial::Joint& joint) const {
  for (const NamedJoint& given : joints_) {
    const int count = movements_of(given.of.kind);
    if (joint.name == (count == 1 ? given.name : fmt::format("{}.{}", given.name, count)))
      return ways_of(given.of);
  }
  return {};
}

WaysToGive GivingWay::of(const spatial::ClosingJoint& joint, double length) const {
  for (const NamedJoint& given : joints_)
    if (joint.name == given.name) return ways_of(given.of);
  for (const Line& line : lines_) {
    if (joint.name != line.joint) continue;
    const double stiffness = line.EA / length;
    return {{stiffness, line.retardation * stiffness}, {}, {}, {}, {}};
  }
  return {};
}

bool has_springs(const spatial::Mechanism& mechanism) {
  return !mechanism.springs.empty() || !mechanism.torsion_springs.empty();
}

}  // namespace boxbeam
