#include "modal_transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"

namespace boxbeam {
namespace {

/// Equations of k modes, and what is beside them, as one column.
Eigen::VectorXd packed_with(const ModalEquations& of, const Eigen::VectorXd& beside) {
  Eigen::VectorXd all(of.damping.size() + of.stiffness.size() + of.force.size() + beside.size());
  all << of.damping.reshaped(), of.stiffness.reshaped(), of.force, beside;
  return all;
}

Eigen::Index size_of_equations(Eigen::Index k) { return 2 * k * k + k; }

ModalEquations unpacked_from(const Eigen::VectorXd& all, Eigen::Index k) {
  return {all.head(k * k).reshaped(k, k), all.segment(k * k, k * k).reshaped(k, k), all.tail(k)};
}

}  // namespace

ModalTransient::ModalTransient(OpenMotion motion, const PassedOnce& passed)
    : motion_(std::move(motion)) {
  const double longest_piece = passed.instants_to_a_piece * motion_.step();
  std::vector<double> borders;
  auto change = passed.changes.begin();
  for (const double border : motion_.borders) {
    borders.push_back(border);
    if (change == passed.changes.end() || *change != border) continue;
    respond(passed, borders, longest_piece);
    response_->turn(passed.turned_at(border));
    turned_ = response_->states().size() - 1;
    borders = {border};
    ++change;
  }
  respond(passed, borders, longest_piece);
  if (!motion_.rests_behind) return;
  const double end = motion_.end(), watched = length_watched(passed.resting());
  respond(passed, {end, end + watched}, passed.vibrates_behind ? 0.5 / lowest_ : watched);
}

void ModalTransient::respond(const PassedOnce& passed, const std::vector<double>& borders,
                             double longest_piece) {
  Eigen::Index modes = 0;
  const auto ask = [&](double time) {
    const PassedPosture at = passed.posture_at(time);
    const Eigen::VectorXd& squares = at.posture.squares;
    modes = squares.size();
    lowest_ = std::min(lowest_, lowest_frequency_of(squares));
    fastest_ = std::max(fastest_, std::sqrt(squares[modes - 1]) / full_turn);
    return packed_with(aligned(at.posture), at.beside);
  };
  // Behind the end postures change no faster than modes do.
  const bool behind = borders.front() >= motion_.end();
  const double shortest = behind ? 0.5 / fastest_ : motion_.step();
  ChebyshevCurve made(
      ask, ChebyshevCurve::Division{borders, longest_piece, std::min(shortest, longest_piece)},
      passed.accuracy);
  const ChebyshevCurve& curve =
      passages_.emplace_back(Passage{borders.back(), std::move(made), modes}).curve;
  constexpr double steps_to_a_period = 20.0, steps_to_a_piece = 2.0;
  double longest_step = 1.0 / (steps_to_a_period * fastest_);
  if (!behind) longest_step = std::min(longest_step, curve.shortest_piece() / steps_to_a_piece);
  const auto equations = [&](double time) {
    return unpacked_from(curve.at(time, size_of_equations(modes)), modes);
  };
  if (response_) {
    response_->go_on(equations, borders, longest_step);
    return;
  }
  const auto balance_at = [&](double time) {
    return resting(aligned(passed.posture_at(time).posture)).eta;
  };
  response_.emplace(equations, borders, state_at_begin(motion_, balance_at), longest_step);
}

/// How long the free vibration behind the end is looked at.
double ModalTransient::length_watched(const RestingModes& rest) const {
  constexpr double least_periods = 1.5, periods_undamped = 3.0, gone = 0.05;
  const Eigen::MatrixXd& turn = rest.posture.turn;
  const Eigen::MatrixXd& damping = rest.posture.damping;
  const Eigen::VectorXd& stress = rest.stresses;
  const Eigen::Index modes = stress.size();
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(modes);
  const std::vector<ModalState>& states = response_->states();
  for (std::size_t i = turned_; i < states.size(); ++i)
    largest = largest.cwiseMax((turn * states[i].eta).cwiseAbs());
  const double level = gone * stress.cwiseProduct(largest).maxCoeff();
  const ModalState& last = states.back();
  const Eigen::VectorXd statically = rest.posture.force.cwiseQuotient(rest.posture.squares);
  const Eigen::VectorXd beside = turn * last.eta - statically, speed = turn * last.speed;
  double dies_out = 0.0;
  for (Eigen::Index j = 0; j < modes; ++j) {
    const double omega = full_turn * rest.frequencies[j];
    const double amplitude = stress[j] * std::hypot(beside[j], speed[j] / omega);
    if (amplitude <= level) continue;
    const double decay = 0.5 * damping(j, j);
    dies_out = std::max(dies_out, decay > 0.0 ? std::log(amplitude / level) / decay : 1e300);
  }
  const double period = 1.0 / rest.frequencies[0];
  // As many steps to a second as the motion has, or else as the fastest mode wants.
  const double resolved = static_cast<double>(motion_.instants) / motion_.length;
  const double least = instants_to_a_period * fastest_;
  const auto most_at = [&](double rate) {
    constexpr double rounding = 0.999;
    return rounding * most_vibrating_instants / rate - motion_.length;
  };
  double most = most_at(std::max(resolved, least));
  if (most < periods_undamped * period) most = most_at(least);
  if (dies_out > most) dies_out = std::max(periods_undamped * period, std::min(dies_out, most));
  if (damping(0, 0) <= 0.0) dies_out = std::min(dies_out, periods_undamped * period);
  return std::max(least_periods * period, dies_out);
}

Eigen::VectorXd ModalTransient::beside_at(double time) const {
  time = std::clamp(time, motion_.begin, response_->times().back());
  auto of = passages_.begin();
  // At a change what is behind it, at the end of the motion what is before it.
  while (of + 1 != passages_.end() &&
         (time > of->until || (time == of->until && time < motion_.end())))
    ++of;
  const Eigen::VectorXd all = of->curve.at(time);
  return all.tail(all.size() - size_of_equations(of->modes));
}

LoadSpan ModalTransient::span_of(const LoadSpan& rigid) const {
  LoadSpan span = rigid;
  const Time until = si<Time>(response_->times().back());
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

}  // namespace boxbeam
