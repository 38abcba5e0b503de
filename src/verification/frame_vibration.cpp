#include "frame_vibration.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "elastic_motion_in_space.hpp"
#include "strained_once.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using frame::Vector6;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t modes_of_frame = 6, instants_of_axial_force = 6;

frame::Structure changing_part_of(const frame::Structure& structure) {
  frame::Structure of = structure;
  for (frame::LoadCase& in : of.cases)
    std::erase_if(in.actions,
                  [](const frame::Action& action) { return !frame::changes_over_time(action); });
  return of;
}

/// Whether something that acts changes over time.
bool changes_while_acting(const frame::Structure& structure) {
  for (std::size_t k = 0; k < structure.cases.size(); ++k) {
    const std::vector<frame::Action>& actions = structure.cases[k].actions;
    if (structure.factors[k] != 0.0 &&
        std::any_of(actions.begin(), actions.end(),
                    [](const frame::Action& of) { return frame::changes_over_time(of); }))
      return true;
  }
  return false;
}

/// Stations of a member at which something takes hold of it.
std::vector<double> held_stations(const frame::Structure& structure, std::size_t member) {
  std::vector<double> at;
  const auto add = [&](const frame::Place& place) {
    if (place.member == static_cast<int>(member)) at.push_back(place.p.x());
  };
  for (const frame::Joint& joint : structure.joints) {
    add(joint.a);
    add(joint.b);
  }
  for (const frame::LoadCase& in : structure.cases) {
    for (const frame::Action& action : in.actions)
      if (const auto* const driven = std::get_if<frame::DrivenAction>(&action.kind))
        add(driven->at);
  }
  return at;
}

/// Joints of a frame as ties between its members, in the axes of a scene.
std::vector<frame::Tie> ties_of_frame(const frame::Structure& structure,
                                      const std::vector<std::size_t>& place,
                                      const Matrix3d& from_world, const Vector3d& origin) {
  std::vector<frame::Tie> ties;
  for (const frame::Joint& joint : structure.joints) {
    for (std::size_t way = 0; way < 6; ++way) {
      const double stiffness = joint.stiffness[way];
      // In a plane frame joints know their plane's ways alone.
      const bool in_plane = way == 0 || way == 1 || way == 5;
      if (stiffness == 0.0 || (structure.plane && !in_plane)) continue;
      Vector6 per = Vector6::Zero();
      per.segment<3>(way < 3 ? 0 : 3) = from_world * joint.axes.col(static_cast<Index>(way % 3));
      const auto end = [&](const frame::Place& at, double sign) -> frame::Tie::End {
        const int member = at.member == frame::ground
                               ? frame::ground
                               : static_cast<int>(place[static_cast<std::size_t>(at.member)]);
        return {{member, from_world * (frame::in_world(structure, at) - origin)}, sign * per};
      };
      frame::Tie& tie = ties.emplace_back();
      tie.ends = {end(joint.a, -1.0), end(joint.b, 1.0)};
      tie.stiffness = stiffness;
      tie.name = joint.name;
    }
  }
  return ties;
}

/// Keeps a node of a member in the plane of the frame.
void keep_in_plane(int member, const Vector3d& at, const Matrix3d& from_world,
                   std::vector<frame::Tie>& ties) {
  for (const auto& [turns, axis] : {std::pair{false, 2}, {true, 0}, {true, 1}}) {
    frame::Tie& tie = ties.emplace_back();
    Vector6 per = Vector6::Zero();
    per.segment<3>(turns ? 3 : 0) = from_world.col(axis);
    tie.ends.push_back({{member, at}, per});
  }
}

/// What the value at each of these places weighs in that at x of the polynomial through them:
/// Lagrange.
std::vector<double> weights_of_polynomial(const std::vector<double>& places, double x) {
  std::vector<double> weights(places.size(), 1.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i) weights[i] *= (x - places[k]) / (places[i] - places[k]);
  }
  return weights;
}

