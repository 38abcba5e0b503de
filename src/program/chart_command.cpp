#include "program/chart_command.hpp"

#include <fmt/format.h>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/accuracy.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/study/topics.hpp"
#include "program/exit_code.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

std::vector<const study::Topic*> topics_of(const ChartOptions& options) {
  std::vector<const study::Topic*> wanted;
  for (const study::Topic& topic : study::topics()) {
    const bool all = options.topics.empty();
    bool named = all;
    for (const std::string& word : options.topics) {
      named = named || word == "all" || word == topic.name;
    }
    if (named) wanted.push_back(&topic);
  }
  return wanted;
}

}  // namespace

int run_chart(const ChartOptions& options) {
  const study::Scenes scenes = options.of_case.file.empty()
                                   ? study::reference_scenes()
                                   : study::scenes_of(read_case(options.of_case));
  const study::Effort effort{options.quick};
  const std::string folder = options.out.empty() ? "reports/accuracy" : options.out;
  std::vector<TopicShown> shown;
  {
    Progress progress;
    for (const study::Topic* topic : topics_of(options)) {
      progress.now(topic->title);
      shown.push_back({topic, topic->run(scenes, effort)});
    }
    for (const TopicShown& topic : shown) {
      for (const study::Chart& chart : topic.result.charts) {
        write_file(fmt::format("{}/{}.csv", folder, chart.name), chart_csv(chart));
      }
      for (const study::Map& map : topic.result.maps) {
        write_file(fmt::format("{}/{}.csv", folder, map.name), map_csv(map));
      }
    }
    draw_charts(shown, folder);
  }
  return all_pass;
}

}  // namespace boxbeam::program
