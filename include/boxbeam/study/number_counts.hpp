#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace boxbeam {

/// How often numbers occur, in bounded memory: each number by itself while there are few unlike
/// ones, then those together that agree in all but the last bits of their mantissa,
///
///     b = bits of x in the order of numbers, without the last k,
///
/// k the least with which there are no more than `most` unlike b. So k, and with it all that is
/// said, hangs on the numbers alone, whatever their order and however parts of them were joined.
/// Where k > 0 a number is known to a relative error of 2^(k-53) (of numbers above 2.3e-308); the
/// count below it is exact. Source: as in Masson, Rim, Lee, DDSketch, VLDB 12 (2019), with
/// mantissas in place of logarithms, and bins that only ever merge.
class NumberCounts {
 public:
  explicit NumberCounts(std::size_t most = 1U << 14U) : most_(most) {}

  /// A finite number.
  void add(double number);
  /// Those of another; the coarser of the two counts.
  void add(const NumberCounts& other);

  std::uint64_t count() const { return count_; }
  double least() const { return least_; }
  double largest() const { return largest_; }
  /// Relative error of a number that is neither the least nor the largest; 0 where all are exact.
  double error() const;
  /// The smallest number that such a share of all is not above. Of none: 0.
  double quantile(double share) const;
  /// How many lie in each of so many equal parts from the least to the largest number.
  std::vector<std::uint64_t> parts(std::size_t count) const;

  /// As text that `number_counts_in` reads to the same. Words and numbers, with spaces between.
  std::string text() const;

 private:
  friend NumberCounts number_counts_in(std::string_view text, std::size_t most);

  double number_of(std::uint64_t bin) const;
  void coarsen(unsigned dropped);
  void keep_few();

  std::size_t most_;
  unsigned dropped_ = 0;                         ///< bits, k above
  std::map<std::uint64_t, std::uint64_t> bins_;  ///< counts
  std::uint64_t count_ = 0;
  double least_ = 0.0, largest_ = 0.0;
};

/// Throws std::invalid_argument where the text is none of `NumberCounts::text`.
NumberCounts number_counts_in(std::string_view text, std::size_t most = 1U << 14U);

}  // namespace boxbeam
