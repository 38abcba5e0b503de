#include "boxbeam/study/distribution.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace boxbeam {
namespace {

using std::numbers::sqrt2;

/// 2 ln Gamma(1 + 1/k) - ln Gamma(1 + 2/k) + ln(1 + v^2): zero where the coefficient of variation
/// is v.
double weibull_shape(double variation) {
  const double wanted = std::log1p(variation * variation);
  const auto above = [&](double log_k) {
    const double inverse = std::exp(-log_k);
    return std::lgamma(1.0 + 2.0 * inverse) - 2.0 * std::lgamma(1.0 + inverse) - wanted;
  };
  std::uintmax_t most = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      above, std::log(0.05), std::log(1e4), boost::math::tools::eps_tolerance<double>(50), most);
  return std::exp(0.5 * (low + high));
}

/// Nodes and weights of Gauss' rule for the standard normal density (Golub, Welsch 1969).
struct NormalRule {
  Eigen::VectorXd z, weight;
};

const NormalRule& normal_rule() {
  static const NormalRule rule = [] {
    constexpr Eigen::Index count = 64;
    Eigen::VectorXd below(count - 1);
    for (Eigen::Index k = 0; k < below.size(); ++k)
      below[k] = std::sqrt(static_cast<double>(k + 1));
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> jacobi;
    jacobi.computeFromTridiagonal(Eigen::VectorXd::Zero(count), below);
    return NormalRule{jacobi.eigenvalues(),
                      jacobi.eigenvectors().row(0).transpose().array().square()};
  }();
  return rule;
}

/// The value of a variable whose normal one is z, less its mean, over its standard deviation.
double standardised(const Distribution& x, double z) {
  return (x.value_at(z) - x.mean()) / x.standard_deviation();
}

/// The correlation of two variables whose normal ones have this.
double correlation_of(const Distribution& x, const Distribution& y, double normal) {
  const NormalRule& rule = normal_rule();
  const double rest = std::sqrt(std::max(0.0, 1.0 - normal * normal));
  double sum = 0.0;
  for (Eigen::Index i = 0; i < rule.z.size(); ++i) {
    double inner = 0.0;
    for (Eigen::Index j = 0; j < rule.z.size(); ++j)
      inner += rule.weight[j] * standardised(y, normal * rule.z[i] + rest * rule.z[j]);
    sum += rule.weight[i] * standardised(x, rule.z[i]) * inner;
  }
  return sum;
}

}  // namespace

double normal_share_below(double z) { return 0.5 * boost::math::erfc(-z / sqrt2); }

double normal_quantile(double u) { return -sqrt2 * boost::math::erfc_inv(2.0 * u); }

double Distribution::quantile(double u) const {
  switch (kind) {
    case DistributionKind::normal: return a + b * normal_quantile(u);
    case DistributionKind::lognormal: return std::exp(a + b * normal_quantile(u));
    case DistributionKind::uniform: return a + u * (b - a);
    case DistributionKind::weibull: return a * std::pow(-std::log1p(-u), 1.0 / b);
    case DistributionKind::gumbel: return a - b * std::log(-std::log(u));
    case DistributionKind::exponential: return -a * std::log1p(-u);
  }
  return 0.0;
}

double Distribution::value_at(double z) const {
  constexpr double least = std::numeric_limits<double>::min();
  const auto below = [&] { return std::max(least, normal_share_below(z)); };
  const auto above = [&] { return std::max(least, normal_share_below(-z)); };
  // Logarithms of the smaller share by itself: the other one is 1 but for it.
  const auto log_below = [&] { return z < 0.0 ? std::log(below()) : std::log1p(-above()); };
  const auto log_above = [&] { return z > 0.0 ? std::log(above()) : std::log1p(-below()); };
  switch (kind) {
    case DistributionKind::normal: return a + b * z;
    case DistributionKind::lognormal: return std::exp(a + b * z);
    case DistributionKind::uniform: return z < 0.0 ? a + below() * (b - a) : b - above() * (b - a);
    case DistributionKind::weibull: return a * std::pow(-log_above(), 1.0 / b);
    case DistributionKind::gumbel: return a - b * std::log(-log_below());
    case DistributionKind::exponential: return -a * log_above();
  }
  return 0.0;
}

double Distribution::mean() const {
  switch (kind) {
    case DistributionKind::normal: return a;
    case DistributionKind::lognormal: return std::exp(a + 0.5 * b * b);
    case DistributionKind::uniform: return 0.5 * (a + b);
    case DistributionKind::weibull: return a * std::tgamma(1.0 + 1.0 / b);
    case DistributionKind::gumbel: return a + b * std::numbers::egamma;
    case DistributionKind::exponential: return a;
  }
  return 0.0;
}

double Distribution::standard_deviation() const {
  switch (kind) {
    case DistributionKind::normal: return b;
    case DistributionKind::lognormal: return mean() * std::sqrt(std::expm1(b * b));
    case DistributionKind::uniform: return (b - a) / std::sqrt(12.0);
    case DistributionKind::weibull:
      return a * std::sqrt(std::tgamma(1.0 + 2.0 / b) - std::pow(std::tgamma(1.0 + 1.0 / b), 2));
    case DistributionKind::gumbel: return b * std::numbers::pi / std::sqrt(6.0);
    case DistributionKind::exponential: return a;
  }
  return 0.0;
}

Distribution distribution_by_moments(DistributionKind kind, double mean, double sd) {
  switch (kind) {
    case DistributionKind::normal: return {kind, mean, sd};
    case DistributionKind::lognormal: {
      const double variance = std::log1p(std::pow(sd / mean, 2));
      return {kind, std::log(mean) - 0.5 * variance, std::sqrt(variance)};
    }
    case DistributionKind::uniform:
      return {kind, mean - std::sqrt(3.0) * sd, mean + std::sqrt(3.0) * sd};
    case DistributionKind::weibull: {
      const double shape = weibull_shape(sd / mean);
      return {kind, mean / std::tgamma(1.0 + 1.0 / shape), shape};
    }
    case DistributionKind::gumbel: {
      const double scale = sd * std::sqrt(6.0) / std::numbers::pi;
      return {kind, mean - std::numbers::egamma * scale, scale};
    }
    case DistributionKind::exponential: return {kind, mean, 1.0};
  }
  return {};
}

double normal_correlation(const Distribution& x, const Distribution& y, double rho) {
  constexpr double most = 1.0 - 1e-9;
  if (rho == 0.0) return 0.0;
  const auto above = [&](double normal) { return correlation_of(x, y, normal) - rho; };
  const double low = above(-most), high = above(most);
  if (low > 0.0 || high < 0.0)
    throw std::domain_error("no correlation of normal variables gives it");
  std::uintmax_t steps = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      above, -most, most, low, high, boost::math::tools::eps_tolerance<double>(44), steps);
  return 0.5 * (a + b);
}

}  // namespace boxbeam
