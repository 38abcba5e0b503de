#include "accuracy_plot.hpp"
#include "boxbeam/report/accuracy.hpp"
#include "drawn_files.hpp"

namespace boxbeam {

std::vector<std::string> draw_charts(const std::vector<TopicShown>& topics,
                                     const std::string& folder, const std::string& pdf_folder) {
  std::vector<DrawnFigure> figures;
  for (const TopicShown& topic : topics) {
    for (const study::Chart& chart : topic.result.charts) {
      figures.push_back(
          {chart.name, [&](plot::Script& script) { plot::work_precision(script, chart); }});
    }
    for (const study::Map& map : topic.result.maps) {
      figures.push_back(
          {map.name, [&](plot::Script& script) { plot::stability_map(script, map); }});
    }
  }
  return draw_into(folder, pdf_folder, figures);
}

}  // namespace boxbeam
