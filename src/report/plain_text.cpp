#include "plain_text.hpp"

#include <algorithm>

#include "boxbeam/core/code_points.hpp"

namespace boxbeam::plain_text {
namespace {

bool in(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

bool combines(char32_t code) {
  return in(code, 0x300, 0x36F) || in(code, 0x200B, 0x200D) || in(code, 0x20D0, 0x20FF) ||
         in(code, 0xFE00, 0xFE0F);
}

bool is_wide(char32_t code) {
  return in(code, 0x1100, 0x115F) || in(code, 0x2E80, 0xA4CF) || in(code, 0xAC00, 0xD7A3) ||
         in(code, 0xF900, 0xFAFF) || in(code, 0xFE30, 0xFE6F) || in(code, 0xFF00, 0xFF60) ||
         in(code, 0xFFE0, 0xFFE6) || in(code, 0x1F300, 0x1FAFF) || in(code, 0x20000, 0x3FFFD);
}

/// Nothing to look at closely: printable ASCII.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// The bytes of a word that fit into so many columns, at least one character.
std::size_t bytes_within(std::string_view word, std::size_t columns) {
  std::size_t at = code_point_at(word, 0).length;
  while (at < word.size()) {
    const std::size_t next = at + code_point_at(word, at).length;
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
    const CodePoint point = code_point_at(text, i);
    columns += combines(point.code) ? 0 : is_wide(point.code) ? 2 : 1;
    i += point.length;
  }
  return columns;
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
    std::string word = visible(text.substr(at, end - at));
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
