#include "program/study_publication.hpp"

#include <fmt/format.h>
#include <sha256.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/study_document.hpp"
#include "boxbeam/report/study_report.hpp"
#include "program/column_file.hpp"
#include "program/outputs.hpp"
#include "report/csv_cells.hpp"
#include "report/folder_update.hpp"
#include "version.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* rows_name = "rows.csv";
constexpr const char* summary_name = "study.json";

/// "" where it cannot be read.
std::string sha256_of_file(const std::string& path) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digest{};
  return SHA256File(path.c_str(), digest.data()) == nullptr ? "" : digest.data();
}

std::string header_of(const Manifest& manifest) {
  std::vector<std::string> cells;
  for (const Column& column : manifest.columns) cells.push_back(report::csv_cell(column.name));
  return report::csv_row(cells);
}

}  // namespace

std::size_t Manifest::rows_in(std::size_t of) const {
  return std::min(chunk, designs - of * chunk);
}

Manifest manifest_of(const Study& study, const StudyDesigns& designs, std::size_t chunk) {
  Manifest of{study.name,
              fs::path(study.path).filename().string(),
              study.case_written,
              designs.sha256(),
              version,
              study.seed,
              designs.size(),
              chunk,
              designs.columns(),
              study.variables.size(),
              false,
              {}};
  const auto has_several = [](const Variable& variable) {
    return variable.values.size() + variable.words.size() > 1;
  };
  of.scatters =
      std::none_of(study.variables.begin(), study.variables.end(), has_several) &&
      std::any_of(study.variables.begin(), study.variables.end(),
                  [](const Variable& variable) { return variable.distribution.has_value(); });
  if (!study.indices) return of;
  of.indices = IndexPlan{{}, study.indices->resamples, study.seed};
  for (const Variable& variable : study.variables)
    if (variable.distribution) of.indices->variables.push_back(variable.name);
  return of;
}

std::string to_json(const Manifest& of) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const Column& column : of.columns)
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  nlohmann::ordered_json json{{"schema", "boxbeam.chunks/1"},
                              {"name", of.name},
                              {"study", of.study_file},
                              {"case", of.case_file},
                              {"input_sha256", of.sha256},
                              {"version", of.version},
                              {"seed", of.seed},
                              {"designs", of.designs},
                              {"chunk", of.chunk},
                              {"variables", of.variables},
                              {"scatters", of.scatters},
                              {"columns", columns}};
  if (of.indices)
    json["indices"] = {{"variables", of.indices->variables}, {"resamples", of.indices->resamples}};
  return json.dump(2) + "\n";
}

Manifest manifest_in(const std::string& text, const std::string& folder) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    Manifest of{json.at("name"),         json.at("study"),    json.at("case"),
                json.at("input_sha256"), json.at("version"),  json.at("seed"),
                json.at("designs"),      json.at("chunk"),    {},
                json.at("variables"),    json.at("scatters"), {}};
    for (const nlohmann::json& column : json.at("columns"))
      of.columns.push_back({column.at("name"), column.at("unit")});
    if (json.contains("indices"))
      of.indices = IndexPlan{json.at("indices").at("variables"), json.at("indices").at("resamples"),
                             of.seed};
    if (of.chunk == 0) throw InputError("");
    return of;
  } catch (const std::exception&) {
    throw InputError(fmt::format("{}/chunks/manifest.json is none of boxbeam sweep", folder));
  }
}

PublishedStudy publish_study(const Manifest& manifest, const std::string& folder, bool netcdf,
                             const RowsOfChunk& rows_of) {
  PublishedStudy published{{}, {rows_name, summary_name}};
  StudySummary& summary = published.summary;
  summary.name = manifest.name;
  summary.study_file = manifest.study_file;
  summary.case_file = manifest.case_file;
  summary.sha256 = manifest.sha256;
  summary.version = manifest.version;
  summary.seed = manifest.seed;
  const std::vector<Column>& columns = manifest.columns;
  const std::vector<Column> counted(columns.begin() + 1, columns.end() - 1);
  StudyStatistics statistics(counted, manifest.variables, manifest.scatters, manifest.indices);
  DesignSample sample(counted, manifest.variables, manifest.designs, manifest.seed);
  report::FolderUpdate update(folder);
  const std::string path = update.path() + "/" + rows_name;
  std::ofstream rows(path, std::ios::binary);
  rows << header_of(manifest);
  for (std::size_t chunk = 0; chunk < manifest.chunks(); ++chunk) {
    const std::string text = rows_of(chunk);
    rows << text;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = text.find('\n', from);
      const std::vector<std::string> cells =
          cells_in(std::string_view(text).substr(from, end - from));
      from = end + 1;
      const std::vector<std::string> of_design(cells.begin() + 1, cells.end() - 1);
      statistics.take(of_design, cells.back());
      sample.take(of_design, cells.back());
    }
  }
  rows.close();
  if (!rows) throw OutputError(update.in_place(path) + " cannot be written: the disk may be full");
  statistics.put_into(summary);
  summary.rows_sha256 = sha256_of_file(path);
  write_file(update.path() + "/" + summary_name, study_json(summary));
  if (netcdf) {
    published.files.emplace_back("rows.nc");
    write_column_file(update.path() + "/rows.nc", path, columns, summary);
  }
  DesignRows shown = sample.rows();
  shown.scatters = manifest.scatters;
  for (std::string& figure : draw_study(summary, shown, update.path()))
    published.files.push_back(std::move(figure));
  published.files.push_back(
      write_page("study.html", study_document(summary, shown), update.path()));
  std::vector<std::string> earlier = files_of_study();
  earlier.insert(earlier.end(), published.files.begin(), published.files.end());
  update.publish(earlier);
  return published;
}

bool stands_whole(const Manifest& manifest, const std::string& folder) {
  std::ifstream file(fs::path(folder) / summary_name, std::ios::binary);
  if (!file) return false;
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("schema", "") != "boxbeam.study/1") return false;
  const auto says = [&](const char* key, const nlohmann::json& value) {
    return json.contains(key) && json.at(key) == value;
  };
  return says("input_sha256", manifest.sha256) && says("version", manifest.version) &&
         says("designs", manifest.designs) && says("seed", manifest.seed) &&
         says("rows_sha256", sha256_of_file((fs::path(folder) / rows_name).string()));
}

RowsOfChunk rows_that_stand(const Manifest& manifest, const std::string& folder) {
  const auto file = std::make_shared<std::ifstream>(fs::path(folder) / rows_name, std::ios::binary);
  std::string row;
  std::getline(*file, row);  // the names
  return [file, &manifest](std::size_t chunk) {
    std::string rows, one;
    for (std::size_t i = 0; i < manifest.rows_in(chunk) && std::getline(*file, one); ++i)
      rows += one + "\n";
    return rows;
  };
}

}  // namespace boxbeam::program
