#include "loaded_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace boxbeam {
namespace {

/// Adds loads at the same places; what one joint does there in both is one load.
BeamLoads sum_of(const BeamLoads& standing, const BeamLoads& moving) {
  BeamLoads sum = standing;
  for (const PointLoad& load : moving.points) {
    const auto same = std::find_if(sum.points.begin(), sum.points.end(), [&](const auto& other) {
      return other.name == load.name && other.s == load.s;
    });
    if (same == sum.points.end()) {
      sum.points.push_back(load);
    } else {
      same->force += load.force;
      same->moment += load.moment;
    }
  }
  return sum;
}

/// Of the axial forces at instants, tension positive, those that none of the others exceeds in
/// compression in every piece, a thousandth of what the piece ever bears aside: more compression
/// anywhere never makes a frame stiffer, so that the least critical factor is among them.
std::vector<std::vector<double>> most_compressed_of(std::vector<std::vector<double>> all) {
  std::vector<double> slack(all.front().size());
  for (const std::vector<double>& forces : all) {
    for (std::size_t p = 0; p < slack.size(); ++p)
      slack[p] = std::max(slack[p], 1e-3 * std::abs(forces[p]));
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::accumulate(a.begin(), a.end(), 0.0) < std::accumulate(b.begin(), b.end(), 0.0);
  });
  std::vector<std::vector<double>> kept;
  for (std::vector<double>& forces : all) {
    const bool exceeded =
        std::any_of(kept.begin(), kept.end(), [&](const std::vector<double>& other) {
          for (std::size_t p = 0; p < slack.size(); ++p) {
            if (other[p] > forces[p] + slack[p]) return false;
          }
          return true;
        });
    if (!exceeded) kept.push_back(std::move(forces));
  }
  return kept;
}

}  // namespace

LoadedFrame::LoadedFrame(const frame::Structure& of) : structure(of), statics_(structure) {
  const std::optional<TimeSpan> time = time_of_loads(structure);
  changes_ = time.has_value();
  time_ = time.value_or(TimeSpan{});
  // Loads name their actions, which must stay.
  lasting_ = acting_part_of(structure, false);
  moving_ = acting_part_of(structure, true);
  standing_ = statics_.solve(acting_at(lasting_, 0.0));
}

frame::ActingLoads LoadedFrame::acting_moved(double time) const {
  if (!time_.closed) time = std::clamp(time, time_.begin, time_.begin + time_.length);
  return acting_at(moving_, time);
}

BeamLoads LoadedFrame::loads_at(int beam, double time) const {
  const auto member = static_cast<std::size_t>(beam);
  if (!changes_) return standing_.members[member].loads;
  return sum_of(standing_.members[member].loads,
                statics_.balance(acting_moved(time)).members[member].loads);
}

frame::Vector6 LoadedFrame::start_at(int beam, double time) const {
  frame::Vector6 of = statics_.motion_at(beam, 0.0, standing_);
  if (changes_) of += statics_.motion_at(beam, 0.0, statics_.solve(acting_moved(time)));
  const Eigen::Matrix3d& axes = structure.members[static_cast<std::size_t>(beam)].axes;
  of << axes.transpose() * of.head<3>().eval(), axes.transpose() * of.tail<3>().eval();
  return of;
}

double LoadedFrame::Pressed::critical_factor(double most) const {
  for (const std::vector<double>& of : forces)
    most = std::min(most, finer.critical_factor(of, most));
  return most;
}

std::unique_ptr<const LoadedFrame::Pressed> LoadedFrame::pressed_by(
    const LoadHistory& loads) const {
  auto pressed = std::make_unique<Pressed>(structure);
  const std::vector<double> standing = pressed->finer.axial_forces(standing_);
  pressed->forces = {standing};
  if (!changes_) return pressed;
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    all.push_back(
        pressed->finer.axial_forces(statics_.solve(acting_moved(loads.time_of(i).value()))));
    for (std::size_t p = 0; p < standing.size(); ++p) all.back()[p] += standing[p];
  }
  pressed->forces = most_compressed_of(std::move(all));
  return pressed;
}

double LoadedFrame::heat_curvature(int beam) const {
  return standing_.members[static_cast<std::size_t>(beam)].heat[4];
}

std::vector<frame::Vector6> LoadedFrame::reactions_at(double time) const {
  std::vector<frame::Vector6> forces = standing_.joints;
  if (!changes_) return forces;
  const frame::Equilibrium moving = statics_.balance(acting_moved(time));
  for (std::size_t k = 0; k < forces.size(); ++k) forces[k] += moving.joints[k];
  return forces;
}

}  // namespace boxbeam
