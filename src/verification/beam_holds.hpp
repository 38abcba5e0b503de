#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A plane of bending of the beam's own axes.
enum class Plane { z, y };

/// A place where a beam by itself is held in a plane: pinned, or clamped.
struct Hold {
  double s = 0.0;  ///< [m]
  bool clamped = false;

  friend bool operator==(const Hold& a, const Hold& b) {
    return a.s == b.s && a.clamped == b.clamped;
  }
};

/// How a beam by itself is held in one way.
template <class Places>
struct HeldAt {
  Places at;
  std::string words;  ///< "pinned at s = 0 m and 3 m, as the case says"
  bool said = false;  ///< by the case; else taken from what carries the beam
};

/// How a beam by itself is held against buckling. What the case does not say: pins at the two
/// outermost places where what carries it takes hold of it, a clamp where there is but one.
struct BeamHolds {
  HeldAt<std::vector<Hold>> along_z, along_y;
  HeldAt<std::vector<double>> turning;  ///< against turning about its axis
};

BeamHolds holds_of(const Project& project, const std::vector<double>& supports);

/// The beam on the ground, as a link that bends in a plane.
flexible::Mechanism beam_alone(const Project& project, Plane plane, const std::vector<Hold>& holds);

}  // namespace boxbeam
