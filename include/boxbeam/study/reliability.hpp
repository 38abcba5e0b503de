#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/limit_state.hpp"

namespace boxbeam {

enum class ReliabilityMethod { form, sorm, monte_carlo, importance, subset };

inline constexpr std::array reliability_methods{
    ReliabilityMethod::form, ReliabilityMethod::sorm, ReliabilityMethod::monte_carlo,
    ReliabilityMethod::importance, ReliabilityMethod::subset};

/// "form", "sorm", "monte-carlo", "importance", "subset".
const char* to_text(ReliabilityMethod method);

/// What is asked of a limit state.
struct ReliabilityDemand {
  std::vector<std::string> checks;       ///< names of criteria, or "all"
  std::vector<std::string> expressions;  ///< failure where any is below zero
  std::vector<ReliabilityMethod> methods;
  std::size_t samples = 100'000;  ///< at most, of each simulation
  double variation = 0.05;        ///< coefficient of variation at which a simulation ends
  std::size_t per_level = 1000;   ///< samples of a level of subset simulation
  std::size_t starts = 24;        ///< of searches for design points, beside the mean
  std::size_t probes = 1000;      ///< designs as they scatter, against which points are held
  double step = 1e-4;             ///< of differences, in standard deviations
  double tolerance = 1e-4;        ///< of the direction of a design point [rad]
  std::optional<double> years;    ///< of service, over which p_f counts
};

/// A point at which a limit state is next to the origin, in standard normal space.
struct DesignPoint {
  Eigen::VectorXd u;
  Eigen::VectorXd alpha;       ///< u = beta alpha; above zero of what loads
  double beta = 0.0;           ///< below zero where the mean fails
  double slope = 0.0;          ///< of the limit state there, the length of its gradient
  Eigen::VectorXd curvatures;  ///< principal ones, above zero where failure bends away
  bool kinked = false;         ///< differences by two steps tell other curvatures
};

/// How an estimate stands after so many evaluations.
struct Estimate {
  std::size_t samples = 0;
  double p_f = 0.0;
  double variation = 0.0;        ///< coefficient of variation of p_f
  double low = 0.0, high = 0.0;  ///< of 95 % confidence
};

/// What one method says. Without p_f where it says nothing, which `reason` explains.
struct MethodResult {
  ReliabilityMethod method = ReliabilityMethod::form;
  bool converged = false;
  std::string reason;  ///< why it did not converge, or what is to be known of the result
  std::optional<double> p_f;
  std::optional<double> beta;      ///< of the nearest design point by form, else -Phi^-1(p_f)
  double low = 0.0, high = 0.0;    ///< Ditlevsen's bounds of form and sorm, else of 95 % confidence
  std::optional<double> breitung;  ///< p_f of sorm by Breitung's formula
  std::vector<Estimate> history;   ///< of simulations; the last one is the result
  std::size_t samples = 0;
  std::size_t failing = 0;   ///< of the samples
  std::size_t unjudged = 0;  ///< of the evaluations; they count as failing
  std::size_t calls = 0;     ///< of the limit state
};

struct ReliabilityResult {
  std::vector<DesignPoint> points;  ///< the nearest first
  std::vector<MethodResult> methods;
  std::string first_trouble;         ///< of designs that could not be judged
  std::vector<std::string> remarks;  ///< where methods disagree
  std::size_t calls = 0;
};

/// Probability that a limit state is below zero. `progress` hears what is being done.
ReliabilityResult reliability_of(LimitState& limit_state, const ReliabilityDemand& demand,
                                 std::uint64_t seed,
                                 const std::function<void(const std::string&)>& progress = {});

/// The index that belongs to a probability of failure, -Phi^-1(p_f); nothing of 0 and 1.
std::optional<double> reliability_index(double p_f);

/// Of one year, where years fail independently of each other: 1 - (1 - p_f)^(1/years).
double per_year(double p_f, double years);

}  // namespace boxbeam
