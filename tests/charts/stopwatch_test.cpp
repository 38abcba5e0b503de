#include "charts/stopwatch.hpp"

#include "catch.hpp"

namespace stopwatch_test {

using namespace boxbeam::charts;

TEST_CASE("alternatives are measured by turns, each as often as the others", "[charts]") {
  const Effort effort{true};
  int first = 0, second = 0;
  int switches = 0, last = 0;
  const auto note = [&](int which, int& count) {
    ++count;
    if (which != last) ++switches;
    last = which;
  };
  const auto timings = times_of({[&] { note(1, first); }, [&] { note(2, second); }}, effort);
  REQUIRE(timings.size() == 2);
  CHECK(first >= effort.repetitions());
  CHECK(second >= effort.repetitions());
  // Once each to find how often a measurement repeats them, then one after the other in every turn.
  CHECK(switches == 2 + 2 * effort.repetitions());
  for (const Timing& timing : timings) {
    CHECK(timing.low > 0.0);
    CHECK(timing.low <= timing.median);
    CHECK(timing.median <= timing.high);
  }
  CHECK(times_of({}, effort).empty());
}

}  // namespace stopwatch_test
