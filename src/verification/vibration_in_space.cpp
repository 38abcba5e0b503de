#include "vibration_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "strained_once.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t modes_estimated = 6, postures_estimated = 12;

/// The placement of the beam that this body is; the end where it is none.
auto beam_on(int body, const std::vector<spatial::BeamPlacement>& beams) {
  return std::find_if(beams.begin(), beams.end(),
                      [&](const spatial::BeamPlacement& of) { return of.body == body; });
}

/// How the bodies of a stopped mechanism are tied to each other, in beam axes.
class StoppedTies {
 public:
  StoppedTies(const spatial::Mechanism& mechanism, const spatial::State& state,
              const std::vector<spatial::BeamPlacement>& beams, const GivingWay& giving,
              const std::vector<spatial::Wrench>& wrenches)
      : mechanism_(&mechanism), state_(&state), giving_(&giving), wrenches_(&wrenches) {
    const spatial::BeamPlacement& first = beams.front();
    const spatial::BodyMotion& own = state.bodies[static_cast<std::size_t>(first.body)];
    start_ = own.position + own.R_WB * first.start;
    R_BW_ = (own.R_WB * first.axes).transpose();
    int next = static_cast<int>(beams.size());
    for (std::size_t i = 0; i < mechanism_->bodies.size(); ++i) {
      const auto beam = beam_on(static_cast<int>(i), beams);
      if (beam != beams.end()) {
        member_.push_back(static_cast<int>(beam - beams.begin()));
        continue;
      }
      member_.push_back(next++);
      const spatial::Body& body = mechanism_->bodies[i];
      const Matrix3d R = R_BW_ * state.bodies[i].R_WB;
      bodies.push_back({body.mass,
                        in_beam(spatial::position_of(state, {static_cast<int>(i), body.centre})),
                        R * body.inertia * R.transpose()});
    }
    for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) add_joint(i);
    for (std::size_t k = 0; k < mechanism_->closing.size(); ++k) add_closing(k);
    for (const spatial::Spring& spring : mechanism_->springs) add_spring(spring);
    for (const spatial::TorsionSpring& spring : mechanism_->torsion_springs) add_spring(spring);
  }

  std::vector<frame::RigidMass> bodies;
  std::vector<frame::Tie> ties;

 private:
  static frame::Vector6 force(const Vector3d& along) {
    frame::Vector6 of = frame::Vector6::Zero();
    of.head<3>() = along;
    return of;
  }
  static frame::Vector6 couple(const Vector3d& about) {
    frame::Vector6 of = frame::Vector6::Zero();
    of.tail<3>() = about;
    return of;
  }

  Vector3d in_beam(const Vector3d& world) const { return R_BW_ * (world - start_); }
  Vector3d turned(int axes, const Vector3d& vector) const {
    return R_BW_ * spatial::in_world(*state_, axes, vector);
  }
  int member_of(int body) const {
    return body == spatial::ground ? frame::ground : member_[static_cast<std::size_t>(body)];
  }
  frame::Tie::End end(int body, const Vector3d& at, const frame::Vector6& per) const {
    return {{member_of(body), at}, per};
  }

  frame::Tie& new_tie() {
    frame::Tie& of = ties.emplace_back();
    of.name = name_;
    return of;
  }
  /// b against a at one place of both.
  frame::Tie& tie(int a, int b, const Vector3d& at, const frame::Vector6& per) {
    frame::Tie& of = new_tie();
    of.ends = {end(a, at, -per), end(b, at, per)};
    return of;
  }
  /// The same of the joint that is being tied, which may give way there.
  void tie(int a, int b, const Vector3d& at, const frame::Vector6& per, const Give& give) {
    give_way(tie(a, b, at, per), give);
  }
  void give_way(frame::Tie& of, const Give& give) const {
    if (std::isinf(give.stiffness)) return;
    of.stiffness = give.stiffness;
    of.damping = give.damping;
    const spatial::Wrench& on_b = (*wrenches_)[wrench_];
    const frame::Vector6& per = of.ends.back().per;
    // In a thread the couple follows from the force.
    of.rigid = of.way() == 0 ? -(R_BW_ * on_b.force).dot(per.head<3>())
                             : -(R_BW_ * on_b.moment).dot(per.tail<3>());
  }

  void hold_across(int a, int b, const Vector3d& at, const Vector3d& axis, const Give& give) {
    const Vector3d u = axis.unitOrthogonal();
    tie(a, b, at, force(u), give);
    tie(a, b, at, force(axis.cross(u)), give);
  }
  /// About the first of two directions across the axis and about the other.
  void hold_tilt(int a, int b, const Vector3d& at, const Vector3d& axis, const Vector3d& first,
                 const WaysToGive& ways) {
    tie(a, b, at, couple(first), ways.first_tilt);
    tie(a, b, at, couple(axis.cross(first)), ways.second_tilt);
  }
  /// A thread advances by so much a radian.
  void hold_thread(int a, int b, const Vector3d& at, const Vector3d& axis, double pitch,
                   const Give& give) {
    tie(a, b, at, force(axis) - pitch * couple(axis), give);
  }
  /// The axis of the movement before this one where it lies across it: that of a universal joint.
  Vector3d first_across(const spatial::Joint& of, const Vector3d& axis) const {
    if (of.parent == spatial::ground) return axis.unitOrthogonal();
    const spatial::Joint& before = mechanism_->joints[static_cast<std::size_t>(of.parent)];
    const Vector3d other = turned(before.parent, before.axis);
    constexpr double square = 1e-9;
    return std::abs(axis.dot(other)) < square ? other : axis.unitOrthogonal();
  }

  void add_joint(std::size_t i) {
    const spatial::Joint& of = mechanism_->joints[i];
    name_ = of.name;
    const int a = of.parent, b = static_cast<int>(i);
    const Vector3d at = in_beam(spatial::position_of(*state_, {b, of.point}));
    const Vector3d axis = turned(of.parent, of.axis);
    const WaysToGive ways = giving_->of(of);
    wrench_ = i;
    hold_across(a, b, at, axis, ways.across);
    hold_tilt(a, b, at, axis, first_across(of, axis), ways);
    const bool moves = of.kind != spatial::JointKind::fixed && !spatial::is_driven(of);
    if (!moves) {
      tie(a, b, at, force(axis), ways.along);
      tie(a, b, at, couple(axis), ways.about);
      return;
    }
    switch (of.kind) {
      case spatial::JointKind::fixed: break;
      case spatial::JointKind::revolute: tie(a, b, at, force(axis), ways.along); break;
      case spatial::JointKind::prismatic: tie(a, b, at, couple(axis), ways.about); break;
      case spatial::JointKind::screw:
        hold_thread(a, b, at, axis, spatial::pitch_of(of.lead), ways.along);
        break;
    }
  }

  void add_closing(std::size_t k) {
    using Kind = spatial::ClosingKind;
    const spatial::ClosingJoint& of = mechanism_->closing[k];
    name_ = of.name;
    wrench_ = mechanism_->joints.size() + k;
    const int a = of.a.body, b = of.b.body;
    if (spatial::has_teeth(of.kind)) {
      add_mesh(of.mesh);
      return;
    }
    const Vector3d at = in_beam(spatial::position_of(*state_, of.b));
    const Vector3d axis = turned(a, of.axis);
    const double length =
        (spatial::position_of(*state_, of.b) - spatial::position_of(*state_, of.a)).norm();
    const WaysToGive ways = giving_->of(of, length);
    const auto across = [&] { hold_across(a, b, at, axis, ways.across); };
    const auto tilt = [&] { hold_tilt(a, b, at, axis, axis.unitOrthogonal(), ways); };
    const auto along = [&] { tie(a, b, at, force(axis), ways.along); };
    const auto about = [&] { tie(a, b, at, couple(axis), ways.about); };
    switch (of.kind) {
      case Kind::fixed:
        across();
        tilt();
        along();
        about();
        break;
      case Kind::revolute:
        across();
        tilt();
        along();
        break;
      case Kind::prismatic:
        across();
        tilt();
        about();
        break;
      case Kind::cylindrical:
        across();
        tilt();
        break;
      case Kind::universal:
        across();
        along();
        tie(a, b, at, couple(axis.cross(turned(b, of.other)).normalized()), ways.second_tilt);
        break;
      case Kind::spherical:
        across();
        along();
        break;
      case Kind::planar:
        along();
        tilt();
        break;
      case Kind::slot: across(); break;
      case Kind::distance: give_way(along_line(of.a, of.b), ways.along); break;
      case Kind::screw:
        across();
        tilt();
        hold_thread(a, b, at, axis, spatial::pitch_of(of.lead), ways.along);
        break;
      case Kind::gear:
      case Kind::rack: break;
    }
  }

  /// The sum of factor q of the coordinates that teeth tie.
  void add_mesh(const spatial::Mesh& mesh) {
    frame::Tie& of = new_tie();
    for (const spatial::Mesh::Part& part : mesh.parts) {
      const spatial::Joint& joint = mechanism_->joints[part.joint];
      const int body = static_cast<int>(part.joint);
      const Vector3d at = in_beam(spatial::position_of(*state_, {body, joint.point}));
      const Vector3d axis = part.factor * turned(joint.parent, joint.axis);
      const frame::Vector6 per = spatial::is_angle(joint.kind) ? couple(axis) : force(axis);
      of.ends.push_back(end(body, at, per));
      of.ends.push_back(end(joint.parent, at, -per));
    }
  }

  frame::Tie& along_line(const spatial::Attachment& a, const spatial::Attachment& b) {
    const Vector3d from = in_beam(spatial::position_of(*state_, a)),
                   to = in_beam(spatial::position_of(*state_, b));
    const Vector3d along = (to - from).normalized();
    frame::Tie& of = new_tie();
    of.ends = {end(a.body, from, force(-along)), end(b.body, to, force(along))};
    return of;
  }

  void add_spring(const spatial::Spring& spring) {
    if (!spatial::acts(spring, *state_)) return;
    name_ = spring.name;
    frame::Tie& of = along_line(spring.a, spring.b);
    of.stiffness = spring.stiffness;
    of.damping = spring.damping;
  }

  void add_spring(const spatial::TorsionSpring& spring) {
    const spatial::Joint& joint = mechanism_->joints[static_cast<std::size_t>(spring.joint)];
    if (spatial::is_driven(joint)) return;
    name_ = spring.name;
    const Vector3d at = in_beam(spatial::position_of(*state_, {spring.joint, joint.point}));
    frame::Tie& of = tie(joint.parent, spring.joint, at, couple(turned(joint.parent, joint.axis)));
    of.stiffness = spring.stiffness;
    of.damping = spring.damping;
  }

  const spatial::Mechanism* mechanism_;
  const spatial::State* state_;
  const GivingWay* giving_;
  const std::vector<spatial::Wrench>* wrenches_;
  std::size_t wrench_ = 0;  ///< of the joint that is being tied
  Vector3d start_;
  Matrix3d R_BW_;
  std::vector<int> member_;
  std::string_view name_;  ///< of what is being tied
};

