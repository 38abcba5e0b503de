#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace boxbeam {

/// A number in the bytes of a file.
template <class Number>
Number number_of_bytes(const char* bytes, std::endian order) {
  std::array<char, sizeof(Number)> own{};
  std::memcpy(own.data(), bytes, own.size());
  if (order != std::endian::native) std::reverse(own.begin(), own.end());
  return std::bit_cast<Number>(own);
}

}  // namespace boxbeam
