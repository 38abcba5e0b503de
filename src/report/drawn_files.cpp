#include "drawn_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "boxbeam/core/error.hpp"
#include "gnuplot_process.hpp"
#include "process.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

/// Brings a drawn file to its place.
void move_to(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  fs::rename(from, to, error);
  if (error == std::errc::cross_device_link)
    fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error)
    throw OutputError(fmt::format("{} cannot be written: {}", to.string(), error.message()));
}

}  // namespace

std::vector<std::string> draw_into(const std::string& folder, const std::string& pdf_folder,
                                   const std::vector<DrawnFigure>& figures) {
  const report::ScratchFolder scratch(folder);
  std::vector<Drawing> drawings;
  for (const DrawnFigure& figure : figures) {
    plot::Script script((scratch.path() / fmt::format("{}.gp", figure.name)).string());
    figure.draw(script);
    drawings.push_back({figure.name, Drawing::svg});
    if (!pdf_folder.empty()) drawings.push_back({figure.name, Drawing::pdf});
  }
  run_gnuplot(scratch.path(), drawings);

  std::vector<std::string> written;
  for (const DrawnFigure& figure : figures) {
    const std::string svg = fmt::format("{}.svg", figure.name);
    const std::string pdf = fmt::format("{}.pdf", figure.name);
    const std::string script = fmt::format("{}.gp", figure.name);
    move_to(scratch.path() / script, fs::path(folder) / "plots" / script);
    move_to(scratch.path() / svg, fs::path(folder) / svg);
    if (!pdf_folder.empty()) move_to(scratch.path() / pdf, fs::path(pdf_folder) / pdf);
    written.push_back(svg);
  }
  return written;
}

}  // namespace boxbeam
