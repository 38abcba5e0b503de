#include "boxbeam/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "boxbeam/core/code_points.hpp"

namespace boxbeam {
namespace {

/// Bytes of `text` before its code point number `count` (columns count code points, not bytes).
std::size_t bytes_before(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size() && count > 0; --count) at += code_point_at(text, at).length;
  return at;
}

/// The part of a line worth showing and the spaces that bring a caret under the place: long lines
/// are cut around it; tabs stay tabs, so that the caret is right whatever the terminal's tab width.
struct Excerpt {
  std::string text;
  std::string margin;
};

Excerpt excerpt_of(const std::string& line, int column) {
  constexpr std::size_t reach = 80;
  const std::size_t at = column > 0 ? static_cast<std::size_t>(column) - 1 : 0;
  const std::size_t from = bytes_before(line, at > reach ? at - reach : 0);
  const std::size_t caret = bytes_before(line, at);
  const std::size_t to = bytes_before(line, at + reach);
  Excerpt excerpt;
  const std::string before = visible(line.substr(from, caret - from), "\t");
  excerpt.text = (from > 0 ? "..." : "") + before + visible(line.substr(caret, to - caret), "\t") +
                 (to < line.size() ? "..." : "");
  if (from > 0) excerpt.margin = "   ";
  for (const char32_t point : code_points_of(before)) excerpt.margin += point == '\t' ? '\t' : ' ';
  return excerpt;
}

std::string join(const std::vector<Problem>& problems) {
  constexpr std::size_t most = 100;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, problems.size()); ++i) text += to_text(problems[i]);
  if (problems.size() > most) text += fmt::format("and {} more errors\n", problems.size() - most);
  return text;
}

std::string describe(const AnalysisFailure& failure) {
  std::string text = visible(failure.what, "\n\t");
  if (!failure.where.empty()) text += fmt::format("\n  where      {}", visible(failure.where));
  if (failure.time) text += fmt::format("\n  time       {:.6g} s", *failure.time);
  if (failure.residual) text += fmt::format("\n  residual   {:.3g}", *failure.residual);
  if (failure.condition) text += fmt::format("\n  condition  {:.3g}", *failure.condition);
  for (const std::string& line : failure.details) text += "\n  " + visible(line, "\t");
  return text;
}

}  // namespace

std::string to_text(const Problem& given) {
  Problem problem = given;
  for (std::string* part : {&problem.file, &problem.message, &problem.hint}) {
    *part = visible(*part, "\t");
  }
  std::string text;
  if (problem.file.empty()) {
    text = fmt::format("error: {}\n", problem.message);
  } else if (problem.line == 0) {
    text = fmt::format("{}: error: {}\n", problem.file, problem.message);
  } else {
    text = fmt::format("{}:{}:{}: error: {}\n", problem.file, problem.line, problem.column,
                       problem.message);
    const Excerpt excerpt = excerpt_of(problem.source_line, problem.column);
    text += fmt::format("    {}\n    {}^\n", excerpt.text, excerpt.margin);
  }
  if (!problem.hint.empty()) text += fmt::format("    hint: {}\n", problem.hint);
  return text;
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

InputError::InputError(const std::string& message, const std::string& hint)
    : InputError(std::vector<Problem>{{{}, 0, 0, {}, message, hint}}) {}

AnalysisError::AnalysisError(AnalysisFailure failure)
    : std::runtime_error(describe(failure)), failure_(std::move(failure)) {}

}  // namespace boxbeam
