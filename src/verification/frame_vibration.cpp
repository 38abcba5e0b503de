#include "frame_vibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "elastic_motion_in_space.hpp"
#include "strained_once.hpp"
#include "vibrating_frame.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using frame::Vector6;

constexpr std::size_t modes_of_frame = 6, instants_of_axial_force = 6;

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
  unload(vibrating);
  for (std::size_t j = 0; j < modes_.size(); ++j)
    add(vibrating, dynamic[static_cast<Index>(j)], modes_[j].loads);
  const double within = std::clamp(time.value(), begin_, begin_ + period_);
  BeamLoads loads = slowly_(once_ ? si<Time>(within) : time);
  add_bending(vibrating, loads);
  return loads;
}

}  // namespace boxbeam
