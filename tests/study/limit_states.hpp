#pragma once

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "boxbeam/study/reliability.hpp"

/// Limit states that are functions in C++, and what is asked of them.
namespace boxbeam::test {

inline LimitState limit_state_of(Eigen::Index n, std::function<double(const Eigen::VectorXd&)> g,
                                 std::size_t threads = 1) {
  return LimitState(
      n, [g] { return [g](const Eigen::VectorXd& u) {
                 return Response{g(u), ""};
               }; }, threads,
      100);
}

inline ReliabilityDemand demand_of(std::vector<ReliabilityMethod> methods,
                                   double variation = 0.03) {
  ReliabilityDemand demand;
  demand.methods = std::move(methods);
  demand.variation = variation;
  demand.samples = 4'000'000;
  return demand;
}

inline const MethodResult& result_of(const ReliabilityResult& of, ReliabilityMethod method) {
  for (const MethodResult& result : of.methods)
    if (result.method == method) return result;
  throw std::runtime_error("not asked for");
}

/// How far a simulation may be from the truth, in coefficients of variation.
inline constexpr double within = 4.0;

/// A normal variable of a mean and a standard deviation.
inline double x(const Eigen::VectorXd& u, Eigen::Index i, double mean, double sd) {
  return mean + sd * u[i];
}

}  // namespace boxbeam::test
