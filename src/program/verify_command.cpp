#include "program/verify_command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/text_report.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/case_options.hpp"
#include "program/exit_code.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

/// Writes every output that can be written; returns what could not be, as text.
std::string write_reports(const Project& project, const Verification& verification,
                          const std::string& folder, bool plots,
                          std::vector<std::string>& written) {
  remove_figures(folder);
  write_file(folder + "/report.txt", text_report(project, verification));
  write_file(folder + "/results.json", results_json(project, verification));
  written = {"report.txt", "results.json"};
  if (!plots) return "";
  try {
    for (std::string& name : draw_figures(project, verification, folder))
      written.push_back(std::move(name));
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

/// Takes over which model is asked for.
void take_model(const VerifyOptions& options, Project& project) {
  if (options.tolerance) project.model.tolerance = *options.tolerance;
  if (options.model.empty()) return;
  project.model.demand = options.model == "auto"    ? ModelDemand::automatic
                         : options.model == "rigid" ? ModelDemand::rigid
                                                    : ModelDemand::flexible;
  if (project.model.demand != ModelDemand::flexible) return;
  if (in_space(project)) {
    throw InputError("the bodies of a mechanism in space are rigid; there is no flexible model",
                     "use --model auto or --model rigid");
  }
  if (project.dynamics == Dynamics::newton_chain) {
    throw InputError("the published Newton chain is one of rigid bodies",
                     "use --model auto or --model rigid, or --dynamics rigorous");
  }
}

}  // namespace

Project project_of(const VerifyOptions& options) {
  Project project = read_case(options.case_file, options.set, options.dynamics);
  take_model(options, project);
  return project;
}

int run_verify(const VerifyOptions& options) {
  const Project project = project_of(options);
  const Verification verification = verify(project);

  const std::string folder = options.out.empty() ? "reports/" + project.name : options.out;
  std::vector<std::string> written;
  const std::string trouble =
      write_reports(project, verification, folder, !options.no_plots, written);
  if (!options.json.empty() && options.json != "-") {
    write_file(options.json, results_json(project, verification));
    written.push_back(options.json);
  }
  if (options.json == "-") {
    put(results_json(project, verification));
  } else {
    put(coloured(summary(project, verification)) +
        fmt::format("\nWritten to {}: {}\n", folder, fmt::join(written, ", ")));
  }
  if (!trouble.empty()) {
    std::cerr << "boxbeam: " << trouble << "\n";
    return output_failed;
  }
  return verification.verdict == Verdict::pass ? all_pass : check_fails;
}

}  // namespace boxbeam::program