/// What rests is the ground of what moves.
void leave_out_resting(const std::vector<bool>& resting,
                       const std::vector<spatial::BeamPlacement>& beams, StoppedScene& scene) {
  const auto count = static_cast<int>(beams.size());
  std::vector<int> member;  // of each body of the scene
  std::vector<frame::RigidMass> moving;
  auto body = scene.bodies.begin();
  for (std::size_t i = 0; i < resting.size(); ++i) {
    if (beam_on(static_cast<int>(i), beams) != beams.end()) continue;
    member.push_back(resting[i] ? frame::ground : count + static_cast<int>(moving.size()));
    if (!resting[i]) moving.push_back(*body);
    ++body;
  }
  scene.bodies = std::move(moving);
  for (frame::Tie& tie : scene.ties) {
    for (frame::Tie::End& end : tie.ends)
      if (end.at.member >= count)
        end.at.member = member[static_cast<std::size_t>(end.at.member - count)];
  }
  std::erase_if(scene.ties, [](const frame::Tie& tie) {
    return std::all_of(tie.ends.begin(), tie.ends.end(),
                       [](const frame::Tie::End& end) { return end.at.member == frame::ground; });
  });
}

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

}  // namespace

std::vector<PlaceInSpace> places_in_space(const TaperedBeam& beam,
                                          const std::vector<Length>& joints) {
  std::vector<PlaceInSpace> places;
  for (const ComparedPlace& place : compared_places_of(beam, joints)) {
    const Section section = section_at(beam, place.station);
    const double A = 1.0 / place.per_N;
    const TorsionProperties torsion = torsion_properties_of(section);
    double per_T = 0.0;
    if (torsion.I_T) {
      const double open = torsion.enclosed.value() > 0.0 ? 1.0 : std::sqrt(3.0);
      per_T = std::sqrt(3.0) * open / std::sqrt(torsion.I_T->value() * A);
    }
    places.push_back(
        {place.station, place.per_N, place.per_M, 1.0 / properties_of(section).W_z.value(), per_T});
  }
  return places;
}

