#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxbeam/report/report.hpp"
#include "charts/accuracy.hpp"
#include "charts/chart_text.hpp"
#include "charts/machine_facts.hpp"
#include "report/blocks.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using charts::Chart;
using charts::Map;
using charts::MapPanel;
using charts::Outcome;
using report::Chapter;
using report::Paragraph;
using report::Picture;
using report::row_of;
using report::Table;

/// "evaluations of the load: 9".
std::string work_text(const Chart& chart, const charts::Point& point) {
  if (!point.operations) return "-";
  return fmt::format("{}: {:.6g}", chart.operations.empty() ? "operations" : chart.operations,
                     *point.operations);
}

/// "beam at one instant: 412 ns".
std::string time_text(const Chart& chart, const charts::Point& point) {
  if (!point.time) return "-";
  const std::string time = duration_text(point.time->median);
  return chart.unit.empty() ? time : fmt::format("{}: {}", chart.unit, time);
}

Table table_of_defaults(const std::vector<TopicShown>& topics) {
  Table table = report::table_of(
      "", {"chart", "default", "error", "good enough", "standing", "work", "time"});
  for (const TopicShown& topic : topics) {
    for (const Chart& chart : topic.result.charts) {
      for (const DefaultSetting& setting : defaults_of(chart)) {
        const charts::Point& point = *setting.point;
        add_row(table, row_of(chart.name, setting_text(setting),
                              report::Cell{error_text(point), point.error}, needed_text(chart),
                              standing_of(chart, point), work_text(chart, point),
                              time_text(chart, point)));
      }
    }
  }
  return table;
}

Chapter chapter_of_defaults(Table table) {
  Chapter chapter{"Default settings", {}};
  chapter.blocks.emplace_back(
      Paragraph{"What the program does unless it is told otherwise, its error against the "
                "reference of each chart, and what that costs. A strength check needs no more than "
                "\"good enough\"; \"better\" is below it, \"coarser\" above."});
  chapter.blocks.emplace_back(std::move(table));
  return chapter;
}

void add_failures(const Chart& chart, Chapter& chapter) {
  Table table = report::table_of(fmt::format("Failed settings of {}", chart.name),
                                 {"method", "settings", "number", "reason"});
  for (const FailedSettings& failed : failures_of(chart)) {
    add_row(table, row_of(failed.method, settings_text(failed.settings),
                          std::to_string(failed.settings.size()), failed.reason));
  }
  if (!table.rows.empty()) chapter.blocks.emplace_back(std::move(table));
}

/// "Title. Lesson": in one piece, so that a picture and what it teaches stay together.
std::string caption_of(const std::string& title, const std::string& lesson) {
  return lesson.empty() ? title + "." : fmt::format("{}. {}", title, lesson);
}

/// The words of a picture that was not drawn stand by themselves.
report::Block picture_of(const std::string& name, std::string caption, bool drawn) {
  if (!drawn) return Paragraph{std::move(caption)};
  return Picture{name, std::move(caption)};
}

void add_chart(const Chart& chart, bool drawn, Chapter& chapter) {
  const std::string front = front_text(chart);
  chapter.blocks.push_back(picture_of(
      chart.name,
      caption_of(chart.title, front.empty() || chart.lesson.empty() ? chart.lesson + front
                                                                    : chart.lesson + " " + front),
      drawn));
  add_failures(chart, chapter);
}

Table table_of_counts(const Map& map) {
  Table table = report::table_of(fmt::format("Trials of {}", map.name),
                                 {"method", "trials", "solved", "silently wrong", "refused"});
  for (const MapPanel& panel : map.panels) {
    const auto count = [&](Outcome outcome) { return std::to_string(panel.count(outcome)); };
    add_row(table, row_of(panel.yardstick ? panel.method + " (for comparison)" : panel.method,
                          std::to_string(panel.cells.size()), count(Outcome::solved),
                          count(Outcome::wrong), count(Outcome::refused)));
  }
  return table;
}

/// Reasons of refusals with how often each was said, the most frequent first.
Table table_of_refusals(const Map& map) {
  constexpr std::size_t most = 8;
  Table table =
      report::table_of(fmt::format("Refusals in {}", map.name), {"method", "number", "reason"});
  for (const MapPanel& panel : map.panels) {
    std::map<std::string, std::size_t> numbers;
    for (const charts::Cell& trial : panel.cells) {
      if (trial.outcome == Outcome::refused) ++numbers[trial.reason];
    }
    std::vector<std::pair<std::string, std::size_t>> sorted(numbers.begin(), numbers.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i)
      add_row(table, row_of(panel.method, std::to_string(sorted[i].second), sorted[i].first));
    if (sorted.size() > most)
      add_row(table,
              row_of(panel.method, "...", fmt::format("{} more reasons", sorted.size() - most)));
  }
  return table;
}

void add_map(const Map& map, bool drawn, Chapter& chapter) {
  chapter.blocks.push_back(picture_of(map.name, caption_of(map.title, map.lesson), drawn));
  chapter.blocks.emplace_back(table_of_counts(map));
  Table refusals = table_of_refusals(map);
  if (!refusals.rows.empty()) chapter.blocks.emplace_back(std::move(refusals));
}

Chapter chapter_of(const TopicShown& topic, bool drawn) {
  Chapter chapter{topic.topic->title, {}};
  if (!topic.result.not_applicable.empty())
    chapter.blocks.emplace_back(Paragraph{"Not applicable: " + topic.result.not_applicable});
  for (const Chart& chart : topic.result.charts) add_chart(chart, drawn, chapter);
  for (const Map& map : topic.result.maps) add_map(map, drawn, chapter);
  return chapter;
}

}  // namespace

report::Document accuracy_document(const AccuracyRun& run) {
  report::Document document;
  document.title = "Accuracy and cost";
  document.subtitle = "Numerical methods of the program beside others, and where they fail";
  document.date = report_date();
  document.program = fmt::format("boxbeam {}", version);
  std::vector<std::string> names;
  for (const TopicShown& topic : run.topics) names.emplace_back(topic.topic->name);
  document.facts.entries = {
      {"topics", fmt::format("{}", fmt::join(names, ", "))},
      {"effort", run.quick ? "quick: fewer settings, shorter measurements" : "full"},
      {"times",
       "median of measurements by turns, and their quartiles; they "
       "depend on the machine, errors and counts of work do not"}};
  for (const auto& [name, sha256] : run.scenes)
    document.facts.entries.emplace_back("scene", fmt::format("{}, sha256 {}", name, sha256));
  const report::Facts machine = report::machine_facts();
  document.facts.entries.insert(document.facts.entries.end(), machine.entries.begin(),
                                machine.entries.end());
  Table defaults = table_of_defaults(run.topics);
  if (!defaults.rows.empty()) document.chapters.push_back(chapter_of_defaults(std::move(defaults)));
  for (const TopicShown& topic : run.topics)
    document.chapters.push_back(chapter_of(topic, run.drawn));
  return document;
}

}  // namespace boxbeam