VectorXd allowed_in_forces(const VectorXd& largest) {
  constexpr double part = 1e-5, hardly = 1e-2;
  return part * largest.cwiseMax(hardly * largest.maxCoeff());
}

/// The time of loads that do not repeat, as what vibrates under them sees it.
OpenMotion open_time_of(const LoadSpan& span, const std::function<VectorXd(double)>& forces) {
  OpenMotion time;
  time.begin = span.begin.value();
  time.length = span.period.value();
  time.instants = span.instants;
  time.borders = {time.begin};
  constexpr double same = 1e-9;
  for (const Time& at : span.breaks)
    if (at.value() > time.borders.back() + same * time.length &&
        at.value() < time.end() - same * time.length)
      time.borders.push_back(at.value());
  time.borders.push_back(time.end());
  time.rests_before = true;
  // Small beside all that happens.
  const double h = time.step() / 64.0;
  const VectorXd last = forces(time.end()), before = forces(time.end() - h);
  double largest = 0.0;
  for (std::size_t i = 0; i <= time.instants; ++i)
    largest = std::max(
        largest,
        forces(time.begin + time.step() * static_cast<double>(i)).lpNorm<Eigen::Infinity>());
  constexpr double still = 1e-6;
  time.rests_behind = (last - before).lpNorm<Eigen::Infinity>() <= still * largest;
  return time;
}

/// The generalised forces at equal steps of a period, a row for each.
MatrixXd forces_over(const VibratingFrame& frame, const std::vector<frame::BeamMode>& modes,
                     const LoadSpan& span) {
  const double begin = span.begin.value(), period = span.period.value();
  MatrixXd forces(static_cast<Index>(span.instants), static_cast<Index>(modes.size()));
  for (Index i = 0; i < forces.rows(); ++i) {
    const double time =
        begin + period * static_cast<double>(i) / static_cast<double>(span.instants);
    forces.row(i) = frame.forces(modes, time, begin, begin + period).transpose();
  }
  return forces;
}

/// Each mode beyond its static part over the time of the loads.
MatrixXd parts_over_time(const VibratingFrame& frame, const std::vector<frame::BeamMode>& modes,
                         const LoadSpan& span) {
  const double begin = span.begin.value(), period = span.period.value();
  const auto count = static_cast<Index>(modes.size());
  if (span.closed) {
    MatrixXd parts = forces_over(frame, modes, span);
    for (Index j = 0; j < count; ++j) {
      const frame::BeamMode& mode = modes[static_cast<std::size_t>(j)];
      parts.col(j) = dynamic_part(parts.col(j).eval(), mode.frequency, mode.damping, 1.0 / period);
    }
    return parts;
  }
  const auto forces = [&](double time) { return frame.forces(modes, time, begin, begin + period); };
  VectorXd frequencies(count), damping(count);
  for (Index j = 0; j < count; ++j) {
    frequencies[j] = modes[static_cast<std::size_t>(j)].frequency;
    damping[j] = modes[static_cast<std::size_t>(j)].damping;
  }
  const StrainedOnce once(open_time_of(span, forces), forces, allowed_in_forces);
  return once.dynamic_parts(MatrixXd::Identity(count, count), frequencies, damping);
}

/// Times at which axial forces are looked at.
std::vector<double> looked_times(const LoadSpan& span) {
  std::vector<double> times;
  for (std::size_t i = 0; i < instants_of_axial_force + (span.closed ? 0 : 1); ++i)
    times.push_back(
        (span.begin + span.period * (static_cast<double>(i) / instants_of_axial_force)).value());
  return times;
}

}  // namespace

VibratingFrame::VibratingFrame(const Project& project, const frame::Structure& structure, int parts)
    : structure_(&structure),
      moving_(changing_part_of(structure)),
      statics_(structure),
      place_(structure.members.size()) {
  order_ = {static_cast<std::size_t>(project.beam_body)};
  for (std::size_t m = 0; m < structure.members.size(); ++m)
    if (m != order_.front()) order_.push_back(m);
  for (std::size_t b = 0; b < order_.size(); ++b) {
    const frame::Member& member = structure.members[order_[b]];
    place_[order_[b]] = b;
    beams_.emplace_back(member.beam, member.youngs_modulus, member.shear_modulus,
                        held_stations(structure, order_[b]), parts, project.model.retardation);
  }
}