Eigen::RowVectorXd stresses_at(const CutForceDiagram& diagram,
                               const std::vector<PlaceInSpace>& places) {
  Eigen::RowVectorXd stresses(stresses_of_place * static_cast<Eigen::Index>(places.size()));
  Eigen::Index i = 0;
  for (const PlaceInSpace& place : places) {
    const CutForces cut = diagram.at(place.station);
    const double axial = cut.N.value() * place.per_N, y = cut.M_y.value() * place.per_M_y,
                 z = cut.M_z.value() * place.per_M_z;
    for (const double both : {y + z, y - z, -y + z, -y - z}) stresses[i++] = axial + both;
    stresses[i++] = cut.T.value() * place.per_T;
  }
  return stresses;
}

namespace {

Eigen::MatrixXd stresses_over(const LoadHistory& history, const std::vector<PlaceInSpace>& places) {
  Eigen::MatrixXd stresses(static_cast<Eigen::Index>(history.even_instants()),
                           stresses_of_place * static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < stresses.rows(); ++i)
    stresses.row(i) = stresses_at(history.even_diagram(static_cast<std::size_t>(i)), places);
  return stresses;
}

double friction_in(const spatial::Mechanism& mechanism) {
  double largest = 0.0;
  for (const spatial::Joint& joint : mechanism.joints)
    largest = std::max(largest, joint.friction.coulomb);
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    largest = std::max(largest, joint.friction.coulomb);
  return largest;
}

/// M_y or M_z at a station over the period, the one with the larger stress.
Eigen::VectorXd bending_in_space(const LoadHistory& history, const PlaceInSpace& place) {
  const auto count = static_cast<Eigen::Index>(history.even_instants());
  Eigen::VectorXd y(count), z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CutForces cut = history.even_diagram(static_cast<std::size_t>(i)).at(place.station);
    y[i] = cut.M_y.value();
    z[i] = cut.M_z.value();
  }
  const bool about_y = place.per_M_y * (y.maxCoeff() - y.minCoeff()) >=
                       place.per_M_z * (z.maxCoeff() - z.minCoeff());
  return about_y ? y : z;
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

/// `StoppedVibration::rigid_cuts` of every even instant, a row for each.
Eigen::MatrixXd cuts_over(const LoadHistory& history, const spatial::Chain& chain,
                          const StoppedVibration& stopped) {
  const std::size_t count = history.even_instants();
  Eigen::MatrixXd cuts;
  for (std::size_t i = 0; i < count; ++i) {
    const Time time =
        history.begin() + history.period() * (static_cast<double>(i) / static_cast<double>(count));
    const Eigen::VectorXd at = stopped.rigid_cuts(chain.at(time.value()), history.even_diagram(i));
    if (i == 0) cuts.resize(static_cast<Eigen::Index>(count), at.size());
    cuts.row(static_cast<Eigen::Index>(i)) = at.transpose();
  }
  return cuts;
}

/// Of every cut force a part of its largest value, or of all forces or moments where it hardly
/// counts beside these.
Eigen::VectorXd allowed_in_cuts_of_space(const Eigen::VectorXd& largest) {
  constexpr double part = 1e-4, hardly = 1e-2;
  constexpr Eigen::Index kinds = 6;
  const auto every = [&](Eigen::Index kind) {
    return Eigen::seqN(kind, largest.size() / kinds, kinds);
  };
  Eigen::VectorXd of_kinds(kinds), allowed(largest.size());
  for (Eigen::Index k = 0; k < kinds; ++k) of_kinds[k] = largest(every(k)).maxCoeff();
  const double force = of_kinds.head<3>().maxCoeff(), moment = of_kinds.tail<3>().maxCoeff();
  for (Eigen::Index k = 0; k < kinds; ++k)
    allowed(every(k)).setConstant(part * std::max(of_kinds[k], hardly * (k < 3 ? force : moment)));
  return allowed;
}

/// Stresses of rigid loads, against which those beside them are weighed.
struct WeighedStresses {
  std::vector<PlaceInSpace> places;
  Eigen::MatrixXd stresses;
  double peak = 0.0, range = 0.0;

