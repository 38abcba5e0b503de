#pragma once

#include "boxbeam/project/project.hpp"
#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// A verification in a screenful: the verdict first, the worst check of every criterion, what
/// blocks the checks, and the first remarks.
report::MarkedText summary(const Project& project, const Verification& verification);

/// "FAIL  sledge-rig: fatigue/4.2/fibre+z, utilisation 165 %".
report::MarkedText verdict_line(const Project& project, const Verification& verification);

/// What a change of the case did: the verdict, and of every criterion the worst check where its
/// utilisation shows another number or it stands elsewhere.
report::MarkedText what_changed(const Verification& before, const Project& project,
                                const Verification& now);

}  // namespace boxbeam
