#include "program/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "boxbeam/report/files.hpp"
#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/overview.hpp"
#include "boxbeam/report/pdf.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/sensitivity_report.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/exit_code.hpp"
#include "program/export_files.hpp"
#include "program/failures.hpp"
#include "program/file_watch.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/sensitivity_run.hpp"
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
  for (const char* name : {"report.txt", "report.html", "report.pdf", "report.log", "results.json",
                           "sensitivities.svg"}) {
    files.emplace_back(name);
  }
  return files;
}

ReportLevel level_of(const std::string& word) {
  if (word == "summary") return ReportLevel::summary;
  return word == "full" ? ReportLevel::full : ReportLevel::governing;
}

/// The folder of a beam's report below that of the case; that itself where it has one beam only.
std::string folder_of(const VerifiedBeam& beam) {
  return beam.project.beam_name.empty() ? "" : beam.project.beam_name + "/";
}

/// What an earlier run of the same beams may have written.
std::vector<std::string> files_of_reports(const std::vector<VerifiedBeam>& beams) {
  std::vector<std::string> files = files_of_reports();
  const std::vector<std::string> of_one = files;
  for (const VerifiedBeam& beam : beams) {
    if (beam.project.beam_name.empty()) continue;
    for (const std::string& file : of_one) files.push_back(folder_of(beam) + file);
  }
  return files;
}

/// A folder with new files, and one with the figures for the PDF.
struct Folders {
  std::string files;
  std::string figures;  ///< "": no PDF is asked for
};

/// Draws the figures of a beam.
void draw(const VerifiedBeam& beam, const Folders& folders, Outputs& outputs) {
  outputs.troubles.attempt([&] {
    const std::string below = folder_of(beam);
    const std::string figures = folders.figures.empty() ? "" : folders.figures + "/" + below;
    if (!below.empty()) fs::create_directories(folders.files + "/" + below);
    if (!figures.empty()) fs::create_directories(figures);
    for (const std::string& name :
         draw_figures(beam.project, beam.verification, folders.files + "/" + below, figures))
      outputs.figures.push_back(below + name);
  });
}

/// Writes a report in its forms into a folder below, each without those that fail.
void write_report(report::Document document, const std::string& below, const VerifyOptions& options,
                  const Folders& folders, Progress& progress, Outputs& outputs) {
  const auto write = [&](const char* name, const std::string& content) {
    write_file(folders.files + "/" + below + name, content);
    outputs.written.push_back(below + name);
  };
  const auto drawn = [&](const std::string& name) {
    const std::vector<std::string>& files = outputs.figures;
    return std::find(files.begin(), files.end(), below + name + ".svg") != files.end();
  };
  document = with_pictures(std::move(document), drawn);
  outputs.troubles.attempt([&] { write("report.txt", report::text_of(document)); });
  if (!options.no_html) {
    const auto picture = [&](const std::string& name) {
      return svg_in(folders.files + "/" + below, name);
    };
    outputs.troubles.attempt([&] { write("report.html", report::html_of(document, picture)); });
  }
  if (!options.no_pdf) {
    progress.now("setting the PDF");
    outputs.troubles.attempt([&] {
      report::write_pdf(document, folders.figures.empty() ? "" : folders.figures + "/" + below,
                        folders.files + "/" + below + "report.pdf");
      outputs.written.push_back(below + "report.pdf");
    });
  }
}

/// The reports of all beams, and of several one of the case, which has the sensitivities.
void write_reports(const std::vector<VerifiedBeam>& beams, const Sensitivities* sensitivities,
                   const VerifyOptions& options, const std::string& folder, Progress& progress,
                   Outputs& outputs) {
  std::optional<report::ScratchFolder> twins;  // the figures as they stand in a PDF
  Folders folders{folder, ""};
  if (!options.no_plots) {
    progress.now("drawing the figures");
    outputs.troubles.attempt([&] {
      if (!options.no_pdf) twins.emplace(folder);
    });
    if (twins) folders.figures = twins->path().string();
    for (const VerifiedBeam& beam : beams) draw(beam, folders, outputs);
    if (sensitivities != nullptr && !sensitivities->inputs.empty())
      outputs.troubles.attempt([&] {
        draw_sensitivities(*sensitivities, folders.files, folders.figures);
        outputs.figures.push_back(std::string(sensitivity_figure) + ".svg");
      });
  }
  const auto write = [&](report::Document document, const std::string& below) {
    if (sensitivities != nullptr && below.empty())
      document.chapters.push_back(sensitivity_chapter(*sensitivities));
    write_report(std::move(document), below, options, folders, progress, outputs);
  };
  if (beams.size() > 1) write(overview_of(beams), "");
  for (const VerifiedBeam& beam : beams)
    write(report_of(beam.project, beam.verification, level_of(options.level)), folder_of(beam));
}