  WeighedStresses(const LoadHistory& history, const TaperedBeam& beam)
      : places(places_in_space(beam)), stresses(stresses_over(history, places)) {
    peak = stresses.cwiseAbs().maxCoeff();
    range = largest_range(stresses);
  }

  /// With none, one, ... of the modes counted. `parts`: of each mode over time, a column each.
  std::vector<double> missed(const std::vector<frame::BeamMode>& modes,
                             const Eigen::MatrixXd& parts) const {
    std::vector<double> missed(modes.size() + 1, 0.0);
    Eigen::MatrixXd beside = Eigen::MatrixXd::Zero(parts.rows(), stresses.cols());
    for (std::size_t j = modes.size(); j-- > 0;) {
      beside += parts.col(static_cast<Eigen::Index>(j)) * stresses_at(modes[j].cut, places);
      const double of_range = range > 0.0 ? largest_range(beside) / range : 0.0;
      missed[j] = std::max(beside.cwiseAbs().maxCoeff() / peak, of_range);
      // A harmonic that meets a frequency without damping has no bound.
      constexpr double no_bound = 1e6;
      missed[j] = std::isfinite(beside.sum()) ? std::min(missed[j], no_bound) : no_bound;
    }
    return missed;
  }

  std::vector<LoadHarmonic> harmonics(const LoadHistory& history) const {
    Eigen::Index governing = 0;
    (stresses.colwise().maxCoeff() - stresses.colwise().minCoeff()).maxCoeff(&governing);
    const auto place = static_cast<std::size_t>(governing / stresses_of_place);
    return harmonics_of(bending_in_space(history, places[place]), 1.0 / history.period().value());
  }
};

/// What the first modes of a posture, taken for the whole motion, are estimated to add.
class SpaceEstimate {
 public:
  SpaceEstimate(const LoadHistory& history, const spatial::Chain& chain,
                const StoppedVibration& stopped, const TaperedBeam& of)
      : history_(&history), weighed_(history, of), base_(1.0 / history.period().value()) {
    const bool steeper = spatial::time_span_of(chain.mechanism()).steeper;
    if (weighed_.peak == 0.0 || steeper) return;
    if (history.closed()) {
      cuts_ = cuts_over(history, chain, stopped);
      return;
    }
    const LoadSpan& span = history.span();
    const spatial::StatesAround states(
        chain, {span.begin.value(), span.period.value(), span.closed, span.instants});
    const auto cuts = [&](double time) {
      return stopped.rigid_cuts(states.at(time), history.diagram_at(si<Time>(time)));
    };
    once_.emplace(open_motion_of(chain, history.span()), cuts, allowed_in_cuts_of_space);
  }

