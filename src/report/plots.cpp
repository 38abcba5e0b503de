#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "boxbeam/core/error.hpp"
#include "gnuplot_process.hpp"
#include "plot_script.hpp"
#include "process.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

bool in_plane(const Project& project, const Verification&) { return !in_space(project); }

bool in_three_dimensions(const Project& project, const Verification&) { return in_space(project); }

bool is_driven(const Project&, const Verification& verification) {
  return verification.cycle && !verification.drivers.empty();
}

bool over_time(const Project&, const Verification& verification) {
  return verification.loads_over_time.has_value();
}

bool is_checked_along(const Project&, const Verification& verification) {
  return std::any_of(verification.checks.begin(), verification.checks.end(),
                     [](const CheckResult& result) { return result.basis.has_value(); });
}

bool has_section(const Project&, const Verification& verification) {
  return verification.section.has_value();
}

/// The worst check of a criterion rests on cut forces.
bool is_computed(const Verification& verification, Criterion criterion) {
  const CheckResult* governing = verification.governing(criterion);
  return governing != nullptr && governing->basis;
}

bool has_history(const Project&, const Verification& verification) {
  return is_computed(verification, Criterion::fatigue) ||
         is_computed(verification, Criterion::yield);
}

bool has_curve(const Project&, const Verification& verification) {
  return verification.sn.has_value();
}

bool has_several_ranges(const Project&, const Verification& verification) {
  return is_computed(verification, Criterion::fatigue) &&
         verification.governing(Criterion::fatigue)->basis->spectrum.size() > 1;
}

bool is_elastic(const Project&, const Verification& verification) {
  return verification.elastic && !verification.elastic->modes.empty();
}

bool vibrates(const Project&, const Verification& verification) {
  return verification.elastic && !verification.elastic->over_period.at.empty();
}

/// A figure that a report may have.
struct FigureKind {
  const char* name;
  bool (*shown)(const Project&, const Verification&);
  void (*draw)(plot::Script&, const Project&, const Verification&);
};

/// All of them, in the order of a report.
constexpr FigureKind kinds[] = {
    {"mechanism", in_plane, plot::mechanism},
    {"mechanism", in_three_dimensions, plot::mechanism_in_space},
    {"motion", is_driven, plot::motion},
    {"cut-forces", in_plane, plot::cut_forces},
    {"cut-forces", in_three_dimensions, plot::cut_forces_in_space},
    {"loads", over_time, plot::loads_over_time},
    {"utilisation", is_checked_along, plot::utilisation},
    {"section", has_section, plot::section},
    {"stress", has_history, plot::stress},
    {"sn", has_curve, plot::sn},
    {"spectrum", has_several_ranges, plot::spectrum},
    {"modes", is_elastic, plot::modes},
    {"frequency-response", vibrates, plot::frequency_response},
    {"joint-forces", vibrates, plot::joint_forces},
    {"sudden-start", vibrates, plot::sudden_start},
};

std::vector<FigureKind> kinds_of(const Project& project, const Verification& verification) {
  std::vector<FigureKind> shown;
  for (const FigureKind& kind : kinds) {
    if (kind.shown(project, verification)) shown.push_back(kind);
  }
  return shown;
}

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

std::vector<std::string> figures_of(const Project& project, const Verification& verification) {
  std::vector<std::string> names;
  for (const FigureKind& kind : kinds_of(project, verification)) names.emplace_back(kind.name);
  return names;
}

void remove_figures(const std::string& folder) {
  std::error_code ignored;
  for (const FigureKind& kind : kinds) {
    fs::remove(fs::path(folder) / fmt::format("{}.svg", kind.name), ignored);
    fs::remove(fs::path(folder) / "plots" / fmt::format("{}.gp", kind.name), ignored);
  }
}

std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder, const std::string& pdf_folder) {
  const report::ScratchFolder scratch(folder);
  const std::vector<FigureKind> shown = kinds_of(project, verification);
  std::vector<Drawing> drawings;
  for (const FigureKind& kind : shown) {
    plot::Script script((scratch.path() / fmt::format("{}.gp", kind.name)).string());
    kind.draw(script, project, verification);
    drawings.push_back({kind.name, Drawing::svg});
    if (!pdf_folder.empty()) drawings.push_back({kind.name, Drawing::pdf});
  }
  run_gnuplot(scratch.path(), drawings);

  std::vector<std::string> written;
  for (const FigureKind& kind : shown) {
    const std::string svg = fmt::format("{}.svg", kind.name);
    const std::string pdf = fmt::format("{}.pdf", kind.name);
    const std::string script = fmt::format("{}.gp", kind.name);
    move_to(scratch.path() / script, fs::path(folder) / "plots" / script);
    move_to(scratch.path() / svg, fs::path(folder) / svg);
    if (!pdf_folder.empty()) move_to(scratch.path() / pdf, fs::path(pdf_folder) / pdf);
    written.push_back(svg);
  }
  return written;
}

}  // namespace boxbeam
