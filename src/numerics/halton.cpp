#include "boxbeam/numerics/halton.hpp"

namespace boxbeam {
namespace {

/// Term `index` of the van der Corput sequence in a base.
double van_der_corput(int index, int base) {
  double value = 0.0;
  double digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

int next_prime(int after) {
  for (int candidate = after + 1;; ++candidate) {
    bool prime = true;
    for (int d = 2; d * d <= candidate; ++d) prime = prime && candidate % d != 0;
    if (prime) return candidate;
  }
}

}  // namespace

std::vector<double> halton_point(int index, int dimensions) {
  std::vector<double> point;
  int prime = 1;
  for (int i = 0; i < dimensions; ++i) {
    prime = next_prime(prime);
    point.push_back(van_der_corput(index, prime));
  }
  return point;
}

}  // namespace boxbeam
