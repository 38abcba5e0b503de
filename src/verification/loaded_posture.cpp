#include "boxbeam/verification/loaded_posture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"

namespace boxbeam {
namespace {

/// Places that are the same but for round-off.
constexpr double near = 1e-9;

/// Where the loads on the beam act, so that its links have nodes there: loads of no size.
void keep_nodes(const BeamLoads& rigid, int link, flexible::Mechanism& links) {
  for (const PointLoad& load : rigid.points) {
    flexible::Load& place = links.loads.emplace_back();
    place.at = {link, {load.s.value(), 0.0}};
  }
}

/// Tension of the rigid beam; at a load on the side that is asked for, though places are met but
/// for round-off.
flexible::TensionAt tension_in(const CutForceDiagram& diagram, const BeamLoads& rigid,
                               double factor) {
  return [&diagram, &rigid, factor](double s, Side side) {
    const double length = diagram.pieces.back().end().value();
    Station station{si<Length>(s), side};
    for (const PointLoad& load : rigid.points) {
      if (std::abs(load.s.value() - s) < near * length) station.s = load.s;
    }
    return factor * diagram.at(station).N.value();
  };
}

/// Stiffness across lines without mass between two points, from their tension.
class LineStiffness {
 public:
  LineStiffness(const planar::State& state, double factor, flexible::Mechanism& links)
      : state_(&state), factor_(factor), links_(&links) {}

  void add(const std::string& name, const planar::Attachment& a, const planar::Attachment& b,
           double tension) const {
    const double length =
        (planar::position_of(a, state_->q) - planar::position_of(b, state_->q)).norm();
    if (length == 0.0) return;
    for (flexible::Joint& joint : links_->joints) {
      const bool line = joint.stiffness[0] > 0.0 && joint.stiffness[1] == 0.0;
      if (joint.name == name && line) joint.stiffness[1] = factor_ * tension / length;
    }
  }

 private:
  const planar::State* state_;
  double factor_;
  flexible::Mechanism* links_;
};

void stiffen_lines(const planar::Mechanism& mechanism, const planar::State& state, double factor,
                   flexible::Mechanism& links) {
  const LineStiffness lines(state, factor, links);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    if (!planar::is_rod(joint)) continue;
    const auto [a, b] = planar::ends_of(joint);
    lines.add(joint.name, a, b, planar::tension_in_joint(mechanism, state, i));
  }
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    const auto* spring = std::get_if<planar::Spring>(&mechanism.forces[i].kind);
    if (spring == nullptr) continue;
    lines.add(mechanism.forces[i].name, spring->a, spring->b,
              planar::tension_in_spring(mechanism, state, i));
  }
}

/// Sum of force times arm of every link, by the arms across the axis in the beam's.
class Arms {
 public:
  Arms(const planar::State& state, const ElasticBody& elastic, double factor,
       flexible::Structure& structure)
      : state_(&state), elastic_(&elastic), factor_(factor), structure_(&structure) {}

  void add(int on, const Eigen::Vector2d& point, const Eigen::Vector2d& force) const {
    if (on == planar::ground) return;
    const auto link = static_cast<std::size_t>(on);
    const double angle = state_->q[3 * static_cast<Eigen::Index>(on) + 2];
    const ElasticBody* bends = elastic_at(*elastic_, on);
    if (bends == nullptr) {
      const Eigen::Vector2d own = Eigen::Rotation2Dd(-angle) * force;
      structure_->links[link].elements.front().turning += factor_ * own.dot(point);
      return;
    }
    const Eigen::Vector2d own = Eigen::Rotation2Dd(-angle - bends->angle) * force;
    const flexible::Attachment at{on, bends->on_axis(point)};
    if (std::abs(at.p.y()) <= near * bends->length) return;
    structure_->links[link].elements[flexible::grip_of(*structure_, at).element].turning +=
        factor_ * own.y() * at.p.y();
  }

 private:
  const planar::State* state_;
  const ElasticBody* elastic_;
  double factor_;
  flexible::Structure* structure_;
};

void add_arms(const planar::Mechanism& mechanism, const planar::State& state, const Arms& arms) {
  for (const planar::Reaction& reaction : planar::reactions_of(mechanism, state)) {
    arms.add(reaction.on, reaction.point, reaction.force);
  }
  for (const planar::AppliedLoad& load :
       planar::applied_loads_of(mechanism, state.time, state.q, state.v, state.touches)) {
    const auto& kind = mechanism.forces[static_cast<std::size_t>(load.force)].kind;
    const auto* force = std::get_if<planar::PointForce>(&kind);
    if (force == nullptr || !force->turns) arms.add(load.on, load.point, load.vector);
  }
}

