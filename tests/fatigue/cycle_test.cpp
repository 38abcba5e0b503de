#include "boxbeam/fatigue/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "catch.hpp"

using namespace boxbeam;

namespace {

using Numbers = std::vector<double>;

std::vector<Cycle> cycles_of(const Numbers& history) {
  std::vector<Stress> points;
  for (const double x : history) points.push_back(si<Stress>(x));
  return count_periodic_cycles(points);
}

/// Ranges of all cycles, ascending.
Numbers ranges_of(const Numbers& history) {
  Numbers ranges;
  for (const Cycle& cycle : cycles_of(history)) {
    CHECK(cycle.count == 1.0);
    ranges.push_back(cycle.range.value());
  }
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

Numbers rotated(Numbers history, std::size_t by) {
  std::rotate(history.begin(), history.begin() + static_cast<std::ptrdiff_t>(by), history.end());
  return history;
}

Numbers random_history(std::mt19937& random, std::size_t size, int levels) {
  std::uniform_int_distribution<int> level(-levels, levels);
  Numbers history(size);
  for (double& x : history) x = level(random);
  return history;
}

/// Another way to count a periodic history, slow and as short as the definition: on the circle of
/// points, drop those that are passed or repeated; take out the smallest range between neighbours;
/// again.
Numbers ranges_by_smallest_first(Numbers circle) {
  Numbers ranges;
  const auto step = [&](std::size_t i) {
    return circle[(i + 1) % circle.size()] - circle[i % circle.size()];
  };
  while (circle.size() >= 2) {
    const std::size_t n = circle.size();
    std::size_t smallest = 0;
    std::optional<std::size_t> passed;
    for (std::size_t i = 0; i < n; ++i) {
      if (step(i) * step(i + 1) >= 0.0) passed = (i + 1) % n;
      if (std::abs(step(i)) < std::abs(step(smallest))) smallest = i;
    }
    if (passed) {
      circle.erase(circle.begin() + static_cast<std::ptrdiff_t>(*passed));
      continue;
    }
    ranges.push_back(std::abs(step(smallest)));
    circle = rotated(circle, smallest);
    circle.erase(circle.begin(), circle.begin() + 2);
  }
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

}  // namespace

TEST_CASE("ASTM E1049-85: the repeating history of figure 6 has full cycles of 3, 4, 7 and 9") {
  CHECK(ranges_of({-2, 1, -3, 5, -1, 3, -4, 4, -2}) == Numbers{3, 4, 7, 9});
  // The largest runs from 5 to -4.
  for (const Cycle& cycle : cycles_of({-2, 1, -3, 5, -1, 3, -4, 4, -2})) {
    if (cycle.range.value() == 9.0) CHECK(cycle.mean.value() == 0.5);
    if (cycle.range.value() == 4.0) CHECK(cycle.mean.value() == 1.0);
  }
}

TEST_CASE("Lee, Barkey and Kang: (1,-3), and (2,-1), (-4,3), (4,-5) from the repeated residue") {
  CHECK(ranges_of({2, -1, 3, -5, 1, -3, 4, -4, 2}) == Numbers{3, 4, 7, 9});
}

TEST_CASE("Haibach, figure 3.3-30, as one period") {
  // Printed cycles 5-3, 2-3, 1-6, 2-3, 1-4, 4-2, 3-4 and the residue 2, 6, 1, 5, 2, which closes
  // on itself to 5-2 and 6-1.
  CHECK(ranges_of({2, 5, 3, 6, 2, 3, 1, 6, 1, 4, 2, 3, 1, 4, 2, 5, 3, 4, 2}) ==
        Numbers{1, 1, 1, 2, 2, 3, 3, 5, 5});
}

TEST_CASE("a short period by hand: 2, 5, 3, 7 has 5-3 and 7-2") {
  const auto cycles = cycles_of({2, 5, 3, 7});
  REQUIRE(cycles.size() == 2);
  CHECK(cycles[0].range.value() == 2.0);
  CHECK(cycles[0].mean.value() == 4.0);
  CHECK(cycles[1].range.value() == 5.0);
  CHECK(cycles[1].mean.value() == 4.5);
}

TEST_CASE("0, 10, 0 is one cycle of 10") { CHECK(ranges_of({0, 10, 0}) == Numbers{10}); }

TEST_CASE("a history that stands still has no cycle") {
  CHECK(cycles_of({}).empty());
  CHECK(cycles_of({3}).empty());
  CHECK(cycles_of({3, 3, 3}).empty());
}

TEST_CASE("two points are one cycle") {
  CHECK(ranges_of({-1, 4}) == Numbers{5});
  CHECK(ranges_of({4, -1}) == Numbers{5});
  CHECK(cycles_of({4, -1})[0].mean.value() == 1.5);
}

TEST_CASE("points passed on the way and points repeated change nothing") {
  const Numbers expected = ranges_of({0, 5, 2, 7});
  CHECK(ranges_of({0, 1, 3, 5, 4, 2, 6, 7, 3}) == expected);
  CHECK(ranges_of({0, 0, 5, 5, 5, 2, 7, 7, 0, 0}) == expected);
  CHECK(ranges_of({3, 5, 2, 7, 4, 0, 1}) == expected);
}

TEST_CASE("equal peaks are counted once each") {
  CHECK(ranges_of({5, 0, 5, 0, 5, 0}) == Numbers{5, 5, 5});
  CHECK(ranges_of({5, 0, 5, 3, 5, 1}) == Numbers{2, 4, 5});
}

TEST_CASE("random histories: the largest range is max - min") {
  std::mt19937 random(21);
  for (std::size_t size = 2; size < 60; ++size) {
    const Numbers history = random_history(random, size, 9);
    const auto [low, high] = std::minmax_element(history.begin(), history.end());
    if (*low == *high) continue;
    CHECK(ranges_of(history).back() == *high - *low);
  }
}

TEST_CASE("random histories: where the period is cut open does not matter") {
  std::mt19937 random(22);
  for (int run = 0; run < 20; ++run) {
    const Numbers history = random_history(random, 25, run < 10 ? 4 : 1000);
    const Numbers expected = ranges_of(history);
    for (std::size_t by = 1; by < history.size(); ++by) {
      CHECK(ranges_of(rotated(history, by)) == expected);
    }
  }
}

TEST_CASE("random histories: twice the sum of ranges is the way up and down in one period") {
  std::mt19937 random(23);
  for (int run = 0; run < 50; ++run) {
    const Numbers history = random_history(random, 40, 50);
    double way = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i) {
      way += std::abs(history[(i + 1) % history.size()] - history[i]);
    }
    for (const double range : ranges_of(history)) sum += range;
    CHECK(2.0 * sum == way);
  }
}

TEST_CASE("random histories: the same ranges as taking out the smallest range first") {
  std::mt19937 random(24);
  for (int run = 0; run < 100; ++run) {
    const Numbers history = random_history(random, 30, 20);
    CHECK(ranges_of(history) == ranges_by_smallest_first(history));
  }
}

TEST_CASE("random histories: turned upside down, the ranges stay and the means change sign") {
  std::mt19937 random(25);
  Numbers history = random_history(random, 50, 1000000);
  Numbers mirrored;
  for (const double x : history) mirrored.push_back(-x);
  CHECK(ranges_of(mirrored) == ranges_of(history));
  double mean = 0.0;
  for (const Cycle& cycle : cycles_of(history)) mean += cycle.mean.value();
  for (const Cycle& cycle : cycles_of(mirrored)) mean += cycle.mean.value();
  CHECK(mean == Approx(0.0).margin(1e-6));
}
