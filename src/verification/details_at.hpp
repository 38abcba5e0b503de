#pragma once

#include <vector>

#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam {

/// Whether a detail holds at a place, and whether it does just inside a station's side.
bool lies_in(const BeamDetail& stretch, Length s);
bool goes_on(const BeamDetail& stretch, const Station& station);

/// Where in a section a place is, for details: walls of paths are fibres, and webs or seams
/// besides.
struct PlaceOfDetails {
  DetailPlace on = DetailPlace::section;
  bool fibre_too = false;

  friend bool operator==(const PlaceOfDetails&, const PlaceOfDetails&) = default;
};

/// All details that may decide at a place, as `detail_at` finds them: first the one of the least
/// strength at 2e6 cycles, behind it those that are weaker than each before them at some number of
/// cycles, as one of slope 5 at few. Each is to be judged.
std::vector<ResistingDetail> details_at(const FatigueInput& fatigue, const Station& station,
                                        const PlaceOfDetails& place, Length plate,
                                        const BeamDetail* flat = nullptr);

}  // namespace boxbeam
