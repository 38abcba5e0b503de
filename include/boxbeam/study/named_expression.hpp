#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace boxbeam {

/// Names that stand in an expression, sorted; a name may have dots: "fatigue.safety_factor". Throws
/// std::invalid_argument with what is wrong with it: orders ("a = 3") and lists ("a, b") are none.
std::vector<std::string> names_in(const std::string& expression);

/// Whether an expression as a whole compares, "a > b", so that it is 1 or 0.
bool is_condition(std::string_view expression);

/// An expression of named numbers, read once. Not for several threads at once.
class NamedExpression {
 public:
  /// Throws std::invalid_argument where it names others.
  NamedExpression(const std::string& text, const std::vector<std::string>& names);
  ~NamedExpression();
  NamedExpression(NamedExpression&&) noexcept;
  NamedExpression& operator=(NamedExpression&&) noexcept;

  /// With the numbers of the names, in their order. May be no number. Throws std::invalid_argument.
  double at(const std::vector<double>& numbers);

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace boxbeam
