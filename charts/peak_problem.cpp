#include "charts/peak_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam::charts {
namespace {

/// The values at equal steps, their number one more where the time is open.
struct Samples {
  std::vector<double> values;
  double begin = 0.0, step = 0.0;
  std::size_t highest = 0;
};

Samples samples_of(const PeakProblem& problem, std::size_t instants, double phase) {
  Samples samples;
  samples.step = problem.period() / static_cast<double>(instants);
  samples.begin = problem.span.begin.value() + phase * samples.step;
  const std::size_t count = instants + (problem.span.closed ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    samples.values.push_back(problem.at(samples.begin + samples.step * static_cast<double>(i)));
  }
  samples.highest = static_cast<std::size_t>(
      std::max_element(samples.values.begin(), samples.values.end()) - samples.values.begin());
  return samples;
}

/// Whether the highest sample has a neighbour on either side.
bool has_neighbours(const PeakProblem& problem, const Samples& samples) {
  return problem.span.closed ||
         (samples.highest > 0 && samples.highest + 1 < samples.values.size());
}

}  // namespace

PeakProblem pulled_bar(std::string name, double period, std::size_t instants,
                       std::function<double(double)> f, double peak, double peak_time) {
  const Length length = 1.0 * metre;
  PeakProblem problem;
  problem.name = std::move(name);
  problem.span = {Time{}, si<Time>(period), instants, true};
  problem.loads = [f = std::move(f), length](Time time) {
    BeamLoads loads;
    const Eigen::Vector3d pull(f(time.value()), 0.0, 0.0);
    loads.points = {{Length{}, -pull, Eigen::Vector3d::Zero()},
                    {length, pull, Eigen::Vector3d::Zero()}};
    loads.lines = {{Length{}, length, {}, {}}};
    return loads;
  };
  problem.station = {0.5 * length};
  problem.quantity = [](const CutForces& cut) { return std::abs(cut.N.value()); };
  problem.peak = peak;
  problem.peak_time = peak_time;
  return problem;
}

FoundPeak peak_of_samples(const PeakProblem& problem, std::size_t instants, double phase) {
  const Samples samples = samples_of(problem, instants, phase);
  return {samples.values[samples.highest], static_cast<double>(samples.values.size())};
}

FoundPeak peak_by_parabola(const PeakProblem& problem, std::size_t instants, double phase) {
  const Samples samples = samples_of(problem, instants, phase);
  const std::size_t n = samples.values.size();
  FoundPeak found{samples.values[samples.highest], static_cast<double>(n)};
  if (!has_neighbours(problem, samples)) return found;
  const double before = samples.values[(samples.highest + n - 1) % n];
  const double behind = samples.values[(samples.highest + 1) % n];
  const double slope = 0.5 * (behind - before);
  const double bend = behind - 2.0 * found.value + before;
  if (bend < 0.0) found.value -= 0.5 * slope * slope / bend;
  return found;
}

FoundPeak peak_by_solves(const PeakProblem& problem, std::size_t instants, double phase) {
  const Samples samples = samples_of(problem, instants, phase);
  FoundPeak found{samples.values[samples.highest], static_cast<double>(samples.values.size())};
  if (!has_neighbours(problem, samples)) return found;
  const double middle = samples.begin + samples.step * static_cast<double>(samples.highest);
  const auto solve = [&](double time) {
    found.solves += 1.0;
    return problem.at(time);
  };
  const Extremum top = find_maximum(solve, middle - samples.step, middle + samples.step);
  found.value = std::max(found.value, top.value);
  return found;
}

FoundPeak peak_by_history(const PeakProblem& problem, std::size_t instants, double phase) {
  LoadSpan span = problem.span;
  span.instants = instants;
  span.begin += phase * span.period / static_cast<double>(instants);
  double solves = 0.0;
  const LoadHistory history(span, [&](Time time) {
    solves += 1.0;
    return problem.loads(time);
  });
  const double value = StationHistory(history, problem.station).largest(problem.quantity).value;
  return {value, solves};
}

FoundPeak worst_of_phases(const PeakProblem& problem, const PeakSearch& search,
                          std::size_t instants, int phases) {
  const int looks = problem.span.closed ? phases : 1;
  FoundPeak worst = search(problem, instants, 0.0);
  for (int k = 1; k < looks; ++k) {
    const FoundPeak found = search(problem, instants, static_cast<double>(k) / looks);
    if (error_of(problem, found) > error_of(problem, worst)) worst = found;
  }
  return worst;
}

double error_of(const PeakProblem& problem, const FoundPeak& found) {
  // Less than half a last digit cannot be seen.
  constexpr double least = 0.5 * std::numeric_limits<double>::epsilon();
  return std::max(least, std::abs(found.value - problem.peak) / std::abs(problem.peak));
}

}  // namespace boxbeam::charts
