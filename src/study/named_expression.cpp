#include "boxbeam/study/named_expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace boxbeam {
namespace {

constexpr const char* of_names = "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The parser takes "a = 3" as an order to change a, and of "a, b" the last alone.
void require_one_value(const std::string& text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], before = i > 0 ? text[i - 1] : ' ';
    open += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && open == 0)
      throw std::invalid_argument("two expressions with a comma between them");
    if (c != '=') continue;
    const bool compares = before == '=' || before == '!' || before == '<' || before == '>' ||
                          (i + 1 < text.size() && text[i + 1] == '=');
    if (!compares) throw std::invalid_argument("\"=\" compares nothing: write \"==\"");
  }
}

}  // namespace

/// The parser looks at the numbers, which therefore stay in their place.
struct NamedExpression::Parsed {
  mu::Parser parser;
  std::vector<double> numbers;
};

bool is_condition(std::string_view expression) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!expression.empty() && is_blank(expression.front())) expression.remove_prefix(1);
  while (!expression.empty() && is_blank(expression.back())) expression.remove_suffix(1);
  int open = 0;
  bool around = expression.starts_with('(');  // one pair of brackets, around all
  for (std::size_t i = 0; i < expression.size(); ++i) {
    const char c = expression[i];
    open += c == '(' ? 1 : c == ')' ? -1 : 0;
    around = around && (open > 0 || i + 1 == expression.size());
    if (c == '?' && open == 0) return false;
  }
  if (around && open == 0) return is_condition(expression.substr(1, expression.size() - 2));
  for (const char c : expression) {
    open += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (open == 0 && std::string_view("<>=!&|").find(c) != std::string_view::npos) return true;
  }
  return false;
}

std::vector<std::string> names_in(const std::string& expression) {
  require_one_value(expression);
  try {
    mu::Parser parser;
    parser.DefineNameChars(of_names);
    parser.SetExpr(expression);
    std::vector<std::string> names;
    for (const auto& [name, place] : parser.GetUsedVar()) names.push_back(name);
    return names;
  } catch (const mu::Parser::exception_type& error) {
    throw std::invalid_argument(error.GetMsg());
  }
}

NamedExpression::NamedExpression(const std::string& text, const std::vector<std::string>& names)
    : parsed_(std::make_unique<Parsed>()) {
  require_one_value(text);
  parsed_->numbers.resize(names.size());
  try {
    parsed_->parser.DefineNameChars(of_names);
    for (std::size_t i = 0; i < names.size(); ++i)
      parsed_->parser.DefineVar(names[i], &parsed_->numbers[i]);
    parsed_->parser.SetExpr(text);
    parsed_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw std::invalid_argument(error.GetMsg());
  }
}

NamedExpression::~NamedExpression() = default;
NamedExpression::NamedExpression(NamedExpression&&) noexcept = default;
NamedExpression& NamedExpression::operator=(NamedExpression&&) noexcept = default;

double NamedExpression::at(const std::vector<double>& numbers) {
  std::copy(numbers.begin(), numbers.end(), parsed_->numbers.begin());
  try {
    return parsed_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw std::invalid_argument(error.GetMsg());
  }
}

}  // namespace boxbeam
