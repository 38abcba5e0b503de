#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace boxbeam {

/// What a limit state says of a design: below zero it fails.
struct Response {
  double g = -std::numeric_limits<double>::infinity();
  std::string trouble;  ///< why it could not be judged; g counts for nothing then
};

/// A limit state as a function of independent standard normal variables u. A design that cannot be
/// judged, or whose g is no number, counts as one that fails: g is minus infinity. Counts its
/// evaluations; what it says hangs on the points alone, not on the number of threads.
class LimitState {
 public:
  using Function = std::function<Response(const Eigen::VectorXd&)>;

  /// `make`: the function, once for each thread. `grain`: so many points at least are worth a
  /// thread of their own.
  LimitState(Eigen::Index dimension, const std::function<Function()>& make, std::size_t threads = 1,
             std::size_t grain = 1);

  Eigen::Index dimension() const { return dimension_; }
  double at(const Eigen::VectorXd& u) { return at(std::vector<Eigen::VectorXd>{u}).front(); }
  std::vector<double> at(const std::vector<Eigen::VectorXd>& points);

  std::size_t calls() const { return calls_; }
  std::size_t troubled() const { return troubled_; }  ///< of them could not be judged
  const std::string& first_trouble() const { return first_trouble_; }

 private:
  Eigen::Index dimension_;
  std::vector<Function> functions_;  ///< one for each thread
  std::size_t grain_;
  std::size_t calls_ = 0, troubled_ = 0;
  std::string first_trouble_;
};

/// A point of so many standard normal variables, by Philox from the seed; `stream` tells those of
/// one use from those of others.
Eigen::VectorXd normal_point(std::uint64_t seed, std::uint32_t stream, std::uint64_t index,
                             Eigen::Index dimension);

}  // namespace boxbeam
