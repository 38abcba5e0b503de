// What holds for every history, with RapidCheck. Histories of small whole numbers, so that ranges,
// means and sums are exact and plateaus and equal peaks are common; some longer than a block.

#include <algorithm>
#include <numeric>
#include <optional>

#include "catch.hpp"
#include "fatigue/plain_rainflow.hpp"
#include "support/property.hpp"

namespace rainflow_properties_test {

using namespace boxbeam;
using plain::Numbers;
using plain::Tally;
using test::holds;

namespace {

constexpr CountingRule astm{Counting::astm};
constexpr CountingRule with_halves{Counting::four_point, Residue::half_cycles};
constexpr CountingRule repeated{Counting::four_point, Residue::repeated};
constexpr CountingRule discarded{Counting::four_point, Residue::discard};
constexpr CountingRule periodic{Counting::periodic};
constexpr CountingRule all_rules[] = {astm, with_halves, repeated, discarded, periodic};

Tally counted(const Numbers& history, CountingRule rule) {
  return plain::tally(count_cycles(history, rule));
}

double total_count(const Tally& tally) {
  return std::accumulate(tally.begin(), tally.end(), 0.0,
                         [](double sum, const auto& entry) { return sum + entry.second; });
}

/// A history of up to `longest` samples on few or many levels.
Numbers any_history(int longest = 12000) {
  const int size = *rc::gen::weightedOneOf<int>(
      {{3, rc::gen::inRange(0, 40)}, {1, rc::gen::inRange(0, longest)}});
  const int levels = *rc::gen::element(2, 8, 1000000);
  const auto samples = *rc::gen::container<std::vector<int>>(
      static_cast<std::size_t>(size), rc::gen::resize(100, rc::gen::inRange(-levels, levels + 1)));
  return {samples.begin(), samples.end()};
}

Numbers changed(Numbers history, double factor, double offset) {
  for (double& x : history) x = factor * x + offset;
  return history;
}

Numbers rotated(Numbers history, std::size_t by) {
  std::rotate(history.begin(), history.begin() + static_cast<std::ptrdiff_t>(by), history.end());
  return history;
}

/// Another way to count a period, as short as the definition: on the circle of points, drop those
/// that are passed or repeated; take out the smallest range between neighbours; again.
Tally smallest_first(Numbers circle) {
  std::vector<Cycle> cycles;
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
    plain::add(cycles, circle[smallest], circle[(smallest + 1) % n], 1.0);
    circle = rotated(circle, smallest);
    circle.erase(circle.begin(), circle.begin() + 2);
  }
  return plain::tally(cycles);
}

}  // namespace

TEST_CASE("every history: the largest range is max - min where the residue counts") {
  holds([] {
    const Numbers history = any_history();
    for (const CountingRule& rule : {astm, with_halves, repeated, periodic}) {
      const Tally tally = counted(history, rule);
      const auto [low, high] = std::minmax_element(history.begin(), history.end());
      const double widest = history.empty() ? 0.0 : *high - *low;
      RC_ASSERT((tally.empty() ? 0.0 : tally.rbegin()->first.first) == widest);
      for (const auto& [cycle, count] : tally) RC_ASSERT(cycle.first > 0.0);
    }
  });
}

TEST_CASE("every history: as many cycles as the texts count") {
  holds([] {
    const Numbers history = any_history();
    RC_ASSERT(counted(history, astm) == plain::tally(plain::astm(history)));
    RC_ASSERT(counted(history, discarded) == plain::tally(plain::four_point(history).cycles));
  });
}

TEST_CASE("every history: ASTM is four points with the residue as half cycles") {
  holds([] {
    const Numbers history = any_history();
    RC_ASSERT(counted(history, astm) == counted(history, with_halves));
  });
}

TEST_CASE("every history: each turning point is the end of half a cycle") {
  holds([] {
    const Numbers history = any_history();
    const std::size_t turns = plain::turning_points(history).size();
    const double ranges = turns == 0 ? 0.0 : static_cast<double>(turns - 1);
    RC_ASSERT(2.0 * total_count(counted(history, astm)) == ranges);
    RC_ASSERT(2.0 * total_count(counted(history, with_halves)) == ranges);
    const plain::FourPoint rest = plain::four_point(history);
    RC_ASSERT(2.0 * total_count(counted(history, discarded)) +
                  static_cast<double>(rest.residue.size()) ==
              static_cast<double>(turns));
  });
}

