#include "boxbeam/study/study_summary.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "simulations.hpp"

namespace boxbeam {

std::vector<std::string> cells_in(std::string_view row) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char c = row[i];
    if (quoted && c == '"' && i + 1 < row.size() && row[i + 1] == '"')
      cells.back() += row[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

std::optional<double> number_of_cell(std::string_view cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

StudyStatistics::StudyStatistics(std::vector<Column> columns, std::size_t variables, bool scatters,
                                 std::optional<IndexPlan> plan, std::size_t most)
    : columns_(std::move(columns)),
      variables_(variables),
      scatters_(scatters),
      plan_(std::move(plan)),
      most_(most),
      numbers_(columns_.size(), Numbers{0.0, 0.0, NumberCounts(most)}),
      of_designs_(columns_.size()) {}

void StudyStatistics::take(const std::vector<std::string>& cells, const std::string& status) {
  ++designs_;
  if (plan_)
    for (std::size_t k = variables_; k < cells.size(); ++k)
      of_designs_[k].push_back(
          number_of_cell(cells[k]).value_or(std::numeric_limits<double>::quiet_NaN()));
  if (status != "ok") {
    ++failed_;
    count_reason(status, 1);
    return;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (columns_[k].name == "verdict") {
      ++verdicts_[cells[k]];
      continue;
    }
    const std::optional<double> number = number_of_cell(cells[k]);
    if (!number || !std::isfinite(*number)) continue;
    // Welford's recurrence, in the order of the designs.
    Numbers& of = numbers_[k];
    of.counts.add(*number);
    const double apart = *number - of.mean;
    of.mean += apart / static_cast<double>(of.counts.count());
    of.squares += apart * (*number - of.mean);
  }
}

/// Means and squares by Chan, Golub, LeVeque, The American Statistician 37 (1983).
void StudyStatistics::join(Numbers& numbers, const Numbers& next) {
  const auto before = static_cast<double>(numbers.counts.count());
  const auto behind = static_cast<double>(next.counts.count());
  numbers.counts.add(next.counts);
  if (behind == 0.0) return;
  if (before == 0.0) {
    numbers.mean = next.mean;
    numbers.squares = next.squares;
    return;
  }
  const double apart = next.mean - numbers.mean, share = behind / (before + behind);
  numbers.mean += apart * share;
  numbers.squares += next.squares + apart * apart * before * share;
}

void StudyStatistics::take(const StudyStatistics& next) {
  designs_ += next.designs_;
  failed_ += next.failed_;
  for (const auto& [verdict, count] : next.verdicts_) verdicts_[verdict] += count;
  for (const auto& [reason, count] : next.reasons_) count_reason(reason, count);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    join(numbers_[k], next.numbers_[k]);
    of_designs_[k].insert(of_designs_[k].end(), next.of_designs_[k].begin(),
                          next.of_designs_[k].end());
  }
}

void StudyStatistics::count_reason(const std::string& reason, std::size_t count) {
  constexpr std::size_t most = 1000;
  if (reasons_.size() < most || reasons_.count(reason) > 0) reasons_[reason] += count;
}

ColumnStatistics StudyStatistics::statistics_of(std::size_t column) const {
  const auto& [mean, squares, counts] = numbers_[column];
  ColumnStatistics of;
  of.column = columns_[column];
  of.count = counts.count();
  of.mean = mean;
  of.sd = of.count > 1 ? std::sqrt(squares / static_cast<double>(of.count - 1)) : 0.0;
  constexpr std::array shares{0.0, 0.05, 0.5, 0.95, 1.0};
  for (std::size_t k = 0; k < shares.size(); ++k) of.quantiles[k] = counts.quantile(shares[k]);
  of.quantile_error = counts.error();
  constexpr std::size_t parts = 20;
  of.histogram = counts.parts(parts);
  return of;
}

void StudyStatistics::put_into(StudySummary& summary) const {
  summary.designs = designs_;
  summary.failed = failed_;
  summary.verdicts = verdicts_;
  summary.reasons = reasons_;
  for (std::size_t k = 0; k < columns_.size(); ++k)
    if (numbers_[k].counts.count() > 0) summary.statistics.push_back(statistics_of(k));
  if (scatters_ && !plan_ && !verdicts_.empty()) {
    const auto passing = verdicts_.find("pass");
    const std::size_t failing = designs_ - (passing == verdicts_.end() ? 0 : passing->second);
    const Estimate share = share_estimate(designs_, failing);
    summary.p_f = BoundedEstimate{share.p_f, share.low, share.high};
  }
  if (!plan_) return;
  summary.index_variables = plan_->variables;
  for (std::size_t k = variables_; k < columns_.size(); ++k)
    if (numbers_[k].counts.count() > 0)
      summary.indices.push_back({columns_[k], sobol_indices_of(of_designs_[k], *plan_)});
}

std::string StudyStatistics::text() const {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const Numbers& of : numbers_)
    columns.push_back(
        {fmt::format("{}", of.mean), fmt::format("{}", of.squares), of.counts.text()});
  return nlohmann::ordered_json{{"designs", designs_},
                                {"failed", failed_},
                                {"verdicts", verdicts_},
                                {"reasons", reasons_},
                                {"columns", columns}}
      .dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

void StudyStatistics::take_text(const std::string& text) {
  StudyStatistics next(columns_, variables_, scatters_, {}, most_);
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    next.designs_ = json.at("designs");
    next.failed_ = json.at("failed");
    json.at("verdicts").get_to(next.verdicts_);
    json.at("reasons").get_to(next.reasons_);
    const nlohmann::json& columns = json.at("columns");
    if (columns.size() != columns_.size()) throw std::invalid_argument("other columns");
    for (std::size_t k = 0; k < columns.size(); ++k)
      next.numbers_[k] = {number_of_cell(columns[k].at(0).get<std::string>()).value(),
                          number_of_cell(columns[k].at(1).get<std::string>()).value(),
                          number_counts_in(columns[k].at(2).get<std::string>(), most_)};
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no statistics of designs");
  } catch (const std::bad_optional_access&) {
    throw std::invalid_argument("no statistics of designs");
  }
  take(next);
}

}  // namespace boxbeam
