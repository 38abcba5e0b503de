#pragma once

#include <string>
#include <vector>

#include "boxbeam/report/document.hpp"

/// Plain-text layout: headings, wrapped paragraphs, tables whose columns fit their content.
namespace boxbeam::layout {

/// Columns of what commands print: those of the terminal where there is one, which the program
/// sets. What is written to files has a width of its own.
std::size_t width();
void set_width(std::size_t columns);

std::string heading(const std::string& text);
/// Wrapped, its further lines indented by two spaces.
std::string line(const std::string& text);
/// Wrapped and indented by two spaces.
std::string paragraph(const std::string& text);
/// A list item with a dash, wrapped.
std::string item(const std::string& text);
/// A short name and what is said of it, wrapped beside it.
std::string entry(const std::string& name, const std::string& text);

/// Six digits; zero for what is round-off beside `size`, and never "-0".
std::string number_beside(double value, double size);

/// A table of texts, as wide as the page at most.
class Table {
 public:
  explicit Table(std::vector<std::string> header);
  void row(const std::vector<std::string>& cells);
  std::string text() const;
  const report::Table& as_block() const { return table_; }

 private:
  report::Table table_;
};

}  // namespace boxbeam::layout
