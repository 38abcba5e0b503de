#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "boxbeam/project/given_loads_case.hpp"
#include "boxbeam/report/export.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/beam_properties.hpp"
#include "csv_cells.hpp"

namespace boxbeam {
namespace {

using report::csv_cell;
using report::csv_row;

constexpr std::array cut_words{"N", "V_y", "V_z", "T", "M_y", "M_z"};

const char* unit_of(std::size_t which) { return which < cut_force::T ? "N" : "N m"; }

std::string cell(std::optional<double> value) { return value ? csv_cell(*value) : ""; }

/// The thicknesses of the plates of a box, of other profiles that of their wall.
struct Thicknesses {
  std::optional<double> top, bottom, left, right;
};

Thicknesses thicknesses_in(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile))
    return {box->top_flange.value(), box->bottom_flange.value(), box->left_web.value(),
            box->right_web.value()};
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double t = tube->wall.value();
    return {t, t, t, t};
  }
  if (const auto* tube = std::get_if<RoundTube>(&profile)) {
    const double t = tube->wall.value();
    return {t, t, t, t};
  }
  return {};
}

}  // namespace

std::string cut_forces_csv(const Verification& verification, const std::deque<SituationRun>& runs,
                           std::size_t& every) {
  std::size_t rows = 0;
  for (const SituationRun& run : runs) rows += run.loads.instants() * verification.stations.size();
  every = std::max<std::size_t>(1, (rows + spreadsheet_rows - 2) / (spreadsheet_rows - 1));
  std::string text = "situation,time [s],s [m],side";
  for (std::size_t k = 0; k < cut_words.size(); ++k)
    text += fmt::format(",{} [{}]", cut_words[k], unit_of(k));
  text += "\n";
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); i += every) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      for (const StationEnvelope& at : verification.stations) {
        const CutForces cut = diagram.at(at.station);
        text += csv_row({csv_cell(run.situation->name), csv_cell(run.loads.time_of(i).value()),
                         csv_cell(at.station.s.value()), to_text(at.station.side),
                         csv_cell(cut.N.value()), csv_cell(cut.V_y.value()),
                         csv_cell(cut.V_z.value()), csv_cell(cut.T.value()),
                         csv_cell(cut.M_y.value()), csv_cell(cut.M_z.value())});
      }
    }
  }
  return text;
}

std::string utilisation_csv(const Verification& verification) {
  std::vector<Criterion> judged;
  for (const Criterion criterion : criteria) {
    const bool any = std::any_of(
        verification.checks.begin(), verification.checks.end(),
        [&](const CheckResult& of) { return of.check.criterion == criterion && of.check.on_beam; });
    if (any) judged.push_back(criterion);
  }
  std::map<std::pair<double, Side>, std::map<Criterion, double>> along;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (!check.on_beam) continue;
    double& most = along[{check.station.s.value(), check.station.side}][check.criterion];
    most = std::max(most, check.utilisation());
  }
  std::string text = "s [m],side";
  for (const Criterion criterion : judged) text += fmt::format(",{}", to_text(criterion));
  text += ",worst\n";
  for (const auto& [station, by] : along) {
    std::vector<std::string> row{csv_cell(station.first), to_text(station.second)};
    double worst = 0.0;
    for (const Criterion criterion : judged) {
      const auto found = by.find(criterion);
      row.push_back(found == by.end() ? "" : csv_cell(found->second));
      if (found != by.end()) worst = std::max(worst, found->second);
    }
    row.push_back(csv_cell(worst));
    text += csv_row(row);
  }
  return text;
}

std::string checks_csv(const Verification& verification) {
  std::string text =
      "id,criterion,point,station [m],side,situation,time [s],acting,resisting,unit,safety_factor,"
      "required,utilisation,source,normal_stress [Pa],shear_stress [Pa]\n";
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    const auto stress = [&](const auto& part_of) {
      return result.basis ? csv_cell(part_of(result.basis->stress_at_time).value()) : "";
    };
    text += csv_row({csv_cell(check.id), to_text(check.criterion), csv_cell(check.point),
                     check.on_beam ? csv_cell(check.station.s.value()) : "",
                     check.on_beam ? to_text(check.station.side) : "", csv_cell(check.situation),
                     csv_cell(check.time.value()), csv_cell(check.acting.value()),
                     csv_cell(check.resisting.value()), check.acting.unit(),
                     csv_cell(check.safety_factor), csv_cell(check.required),
                     csv_cell(check.utilisation()), csv_cell(check.source),
                     stress([](const PointStress& of) { return of.normal; }),
                     stress([](const PointStress& of) { return of.shear; })});
  }
  return text;
}

