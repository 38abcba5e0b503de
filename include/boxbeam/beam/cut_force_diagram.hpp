#pragma once

#include <cstddef>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/section/cut_forces.hpp"

namespace boxbeam {

/// Cut forces between two places where nothing jumps, as polynomials of the distance from
/// `start`: exact integrals of the line loads.
struct CutForcePiece {
  Length start;
  Length length;
  Polynomial<4> N, V_y, V_z;
  Polynomial<5> T, M_y, M_z;

  Length end() const { return start + length; }
};

/// Cut forces along the whole beam at one instant.
///
/// Integrated from the start of the beam; what acts on [0, s] is balanced by the cut:
///
///     dN/ds = -q_x,  dV_z/ds = -q_z,  dM_y/ds = V_z - m_y,
///     dV_y/ds = -q_y,  dM_z/ds = -V_y - m_z,  dT/ds = -m_x
struct CutForceDiagram {
  std::vector<CutForcePiece> pieces;

  /// Cut forces at a station; at a jump, on its side (`both` means behind). Zero outside the beam:
  /// before s = 0 and behind its end nothing is cut.
  CutForces at(const Station& station) const;
  /// The same for who asks diagram after diagram: `piece`, in which it lies in the diagram before,
  /// mostly is that in this one.
  CutForces at(const Station& station, std::size_t& piece) const;
};

/// Integrates the loads. Point loads may stand in any order; their places and the ends of the line
/// loads become the borders of the pieces.
CutForceDiagram cut_forces_of(const BeamLoads& loads);

}  // namespace boxbeam
