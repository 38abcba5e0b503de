#pragma once

#include <functional>
#include <string>
#include <vector>

#include "charts/chart.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// A setting that was tried, with the work to be timed; none where time says nothing.
struct Trial {
  Point point;
  std::function<void()> work;
};

/// A method with all its trials.
struct TriedMethod {
  std::string method;
  std::vector<Trial> trials;
  bool yardstick = false;
  bool other_scene = false;
};

/// The series of a chart: whatever did not fail is timed by turns.
std::vector<Series> timed(const std::vector<TriedMethod>& methods, const Effort& effort);

/// -log(error ratio)/log(ratio of operations) between two points of a series: the order that it
/// shows there.
double order_over_work(const Point& coarse, const Point& fine);

}  // namespace boxbeam::charts
