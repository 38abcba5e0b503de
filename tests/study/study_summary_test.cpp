// Statistics of a study by parts: those of all its numbers, in memory that does not grow.

#include "boxbeam/study/study_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "catch.hpp"

namespace study_summary_test {

using namespace boxbeam;

namespace {

const std::vector<Column> columns{{"t", "mm"}, {"verdict", ""}, {"use", ""}};

struct Row {
  double t = 0.0, use = 0.0;
  bool failed = false;
};

std::vector<Row> random_rows(std::size_t count) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<Row> rows(count);
  for (Row& row : rows)
    row = {12.0 + 0.3 * normal(random), std::exp(0.1 * normal(random)), random() % 13 == 0};
  return rows;
}

void take(StudyStatistics& statistics, const Row& row) {
  if (row.failed) {
    statistics.take({fmt::format("{}", row.t), "", ""}, "it does not fit");
    return;
  }
  statistics.take(
      {fmt::format("{}", row.t), row.use > 1.0 ? "fail" : "pass", fmt::format("{}", row.use)},
      "ok");
}

StudyStatistics by_parts(const std::vector<Row>& rows, std::size_t part, std::size_t most) {
  StudyStatistics all(columns, 1, true);
  for (std::size_t from = 0; from < rows.size(); from += part) {
    StudyStatistics one(columns, 1, true, {}, most);
    for (std::size_t i = from; i < std::min(from + part, rows.size()); ++i) take(one, rows[i]);
    // As chunks of a study hand them on.
    all.take_text(one.text());
  }
  return all;
}

StudySummary summary_of(const StudyStatistics& statistics) {
  StudySummary summary;
  statistics.put_into(summary);
  return summary;
}

}  // namespace

TEST_CASE("statistics by parts are those of all numbers by their definitions", "[study]") {
  const std::vector<Row> rows = random_rows(3000);
  const StudySummary summary = summary_of(by_parts(rows, 170, 1U << 14U));
  double sum = 0.0, squares = 0.0;
  std::size_t good = 0, failing = 0;
  for (const Row& row : rows) {
    if (row.failed) continue;
    ++good;
    sum += row.use;
    failing += row.use > 1.0 ? 1 : 0;
  }
  const double mean = sum / static_cast<double>(good);
  for (const Row& row : rows)
    if (!row.failed) squares += (row.use - mean) * (row.use - mean);
  CHECK(summary.designs == rows.size());
  CHECK(summary.failed == rows.size() - good);
  CHECK(summary.reasons.at("it does not fit") == summary.failed);
  CHECK(summary.verdicts.at("fail") == failing);
  // Those that could not be verified do not pass.
  REQUIRE(summary.p_f);
  CHECK(summary.p_f->value == Approx(static_cast<double>(failing + summary.failed) / 3000.0));
  REQUIRE(summary.statistics.size() == 2);
  const ColumnStatistics& use = summary.statistics[1];
  CHECK(use.count == good);
  CHECK(use.mean == Approx(mean).epsilon(1e-13));
  CHECK(use.sd == Approx(std::sqrt(squares / static_cast<double>(good - 1))).epsilon(1e-12));
  CHECK(use.quantile_error == 0.0);
}

TEST_CASE("parts that tell fewer numbers apart change quantiles within their error", "[study]") {
  const std::vector<Row> rows = random_rows(20'000);
  const StudySummary exact = summary_of(by_parts(rows, 4000, 1U << 15U));
  const StudySummary coarse = summary_of(by_parts(rows, 4000, 256));
  const ColumnStatistics &of = coarse.statistics[1], &by = exact.statistics[1];
  CHECK(of.quantile_error > by.quantile_error);
  CHECK(of.quantile_error < 0.01);
  CHECK(of.mean == by.mean);
  CHECK(of.sd == by.sd);
  CHECK(of.quantiles.front() == by.quantiles.front());
  CHECK(of.quantiles.back() == by.quantiles.back());
  for (std::size_t k = 1; k < 4; ++k)
    CHECK(std::abs(of.quantiles[k] / by.quantiles[k] - 1.0) <=
          of.quantile_error + by.quantile_error);
}

TEST_CASE("statistics are read as they were written, and nothing else is", "[study]") {
  const StudyStatistics all = by_parts(random_rows(500), 100, 64);
  StudyStatistics again(columns, 1, true);
  again.take_text(all.text());
  CHECK(again.text() == all.text());
  for (const char* text : {"", "{}", "[1]",
                           "{\"designs\": 1, \"failed\": 0, \"verdicts\": {}, "
                           "\"reasons\": {}, \"columns\": []}"})
    CHECK_THROWS_AS(again.take_text(text), std::invalid_argument);
}

}  // namespace study_summary_test
