#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawn_files.hpp"

namespace boxbeam {
namespace {

bool in_plane(const Project& project, const Verification&) { return !project.in_space; }

bool in_three_dimensions(const Project& project, const Verification&) { return project.in_space; }

bool is_driven(const Project&, const Verification& verification) {
  return !verification.pictures.cycles.empty() && !verification.pictures.drivers.empty();
}

bool over_time(const Project&, const Verification& verification) {
  return verification.pictures.loads_over_time.has_value();
}

bool is_checked_along(const Project&, const Verification& verification) {
  return std::any_of(verification.checks.begin(), verification.checks.end(),
                     [](const CheckResult& result) { return result.basis.has_value(); });
}

bool has_section(const Project&, const Verification& verification) {
  return verification.pictures.section.has_value();
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
  return verification.pictures.sn.has_value();
}

bool has_several_ranges(const Project&, const Verification& verification) {
  return is_computed(verification, Criterion::fatigue) &&
         verification.governing(Criterion::fatigue)->basis->spectrum.size() > 1;
}

bool is_elastic(const Project&, const Verification& verification) {
  return verification.pictures.elastic && !verification.pictures.elastic->modes.empty();
}

bool vibrates(const Project&, const Verification& verification) {
  return verification.pictures.elastic && !verification.pictures.elastic->over_period.at.empty();
}

/// A figure that a report may have.
struct FigureKind {
  const char* name;
  bool (*shown)(const Project&, const Verification&);
  void (*plot)(plot::Script&, const Project&, const Verification&);      ///< by gnuplot
  plot::Drawing (*draw)(const Project&, const Verification&) = nullptr;  ///< where gnuplot does not
};

/// All of them, in the order of a report.
constexpr FigureKind kinds[] = {
    {"mechanism", in_plane, nullptr, plot::mechanism},
    {"mechanism", in_three_dimensions, nullptr, plot::mechanism_in_space},
    {"motion", is_driven, plot::motion},
    {"cut-forces", in_plane, plot::cut_forces},
    {"cut-forces", in_three_dimensions, plot::cut_forces_in_space},
    {"loads", over_time, plot::loads_over_time},
    {"utilisation", is_checked_along, plot::utilisation},
    {"section", has_section, nullptr, plot::section},
    {"stress", has_history, plot::stress},
    {"sn", has_curve, plot::sn},
    {"spectrum", has_several_ranges, plot::spectrum},
    {"modes", is_elastic, nullptr, plot::modes},
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

}  // namespace

std::vector<std::string> figures_of(const Project& project, const Verification& verification) {
  std::vector<std::string> names;
  for (const FigureKind& kind : kinds_of(project, verification)) names.emplace_back(kind.name);
  return names;
}

std::vector<std::string> files_of_figures() {
  std::vector<std::string> files;
  for (const FigureKind& kind : kinds) {
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
