#include "boxbeam/study/named_expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <stdexcept>

namespace boxbeam {
namespace {

constexpr const char* of_names = "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

}  // namespace

/// The parser looks at the numbers, which therefore stay in their place.
struct NamedExpression::Parsed {
  mu::Parser parser;
  std::vector<double> numbers;
};

std::vector<std::string> names_in(const std::string& expression) {
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
