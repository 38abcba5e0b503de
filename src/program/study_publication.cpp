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
constexpr const char* statistics_name = "statistics.json";
constexpr std::string_view of_statistics = "# ";  // begins the line behind the rows of a chunk

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

/// All columns but the number of the design and its status.
std::vector<Column> counted_columns(const Manifest& manifest) {
  return {manifest.columns.begin() + 1, manifest.columns.end() - 1};
}

constexpr std::size_t unlike_numbers = 1U << 14U;

/// What is known of no design yet.
StudyStatistics no_statistics(const Manifest& manifest, std::size_t most = unlike_numbers) {
  return {counted_columns(manifest), manifest.variables, manifest.scatters, manifest.indices, most};
}

void take_row(StudyStatistics& statistics, std::string_view row) {
  const std::vector<std::string> cells = cells_in(row);
  statistics.take({cells.begin() + 1, cells.end() - 1}, cells.back());
}

/// Hands on each line of a text, without its end.
template <class Take>
void each_line(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Writes the rows of all chunks below their names, and gathers what they come to.
StudyStatistics join_rows(const Manifest& manifest, const RowsOfChunk& rows_of, std::ostream& rows,
                          std::size_t& kept) {
  StudyStatistics statistics = no_statistics(manifest);
  rows << header_of(manifest);
  for (std::size_t chunk = 0; chunk < manifest.chunks(); ++chunk) {
    StudyStatistics of_chunk = no_statistics(manifest);
    each_line(rows_of(chunk), [&](std::string_view line) {
      if (line.starts_with(of_statistics)) {
        of_chunk.take_text(std::string(line.substr(of_statistics.size())));
        return;
      }
      if (manifest.keep.empty()) take_row(of_chunk, line);
      rows << line << '\n';
      ++kept;
    });
    statistics.take(of_chunk);
  }
  return statistics;
}

/// Those of a table that are shown.
DesignRows shown_rows(const Manifest& manifest, const std::string& table, std::size_t kept) {
  DesignSample sample(counted_columns(manifest), manifest.variables, kept, manifest.seed);
  std::ifstream rows(table, std::ios::binary);
  std::string row;
  std::getline(rows, row);  // the names
  for (std::size_t place = 0; std::getline(rows, row); ++place) {
    if (!sample.wants(place)) continue;
    const std::vector<std::string> cells = cells_in(row);
    sample.take(std::stoull(cells.front()), {cells.begin() + 1, cells.end() - 1}, cells.back());
  }
  DesignRows shown = sample.rows();
  shown.scatters = manifest.scatters && manifest.keep.empty();
  return shown;
}

}  // namespace

ChunkRows::ChunkRows(const Manifest& manifest)
    : filters_(!manifest.keep.empty()),
      // Few, for else that line would be as long as the rows that it stands for.
      statistics_(no_statistics(manifest, 1U << 9U)) {}

void ChunkRows::take(const StudyDesigns::Row& row) {
  if (filters_) take_row(statistics_, std::string_view(row.text).substr(0, row.text.size() - 1));
  if (row.kept) rows_.push_back(row.text);
}

std::vector<std::string> ChunkRows::lines() && {
  if (filters_) rows_.push_back(fmt::format("{}{}\n", of_statistics, statistics_.text()));
  return std::move(rows_);
}

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
              {},
              study.keep};
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
  if (!of.keep.empty()) json["keep"] = of.keep;
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
                json.at("variables"),    json.at("scatters"), {},
                json.value("keep", "")};
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
  summary.keep = manifest.keep;
  report::FolderUpdate update(folder);
  const std::string path = update.path() + "/" + rows_name;
  std::ofstream rows(path, std::ios::binary);
  const StudyStatistics statistics = join_rows(manifest, rows_of, rows, summary.kept);
  rows.close();
  if (!rows) throw OutputError(update.in_place(path) + " cannot be written: the disk may be full");
  statistics.put_into(summary);
  summary.rows_sha256 = sha256_of_file(path);
  if (!manifest.keep.empty()) {
    published.files.emplace_back(statistics_name);
    const std::string file = update.path() + "/" + statistics_name;
    write_file(file, statistics.text() + "\n");
    summary.statistics_sha256 = sha256_of_file(file);
  }
  write_file(update.path() + "/" + summary_name, study_json(summary));
  if (netcdf) {
    published.files.emplace_back("rows.nc");
    write_column_file(update.path() + "/rows.nc", path, manifest.columns, summary);
  }
  const DesignRows shown = shown_rows(manifest, path, summary.kept);
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
  const auto is_as_it_was = [&](const char* key, const char* name) {
    return says(key, sha256_of_file((fs::path(folder) / name).string()));
  };
  return says("input_sha256", manifest.sha256) && says("version", manifest.version) &&
         says("designs", manifest.designs) && says("seed", manifest.seed) &&
         is_as_it_was("rows_sha256", rows_name) &&
         (manifest.keep.empty() || is_as_it_was("statistics_sha256", statistics_name));
}

RowsOfChunk rows_that_stand(const Manifest& manifest, const std::string& folder) {
  const auto file = std::make_shared<std::ifstream>(fs::path(folder) / rows_name, std::ios::binary);
  const auto next = std::make_shared<std::string>();
  std::getline(*file, *next);  // the names
  std::getline(*file, *next);
  return [file, next, folder, &manifest](std::size_t chunk) {
    std::string rows;
    const std::size_t behind = (chunk + 1) * manifest.chunk;
    while (!next->empty() && std::stoull(*next) <= behind) {
      rows += *next + "\n";
      if (!std::getline(*file, *next)) next->clear();
    }
    if (chunk > 0 || manifest.keep.empty()) return rows;
    std::ifstream statistics(fs::path(folder) / statistics_name, std::ios::binary);
    std::string line;
    std::getline(statistics, line);
    return rows + std::string(of_statistics) + line + "\n";
  };
}

}  // namespace boxbeam::program