std::vector<frame::BeamMode> VibratingFrame::modes(double time, std::size_t count) const {
  const frame::Equilibrium loaded = statics_.solve(frame::acting_at(*structure_, time));
  const frame::Member& first = structure_->members[order_.front()];
  const Matrix3d from_world = first.axes.transpose();
  frame::VibratingScene scene;
  for (std::size_t b = 0; b < order_.size(); ++b) {
    const frame::Member& member = structure_->members[order_[b]];
    scene.beams.push_back({&beams_[b], loaded.members[order_[b]].cut,
                           from_world * (member.start - first.start), from_world * member.axes});
  }
  scene.ties = ties_of_frame(*structure_, place_, from_world, first.start);
  if (structure_->plane) {
    for (std::size_t b = 0; b < order_.size(); ++b) {
      for (const double s : beams_[b].nodes())
        keep_in_plane(static_cast<int>(b), scene.beams[b].start + s * scene.beams[b].axes.col(0),
                      from_world, scene.ties);
    }
  }
  return frame::modes_of(scene, count);
}

/// Shift and turn of a member's axis, in the axes of the member. Within a piece the polynomial
/// through its ends and the places where its motion is known.
VibratingFrame::Moved VibratingFrame::moved_at(std::size_t beam, double s) const {
  const frame::VibratingBeam& of = beams_[beam];
  const std::vector<frame::VibratingBeam::Piece>& pieces = of.pieces();
  Moved moved;
  for (std::size_t b = 0; b < beam; ++b)
    moved.row += static_cast<Index>(6 * beams_[b].nodes().size());
  std::size_t station = 0, k = 0;
  for (; k + 1 < pieces.size() && s > pieces[k].to; ++k) station += pieces[k].samples.size();
  const frame::VibratingBeam::Piece& piece = pieces[k];
  moved.row += static_cast<Index>(6 * k);
  std::vector<double> places{piece.from, piece.to};
  for (std::size_t i = 0; i < piece.samples.size(); ++i)
    places.push_back(of.stations()[station + i].s.value());
  const std::vector<double> weights = weights_of_polynomial(places, s);
  moved.by << weights[0] * Matrix6::Identity(), weights[1] * Matrix6::Identity();
  for (std::size_t i = 0; i < piece.samples.size(); ++i)
    moved.by += weights[i + 2] * piece.samples[i].motion;
  const Matrix3d into =
      structure_->members[order_[beam]].axes.transpose() * structure_->members[order_.front()].axes;
  for (Index part = 0; part < 4; ++part)
    moved.by.middleCols<3>(3 * part) = (moved.by.middleCols<3>(3 * part) * into).eval();
  return moved;
}

VectorXd VibratingFrame::forces(const std::vector<frame::BeamMode>& modes, double time,
                                double begin, double end) const {
  VectorXd sum = VectorXd::Zero(static_cast<Index>(modes.size()));
  const frame::ActingLoads acting = frame::acting_at(moving_, std::clamp(time, begin, end));
  for (const frame::ActingLoads::Point& point : acting.points) {
    const frame::Place& at = point.action.at;
    const auto member = static_cast<std::size_t>(at.member);
    const Matrix3d into = structure_->members[member].axes.transpose();
    const Vector3d force = into * point.action.force,
                   about_axis =
                       into * point.action.moment + Vector3d(0.0, at.p.y(), at.p.z()).cross(force);
    Vector6 wrench;
    wrench << force, about_axis;
    const Moved moved = moved_at(place_[member], at.p.x());
    const Eigen::Matrix<double, 12, 1> on_nodes = moved.by.transpose() * wrench;
    for (Index j = 0; j < sum.size(); ++j)
      sum[j] += on_nodes.dot(modes[static_cast<std::size_t>(j)].motion.segment<12>(moved.row));
  }
  return sum;
}

