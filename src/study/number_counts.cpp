#include "boxbeam/study/number_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace boxbeam {
namespace {

constexpr unsigned mantissa_bits = 52;
constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63U;

/// Whole numbers in the order of the numbers; 0 and -0 are one.
std::uint64_t ordered_bits(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number + 0.0);
  return (bits & sign_bit) != 0 ? ~bits : bits | sign_bit;
}

double number_of_ordered(std::uint64_t ordered) {
  return std::bit_cast<double>((ordered & sign_bit) != 0 ? ordered ^ sign_bit : ~ordered);
}

/// Takes words off the front of a text.
class CountsText {
 public:
  explicit CountsText(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  template <class Number>
  Number next() {
    Number number{};
    const char* const end = rest_.data() + rest_.size();
    const auto [at, error] = std::from_chars(rest_.data(), end, number);
    if (error != std::errc{} || (at != end && *at != ' '))
      throw std::invalid_argument("no counts of numbers");
    rest_.remove_prefix(static_cast<std::size_t>(at - rest_.data()));
    if (!rest_.empty()) rest_.remove_prefix(1);
    return number;
  }

 private:
  std::string_view rest_;
};

}  // namespace

void NumberCounts::add(double number) {
  least_ = count_ == 0 ? number : std::min(least_, number);
  largest_ = count_ == 0 ? number : std::max(largest_, number);
  ++count_;
  ++bins_[ordered_bits(number) >> dropped_];
  keep_few();
}

void NumberCounts::add(const NumberCounts& other) {
  if (other.count_ == 0) return;
  least_ = count_ == 0 ? other.least_ : std::min(least_, other.least_);
  largest_ = count_ == 0 ? other.largest_ : std::max(largest_, other.largest_);
  count_ += other.count_;
  coarsen(std::max(dropped_, other.dropped_));
  for (const auto& [bin, count] : other.bins_) bins_[bin >> (dropped_ - other.dropped_)] += count;
  keep_few();
}

void NumberCounts::coarsen(unsigned dropped) {
  if (dropped == dropped_) return;
  std::map<std::uint64_t, std::uint64_t> merged;
  for (const auto& [bin, count] : bins_) {
    const std::uint64_t into = bin >> (dropped - dropped_);
    if (merged.empty() || merged.rbegin()->first != into)
      merged.emplace_hint(merged.end(), into, count);
    else
      merged.rbegin()->second += count;
  }
  bins_ = std::move(merged);
  dropped_ = dropped;
}

void NumberCounts::keep_few() {
  // Exponents stay apart: there are no more than 4094 of them.
  while (bins_.size() > most_ && dropped_ < mantissa_bits) coarsen(dropped_ + 1);
}

double NumberCounts::error() const {
  return dropped_ == 0
             ? 0.0
             : std::ldexp(1.0, static_cast<int>(dropped_) - static_cast<int>(mantissa_bits) - 1);
}

/// The middle of a bin.
double NumberCounts::number_of(std::uint64_t bin) const {
  if (dropped_ == 0) return number_of_ordered(bin);
  const std::uint64_t middle = (bin << dropped_) | (std::uint64_t{1} << (dropped_ - 1U));
  return std::clamp(number_of_ordered(middle), least_, largest_);
}

double NumberCounts::quantile(double share) const {
  if (count_ == 0) return 0.0;
  const auto place = static_cast<std::uint64_t>(
      std::max(1.0, std::ceil(std::min(share, 1.0) * static_cast<double>(count_))));
  if (place == 1) return least_;
  if (place >= count_) return largest_;
  std::uint64_t below = 0;
  for (const auto& [bin, count] : bins_) {
    below += count;
    if (below >= place) return number_of(bin);
  }
  return largest_;
}

std::vector<std::uint64_t> NumberCounts::parts(std::size_t count) const {
  std::vector<std::uint64_t> parts(count, 0);
  const double width = largest_ / 2.0 - least_ / 2.0;  // half of it, which does not overflow
  for (const auto& [bin, inside] : bins_) {
    const double share = width > 0.0 ? (number_of(bin) / 2.0 - least_ / 2.0) / width : 0.0;
    const auto part = static_cast<std::size_t>(share * static_cast<double>(count));
    parts[std::min(part, count - 1)] += inside;
  }
  return parts;
}

std::string NumberCounts::text() const {
  std::string text = fmt::format("{} {} {}", dropped_, least_, largest_);
  std::uint64_t before = 0;
  for (const auto& [bin, count] : bins_) {
    text += fmt::format(" {} {}", bin - before, count);
    before = bin;
  }
  return text;
}

NumberCounts number_counts_in(std::string_view text, std::size_t most) {
  CountsText from(text);
  NumberCounts counts(most);
  counts.dropped_ = from.next<unsigned>();
  if (counts.dropped_ > mantissa_bits) throw std::invalid_argument("no counts of numbers");
  counts.least_ = from.next<double>();
  counts.largest_ = from.next<double>();
  std::uint64_t bin = 0;
  while (!from.at_end()) {
    bin += from.next<std::uint64_t>();
    const auto count = from.next<std::uint64_t>();
    counts.bins_.emplace_hint(counts.bins_.end(), bin, count);
    counts.count_ += count;
  }
  counts.keep_few();
  return counts;
}

}  // namespace boxbeam
