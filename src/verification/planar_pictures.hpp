#pragma once

#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/front_end.hpp"

/// What is drawn of a planar mechanism.
namespace boxbeam {

/// The bodies, rods, guides and bearings in a state, with the loads on the beam.
PostureFigure posture_figure(const Project& project, const planar::Mechanism& mechanism,
                             const planar::State& state, const BeamLoads& loads,
                             const std::string& why);

/// What the joints and loads do to the beam, and where in that state.
std::vector<BeamLoadRow> load_rows(const Project& project, const BeamLoads& loads,
                                   const planar::State& state);

/// The drivers; where they leave a freedom to forces, also the points and angles that forces and
/// couples act on, or, where nothing of that kind acts, the coordinates of the first body that is
/// moved, without force. Where the Newton chain loads the beam, the drivers' forces are not known:
/// they are left out.
std::vector<DriverLine> driver_lines_of(const Project& project, const planar::Mechanism& mechanism,
                                        const planar::Motion& motion);

}  // namespace boxbeam
