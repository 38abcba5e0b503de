#include "program/chart_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/pdf.hpp"
#include "charts/accuracy.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"
#include "report/process.hpp"

namespace boxbeam::program {
namespace {

/// In the order of the calculation, whatever the user's.
std::vector<const charts::Topic*> topics_of(const ChartOptions& options) {
  const auto is_wanted = [&](const std::string& name) {
    return std::find(options.topics.begin(), options.topics.end(), name) != options.topics.end();
  };
  const bool all = options.topics.empty() || is_wanted("all");
  std::vector<const charts::Topic*> wanted;
  for (const charts::Topic& topic : charts::topics()) {
    if (all || is_wanted(topic.name)) wanted.push_back(&topic);
  }
  return wanted;
}

/// The cases that the experiments are done on, each once.
std::vector<std::pair<std::string, std::string>> names_of(const charts::Scenes& scenes) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::optional<Project>* scene : {&scenes.planar, &scenes.flexible, &scenes.beam}) {
    if (!*scene) continue;
    const std::pair<std::string, std::string> name{(*scene)->name, (*scene)->sha256};
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void refuse_where_nothing_applies(const std::vector<TopicShown>& topics) {
  AnalysisFailure failure;
  failure.what = "there is nothing to chart of this case";
  for (const TopicShown& topic : topics) {
    if (!topic.result.charts.empty() || !topic.result.maps.empty()) return;
    failure.details.push_back(
        fmt::format("{}: {}", topic.topic->name, topic.result.not_applicable));
  }
  throw AnalysisError(std::move(failure));
}

AccuracyRun run_of(const ChartOptions& options, Progress& progress) {
  AccuracyRun run;
  run.quick = options.quick;
  progress.now("reading the cases");
  const charts::Scenes scenes = options.of_case.file.empty()
                                    ? charts::reference_scenes()
                                    : charts::scenes_of(read_case(options.of_case));
  run.scenes = names_of(scenes);
  const charts::Effort effort{options.quick};
  for (const charts::Topic* topic : topics_of(options)) {
    progress.now(fmt::format("charting {}", topic->name));
    run.topics.push_back({topic, topic->run(scenes, effort)});
  }
  refuse_where_nothing_applies(run.topics);
  return run;
}

/// A chart or a map by the name of its files, and its data.
struct Data {
  std::string name, csv;
};

std::vector<Data> data_of(const std::vector<TopicShown>& topics) {
  std::vector<Data> data;
  for (const TopicShown& topic : topics) {
    for (const charts::Chart& chart : topic.result.charts)
      data.push_back({chart.name, chart_csv(chart)});
    for (const charts::Map& map : topic.result.maps) data.push_back({map.name, map_csv(map)});
  }
  return data;
}

/// What a run has written, and what it could not write.
struct Outputs {
  std::size_t tables = 0, figures = 0;
  std::vector<std::string> pages;
  Troubles troubles;
};

/// What an earlier run may have written of the same charts, and its pages: no picture may stand
/// beside data that it does not show.
std::vector<std::string> files_of_charts(const std::vector<Data>& data) {
  std::vector<std::string> files{"chart.html", "chart.pdf", "chart.log"};
  for (const Data& of : data) {
    files.push_back(of.name + ".csv");
    files.push_back(of.name + ".svg");
    files.push_back("plots/" + of.name + ".gp");
  }
  return files;
}

void write_into(AccuracyRun& run, const std::vector<Data>& data, const std::string& folder,
                bool with_pdf, Progress& progress, Outputs& outputs) {
  const bool possible = outputs.troubles.attempt([&] {
    for (const Data& of : data) {
      write_file(fmt::format("{}/{}.csv", folder, of.name), of.csv);
      ++outputs.tables;
    }
  });
  if (!possible) return;
  progress.now("drawing the charts");
  std::optional<report::ScratchFolder> twins;  // the figures as PDF
  run.drawn = outputs.troubles.attempt([&] {
    if (with_pdf) twins.emplace(folder);
    outputs.figures = draw_charts(run.topics, folder, twins ? twins->path().string() : "").size();
  });
  const report::Document document = accuracy_document(run);
  outputs.troubles.attempt([&] {
    const auto picture = [&](const std::string& name) { return svg_in(folder, name); };
    write_file(folder + "/chart.html", report::html_of(document, picture));
    outputs.pages.emplace_back("chart.html");
  });
  if (!with_pdf) return;
  progress.now("setting the PDF");
  outputs.troubles.attempt([&] {
    report::write_pdf(document, twins ? twins->path().string() : "", folder + "/chart.pdf");
    outputs.pages.emplace_back("chart.pdf");
  });
}

Outputs write_outputs(AccuracyRun& run, const std::string& folder, bool with_pdf,
                      Progress& progress) {
  Outputs outputs;
  const std::vector<Data> data = data_of(run.topics);
  outputs.troubles.attempt([&] {
    report::FolderUpdate update(folder);
    write_into(run, data, update.path(), with_pdf, progress, outputs);
    if (publish(update, folder, files_of_charts(data), outputs.troubles)) return;
    outputs.tables = outputs.figures = 0;
    outputs.pages.clear();
  });
  return outputs;
}

std::string written_line(const std::string& folder, const Outputs& outputs) {
  if (outputs.tables == 0) return "";
  std::string line = fmt::format("\nWritten to {}: {} tables, {} pictures", folder, outputs.tables,
                                 outputs.figures);
  if (!outputs.pages.empty())
    line += fmt::format(", {} of these topics", fmt::join(outputs.pages, " and "));
  return line + "\n";
}

}  // namespace

std::vector<std::string> chart_topics() {
  std::vector<std::string> names;
  for (const charts::Topic& topic : charts::topics()) names.emplace_back(topic.name);
  return names;
}

int run_chart(const ChartOptions& options) {
  report::clear_up_before_the_end();
  const std::string folder = options.out.empty() ? "reports/accuracy" : options.out;
  require_folder(folder);
  AccuracyRun run;
  Outputs outputs;
  {
    Progress progress;
    run = run_of(options, progress);
    outputs = write_outputs(run, folder, !options.no_pdf, progress);
  }
  put_text(accuracy_text(run.topics) + written_line(folder, outputs));
  for (const std::string& trouble : outputs.troubles.words) put_error(trouble);
  return outputs.troubles.words.empty() ? all_pass : output_failed;
}

}  // namespace boxbeam::program
