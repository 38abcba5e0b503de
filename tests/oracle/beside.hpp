#pragma once

#include <deque>
#include <set>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "oracle.hpp"

/// What the oracle finds beside stresses.
namespace oracle {

using boxbeam::CutForceDiagram;
using boxbeam::Project;
using boxbeam::SituationRun;
using boxbeam::Time;

/// The cut forces along the beam at instants of a situation.
struct Run {
  std::size_t situation = 0;
  double load_factor = 1.0;
  bool closed = true;
  std::vector<Time> times;
  std::vector<CutForceDiagram> diagrams;
};

std::vector<Run> sample(const Project& project, const std::deque<SituationRun>& runs, int instants);

/// By integrating curvature and shear along the beam, theta' = -kappa and w' = theta + gamma,
/// from the line that the case measures from.
void look_at_deflection(const Project& project, const std::vector<Run>& sampled,
                        std::set<double> borders, int stations, Findings& found);

}  // namespace oracle
