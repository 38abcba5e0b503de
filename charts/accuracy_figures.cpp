#include "charts/accuracy.hpp"
#include "charts/accuracy_plot.hpp"
#include "report/drawn_files.hpp"

namespace boxbeam {

std::vector<std::string> draw_charts(const std::vector<TopicShown>& topics,
                                     const std::string& folder, const std::string& tex_folder) {
  std::vector<DrawnFigure> figures;
  for (const TopicShown& topic : topics) {
    for (const charts::Chart& chart : topic.result.charts) {
      figures.push_back(
          {chart.name, [&](plot::Script& script) { plot::work_precision(script, chart); }});
    }
    for (const charts::Map& map : topic.result.maps) {
      figures.push_back(
          {map.name, [&](plot::Script& script) { plot::stability_map(script, map); }});
    }
  }
  return draw_into(folder, tex_folder, figures);
}

}  // namespace boxbeam
