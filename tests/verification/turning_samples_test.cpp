#include "boxbeam/verification/turning_samples.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace turning_samples_test {

using namespace boxbeam;

namespace {

/// By definition: of values once round, equal neighbours taken as one, those that both neighbours
/// are below, or both above.
std::vector<std::pair<double, bool>> turns_by_definition(const std::vector<double>& values) {
  std::vector<double> unlike;
  for (const double value : values)
    if (unlike.empty() || value != unlike.back()) unlike.push_back(value);
  while (unlike.size() > 1 && unlike.back() == unlike.front()) unlike.pop_back();
  std::vector<std::pair<double, bool>> turns;
  const std::size_t n = unlike.size();
  for (std::size_t i = 0; n > 1 && i < n; ++i) {
    const double before = unlike[(i + n - 1) % n], at = unlike[i], behind = unlike[(i + 1) % n];
    if (at > before && at > behind) turns.emplace_back(at, true);
    if (at < before && at < behind) turns.emplace_back(at, false);
  }
  return turns;
}

/// The same list begins anywhere.
std::vector<std::pair<double, bool>> from_largest(std::vector<std::pair<double, bool>> turns) {
  std::vector<std::pair<double, bool>> first = turns;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    std::rotate(turns.begin(), turns.begin() + 1, turns.end());
    first = std::max(first, turns);
  }
  return first;
}

}  // namespace

TEST_CASE("samples turn where both neighbours are below, or both above, once round") {
  std::mt19937 random(5);
  for (int run = 0; run < 2000; ++run) {
    // Whole numbers, of which each change is larger than round-off; many are equal.
    const auto n = static_cast<std::size_t>(1 + random() % 40);
    const auto levels = 1 + random() % 9;
    std::vector<double> values(n);
    for (double& value : values) value = static_cast<double>(random() % levels) - 3.0;
    const TurningSamples found = turning_samples_of(values);
    std::vector<std::pair<double, bool>> turns;
    for (const TurningSample& turn : found.turns)
      turns.emplace_back(values[turn.index], turn.maximum);
    CAPTURE(run, n, levels);
    CHECK(from_largest(turns) == from_largest(turns_by_definition(values)));
    CHECK(std::is_sorted(
        found.turns.begin(), found.turns.end(),
        [](const TurningSample& a, const TurningSample& b) { return a.index < b.index; }));
    CHECK(values[found.highest] == *std::max_element(values.begin(), values.end()));
  }
}

TEST_CASE("waves within round-off of the whole do not turn, however many steps they take") {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) {
    const double whole = std::sin(0.02 * 3.141592653589793 * i);
    values.push_back(whole + 1e-11 * (i % 2));
  }
  const TurningSamples found = turning_samples_of(values);
  REQUIRE(found.turns.size() == 2);
  CHECK(found.turns[0].maximum != found.turns[1].maximum);
}

}  // namespace turning_samples_test
