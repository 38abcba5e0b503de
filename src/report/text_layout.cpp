#include "text_layout.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <sstream>

namespace boxbeam::layout {
namespace {

/// Columns a text takes on a terminal: code points, good enough for the scripts of case files.
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string wrapped(const std::string& text, const std::string& first, const std::string& rest) {
  std::istringstream words(text);
  std::string out = first;
  std::size_t column = columns_of(first);
  bool line_begins = true;
  for (std::string word; words >> word;) {
    const std::size_t length = columns_of(word);
    if (!line_begins && column + 1 + length > width) {
      out += "\n" + rest;
      column = columns_of(rest);
      line_begins = true;
    }
    if (!line_begins) {
      out += ' ';
      ++column;
    }
    out += word;
    column += length;
    line_begins = false;
  }
  return out + "\n";
}

bool numeric(const std::string& cell) {
  if (cell.empty()) return true;
  const char c = cell.front();
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+';
}

}  // namespace

std::string heading(const std::string& text) {
  return text + "\n" + std::string(columns_of(text), '-') + "\n";
}

std::string paragraph(const std::string& text) { return wrapped(text, "  ", "  "); }

std::string item(const std::string& text) { return wrapped(text, "  - ", "    "); }

std::string entry(const std::string& name, const std::string& text) {
  const std::string gap(name.size() < 10 ? 10 - name.size() : 1, ' ');
  return wrapped(text, "  " + name + gap, std::string(12, ' '));
}

Table::Table(std::vector<std::string> header) : rows_{std::move(header)} {}

void Table::row(std::vector<std::string> cells) {
  assert(cells.size() == rows_.front().size());
  rows_.push_back(std::move(cells));
}

std::string Table::text() const {
  const std::size_t columns = rows_.front().size();
  std::vector<std::size_t> widths(columns, 0);
  std::vector<bool> right(columns, true);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t k = 0; k < columns; ++k) {
      widths[k] = std::max(widths[k], columns_of(rows_[i][k]));
      if (i > 0) right[k] = right[k] && numeric(rows_[i][k]);
    }
  }
  std::string out;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::string line = " ";
    for (std::size_t k = 0; k < columns; ++k) {
      const std::string gap(widths[k] - columns_of(rows_[i][k]), ' ');
      line += ' ';
      if (right[k]) line += gap;
      line += rows_[i][k];
      if (!right[k]) line += gap;
      line += ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

}  // namespace boxbeam::layout
