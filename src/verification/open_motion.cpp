#include "open_motion.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/rest.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "frame_time.hpp"
#include "front_ends.hpp"

namespace boxbeam {
namespace {

std::vector<double> borders_with(double begin, double length, const std::vector<double>& breaks) {
  constexpr double same = 1e-9;
  const double end = begin + length;
  std::vector<double> borders{begin};
  for (const double at : breaks) {
    if (at > borders.back() + same * length && at < end - same * length) borders.push_back(at);
  }
  borders.push_back(end);
  return borders;
}

}  // namespace

OpenMotion open_motion_of(const planar::Mechanism& mechanism, const planar::Motion& motion) {
  std::vector<double> breaks;
  for (const Break& at :
       breaks_of(planar::functions_of(mechanism), motion.begin, motion.begin + motion.period))
    breaks.push_back(at.at);
  breaks.insert(breaks.end(), motion.changes.begin(), motion.changes.end());
  for (const SlipChange& of : motion.slip_changes) breaks.push_back(of.time);
  std::sort(breaks.begin(), breaks.end());
  // What forces move begins to move at once, and nothing holds it at its end.
  const bool held = motion.freedom.undriven == 0;
  return {motion.begin,
          motion.period,
          motion.states.size(),
          borders_with(motion.begin, motion.period, breaks),
          held && planar::is_at_rest(motion, motion.states.front()),
          held && planar::is_at_rest(motion, motion.end)};
}

std::vector<double> changes_between(
    const std::vector<double>& borders,
    const std::function<std::vector<bool>(double time)>& acting_at) {
  std::vector<double> changes;
  std::vector<bool> acting;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    if (!(borders[i] > borders[i - 1])) continue;
    std::vector<bool> here = acting_at(0.5 * (borders[i - 1] + borders[i]));
    if (!acting.empty() && here != acting) changes.push_back(borders[i - 1]);
    acting = std::move(here);
  }
  return changes;
}

void add_borders_between(const std::function<std::vector<bool>(double time)>& acting_at,
                         double longest, std::vector<double>& borders) {
  constexpr double fewest = 8.0;
  constexpr int halvings = 40;
  std::vector<double> more;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    const double from = borders[i - 1], length = borders[i] - from;
    const double looks = std::max(fewest, std::ceil(length / longest));
    double before = from + 0.5 * length / looks;
    std::vector<bool> known = acting_at(before);
    for (double look = 1.0; look < looks; ++look) {
      const double behind = from + (look + 0.5) * length / looks;
      std::vector<bool> acting = acting_at(behind);
      if (acting != known) {
        double low = before, high = behind;
        for (int half = 0; half < halvings; ++half) {
          const double middle = 0.5 * (low + high);
          (acting_at(middle) == known ? low : high) = middle;
        }
        more.push_back(high);
      }
      before = behind;
      known = std::move(acting);
    }
  }
  borders.insert(borders.end(), more.begin(), more.end());
  std::sort(borders.begin(), borders.end());
}

OpenMotion open_motion_of(const spatial::Chain& chain, const LoadSpan& span) {
  const double begin = span.begin.value(), length = span.period.value();
  // What forces move begins to move at once, and nothing holds it at its end.
  const spatial::EndsAtRest rests =
      chain.forced() != nullptr
          ? spatial::EndsAtRest{}
          : spatial::ends_at_rest_of(chain, {begin, length, false, span.instants});
  std::vector<double> breaks;
  for (const Time& at : span.breaks) breaks.push_back(at.value());
  return {begin,       length,   span.instants, borders_with(begin, length, breaks),
          rests.begin, rests.end};
}

std::optional<OpenMotion> open_motion_of(const Project& project, const SituationRun& run) {
  if (run.loads.closed()) return std::nullopt;
  if (std::holds_alternative<planar::Mechanism>(project.mechanism))
    return open_motion_of(planar_in(project, *run.situation), planar_motion_of(run));
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism))
    return open_motion_of(chain_of(run), span_of_motion_in_space(run));
  if (std::holds_alternative<frame::Structure>(project.mechanism)) {
    // A frame stands in balance where its loads begin.
    const auto time = time_of_loads(frame_in(project, *run.situation));
    if (time && !time->closed)
      return OpenMotion{time->begin,
                        time->length,
                        run.loads.span().instants,
                        borders_with(time->begin, time->length, {}),
                        true,
                        true};
  }
  return std::nullopt;
}

ModalState state_at_begin(const OpenMotion& motion,
                          const std::function<Eigen::VectorXd(double time)>& balance_at) {
  if (motion.rests_before) {
    Eigen::VectorXd balance = balance_at(motion.before());
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(balance.size());
    return {std::move(balance), std::move(rate)};
  }
  // Small beside all that happens in a motion.
  constexpr double part = 1.0 / 64.0;
  const double h = part * motion.step();
  return moving_with(
      {balance_at(motion.begin), balance_at(motion.begin + h), balance_at(motion.begin + 2.0 * h)},
      h);
}

}  // namespace boxbeam