std::string sections_csv(const Project& project, const Verification& verification) {
  std::string text =
      "s [m],side,profile,inner profile,A [m^2],I_y [m^4],I_z [m^4],I_yz [m^4],I_T [m^4],W_y [m^3],"
      "W_z [m^3],centroid y [m],centroid z [m],mass per length [kg/m],A net [m^2],I_y net [m^4],"
      "W_y net [m^3],width [m],height [m],top flange [m],bottom flange [m],left web [m],"
      "right web [m]\n";
  for (const StationProperties& at :
       station_properties_of(project, verification.stations, verification.checks)) {
    const Section section = section_at(project.beam, at.station);
    const SectionProperties& gross = at.gross;
    const std::optional<SecondMoment> I_T = torsion_properties_of(section).I_T;
    const Thicknesses plates = thicknesses_in(section.outer);
    text += csv_row({csv_cell(at.station.s.value()),
                     to_text(at.station.side),
                     to_text(section.outer),
                     section.inner ? to_text(*section.inner) : "",
                     csv_cell(gross.area.value()),
                     csv_cell(gross.I_y.value()),
                     csv_cell(gross.I_z.value()),
                     csv_cell(gross.I_yz.value()),
                     I_T ? csv_cell(I_T->value()) : "",
                     csv_cell(gross.W_y.value()),
                     csv_cell(gross.W_z.value()),
                     csv_cell(gross.centroid_y.value()),
                     csv_cell(gross.centroid_z.value()),
                     csv_cell((project.beam.density * gross.area).value()),
                     csv_cell(at.net.area.value()),
                     csv_cell(at.net.I_y.value()),
                     csv_cell(at.net.W_y.value()),
                     csv_cell((gross.y_left - gross.y_right).value()),
                     csv_cell((gross.z_top - gross.z_bottom).value()),
                     cell(plates.top),
                     cell(plates.bottom),
                     cell(plates.left),
                     cell(plates.right)});
  }
  return text;
}

std::vector<ExportedFile> given_loads_files(const Project& project, const LoadSamples& samples) {
  constexpr std::array in_plane{cut_force::N, cut_force::V_z, cut_force::M_y};
  std::vector<std::size_t> given{0, 1, 2, 3, 4, 5};
  if (!project.in_space) given.assign(in_plane.begin(), in_plane.end());
  GivenLoads loads;
  loads.held = samples.held;
  std::string head = "time [s]";
  for (std::size_t j = 0; j < samples.stations.size(); ++j) {
    GivenCut& cut = loads.cuts.emplace_back();
    cut.s = samples.stations[j].s;
    for (const std::size_t k : given) {
      cut.columns[k] = fmt::format("{} {}", cut_words[k], j + 1);
      head += fmt::format(",{} [{}]", cut.columns[k], unit_of(k));
    }
  }
  std::vector<ExportedFile> files(1);
  for (const SampledSituation& of : samples.situations) {
    ExportedFile& file = files.emplace_back();
    file.name = fmt::format("loads-{}.csv", files.size() - 1);
    file.content = head + "\n";
    for (std::size_t i = 0; i < of.times.size(); ++i) {
      file.content += csv_cell(of.times[i]);
      for (const CutForces& cut : of.at[i]) {
        for (const std::size_t k : given)
          file.content += "," + csv_cell(value_of(cut, static_cast<cut_force::Index>(k)));
      }
      file.content += "\n";
    }
    loads.files.push_back(file.name);
  }
  files.front() = {"loads.toml",
                   "# Written by boxbeam verify --export: the cut forces of the case stand for its "
                   "mechanism.\n\n" +
                       given_loads_case(project, loads)};
  return files;
}

std::vector<std::string> names_of_exports(const Project& project) {
  std::vector<std::string> names{"cut-forces.csv", "utilisation.csv",  "checks.csv",
                                 "sections.csv",   "loads.toml",       "beam.vtk",
                                 "beam.inp",       "beam-elements.csv"};
  for (std::size_t i = 1; i <= project.situations.size(); ++i)
    names.push_back(fmt::format("loads-{}.csv", i));
  return names;
}

}  // namespace boxbeam
