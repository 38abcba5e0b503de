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
#include "boxbeam/numerics/chebyshev_curve.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "modal_motion.hpp"

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

/// Equations of k modes as one column, and back.
Eigen::VectorXd packed(const ModalEquations& of) {
  Eigen::VectorXd all(of.damping.size() + of.stiffness.size() + of.force.size());
  all << of.damping.reshaped(), of.stiffness.reshaped(), of.force;
  return all;
}

ModalEquations unpacked(const Eigen::VectorXd& all, Eigen::Index k) {
  return {all.head(k * k).reshaped(k, k), all.segment(k * k, k * k).reshaped(k, k), all.tail(k)};
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

double step_of_rates(const planar::Motion& motion) {
  constexpr double part = 1.0 / 64.0;
  return part * motion.period / static_cast<double>(motion.states.size());
}

std::vector<double> borders_of(const RigidMotion& rigid) {
  const planar::Motion& motion = *rigid.motion;
  const double begin = motion.begin, end = begin + motion.period;
  constexpr double same = 1e-9;
  std::vector<double> borders{begin};
  for (const Break& at : breaks_of(planar::functions_of(*rigid.mechanism), begin, end)) {
    if (at.at > borders.back() + same * motion.period && at.at < end - same * motion.period)
      borders.push_back(at.at);
  }
  borders.push_back(end);
  return borders;
}

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
    solve_from_rest();
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

void ElasticMotion::note_frequencies(const ModalPosture& posture) {
  lowest_ = std::min(lowest_, std::sqrt(posture.squares[0]) / full_turn);
  fastest_ = std::max(fastest_, std::sqrt(posture.squares.tail<1>()[0]) / full_turn);
}

void ElasticMotion::solve_periodic() {
  const planar::Motion& motion = *rigid_.motion;
  const auto stride = static_cast<std::size_t>(stride_of(motion.states.size(), count_));
  std::vector<ModalPosture> postures;
  for (std::size_t i = 0; i < motion.states.size() / stride; ++i) {
    const planar::State& state = motion.states[i * stride];
    postures.push_back(passed_at(state, rigid_.loads(si<Time>(state.time)), state.time));
    note_frequencies(postures.back());
  }
  ModalMotion solved = solve_modal_motion(postures, motion.period);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
}

void ElasticMotion::respond(std::vector<double> borders, double longest_piece) {
  const auto k = static_cast<Eigen::Index>(count_);
  const double end = rigid_.motion->begin + rigid_.motion->period;
  const double step = rigid_.motion->period / static_cast<double>(rigid_.motion->states.size());
  const auto ask = [&](double time) {
    const ModalPosture at = passed_at(states_->at(time), rigid_.loads(si<Time>(time)), time);
    note_frequencies(at);
    return packed(aligned(at));
  };
  // Behind the end only a vibrating axial force changes anything: no faster than modes do.
  const double shortest = transient_ ? 0.5 / fastest_ : step;
  const ChebyshevCurve curve(
      ask, {borders, longest_piece, std::min(shortest, longest_piece)},
      [k](const Eigen::VectorXd& largest) { return allowed_of(largest, k); });
  constexpr double steps_to_a_period = 20.0, steps_to_a_piece = 2.0;
  double longest_step = 1.0 / (steps_to_a_period * fastest_);
  if (borders.front() < end)
    longest_step = std::min(longest_step, curve.shortest_piece() / steps_to_a_piece);
  const auto equations = [&](double time) { return unpacked(curve.at(time), k); };
  if (transient_) {
    transient_->go_on(equations, borders, longest_step);
    return;
  }
  transient_.emplace(equations, borders, state_at_beginning(), longest_step);
}

ModalState ElasticMotion::state_at_beginning() const {
  const planar::Motion& motion = *rigid_.motion;
  const auto balance_at = [&](double time) {
    return resting(aligned(passed_at(states_->at(time), rigid_.loads(si<Time>(time)), time)));
  };
  if (planar::is_at_rest(motion, motion.states.front()))
    return balance_at(motion.begin - motion.period);
  const double h = step_of_rates(motion);
  return moving_with({balance_at(motion.begin).eta, balance_at(motion.begin + h).eta,
                      balance_at(motion.begin + 2.0 * h).eta},
                     h);
}

void ElasticMotion::solve_from_rest() {
  const planar::Motion& motion = *rigid_.motion;
  constexpr double instants_to_a_piece = 8.0;
  respond(borders_of(rigid_),
          instants_to_a_piece * motion.period / static_cast<double>(motion.states.size()));
  if (!planar::is_at_rest(motion, motion.end)) return;
  const double end = motion.begin + motion.period;
  const double watched = length_watched();
  // Constant, but for a vibrating axial force.
  respond({end, end + watched}, axial_ ? 0.5 / lowest_ : watched);
}

/// How long the free vibration behind the end is looked at.
double ElasticMotion::length_watched() const {
  constexpr double least_periods = 1.5, periods_undamped = 3.0, gone = 0.05;
  const planar::Motion& motion = *rigid_.motion;
  const double end = motion.begin + motion.period;
  const Moment rest = moment_at(end + motion.period);
  const Eigen::MatrixXd& turn = rest.aligned.turn;
  const PostureModes& modes = rest.aligned.modes;
  const std::vector<ComparedPlace> places = compared_places_of(*rigid_.beam);
  const auto k = static_cast<Eigen::Index>(count_);
  Eigen::VectorXd stress(k), largest = Eigen::VectorXd::Zero(k);
  for (Eigen::Index j = 0; j < k; ++j) {
    stress[j] =
        fibre_stresses(modes.diagrams[static_cast<std::size_t>(j)], places).abs().maxCoeff();
  }
  for (const ModalState& state : transient_->states())
    largest = largest.cwiseMax((turn * state.eta).cwiseAbs());
  const double level = gone * stress.cwiseProduct(largest).maxCoeff();
  const ModalState& last = transient_->states().back();
  const Eigen::VectorXd beside = turn * last.eta - rest.statically, speed = turn * last.speed;
  double dies_out = 0.0;
  for (Eigen::Index j = 0; j < k; ++j) {
    const double omega = full_turn * modes.frequencies[static_cast<std::size_t>(j)];
    const double amplitude = stress[j] * std::hypot(beside[j], speed[j] / omega);
    if (amplitude <= level) continue;
    const double decay = 0.5 * modes.damping(j, j);
    dies_out = std::max(dies_out, decay > 0.0 ? std::log(amplitude / level) / decay : 1e300);
  }
  const double period = 1.0 / modes.frequencies.front();
  // As many steps to a second as the motion has, or else as the fastest mode wants.
  const double resolved = static_cast<double>(motion.states.size()) / motion.period;
  const double least = instants_to_a_period * fastest_;
  const auto most_at = [&](double rate) {
    constexpr double rounding = 0.999;
    return rounding * most_vibrating_instants / rate - motion.period;
  };
  double most = most_at(std::max(resolved, least));
  if (most < periods_undamped * period) most = most_at(least);
  if (dies_out > most) dies_out = std::max(periods_undamped * period, std::min(dies_out, most));
  if (modes.damping(0, 0) <= 0.0) dies_out = std::min(dies_out, periods_undamped * period);
  return std::max(least_periods * period, dies_out);
}

LoadSpan ElasticMotion::span_of(const LoadSpan& rigid) const {
  if (!transient_) return rigid;
  LoadSpan span = rigid;
  const Time until = si<Time>(transient_->times().back());
  span.period = until - span.begin;
  const double share = (span.period / rigid.period).value();
  if (share > 1.0) span.breaks.push_back(rigid.begin + rigid.period);
  const double least = instants_to_a_period * fastest_ * span.period.value();
  if (least > most_vibrating_instants) {
    refuse_vibration(fmt::format(
        "the {:.4g} s looked at hold {:.0f} periods of its mode at {:.4g} Hz, more than {:.0f} "
        "instants resolve; look at a shorter time, or use --model rigid to have the loads of rigid "
        "bodies",
        span.period.value(), fastest_ * span.period.value(), fastest_, most_vibrating_instants));
  }
  const double wanted = std::max(static_cast<double>(rigid.instants) * share, least);
  span.instants = static_cast<std::size_t>(std::ceil(std::min(wanted, most_vibrating_instants)));
  return span;
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
    const ModalState state = transient_->at(time.value());
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
