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

/// All details that may decide at a place: first the weakest at 2e6 cycles of the stretches that a
/// station lies in, or of the whole beam, each with the strength that it has in a plate of this
/// thickness, behind it those that are weaker than each before them at some number of cycles, as
/// one of slope 5 at few. Each is to be judged. The end of a stretch belongs to it on both sides,
/// and on the side where none goes on, that of the whole beam counts as well. Beside them the weld
/// of a diaphragm that stands there, and that of a flat at the place, if any. Compression counts
/// 60 % only where none of them is welded as it is.
std::vector<ResistingDetail> details_at(const FatigueInput& fatigue, const Station& station,
                                        const PlaceOfDetails& place, Length plate,
                                        const BeamDetail* flat = nullptr);

}  // namespace boxbeam