  /// Whether what modes add is estimated.
  bool estimates() const { return cuts_.size() > 0 || once_; }

  bool loaded() const { return weighed_.peak > 0.0; }

  std::vector<double> missed_by(const std::vector<frame::BeamMode>& modes) const {
    return weighed_.missed(modes, once_ ? parts_once(modes) : parts_over_period(modes));
  }

  std::vector<LoadHarmonic> harmonics() const { return weighed_.harmonics(*history_); }

 private:
  Eigen::MatrixXd parts_over_period(const std::vector<frame::BeamMode>& modes) const {
    Eigen::MatrixXd parts(cuts_.rows(), static_cast<Eigen::Index>(modes.size()));
    Eigen::Index j = 0;
    for (const frame::BeamMode& mode : modes)
      parts.col(j++) = dynamic_part(cuts_ * mode.work, mode.frequency, mode.damping, base_);
    return parts;
  }
  Eigen::MatrixXd parts_once(const std::vector<frame::BeamMode>& modes) const {
    const auto count = static_cast<Eigen::Index>(modes.size());
    Eigen::MatrixXd work(count, modes.front().work.size());
    Eigen::VectorXd frequencies(count), damping(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const frame::BeamMode& mode = modes[static_cast<std::size_t>(j)];
      work.row(j) = mode.work.transpose();
      frequencies[j] = mode.frequency;
      damping[j] = mode.damping;
    }
    return once_->dynamic_parts(work, frequencies, damping);
  }

