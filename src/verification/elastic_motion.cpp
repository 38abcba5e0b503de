#include "boxbeam/verification/elastic_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "modal_transient.hpp"
#include "repeated_vibration.hpp"

namespace boxbeam {
namespace {

[[noreturn]] void refuse_buckling(double time) {
  refuse_vibration(
      "the beam buckles in the plane of motion under its axial force: no elastic loads exist; "
      "use --model rigid to see those of rigid bodies",
      time);
}

/// Stops where a posture buckles.
LoadedPosture standing_posture(const RigidMotion& rigid, const ElasticBody& elastic,
                               const planar::State& state, const BeamLoads& loads,
                               const BeamLoads* axial = nullptr) {
  LoadedPosture posture =
      loaded_posture(*rigid.mechanism, state, elastic, *rigid.beam, loads, 1.0, axial);
  if (!stands(posture)) refuse_buckling(state.time);
  return posture;
}

/// Largest axial force over the motion, by the one that buckles a pinned beam of the least bending
/// stiffness.
double axial_part(const RigidMotion& rigid, const ElasticBody& elastic) {
  double least = 1e300;
  for (const flexible::LinkStretch& stretch : elastic.stretches) {
    least = std::min({least, stretch.EI(0.0), stretch.EI(stretch.length)});
  }
  constexpr std::size_t looked_at = 48;
  const std::vector<planar::State>& states = rigid.motion->states;
  double most = 0.0;
  for (std::size_t i = 0; i < states.size();
       i += std::max<std::size_t>(1, states.size() / looked_at)) {
    for (const CutForcePiece& piece : cut_forces_of(rigid.loads(si<Time>(states[i].time))).pieces) {
      most = std::max({most, std::abs(piece.N(0.0)), std::abs(piece.N(piece.length.value()))});
    }
  }
  return most * std::pow(elastic.length / std::numbers::pi, 2) / least;
}

Eigen::VectorXd squares_of(const PostureModes& modes) {
  Eigen::VectorXd squares(static_cast<Eigen::Index>(modes.frequencies.size()));
  for (Eigen::Index j = 0; j < squares.size(); ++j)
    squares[j] = std::pow(full_turn * modes.frequencies[static_cast<std::size_t>(j)], 2);
  return squares;
}

/// Of K a part of its largest entry, of C of what that damps critically, of every force of its own
/// largest value, or of all where it hardly counts beside the others. Where modes may be `free`,
/// slow ones are to be right beside fast ones: of K between two of them a part of the mean of their
/// own.
Eigen::VectorXd allowed_of(const Eigen::VectorXd& largest, Eigen::Index k, bool free) {
  constexpr double part = 1e-4, hardly = 1e-2, slow = 1e-6;
  const Eigen::VectorXd stiffness = largest.segment(k * k, k * k).reshaped(k, k).diagonal();
  const double most = largest.segment(k * k, k * k).maxCoeff();
  const Eigen::VectorXd omega = stiffness.cwiseMax((free ? slow : 1.0) * most).cwiseSqrt(),
                        root = omega.cwiseSqrt();
  const double force = largest.tail(k).maxCoeff();
  const Eigen::MatrixXd of_damping = part * root * root.transpose(),
                        of_stiffness = part * omega * omega.transpose();
  Eigen::VectorXd allowed(largest.size());
  allowed << of_damping.reshaped(), of_stiffness.reshaped(),
      part * largest.tail(k).cwiseMax(hardly * force);
  return allowed;
}

}  // namespace

LoadsAt bent_statically(const RigidMotion& rigid, const ElasticBody& elastic, LoadsAt axial) {
  auto states = std::make_shared<planar::StatesAround>(*rigid.mechanism, *rigid.motion);
  return [rigid, elastic = elastic.with_straight_rods(), states,
          axial = std::move(axial)](Time time) {
    BeamLoads loads = rigid.loads(time);
    const BeamLoads borne = axial ? axial(time) : loads;
    const BeamLoads bent =
        second_order_of(standing_posture(rigid, elastic, states->at(time.value()), loads, &borne))
            .loads;
    loads.lines = on_stretches_of(loads.lines, bent.lines);
    add_mode(loads, 1.0, bent);
    return loads;
  };
}

ElasticMotion::ElasticMotion(RigidMotion rigid, ElasticBody elastic, std::size_t modes,
                             LoadsAt axial)
    : rigid_(std::move(rigid)),
      states_(std::make_shared<planar::StatesAround>(*rigid_.mechanism, *rigid_.motion)),
      elastic_(std::move(elastic)),
      count_(modes),
      axial_(std::move(axial)) {
  const planar::Motion& motion = *rigid_.motion;
  if (motion.closed && !motion.changes.empty())
    refuse_vibration(
        "a stop or a cable begins or ends to act in a motion that repeats, and the modes of the "
        "beam change at once; use --model rigid to have the loads of rigid bodies all the same",
        motion.changes.front());
  count_ += freedoms();
  const planar::State& first = motion.states.front();
  begin_passage(-std::numeric_limits<double>::infinity(), 0.0,
                modes_of(posture_at(first, rigid_.loads(si<Time>(first.time)), first.time)));
  if (motion.closed)
    solve_periodic();
  else
    solve_once();
}

std::size_t ElasticMotion::freedoms() const {
  return static_cast<std::size_t>(rigid_.motion->freedom.undriven);
}

/// Adds what presses a mechanism that is free to move.
void ElasticMotion::press_free(const planar::State& state, const BeamLoads& rigid,
                               const LoadedPosture& straight, const PostureModes& modes,
                               FrameTerms& frame) const {
  constexpr double faster = 2.0;
  const LoadedPosture pressed = posture_at(state, rigid, state.time, 1.0);
  if (!all_parts_stand(pressed)) refuse_buckling(state.time);
  frame.of_size += geometric_stiffness_of(modes, straight, pressed);
  double turned = 0.0;
  for (Eigen::Index angle = 2; angle < state.v.size(); angle += 3)
    turned = std::max({turned, std::pow(state.v[angle], 2), std::abs(state.a[angle])});
  const Eigen::VectorXd squares = squares_of(modes);
  for (Eigen::Index j = 0; j < squares.size(); ++j) {
    if (squares[j] > faster * faster * turned) continue;
    for (Eigen::MatrixXd* const of : {&frame.of_rate, &frame.of_size}) {
      of->row(j).setZero();
      of->col(j).setZero();
    }
  }
  Eigen::MatrixXd stiffness = 0.5 * (frame.of_size + frame.of_size.transpose());
  stiffness.diagonal() += squares;
  const Eigen::Index strained = (squares.array() > 0.0).count();
  if (strained == 0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness.bottomRightCorner(strained, strained), Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues()[0] > 0.0)) refuse_buckling(state.time);
}

