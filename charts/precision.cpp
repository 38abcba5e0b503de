#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "charts/rounded_instant.hpp"
#include "charts/runs.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

template <class Scalar>
struct Format;
template <>
struct Format<Decimal<5>> {
  static constexpr const char* name = "5 decimal digits";
  static constexpr double bits = 16.609640474436812;  // 5/log10(2)
  static constexpr double round_off = 0.5e-4;
};
template <>
struct Format<float> {
  static constexpr const char* name = "float";
  static constexpr double bits = std::numeric_limits<float>::digits;
  static constexpr double round_off = std::numeric_limits<float>::epsilon();
};
template <>
struct Format<double> {
  static constexpr const char* name = "double";
  static constexpr double bits = std::numeric_limits<double>::digits;
  static constexpr double round_off = std::numeric_limits<double>::epsilon();
};
template <>
struct Format<long double> {
  static constexpr const char* name = "long double";
  static constexpr double bits = std::numeric_limits<long double>::digits;
  static constexpr double round_off = std::numeric_limits<long double>::epsilon();
};

template <class Scalar>
Run run_in(const DrivenScene& scene, const ReferenceMotion& reference, LinearMethod method) {
  using Setting = typename Follower<Scalar>::Setting;
  const auto follower = std::make_shared<Follower<Scalar>>(scene, reference.times, method);
  // The step behind a step of this size is round-off.
  const Setting setting{std::pow(Format<Scalar>::round_off, 0.75), 2, true};
  Run run;
  run.point.setting = Format<Scalar>::name;
  run.point.parameter = Format<Scalar>::bits;
  run.point.operations = Format<Scalar>::bits;
  run.point.failure = follower->run(setting);
  if (run.point.failure.empty()) {
    run.instants = follower->instants();
    run.work = [follower, setting] { keep(follower->run(setting)); };
  } else if (scene.mechanism.equations() > scene.mechanism.coordinates()) {
    run.point.failure = "more equations than coordinates";
  }
  return run;
}

Chart format_chart(const DrivenScene& scene, const ReferenceMotion& reference,
                   const std::vector<Run>& runs, Quantity quantity) {
  const ErrorOf error_of(scene.mechanism, reference);
  Chart chart;
  chart.name = fmt::format("precision-{}", to_text(quantity));
  chart.title = fmt::format("Precision of the arithmetic: {}", to_text(quantity));
  chart.scene = fmt::format("{}, {} instants", scene.name, reference.times.size());
  chart.error = fmt::format("largest error of {}, relative", to_text(quantity));
  chart.reference = reference.name;
  chart.operations = "bits of the numbers' significand";
  chart.unit = "one instant: positions to reactions";
  chart.series = {{"Newton, dense LU", {}, true},
                  {"Newton, static sparse order", {}, true},
                  {"boxbeam", {}, false}};
  for (const Run& run : runs) {
    chart.series[run.series].points.push_back(point_of(run, error_of, quantity));
  }
  const std::vector<Point>& sparse = chart.series[1].points;
  const Point& program = chart.series[2].points.front();
  if (sparse.front().failure.empty()) {
    chart.lesson = fmt::format(
        "Five decimal digits leave an error of {:.0e}, float {:.0e}, double {:.0e}. Towards a dead "
        "point the error grows as round-off over the distance: float then has {:.0f} digits in "
        "reserve for a check, double {:.0f}, and boxbeam calculates in double.",
        sparse[0].error, sparse[1].error, program.error,
        std::floor(std::log10(chart.needed_low / sparse[1].error)),
        std::floor(std::log10(chart.needed_low / program.error)));
  } else {
    chart.lesson = fmt::format("boxbeam calculates in double and leaves {:.0e}; {}.", program.error,
                               sparse.front().failure);
  }
  return chart;
}

// ---- next to turning points -----------------------------------------------------------------

/// The only driver of a mechanism, if it is one harmonic.
const HarmonicDriver* harmonic_of(const planar::Mechanism& mechanism) {
  const HarmonicDriver* only = nullptr;
  for (const planar::Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<planar::Driven>(&joint.kind);
    if (driven == nullptr) continue;
    const auto* harmonic = std::get_if<HarmonicDriver>(&driven->driver);
    if (harmonic == nullptr || !harmonic->further.empty() || only != nullptr) return nullptr;
    only = harmonic;
  }
  return only;
}

/// An instant close to a quarter of the driver's period, and what is right there.
struct Quarter {
  Point point;  ///< but for the error
  planar::State state;
  ReferenceMotion exact;
};

