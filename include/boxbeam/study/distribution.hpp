#pragma once

namespace boxbeam {

/// How a value scatters.
enum class DistributionKind { normal, lognormal, uniform, weibull, gumbel, exponential };

/// A distribution by its own parameters.
///
///     normal       mean a, standard deviation b
///     lognormal    ln x normal with mean a and standard deviation b
///     uniform      from a to b
///     weibull      F = 1 - exp(-(x/a)^b), scale a, shape b, x > 0
///     gumbel       F = exp(-exp(-(x - a)/b)), of largest values
///     exponential  F = 1 - exp(-x/a), x > 0
struct Distribution {
  DistributionKind kind = DistributionKind::normal;
  double a = 0.0, b = 1.0;

  /// The value that a share u of all is below, 0 < u < 1.
  double quantile(double u) const;
  /// The same where the share is that of a standard normal variable below z; exact far out, too.
  double value_at(double z) const;
  double mean() const;
  double standard_deviation() const;
};

/// By its mean and standard deviation (uniform and exponential too, of these the latter by the mean
/// alone). Preconditions: sd > 0; mean > 0 of lognormal, weibull and exponential. Of the Weibull
/// distribution the shape is found by the root of the squared coefficient of variation,
/// Gamma(1 + 2/k)/Gamma(1 + 1/k)^2 - 1.
Distribution distribution_by_moments(DistributionKind kind, double mean, double sd);

/// Distribution function and quantile of the standard normal distribution.
double normal_share_below(double z);
double normal_quantile(double u);

/// The correlation of the normal variables behind two others so that these have the correlation
/// `rho` (Nataf's model); found by Gauss-Hermite quadrature of their product. Throws
/// std::domain_error where no normal variables give it. Source: Liu, Der Kiureghian, Probabilistic
/// Engineering Mechanics 1 (1986).
double normal_correlation(const Distribution& x, const Distribution& y, double rho);

}  // namespace boxbeam
