#pragma once

namespace boxbeam::report {

/// How a row, a step or a verdict is to be marked.
enum class Mark { none, passes, fails, not_applicable };

/// "passes", "FAILS", "not applicable".
const char* to_text(Mark mark);

}  // namespace boxbeam::report