/// The ends of a line that stretches, as of a beam.
BeamLoads loads_on_line(const planar::Mechanism& mechanism, const planar::State& state,
                        const ElasticLine& line) {
  const auto joint = static_cast<std::size_t>(planar::joint_index(mechanism, line.joint));
  const auto [a, b] = planar::ends_of(mechanism.joints[joint]);
  const Length length =
      si<Length>((planar::position_of(b, state.q) - planar::position_of(a, state.q)).norm());
  const double tension = planar::tension_in_joint(mechanism, state, joint);
  BeamLoads loads;
  loads.lines = {{Length{}, length, {}, {}}};
  loads.points.resize(2);
  loads.points[0].force.x() = -tension;
  loads.points[1].force.x() = tension;
  loads.points[1].s = length;
  return loads;
}

/// Divides the links and loads the beam along its axis.
void load_beam(const BeamLoads& rigid, const BeamLoads& axial, double factor,
               LoadedPosture& posture) {
  posture.structure = flexible::structure_of(*posture.links);
  posture.rigid = cut_forces_of(rigid);
  const CutForceDiagram borne = cut_forces_of(axial);
  flexible::load_axially(posture.structure.links[static_cast<std::size_t>(posture.beam_link)],
                         tension_in(borne, axial, factor));
}

/// N, V and couple of a diagram in the axes of a link: y of the beam points into the plane.
Eigen::Vector3d in_link_axes(const CutForces& cut) {
  return {cut.N.value(), cut.V_z.value(), -cut.M_y.value()};
}

/// Adds loads in pairs on the two ends of every part of a link that strain it as these cut forces.
void add_straining(const flexible::DividedLink& link, const CutForceDiagram& rigid,
                   Eigen::Matrix3Xd& loads) {
  for (std::size_t i = 0; i < link.springs.size(); ++i) {
    const flexible::SpringElement& part = link.springs[i];
    const Eigen::Vector3d mean = mean_over(rigid, part);
    for (const auto& [element, sign] : {std::pair(i, -1.0), std::pair(i + 1, 1.0)}) {
      Eigen::Vector3d load = sign * mean;
      load[2] += (part.place - link.elements[element].node) * load[1];
      loads.col(static_cast<Eigen::Index>(element)) += load;
    }
  }
}

/// What strains the elastic links as the cut forces of rigid bodies do.
flexible::LinkColumns<double> straining_loads(const LoadedPosture& posture) {
  flexible::LinkColumns<double> loads = flexible::no_loads<double>(posture.structure);
  const auto add = [&](int of, const CutForceDiagram& rigid) {
    const auto index = static_cast<std::size_t>(of);
    add_straining(posture.structure.links[index], rigid, loads[index]);
  };
  add(posture.beam_link, posture.rigid);
  for (const auto& [link, rigid] : posture.beside) add(link, rigid);
  // A joint that does its force to its first body is opened by the opposite.
  const auto push = [&](const flexible::Grip& grip, const Eigen::Vector3d& world) {
    if (grip.link == flexible::ground) return;
    loads[static_cast<std::size_t>(grip.link)].col(static_cast<Eigen::Index>(grip.element)) +=
        grip.motion.transpose() * world;
  };
  for (const auto& [joint, force] : posture.joints) {
    const flexible::Structure::Ends& ends = posture.structure.joints[joint];
    push(ends.a, -ends.axes.transpose() * force);
    push(ends.b, ends.axes.transpose() * force);
  }
  return loads;
}

/// The links of what is elastic beside the beam.
std::vector<int> links_beside(const planar::Mechanism& mechanism, const ElasticBody& elastic) {
  std::vector<int> links;
  for (const ElasticBody& other : elastic.beside) links.push_back(other.body);
  for (std::size_t k = 0; k < elastic.lines.size(); ++k)
    links.push_back(static_cast<int>(mechanism.bodies.size() + k));
  return links;
}

}  // namespace

std::vector<BeamLoads> loads_beside(const planar::Mechanism& mechanism, const planar::State& state,
                                    const ElasticBody& elastic) {
  std::vector<BeamLoads> loads;
  for (const ElasticBody& other : elastic.beside)
    loads.push_back(planar::beam_loads_of(mechanism, state, other.laid_out));
  for (const ElasticLine& line : elastic.lines)
    loads.push_back(loads_on_line(mechanism, state, line));
  return loads;
}

Eigen::Vector3d mean_over(const CutForceDiagram& diagram, const flexible::SpringElement& part) {
  const auto at = [&](double s, Side side) {
    return in_link_axes(diagram.at({si<Length>(s), side}));
  };
  const double middle = 0.5 * (part.from + part.to);
  Eigen::Vector3d mean =
      (at(part.from, Side::behind) + 4.0 * at(middle, Side::both) + at(part.to, Side::before)) /
      6.0;
  // dM/ds = V, M against the sense of a link's couples.
  mean[2] -= (part.place - middle) * mean[1];
  return mean;
}

