#include "boxbeam/study/study_summary.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "simulations.hpp"

namespace boxbeam {
namespace {

std::optional<double> number_in(const std::string& cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

ColumnStatistics statistics_of(const Column& column, std::vector<double> numbers) {
  ColumnStatistics of;
  of.column = column;
  of.count = numbers.size();
  // Welford's recurrence, in the order of the designs.
  double squares = 0.0, count = 0.0;
  for (const double x : numbers) {
    count += 1.0;
    const double apart = x - of.mean;
    of.mean += apart / count;
    squares += apart * (x - of.mean);
  }
  of.sd = count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  std::sort(numbers.begin(), numbers.end());
  constexpr std::array shares{0.0, 0.05, 0.5, 0.95, 1.0};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const auto place = static_cast<std::size_t>(std::ceil(shares[k] * count));
    of.quantiles[k] = numbers[place == 0 ? 0 : place - 1];
  }
  return of;
}

}  // namespace

StudyStatistics::StudyStatistics(std::vector<Column> columns, std::size_t variables, bool scatters,
                                 std::optional<IndexPlan> plan)
    : columns_(std::move(columns)),
      variables_(variables),
      scatters_(scatters),
      plan_(std::move(plan)),
      numbers_(columns_.size()),
      of_designs_(columns_.size()) {}

void StudyStatistics::take(const std::vector<std::string>& cells, const std::string& status) {
  ++designs_;
  if (plan_)
    for (std::size_t k = variables_; k < cells.size(); ++k)
      of_designs_[k].push_back(
          number_in(cells[k]).value_or(std::numeric_limits<double>::quiet_NaN()));
  if (status != "ok") {
    ++failed_;
    constexpr std::size_t most = 1000;
    if (reasons_.size() < most || reasons_.count(status) > 0) ++reasons_[status];
    return;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (columns_[k].name == "verdict")
      ++verdicts_[cells[k]];
    else if (const std::optional<double> number = number_in(cells[k]))
      numbers_[k].push_back(*number);
  }
}

void StudyStatistics::put_into(StudySummary& summary) const {
  summary.designs = designs_;
  summary.failed = failed_;
  summary.verdicts = verdicts_;
  summary.reasons = reasons_;
  for (std::size_t k = 0; k < columns_.size(); ++k)
    if (!numbers_[k].empty()) summary.statistics.push_back(statistics_of(columns_[k], numbers_[k]));
  if (scatters_ && !plan_ && !verdicts_.empty()) {
    const auto passing = verdicts_.find("pass");
    const std::size_t failing = designs_ - (passing == verdicts_.end() ? 0 : passing->second);
    const Estimate share = share_estimate(designs_, failing);
    summary.p_f = BoundedEstimate{share.p_f, share.low, share.high};
  }
  if (!plan_) return;
  summary.index_variables = plan_->variables;
  for (std::size_t k = variables_; k < columns_.size(); ++k)
    if (!numbers_[k].empty())
      summary.indices.push_back({columns_[k], sobol_indices_of(of_designs_[k], *plan_)});
}

}  // namespace boxbeam
