#include "code_points.hpp"

#include <array>

namespace boxbeam::report {
namespace {

struct Form {
  unsigned mask;       ///< of the first byte
  unsigned lead;       ///< its fixed bits
  std::size_t length;  ///< bytes in all
  char32_t smallest;   ///< below it the form is overlong
};

constexpr std::array<Form, 4> forms{
    {{0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}}};

/// The code point at the front and its number of bytes; 0 bytes where there is none.
std::pair<char32_t, std::size_t> first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (const Form& form : forms) {
    if ((byte(0) & form.mask) != form.lead) continue;
    if (text.size() < form.length) break;
    char32_t point = byte(0) & ~form.mask & 0xFFU;
    for (std::size_t i = 1; i < form.length; ++i) {
      if ((byte(i) & 0xC0U) != 0x80U) return {0, 0};
      point = (point << 6U) | (byte(i) & 0x3FU);
    }
    const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
    if (point < form.smallest || point > 0x10FFFF || surrogate) break;
    return {point, form.length};
  }
  return {0, 0};
}

}  // namespace

std::u32string code_points_of(std::string_view text) {
  std::u32string points;
  points.reserve(text.size());
  while (!text.empty()) {
    const auto [point, length] = first_of(text);
    points += length > 0 ? point : 0xDC00U + static_cast<unsigned char>(text.front());
    text.remove_prefix(length > 0 ? length : 1);
  }
  return points;
}

}  // namespace boxbeam::report