  const LoadHistory* history_;
  WeighedStresses weighed_;
  double base_;
  Eigen::MatrixXd cuts_;
  std::optional<StrainedOnce> once_;  ///< of a motion that does not repeat
};

}  // namespace

Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam) {
  return stresses_over(history, places_in_space(beam));
}

Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam,
                                        const LoadSpan& span) {
  const std::vector<PlaceInSpace> places = places_in_space(beam);
  const auto rows = static_cast<Eigen::Index>(span.instants + (span.closed ? 0 : 1));
  Eigen::MatrixXd stresses(rows, stresses_of_place * static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(span.instants);
    stresses.row(i) = stresses_at(history.diagram_at(span.begin + part * span.period), places);
  }
  return stresses;
}

MissedInSpace missed_in_space(const LoadHistory& history, const TaperedBeam& beam,
                              const std::vector<frame::BeamMode>& modes,
                              const Eigen::MatrixXd& parts) {
  const WeighedStresses weighed(history, beam);
  if (weighed.peak == 0.0) return {};
  return {weighed.missed(modes, parts),
          history.closed() ? weighed.harmonics(history) : std::vector<LoadHarmonic>{}};
}

Eigen::VectorXd largest_stresses_in_space(const std::vector<frame::BeamMode>& modes,
                                          const TaperedBeam& beam) {
  const std::vector<PlaceInSpace> places = places_in_space(beam);
  Eigen::VectorXd largest(static_cast<Eigen::Index>(modes.size()));
  for (Eigen::Index j = 0; j < largest.size(); ++j)
    largest[j] = stresses_at(modes[static_cast<std::size_t>(j)].cut, places).cwiseAbs().maxCoeff();
  return largest;
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

std::vector<spatial::BeamPlacement> elastic_placements(const Project& project,
                                                       const spatial::Mechanism& mechanism) {
  std::vector<spatial::BeamPlacement> placements;
  for (const ElasticMember& member : elastic_members(project, mechanism))
    placements.push_back(member.placement);
  return placements;
}

StoppedScene stopped_scene(const spatial::Mechanism& mechanism, const spatial::State& state,
                           const std::vector<spatial::BeamPlacement>& members,
                           const GivingWay& giving, const std::vector<spatial::Wrench>& wrenches) {
  StoppedTies of(mechanism, state, members, giving, wrenches);
  return {std::move(of.bodies), std::move(of.ties)};
}

std::vector<bool> resting_bodies(const spatial::Mechanism& mechanism,
                                 const std::vector<spatial::BeamPlacement>& beams,
                                 const GivingWay& giving) {
  std::vector<bool> resting;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    const bool carried =
        joint.parent == spatial::ground || resting[static_cast<std::size_t>(joint.parent)];
    const bool held = joint.kind == spatial::JointKind::fixed || spatial::is_driven(joint);
    resting.push_back(carried && held && !spatial::is_forced(joint) &&
                      !gives_way(giving.of(joint)) &&
                      beam_on(static_cast<int>(i), beams) == beams.end());
  }
  return resting;
}