/// Writes all that is asked for.
Outputs write_outputs(const std::vector<VerifiedBeam>& beams, const Sensitivities* sensitivities,
                      const VerifyOptions& options, const std::string& folder, Progress& progress) {
  Outputs outputs;
  outputs.results = results_json(beams, sensitivities);
  outputs.troubles.attempt([&] {
    report::FolderUpdate update(folder);
    const bool possible = outputs.troubles.attempt(
        [&] { write_file(update.path() + "/results.json", outputs.results); });
    if (possible) {
      write_reports(beams, sensitivities, options, update.path(), progress, outputs);
      outputs.written.emplace_back("results.json");
    }
    if (publish(update, folder, files_of_reports(beams), outputs.troubles)) {
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
  std::vector<VerifiedBeam> beams;
  std::string folder;
  std::optional<Sensitivities> sensitivities;  ///< where they are asked for
  Outputs outputs;
  Exported exported;  ///< for other programs, where that is asked for
};

/// Exports each beam, of several into a folder of its name.
void export_beams(const std::string& folder, Progress& progress, Run& run) {
  progress.now("writing the export");
  for (const VerifiedBeam& beam : run.beams) {
    const std::string below = folder_of(beam);
    const std::string into = below.empty() ? folder : fmt::format("{}/{}", folder, below);
    run.outputs.troubles.attempt([&] {
      const Exported of = export_files(beam.project, beam.verification, into);
      for (const std::string& name : of.written) run.exported.written.push_back(below + name);
      for (const std::string& words : of.said) run.exported.said.push_back(words);
      for (const std::string& words : of.left_out) run.exported.left_out.push_back(words);
    });
  }
}

Run run_once(const VerifyOptions& options) {
  std::vector<Project> beams = read_beams_of(options.of_case);
  if (beams.size() == 1) beams.front().beam_name.clear();  // its report is that of the case
  Run run;
  run.folder = options.out.empty() ? "reports/" + beams.front().name : options.out;
  require_folder(run.folder);
  require_file_beside(options.json, run.folder);
  if (!options.export_to.empty()) require_folder(options.export_to);
  Progress progress(!options.quiet);
  progress.now("verifying");
  const Figures figures = options.no_plots  ? Figures::without
                          : options.no_html ? Figures::with
                                            : Figures::with_scenes;
  run.beams = verify_beams(std::move(beams), figures, Advice::with);
  if (options.sensitivities)
    run.sensitivities = sensitivities_of(options.of_case, run.beams, progress);
  run.outputs = write_outputs(run.beams, run.sensitivities ? &*run.sensitivities : nullptr, options,
                              run.folder, progress);
  if (!options.export_to.empty()) export_beams(options.export_to, progress, run);
  return run;
}

void say(const Run& run, const VerifyOptions& options) {
  if (options.json == "-") {
    put(run.outputs.results);
  } else if (options.quiet) {
    put_text(verdict_line(run.beams));
  } else {
    report::MarkedText text = summary(run.beams);
    if (run.sensitivities) text += sensitivity_text(*run.sensitivities);
    text += written_line(run.folder, run.outputs);
    if (!run.exported.written.empty()) {
      text += layout::line(fmt::format("Exported to {}: {}", options.export_to,
                                       fmt::join(run.exported.written, ", ")));
    }
    for (const std::string& words : run.exported.said) text += layout::line("  " + words);
    for (const std::string& words : run.exported.left_out) text += layout::line("  " + words);
    put_text(text);
  }
  if (options.json == "-" || options.quiet) {
    for (const std::string& words : run.exported.left_out) put_error(words);
  }
  for (const std::string& trouble : run.outputs.troubles.words) put_error(trouble);
}

/// Of each beam of a name; where there are others now, all that there is.
void say_what_changed(const std::vector<VerifiedBeam>& before,
                      const std::vector<VerifiedBeam>& now) {
  for (const VerifiedBeam& beam : now) {
    const auto same = std::find_if(before.begin(), before.end(), [&](const VerifiedBeam& other) {
      return other.project.beam_name == beam.project.beam_name;
    });
    if (!beam.project.beam_name.empty()) put_text(layout::line("Beam " + beam.project.beam_name));
    if (same == before.end())
      put_text(summary(beam.project, beam.verification));
    else
      put_text(what_changed(same->verification, beam.project, beam.verification));
  }
}

/// Verifies again and again, for as long as it is let.
[[noreturn]] void verify_on_every_change(const VerifyOptions& options) {
  std::optional<Run> last;
  FileWatch watch({options.of_case.file});
  for (;;) {
    exit_code_of([&] {
      Run run = run_once(options);
      std::vector<std::string> files{options.of_case.file};
      for (const InputFile& table : run.beams.front().project.tables)
        files.push_back(table.resolved);
      watch.add(files);
      if (last) {
        say_what_changed(last->beams, run.beams);
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
  return worst_of(run.beams).verification.verdict == Verdict::pass ? all_pass : check_fails;
}

}  // namespace boxbeam::program
