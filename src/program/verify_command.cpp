#include "program/verify_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "boxbeam/report/files.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/pdf.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/exit_code.hpp"
#include "program/failures.hpp"
#include "program/file_watch.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"
#include "report/process.hpp"
#include "report/text_layout.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

/// What a run has written, and what it could not write.
struct Outputs {
  std::vector<std::string> written;  ///< in the folder, or as the user named them
  std::vector<std::string> figures;  ///< their files
  Troubles troubles;
  std::string results;  ///< results.json
};

/// What an earlier run may have written: nothing of it may stand beside the new report.
std::vector<std::string> files_of_reports() {
  std::vector<std::string> files = files_of_figures();
  for (const char* name :
       {"report.txt", "report.html", "report.pdf", "report.log", "results.json"}) {
    files.emplace_back(name);
  }
  return files;
}

ReportLevel level_of(const std::string& word) {
  if (word == "summary") return ReportLevel::summary;
  return word == "full" ? ReportLevel::full : ReportLevel::governing;
}

/// Writes the report in its forms and its figures, each without those that fail.
void write_report(const Project& project, const Verification& verification,
                  const VerifyOptions& options, const std::string& folder, Progress& progress,
                  Outputs& outputs) {
  const auto write = [&](const char* name, const std::string& content) {
    write_file(folder + "/" + name, content);
    outputs.written.emplace_back(name);
  };
  std::optional<report::ScratchFolder> twins;  // the figures as PDF
  if (!options.no_plots) {
    progress.now("drawing the figures");
    outputs.troubles.attempt([&] {
      if (!options.no_pdf) twins.emplace(folder);
      outputs.figures =
          draw_figures(project, verification, folder, twins ? twins->path().string() : "");
    });
  }
  const auto drawn = [&](const std::string& name) {
    const std::vector<std::string>& files = outputs.figures;
    return std::find(files.begin(), files.end(), name + ".svg") != files.end();
  };
  const report::Document document =
      with_pictures(report_of(project, verification, level_of(options.level)), drawn);
  outputs.troubles.attempt([&] { write("report.txt", report::text_of(document)); });
  if (!options.no_html) {
    const auto picture = [&](const std::string& name) { return svg_in(folder, name); };
    outputs.troubles.attempt([&] { write("report.html", report::html_of(document, picture)); });
  }
  if (!options.no_pdf) {
    progress.now("setting the PDF");
    outputs.troubles.attempt([&] {
      report::write_pdf(document, twins ? twins->path().string() : "", folder + "/report.pdf");
      outputs.written.emplace_back("report.pdf");
    });
  }
}

/// Writes all that is asked for.
Outputs write_outputs(const Project& project, const Verification& verification,
                      const VerifyOptions& options, const std::string& folder, Progress& progress) {
  Outputs outputs;
  outputs.results = results_json(project, verification);
  outputs.troubles.attempt([&] {
    report::FolderUpdate update(folder);
    const bool possible = outputs.troubles.attempt(
        [&] { write_file(update.path() + "/results.json", outputs.results); });
    if (possible) {
      outputs.written.emplace_back("results.json");
      write_report(project, verification, options, update.path(), progress, outputs);
      std::rotate(outputs.written.begin(), outputs.written.begin() + 1, outputs.written.end());
    }
    if (publish(update, folder, files_of_reports(), outputs.troubles)) {
      std::error_code ignored;
      fs::remove(fs::path(folder) / "plots", ignored);  // where nothing is in it
    } else {
      outputs.written.clear();
      outputs.figures.clear();
    }
  });
  if (!options.json.empty() && options.json != "-") {
    outputs.troubles.attempt([&] {
      write_file(options.json, outputs.results);
      outputs.written.push_back(options.json);
    });
  }
  return outputs;
}

std::string written_line(const std::string& folder, const Outputs& outputs) {
  if (outputs.written.empty()) return "";
  std::string line = fmt::format("Written to {}: {}", folder, fmt::join(outputs.written, ", "));
  if (!outputs.figures.empty()) line += fmt::format(", {} figures", outputs.figures.size());
  return "\n" + layout::line(line);
}

/// A verification with what it wrote.
struct Run {
  Project project;
  Verification verification;
  std::string folder;
  Outputs outputs;
};

Run run_once(const VerifyOptions& options) {
  Run run{read_case(options.of_case), {}, {}, {}};
  run.folder = options.out.empty() ? "reports/" + run.project.name : options.out;
  require_folder(run.folder);
  require_file_beside(options.json, run.folder);
  Progress progress(!options.quiet);
  progress.now("verifying");
  run.verification =
      verify(run.project, options.no_plots ? Figures::without : Figures::with, Advice::with);
  run.outputs = write_outputs(run.project, run.verification, options, run.folder, progress);
  return run;
}

void say(const Run& run, const VerifyOptions& options) {
  if (options.json == "-") {
    put(run.outputs.results);
  } else if (options.quiet) {
    put_text(verdict_line(run.project, run.verification));
  } else {
    report::MarkedText text = summary(run.project, run.verification);
    text += written_line(run.folder, run.outputs);
    put_text(text);
  }
  for (const std::string& trouble : run.outputs.troubles.words) put_error(trouble);
}

/// Verifies again and again, for as long as it is let.
[[noreturn]] void verify_on_every_change(const VerifyOptions& options) {
  std::optional<Run> last;
  FileWatch watch({options.of_case.file});
  for (;;) {
    exit_code_of([&] {
      Run run = run_once(options);
      std::vector<std::string> files{options.of_case.file};
      for (const InputFile& table : run.project.tables) files.push_back(table.resolved);
      watch.add(files);
      if (last) {
        put_text(what_changed(last->verification, run.project, run.verification));
        for (const std::string& trouble : run.outputs.troubles.words) put_error(trouble);
      } else {
        say(run, options);
        put_text(
            layout::line("\nVerified again whenever the case or a table changes; Ctrl-C ends it."));
      }
      last = std::move(run);
      return 0;
    });
    watch.wait();
  }
}

}  // namespace

int run_verify(const VerifyOptions& options) {
  report::clear_up_before_the_end();
  if (options.watch) verify_on_every_change(options);
  const Run run = run_once(options);
  say(run, options);
  if (!run.outputs.troubles.words.empty()) return output_failed;
  return run.verification.verdict == Verdict::pass ? all_pass : check_fails;
}

}  // namespace boxbeam::program
