#pragma once

#include <random>

namespace test {

/// Evenly distributed numbers, from a seed.
class Uniform {
 public:
  explicit Uniform(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution(low, high)(engine_);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace test
