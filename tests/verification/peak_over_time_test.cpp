#include "boxbeam/verification/peak_over_time.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace peak_over_time_test {

using namespace boxbeam;

namespace {

/// `count` equally spaced instants; of a time that repeats, behind the last comes the first; else
/// the last is the end.
SampledTime equal_instants(double begin, double step, std::size_t count, bool closed) {
  SampledTime span{{}, begin, step * static_cast<double>(closed ? count : count - 1)};
  for (std::size_t i = 0; i < count; ++i) {
    const double at = begin + step * static_cast<double>(i);
    const bool first = i == 0 && !closed, last = i + 1 == count && !closed;
    span.instants.push_back({at, first ? at : at - step, last ? at : at + step});
  }
  return span;
}

std::vector<double> sampled(const SampledTime& span, const std::function<double(double)>& f) {
  std::vector<double> values;
  for (const SampledInstant& instant : span.instants) values.push_back(f(instant.at));
  return values;
}

}  // namespace

TEST_CASE("the highest peak is found although another one has the highest instant") {
  // Peaks of 1 at an instant and of 1.01 half-way between two instants, which are at 0.999.
  const auto f = [](double t) {
    return std::max(1.0 - 4.4 * (t - 0.2) * (t - 0.2), 1.01 - 4.4 * (t - 0.65) * (t - 0.65));
  };
  const SampledTime span = equal_instants(0.0, 0.1, 11, false);
  const Extremum peak = peak_over_time(sampled(span, f), span, f);
  CHECK(peak.value == Approx(1.01).epsilon(1e-12));
  CHECK(peak.at == Approx(0.65).epsilon(1e-6));
}

TEST_CASE("a peak across the end of a closed time is found, its time within the span") {
  const double top = 0.97;
  const auto f = [&](double t) { return std::cos(2.0 * std::numbers::pi * (t - top)); };
  const SampledTime span = equal_instants(0.0, 0.125, 8, true);
  const Extremum peak = peak_over_time(sampled(span, f), span, f);
  CHECK(peak.value == Approx(1.0).epsilon(1e-12));
  CHECK(peak.at == Approx(top).epsilon(1e-6));
}

TEST_CASE("an open time is not left: its end may be the largest, and a constant has no peak") {
  const SampledTime span = equal_instants(1.0, 0.5, 5, false);
  const auto f = [](double t) {
    if (t < 1.0 || t > 3.0) FAIL("looked at t = " << t);
    return t * t;
  };
  const Extremum end = peak_over_time(sampled(span, f), span, f);
  CHECK(end.value == Approx(9.0).epsilon(1e-9));
  CHECK(end.at == Approx(3.0).epsilon(1e-6));
  int evaluations = 0;
  const auto constant = [&](double) {
    ++evaluations;
    return 7.0;
  };
  CHECK(peak_over_time({7.0, 7.0, 7.0, 7.0, 7.0}, span, constant).value == 7.0);
  CHECK(evaluations == 0);
}

TEST_CASE("an instant at a corner of the function is the peak itself") {
  const auto f = [](double t) { return 1.0 - std::abs(t - 0.3); };
  const SampledTime span = equal_instants(0.0, 0.1, 8, false);
  CHECK(peak_over_time(sampled(span, f), span, f).value == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a jump between two instants is on neither side's way") {
  // 1 + t up to the jump at 0.5, 0 behind it: two instants stand at it, which reach to one side.
  const auto f = [](double t) {
    if (t > 0.5 && t < 0.5000001) FAIL("looked across the jump");
    return t <= 0.5 ? 1.0 + t : 0.0;
  };
  const SampledTime span{{{0.0, 0.0, 0.25},
                          {0.25, 0.0, 0.5},
                          {0.5, 0.25, 0.5},
                          {0.6, 0.6, 0.8},
                          {0.8, 0.6, 1.0},
                          {1.0, 0.8, 1.0}},
                         0.0,
                         1.0};
  const Extremum peak = peak_over_time(sampled(span, f), span, f);
  CHECK(peak.value == Approx(1.5).epsilon(1e-12));
  CHECK(peak.at == Approx(0.5).epsilon(1e-9));
}

}  // namespace peak_over_time_test
