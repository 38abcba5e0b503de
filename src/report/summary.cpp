#include "boxbeam/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/remarks.hpp"
#include "plain_text.hpp"
#include "report_parts.hpp"
#include "text_layout.hpp"
#include "text_table.hpp"

namespace boxbeam {
namespace {

/// A gate that blocks is always shown, of the rest the first few.
std::string remarks_summary(const Project& project, const Verification& verification) {
  constexpr std::size_t most = 3;
  std::string out;
  std::size_t others = 0;
  std::size_t hidden = 0;
  for (const std::string& remark : remarks_of(project, verification)) {
    if (remark.starts_with("assumed: ")) {
      ++hidden;
    } else if (remark.starts_with("not applicable: ") || others++ < most) {
      out += layout::item(remark);
    } else {
      ++hidden;
    }
  }
  if (hidden > 0) {
    out += layout::item(fmt::format("{} more remarks and assumptions stand in the report", hidden));
  }
  return out;
}

}  // namespace

std::string summary(const Project& project, const Verification& verification) {
  const report::Table governing = report::with_results(
      report::governing_table({project, verification, ReportLevel::summary, {}}));
  return fmt::format("{}  {}\n{}\nRemarks:\n{}", report::verdict_text(verification.verdict),
                     visible(project.title), report::table_text(governing, layout::width()),
                     remarks_summary(project, verification));
}

}  // namespace boxbeam
