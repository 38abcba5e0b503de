#include "program/study_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/report/result_book.hpp"
#include "boxbeam/study/case_keys.hpp"
#include "boxbeam/study/named_expression.hpp"
#include "boxbeam/study/written_quantity.hpp"
#include "report/csv_cells.hpp"

namespace boxbeam::program {
namespace {

/// Columns that are no numbers.
bool is_of_verdict(const std::string& column) {
  return column == "verdict" || column == "governing";
}

std::string cell_of(const std::string& column, const std::vector<VerifiedBeam>& beams,
                    const std::optional<ResultBook>& book) {
  const Verification& worst = worst_of(beams).verification;
  const bool checked = !worst.checks.empty();
  if (column == "verdict") return to_text(worst.verdict);
  if (column == "governing") return checked ? report::csv_cell(worst.checks.front().check.id) : "";
  const ResultValue* const value = book->find(column);
  return value != nullptr ? report::csv_cell(value->value) : "";
}

}  // namespace

CaseOptions case_of(const Study& study) {
  CaseOptions options;
  options.file = study.case_file;
  return options;
}

StudyDesigns::StudyDesigns(const Study& study)
    : study_(&study), space_(study), trials_(case_of(study)) {
  columns_ = {{"design", ""}};
  for (const Variable& variable : study.variables)
    columns_.push_back({variable.name, variable.unit});
  for (const std::string& column : study.columns) columns_.push_back({column, ""});
  columns_.push_back({"status", ""});
  if (!study.keep.empty()) keep_names_ = names_in(study.keep);
  for (const std::string& name : keep_names_)
    keep_columns_.push_back(static_cast<std::size_t>(
        std::find_if(columns_.begin(), columns_.end(),
                     [&](const Column& column) { return column.name == name; }) -
        columns_.begin()));
  if (study.case_file.empty()) {
    require_no_keys();
    sha256_ = sha256_of(study.text);
    return;
  }
  require_keys();
  const std::vector<Project> beams = read_beams_of(case_of(study));
  sha256_ = sha256_of(study.text + "\n" + beams.front().sha256);
  require_columns();
}

void StudyDesigns::require_no_keys() const {
  for (const Variable& variable : study_->variables)
    if (!variable.keys.empty())
      throw InputError(fmt::format("{}: \"{}\" is a key of a case, but the study has none",
                                   study_->path, variable.name),
                       "write case = \"rig.toml\" in [study]");
}

void StudyDesigns::require_keys() const {
  const CaseDocument document = read_document(study_->case_file, {});
  std::vector<std::vector<std::string>> designs;
  for (const std::size_t index : {std::size_t{0}, space_.size() - 1})
    // An expression may have no value there; that design's row says it.
    trouble_of([&] { designs.push_back(space_.overrides(space_.at(index))); });
  if (designs.empty()) return;
  const auto read = [&](const std::vector<std::string>& set) {
    CaseOptions with = case_of(*study_);
    with.set = set;
    read_beams_of(with);
  };
  auto setting = designs.front().begin();
  for (const Variable& variable : study_->variables)
    for (const std::string& key : variable.keys) {
      const std::string value = (setting++)->substr(key.size() + 1);
      if (const auto trouble = trouble_with_key(document, key, value, designs, read))
        throw InputError(
            fmt::format("{}: variable {}: {}", study_->path, variable.name, trouble->what),
            trouble->hint);
    }
}

/// A column that the case has not may be one of a design: its first and last are asked.
void StudyDesigns::require_columns() {
  std::vector<std::string> unknown;
  for (const std::string& column : study_->columns)
    if (!is_of_verdict(column)) unknown.push_back(column);
  std::optional<ResultBook> first;
  const auto look_at = [&](const std::vector<std::string>& set) {
    if (unknown.empty()) return;
    trouble_of([&] {
      const ResultBook book = results_of(trials_.verify(set).beams);
      std::erase_if(unknown, [&](const std::string& key) {
        const ResultValue* const value = book.find(key);
        if (value == nullptr) return false;
        for (Column& column : columns_)
          if (column.name == key && value->unit != "1") column.unit = value->unit;
        return true;
      });
      if (!first) first = book;
    });
  };
  look_at({});
  for (const std::size_t index : {std::size_t{0}, space_.size() - 1})
    trouble_of([&] { look_at(space_.overrides(space_.at(index))); });
  if (unknown.empty() || !first) return;
  throw InputError(fmt::format("{}: there is no result \"{}\"", study_->path, unknown.front()),
                   first->hint_for(unknown.front()));
}

/// The results of a design as cells.
std::vector<std::string> StudyDesigns::results_of_design(const std::vector<Setting>& design) const {
  std::vector<std::string> results;
  if (study_->case_file.empty()) {
    std::vector<std::string> names;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < design.size(); ++i) {
      if (!study_->variables[i].words.empty()) continue;
      names.push_back(study_->variables[i].name);
      numbers.push_back(design[i].number);
    }
    for (std::size_t k = 0; k < study_->formulas.size(); ++k) {
      const double value = NamedExpression(study_->formulas[k], names).at(numbers);
      if (!std::isfinite(value))
        throw AnalysisError({fmt::format("\"{}\" has no finite value", study_->formulas[k]),
                             "column " + study_->columns[k]});
      results.push_back(report::csv_cell(value));
    }
    return results;
  }
  const VerifiedDesign found = trials_.verify(space_.overrides(design));
  const std::vector<VerifiedBeam>& beams = found.beams;
  const bool numbers = !std::all_of(study_->columns.begin(), study_->columns.end(), is_of_verdict);
  const std::optional<ResultBook> book =
      numbers ? std::optional(results_of(beams, study_->columns)) : std::nullopt;
  for (const std::string& column : study_->columns) results.push_back(cell_of(column, beams, book));
  return results;
}

/// A design that the condition cannot judge stays.
bool StudyDesigns::keeps(const std::vector<std::string>& cells) const {
  if (study_->keep.empty()) return true;
  std::vector<double> numbers;
  for (const std::size_t column : keep_columns_) {
    const std::optional<double> number = number_of_cell(cells[column]);
    if (!number) return true;
    numbers.push_back(*number);
  }
  return NamedExpression(study_->keep, keep_names_).at(numbers) != 0.0;
}

StudyDesigns::Row StudyDesigns::row(std::size_t index) const {
  std::vector<std::string> cells{std::to_string(index + 1)};
  std::vector<std::string> results(study_->columns.size());
  std::vector<std::string> values(study_->variables.size());
  Row row;
  std::string status = trouble_of([&] {
    const std::vector<Setting> design = space_.at(index);
    for (std::size_t i = 0; i < design.size(); ++i)
      values[i] = study_->variables[i].words.empty() ? report::csv_cell(design[i].number)
                                                     : report::csv_cell(design[i].word);
    results = results_of_design(design);
  });
  row.failed = !status.empty();
  if (row.failed) results.assign(study_->columns.size(), "");
  cells.insert(cells.end(), values.begin(), values.end());
  cells.insert(cells.end(), results.begin(), results.end());
  cells.push_back(row.failed ? report::csv_cell(status) : "ok");
  row.kept = row.failed || keeps(cells);
  row.text = report::csv_row(cells);
  return row;
}

}  // namespace boxbeam::program
