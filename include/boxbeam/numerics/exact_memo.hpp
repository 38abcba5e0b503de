#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace boxbeam {

/// Values of a function of so many numbers, each found once: kept by the bits of its arguments, so
/// that what is found again is what the function would give. Forgets all when it holds too many.
template <std::size_t arguments, class Value>
class ExactMemo {
 public:
  using Arguments = std::array<double, arguments>;

  /// What is known of these arguments, or else what `find` gives. Stays until others are asked for.
  template <class Find>
  const Value& of(const Arguments& at, const Find& find) {
    if (const auto known = values_.find(at); known != values_.end()) return known->second;
    Value found = find();
    if (values_.size() >= most) values_.clear();
    return values_.emplace(at, std::move(found)).first->second;
  }

 private:
  static constexpr std::size_t most = 4096;

  using Bits = std::array<std::uint64_t, arguments>;
  struct Hash {
    std::size_t operator()(const Arguments& at) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t bits : std::bit_cast<Bits>(at)) {
        // The multiplier and the shift of splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
        hash = (hash ^ bits) * 0xbf58476d1ce4e5b9U;
        hash ^= hash >> 31U;
      }
      return hash;
    }
  };
  struct Same {
    bool operator()(const Arguments& a, const Arguments& b) const {
      return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
    }
  };

  std::unordered_map<Arguments, Value, Hash, Same> values_;
};

}  // namespace boxbeam
