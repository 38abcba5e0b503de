#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "boxbeam/core/error.hpp"
#include "gnuplot_process.hpp"
#include "plot_script.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

struct Figure {
  std::string name;
  std::function<void(plot::Script&)> draw;
};

}  // namespace

void remove_figures(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {"cut-forces", "mechanism", "modes", "frequency-response", "joint-forces",
                           "sudden-start", "loads", "stress", "sn"}) {
    fs::remove(fs::path(folder) / fmt::format("{}.svg", name), ignored);
    fs::remove(fs::path(folder) / "plots" / fmt::format("{}.gp", name), ignored);
  }
}

std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder,
                                      [[maybe_unused]] const std::string& pdf_folder) {
  std::vector<Figure> figures;
  const auto add = [&](const char* name, auto draw) {
    figures.push_back({name, [&, draw](plot::Script& gp) { draw(gp, project, verification); }});
  };
  const bool space = in_space(project);
  add("cut-forces", space ? plot::cut_forces_in_space : plot::cut_forces);
  add("mechanism", space ? plot::mechanism_in_space : plot::mechanism);
  if (verification.elastic) {
    add("modes", plot::modes);
    if (!verification.elastic->over_period.at.empty()) {
      add("frequency-response", plot::frequency_response);
      add("joint-forces", plot::joint_forces);
      add("sudden-start", plot::sudden_start);
    }
  }
  if (verification.loads_over_time) add("loads", plot::loads_over_time);
  if (project.given_stresses.empty()) add("stress", plot::stress);
  if (verification.sn) add("sn", plot::sn);

  const ScratchFolder scratch(folder);
  std::vector<std::string> names;
  for (const Figure& figure : figures) {
    {
      plot::Script script((scratch.path() / (figure.name + ".gp")).string());
      figure.draw(script);
    }
    names.push_back(figure.name);
  }
  run_gnuplot(scratch.path(), names);

  std::vector<std::string> written;
  std::error_code error;
  fs::create_directories(fs::path(folder) / "plots", error);
  for (const Figure& figure : figures) {
    const std::string script = "plots/" + figure.name + ".gp";
    const std::string drawing = figure.name + ".svg";
    fs::rename(scratch.path() / (figure.name + ".gp"), fs::path(folder) / script, error);
    if (!error) fs::rename(scratch.path() / drawing, fs::path(folder) / drawing, error);
    if (error)
      throw OutputError(
          fmt::format("{}/{} cannot be written: {}", folder, drawing, error.message()));
    written.push_back(drawing);
  }
  return written;
}

}  // namespace boxbeam
