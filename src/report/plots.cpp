#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include "drawn_files.hpp"
#include "figure_kinds.hpp"

namespace boxbeam {

std::vector<std::string> files_of_figures() {
  std::vector<std::string> files;
  for (const report::FigureKind& kind : report::figure_kinds()) {
    files.push_back(fmt::format("{}.svg", kind.name));
    if (kind.plot != nullptr) files.push_back(fmt::format("plots/{}.gp", kind.name));
  }
  return files;
}

std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder, const std::string& tex_folder) {
  std::vector<DrawnFigure> figures;
  for (const report::FigureKind& kind : report::figure_kinds()) {
    if (!kind.shown(project, verification)) continue;
    if (kind.draw != nullptr)
      figures.push_back({kind.name, [&, kind] { return kind.draw(project, verification); }});
    else
      figures.push_back(
          {kind.name, [&, kind](plot::Script& gp) { kind.plot(gp, project, verification); }});
  }
  return draw_into(folder, tex_folder, figures);
}

}  // namespace boxbeam
