#include "boxbeam/verification/front_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/elastic_figures.hpp"
#include "front_ends.hpp"

namespace boxbeam {

std::optional<ElasticFigures> FrontEnd::elastic_figures(const SituationRun&,
                                                        const ElasticModel&) const {
  return {};
}

std::unique_ptr<const FrontEnd> front_end_of(const Project& project) {
  return std::visit([&](const auto& mechanism) { return front_end_for(mechanism, project); },
                    project.mechanism);
}

AnyMotionResult any_motion_of(const Project& project, const std::vector<double>& times) {
  return front_end_of(project)->motion(times, "");
}

LoadsAt staying_on(const TaperedBeam& beam, LoadsAt loads) {
  std::vector<double> borders{0.0};
  for (const Segment& of : beam.segments) borders.push_back(of.end().value());
  return [borders = std::move(borders), loads = std::move(loads)](Time time) {
    BeamLoads at = loads(time);
    // Rounding of sums; what rolls over a border is looked at on both sides of it, farther away.
    const double length = borders.back(), near = 1e-9 * length, rounding = 1e-14 * length;
    for (PointLoad& load : at.points) {
      const double s = load.s.value();
      const auto border = std::lower_bound(borders.begin(), borders.end(), s - rounding);
      if (border != borders.end() && *border <= s + rounding) load.s = si<Length>(*border);
      if (s >= -near && s <= length + near) continue;
      throw AnalysisError(
          {fmt::format("a joint slides off the beam: it stands at s = {:.6g} m, and "
                       "the beam goes from 0 to {:.6g} m",
                       s, length),
           "beam", time.value()});
    }
    return at;
  };
}

void add_sample(DriverLine& line, double time, const DriverState& motion,
                std::optional<double> force) {
  line.times.push_back(time);
  line.position.push_back(motion.value);
  line.speed.push_back(motion.rate);
  line.acceleration.push_back(motion.acceleration);
  if (force) line.force.push_back(*force);
}

std::vector<Time> break_times_in(const std::vector<DriverUse>& functions, double begin,
                                 double length) {
  std::vector<Time> times;
  for (const Break& at : breaks_of(functions, begin, begin + length)) {
    times.push_back(si<Time>(at.at));
  }
  return times;
}

}  // namespace boxbeam