ModalPosture ElasticMotion::passed_in(const planar::State& state, const BeamLoads& rigid,
                                      const LoadedPosture& loaded, const Aligned& aligned) const {
  const PostureModes& at = aligned.modes;
  FrameTerms frame = frame_terms(at, state);
  if (freedoms() > 0) press_free(state, rigid, loaded, at, frame);
  ModalPosture posture;
  posture.squares = squares_of(at);
  posture.damping = at.damping;
  posture.of_material = damping_of_material(at, aligned.dampers);
  posture.of_rate = std::move(frame.of_rate);
  posture.of_size = std::move(frame.of_size);
  posture.force = modal_loads(at, loaded);
  posture.turn = aligned.turn;
  return posture;
}

ModalPosture ElasticMotion::passed_at(double time) const {
  const planar::State state = states_->at(time);
  const BeamLoads rigid = rigid_.loads(si<Time>(time));
  const LoadedPosture loaded = posture_at(state, rigid, time);
  return passed_in(state, rigid, loaded, aligned_at(loaded, time));
}

void ElasticMotion::solve_periodic() {
  const planar::Motion& motion = *rigid_.motion;
  const auto stride = static_cast<std::size_t>(stride_of(motion.states.size(), count_));
  // Of more the loads at all of them would take much memory.
  constexpr std::size_t most_kept = 1024;
  const std::size_t instants = motion.states.size() / stride;
  std::vector<ModalPosture> postures;
  std::vector<AddedLoads> added;
  for (std::size_t i = 0; i < instants; ++i) {
    const planar::State& state = motion.states[i * stride];
    const BeamLoads rigid = rigid_.loads(si<Time>(state.time));
    const LoadedPosture loaded = posture_at(state, rigid, state.time);
    Aligned aligned = aligned_at(loaded, state.time);
    postures.push_back(passed_in(state, rigid, loaded, aligned));
    lowest_ = std::min(lowest_, std::sqrt(postures.back().squares[0]) / full_turn);
    if (instants > most_kept) continue;
    added.push_back({state.time, size_of_loads(rigid, elastic_.length),
                     second_order_of(loaded).loads, in_basis(aligned.modes.loads, aligned.turn),
                     std::move(aligned.dampers)});
    for (JointDamper& of : added.back().dampers) of.gaps = aligned.turn.transpose() * of.gaps;
  }
  repeated_ = std::make_shared<const RepeatedVibration>(
      rigid_, elastic_.length, solve_modal_motion(postures, motion.period), std::move(added));
}