CutForceDiagram rigid_cut_forces(const spatial::Chain& chain, const spatial::State& state,
                                 const spatial::BeamBody& beam,
                                 const std::vector<spatial::Wrench>& wrenches) {
  const LoadsAt loads = staying_on(
      *beam.beam, [&](Time) { return spatial::beam_loads_of(chain, state, beam, wrenches); });
  return cut_forces_of(loads(si<Time>(state.time)));
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
  resting_ = resting_bodies(mechanism, placements_, giving_);
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

frame::VibratingScene StoppedVibration::scene_in(const spatial::State& state,
                                                 const CutForceDiagram& rigid) const {
  std::vector<spatial::Wrench> wrenches;
  if (!beside_.empty() || !giving_.empty()) wrenches = chain_->joint_wrenches(state);
  StoppedScene stopped = stopped_scene(chain_->mechanism(), state, placements_, giving_, wrenches);
  leave_out_resting(resting_, placements_, stopped);
  return {beams_in(state, rigid, wrenches), std::move(stopped.bodies), std::move(stopped.ties)};
}

std::vector<frame::BeamMode> StoppedVibration::modes(const spatial::State& state,
                                                     const CutForceDiagram& rigid,
                                                     std::size_t count) {
  return frame::modes_of(scene_in(state, rigid), count, ties_);
}

Eigen::VectorXd StoppedVibration::rigid_cuts(const spatial::State& state,
                                             const CutForceDiagram& rigid) const {
  return cuts_of_scene(scene_in(state, rigid));
}

ModesInMotion StoppedVibration::modes_in_motion(const spatial::State& state,
                                                const CutForceDiagram& rigid, std::size_t count) {
  const spatial::Mechanism& mechanism = chain_->mechanism();
  const frame::VibratingScene scene = scene_in(state, rigid);
  ModesInMotion result;
  result.modes = frame::modes_of(scene, count, ties_);
  const spatial::BeamPlacement& first = placements_.front();
  const Matrix3d R_WB = state.bodies[static_cast<std::size_t>(first.body)].R_WB * first.axes;
  const auto turning_of = [&](std::size_t body) {
    const spatial::BodyMotion& of = state.bodies[body];
    return frame::Turning{R_WB.transpose() * of.omega, R_WB.transpose() * of.alpha};
  };
  std::vector<frame::Turning> frames;
  for (const spatial::BeamPlacement& of : placements_)
    frames.push_back(turning_of(static_cast<std::size_t>(of.body)));
  /// Of the bodies, in the order of the scene: from its axes to their own, and roots of inertias.
  std::vector<Matrix3d> own, roots;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    if (resting_[i] || beam_on(static_cast<int>(i), placements_) != placements_.end()) continue;
    frames.push_back(turning_of(i));
    own.push_back(state.bodies[i].R_WB.transpose() * R_WB);
    roots.push_back(roots_[i]);
  }
  result.turning = frame::turning_terms_of(scene, result.modes, frames);
  const Eigen::VectorXd cuts = cuts_of_scene(scene);
  const auto size = static_cast<Eigen::Index>(result.modes.size());
  result.force.resize(size);
  result.damping.resize(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const frame::BeamMode& mode = result.modes[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < size; ++i)
      result.damping(i, j) = result.modes[static_cast<std::size_t>(i)].motion.dot(mode.drag);
    result.force[j] = cuts.dot(mode.work);
    const Eigen::VectorXd on_beams = frame::shape_on_beams(scene, mode);
    const auto others = static_cast<Eigen::Index>(6 * own.size());
    if (j == 0) result.shapes.resize(on_beams.size() + others, size);
    Eigen::VectorXd beside = mode.motion.tail(others);
    for (std::size_t b = 0; b < own.size(); ++b) {
      const auto at = static_cast<Eigen::Index>(6 * b);
      beside.segment<3>(at) =
          std::sqrt(scene.bodies[b].mass) * (own[b] * beside.segment<3>(at)).eval();
      beside.segment<3>(at + 3) = (roots[b] * own[b] * beside.segment<3>(at + 3)).eval();
    }
    result.shapes.col(j) << on_beams, beside;
  }
  return result;
}

std::string shape_of(const frame::BeamMode& mode) {
  constexpr const char* words[] = {"stretching",
                                   "bending about y",
                                   "bending about z",
                                   "torsion",
                                   "springs and joints beside the beam",
                                   "other beams and rods"};
  return words[std::max_element(mode.energy.begin(), mode.energy.end()) - mode.energy.begin()];
}

std::string obstacle_to_vibration_in_space(const std::deque<SituationRun>& rigid) {
  for (const SituationRun& run : rigid) {
    const spatial::Mechanism& mechanism = chain_of(run).mechanism();
    if (std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                    [](const spatial::Joint& joint) { return spatial::is_forced(joint); }))
      return "forces decide the motion: with its drivers held the mechanism is free to move";
    if (spatial::time_span_of(mechanism).steeper)
      return "the edges of a table of forces are steeper than the instants looked at";
  }
  return "";
}

