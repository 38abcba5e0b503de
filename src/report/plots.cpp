#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include "drawn_files.hpp"
#include "figure_kinds.hpp"

namespace boxbeam {
namespace {

using report::FigureKind;

std::vector<FigureKind> kinds_of(const Project& project, const Verification& verification) {
  std::vector<FigureKind> shown;
  for (const FigureKind& kind : report::figure_kinds()) {
    if (kind.shown(project, verification)) shown.push_back(kind);
  }
  return shown;
}

}  // namespace

std::vector<std::string> figures_of(const Project& project, const Verification& verification) {
  std::vector<std::string> names;
  for (const FigureKind& kind : kinds_of(project, verification)) names.emplace_back(kind.name);
  return names;
}

std::vector<std::string> files_of_figures() {
  std::vector<std::string> files;
  for (const FigureKind& kind : report::figure_kinds()) {
    files.push_back(fmt::format("{}.svg", kind.name));
    if (kind.plot != nullptr) files.push_back(fmt::format("plots/{}.gp", kind.name));
  }
  return files;
}

std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder, const std::string& tex_folder) {
  std::vector<DrawnFigure> figures;
  for (const FigureKind& kind : kinds_of(project, verification)) {
    if (kind.draw != nullptr)
      figures.push_back({kind.name, [&, kind] { return kind.draw(project, verification); }});
    else
      figures.push_back(
          {kind.name, [&, kind](plot::Script& gp) { kind.plot(gp, project, verification); }});
  }
  return draw_into(folder, tex_folder, figures);
}

}  // namespace boxbeam
