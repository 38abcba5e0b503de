#include "drawn_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "drawing_forms.hpp"
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

std::vector<std::string> draw_into(const std::string& folder, const std::string& tex_folder,
                                   const std::vector<DrawnFigure>& figures) {
  const report::ScratchFolder scratch(folder);
  std::vector<std::string> scripts;
  for (const DrawnFigure& figure : figures) {
    const auto* write = std::get_if<0>(&figure.draw);
    if (write == nullptr) continue;
    plot::Script script((scratch.path() / fmt::format("{}.gp", figure.name)).string());
    (*write)(script);
    scripts.push_back(figure.name);
  }
  run_gnuplot(scratch.path(), scripts);

  for (const DrawnFigure& figure : figures) {
    const fs::path file = scratch.path() / fmt::format("{}.svg", figure.name);
    const auto* draw = std::get_if<1>(&figure.draw);
    const plot::Drawing drawing =
        draw != nullptr ? (*draw)() : plot::drawing_of_gnuplot(content_of(file));
    write_file(file.string(), plot::svg_of(drawing));
    write_file((scratch.path() / fmt::format("{}.tex", figure.name)).string(),
               plot::latex_of(drawing));
  }
  std::vector<std::string> written;
  const auto take = [&](const std::string& name, const fs::path& to) {
    move_to(scratch.path() / name, to / name);
  };
  for (const std::string& name : scripts) take(name + ".gp", fs::path(folder) / "plots");
  for (const DrawnFigure& figure : figures) {
    if (!tex_folder.empty()) take(figure.name + ".tex", tex_folder);
    take(figure.name + ".svg", folder);
    written.push_back(figure.name + ".svg");
  }
  return written;
}

}  // namespace boxbeam