void ElasticMotion::solve_once() {
  const planar::Motion& motion = *rigid_.motion;
  const auto k = static_cast<Eigen::Index>(count_);
  PassedOnce passed;
  passed.posture_at = [this](double time) -> PassedPosture { return {passed_at(time), {}}; };
  passed.accuracy = [k, free = freedoms() > 0](const Eigen::VectorXd& largest) {
    return allowed_of(largest, k, free);
  };
  passed.resting = [&]() -> RestingModes {
    const double behind = motion.begin + motion.period + motion.period;
    const PostureModes modes =
        modes_of(posture_at(states_->at(behind), rigid_.loads(si<Time>(behind)), behind));
    const std::vector<ComparedPlace> places = compared_places_of(*rigid_.beam);
    Eigen::VectorXd stresses(k);
    for (Eigen::Index j = 0; j < k; ++j) {
      stresses[j] =
          fibre_stresses(modes.diagrams[static_cast<std::size_t>(j)], places).abs().maxCoeff();
    }
    return {passed_at(behind), Eigen::VectorXd::Map(modes.frequencies.data(), k),
            std::move(stresses)};
  };
  // Constant, but for a vibrating axial force.
  passed.vibrates_behind = static_cast<bool>(axial_);
  OpenMotion once = open_motion_of(*rigid_.mechanism, motion);
  const auto acting_at = [&](double time) {
    return planar::acting_springs(*rigid_.mechanism, states_->at(time));
  };
  // What drivers decide knows them.
  if (freedoms() > 0 && planar::has_damped_touches(*rigid_.mechanism))
    add_borders_between(acting_at, once.step(), once.borders);
  passed.changes = changes_between(once.borders, acting_at);
  passed.turned_at = [this, borders = once.borders](double change) {
    return turned_at(change, borders);
  };
  transient_ = std::make_shared<const ModalTransient>(std::move(once), passed);
  lowest_ = transient_->lowest_frequency();
}

/// What turns the coordinates before a change of what acts into those behind it, of which the
/// postures are from there on.
Eigen::MatrixXd ElasticMotion::turned_at(double change, const std::vector<double>& borders) {
  // So near that nothing has moved, and so far that only round-off is nearer.
  const auto border = std::lower_bound(borders.begin(), borders.end(), change);
  const double beside = 1e-6 * std::min(change - *(border - 1), *(border + 1) - change);
  const auto loaded_at = [&](double time) {
    return posture_at(states_->at(time), rigid_.loads(si<Time>(time)), time);
  };
  const LoadedPosture before = loaded_at(change - beside), behind = loaded_at(change + beside);
  const Aligned ahead = aligned_at(before, change - beside);
  const PostureModes from_here = modes_of(behind);
  begin_passage(change, beside, from_here);
  return masses_between(behind, from_here, ahead.modes) * ahead.turn;
}

/// A time, or at a change of what acts one so near to it that the same acts.
double ElasticMotion::beside_changes(double time) const {
  for (const Passage& of : passages_) {
    if (time >= of.from + of.beside || time <= of.from - of.beside) continue;
    return time < of.from ? of.from - of.beside : of.from + of.beside;
  }
  return time;
}

const Eigen::MatrixXd& ElasticMotion::coordinates() const { return repeated_->coordinates(); }

const TransientResponse* ElasticMotion::transient() const {
  return transient_ ? &transient_->response() : nullptr;
}

LoadSpan ElasticMotion::span_of(const LoadSpan& rigid) const {
  return transient_ ? transient_->span_of(rigid) : rigid;
}

LoadedPosture ElasticMotion::posture_at(const planar::State& state, const BeamLoads& rigid,
                                        double time, double pressed) const {
  std::optional<BeamLoads> axial;
  if (axial_ && pressed > 0.0) axial = axial_(si<Time>(time));
  const BeamLoads* const borne = axial ? &*axial : nullptr;
  if (freedoms() == 0) return standing_posture(rigid_, elastic_, state, rigid, borne);
  return loaded_posture(*rigid_.mechanism, state, elastic_, *rigid_.beam, rigid, pressed, borne);
}

LoadedPosture ElasticMotion::posture_at(const planar::State& state, const BeamLoads& rigid,
                                        double time) const {
  return posture_at(state, rigid, time, freedoms() == 0 ? 1.0 : 0.0);
}

PostureModes ElasticMotion::modes_of(const LoadedPosture& posture) const {
  return modes_in_posture(posture, count_, freedoms());
}

void ElasticMotion::begin_passage(double from, double beside, const PostureModes& modes) {
  passages_.push_back({from, beside, modes.shapes,
                       std::count(modes.frequencies.begin(), modes.frequencies.end(), 0.0)});
}