std::vector<Quarter> quarters_of(const DrivenScene& scene, const HarmonicDriver& driver) {
  std::vector<Quarter> quarters;
  planar::InstantSolver solver(scene.mechanism);
  planar::State state = scene.motion.states.front();
  for (int k = 1; k <= 6; ++k) {
    // To three digits, as a table of results is made.
    const double quarter = (0.5 * std::numbers::pi * k - driver.phase) / driver.omega;
    const double time = static_cast<double>(Decimal<3>(quarter));
    if (time <= state.time) continue;
    state = solver.solve_near(time, state);
    const auto exact = rounded_instant<long double>(
        scene.mechanism, {rounded_state<long double>(driver, time)}, state.q);
    if (!exact) continue;
    Quarter next;
    next.point.setting = fmt::format("t = {:.4g} s", time);
    next.point.parameter = time;
    next.point.operations = 1.0 / std::abs(std::cos(driver.omega * time + driver.phase));
    next.state = state;
    next.exact = {"", {time}, {*exact}};
    quarters.push_back(std::move(next));
  }
  std::sort(quarters.begin(), quarters.end(), [](const Quarter& a, const Quarter& b) {
    return *a.point.operations < *b.point.operations;
  });
  return quarters;
}

template <class Scalar, class Argument = Scalar>
Series turning_series(const std::string& method, const DrivenScene& scene,
                      const HarmonicDriver& driver, const std::vector<Quarter>& quarters) {
  Series series{method, {}, true};
  for (const Quarter& quarter : quarters) {
    Point point = quarter.point;
    const auto rounded = rounded_instant<Scalar>(
        scene.mechanism, {rounded_state<Scalar, Argument>(driver, point.parameter)},
        quarter.state.q);
    if (rounded) {
      point.error = ErrorOf(scene.mechanism, quarter.exact)
                        .at(Quantity::velocity, 0, rounded->template in<long double>());
    } else {
      point.failure = "no convergence";
    }
    series.points.push_back(std::move(point));
  }
  return series;
}

Chart turning_chart(const DrivenScene& scene, const HarmonicDriver& driver) {
  const std::vector<Quarter> quarters = quarters_of(scene, driver);
  Chart chart;
  chart.name = "precision-turning-points";
  chart.title = "Precision of the arithmetic: velocities next to turning points";
  chart.scene =
      fmt::format("{}, instants to three digits next to quarters of the period", scene.name);
  chart.error = "largest error of velocities, by the largest at the same instant";
  chart.reference = "Newton's method in long double, the driver's phase too";
  chart.operations = "largest rate of the driver over its rate at the instant";
  chart.operations_cost = false;
  chart.series = {turning_series<Decimal<5>, Decimal<3>>("5 digits, the driver's phase to 3", scene,
                                                         driver, quarters),
                  turning_series<Decimal<5>>("5 digits", scene, driver, quarters),
                  turning_series<float>("float", scene, driver, quarters)};
  Series own{"boxbeam, double", {}, false};
  for (const Quarter& quarter : quarters) {
    Point point = quarter.point;
    point.error = ErrorOf(scene.mechanism, quarter.exact)
                      .at(Quantity::velocity, 0, instant_of(quarter.state));
    own.points.push_back(std::move(point));
  }
  own.points.back().is_default = true;
  chart.series.push_back(std::move(own));
  chart.guides = {{-1.0, 0}, {-1.0, 3}};
  const Point& three = chart.series[0].points.back();
  const Point& five = chart.series[1].points.back();
  const Point& program = chart.series[3].points.back();
  chart.lesson = fmt::format(
      "Next to a turning point the driver's phase counts, not the linkage: rounded to three digits "
      "it leaves velocities with an error of {:.0e}, with five digits throughout {:.0e}, in double "
      "{:.0e}. Carry the phase in full; a small velocity has fewer digits than its neighbours.",
      three.error, five.error, program.error);
  return chart;
}

}  // namespace

TopicResult precision(const Scenes& scenes, const Effort& effort) {
  return on_driven_scene(scenes, [&](const DrivenScene& scene) {
    TopicResult result;
    const ReferenceMotion reference = reference_of(scene, instants_of(scene));
    std::vector<Run> runs;
    std::size_t series = 0;
    for (const LinearMethod method : {LinearMethod::dense, LinearMethod::sparse}) {
      runs.push_back(run_in<Decimal<5>>(scene, reference, method));
      runs.push_back(run_in<float>(scene, reference, method));
      runs.push_back(run_in<double>(scene, reference, method));
      runs.push_back(run_in<long double>(scene, reference, method));
      for (std::size_t i = runs.size() - 4; i < runs.size(); ++i) runs[i].series = series;
      ++series;
    }
    runs.push_back(program_run(scene, reference));
    runs.back().series = series;
    runs.back().point.setting = "double";
    runs.back().point.parameter = Format<double>::bits;
    runs.back().point.operations = Format<double>::bits;
    time_runs(runs, reference.times.size(), effort);
    for (const Quantity quantity :
         {Quantity::position, Quantity::velocity, Quantity::acceleration, Quantity::reaction}) {
      result.charts.push_back(format_chart(scene, reference, runs, quantity));
    }
    const HarmonicDriver* const driver = harmonic_of(scene.mechanism);
    if (driver != nullptr && scene.mechanism.equations() == scene.mechanism.coordinates()) {
      result.charts.push_back(turning_chart(scene, *driver));
    }
    return result;
  });
}

}  // namespace boxbeam::charts
