#pragma once

#include <Eigen/Core>

#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam::flexible {

/// Loads on the beam that is a link after the harmonic loads are switched on: joints, loads,
/// weight, and the inertia of the modes, in balance to round-off. Those of each mode are found
/// once; at a time they are added up. Precondition: `modes` are of this structure, which stays; the
/// link's axis is that of the beam.
class StartLoads {
 public:
  StartLoads(const Structure& structure, int link, const TaperedBeam& beam, SuddenStartModes modes);

  BeamLoads at(double time) const;

 private:
  SuddenStartModes modes_;
  BeamResponse driven_;  ///< without vibration; `sine` and `cosine` of the drive's angle
  /// Numbers of the loads in the plane, which are added to those of the drive, a column each.
  Eigen::MatrixXd of_modes_;  ///< with x_j = 1
  Eigen::MatrixXd of_speeds_;
};

}  // namespace boxbeam::flexible
