#include "followed_modes.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <utility>

#include "modal_motion.hpp"

namespace boxbeam {
namespace {

/// So many modes that none is parted from those of nearly its frequency.
std::size_t whole_groups(const std::vector<frame::BeamMode>& modes, std::size_t asked) {
  constexpr double alike = 0.02;
  std::size_t count = std::min(asked, modes.size());
  while (count < modes.size() &&
         modes[count].frequency < (1.0 + alike) * modes[count - 1].frequency)
    ++count;
  return count;
}

}  // namespace

FollowedModes::FollowedModes(StoppedVibration& stopped, StateAt state_at, CutsIn cuts_in,
                             std::size_t modes, bool statically)
    : stopped_(&stopped),
      state_at_(std::move(state_at)),
      cuts_in_(std::move(cuts_in)),
      modes_(modes),
      statically_(statically) {}

ModesOfPosture FollowedModes::begin_at(double time) {
  /// Modes beyond those asked for, one of which may be alike.
  constexpr std::size_t more = 3;
  const std::size_t asked = stopped_->freedoms() + modes_;
  ModesOfPosture first = shapes_at(time, asked + more);
  count_ = whole_groups(first.modes, asked);
  if (count_ == 0) refuse_vibration("without mass nothing vibrates; use --model rigid", time);
  first.modes.resize(count_);
  reference_ = first.shapes.leftCols(static_cast<Eigen::Index>(count_));
  return first;
}

ModesInMotion FollowedModes::at(double time) {
  const spatial::State state = state_at_(time);
  ModesInMotion at = stopped_->modes_in_motion(state, cuts_in_(state), count_, statically_);
  require_all(at.modes.size(), time);
  return at;
}

ModesOfPosture FollowedModes::shapes_at(double time, std::size_t count) {
  const spatial::State state = state_at_(time);
  return stopped_->modes_with_shapes(state, cuts_in_(state), count);
}

ModesOfPosture FollowedModes::still_at(double time) {
  ModesOfPosture at = shapes_at(time, count_);
  require_all(at.modes.size(), time);
  return at;
}

void FollowedModes::require_all(std::size_t found, double time) const {
  if (found >= count_) return;
  refuse_vibration(
      fmt::format("the beam has {} modes here and {} at the begin of its motion; use --model "
                  "rigid to have the loads of rigid bodies all the same",
                  found, count_),
      time);
}

Eigen::MatrixXd FollowedModes::turn_of(const Eigen::MatrixXd& shapes, double time) const {
  return turn_between(shapes, reference_, time);
}

std::vector<double> FollowedModes::changes_over(
    OpenMotion& motion, double instants,
    const std::function<std::vector<bool>(double time)>& acting_at) {
  constexpr double well_recognised = 0.97;
  std::vector<double> changes = changes_between(motion.borders, acting_at), more;
  double begun = motion.begin, last = begun;
  begin_at(begun);
  for (std::size_t i = 1; i < motion.borders.size(); ++i) {
    const double from = motion.borders[i - 1], length = motion.borders[i] - from;
    if (std::find(changes.begin(), changes.end(), from) != changes.end()) {
      begun = last = from;
      begin_at(from + 1e-6 * length);
    }
    const int parts = std::max(1, static_cast<int>(length / (instants * motion.step())));
    for (int part = 0; part < parts; ++part) {
      const double time = from + length * (part + 0.5) / parts;
      const Eigen::JacobiSVD<Eigen::MatrixXd> same(still_at(time).shapes.transpose() * reference_);
      if (same.singularValues().minCoeff() < well_recognised && last > begun) {
        more.push_back(last);
        begun = last;
        begin_at(last);
      }
      last = time;
    }
  }
  for (std::vector<double>* const all : {&changes, &motion.borders}) {
    all->insert(all->end(), more.begin(), more.end());
    std::sort(all->begin(), all->end());
  }
  return changes;
}

Eigen::MatrixXd FollowedModes::turned_at(const OpenMotion& motion, double border) {
  // So near that nothing has moved, and so far that only round-off is nearer.
  const auto found = std::lower_bound(motion.borders.begin(), motion.borders.end(), border);
  const double beside = 1e-6 * std::min(border - *(found - 1), *(found + 1) - border);
  const ModesOfPosture ahead = still_at(border - beside);
  const Eigen::MatrixXd turn = turn_of(ahead.shapes, border);
  const ModesOfPosture from_here = begin_at(border + beside);
  const frame::VibratingScene& scene = from_here.scene.scene();
  return frame::masses_between(scene, from_here.modes, ahead.modes) * turn;
}

}  // namespace boxbeam
