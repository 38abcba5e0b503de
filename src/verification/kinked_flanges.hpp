#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A force of a plate [N], per cut force.
using PlateForce = std::array<double, cut_force::count>;

/// A plate of a box or of a thin-walled path that turns off between two segments.
struct TurnedPlate {
  Length clear, thickness;  ///< the thinner one of both sides
  Stress yield_strength;    ///< the lower one
  bool outstand = false;    ///< held along one edge
  double between = 1.0;     ///< what of its force stands on none of the plates beside it
  Length place;             ///< of its middle, across the force
  /// Its force along the beam, by the stress of its middle on the gross section of the side before
  /// the border and of the one behind, times the turn: what it puts into the plates beside it.
  /// Source: equilibrium.
  std::array<PlateForce, 2> turned{};
};

/// Plates that turn off together, and so push into the plates beside them, or pull at them: a
/// flange of a box, or of a path all plates of it that hang together.
struct FlangeKink {
  Length s;
  std::string name;      ///< "the kink of the top flange", "the kink of wall 1 and wall 2"
  bool along_z = true;   ///< the force; else it is along y
  bool at_high = false;  ///< at the end of the section that is high along it
  bool knee = false;     ///< where two beams meet
  std::vector<TurnedPlate> plates;

  /// What they put into the plates beside them, along the kink's axis, and its couple about the
  /// beam's axis, by the forces before the border and by those behind it. Where these differ,
  /// something comes in at the kink: as it does so along the one plate or the other, either is what
  /// turns off, and all that lies between is less.
  struct Turned {
    Force force;
    Moment couple;
  };
  std::array<Turned, 2> under(const CutForces& before, const CutForces& behind) const;
  /// What that is at most, of cut forces and moments of these sizes [N, N m].
  double most_under(double force, double moment) const;
  /// Over how much of the beam on either side others like it bend the same width across.
  Length width() const;
};

/// The kinks of a beam, where its outline goes on without a jump; and the flanges of a beam of a
/// frame where a joint holds it rigidly to another one, end to end, that goes on in another
/// direction: each turns off by 2 sin(delta/2).
std::vector<FlangeKink> flange_kinks_of(const Project& project);

/// A plate that ends where the next segment's lies elsewhere.
struct FlangeStep {
  Length s;
  std::string name;  ///< "top flange", "wall 3"
  bool web = false;  ///< it lies along the plane of bending: what it bears in shear ends, too
  Area area;
  Stress yield_strength;
  Force led;                          ///< of a web, what a diaphragm there leads on
  std::array<PlateForce, 3> along{};  ///< its force along the beam, and those of its halves
  PlateForce across{};                ///< its part of the shear
  std::optional<Length> by;           ///< nothing: there is none
};

/// Joints by which the beam's end goes on, straight or as a knee, in a member of a frame with a
/// section as deep and wide, neither turned about its axis against the other.
std::vector<std::string> judged_knees_of(const Project& project);

/// On both sides of each border of segments.
std::vector<FlangeStep> flange_steps_of(const Project& project);

/// The largest stress across the plates of a kink, over their strength.
///
/// Between two plates beside it as a strip on simple supports without end, under a force that is
/// spread evenly over its width:
///
///     m = (1 + nu) G F/pi^2,  G = 1 - 1/9 + 1/25 - ... = 0.916,  sigma = 6 m/t^2
///
/// t  thickness; F  what turns off of it, not of what stands on the plates beside it. Source:
/// Timoshenko, Woinowsky-Krieger, Theory of Plates and Shells, section 36, summed over the sine
/// waves of an even load. An outstand as a cantilever without end whose free edge bears all of
/// it (`bent_outside`).
double use_across_kink(const FlangeKink& kink, const CutForces& before, const CutForces& behind);

}  // namespace boxbeam
