#include "boxbeam/verification/elastic_motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "modal_transient.hpp"

namespace boxbeam {
namespace {

/// Adds what a mode does to a beam to its loads: at the same places, and on the mode's stretches,
/// which lie inside the beam's own.
void add_mode(BeamLoads& sum, double factor, const BeamLoads& mode) {
  for (const PointLoad& load : mode.points) {
    auto same = std::find_if(sum.points.begin(), sum.points.end(),
                             [&](const PointLoad& other) { return other.s == load.s; });
    if (same == sum.points.end() && load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    if (same == sum.points.end()) {
      PointLoad empty;
      empty.s = load.s;
      same = sum.points.insert(same, empty);
    }
    same->force += factor * load.force;
    same->moment += factor * load.moment;
  }
  add_lines(sum.lines, factor, mode.lines);
}

/// Stops where a posture buckles.
LoadedPosture standing_posture(const RigidMotion& rigid, const ElasticBody& elastic,
                               const planar::State& state, const BeamLoads& loads,
                               const BeamLoads* axial = nullptr) {
  LoadedPosture posture =
      loaded_posture(*rigid.mechanism, state, elastic, *rigid.beam, loads, 1.0, axial);
  if (!stands(posture)) {
    refuse_vibration(
        "the beam buckles in the plane of motion under its axial force: no elastic loads exist; "
        "use --model rigid to see those of rigid bodies",
        state.time);
  }
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
/// largest value, or of all where it hardly counts beside the others.
Eigen::VectorXd allowed_of(const Eigen::VectorXd& largest, Eigen::Index k) {
  constexpr double part = 1e-4, hardly = 1e-2;
  const double stiffness = largest.segment(k * k, k * k).maxCoeff();
  const double force = largest.tail(k).maxCoeff();
  Eigen::VectorXd allowed(largest.size());
  allowed << Eigen::VectorXd::Constant(k * k, part * std::sqrt(stiffness)),
      Eigen::VectorXd::Constant(k * k, part * stiffness),
      part * largest.tail(k).cwiseMax(hardly * force);
  return allowed;
}

}  // namespace

LoadsAt bent_statically(const RigidMotion& rigid, const ElasticBody& elastic, LoadsAt axial) {
  auto states = std::make_shared<planar::StatesAround>(*rigid.mechanism, *rigid.motion);
  return [rigid, elastic, states, axial = std::move(axial)](Time time) {
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
  if (motion.freedom.undriven > 0) {
    refuse_vibration(
        "rigid bodies are not enough for this motion, and the beam's vibration is only computed in "
        "motions that drivers fix; use --model rigid to have the loads of rigid bodies all the "
        "same");
  }
  const planar::State& first = motion.states.front();
  reference_ =
      modes_in_posture(posture_at(first, rigid_.loads(si<Time>(first.time)), first.time), count_)
          .shapes;
  if (motion.closed)
    solve_periodic();
  else
    solve_once();
}

ModalPosture ElasticMotion::passed_at(const planar::State& state, const BeamLoads& rigid,
                                      double time) const {
  const LoadedPosture loaded = posture_at(state, rigid, time);
  auto [at, turn] = aligned_at(loaded, time);
  FrameTerms frame = frame_terms(at, state);
  ModalPosture posture;
  posture.squares = squares_of(at);
  posture.damping = std::move(at.damping);
  posture.of_rate = std::move(frame.of_rate);
  posture.of_size = std::move(frame.of_size);
  posture.force = modal_loads(at, loaded);
  posture.turn = std::move(turn);
  return posture;
}

void ElasticMotion::solve_periodic() {
  const planar::Motion& motion = *rigid_.motion;
  const auto stride = static_cast<std::size_t>(stride_of(motion.states.size(), count_));
  std::vector<ModalPosture> postures;
  for (std::size_t i = 0; i < motion.states.size() / stride; ++i) {
    const planar::State& state = motion.states[i * stride];
    postures.push_back(passed_at(state, rigid_.loads(si<Time>(state.time)), state.time));
    lowest_ = std::min(lowest_, std::sqrt(postures.back().squares[0]) / full_turn);
  }
  ModalMotion solved = solve_modal_motion(postures, motion.period);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
}

void ElasticMotion::solve_once() {
  const planar::Motion& motion = *rigid_.motion;
  const auto k = static_cast<Eigen::Index>(count_);
  PassedOnce passed;
  passed.posture_at = [this](double time) -> PassedPosture {
    return {passed_at(states_->at(time), rigid_.loads(si<Time>(time)), time), {}};
  };
  passed.accuracy = [k](const Eigen::VectorXd& largest) { return allowed_of(largest, k); };
  passed.resting = [&]() -> RestingModes {
    const double behind = motion.begin + motion.period + motion.period;
    const planar::State state = states_->at(behind);
    const BeamLoads loads = rigid_.loads(si<Time>(behind));
    const PostureModes modes = modes_in_posture(posture_at(state, loads, behind), count_);
    const std::vector<ComparedPlace> places = compared_places_of(*rigid_.beam);
    Eigen::VectorXd stresses(k);
    for (Eigen::Index j = 0; j < k; ++j) {
      stresses[j] =
          fibre_stresses(modes.diagrams[static_cast<std::size_t>(j)], places).abs().maxCoeff();
    }
    return {passed_at(state, loads, behind), Eigen::VectorXd::Map(modes.frequencies.data(), k),
            std::move(stresses)};
  };
  // Constant, but for a vibrating axial force.
  passed.vibrates_behind = static_cast<bool>(axial_);
  transient_ =
      std::make_shared<const ModalTransient>(open_motion_of(*rigid_.mechanism, motion), passed);
  lowest_ = transient_->lowest_frequency();
}

const TransientResponse* ElasticMotion::transient() const {
  return transient_ ? &transient_->response() : nullptr;
}

LoadSpan ElasticMotion::span_of(const LoadSpan& rigid) const {
  return transient_ ? transient_->span_of(rigid) : rigid;
}

LoadedPosture ElasticMotion::posture_at(const planar::State& state, const BeamLoads& rigid,
                                        double time) const {
  if (!axial_) return standing_posture(rigid_, elastic_, state, rigid);
  const BeamLoads axial = axial_(si<Time>(time));
  return standing_posture(rigid_, elastic_, state, rigid, &axial);
}

ElasticMotion::Aligned ElasticMotion::aligned_at(const LoadedPosture& posture, double time) const {
  PostureModes modes = modes_in_posture(posture, count_);
  Eigen::MatrixXd turn = turn_between(modes.shapes, reference_, time);
  return {std::move(modes), std::move(turn)};
}

Eigen::VectorXd ElasticMotion::dynamic_at(double time) const {
  return trigonometric_at(dynamic_, (time - rigid_.motion->begin) / rigid_.motion->period);
}

ElasticMotion::Moment ElasticMotion::moment_at(double time) const {
  BeamLoads loads = rigid_.loads(si<Time>(time));
  const LoadedPosture posture = posture_at(states_->at(time), loads, time);
  Aligned aligned = aligned_at(posture, time);
  Eigen::VectorXd statically;
  if (!rigid_.motion->closed) {
    statically = modal_loads(aligned.modes, posture).cwiseQuotient(squares_of(aligned.modes));
  }
  const BeamLoads bent = second_order_of(posture).loads;
  loads.lines = on_stretches_of(loads.lines, bent.lines);
  add_mode(loads, 1.0, bent);
  return {std::move(loads), std::move(aligned), std::move(statically)};
}

BeamLoads ElasticMotion::loads_at(Time time) const {
  const bool behind =
      transient_ && !axial_ && time.value() > rigid_.motion->begin + rigid_.motion->period;
  if (behind && !at_end_) at_end_ = std::make_shared<const Moment>(moment_at(time.value()));
  const Moment now = behind ? *at_end_ : moment_at(time.value());
  const auto& [at, turn] = now.aligned;
  Eigen::VectorXd sizes;
  if (transient_) {
    const ModalState state = transient_->response().at(time.value());
    const Eigen::VectorXd viscous = at.damping * (turn * state.speed);
    sizes = turn * state.eta + viscous.cwiseQuotient(squares_of(at)) - now.statically;
  } else {
    sizes = turn * dynamic_at(time.value());
  }
  BeamLoads loads = now.bent;
  for (std::size_t j = 0; j < count_; ++j) {
    add_mode(loads, sizes[static_cast<Eigen::Index>(j)], at.loads[j]);
  }
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
