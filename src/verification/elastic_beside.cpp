#include "boxbeam/verification/elastic_beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "members_in_space.hpp"
#include "neighbour_loads.hpp"
#include "neighbour_parts.hpp"

namespace boxbeam {
namespace {

/// Lengths that are the same, by the length of a rod.
constexpr double rod_end_slack = 1e-6;

const Body& body_of_rod(const Project& project, const PlanarRod& rod) {
  return planar_of(project).bodies[static_cast<std::size_t>(rod.from.body)];
}

/// Calls f(name, place) for all places at which joints and forces take hold.
template <class Function>
void each_place_held(const planar::Mechanism& mechanism, const Function& f) {
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    f(joint.name, a);
    f(joint.name, b);
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    std::visit(
        [&](const auto& kind) {
          if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, planar::PointForce>) {
            f(force.name, kind.at);
          } else {
            f(force.name, kind.a);
            f(force.name, kind.b);
          }
        },
        force.kind);
  }
}

/// What takes hold of the body of a rod beyond its ends, by name.
std::string held_beyond(const planar::Mechanism& mechanism, const PlanarRod& rod) {
  const Eigen::Vector2d line = rod.to.p - rod.from.p;
  std::string found;
  each_place_held(mechanism, [&](const std::string& name, const planar::Attachment& at) {
    if (at.body != rod.from.body) return;
    const double part = (at.p - rod.from.p).dot(line) / line.squaredNorm();
    if (part < -rod_end_slack || part > 1.0 + rod_end_slack) found = name;
  });
  return found;
}

/// What slides or rolls along the body of a rod, by name.
std::string sliding_along(const planar::Mechanism& mechanism, const PlanarRod& rod) {
  const auto moves = [](planar::Hold hold) {
    switch (hold) {
      case planar::Hold::guide:
      case planar::Hold::teeth: return true;
      case planar::Hold::place:
      case planar::Hold::angle:
      case planar::Hold::clamp: return false;
    }
    return false;
  };
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    const auto [of_a, of_b] = planar::holds_of(joint);
    if ((a.body == rod.from.body && moves(of_a)) || (b.body == rod.from.body && moves(of_b)))
      return joint.name;
  }
  return "";
}

/// The rods that are parts of a body.
std::size_t rods_on(const Project& project, int body) {
  return static_cast<std::size_t>(std::count_if(
      project.elastic_beside.begin(), project.elastic_beside.end(), [&](const auto& of) {
        const auto* const rod = std::get_if<PlanarRod>(&of.place);
        return rod != nullptr && rod->from.body == body;
      }));
}

using Beside = const ElasticBeside&;
std::string why_rigid(const Project&, Beside, const WholeBody&) { return ""; }
std::string why_rigid(const Project&, Beside, const RodLink&) { return ""; }
std::string why_rigid(const Project&, Beside, const planar::ElasticJoint&) { return ""; }
std::string why_rigid(const Project&, Beside, const spatial::ElasticJoint&) { return ""; }
std::string why_rigid(const Project& project, Beside of, const RodBody& rod) {
  return obstacle_to_rod(project, of, rod);
}
std::string why_rigid(const Project& project, Beside, const PlanarRod& rod) {
  const planar::Mechanism& mechanism = planar_of(project);
  const RodMass mass = mass_of(body_of_rod(project, rod), rod);
  if (rods_on(project, rod.from.body) > 1) return "its body has several rods";
  if (mass.beside > rod_end_slack * mass.length) return "its centre of mass lies beside its line";
  if (!mass.along())
    return "by its inertia its mass lies too near its ends, or too near one place, to be laid out "
           "along it";
  const std::string slides = sliding_along(mechanism, rod);
  if (!slides.empty()) return fmt::format("joint {} moves along it", slides);
  const std::string beyond = held_beyond(mechanism, rod);
  if (!beyond.empty()) return fmt::format("{} takes hold of its body beyond its ends", beyond);
  return "";
}

