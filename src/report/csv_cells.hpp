#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "json_number.hpp"

/// Cells of comma-separated values. Source: RFC 4180.
namespace boxbeam::report {

/// As many digits as give the same number back.
inline std::string csv_cell(double value) { return fmt::format("{}", finite(value)); }

/// In quotes where it needs them.
inline std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

inline std::string csv_row(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace boxbeam::report