ElasticMotion::Aligned ElasticMotion::aligned_at(const LoadedPosture& posture, double time) const {
  PostureModes modes = modes_of(posture);
  // At a change those behind it.
  const auto behind =
      std::upper_bound(passages_.begin() + 1, passages_.end(), time,
                       [](double value, const Passage& of) { return value < of.from; });
  const Passage& of = *(behind - 1);
  // What moves without force and what does not are turned by themselves: the first may move far,
  // bears nothing and need not be recognised.
  const Eigen::Index strained = of.shapes.cols() - of.free;
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(of.shapes.cols(), of.shapes.cols());
  if (of.free > 0)
    turn.topLeftCorner(of.free, of.free) =
        nearest_turn(modes.shapes.leftCols(of.free), of.shapes.leftCols(of.free));
  if (strained > 0)
    turn.bottomRightCorner(strained, strained) =
        turn_between(modes.shapes.rightCols(strained), of.shapes.rightCols(strained), time);
  std::vector<JointDamper> dampers = dampers_in(posture, modes);
  return {std::move(modes), std::move(turn), std::move(dampers)};
}

ElasticMotion::Moment ElasticMotion::moment_at(double time) const {
  BeamLoads loads = rigid_.loads(si<Time>(time));
  const double beside = beside_changes(time);
  const LoadedPosture posture = posture_at(
      states_->at(beside), beside == time ? loads : rigid_.loads(si<Time>(beside)), beside);
  Aligned aligned = aligned_at(posture, beside);
  Eigen::VectorXd statically;
  if (!rigid_.motion->closed) {
    statically = modal_loads(aligned.modes, posture)
                     .cwiseProduct(flexibilities_of(squares_of(aligned.modes)));
  }
  const BeamLoads bent = freedoms() == 0 ? second_order_of(posture).loads
                                         : taken_over_in(posture, aligned.modes.motions);
  loads.lines = on_stretches_of(loads.lines, bent.lines);
  add_mode(loads, 1.0, bent);
  return {std::move(loads), std::move(aligned), std::move(statically)};
}

BeamLoads ElasticMotion::loads_at(Time time) const {
  if (repeated_)
    if (auto known = repeated_->loads_at(time)) return *std::move(known);
  const bool behind =
      transient_ && !axial_ && time.value() > rigid_.motion->begin + rigid_.motion->period;
  if (behind && !at_end_) at_end_ = std::make_shared<const Moment>(moment_at(time.value()));
  const Moment now = behind ? *at_end_ : moment_at(time.value());
  const auto& [at, turn, dampers] = now.aligned;
  Eigen::VectorXd sizes, speed;
  if (transient_) {
    const ModalState state = transient_->response().at(time.value());
    speed = turn * state.speed;
    const Eigen::VectorXd viscous = damping_of_material(at, dampers) * speed;
    sizes =
        turn * state.eta + viscous.cwiseProduct(flexibilities_of(squares_of(at))) - now.statically;
  } else {
    sizes = turn * repeated_->dynamic_at(time.value());
    if (!dampers.empty()) speed = turn * repeated_->speed_at(time.value());
  }
  BeamLoads loads = now.bent;
  for (std::size_t j = 0; j < count_; ++j) {
    add_mode(loads, sizes[static_cast<Eigen::Index>(j)], at.loads[j]);
  }
  for (const JointDamper& damper : dampers)
    add_mode(loads, damper.damping * damper.gaps.dot(speed), damper.loads);
  return loads;
}

LoadHistory elastic_loads_of(const Project& project, const planar::Mechanism& mechanism,
                             const planar::Motion& motion, const ElasticModel& model,
                             const LoadSpan& span, LoadsAt rigid) {
  if (model.level == ModelLevel::rigid) return {span, std::move(rigid)};
  require_few_instants(motion.states.size());
  const RigidMotion bodies{&mechanism, &motion, &project.beam, std::move(rigid)};
  const ElasticBody elastic = elastic_body_of(project, model.parts);
  if (model.level == ModelLevel::quasi_static) return {span, bent_statically(bodies, elastic)};
  const auto modes = static_cast<std::size_t>(model.modes);
  auto first = std::make_shared<const ElasticMotion>(bodies, elastic, modes);
  // The vibrating part of an axial force that hardly counts does not count.
  constexpr double hardly = 0.02;
  if (axial_part(bodies, elastic) < hardly) {
    return {first->span_of(span), [first](Time time) { return first->loads_at(time); }};
  }
  const LoadsAt vibrating = [first](Time time) { return first->loads_at(time); };
  auto of = std::make_shared<const ElasticMotion>(bodies, elastic, modes, vibrating);
  return {of->span_of(span), [of](Time time) { return of->loads_at(time); }};
}

}  // namespace boxbeam