bool has_loads_over_time(const Project& project) {
  if (!std::holds_alternative<frame::Structure>(project.mechanism)) return false;
  return std::any_of(
      project.situations.begin(), project.situations.end(), [&](const Situation& situation) {
        return situation.runs() && changes_while_acting(frame_in(project, situation));
      });
}

FrameVibration estimate_vibration_of_frame(const Project& project, const SituationRun& run,
                                           int parts) {
  FrameVibration result;
  result.estimate.without_modes = {0.0};
  const frame::Structure& structure = frame_in(project, *run.situation);
  const LoadSpan& span = run.loads.span();
  if (!changes_while_acting(structure)) return result;
  const std::vector<DriverUse> functions = frame::functions_of(structure);
  if (!functions.empty() && time_span_of(functions, structure.duration).steeper) {
    result.obstacle = "the edges of a table of forces are steeper than the instants looked at";
    return result;
  }
  double now = 0.0;
  std::vector<double> looked;  // first frequencies
  try {
    const VibratingFrame vibrating(project, structure, parts);
    for (const double time : looked_times(span)) {
      now = time;
      const std::vector<frame::BeamMode> modes = vibrating.modes(time, modes_of_frame);
      if (modes.empty()) continue;
      // Under nearly the same axial forces it vibrates alike.
      constexpr double alike = 1e-3;
      const double first = modes.front().frequency;
      if (std::any_of(looked.begin(), looked.end(),
                      [&](double f) { return std::abs(f - first) < alike * first; }))
        continue;
      looked.push_back(first);
      MissedInSpace missed =
          missed_in_space(run.loads, project.beam, modes, parts_over_time(vibrating, modes, span));
      std::vector<double>& worst = result.estimate.without_modes;
      if (worst.size() < missed.without_modes.size())
        worst.resize(missed.without_modes.size(), 0.0);
      for (std::size_t k = 0; k < missed.without_modes.size(); ++k)
        worst[k] = std::max(worst[k], missed.without_modes[k]);
      result.estimate.harmonics = std::move(missed.harmonics);
      std::vector<double>& lowest = result.estimate.frequencies;
      if (!lowest.empty() && modes.front().frequency >= lowest.front()) continue;
      lowest.clear();
      for (const frame::BeamMode& mode : modes) lowest.push_back(mode.frequency);
      result.shape = shape_of(modes.front());
    }
  } catch (const AnalysisError& error) {
    result.obstacle = fmt::format("at {:.4g} s, {}", now, error.failure().what);
  }
  return result;
}

