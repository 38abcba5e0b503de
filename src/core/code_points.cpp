#include "boxbeam/core/code_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace boxbeam {
namespace {

constexpr char32_t stray = 0xDC00;

struct Form {
  unsigned mask;       ///< of the first byte
  unsigned lead;       ///< its fixed bits
  std::size_t length;  ///< bytes in all
  char32_t smallest;   ///< below it the form is overlong
};

constexpr std::array<Form, 4> forms{
    {{0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}}};

bool in(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const CodePoint none{stray + byte(0), 1};
  for (const Form& form : forms) {
    if ((byte(0) & form.mask) != form.lead) continue;
    if (text.size() - at < form.length) return none;
    char32_t code = byte(0) & ~form.mask & 0xFFU;
    for (std::size_t i = 1; i < form.length; ++i) {
      if ((byte(i) & 0xC0U) != 0x80U) return none;
      code = (code << 6U) | (byte(i) & 0x3FU);
    }
    if (code < form.smallest || code > 0x10FFFF || in(code, 0xD800, 0xDFFF)) return none;
    return {code, form.length};
  }
  return none;
}

std::u32string code_points_of(std::string_view text) {
  std::u32string points;
  points.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    points += point.code;
    at += point.length;
  }
  return points;
}

std::string small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

bool is_stray_byte(char32_t code) { return in(code, stray + 0x80, stray + 0xFF); }

bool is_hidden(char32_t code) {
  return code < 0x20 || in(code, 0x7F, 0x9F) || code == 0x061C || code == 0x200B ||
         in(code, 0x200E, 0x200F) || in(code, 0x2028, 0x202E) || in(code, 0x2060, 0x206F) ||
         code == 0xFEFF || (code & 0xFFFEU) == 0xFFFE || is_stray_byte(code);
}

std::string escape_of(char32_t code) {
  switch (code) {
    case '\n': return "\\n";
    case '\r': return "\\r";
    case '\t': return "\\t";
    default: break;
  }
  if (is_stray_byte(code)) code -= stray;
  const auto number = static_cast<unsigned>(code);
  return number < 0x100 ? fmt::format("\\x{:02X}", number) : fmt::format("\\u{:04X}", number);
}

std::string visible(std::string_view text, std::string_view kept) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0;;) {
    const auto* const from = text.data() + at;
    const auto* const plain = std::find_if_not(from, text.data() + text.size(), is_plain);
    out.append(from, plain);
    at = static_cast<std::size_t>(plain - text.data());
    if (at == text.size()) return out;
    const CodePoint point = code_point_at(text, at);
    const std::string_view bytes = text.substr(at, point.length);
    if (is_hidden(point.code) && kept.find(bytes) == std::string_view::npos) {
      out += escape_of(point.code);
    } else {
      out += bytes;
    }
    at += point.length;
  }
}

}  // namespace boxbeam
