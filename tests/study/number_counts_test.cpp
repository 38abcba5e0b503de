// Counts of numbers in bounded memory: exact while few are unlike, within the stated error of the
// sorted numbers else, and the same whatever the order and the parts.

#include "boxbeam/study/number_counts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "catch.hpp"

namespace number_counts_test {

using namespace boxbeam;

namespace {

NumberCounts counts_of(const std::vector<double>& numbers, std::size_t most) {
  NumberCounts counts(most);
  for (const double number : numbers) counts.add(number);
  return counts;
}

/// The smallest number that such a share is not above, from the sorted numbers themselves.
double exact_quantile(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  const auto place =
      static_cast<std::size_t>(std::ceil(share * static_cast<double>(numbers.size())));
  return numbers[place == 0 ? 0 : place - 1];
}

/// Of both signs and over ten decades.
std::vector<double> spread_numbers(std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(count);
  for (double& number : numbers) number = normal(random) * std::pow(10.0, 2.5 * normal(random));
  return numbers;
}

}  // namespace

TEST_CASE("few unlike numbers are known exactly, however often they come", "[study]") {
  std::vector<double> numbers;
  for (int i = 0; i < 10'000; ++i) numbers.push_back(0.1 * (i % 37) - 1.7);
  const NumberCounts counts = counts_of(numbers, 64);
  CHECK(counts.error() == 0.0);
  CHECK(counts.count() == numbers.size());
  for (const double share : {0.0, 0.05, 0.5, 0.731, 0.95, 1.0})
    CHECK(counts.quantile(share) == exact_quantile(numbers, share));
}

TEST_CASE("quantiles of many numbers are within the stated error", "[study]") {
  const std::vector<double> numbers = spread_numbers(50'000);
  for (const std::size_t most : {std::size_t{512}, std::size_t{1} << 14U}) {
    const NumberCounts counts = counts_of(numbers, most);
    CAPTURE(most, counts.error());
    CHECK(counts.error() > 0.0);
    CHECK(counts.error() < 0.25);
    for (double share = 0.001; share < 1.0; share += 0.013) {
      const double exact = exact_quantile(numbers, share);
      CHECK(std::abs(counts.quantile(share) - exact) <= counts.error() * std::abs(exact));
    }
    CHECK(counts.quantile(0.0) == exact_quantile(numbers, 0.0));
    CHECK(counts.quantile(1.0) == exact_quantile(numbers, 1.0));
  }
}

TEST_CASE("numbers that lie close together are told apart", "[study]") {
  // A thousandth about 1000: bins that are wide by a part of the number itself would show nothing.
  std::vector<double> numbers;
  for (int i = 0; i < 40'000; ++i) numbers.push_back(1000.0 + 1e-3 * std::sin(1.0 * i));
  const NumberCounts counts = counts_of(numbers, 1024);
  CHECK(counts.error() < 1e-8);
  for (const double share : {0.05, 0.5, 0.95})
    CHECK(std::abs(counts.quantile(share) - exact_quantile(numbers, share)) < 1e-5);
}

TEST_CASE("what comes of numbers hangs on neither their order nor their parts", "[study]") {
  std::vector<double> numbers = spread_numbers(30'000);
  const std::string whole = counts_of(numbers, 1000).text();
  std::mt19937_64 random(3);
  for (int turn = 0; turn < 5; ++turn) {
    std::shuffle(numbers.begin(), numbers.end(), random);
    CHECK(counts_of(numbers, 1000).text() == whole);
    // Parts of all sizes, joined in any order and by twos.
    std::vector<NumberCounts> parts;
    for (std::size_t from = 0; from < numbers.size();) {
      const std::size_t size = std::min<std::size_t>(1 + random() % 9000, numbers.size() - from);
      const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(from);
      parts.push_back(counts_of({begin, begin + static_cast<std::ptrdiff_t>(size)}, 1000));
      from += size;
    }
    while (parts.size() > 1) {
      std::shuffle(parts.begin(), parts.end(), random);
      const NumberCounts last = parts.back();
      parts.pop_back();
      parts.front().add(last);
    }
    CHECK(parts.front().text() == whole);
  }
}

TEST_CASE("memory is bounded whatever the numbers", "[study]") {
  NumberCounts counts(5000);
  std::mt19937_64 random(1);
  for (int i = 0; i < 200'000; ++i) {
    const double number = std::ldexp(1.0 + 1e-9 * static_cast<double>(random() % 1'000'000'000),
                                     static_cast<int>(random() % 2000) - 1000);
    counts.add(i % 2 == 0 ? number : -number);
  }
  counts.add(0.0);
  counts.add(std::numeric_limits<double>::denorm_min());
  counts.add(std::numeric_limits<double>::max());
  CHECK(counts.count() == 200'003);
  // Three numbers at most, and two for each bin.
  const std::string text = counts.text();
  CHECK(std::count(text.begin(), text.end(), ' ') <= 2 + 2 * 5000);
  CHECK(counts.quantile(1.0) == std::numeric_limits<double>::max());
}

TEST_CASE("equal parts hold all numbers", "[study]") {
  const NumberCounts even = counts_of({0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0}, 64);
  CHECK(even.parts(5) == std::vector<std::uint64_t>{2, 2, 2, 2, 3});
  CHECK(counts_of({2.0, 2.0}, 64).parts(3) == std::vector<std::uint64_t>{2, 0, 0});
  // Zero is one number, whatever its sign.
  CHECK(counts_of({0.0, -0.0}, 64).text() == counts_of({0.0, 0.0}, 64).text());
  std::uint64_t sum = 0;
  for (const std::uint64_t part : counts_of(spread_numbers(9000), 512).parts(20)) sum += part;
  CHECK(sum == 9000);
}

TEST_CASE("counts are read as they were written", "[study]") {
  for (const std::vector<double>& numbers :
       {std::vector<double>{}, std::vector<double>{-3.5}, spread_numbers(5000)}) {
    const NumberCounts counts = counts_of(numbers, 512);
    const NumberCounts again = number_counts_in(counts.text(), 512);
    CHECK(again.text() == counts.text());
    CHECK(again.count() == counts.count());
  }
  for (const char* text : {"", "a", "99 0 1", "0 0 1 5", "0 0 1 5 x"})
    CHECK_THROWS_AS(number_counts_in(text), std::invalid_argument);
}

}  // namespace number_counts_test