double vibration_missed_in_space(const Project& project, const ModelChoice& model) {
  const bool frame = std::holds_alternative<frame::Structure>(project.mechanism);
  if (!frame && !std::holds_alternative<spatial::Mechanism>(project.mechanism)) return 0.0;
  if (model.chosen.level == ModelLevel::modal) return 0.0;
  if (model.weighed.empty()) return 0.0;
  const ModelEstimate& by_rigid = model.weighed.front();
  const SecondOrderEstimate& pressed = model.second_order;
  const double bending = pressed.whole ? pressed.change.value_or(0.0) : 0.0;
  return std::max({0.0, by_rigid.error - bending, by_rigid.found.value_or(0.0)});
}

VibrationInSpace estimate_vibration_in_space(const Project& project, const SituationRun& run,
                                             int parts) {
  const spatial::Chain& chain = chain_of(run);
  StoppedVibration stopped(project, chain, parts);
  const SpaceEstimate of_loads(run.loads, chain, stopped, project.beam);
  VibrationInSpace result;
  VibrationEstimate& estimate = result.estimate;
  estimate.without_modes = {0.0};
  if (!of_loads.loaded()) return result;
  const double begin = run.loads.begin().value(), period = run.loads.period().value();
  double fastest = 0.0, beside = 0.0;  // of the first mode's mass what is not the beam's
  /// The first frequency in a posture, which is weighed; infinite without mass.
  const auto look_at = [&](double time) {
    const spatial::State state = chain.at(time);
    const std::vector<frame::BeamMode> modes =
        stopped.modes(state, run.loads.diagram_at(si<Time>(time)), modes_estimated);
    if (modes.empty()) return std::numeric_limits<double>::infinity();
    for (const spatial::BeamPlacement& beam : stopped.placements())
      fastest = std::max(fastest, state.bodies[static_cast<std::size_t>(beam.body)].omega.norm());
    const std::vector<double> missed =
        of_loads.estimates() ? of_loads.missed_by(modes) : std::vector<double>{};
    if (estimate.without_modes.size() < missed.size())
      estimate.without_modes.resize(missed.size(), 0.0);
    for (std::size_t k = 0; k < missed.size(); ++k)
      estimate.without_modes[k] = std::max(estimate.without_modes[k], missed[k]);
    beside = std::max(beside, std::clamp(1.0 - modes.front().own_mass, 0.0, 1.0));
    if (estimate.frequencies.empty() || modes.front().frequency < estimate.frequencies.front()) {
      estimate.frequencies.clear();
      for (const frame::BeamMode& mode : modes) estimate.frequencies.push_back(mode.frequency);
      result.lowest_at = si<Time>(time);
      result.shape = shape_of(modes.front());
    }
    return modes.front().frequency;
  };
  double now = begin;
  try {
    const bool closed = run.loads.closed();
    const std::size_t postures = closed ? postures_estimated : postures_estimated + 1;
    const double step = period / postures_estimated;
    std::vector<double> first;
    for (std::size_t k = 0; k < postures; ++k) {
      now = begin + step * static_cast<double>(k);
      first.push_back(look_at(now));
    }
    const auto [low, high] = std::minmax_element(first.begin(), first.end());
    // What hardly changes is known.
    if (*high > 1.001 * *low && std::isfinite(*high)) {
      double half = 0.5 * step;
      double middle = result.lowest_at.value();
      for (int round = 0; round < 4; ++round) {
        for (const double side : {middle - half, middle + half}) {
          now = closed ? begin + std::fmod(side - begin + period, period)
                       : std::clamp(side, begin, begin + period);
          look_at(now);
        }
        middle = result.lowest_at.value();
        half *= 0.5;
      }
    }
  } catch (const AnalysisError& error) {
    result.obstacle = fmt::format("stopped at {:.4g} s, {}", now, error.failure().what);
    return result;
  }
  if (estimate.frequencies.empty() || !of_loads.estimates()) return result;
  const double turning = std::pow(fastest / (full_turn * estimate.frequencies.front()), 2);
  // Bodies beside the beam turn with axes of their own, against which modes change.
  const double coupled = turning * beside;
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k)
    estimate.without_modes[k] += coupled;
  estimate.without_modes.front() += turning;
  const double rubbed = friction_in(chain.mechanism()) * estimate.without_modes.front();
  for (double& error : estimate.without_modes) error += rubbed;
  estimate.left_out = coupled + rubbed;
  if (run.loads.closed()) estimate.harmonics = of_loads.harmonics();
  return result;
}

}  // namespace boxbeam
