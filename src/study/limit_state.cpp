#include "boxbeam/study/limit_state.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/distribution.hpp"

namespace boxbeam {

LimitState::LimitState(Eigen::Index dimension, const std::function<Function()>& make,
                       std::size_t threads, std::size_t grain)
    : dimension_(dimension), grain_(std::max<std::size_t>(1, grain)) {
  for (std::size_t i = 0; i < std::max<std::size_t>(1, threads); ++i) functions_.push_back(make());
}

std::vector<double> LimitState::at(const std::vector<Eigen::VectorXd>& points) {
  std::vector<Response> responses(points.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr trouble;
  std::mutex of_trouble;
  const auto work = [&](const Function& function) {
    try {
      for (std::size_t from = next.fetch_add(grain_); from < points.size();
           from = next.fetch_add(grain_))
        for (std::size_t i = from; i < std::min(from + grain_, points.size()); ++i)
          responses[i] = function(points[i]);
    } catch (...) {
      const std::lock_guard lock(of_trouble);
      if (!trouble) trouble = std::current_exception();
      next = points.size();
    }
  };
  const std::size_t threads = std::min(functions_.size(), (points.size() + grain_ - 1) / grain_);
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < threads; ++i)
      helpers.emplace_back([&work, this, i] { work(functions_[i]); });
    work(functions_.front());
  }
  if (trouble) std::rethrow_exception(trouble);
  std::vector<double> values;
  values.reserve(points.size());
  calls_ += points.size();
  for (Response& response : responses) {
    if (response.trouble.empty() && std::isnan(response.g))
      response.trouble = "the limit state is no number";
    if (!response.trouble.empty()) {
      response.g = -std::numeric_limits<double>::infinity();
      if (troubled_++ == 0) first_trouble_ = response.trouble;
    }
    values.push_back(response.g);
  }
  return values;
}

Eigen::VectorXd normal_point(std::uint64_t seed, std::uint32_t stream, std::uint64_t index,
                             Eigen::Index dimension) {
  constexpr unsigned of_stream = 44;  // 1.7e13 points of each
  Eigen::VectorXd u(dimension);
  for (Eigen::Index k = 0; k < dimension; ++k)
    u[k] = normal_quantile(uniform_number(seed, std::uint64_t{stream} << of_stream | index,
                                          static_cast<std::uint32_t>(k)));
  return u;
}

}  // namespace boxbeam