FrameResponse::FrameResponse(const Project& project, const frame::Structure& structure,
                             const LoadSpan& span, LoadsAt slowly, std::size_t modes, int parts)
    : slowly_(std::move(slowly)), begin_(span.begin.value()), period_(span.period.value()) {
  const VibratingFrame vibrating(project, structure, parts);
  for (const double time : looked_times(span)) {
    std::vector<frame::BeamMode> of = vibrating.modes(time, modes);
    if (of.empty()) refuse_vibration("without mass nothing vibrates", time);
    if (modes_.empty() || of.front().frequency < modes_.front().frequency) modes_ = std::move(of);
  }
  if (span.closed) {
    dynamic_ = parts_over_time(vibrating, modes_, span);
    return;
  }
  const auto count = static_cast<Index>(modes_.size());
  ModalPosture posture;
  posture.squares.resize(count);
  posture.damping = MatrixXd::Zero(count, count);
  posture.of_rate = posture.of_size = MatrixXd::Zero(count, count);
  posture.turn = MatrixXd::Identity(count, count);
  VectorXd frequencies(count);
  for (Index j = 0; j < count; ++j) {
    const frame::BeamMode& mode = modes_[static_cast<std::size_t>(j)];
    frequencies[j] = mode.frequency;
    posture.squares[j] = std::pow(full_turn * mode.frequency, 2);
    for (Index i = 0; i < count; ++i)
      posture.damping(i, j) = modes_[static_cast<std::size_t>(i)].motion.dot(mode.drag);
  }
  posture.of_material = posture.damping;
  const auto forces = [&](double time) {
    return vibrating.forces(modes_, time, begin_, begin_ + period_);
  };
  const auto posture_at = [&](double time) {
    ModalPosture at = posture;
    at.force = forces(time);
    return at;
  };
  PassedOnce passed;
  passed.posture_at = [&](double time) {
    ModalPosture at = posture_at(time);
    VectorXd statically = at.force.cwiseQuotient(at.squares);
    return PassedPosture{std::move(at), std::move(statically)};
  };
  passed.accuracy = [&](const VectorXd& largest) {
    // C and K do not change; p and its deflection.
    VectorXd allowed = VectorXd::Constant(largest.size(), 1e-9 * largest.maxCoeff());
    allowed.segment(2 * count * count, count) =
        allowed_in_forces(largest.segment(2 * count * count, count));
    allowed.tail(count) = allowed_in_forces(largest.tail(count));
    return allowed;
  };
  passed.resting = [&]() -> RestingModes {
    return {posture_at(begin_ + 2.0 * period_), frequencies,
            largest_stresses_in_space(modes_, project.beam)};
  };
  once_ = std::make_shared<const ModalTransient>(open_time_of(span, forces), passed);
}

LoadSpan FrameResponse::span_of(const LoadSpan& slowly) const {
  return once_ ? once_->span_of(slowly) : slowly;
}

/// Each mode beyond its static part, with its viscous one.
VectorXd FrameResponse::dynamic_at(double time) const {
  VectorXd dynamic;
  if (once_) {
    const ModalState state = once_->response().at(time);
    const VectorXd statically = once_->beside_at(time);
    dynamic.resize(state.eta.size());
    for (Index j = 0; j < dynamic.size(); ++j) {
      const frame::BeamMode& mode = modes_[static_cast<std::size_t>(j)];
      dynamic[j] = state.eta[j] +
                   mode.damping / std::pow(full_turn * mode.frequency, 2) * state.speed[j] -
                   statically[j];
    }
  } else {
    dynamic = trigonometric_at(dynamic_, (time - begin_) / period_);
  }
  return dynamic;
}

Vector6 FrameResponse::start_at(Time time) const {
  const VectorXd dynamic = dynamic_at(time.value());
  Vector6 sum = Vector6::Zero();
  for (std::size_t j = 0; j < modes_.size(); ++j)
    sum += dynamic[static_cast<Index>(j)] * modes_[j].motion.head<6>();
  return sum;
}

BeamLoads FrameResponse::loads_at(Time time) const {
  const VectorXd dynamic = dynamic_at(time.value());
  // Ties and pieces are the same of all modes.
  BeamLoads vibrating = modes_.front().loads;
  for (PointLoad& point : vibrating.points) {
    point.force.setZero();
    point.moment.setZero();
  }
  for (LineLoad& line : vibrating.lines) {
    line.force = {};
    line.couple = {};
  }
  for (std::size_t j = 0; j < modes_.size(); ++j) {
    const double part = dynamic[static_cast<Index>(j)];
    for (std::size_t i = 0; i < vibrating.points.size(); ++i) {
      vibrating.points[i].force += part * modes_[j].loads.points[i].force;
      vibrating.points[i].moment += part * modes_[j].loads.points[i].moment;
    }
    add_lines(vibrating.lines, part, modes_[j].loads.lines);
  }
  const double within = std::clamp(time.value(), begin_, begin_ + period_);
  BeamLoads loads = slowly_(once_ ? si<Time>(within) : time);
  add_bending(vibrating, loads);
  return loads;
}

}  // namespace boxbeam
