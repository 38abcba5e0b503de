// Designs that are looked at one by one: all of few, an even part of many.

#include "boxbeam/study/design_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "catch.hpp"

namespace design_rows_test {

using namespace boxbeam;

namespace {

DesignRows rows_of(std::size_t designs, std::uint64_t seed) {
  DesignSample sample({{"t", "mm"}, {"verdict", ""}, {"none", ""}}, 1, designs, seed);
  for (std::size_t i = 0; i < designs; ++i) {
    const bool fails = i % 7 == 3;
    if (!sample.wants(i)) continue;
    sample.take(i + 1, {fmt::format("{}", i + 1), fails ? "" : "pass", ""},
                fails ? "too thin" : "ok");
  }
  return sample.rows();
}

}  // namespace

TEST_CASE("of few designs all are kept, with columns that say something", "[study]") {
  const DesignRows rows = rows_of(100, 1);
  REQUIRE(rows.size() == 100);
  REQUIRE(rows.columns.size() == 3);  // nothing ever stands in the last column of results
  CHECK(rows.find("none") == nullptr);
  CHECK(rows.find("t")->is_variable);
  CHECK(rows.find("t")->numbers[9] == 10.0);
  CHECK(rows.find("verdict")->numbers.empty());
  CHECK(rows.find("verdict")->words[3].empty());
  CHECK(rows.find("status")->words[3] == "too thin");
}

TEST_CASE("of many designs one of each of equal parts is kept, by the seed", "[study]") {
  constexpr std::size_t designs = 64'005;
  const DesignRows rows = rows_of(designs, 1);
  CHECK(rows.designs == designs);
  CHECK(rows.size() <= DesignSample::most);
  constexpr std::size_t part = 7;
  CHECK(rows.size() == (designs + part - 1) / part);
  std::set<std::size_t> places;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CHECK((rows.numbers[k] - 1) / part == k);
    CHECK(rows.find("t")->numbers[k] == static_cast<double>(rows.numbers[k]));
    places.insert((rows.numbers[k] - 1) % part);
  }
  CHECK(places.size() == part);
  // One of seven fails: of so many kept ones 1306, and sqrt(n p q) = 33.
  std::size_t failing = 0;
  for (const std::string& status : rows.find("status")->words) failing += status == "ok" ? 0 : 1;
  CHECK(std::abs(static_cast<double>(failing) - static_cast<double>(rows.size()) / 7.0) < 4.0 * 34);
  CHECK(rows_of(designs, 1).numbers == rows.numbers);
  CHECK(rows_of(designs, 2).numbers != rows.numbers);
}

}  // namespace design_rows_test
