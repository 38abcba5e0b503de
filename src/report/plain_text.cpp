#include "plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace boxbeam::plain_text {
namespace {

/// A character of UTF-8; where the bytes are none, one byte with `valid` false.
struct Character {
  char32_t code = 0;
  std::size_t length = 1;
  bool valid = false;
};

Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<char32_t>(static_cast<unsigned char>(text[i])) : 0U;
  };
  const char32_t first = byte(at);
  if (first < 0x80) return {first, 1, true};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return {first, 1, false};
  char32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) return {first, 1, false};
    code = (code << 6U) | (byte(at + i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < smallest[length] || code > 0x10FFFF || surrogate) return {first, 1, false};
  return {code, length, true};
}

bool in(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

/// Controls, marks that turn the direction of writing, and line and paragraph separators.
bool moves_the_cursor(char32_t code) {
  return code < 0x20 || in(code, 0x7F, 0x9F) || in(code, 0x200E, 0x200F) ||
         in(code, 0x2028, 0x202E) || in(code, 0x2066, 0x2069) || code == 0xFEFF;
}

bool combines(char32_t code) {
  return in(code, 0x300, 0x36F) || in(code, 0x200B, 0x200D) || in(code, 0x20D0, 0x20FF) ||
         in(code, 0xFE00, 0xFE0F);
}

bool is_wide(char32_t code) {
  return in(code, 0x1100, 0x115F) || in(code, 0x2E80, 0xA4CF) || in(code, 0xAC00, 0xD7A3) ||
         in(code, 0xF900, 0xFAFF) || in(code, 0xFE30, 0xFE6F) || in(code, 0xFF00, 0xFF60) ||
         in(code, 0xFFE0, 0xFFE6) || in(code, 0x1F300, 0x1FAFF) || in(code, 0x20000, 0x3FFFD);
}

std::string escape_of(const Character& character) {
  if (!character.valid) return fmt::format("\\x{:02X}", static_cast<unsigned>(character.code));
  switch (character.code) {
    case '\n': return "\\n";
    case '\r': return "\\r";
    case '\t': return "\\t";
    default: break;
  }
  const auto code = static_cast<unsigned>(character.code);
  return code < 0x100 ? fmt::format("\\x{:02X}", code) : fmt::format("\\u{:04X}", code);
}

/// Nothing to look at closely: printable ASCII.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// The bytes of a word that fit into so many columns, at least one character.
std::size_t bytes_within(std::string_view word, std::size_t columns) {
  std::size_t at = character_at(word, 0).length;
  while (at < word.size()) {
    const std::size_t next = at + character_at(word, at).length;
    if (columns_of(word.substr(0, next)) > columns) break;
    at = next;
  }
  return at;
}

/// The bytes of a word too long for so many columns that stand in the first line: up to a dot or
/// behind a slash, as keys and paths have them, where that fills half of the line.
std::size_t bytes_of_first_line(std::string_view word, std::size_t columns) {
  const auto is_digit = [&](std::size_t i) {
    return i < word.size() && word[i] >= '0' && word[i] <= '9';
  };
  const std::size_t most = bytes_within(word, columns);
  for (std::size_t at = most; at > most / 2 && at > 1; --at) {
    const bool in_number = is_digit(at - 1) && is_digit(at + 1);
    if (word[at - 1] == '/' || (word[at] == '.' && !in_number)) return at;
  }
  return most;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
  if (is_plain(text)) return text.size();
  std::size_t columns = 0;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = character_at(text, i);
    columns += combines(character.code) ? 0 : is_wide(character.code) ? 2 : 1;
    i += character.length;
  }
  return columns;
}

std::string shown(std::string_view text, bool lines) {
  if (is_plain(text)) return std::string(text);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = character_at(text, i);
    const bool stays = lines && (character.code == '\n' || character.code == '\t');
    if (!character.valid || (moves_the_cursor(character.code) && !stays)) {
      out += escape_of(character);
    } else {
      out += text.substr(i, character.length);
    }
    i += character.length;
  }
  return out;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::size_t first) {
  std::vector<std::string> out(1);
  std::size_t column = 0;
  const auto room = [&] { return out.size() == 1 ? first : width; };
  const auto new_line = [&] {
    out.emplace_back();
    column = 0;
  };
  for (std::size_t at = text.find_first_not_of(" \n\t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \n\t", at), text.size());
    std::string word = shown(text.substr(at, end - at));
    std::size_t length = columns_of(word);
    if (column > 0 && column + 1 + length > room()) new_line();
    while (length > room()) {
      const std::size_t part = bytes_of_first_line(word, room());
      out.back() = word.substr(0, part);
      new_line();
      word.erase(0, part);
      length = columns_of(word);
    }
    if (column > 0) {
      out.back() += ' ';
      ++column;
    }
    out.back() += word;
    column += length;
    at = text.find_first_not_of(" \n\t", end);
  }
  return out;
}

}  // namespace boxbeam::plain_text
