#include "program/commands.hpp"

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/published_values.hpp"
#include "boxbeam/report/comparison.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/design_numbers.hpp"
#include "program/design_trial.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
int run_compare(const CompareOptions& options) {
  const PublishedValues published = read_published(options.published);
  const Project project = read_case(options.of_case);
  require_file(options.json);
  require_file(options.html);
  Comparison comparison;
  {
    Progress progress;
    progress.now("verifying");
    const Verification verification = verify(project);
    comparison = compare(project, verification, published, [&](const std::vector<double>& times) {
      return any_motion_of(project, times);
    });
    if (const std::optional<AnalysisError> why = not_judged(verification))
      comparison.gate = in_one_line(why->failure().what);
  }
  if (!options.html.empty()) {
    const auto no_pictures = [](const std::string&) { return std::optional<std::string>(); };
    write_file(options.html,
               report::html_of(comparison_document(project, comparison), no_pictures));
  }
  put_result(options.json, comparison_json(project, comparison),
             comparison_text(project, comparison));
  return comparison.passes() ? all_pass : check_fails;
}

}  // namespace boxbeam::program
