#include "stopped_vibration.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "stopped_scene.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<double> stations_held(const spatial::Mechanism& mechanism,
                                  const spatial::BeamPlacement& placement, bool loaded) {
  std::vector<double> at;
  const auto add = [&](const Vector3d& place) {
    at.push_back(spatial::in_beam(placement, place).x());
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == placement.body) add(joint.point);
    if (joint.parent == placement.body) add(joint.at);
  }
  const auto add_ends = [&](const auto& of) {
    for (const spatial::Attachment& end : {of.a, of.b})
      if (end.body == placement.body) add(end.p);
  };
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    if (!spatial::has_teeth(joint.kind)) add_ends(joint);
  for (const spatial::Spring& spring : mechanism.springs) add_ends(spring);
  if (!loaded) return at;
  for (const spatial::AppliedLoad& load : mechanism.loads)
    if (load.at.body == placement.body) add(load.at.p);
  for (const spatial::LineForce& load : mechanism.line_forces) {
    if (load.on != placement.body) continue;
    add(load.from);
    add(load.to);
  }
  return at;
}

/// `cuts_at` of one beam after the other, then what is in ties that give way.
Eigen::VectorXd cuts_of_scene(const frame::VibratingScene& scene) {
  Eigen::VectorXd cuts(0);
  const auto add = [&](const Eigen::VectorXd& own) {
    cuts.conservativeResize(cuts.size() + own.size());
    cuts.tail(own.size()) = own;
  };
  for (const frame::PosedBeam& posed : scene.beams)
    add(cuts_at(posed.rigid, posed.beam->stations()));
  for (const frame::Tie& tie : scene.ties)
    if (tie.rigid) add(*tie.rigid * frame::Vector6::Unit(tie.way()));
  return cuts;
}

/// Adds what axial forces do to the modes of a scene that is free to move. What is slower than its
/// bodies turn moves these as a whole, whose turning the rigid motion has.
void press_free(const frame::VibratingScene& scene, const std::vector<frame::BeamMode>& modes,
                const std::vector<frame::Turning>& frames, frame::TurningTerms& turning) {
  constexpr double faster = 2.0;
  turning.of_size += frame::geometric_stiffness_of(scene, modes);
  double turned = 0.0;
  for (const frame::Turning& of : frames)
    turned = std::max({turned, of.omega.squaredNorm(), of.alpha.norm()});
  for (std::size_t j = 0; j < modes.size(); ++j) {
    const double omega = full_turn * modes[j].frequency;
    if (omega * omega > faster * faster * turned) continue;
    const auto at = static_cast<Eigen::Index>(j);
    for (Eigen::MatrixXd* const of : {&turning.of_rate, &turning.of_size}) {
      of->row(at).setZero();
      of->col(at).setZero();
    }
  }
  Eigen::MatrixXd stiffness = 0.5 * (turning.of_size + turning.of_size.transpose());
  for (std::size_t j = 0; j < modes.size(); ++j)
    stiffness.diagonal()[static_cast<Eigen::Index>(j)] +=
        std::pow(full_turn * modes[j].frequency, 2);
  const Eigen::Index elastic = std::count_if(
      modes.begin(), modes.end(), [](const frame::BeamMode& of) { return of.frequency > 0.0; });
  if (elastic == 0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness.bottomRightCorner(elastic, elastic), Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues()[0] > 0.0))
    throw AnalysisError({"under its axial force the beam buckles", "beam", {}, {}, {}});
}

}  // namespace

CutForceDiagram rigid_cut_forces(const spatial::Chain& chain, const spatial::State& state,
                                 const spatial::BeamBody& beam,
                                 const std::vector<spatial::Wrench>& wrenches) {
  const LoadsAt loads = staying_on(
      *beam.beam, [&](Time) { return spatial::beam_loads_of(chain, state, beam, wrenches); });
  return cut_forces_of(loads(si<Time>(state.time)));
}

Eigen::VectorXd cuts_at(const CutForceDiagram& diagram, const std::vector<Station>& stations) {
  Eigen::VectorXd cuts(6 * static_cast<Eigen::Index>(stations.size()));
  Eigen::Index at = 0;
  for (const Station& station : stations) {
    const CutForces cut = diagram.at(station);
    for (const double value : {cut.N.value(), cut.V_y.value(), cut.V_z.value(), cut.T.value(),
                               cut.M_y.value(), cut.M_z.value()})
      cuts[at++] = value;
  }
  return cuts;
}

