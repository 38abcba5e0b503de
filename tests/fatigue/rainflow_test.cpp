#include "boxbeam/fatigue/rainflow.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "catch.hpp"
#include "fatigue/plain_rainflow.hpp"

namespace rainflow_test {

using namespace boxbeam;
using plain::Numbers;
using plain::Tally;

namespace {

const CountingRule all_rules[] = {
    {Counting::astm},
    {Counting::four_point, Residue::half_cycles},
    {Counting::four_point, Residue::repeated},
    {Counting::four_point, Residue::discard},
    {Counting::periodic},
};

Tally counted(const Numbers& history, CountingRule rule = {}) {
  return plain::tally(count_cycles(history, rule));
}

const Tally none;

/// Uniform numbers with 20 binary digits behind the point, so that all ranges and means are exact.
Numbers uniform(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(-(1 << 20), 1 << 20);
  Numbers history(size);
  for (double& x : history) x = level(random) / 1048576.0;
  return history;
}

Numbers walk(std::size_t size, unsigned seed) {
  Numbers history = uniform(size, seed);
  std::partial_sum(history.begin(), history.end(), history.begin());
  return history;
}

/// A few levels: equal neighbours and equal peaks all the time.
Numbers coarse(std::size_t size, unsigned seed) {
  Numbers history = uniform(size, seed);
  for (double& x : history) x = std::round(3.0 * x);
  return history;
}

}  // namespace

TEST_CASE("a history that stands still has no cycle") {
  for (const CountingRule& rule : all_rules) {
    CHECK(counted({}, rule) == none);
    CHECK(counted({1}, rule) == none);
    CHECK(counted({3, 3, 3}, rule) == none);
    CHECK(counted({0.0, -0.0, 0.0}, rule) == none);
  }
}

TEST_CASE("one way is half a cycle, and one cycle where the history repeats") {
  CHECK(counted({1, 2}) == Tally{{{1, 1.5}, 0.5}});
  CHECK(counted({2, 1}) == Tally{{{1, 1.5}, 0.5}});
  CHECK(counted({1, 2, 3}) == Tally{{{2, 2}, 0.5}});
  CHECK(counted({1, 2, 3}, {Counting::four_point}) == Tally{{{2, 2}, 0.5}});
  CHECK(counted({1, 2, 3}, {Counting::four_point, Residue::discard}) == none);
  CHECK(counted({1, 2, 3}, {Counting::four_point, Residue::repeated}) == Tally{{{2, 2}, 1.0}});
  CHECK(counted({1, 2, 3}, {Counting::periodic}) == Tally{{{2, 2}, 1.0}});
  CHECK(counted({3, 1}, {Counting::periodic}) == Tally{{{2, 2}, 1.0}});
}

TEST_CASE("0, 10, 0 is two half cycles, one cycle where it repeats") {
  CHECK(count_cycles(Numbers{0, 10, 0}).size() == 2);
  CHECK(counted({0, 10, 0}) == Tally{{{10, 5}, 1.0}});
  CHECK(counted({0, 10, 0}, {Counting::periodic}) == Tally{{{10, 5}, 1.0}});
  CHECK(counted({0, 10, 0}, {Counting::four_point, Residue::repeated}) == Tally{{{10, 5}, 1.0}});
}

TEST_CASE("points passed on the way and points repeated change nothing") {
  for (const CountingRule& rule : all_rules) {
    const Tally expected = counted({0, 5, 2, 7, 1}, rule);
    CHECK(counted({0, 1, 3, 5, 4, 2, 6, 7, 3, 1}, rule) == expected);
    CHECK(counted({0, 0, 5, 5, 5, 2, 2, 7, 7, 1, 1}, rule) == expected);
    CHECK(counted({0, 0, 3, 3, 5, 4, 4, 2, 6, 6, 7, 1, 1}, rule) == expected);
  }
}

TEST_CASE("of a repeating history, a turning point at the joint may be passed or repeated") {
  const CountingRule periodic{Counting::periodic};
  const Tally expected = counted({7, 0, 5, 2}, periodic);
  CHECK(expected == Tally{{{3, 3.5}, 1.0}, {{7, 3.5}, 1.0}});
  CHECK(counted({1, 0, 5, 2, 7, 3}, periodic) == expected);
  CHECK(counted({7, 7, 0, 5, 2, 7}, periodic) == expected);
  CHECK(counted({0, 5, 2, 7, 0, 0}, periodic) == expected);
  CHECK(counted({4, 5, 2, 7, 0, 3}, periodic) == expected);
}

TEST_CASE("equal peaks are counted once each") {
  CHECK(counted({5, 0, 5, 0, 5, 0}, {Counting::periodic}) == Tally{{{5, 2.5}, 3.0}});
  CHECK(counted({5, 0, 5, 3, 5, 1}, {Counting::periodic}) ==
        Tally{{{2, 4}, 1.0}, {{4, 3}, 1.0}, {{5, 2.5}, 1.0}});
  // ASTM: each range holds the start, so that all are halves.
  for (const Cycle& cycle : count_cycles(Numbers{5, 0, 5, 0, 5, 0})) CHECK(cycle.count == 0.5);
}

TEST_CASE("long histories: the same cycles as by the texts") {
  for (const std::size_t size : {100U, 4096U, 4097U, 30000U}) {
    for (const Numbers& history : {uniform(size, 1), walk(size, 2), coarse(size, 3)}) {
      CHECK(counted(history) == plain::tally(plain::astm(history)));

      const plain::FourPoint four_point = plain::four_point(history);
      CHECK(counted(history, {Counting::four_point, Residue::discard}) ==
            plain::tally(four_point.cycles));
      std::vector<Cycle> with_halves = four_point.cycles;
      for (std::size_t i = 1; i < four_point.residue.size(); ++i) {
        plain::add(with_halves, four_point.residue[i - 1], four_point.residue[i], 0.5);
      }
      CHECK(counted(history, {Counting::four_point, Residue::half_cycles}) ==
            plain::tally(with_halves));
    }
  }
}

TEST_CASE("ASTM counts as many halves in long histories as the text does") {
  const auto halves = [](const std::vector<Cycle>& cycles) {
    return std::count_if(cycles.begin(), cycles.end(),
                         [](const Cycle& cycle) { return cycle.count == 0.5; });
  };
  for (const Numbers& history : {uniform(9000, 4), walk(9000, 5), coarse(9000, 6)}) {
    CHECK(halves(count_cycles(history)) == halves(plain::astm(history)));
  }
}

TEST_CASE("one shock in a long signal takes no cycle away") {
  Numbers history = uniform(100000, 7);
  history[50001] = 1e6;
  double way = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) way += std::abs(history[i] - history[i - 1]);
  for (const CountingRule& rule : {all_rules[0], all_rules[1]}) {
    double sum = 0.0;
    for (const Cycle& cycle : count_cycles(history, rule)) sum += cycle.count * cycle.range.value();
    // Up and down are two ranges of one cycle; sums of 1e5 exact ranges below 2^53 / 2^20 / 1e6.
    CHECK(2.0 * sum == Approx(way).epsilon(1e-13));
  }
  CHECK(counted(history) == plain::tally(plain::astm(history)));
}