TEST_CASE("every history: twice the sum of ranges is the way up and down") {
  holds([] {
    const Numbers history = any_history();
    double way = 0.0;
    for (std::size_t i = 1; i < history.size(); ++i) way += std::abs(history[i] - history[i - 1]);
    const double back = history.empty() ? 0.0 : std::abs(history.front() - history.back());
    const auto sum = [&](CountingRule rule) {
      double ranges = 0.0;
      for (const auto& [cycle, count] : counted(history, rule)) ranges += count * cycle.first;
      return 2.0 * ranges;
    };
    RC_ASSERT(sum(astm) == way);
    RC_ASSERT(sum(with_halves) == way);
    RC_ASSERT(sum(periodic) == way + back);
  });
}

TEST_CASE("every history: in chunks of any size the same cycles in the same order") {
  holds([] {
    const Numbers history = any_history(20000);
    const auto cuts =
        *rc::gen::container<std::vector<int>>(rc::gen::resize(100, rc::gen::inRange(0, 6000)));
    for (const CountingRule& rule : all_rules) {
      std::vector<Cycle> cycles;
      RainflowCounter counter(rule, [&](const CycleBatch& batch) {
        for (std::size_t i = 0; i < batch.range.size(); ++i) {
          cycles.push_back({si<Stress>(batch.range[i]), si<Stress>(batch.mean[i]), batch.count});
        }
      });
      std::span<const double> rest = history;
      for (std::size_t i = 0; !rest.empty(); ++i) {
        const std::size_t wanted = i < cuts.size() ? static_cast<std::size_t>(cuts[i]) : 1;
        const auto chunk = rest.first(std::min(wanted, rest.size()));
        counter.push(chunk);
        rest = rest.subspan(chunk.size());
      }
      counter.finish();
      const std::vector<Cycle> at_once = count_cycles(history, rule);
      RC_ASSERT(cycles.size() == at_once.size());
      for (std::size_t i = 0; i < cycles.size(); ++i) {
        RC_ASSERT(cycles[i].range == at_once[i].range);
        RC_ASSERT(cycles[i].mean == at_once[i].mean);
        RC_ASSERT(cycles[i].count == at_once[i].count);
      }
    }
  });
}

TEST_CASE("every period: where it is cut open does not matter") {
  holds([] {
    const Numbers history = any_history();
    RC_PRE(!history.empty());
    const auto by = *rc::gen::inRange<std::size_t>(0, history.size());
    RC_ASSERT(counted(rotated(history, by), periodic) == counted(history, periodic));
  });
}

TEST_CASE("every period: the count is that of the smallest range first") {
  holds([] {
    const Numbers history = any_history(300);
    RC_ASSERT(counted(history, periodic) == smallest_first(history));
  });
}

TEST_CASE("every period: the residue behind itself closes the same cycles") {
  holds([] {
    const Numbers history = any_history();
    RC_ASSERT(counted(history, repeated) == counted(history, periodic));
  });
}

TEST_CASE("every period: twice the history holds its cycles twice, but for the open ones") {
  holds([] {
    const Numbers history = any_history();
    Numbers twice = history;
    twice.insert(twice.end(), history.begin(), history.end());
    Tally doubled = counted(history, periodic);
    for (auto& [cycle, count] : doubled) count *= 2.0;
    RC_ASSERT(counted(twice, periodic) == doubled);
    // The second pass closes what one period holds.
    Tally second = counted(twice, discarded);
    for (const auto& [cycle, count] : counted(history, discarded)) {
      second[cycle] -= count;
      if (second[cycle] == 0.0) second.erase(cycle);
    }
    RC_ASSERT(second == counted(history, periodic));
  });
}

TEST_CASE("every history: upside down, the ranges stay and the means change sign") {
  holds([] {
    const Numbers history = any_history();
    for (const CountingRule& rule : all_rules) {
      Tally mirrored;
      for (const auto& [cycle, count] : counted(history, rule)) {
        mirrored[{cycle.first, 0.0 - cycle.second}] += count;
      }
      RC_ASSERT(counted(changed(history, -1.0, 0.0), rule) == mirrored);
    }
  });
}

TEST_CASE("every history: scaled and shifted, so are the cycles") {
  holds([] {
    const Numbers history = any_history();
    const double factor = *rc::gen::element(0.25, 2.0, 4096.0);
    const double offset = *rc::gen::inRange(-100, 100);
    for (const CountingRule& rule : all_rules) {
      Tally scaled;
      for (const auto& [cycle, count] : counted(history, rule)) {
        scaled[{factor * cycle.first, factor * cycle.second + offset}] += count;
      }
      RC_ASSERT(counted(changed(history, factor, offset), rule) == scaled);
    }
  });
}

TEST_CASE("every history: backwards, the same ranges") {
  holds([] {
    const Numbers history = any_history();
    const Numbers backwards(history.rbegin(), history.rend());
    for (const CountingRule& rule : {astm, with_halves, repeated, periodic}) {
      RC_ASSERT(counted(backwards, rule) == counted(history, rule));
    }
  });
}

}  // namespace rainflow_properties_test
