#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam::charts {

/// The runs of a case: rigid bodies, elastic links with all their elements.
std::deque<SituationRun> bending_runs_of(const Project& project);

/// The place and the instant at which a beam is bent most, among the instants that were solved.
struct DemandingInstant {
  const SituationRun* run = nullptr;
  cut_force::Index moment = cut_force::M_y;  ///< M_y or M_z
  Time time;
  Station station;
  double M = 0.0;  ///< there [N m]
};

/// Nothing where nothing bends the beam.
std::optional<DemandingInstant> demanding_instant_of(const std::deque<SituationRun>& runs);

/// Bending in one plane as a problem of scalars:
///
///     V' = -q,  M' = V - m,  at a point load V jumps by -P and M by -C
///
/// About y: V = V_z; about z: V = -V_y. SI.
struct Bending {
  /// A piece between two places where something jumps: load and couple per length as polynomials of
  /// the distance from `origin`, at or before its start.
  struct Piece {
    double start = 0.0, length = 0.0, origin = 0.0;
    Polynomial<3> q;
    Polynomial<4> m;
    double P = 0.0, C = 0.0;  ///< point loads at its start

    double end() const { return start + length; }
  };
  std::vector<Piece> pieces;

  double length() const { return pieces.back().end(); }
};

Bending bending_of(const BeamLoads& loads, cut_force::Index moment);

/// The moment just before a place, as that of everything before it, in long double:
///
///     M(s) = -sum (C_i + P_i (s - s_i)) - int_0^s ((s - x) q + m) dx
///
/// By Gauss' rule of eight points in each piece: exact for these loads.
long double moment_before(const Bending& bending, double s);

}  // namespace boxbeam::charts
