#include "charts/points.hpp"

namespace boxbeam::charts {

Point solved_point(const std::string& setting, double parameter, double operations, double error) {
  return {setting, parameter, operations, {}, error, "", false};
}

Point failed_point(const std::string& setting, double parameter, double operations,
                   const std::string& failure) {
  return {setting, parameter, operations, {}, 0.0, failure, false};
}

Chart without_answer(Chart chart, const std::string& failure) {
  chart.series = {{"reference", {failed_point("the case as it is", 1.0, 1.0, failure)}, false}};
  chart.lesson = "No answer: " + failure;
  return chart;
}

}  // namespace boxbeam::charts
