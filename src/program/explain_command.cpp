#include "program/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/exit_code.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

/// All ids, worst first.
report::MarkedText list_of(const Verification& verification) {
  report::MarkedText list;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    const report::Mark mark = check.passes() ? report::Mark::passes : report::Mark::fails;
    list += {report::to_text(mark), mark};
    list += fmt::format("{} {:>8}  {}\n", check.passes() ? "" : " ",
                        text::percent(check.utilisation()), check.id);
  }
  return list;
}

const CheckResult* find_in(const std::vector<CheckResult>& checks, const std::string& id) {
  const auto same = std::find_if(checks.begin(), checks.end(),
                                 [&](const CheckResult& result) { return result.check.id == id; });
  if (same != checks.end()) return &*same;
  for (const std::string& begin : {id + "/", id}) {
    const auto below = std::find_if(checks.begin(), checks.end(), [&](const CheckResult& result) {
      return result.check.id.starts_with(begin);
    });
    if (!id.empty() && below != checks.end()) return &*below;
  }
  return nullptr;
}

/// The check of an id; or the worst one of those whose ids begin with its parts, "fatigue/4.2"; or
/// of those whose criteria's names begin so: "shear", "combined". Else one that stands beside the
/// verdict.
const CheckResult* find_check(const Verification& verification, const std::string& id) {
  if (id == "governing") return &verification.checks.front();
  const CheckResult* const found = find_in(verification.checks, id);
  return found != nullptr ? found : find_in(verification.beside, id);
}

InputError unknown(const Verification& verification, const std::string& id) {
  std::vector<std::string> known{"governing", "list"};
  for (const CheckResult& result : verification.checks) {
    const std::string& full = result.check.id;
    for (std::size_t end = full.find('/'); end != std::string::npos; end = full.find('/', end + 1))
      known.push_back(full.substr(0, end));
    known.push_back(full);
  }
  const std::string near = nearest_word(id, known);
  const std::string hint = near.empty() ? "" : fmt::format("did you mean {}? ", near);
  return InputError(fmt::format("the case has no check \"{}\"", id),
                    hint + "boxbeam explain list CASE shows all");
}

/// The check stands before the case; a file in its place is the case.
void refuse_swapped(const ExplainOptions& options) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(options.check, error) || fs::exists(options.of_case.file, error)) return;
  throw InputError("the check stands before the case",
                   fmt::format("boxbeam explain {} {}", shell_word(options.of_case.file),
                               shell_word(options.check)));
}

}  // namespace

int run_explain(const ExplainOptions& options) {
  refuse_swapped(options);
  const Project project = read_case(options.of_case);
  Verification verification;
  {
    Progress progress;
    progress.now("verifying");
    verification = verify(project);
  }
  if (options.check == "list") {
    put_text(list_of(verification));
    return all_pass;
  }
  const CheckResult* result = find_check(verification, options.check);
  if (result == nullptr) throw unknown(verification, options.check);
  put_text(report::text_of(sheet_of(project, verification, *result), columns()));
  return all_pass;
}

}  // namespace boxbeam::program
