#include "boxbeam/fatigue/rainflow_kernels.hpp"

#include "catch.hpp"
#include "fatigue/plain_rainflow.hpp"
#include "support/property.hpp"

namespace rainflow_kernels_test {

using namespace boxbeam;
using plain::Numbers;
using test::holds;

namespace {

Numbers any_samples(int fewest) {
  const int size = *rc::gen::resize(100, rc::gen::inRange(fewest, 120));
  const int levels = *rc::gen::element(2, 8, 1000000);
  const auto samples = *rc::gen::container<std::vector<int>>(
      static_cast<std::size_t>(size), rc::gen::resize(100, rc::gen::inRange(-levels, levels + 1)));
  return {samples.begin(), samples.end()};
}

/// The turning points of samples of which the first two differ, without the last.
Numbers turns_by(const RainflowKernels& kernels, const Numbers& samples, Course& course) {
  Numbers turns(samples.size() + kernel_slack);
  course = {samples[1], samples[1] > samples[0]};
  turns.resize(
      kernels.write_turns(std::span<const double>(samples).subspan(2), course, turns.data()));
  return turns;
}

struct Closed {
  Numbers turns, range, mean;
  friend bool operator==(const Closed&, const Closed&) = default;
};

Closed closed_by(const RainflowKernels& kernels, const Numbers& turns) {
  Closed closed{turns, Numbers(turns.size() + kernel_slack), Numbers(turns.size() + kernel_slack)};
  closed.turns.resize(turns.size() + 1 + kernel_slack);
  CycleArrays cycles{closed.range.data(), closed.mean.data(), 0};
  closed.turns.resize(
      kernels.close_enclosed(closed.turns.data(), turns.size(), turns[0] > turns[1], cycles));
  closed.range.resize(cycles.count);
  closed.mean.resize(cycles.count);
  return closed;
}

}  // namespace

TEST_CASE("kernels: the turning points of the text") {
  holds([] {
    const Numbers samples = any_samples(2);
    RC_PRE(samples[0] != samples[1]);
    for (const RainflowKernels* kernels : {&plain_kernels, &fastest_kernels()}) {
      Course course;
      Numbers turns = turns_by(*kernels, samples, course);
      turns.insert(turns.begin(), samples.front());
      turns.push_back(course.last);
      RC_ASSERT(turns == plain::turning_points(samples));
      RC_ASSERT(course.up == (turns.back() > turns[turns.size() - 2]));
    }
  });
}

TEST_CASE("kernels: what is enclosed by its neighbours closes, first and last points stay") {
  for (const RainflowKernels* kernels : {&plain_kernels, &fastest_kernels()}) {
    const Closed falling = closed_by(*kernels, {0, 9, 3, 6, 2, 8});
    CHECK(falling == Closed{{0, 9, 2, 8}, {3}, {4.5}});
    const Closed rising = closed_by(*kernels, {9, 0, 6, 3, 7, 1});
    CHECK(rising == Closed{{9, 0, 7, 1}, {3}, {4.5}});
    // Equal ranges at the start are halves by ASTM: none of them may close.
    const Closed equal = closed_by(*kernels, {0, 5, 0, 5, 0, 5, 0, 5});
    CHECK(equal == Closed{{0, 5, 0, 5, 0, 5, 0, 5}, {}, {}});
  }
}

TEST_CASE("kernels: closing enclosed ranges first changes no cycle of the count") {
  holds([] {
    const Numbers turns = plain::turning_points(any_samples(5));
    RC_PRE(turns.size() >= 5U);
    for (const RainflowKernels* kernels : {&plain_kernels, &fastest_kernels()}) {
      const Closed closed = closed_by(*kernels, turns);
      RC_ASSERT(closed.turns.front() == turns.front());
      RC_ASSERT(closed.turns.back() == turns.back());
      RC_ASSERT(closed.turns.size() + 2 * closed.range.size() == turns.size());
      std::vector<Cycle> cycles = plain::astm(closed.turns);
      for (std::size_t i = 0; i < closed.range.size(); ++i) {
        cycles.push_back({si<Stress>(closed.range[i]), si<Stress>(closed.mean[i]), 1.0});
      }
      RC_ASSERT(plain::tally(cycles) == plain::tally(plain::astm(turns)));
    }
  });
}

TEST_CASE("kernels: the fastest gives the numbers of the plain ones, bit for bit and in order") {
  holds([] {
    const Numbers samples = any_samples(2);
    RC_PRE(samples[0] != samples[1]);
    Course plain_course, fast_course;
    Numbers turns = turns_by(plain_kernels, samples, plain_course);
    RC_ASSERT(turns_by(fastest_kernels(), samples, fast_course) == turns);
    RC_ASSERT(fast_course.last == plain_course.last);
    RC_ASSERT(fast_course.up == plain_course.up);
    // Numbers that are not exact in binary, for the rounding of ranges and means.
    for (double& turn : turns) turn *= 0.1;
    if (turns.size() >= 5) {
      RC_ASSERT(closed_by(fastest_kernels(), turns) == closed_by(plain_kernels, turns));
    }
  });
}

}  // namespace rainflow_kernels_test