StoppedVibration::StoppedVibration(const Project& project, const spatial::Chain& chain, int parts,
                                   bool loaded)
    : chain_(&chain), giving_(project) {
  const spatial::Mechanism& mechanism = chain.mechanism();
  const std::vector<ElasticMember> members = elastic_members(project, mechanism);
  // The cost of modes grows as the cube of all pieces.
  constexpr int most_beside = 64;
  const auto others = static_cast<int>(members.size()) - 1;
  for (const ElasticMember& member : members) {
    const bool first = beams_.empty();
    if (!first) beside_.push_back(member.body_in(mechanism));
    placements_.push_back(member.placement);
    beams_.emplace_back(*member.beam, member.youngs_modulus, member.shear_modulus,
                        stations_held(mechanism, member.placement, loaded),
                        first ? parts : std::clamp(most_beside / others, 1, parts),
                        project.model.retardation, member.masses);
  }
  members_ = members_of_scene(resting_bodies(mechanism, placements_, giving_), placements_);
  for (const spatial::Body& body : mechanism.bodies) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(body.inertia);
    roots_.push_back(principal.eigenvectors() *
                     principal.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                     principal.eigenvectors().transpose());
  }
}

std::vector<frame::PosedBeam> StoppedVibration::beams_in(
    const spatial::State& state, const CutForceDiagram& rigid,
    const std::vector<spatial::Wrench>& wrenches) const {
  std::vector<frame::PosedBeam> posed{{&beams_.front(), rigid}};
  const auto start_of = [&](const spatial::BeamPlacement& of) {
    return spatial::position_of(state, {of.body, of.start});
  };
  const auto axes_of = [&](const spatial::BeamPlacement& of) -> Matrix3d {
    return state.bodies[static_cast<std::size_t>(of.body)].R_WB * of.axes;
  };
  const Vector3d origin = start_of(placements_.front());
  const Matrix3d into = axes_of(placements_.front()).transpose();
  for (std::size_t k = 0; k < beside_.size(); ++k) {
    const spatial::BeamPlacement& of = placements_[k + 1];
    posed.push_back({&beams_[k + 1], rigid_cut_forces(*chain_, state, beside_[k], wrenches),
                     into * (start_of(of) - origin), into * axes_of(of)});
  }
  return posed;
}

StoppedVibration::SceneWithContacts StoppedVibration::contacts_in(
    const spatial::State& state, const CutForceDiagram& rigid) const {
  std::vector<spatial::Wrench> wrenches;
  if (!beside_.empty() || !giving_.empty()) wrenches = chain_->joint_wrenches(state);
  StoppedScene stopped = stopped_scene(chain_->mechanism(), state, placements_, giving_, wrenches);
  leave_out_resting(members_, placements_.size(), stopped);
  const std::size_t may_move = freedoms();
  return {{beams_in(state, rigid, wrenches), std::move(stopped.bodies), std::move(stopped.ties),
           may_move, may_move == 0},
          std::move(stopped.contacts)};
}

frame::VibratingScene StoppedVibration::scene_in(const spatial::State& state,
                                                 const CutForceDiagram& rigid) const {
  return contacts_in(state, rigid).scene;
}

bool StoppedVibration::is_damped() const {
  const spatial::Mechanism& mechanism = chain_->mechanism();
  const auto damped = [](const auto& of) { return of.damping > 0.0; };
  return giving_.is_damped() ||
         std::any_of(mechanism.springs.begin(), mechanism.springs.end(), damped) ||
         std::any_of(mechanism.torsion_springs.begin(), mechanism.torsion_springs.end(), damped);
}

bool StoppedVibration::takes_over() const {
  return freedoms() > 0 || has_springs(chain_->mechanism());
}

std::vector<std::size_t> StoppedVibration::bodies_of_scene() const {
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (members_[i] != frame::ground && members_[i] >= static_cast<int>(placements_.size()))
      bodies.push_back(i);
  return bodies;
}

std::size_t StoppedVibration::freedoms() const {
  const std::vector<spatial::Joint>& joints = chain_->mechanism().joints;
  return static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), spatial::is_forced));
}

std::vector<frame::BeamMode> StoppedVibration::modes(const spatial::State& state,
                                                     const CutForceDiagram& rigid,
                                                     std::size_t count) {
  const std::size_t moved = freedoms();
  std::vector<frame::BeamMode> modes =
      frame::modes_of(frame::FactoredScene(scene_in(state, rigid), ties_), count + moved);
  // Those of whole bodies on their springs strain the beams least.
  for (std::size_t k = 0; k < moved && !modes.empty(); ++k)
    modes.erase(std::min_element(modes.begin(), modes.end(),
                                 [](const frame::BeamMode& a, const frame::BeamMode& b) {
                                   return strained_part_of(a) < strained_part_of(b);
                                 }));
  return modes;
}

Eigen::VectorXd StoppedVibration::rigid_cuts(const spatial::State& state,
                                             const CutForceDiagram& rigid) const {
  return cuts_of_scene(scene_in(state, rigid));
}

