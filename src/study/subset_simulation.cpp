#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "simulations.hpp"

namespace boxbeam {
namespace {

using Eigen::VectorXd;

constexpr std::uint32_t stream_of_subsets = 16;  // and those behind it, one a repetition
constexpr std::size_t part = 10;                 // one of so many passes a level
constexpr std::size_t most_levels = 60;
constexpr double wanted_acceptance = 0.44;

struct Sample {
  VectorXd u;
  double g = 0.0;
};

/// The samples of a level: in chains, sample by sample one after the other, each of as many as
/// there are chains: all first ones, all second ones, ...
struct Level {
  Level(std::vector<Sample> of, std::size_t count)
      : samples(std::move(of)), chains(count), order(samples.size()) {
    std::iota(order.begin(), order.end(), std::size_t{0});
  }

  std::vector<Sample> samples;
  std::size_t chains;
  std::vector<std::size_t> order;  ///< of the samples by g, once sorted
};

/// How much the correlation in chains adds to the square of the coefficient of variation of a
/// share: 2 sum (1 - k/length) rho_k.
double added_by_chains(const Level& level, double limit, double share) {
  const std::size_t length = level.samples.size() / level.chains;
  const double spread = share * (1.0 - share);
  if (length < 2 || spread <= 0.0) return 0.0;
  double added = 0.0;
  for (std::size_t k = 1; k < length; ++k) {
    double both = 0.0;
    for (std::size_t i = 0; i + k * level.chains < level.samples.size(); ++i)
      if (level.samples[i].g <= limit && level.samples[i + k * level.chains].g <= limit)
        both += 1.0;
    const auto pairs = static_cast<double>((length - k) * level.chains);
    const double rho = (both / pairs - share * share) / spread;
    added += 2.0 * (1.0 - static_cast<double>(k) / static_cast<double>(length)) * rho;
  }
  return std::max(0.0, added);
}

/// What one run through all levels comes to.
struct Descent {
  double p_f = 1.0;
  double variation = 0.0;
  std::size_t failing = 0;
  std::size_t samples = 0;
  bool stalled = false;  ///< a level is no rarer than the one before it
};

class Subsets {
 public:
  Subsets(LimitState& limit_state, const ReliabilityDemand& demand, std::uint64_t seed)
      : limit_state_(&limit_state),
        seeds_(std::max<std::size_t>(2, demand.per_level / part)),
        seed_(seed) {}

  Descent run(std::uint32_t repetition) {
    stream_ = stream_of_subsets + repetition;
    next_point_ = 0;
    Descent of;
    Level level = first();
    of.samples = level.samples.size();
    double squares = 0.0, before = std::numeric_limits<double>::infinity();
    for (std::size_t depth = 0; depth < most_levels; ++depth) {
      std::stable_sort(level.order.begin(), level.order.end(), [&](std::size_t a, std::size_t b) {
        return level.samples[a].g < level.samples[b].g;
      });
      const auto ranked = [&](std::size_t rank) { return level.samples[level.order[rank]].g; };
      const double middle = 0.5 * (ranked(seeds_ - 1) + ranked(seeds_));
      const bool is_last = middle <= 0.0;
      const double limit = is_last ? -std::numeric_limits<double>::denorm_min() : middle;
      const auto below = static_cast<std::size_t>(
          std::count_if(level.samples.begin(), level.samples.end(),
                        [&](const Sample& sample) { return sample.g <= limit; }));
      if (below == 0 || (!is_last && !(middle < before))) break;
      before = middle;
      const auto n = static_cast<double>(level.samples.size());
      const double share = static_cast<double>(below) / n;
      of.p_f *= share;
      squares += (1.0 - share) / (share * n) * (1.0 + added_by_chains(level, limit, share));
      if (is_last) {
        of.failing = below;
        of.variation = std::sqrt(squares);
        return of;
      }
      level = below_limit(level, limit);
      of.samples += level.samples.size() - seeds_;
    }
    of.stalled = true;
    return of;
  }

 private:
  std::vector<Sample> judged(std::vector<VectorXd> points) {
    const std::vector<double> g = limit_state_->at(points);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < points.size(); ++i) samples.push_back({std::move(points[i]), g[i]});
    return samples;
  }

  VectorXd drawn() {
    return normal_point(seed_, stream_, next_point_++, limit_state_->dimension());
  }

  Level first() {
    std::vector<VectorXd> points;
    for (std::size_t i = 0; i < seeds_ * part; ++i) points.push_back(drawn());
    return Level(judged(std::move(points)), seeds_ * part);
  }

  /// Chains from the lowest samples of the level before.
  Level below_limit(const Level& before, double limit) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < seeds_; ++i) samples.push_back(before.samples[before.order[i]]);
    for (std::size_t link = 1; link < part; ++link) {
      const std::size_t last = samples.size() - seeds_;
      std::vector<VectorXd> tried;
      for (std::size_t i = 0; i < seeds_; ++i)
        tried.emplace_back(std::sqrt(1.0 - spread_ * spread_) * samples[last + i].u +
                           spread_ * drawn());
      std::vector<Sample> next = judged(std::move(tried));
      std::size_t accepted = 0;
      for (std::size_t i = 0; i < seeds_; ++i) {
        if (next[i].g <= limit)
          ++accepted;
        else
          next[i] = samples[last + i];
      }
      samples.insert(samples.end(), next.begin(), next.end());
      const double share = static_cast<double>(accepted) / static_cast<double>(seeds_);
      spread_ = std::clamp(
          spread_ * std::exp((share - wanted_acceptance) / std::sqrt(static_cast<double>(link))),
          0.02, 1.0);
    }
    return Level(std::move(samples), seeds_);
  }

  LimitState* limit_state_;
  std::size_t seeds_;
  std::uint64_t seed_;
  std::uint32_t stream_ = stream_of_subsets;
  std::uint64_t next_point_ = 0;
  double spread_ = 0.7;  ///< of the next place of a chain
};

}  // namespace

MethodResult subset_simulation(LimitState& limit_state, const ReliabilityDemand& demand,
                               std::uint64_t seed) {
  MethodResult result;
  result.method = ReliabilityMethod::subset;
  Subsets subsets(limit_state, demand, seed);
  double sum = 0.0, squares = 0.0, variances = 0.0;
  std::size_t samples = 0;
  for (std::uint32_t repetition = 0; repetition < 10'000; ++repetition) {
    const Descent of = subsets.run(repetition);
    samples += of.samples;
    if (of.stalled) {
      result.history.clear();
      result.samples = samples;
      result.failing = 0;
      result.reason =
          "a level is no rarer than the one before it: the limit state is flat where it should "
          "lead to failure, or failure is too rare";
      return result;
    }
    sum += of.p_f;
    squares += of.p_f * of.p_f;
    variances += std::pow(of.p_f * of.variation, 2);
    result.failing += of.failing;
    const double runs = repetition + 1.0, mean = sum / runs;
    double variation = std::sqrt(variances) / (runs * mean);
    // The formula leaves out how levels hang together; enough runs show it.
    constexpr double enough = 10.0;
    if (runs >= enough)
      variation = std::max(
          variation, std::sqrt(std::max(0.0, squares / runs - mean * mean) / (runs - 1.0)) / mean);
    result.history.push_back(lognormal_estimate(samples, mean, variation));
    if (variation <= demand.variation || samples + of.samples > demand.samples) break;
  }
  conclude(result, demand);
  return result;
}

}  // namespace boxbeam
