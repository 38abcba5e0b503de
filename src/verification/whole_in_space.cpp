#include "whole_in_space.hpp"

#include <algorithm>
#include <utility>

#include "bent_in_space.hpp"
#include "boxbeam/verification/front_end.hpp"

namespace boxbeam {

bool held_by_whole(const Project& project, const BeamHolds& alone) {
  return project.in_space && !alone.along_z.said && !alone.along_y.said;
}

std::optional<double> part_of_whole(const SituationRun& run, Time time,
                                    const CutForceDiagram& diagram, double factor, double least) {
  const double most = factor / least;
  const auto critical = run.motion->critical_factor_at(time, diagram, most);
  if (!critical) return {};
  if (*critical >= most) return 0.0;
  return factor / *critical;
}

BentWhole bent_whole(const SituationRun& run, Time time, const CutForceDiagram& diagram,
                     double factor) {
  BentWhole of;
  auto design = bent_scene_in(run, time, diagram, factor);
  if (!design) return of;
  of.known = true;
  if (design->critical) {
    of.part = std::max(1.0, factor / *design->critical);
    return of;
  }
  of.turn = factor * design->turn;
  of.design = std::move(design->loads);
  if (factor != 1.0)
    if (auto once = bent_scene_in(run, time, diagram, 1.0)) of.once = std::move(once->loads);
  return of;
}

}  // namespace boxbeam