/// A beam, or a rod as one, as an elastic body that its mass is still to be laid out on.
ElasticBody elastic_axis_of(const Project& project, const TaperedBeam& beam, int body, double E,
                            double G) {
  ElasticBody elastic;
  elastic.body = body;
  elastic.length = beam.length().value();
  elastic.stretches = link_stretches_of(beam, E, G);
  elastic.retardation = project.model.retardation;
  return elastic;
}

ElasticBody elastic_beam_of(const Project& project, const TaperedBeam& beam, int body) {
  ElasticBody elastic = elastic_axis_of(project, beam, body, project.model.youngs_modulus,
                                        project.model.shear_modulus);
  elastic.centre = mass_properties_of(beam).centre.value();
  return elastic;
}

/// Adds what is elastic beside a beam to it.
struct BesideBeam {
  const Project& project;
  const ElasticBeside& of;
  ElasticBody& beam;

  void operator()(const WholeBody& whole) const {
    ElasticBody& beside = beam.beside.emplace_back(elastic_beam_of(project, of.beam, whole.body));
    beside.laid_out = planar::beam_body_of(of.beam, whole.body);
  }

  void operator()(const PlanarRod& rod) const {
    const RodMass mass = mass_of(body_of_rod(project, rod), rod);
    ElasticBody& beside = beam.beside.emplace_back(
        elastic_axis_of(project, of.beam, rod.from.body, rod_modulus_of(project).value(),
                        rod_shear_modulus_of(project).value()));
    const Eigen::Vector2d line = rod.to.p - rod.from.p;
    beside.centre = mass.centre;
    beside.angle = std::atan2(line.y(), line.x());
    beside.stretches.front().mass = *mass.along();
    beside.between_pins = bending_of(planar_of(project), rod).empty();
    SegmentMass along;
    along.mass = *mass.along();
    beside.laid_out = {rod.from.body,      &of.beam,    {along},
                       places_of(of.beam), mass.centre, beside.angle};
  }

  void operator()(const RodLink& link) const {
    const Section& section = of.beam.segments.front().from;
    beam.lines.push_back({planar_of(project).joints[link.index].name,
                          (rod_modulus_of(project) * properties_of(section).area).value(),
                          project.model.retardation});
  }

  void operator()(const planar::ElasticJoint& joint) const { beam.joints.push_back(joint); }
  // In space.
  void operator()(const RodBody&) const {}
  void operator()(const spatial::ElasticJoint&) const {}
};

bool is_joint(const ElasticBeside& of) {
  return std::holds_alternative<planar::ElasticJoint>(of.place) ||
         std::holds_alternative<spatial::ElasticJoint>(of.place);
}

}  // namespace

ElasticBody elastic_body_of(const Project& project, int parts) {
  ElasticBody elastic = elastic_beam_of(project, project.beam, project.beam_body);
  for (const ElasticBeside& other : project.elastic_beside) {
    if (obstacle_to_elasticity(project, other).empty())
      std::visit(BesideBeam{project, other, elastic}, other.place);
  }
  elastic.parts = parts;
  for (ElasticBody& other : elastic.beside) other.parts = parts;
  return elastic;
}

std::string obstacle_to_elasticity(const Project& project, const ElasticBeside& of) {
  return std::visit([&](const auto& place) { return why_rigid(project, of, place); }, of.place);
}

std::string elastic_beside_text(const Project& project) {
  std::string elastic, rigid;
  for (const ElasticBeside& of : project.elastic_beside) {
    const std::string obstacle = obstacle_to_elasticity(project, of);
    if (obstacle.empty())
      elastic +=
          fmt::format("{}{}{}", elastic.empty() ? "" : ", ", is_joint(of) ? "joint " : "", of.name);
    else
      rigid +=
          fmt::format("{}rod {} counts as rigid: {}", rigid.empty() ? "" : "; ", of.name, obstacle);
  }
  if (!elastic.empty()) elastic += " elastic as well";
  if (elastic.empty() && rigid.empty()) return "";
  return fmt::format(" ({}{}{})", elastic, elastic.empty() || rigid.empty() ? "" : "; ", rigid);
}

}  // namespace boxbeam