TEST_CASE("a counter begins anew after each history") {
  std::vector<Cycle> cycles;
  const Numbers one = uniform(3000, 8);
  const Numbers other = walk(100, 9);
  for (const CountingRule& rule : all_rules) {
    std::vector<Cycle> got;
    RainflowCounter counter(rule, [&](const CycleBatch& batch) {
      for (std::size_t i = 0; i < batch.range.size(); ++i) {
        got.push_back({si<Stress>(batch.range[i]), si<Stress>(batch.mean[i]), batch.count});
      }
    });
    counter.push(one);
    counter.finish();
    got.clear();
    counter.push(other);
    counter.finish();
    CHECK(plain::tally(got) == counted(other, rule));
  }
}

TEST_CASE("the first sample that cannot be counted is found") {
  const double too_large = std::ldexp(1.0, 1023);
  const double largest = std::nextafter(too_large, 0.0);
  Numbers history = uniform(5000, 10);
  CHECK_FALSE(find_uncountable(history));
  CHECK_FALSE(find_uncountable({}));
  CHECK_FALSE(find_uncountable(Numbers{-largest, largest}));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), too_large, -too_large}) {
    for (const std::size_t at : {0U, 1U, 1023U, 1024U, 4999U}) {
      Numbers broken = history;
      broken[at] = bad;
      broken.back() = std::nan("");
      CHECK(find_uncountable(broken) == at);
    }
  }
}

TEST_CASE("ranges up to the largest double do not overflow") {
  const double largest = std::nextafter(std::ldexp(1.0, 1023), 0.0);
  CHECK(counted({-largest, largest}) == Tally{{{2.0 * largest, 0.0}, 0.5}});
}

}  // namespace rainflow_test
