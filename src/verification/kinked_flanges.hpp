#pragma once

#include <string>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_box.hpp"

namespace boxbeam {

/// A plate of a box that turns off between two segments, and so pushes into the plates beside it,
/// or pulls at them.
struct FlangeKink {
  Length s;
  std::string name;  ///< "the kink of the top flange"
  bool along_z = true;
  double turn = 0.0;  ///< of its slope, behind less before
  /// Of the plate before it.
  Area area;
  Length clear, thickness;
  Stress yield_strength;
  StressInfluence middle;

  /// What it puts into the plates beside it, along its axis: the plate's force along the beam, by
  /// the stress of its middle on the gross section, times the turn. Source: equilibrium.
  Force force_under(const CutForces& cut) const;
};

/// The kinks of a beam's boxes, where their outline goes on without a jump.
std::vector<FlangeKink> flange_kinks_of(const Project& project);

/// A plate of a box that ends where the next segment's lies elsewhere, by more than it is thick.
struct FlangeStep {
  FlangeKink ends;  ///< whose turn is 1: its force is the plate's along the beam
  Length by;
};

/// In pairs, the plate before each border of segments and the one behind it.
std::vector<FlangeStep> flange_steps_of(const Project& project);

/// The largest stress across a plate between the two beside it under a force that is spread over
/// its width where it turns off, as a strip on simple supports without end.
///
///     m = (1 + nu) q b/(4 pi),  q = F/b,  sigma = 6 m/t^2
///
/// b, t  clear width and thickness. Source: Timoshenko, Woinowsky-Krieger, Theory of Plates and
/// Shells, section 36, the first term of the series.
Stress stress_across_kink(const FlangeKink& kink, Force force);

}  // namespace boxbeam
