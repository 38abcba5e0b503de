#pragma once

#include <vector>

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"

/// What is said of a case of several beams as a whole; each beam has a report of its own, in a
/// folder of its name.
namespace boxbeam {

/// The verdict of the worst beam, with what any of them leaves out.
VerdictText verdict_text_of(const std::vector<VerifiedBeam>& beams);

/// The verdict, the beams worst first, and of each its worst checks with its figure of the
/// mechanism.
report::Document overview_of(const std::vector<VerifiedBeam>& beams);

/// The same in a screenful: of the beam that decides, all that `summary` says.
report::MarkedText summary(const std::vector<VerifiedBeam>& beams);

/// In a line.
report::MarkedText verdict_line(const std::vector<VerifiedBeam>& beams);

}  // namespace boxbeam
