#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "boxbeam/study/chart.hpp"
#include "boxbeam/study/stopwatch.hpp"

namespace boxbeam::study {

/// A point that came to a result, not timed yet.
Point solved_point(const std::string& setting, double parameter, double operations, double error);

/// One that did not, and why.
Point failed_point(const std::string& setting, double parameter, double operations,
                   const std::string& failure);

/// A chart whose scene has no answer, and why: one failed point.
Chart without_answer(Chart chart, const std::string& failure);

/// The work of points of a chart, timed together by turns when all of them are there.
class PointTimer {
 public:
  /// Of the point that was added last to the series that was.
  void add(const Chart& chart, std::function<void()> work);
  void measure(Chart& chart, const Effort& effort) const;

 private:
  struct Place {
    std::size_t series, point;
  };
  std::vector<Place> places_;
  std::vector<std::function<void()>> works_;
};

/// The point that the program uses by default in a chart, nullptr where there is none.
const Point* default_of(const Chart& chart);

/// Slope of the error of two neighbouring points over what the series runs over, its sign turned:
/// the order of convergence.
double order_between(const Point& coarse, const Point& fine);

}  // namespace boxbeam::study
