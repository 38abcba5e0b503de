#pragma once

#include <array>
#include <span>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Smallest and largest value over all situations, with their instants.
struct Envelope {
  Extreme smallest, largest;
};

/// A cut force that a case looks at, and what it is called there.
struct CutForceName {
  cut_force::Index which;
  const char* name;

  bool is_moment() const { return which >= cut_force::T; }
  bool bends() const { return which == cut_force::M_y || which == cut_force::M_z; }
};

/// N, V and M (V_z and M_y) in the plane, all six in space.
std::span<const CutForceName> cut_forces_looked_at(const Project& project);

/// Extremes of the cut forces at a station [N, N m], by cut_force::Index; zero where not looked at.
struct StationEnvelope {
  Station station;
  std::array<Envelope, cut_force::count> of;
};

/// The extremes of a station's cut forces; where nothing is looked at, zero.
StationEnvelope envelope_at(const Project& project, const Station& station,
                            const std::vector<SituationHistory>& histories);

}  // namespace boxbeam
