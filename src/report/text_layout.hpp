#pragma once

#include <string>
#include <vector>

/// Plain-text layout: headings, wrapped paragraphs, tables whose columns fit their content.
namespace boxbeam::layout {

inline constexpr std::size_t width = 110;

std::string heading(const std::string& text);
/// Wrapped and indented by two spaces.
std::string paragraph(const std::string& text);
/// A list item with a dash, wrapped.
std::string item(const std::string& text);
/// A short name and what is said of it, wrapped beside it.
std::string entry(const std::string& name, const std::string& text);

/// Columns after the first are right-aligned where every entry begins with a digit or a sign.
class Table {
 public:
  explicit Table(std::vector<std::string> header);
  void row(std::vector<std::string> cells);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace boxbeam::layout
