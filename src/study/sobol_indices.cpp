#include "boxbeam/study/sobol_indices.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/study/design_space.hpp"

namespace boxbeam {
namespace {

constexpr std::uint64_t stream_of_resamples = 6;
constexpr std::size_t fewest_pairs = 10;

/// What one pair of designs adds to the sums.
struct PairTerms {
  double sum = 0.0, squares = 0.0;   ///< of f_A and f_B
  std::vector<double> first, total;  ///< of each variable
};

/// Sums over pairs, and what they come to.
struct IndexSums {
  explicit IndexSums(std::size_t variables) : first(variables), total(variables) {}

  void add(const PairTerms& pair) {
    count += 1.0;
    sum += pair.sum;
    squares += pair.squares;
    for (std::size_t i = 0; i < first.size(); ++i) {
      first[i] += pair.first[i];
      total[i] += pair.total[i];
    }
  }
  double variance() const {
    const double mean = sum / (2.0 * count);
    return squares / (2.0 * count) - mean * mean;
  }
  double first_of(std::size_t i) const { return first[i] / count / variance(); }
  double total_of(std::size_t i) const { return total[i] / (2.0 * count) / variance(); }

  double count = 0.0, sum = 0.0, squares = 0.0;
  std::vector<double> first, total;
};

/// Of the pairs of which every design has a result.
std::vector<PairTerms> terms_of(const std::vector<double>& values, std::size_t variables) {
  const std::size_t block = variables + 2;
  std::vector<const double*> whole;
  double sum = 0.0;
  for (std::size_t at = 0; at + block <= values.size(); at += block) {
    const double* const of = values.data() + at;
    if (std::any_of(of, of + block, [](double value) { return !std::isfinite(value); })) continue;
    whole.push_back(of);
    sum += of[0] + of[1];
  }
  // Less the mean, so that a large one leaves no error in small differences.
  const double mean = whole.empty() ? 0.0 : sum / (2.0 * static_cast<double>(whole.size()));
  std::vector<PairTerms> all;
  all.reserve(whole.size());
  for (const double* const of : whole) {
    const double a = of[0] - mean, b = of[1] - mean;
    PairTerms pair{a + b, a * a + b * b, {}, {}};
    for (std::size_t i = 0; i < variables; ++i) {
      const double mixed = of[2 + i] - mean;
      pair.first.push_back(b * (mixed - a));
      pair.total.push_back((a - mixed) * (a - mixed));
    }
    all.push_back(std::move(pair));
  }
  return all;
}

/// Bounds that 2.5 % of the estimates lie beyond on either side.
BoundedEstimate bounded(double value, std::vector<double> estimates) {
  std::sort(estimates.begin(), estimates.end());
  const auto last = static_cast<double>(estimates.size() - 1);
  const auto at = [&](double share) {
    return estimates[static_cast<std::size_t>(std::llround(share * last))];
  };
  constexpr double beyond = 0.025;
  return {value, at(beyond), at(1.0 - beyond)};
}

}  // namespace

SobolIndices sobol_indices_of(const std::vector<double>& values, const IndexPlan& plan) {
  const std::size_t variables = plan.variables.size();
  const std::vector<PairTerms> pairs = terms_of(values, variables);
  SobolIndices indices;
  indices.samples = pairs.size();
  indices.left_out = values.size() / (variables + 2) - pairs.size();
  if (pairs.size() < fewest_pairs) return indices;
  IndexSums all(variables);
  for (const PairTerms& pair : pairs) all.add(pair);
  indices.variance = all.variance();
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  constexpr double rounding = 1e-12;
  if (!(indices.variance > std::pow(rounding * largest, 2))) return indices;
  std::vector<std::vector<double>> first(variables), total(variables);
  for (std::size_t again = 0; again < plan.resamples; ++again) {
    IndexSums drawn(variables);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const double share = uniform_number(plan.seed, stream_of_resamples << 44U | k,
                                          static_cast<std::uint32_t>(again));
      drawn.add(pairs[static_cast<std::size_t>(share * static_cast<double>(pairs.size()))]);
    }
    if (!(drawn.variance() > 0.0)) continue;
    for (std::size_t i = 0; i < variables; ++i) {
      first[i].push_back(drawn.first_of(i));
      total[i].push_back(drawn.total_of(i));
    }
  }
  for (std::size_t i = 0; i < variables; ++i)
    indices.of.push_back({bounded(all.first_of(i), std::move(first[i])),
                          bounded(all.total_of(i), std::move(total[i]))});
  return indices;
}

}  // namespace boxbeam
