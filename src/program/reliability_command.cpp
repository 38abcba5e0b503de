#include "program/reliability_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/reliability_report.hpp"
#include "boxbeam/report/study_document.hpp"
#include "program/case_limit_state.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"
#include "report/text_layout.hpp"
#include "report/unfinished.hpp"

namespace boxbeam::program {
namespace {

std::size_t threads_wanted(const ReliabilityOptions& options) {
  if (options.threads > 0) return options.threads;
  return std::max(1U, std::thread::hardware_concurrency());
}

StudyReliability solved(const Study& study, const ReliabilityOptions& options) {
  Progress progress(!options.quiet);
  const std::size_t threads = threads_wanted(options);
  const auto ask = [&](LimitState& limit_state, const std::string& sha256) {
    StudyReliability of = study_reliability(
        study, reliability_of(limit_state, *study.reliability, study.seed,
                              [&](const std::string& what) { progress.now(what); }));
    of.sha256 = sha256;
    return of;
  };
  if (study.case_file.empty()) {
    LimitState limit_state = limit_state_of_variables(study, threads);
    return ask(limit_state, sha256_of(study.text));
  }
  progress.now("verifying the design of all medians");
  CaseLimitState of_case = limit_state_of_case(study, threads);
  return ask(of_case.limit_state, of_case.sha256);
}

}  // namespace

int run_reliability(const ReliabilityOptions& options) {
  report::clear_up_before_the_end();
  const Study study = read_study(options.study);
  if (!study.reliability)
    throw InputError(fmt::format("{}: the study says not where a design fails", study.path),
                     "write [limit_state] with check = \"fatigue\" or expression = \"r - s\"");
  const std::string folder = options.out.empty() ? "reports/" + study.name : options.out;
  require_folder(folder);
  require_file_beside(options.json, folder);
  const StudyReliability of = solved(study, options);
  report::FolderUpdate update(folder);
  write_file(update.path() + "/reliability.json", reliability_json(of));
  const std::vector<std::string> figures = draw_reliability(of, update.path());
  write_page("reliability.html", reliability_document(of), update.path());
  update.publish(files_of_reliability());
  std::string names = "reliability.json, reliability.html";
  for (const std::string& figure : figures) names += ", " + figure;
  report::MarkedText text = reliability_text(of);
  text += "\n" + layout::line(fmt::format("Written to {}: {}", folder, names));
  put_result(options.json, reliability_json(of), text);
  const bool answered =
      std::any_of(of.result.methods.begin(), of.result.methods.end(),
                  [](const MethodResult& method) { return method.p_f.has_value(); });
  return answered ? all_pass : not_possible;
}

}  // namespace boxbeam::program
