#include <fmt/format.h>

#include "boxbeam/core/code_points.hpp"
#include "charts/accuracy.hpp"
#include "charts/chart_text.hpp"
#include "report/text_layout.hpp"

namespace boxbeam {
namespace {

std::string charts_text(const std::vector<charts::Chart>& charts) {
  if (charts.empty()) return "";
  layout::Table table({"chart", "default", "error", "good enough", "standing"});
  for (const charts::Chart& chart : charts) {
    const std::vector<DefaultSetting> defaults = defaults_of(chart);
    if (defaults.empty()) table.row({chart.name, "none", "-", needed_text(chart), "-"});
    for (const DefaultSetting& setting : defaults) {
      table.row({chart.name, visible(setting_text(setting)), error_text(*setting.point),
                 needed_text(chart), standing_of(chart, *setting.point)});
    }
  }
  std::string off_front;
  for (const charts::Chart& chart : charts)
    if (const std::string front = front_text(chart); !front.empty())
      off_front += layout::paragraph(fmt::format("{}: {}", chart.name, visible(front)));
  return table.text() + (off_front.empty() ? "" : "\n" + off_front);
}

std::string maps_text(const std::vector<charts::Map>& maps) {
  if (maps.empty()) return "";
  layout::Table table({"map", "method", "solved", "silently wrong", "refused"});
  for (const charts::Map& map : maps) {
    for (const charts::MapPanel& panel : map.panels) {
      const auto count = [&](charts::Outcome outcome) {
        return std::to_string(panel.count(outcome));
      };
      table.row({map.name, visible(panel.method) + (panel.yardstick ? " (for comparison)" : ""),
                 count(charts::Outcome::solved), count(charts::Outcome::wrong),
                 count(charts::Outcome::refused)});
    }
  }
  return table.text();
}

}  // namespace

std::string accuracy_text(const std::vector<TopicShown>& topics) {
  std::string text;
  for (const TopicShown& topic : topics) {
    if (!text.empty()) text += "\n";
    text += layout::heading(topic.topic->title);
    if (!topic.result.not_applicable.empty())
      text += layout::paragraph("not applicable: " + visible(topic.result.not_applicable));
    text += charts_text(topic.result.charts);
    if (!topic.result.charts.empty() && !topic.result.maps.empty()) text += "\n";
    text += maps_text(topic.result.maps);
  }
  return text;
}

}  // namespace boxbeam
