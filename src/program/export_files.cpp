#include "program/export_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/given_loads_case.hpp"
#include "boxbeam/report/export.hpp"
#include "boxbeam/report/files.hpp"
#include "report/folder_update.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

/// Files of earlier exports in a folder: those that this case can have, and tables of loads by
/// their numbers.
std::vector<std::string> earlier_files(const Project& project, const std::string& folder) {
  std::vector<std::string> names = names_of_exports(project);
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string number = name.starts_with("loads-") && name.ends_with(".csv")
                                   ? name.substr(6, name.size() - 10)
                                   : "";
    const bool numbered =
        !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
    if (numbered && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  return names;
}

/// The worst check of a criterion but of what forces do where they come in: cut forces do not say
/// how and where between their stations that is.
const CheckResult* worst_in_sections(const Verification& of, Criterion criterion) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion != criterion || result.patch || result.pressed) continue;
    if (worst == nullptr || result.check.utilisation() > worst->check.utilisation())
      worst = &result;
  }
  return worst;
}

/// The largest relative difference of the governing factors of two verifications; infinite where
/// one of them judges what the other does not.
double difference_of(const Verification& a, const Verification& b) {
  double largest = 0.0;
  for (const Criterion criterion : criteria) {
    const CheckResult *const of = worst_in_sections(a, criterion), *const other = worst_in_sections(
                                                                       b, criterion);
    if (of == nullptr && other == nullptr) continue;
    if (of == nullptr || other == nullptr) return INFINITY;
    largest = std::max(largest, std::abs(other->check.safety_factor / of->check.safety_factor - 1));
  }
  return largest;
}

class Exporter {
 public:
  Exporter(const Project& project, const Verification& verification, const std::string& folder)
      : project_(&project), verification_(&verification), folder_(folder), update_(folder) {}

  Exported run() {
    const std::deque<SituationRun> runs = run_situations(*project_, verification_->model.chosen);
    write_tables(runs);
    write_loads(runs);
    if (const auto shown = governing_loads(*project_, runs, *verification_)) {
      write_shapes(*shown);
    } else {
      leave_out("beam.vtk and beam.inp are not written: no check rests on cut forces");
    }
    update_.publish(earlier_files(*project_, folder_));
    return std::move(exported_);
  }

 private:
  void say(std::string words) { exported_.said.push_back(std::move(words)); }
  void leave_out(std::string words) { exported_.left_out.push_back(std::move(words)); }

  void write(const std::string& name, const std::string& content) {
    write_file(update_.path() + "/" + name, content);
    exported_.written.push_back(name);
  }

  void write_tables(const std::deque<SituationRun>& runs) {
    std::size_t every = 1;
    write("cut-forces.csv", cut_forces_csv(*verification_, runs, every));
    if (every > 1) {
      leave_out(fmt::format("cut-forces.csv has one instant of {}: a spreadsheet holds {} rows",
                            every, spreadsheet_rows));
    }
    write("utilisation.csv", utilisation_csv(*verification_));
    write("checks.csv", checks_csv(*verification_));
    write("sections.csv", sections_csv(*project_, *verification_));
  }

  void write_loads(const std::deque<SituationRun>& runs) {
    const std::vector<std::string> obstacles = obstacles_to_given_loads(*project_);
    if (!obstacles.empty())
      return leave_out(fmt::format("loads.toml is not written: {}", fmt::join(obstacles, "; ")));
    const LoadSamples samples = sample_loads(*project_, runs, *verification_);
    if (samples.slides) {
      return leave_out(
          "loads.toml is not written: a load slides along the beam, and no stations can follow it");
    }
    const std::vector<ExportedFile> files = given_loads_files(*project_, samples);
    for (const ExportedFile& file : files)
      write_file(update_.path() + "/" + file.name, file.content);
    const std::string trouble = trouble_with(samples);
    if (trouble.empty()) {
      for (const ExportedFile& file : files) exported_.written.push_back(file.name);
      return;
    }
    for (const ExportedFile& file : files) fs::remove(update_.path() + "/" + file.name);
    leave_out("loads.toml is not written: " + trouble);
  }

  /// Verifies the case of loads as it stands there, and says how well it agrees. Returns why it is
  /// no such case.
  std::string trouble_with(const LoadSamples& samples) {
    try {
      const Verification other = verify(read_project(update_.path() + "/loads.toml"));
      const double apart = difference_of(*verification_, other);
      if (!std::isfinite(apart)) return "it would not be judged by the same criteria";
      if (other.verdict != verification_->verdict) {
        return fmt::format("its verdict would be \"{}\" and not \"{}\"", to_text(other.verdict),
                           to_text(verification_->verdict));
      }
      say(fmt::format(
          "loads.toml, verified: the same verdict, governing safety factors within {:.2g} "
          "(relative); between its stations and instants forces within {:.2g} and moments within "
          "{:.2g} of the largest",
          apart, samples.error.force, samples.error.moment));
      return "";
    } catch (const InputError& error) {
      return update_.in_place(error.problems().front().message);
    } catch (const AnalysisError& error) {
      return error.what();
    }
  }

  void write_shapes(const ShownLoads& shown) {
    const BeamLoads loads = shown.run->loads.loads_at(shown.time);
    const CutForceDiagram diagram = cut_forces_of(loads);
    const std::string title =
        fmt::format("{}: t = {:.6g} s{}, governing check {}", project_->name, shown.time.value(),
                    shown.run->situation->name.empty() ? "" : " of " + shown.run->situation->name,
                    shown.check->check.id);
    const PlateField field = plate_field_of(*project_, diagram);
    write("beam.vtk", plates_vtk(field, title));
    if (!field.left_out.empty())
      leave_out(fmt::format("plates not in beam.vtk: {}", fmt::join(field.left_out, ", ")));
    const std::string obstacle = obstacle_to_shells(*project_);
    if (!obstacle.empty()) return leave_out("beam.inp not exported: " + obstacle);
    const ShellModel model = shell_model_of(*project_, loads, diagram);
    write("beam.inp", shells_inp(model, *project_, title));
    write("beam-elements.csv", shells_csv(model));
    for (const std::string& words : model.simplified) say("beam.inp: " + words);
  }

  const Project* project_;
  const Verification* verification_;
  std::string folder_;
  report::FolderUpdate update_;
  Exported exported_;
};

}  // namespace

Exported export_files(const Project& project, const Verification& verification,
                      const std::string& folder) {
  return Exporter(project, verification, folder).run();
}

}  // namespace boxbeam::program
