#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/study_report.hpp"
#include "design_plots.hpp"
#include "drawn_files.hpp"
#include "ink.hpp"

namespace boxbeam {
namespace {

constexpr const char* indices_figure = "indices";
constexpr double index_row = 34.0, index_names = 170.0;
constexpr std::size_t most_index_rows = 16, most_index_columns = 4;

/// A bar from zero with the bounds of its value as a line.
void put_bounded_bar(plot::Drawing& drawing, const plot::Panel& panel, const BoundedEstimate& of,
                     double low, double high, const std::string& ink) {
  const auto inside = [&](double x) { return std::clamp(x, panel.x_low, panel.x_high); };
  const double end = inside(of.value), middle = 0.5 * (low + high);
  drawing.shapes.emplace_back(
      plot::Line{{panel.at(0.0, low), panel.at(end, low), panel.at(end, high), panel.at(0.0, high)},
                 {ink, 0.8, {}, ink, ""},
                 true});
  const plot::Pen pen{"#202020", 1.0};
  plot::put_line(drawing, panel.at(inside(of.low), middle), panel.at(inside(of.high), middle), pen);
  for (const double bound : {of.low, of.high})
    plot::put_line(drawing, panel.at(inside(bound), low), panel.at(inside(bound), high), pen);
}

/// One panel a result, the largest ST at its top.
plot::Drawing index_bars(const StudySummary& summary) {
  std::vector<const ColumnIndices*> columns;
  for (const ColumnIndices& column : summary.indices)
    if (!column.indices.of.empty() && columns.size() < most_index_columns)
      columns.push_back(&column);
  const std::vector<plot::LegendEntry> legend{
      {"S1, by itself", "", "", {plot::colour(0), 9.0}},
      {"ST, with what it does together with others; line: 95 % confidence",
       "",
       "",
       {plot::colour(1), 9.0}}};
  const double legend_height = plot::height_of_legend(legend) + 4.0;
  const std::size_t rows = std::min(most_index_rows, summary.index_variables.size());
  const double of_one =
      plot::footing_room + index_row * static_cast<double>(rows) + plot::heading_room;
  plot::Drawing drawing{
      plot::figure_width, legend_height + of_one * static_cast<double>(columns.size()), {}};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const SobolIndices& indices = columns[c]->indices;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < indices.of.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return indices.of[a].total.value > indices.of[b].total.value;
    });
    order.resize(rows);
    double most = 1.0, least = 0.0;
    for (const std::size_t i : order) {
      most = std::max({most, indices.of[i].first.high, indices.of[i].total.high});
      least = std::min({least, indices.of[i].first.low, indices.of[i].total.low});
    }
    const double below =
        legend_height + of_one * static_cast<double>(columns.size() - 1 - c) + plot::footing_room;
    const plot::Panel panel{{index_names, below, plot::figure_width - 16.0,
                             below + index_row * static_cast<double>(rows)},
                            std::max(least, -0.2),
                            std::min(most, 1.3),
                            0.0,
                            static_cast<double>(rows)};
    plot::put_axes(drawing, panel, false);
    plot::put_heading(drawing, panel, columns[c]->column.name);
    plot::put_footing(drawing, panel, "part of the variance");
    for (std::size_t k = 0; k < rows; ++k) {
      const double middle = static_cast<double>(rows - k) - 0.5;
      put_bounded_bar(drawing, panel, indices.of[order[k]].first, middle + 0.03, middle + 0.35,
                      plot::colour(0));
      put_bounded_bar(drawing, panel, indices.of[order[k]].total, middle - 0.35, middle - 0.03,
                      plot::colour(1));
      plot::put_text(drawing, plot::fitted(summary.index_variables[order[k]], index_names - 16.0),
                     {index_names - 8.0, panel.at(0.0, middle).y()}, plot::Anchor::right);
    }
  }
  plot::draw_legend(drawing, legend, 4.0);
  return drawing;
}

}  // namespace

std::vector<std::string> draw_study(const StudySummary& summary, const DesignRows& rows,
                                    const std::string& folder) {
  std::vector<DrawnFigure> figures;
  const auto add = [&](const char* name, std::optional<plot::Drawing> drawing) {
    if (drawing) figures.push_back({name, [drawn = *std::move(drawing)] { return drawn; }});
  };
  const bool varies =
      std::any_of(summary.indices.begin(), summary.indices.end(),
                  [](const ColumnIndices& column) { return !column.indices.of.empty(); });
  if (varies) add(indices_figure, index_bars(summary));
  add("contour", plot::contour(rows));
  add("parallel", plot::parallel_axes(rows));
  add("histogram", summary.keep.empty() ? plot::histogram(rows) : plot::histogram(summary));
  return figures.empty() ? std::vector<std::string>() : draw_into(folder, "", figures);
}

std::vector<std::string> files_of_study() {
  return {"rows.csv",    "rows.nc",     "study.json",   "study.html",   "statistics.json",
          "indices.svg", "contour.svg", "parallel.svg", "histogram.svg"};
}

}  // namespace boxbeam
