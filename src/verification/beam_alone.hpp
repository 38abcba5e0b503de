#pragma once

#include <optional>
#include <vector>

#include "beam_holds.hpp"
#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/front_end.hpp"

/// The beam by itself, held as it may be, under what presses and bends it.
namespace boxbeam {

/// The loads of one plane as those of the plane of motion.
BeamLoads in_plane(BeamLoads loads, Plane plane);

/// The beam by itself in a plane, made anew only where it is held in another way.
class BeamAlone {
 public:
  BeamAlone(const Project& project, Plane plane) : project_(&project), plane_(plane) {}

  MakePosture under(const BeamLoads& loads, const std::vector<Hold>& holds);

 private:
  const Project* project_;
  Plane plane_;
  std::vector<Hold> holds_;
  std::optional<flexible::Mechanism> mechanism_;
};

/// N/N_cr, where it is above `known`, to 1e-5 of itself.
double part_of_critical(const MakePosture& make, double known);

/// Largest compression along the beam [N].
double compression_of(const CutForceDiagram& diagram);

/// N_cr of a cantilever as long as the beam, of its least second moment of area [N].
///
///     N_cr = (pi/(2 L))^2 E I
///
/// Source: Euler; Timoshenko, Gere, Theory of Elastic Stability (1961), section 2.1.
double cantilever_load_of(const Project& project);

/// Whether anything presses or pulls along the beam, by the size of what bends it.
bool bears_axial_force(const CutForceDiagram& diagram);

/// So many instants are looked at; of what second order hardly reaches, fewer are enough.
constexpr std::size_t instants_in_all = 48, few_instants = 12;

/// Instants spread over the time, and those of largest compression and bending. The most compressed
/// first: of the others it is then mostly enough to know that they are not nearer to buckling.
std::vector<std::size_t> instants_of(const LoadHistory& history,
                                     std::size_t spread = instants_in_all);

}  // namespace boxbeam
