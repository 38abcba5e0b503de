#include "simulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/distribution.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::uint32_t stream_of_monte_carlo = 2, stream_of_importance = 3,
                        stream_of_components = 4;
constexpr std::size_t fewest_failing = 10;  // below it a coefficient of variation means little

/// How many samples the next estimate rests on: a tenth more, so that a history is short and the
/// same on any number of threads.
std::size_t next_count(std::size_t samples, const ReliabilityDemand& demand) {
  const std::size_t more = std::max<std::size_t>(50, samples / 10);
  return std::min(demand.samples, samples + more);
}

}  // namespace

Estimate share_estimate(std::size_t samples, std::size_t failing) {
  using boost::math::binomial_distribution;
  const auto n = static_cast<double>(samples), k = static_cast<double>(failing);
  Estimate of;
  of.samples = samples;
  of.p_f = k / n;
  of.variation = failing > 0 ? std::sqrt((1.0 - of.p_f) / k) : 0.0;
  constexpr double beyond = 0.025;
  of.low = failing == 0 ? 0.0 : binomial_distribution<>::find_lower_bound_on_p(n, k, beyond);
  of.high = failing == samples ? 1.0 : binomial_distribution<>::find_upper_bound_on_p(n, k, beyond);
  return of;
}

Estimate lognormal_estimate(std::size_t samples, double p_f, double variation) {
  constexpr double of_95_percent = 1.959963984540054;
  const double spread = std::exp(of_95_percent * std::sqrt(std::log1p(variation * variation)));
  return {samples, p_f, variation, p_f / spread, std::min(1.0, p_f * spread)};
}

void conclude(MethodResult& result, const ReliabilityDemand& demand) {
  if (result.history.empty()) return;
  const Estimate& last = result.history.back();
  result.samples = last.samples;
  result.low = last.low;
  result.high = last.high;
  if (last.p_f <= 0.0) {
    result.reason = fmt::format(
        "none of {} samples fails: p_f is below {:.2g} with 97.5 % confidence, no more is known",
        last.samples, last.high);
    return;
  }
  if (last.p_f >= 1.0) {
    result.reason = fmt::format(
        "all of {} samples fail: p_f is above {:.6g} with 97.5 % confidence, no more is known",
        last.samples, last.low);
    return;
  }
  result.p_f = last.p_f;
  result.beta = reliability_index(last.p_f);
  result.converged = last.variation <= demand.variation && result.failing >= fewest_failing;
  if (!result.converged && result.reason.empty())
    result.reason = fmt::format(
        "{} samples do not suffice for a coefficient of variation of {}: {} of them fail",
        last.samples, demand.variation, result.failing);
}

MethodResult monte_carlo(LimitState& limit_state, const ReliabilityDemand& demand,
                         std::uint64_t seed) {
  MethodResult result;
  result.method = ReliabilityMethod::monte_carlo;
  std::size_t samples = 0;
  while (samples < demand.samples) {
    const std::size_t end = next_count(samples, demand);
    std::vector<VectorXd> points;
    for (std::size_t i = samples; i < end; ++i)
      points.push_back(normal_point(seed, stream_of_monte_carlo, i, limit_state.dimension()));
    for (const double g : limit_state.at(points)) result.failing += g < 0.0 ? 1 : 0;
    samples = end;
    result.history.push_back(share_estimate(samples, result.failing));
    // Of many that fail the others are the rare ones.
    const std::size_t rarer = std::min(result.failing, samples - result.failing);
    if (rarer >= fewest_failing && result.history.back().variation <= demand.variation) break;
  }
  conclude(result, demand);
  return result;
}

MethodResult importance_sampling(LimitState& limit_state, const ReliabilityDemand& demand,
                                 const DesignPoints& about, std::uint64_t seed) {
  MethodResult result;
  result.method = ReliabilityMethod::importance;
  if (about.points.empty()) {
    result.reason = "there is no design point to sample about: " + about.reason;
    return result;
  }
  std::vector<double> weights;
  double all = 0.0;
  for (const DesignPoint& point : about.points) {
    weights.push_back(normal_share_below(-point.beta));
    all += weights.back();
  }
  const double sign = about.mean_fails ? -1.0 : 1.0;
  double sum = 0.0, squares = 0.0;
  std::size_t samples = 0, rare = 0;
  while (samples < demand.samples) {
    const std::size_t end = next_count(samples, demand);
    std::vector<VectorXd> points;
    for (std::size_t i = samples; i < end; ++i) {
      double place = all * uniform_number(seed, std::uint64_t{stream_of_components} << 44U | i, 0);
      std::size_t component = 0;
      while (component + 1 < weights.size() && place > weights[component])
        place -= weights[component++];
      points.emplace_back(about.points[component].u +
                          normal_point(seed, stream_of_importance, i, limit_state.dimension()));
    }
    const std::vector<double> g = limit_state.at(points);
    for (std::size_t i = 0; i < g.size(); ++i) {
      if (!(sign * g[i] < 0.0)) continue;
      double density = 0.0;  // q/phi
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const VectorXd& u = about.points[k].u;
        density += weights[k] / all * std::exp(u.dot(points[i]) - 0.5 * u.squaredNorm());
      }
      sum += 1.0 / density;
      squares += 1.0 / (density * density);
      ++rare;
    }
    samples = end;
    const auto n = static_cast<double>(samples);
    const double mean = sum / n;
    double variation =
        mean > 0.0 ? std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1.0)) / mean : 0.0;
    Estimate estimate = lognormal_estimate(samples, mean, variation);
    if (about.mean_fails)
      estimate = {samples, 1.0 - mean, variation * mean / (1.0 - mean), 1.0 - estimate.high,
                  1.0 - estimate.low};
    result.history.push_back(estimate);
    // Few samples may have missed those that count most.
    constexpr std::size_t fewest = 200;
    if (samples >= std::min(fewest, demand.samples) && rare >= fewest_failing &&
        variation <= demand.variation)
      break;
  }
  result.failing = about.mean_fails ? samples - rare : rare;
  conclude(result, demand);
  return result;
}

}  // namespace boxbeam
