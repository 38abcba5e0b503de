#pragma once

#include <optional>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// What a case says of the welds of what is attached to its beam; nothing: by the rows of the
/// tables.
struct AttachmentDetails {
  std::optional<Detail> diaphragms, flats, flat_ends;
};

/// The welds of a beam's diaphragms and flats.
///
///     diaphragms  row 8.4/8, beside single walls 8.4/7, by the length between the toes of fillets
///                 with legs as long as the plate is thick: 80 up to 50 mm, 71 up to 80 mm, and
///                 beyond, where the rows end and legs are shorter
///     flats       row 8.2/5, continuous fillets by hand: 100; where a flat ends within the beam
///                 row 8.4/1 by its length: 56 beyond 100 mm
///
/// A flat goes on in the next segment where one stands within its thickness on the same plate.
/// Those that the case says nothing of are assumed, and have the beam's own k_f.
/// Source: EN 1993-1-9:2005+AC:2009, tables 8.2 and 8.4.
std::vector<AttachmentWeld> attachment_welds_of(const TaperedBeam& beam, const BeamDetail& of_beam,
                                                const AttachmentDetails& given);

/// Of 2e6 cycles over the detail's stress factor [Pa], as the search for the weakest detail of a
/// place compares them.
double comparable_strength_of(const BeamDetail& of);

/// Whether a detail endures no more than another one at any number of cycles, over their stress
/// factors, of a spectrum and of one range: whatever the other one refuses, it refuses. Of curves
/// of one shape their references decide, of others each kink of both.
bool is_nowhere_stronger(const BeamDetail& of, const BeamDetail& other);

/// Whether a weld may be used more than what the case itself has there: no detail of it that
/// surely holds at the place is as weak.
bool may_govern(const FatigueInput& fatigue, const AttachmentWeld& weld);

}  // namespace boxbeam
