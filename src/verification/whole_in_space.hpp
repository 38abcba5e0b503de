#pragma once

#include <optional>

#include "beam_holds.hpp"
#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/situation_run.hpp"

/// The mechanism in space that carries a beam, as one: its beams hold each other.
namespace boxbeam {

/// Whether it is all that holds the beam: what a case says to hold it besides is in no mechanism.
bool held_by_whole(const Project& project, const BeamHolds& alone);

/// N/N_cr of the whole under so many times its loads at an instant; zero of less than `least`,
/// nothing where it is not known.
std::optional<double> part_of_whole(const SituationRun& run, Time time,
                                    const CutForceDiagram& diagram, double factor, double least);

/// The beam in the whole, bent by its design loads and by its loads times one.
struct BentWhole {
  bool known = false;
  double part = 0.0;       ///< of the loads that buckle it, where that is one or more
  double turn = 0.0;       ///< of a section, by the design loads [rad]
  BeamLoads design, once;  ///< what bending adds; once: empty where both are the same
};

BentWhole bent_whole(const SituationRun& run, Time time, const CutForceDiagram& diagram,
                     double factor);

}  // namespace boxbeam
