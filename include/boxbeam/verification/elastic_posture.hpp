#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/verification/posture.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A deformed mechanism of elastic links, its displacements drawn so many times as large.
struct DeformedPosture {
  const flexible::Structure* structure = nullptr;
  flexible::Deformation<double> deformation;
  double magnified = 1.0;
};

/// 1, 2 or 5 times a power of ten: draws the largest displacement as long as a part of the
/// mechanism, and 1 where nothing moves.
double magnification_of(const flexible::Structure& structure, double largest_displacement,
                        double part);

/// The largest displacement of any node [m]; of a vibration what it can be at most.
double largest_displacement(const flexible::LinkColumns<double>& motion);
double largest_displacement(const flexible::Response& response);

/// Links, their joints and bearings, without loads. The time is left to the caller.
PostureFigure posture_figure(const Project& project, const DeformedPosture& posture,
                             const std::string& why);

/// What joints and loads do to the beam that is a link.
std::vector<BeamLoadRow> load_rows(const Project& project, const DeformedPosture& posture,
                                   const BeamLoads& loads);

}  // namespace boxbeam