ModesOfPosture StoppedVibration::modes_with_shapes(frame::VibratingScene scene,
                                                   const spatial::State& state, std::size_t count) {
  const frame::FactoredScene factored(std::move(scene), ties_);
  ModesOfPosture of{factored, frame::modes_of(factored, count), {}};
  const std::vector<frame::RigidMass>& bodies = factored.scene().bodies;
  const spatial::BeamPlacement& first = placements_.front();
  const Matrix3d R_WB = state.bodies[static_cast<std::size_t>(first.body)].R_WB * first.axes;
  /// Of the bodies, in the order of the scene: from its axes to their own, and roots of inertias.
  std::vector<Matrix3d> own, roots;
  for (const std::size_t i : bodies_of_scene()) {
    own.push_back(state.bodies[i].R_WB.transpose() * R_WB);
    roots.push_back(roots_[i]);
  }
  const auto others = static_cast<Eigen::Index>(6 * own.size());
  for (std::size_t k = 0; k < of.modes.size(); ++k) {
    const frame::BeamMode& mode = of.modes[k];
    const Eigen::VectorXd on_beams = frame::shape_on_beams(factored.scene(), mode);
    if (k == 0)
      of.shapes.resize(on_beams.size() + others, static_cast<Eigen::Index>(of.modes.size()));
    Eigen::VectorXd beside = mode.motion.tail(others);
    for (std::size_t b = 0; b < own.size(); ++b) {
      const auto at = static_cast<Eigen::Index>(6 * b);
      beside.segment<3>(at) = std::sqrt(bodies[b].mass) * (own[b] * beside.segment<3>(at)).eval();
      beside.segment<3>(at + 3) = (roots[b] * own[b] * beside.segment<3>(at + 3)).eval();
    }
    of.shapes.col(static_cast<Eigen::Index>(k)) << on_beams, beside;
  }
  return of;
}

ModesOfPosture StoppedVibration::modes_with_shapes(const spatial::State& state,
                                                   const CutForceDiagram& rigid,
                                                   std::size_t count) {
  return modes_with_shapes(scene_in(state, rigid), state, count);
}

BeamLoads StoppedVibration::taken_over_in(frame::VibratingScene scene,
                                          const std::vector<frame::BeamMode>& modes,
                                          const Eigen::VectorXd& cuts) {
  scene.pressed = false;
  // What dampers do is known.
  for (frame::Tie& tie : scene.ties) tie.damping = 0.0;
  const frame::FactoredScene straight(std::move(scene), ties_);
  return *frame::static_parts_of(straight, modes, cuts).taken_over;
}

BeamLoads StoppedVibration::taken_over(const spatial::State& state, const CutForceDiagram& rigid,
                                       const std::vector<frame::BeamMode>& modes) {
  frame::VibratingScene scene = scene_in(state, rigid);
  const Eigen::VectorXd cuts = cuts_of_scene(scene);
  return taken_over_in(std::move(scene), modes, cuts);
}

ModesInMotion StoppedVibration::modes_in_motion(const spatial::State& state,
                                                const CutForceDiagram& rigid, std::size_t count,
                                                bool statically) {
  SceneWithContacts all = contacts_in(state, rigid);
  ModesOfPosture of = modes_with_shapes(std::move(all.scene), state, count);
  const frame::VibratingScene& scene = of.scene.scene();
  ModesInMotion result;
  result.modes = std::move(of.modes);
  result.shapes = std::move(of.shapes);
  result.gaps = frame::gaps_of(scene, result.modes, all.contacts);
  const spatial::BeamPlacement& first = placements_.front();
  const Matrix3d R_WB = state.bodies[static_cast<std::size_t>(first.body)].R_WB * first.axes;
  std::vector<frame::Turning> frames;
  const auto add_turning_of = [&](std::size_t body) {
    const spatial::BodyMotion& turning = state.bodies[body];
    frames.push_back({R_WB.transpose() * turning.omega, R_WB.transpose() * turning.alpha});
  };
  for (const spatial::BeamPlacement& beam : placements_)
    add_turning_of(static_cast<std::size_t>(beam.body));
  for (const std::size_t body : bodies_of_scene()) add_turning_of(body);
  result.turning = frame::turning_terms_of(scene, result.modes, frames);
  if (scene.may_move > 0) press_free(scene, result.modes, frames, result.turning);
  const Eigen::VectorXd cuts = cuts_of_scene(scene);
  std::optional<Eigen::VectorXd> bending;
  if (statically && scene.may_move > 0) bending = cuts;
  frame::StaticParts parts = frame::static_parts_of(of.scene, result.modes, bending);
  result.dampers = std::move(parts.dampers);
  result.taken_over = std::move(parts.taken_over);
  if (statically && scene.may_move == 0 && takes_over())
    result.taken_over = taken_over_in(scene, result.modes, cuts);
  const auto size = static_cast<Eigen::Index>(result.modes.size());
  result.force.resize(size);
  result.damping.resize(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const frame::BeamMode& mode = result.modes[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < size; ++i)
      result.damping(i, j) = result.modes[static_cast<std::size_t>(i)].motion.dot(mode.drag);
    result.force[j] = cuts.dot(mode.work);
  }
  return result;
}

}  // namespace boxbeam
