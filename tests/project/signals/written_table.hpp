#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

/// Tables written by the tests in the many ways in which programs write them.
namespace test {

struct WrittenTable {
  std::vector<std::string> names;  ///< the first one is the time
  std::vector<std::string> units;
  std::vector<std::vector<double>> rows;
};

/// How it is written.
struct Writing {
  enum class Units { brackets, parentheses, row };
  enum class Encoding { utf8, utf8_mark, latin1, utf16_little, utf16_big, utf16_unmarked };

  char separator = ',';
  char decimal_sign = '.';
  Units units = Units::brackets;
  bool quotes = false;
  std::string line_end = "\n";
  Encoding encoding = Encoding::utf8;
};

inline std::string joined(const std::vector<std::string>& parts, const Writing& way) {
  std::string line;
  for (const std::string& part : parts) {
    if (!line.empty()) line += way.separator;
    line += way.quotes ? "\"" + part + "\"" : part;
  }
  return line + way.line_end;
}

/// From UTF-8 of code points below U+0800.
inline std::string encoded(const std::string& text, Writing::Encoding encoding) {
  using Encoding = Writing::Encoding;
  if (encoding == Encoding::utf8) return text;
  if (encoding == Encoding::utf8_mark) return "\xEF\xBB\xBF" + text;
  const bool big = encoding == Encoding::utf16_big;
  std::string bytes;
  if (encoding == Encoding::utf16_little) bytes = "\xFF\xFE";
  if (big) bytes = "\xFE\xFF";
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = static_cast<unsigned char>(text[i]);
    if (code >= 0xC0U) code = (code & 0x1FU) << 6U | (static_cast<unsigned>(text[++i]) & 0x3FU);
    const auto low = static_cast<char>(code & 0xFFU);
    const auto high = static_cast<char>(code >> 8U);
    if (encoding == Encoding::latin1) {
      bytes += low;
    } else {
      bytes += big ? high : low;
      bytes += big ? low : high;
    }
  }
  return bytes;
}

/// Numbers with as many digits as tell them from all others.
inline std::string text_of(const WrittenTable& table, const Writing& way) {
  std::vector<std::string> head = table.names;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (way.units == Writing::Units::brackets) head[i] += " [" + table.units[i] + "]";
    if (way.units == Writing::Units::parentheses) head[i] += " (" + table.units[i] + ")";
  }
  std::string text = joined(head, way);
  if (way.units == Writing::Units::row) text += joined(table.units, way);
  for (const std::vector<double>& row : table.rows) {
    std::vector<std::string> numbers;
    for (const double value : row) {
      numbers.push_back(fmt::format("{}", value));
      std::replace(numbers.back().begin(), numbers.back().end(), '.', way.decimal_sign);
    }
    text += joined(numbers, way);
  }
  return encoded(text, way.encoding);
}

}  // namespace test
