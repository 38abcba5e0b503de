#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/flexible_motion_result.hpp"
#include "boxbeam/verification/posture.hpp"
#include "boxbeam/verification/situation_run.hpp"

/// What the report shows of elastic links beside the beam, as numbers.
namespace boxbeam {

/// A quantity of every joint over an abscissa.
struct JointLines {
  std::vector<double> at;  ///< frequencies [Hz] or times [s]
  std::vector<std::string> names;
  std::vector<std::vector<double>> force;  ///< of each joint: length of its force [N]
};

struct ElasticFigures {
  FlexibleMotionResult motion;       ///< with its errors of division
  PostureFigure rest;                ///< without load
  std::vector<PostureFigure> modes;  ///< the lowest; `why` is the frequency
  JointLines over_frequency;         ///< largest over a period of what vibrates
  JointLines over_period;            ///< static and vibrating
  JointLines after_start;            ///< the loads switched on at t = 0
};

/// Of the first situation, by all elements: as many parts of every link as the case says or the
/// model has, whichever is more, with the model's kind of element and elasticity along the axes.
/// So links that the chosen model takes as rigid, or by few modes, still have their frequencies.
/// Throws AnalysisError.
ElasticFigures elastic_figures_of(const Project& project, const SituationRun& run,
                                  const ElasticModel& model);

}  // namespace boxbeam
