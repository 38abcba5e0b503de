#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/whole_life.hpp"
#include "boxbeam/verification/worst_place.hpp"

namespace boxbeam {

class StationMemory;

/// How the governing places were searched.
struct SearchSummary {
  std::size_t evaluations = 0;  ///< stations at which every criterion was judged
  std::size_t pieces = 0;       ///< between the cuts of the beam
  /// By how much the largest utilisation of a criterion may exceed what was found, relative.
  double tolerance = 0.0;
  WholeSummary whole = {};  ///< of long records
};

/// The stations to verify, and how they were found.
struct VerifiedStations {
  std::vector<Station> stations;
  SearchSummary search = {};
  /// What was found of their points, for the checks: at all cuts.
  std::map<std::pair<double, Side>, StationPoints> points = {};
};

/// All cuts of the beam, both sides where something differs on them (beam_cuts_of), and the places
/// between them where the utilisation of a criterion is largest.
///
/// Each piece between two cuts is searched for the largest utilisation of every criterion, at every
/// point of the section and along its walls, as largest_on_pieces does, to 1e-4 of the utilisation.
/// A piece is first divided so that no size of the section changes by more than half within a part,
/// and long pieces in two: nine places, more than the polynomials of the cut forces can hide from.
/// Utilisations are those of StationSamples; local maxima within 2 % of the largest are all given
/// back, so that the exact checks decide among them. What other designs under the same loads have
/// found of a station is taken from `memory`.
VerifiedStations search_stations(const Project& project, const std::deque<SituationRun>& runs,
                                 const std::vector<BendingZone>& zones,
                                 StationMemory* memory = nullptr);

}  // namespace boxbeam