LoadedPosture loaded_posture(const planar::Mechanism& mechanism, const planar::State& state,
                             const ElasticBody& elastic, const TaperedBeam& beam,
                             const BeamLoads& rigid, double factor, const BeamLoads* axial) {
  auto links = std::make_unique<flexible::Mechanism>(links_of(mechanism, state, elastic));
  keep_nodes(rigid, elastic.body, *links);
  const std::vector<BeamLoads> others = loads_beside(mechanism, state, elastic);
  const std::vector<int> beside = links_beside(mechanism, elastic);
  for (std::size_t k = 0; k < others.size(); ++k) keep_nodes(others[k], beside[k], *links);
  stiffen_lines(mechanism, state, factor, *links);
  LoadedPosture posture;
  posture.links = std::move(links);
  posture.beam_link = elastic.body;
  posture.beam = &beam;
  load_beam(rigid, axial != nullptr ? *axial : rigid, factor, posture);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto& [link, cut] = posture.beside.emplace_back(beside[k], cut_forces_of(others[k]));
    flexible::load_axially(posture.structure.links[static_cast<std::size_t>(link)],
                           tension_in(cut, others[k], factor));
  }
  add_arms(mechanism, state, Arms(state, elastic, factor, posture.structure));
  for (const planar::ElasticJoint& of : elastic.joints) {
    const std::string& name = mechanism.joints[static_cast<std::size_t>(of.joint)].name;
    const std::vector<flexible::Joint>& joints = posture.links->joints;
    const auto found =
        std::find_if(joints.begin(), joints.end(),
                     [&](const flexible::Joint& joint) { return joint.name == name; });
    if (found == joints.end()) continue;  // between ground and ground
    posture.joints.emplace_back(static_cast<std::size_t>(found - joints.begin()),
                                force_in(mechanism, state, elastic, of));
  }
  return posture;
}

LoadedPosture loaded_beam(flexible::Mechanism held, const TaperedBeam& beam, const BeamLoads& rigid,
                          double factor) {
  LoadedPosture posture;
  keep_nodes(rigid, 0, held);
  posture.links = std::make_unique<const flexible::Mechanism>(std::move(held));
  posture.beam = &beam;
  load_beam(rigid, rigid, factor, posture);
  return posture;
}

bool all_parts_stand(const LoadedPosture& posture) {
  const auto parts_of = [&](int link) {
    return flexible::parts_stand(posture.structure.links[static_cast<std::size_t>(link)]);
  };
  return parts_of(posture.beam_link) &&
         std::all_of(posture.beside.begin(), posture.beside.end(),
                     [&](const auto& other) { return parts_of(other.first); });
}

bool stands(const LoadedPosture& posture) {
  if (!all_parts_stand(posture)) return false;
  return flexible::DynamicStiffness<double>(posture.structure, 0.0, 0.0).frequencies_below() == 0;
}

void require_held(const LoadedPosture& posture) {
  if (!all_parts_stand(posture)) return;
  const flexible::DynamicStiffness<double> stiffness(posture.structure, 0.0, 0.0);
}

namespace {

/// Of the joints that give way what they do beside the rigid motion's force.
void leave_rigid_forces(const LoadedPosture& posture, flexible::Deformation<double>& bent) {
  for (const auto& [joint, force] : posture.joints)
    bent.joints.col(static_cast<Eigen::Index>(joint)) -= force;
}

}  // namespace

BeamLoads taken_over_in(const LoadedPosture& posture, const std::vector<flexible::Mode>& modes) {
  flexible::Deformation<double> bent =
      flexible::static_response_of({&posture.structure, modes, {}}, straining_loads(posture));
  leave_rigid_forces(posture, bent);
  return loads_in_motion(posture, bent, 0.0);
}

SecondOrder second_order_of(const LoadedPosture& posture) {
  flexible::Deformation<double> bent =
      flexible::DynamicStiffness<double>(posture.structure, 0.0, 0.0)
          .solve(straining_loads(posture));
  leave_rigid_forces(posture, bent);
  SecondOrder result;
  result.loads = loads_in_motion(posture, bent, 0.0);
  result.turn =
      bent.motion[static_cast<std::size_t>(posture.beam_link)].row(2).cwiseAbs().maxCoeff();
  return result;
}

BeamLoads loads_in_motion(const LoadedPosture& posture, const flexible::Deformation<double>& motion,
                          double frequency) {
  flexible::Response response;
  response.frequency = frequency;
  response.constant = motion;
  for (auto& link : response.constant.motion) link.setZero();
  response.constant.joints.setZero();
  for (const auto& link : motion.motion) {
    response.harmonic.motion.emplace_back(link.cast<flexible::Complex>());
  }
  response.harmonic.joints = motion.joints.cast<flexible::Complex>();
  BeamLoads loads = flexible::beam_response_of(posture.structure, posture.beam_link, *posture.beam,
                                               response, response.harmonic.motion)
                        .sine;
  // The links were made for this posture, and their names go with it.
  for (PointLoad& load : loads.points) load.name = {};
  return loads;
}

}  // namespace boxbeam
