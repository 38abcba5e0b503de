#include "derivation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

using Operation = Expression::Operation;

enum class Look { symbols, values };

std::string text_of(const Expression& node, Look look);

bool is_sum(const Expression& node) {
  return node.operation == Operation::sum || node.operation == Operation::difference;
}

/// A constant of digits.
bool is_number(const Expression& node) {
  return node.operation == Operation::constant && node.text[0] <= '9';
}

bool is_angle_call(const Expression& node) {
  return node.operation == Operation::call && (node.text == "sin" || node.text == "cos");
}

bool is_leaf(const Expression& node) {
  return node.operation == Operation::constant || node.operation == Operation::symbol;
}

std::string leaf_text(const Expression& node, Look look) {
  const bool constant = node.operation == Operation::constant;
  if (!node.text.empty() && (constant || look == Look::symbols)) return node.text;
  return value_text(node.value, node.shown);
}

std::string in_parentheses(const std::string& text) { return "(" + text + ")"; }

/// Under an exponent: in parentheses where the exponent would take a part of it only.
std::string base_text(const std::string& text) {
  const bool open = text.find(' ') != std::string::npos || text.starts_with('-');
  const bool closed = text.starts_with('(') && text.find(')') == text.size() - 1;
  return open && !closed ? in_parentheses(text) : text;
}

/// A factor and how often it follows itself.
struct Factor {
  const Expression* node;
  int times = 1;
};

/// A term: factors over factors.
struct Fraction {
  bool negative = false;
  std::vector<Factor> above, below;
};

void add_factor(std::vector<Factor>& factors, const Expression& node) {
  const bool again = !factors.empty() && !is_number(node) &&
                     text_of(*factors.back().node, Look::symbols) == text_of(node, Look::symbols);
  if (again)
    ++factors.back().times;
  else
    factors.push_back({&node});
}

void collect_factors(const Expression& node, bool below, Fraction& of) {
  std::vector<Factor>& factors = below ? of.below : of.above;
  if (node.operation == Operation::product) {
    for (const auto& part : node.parts) collect_factors(*part, below, of);
  } else if (node.operation == Operation::quotient && !below) {
    collect_factors(*node.parts[0], false, of);
    collect_factors(*node.parts[1], true, of);
  } else if (node.operation == Operation::negative) {
    of.negative = !of.negative;
    collect_factors(*node.parts[0], below, of);
  } else {
    add_factor(factors, node);
  }
}

std::string factor_text(const Factor& factor, Look look) {
  std::string text = text_of(*factor.node, look);
  const bool group = is_sum(*factor.node) || factor.node->operation == Operation::quotient;
  if (group) text = in_parentheses(text);
  return factor.times == 1 ? text : fmt::format("{}^{}", base_text(text), factor.times);
}

/// Whether two factors side by side would be read as one number.
bool run_together(const std::string& before, const std::string& behind) {
  const char last = before.back(), first = behind.front();
  const bool ends_in_digit =
      last >= '0' && last <= '9' && before.find_first_not_of("0123456789.e") == std::string::npos;
  return ends_in_digit && first >= '0' && first <= '9';
}

std::string factors_text(const std::vector<Factor>& factors, Look look) {
  std::string text, before;
  for (const Factor& factor : factors) {
    std::string of = factor_text(factor, look);
    const bool constant = factor.node->operation == Operation::constant;
    if (factors.size() > 1 && !(constant && before.empty())) of = term(of);
    const bool number = constant && factor.node->text.empty();
    if (!before.empty()) {
      text += look == Look::values || number || run_together(before, of) ? " x " : " ";
    }
    text += of;
    before = of;
  }
  return text;
}

/// A part of a formula and the sign that the formula gives it.
struct SignedText {
  bool negative = false;
  std::string text;
};

SignedText signed_text(const Expression& node, Look look) {
  const bool is_term = node.operation == Operation::product ||
                       node.operation == Operation::quotient ||
                       node.operation == Operation::negative;
  if (!is_term) return {false, text_of(node, look)};
  Fraction of;
  collect_factors(node, false, of);
  // Nobody writes a one before other factors; numbers of a denominator stand first, angles last.
  const auto is_one = [](const Factor& factor) {
    return factor.node->operation == Operation::constant && factor.node->text == "1";
  };
  for (std::vector<Factor>* factors : {&of.above, &of.below}) {
    if (factors->size() > 1) std::erase_if(*factors, is_one);
  }
  std::stable_partition(of.below.begin(), of.below.end(),
                        [](const Factor& factor) { return is_number(*factor.node); });
  std::stable_partition(of.above.begin(), of.above.end(),
                        [](const Factor& factor) { return !is_angle_call(*factor.node); });
  std::string text = of.above.empty() ? "1" : factors_text(of.above, look);
  if (!of.below.empty()) {
    const std::string below = factors_text(of.below, look);
    const bool group = of.below.size() > 1 || below.starts_with('-');
    text += "/" + (group ? in_parentheses(below) : below);
  }
  return {of.negative, std::move(text)};
}

/// The terms of a sum with their signs.
struct Term {
  const Expression* node;
  bool minus = false;
};

void collect_terms(const Expression& node, bool minus, std::vector<Term>& terms) {
  if (!is_sum(node)) {
    terms.push_back({&node, minus});
    return;
  }
  collect_terms(*node.parts[0], minus, terms);
  const Expression& second = *node.parts[1];
  // What is taken away as a whole stays one.
  if (node.operation == Operation::sum && !minus)
    collect_terms(second, false, terms);
  else
    terms.push_back({&second, minus != (node.operation == Operation::difference)});
}

std::vector<Term> terms_of(const Expression& node) {
  std::vector<Term> terms;
  collect_terms(node, false, terms);
  return terms;
}

bool is_stress_sum(const Expression& node) {
  return is_sum(node) && node.dimension == dimension_of(ValueKind::stress);
}

bool all_leaves(const std::vector<Term>& terms) {
  return std::all_of(terms.begin(), terms.end(), [](const Term& of) { return is_leaf(*of.node); });
}

/// The values of the terms of a sum of stresses, and their sum. Where terms are formulas their
/// signs are those of their values.
StressSum stress_sum_of(const std::vector<Term>& terms) {
  const bool leaves = all_leaves(terms);
  std::vector<double> stresses;
  std::vector<bool> minus;
  for (const Term& of : terms) {
    stresses.push_back(of.minus && !leaves ? -of.node->value : of.node->value);
    minus.push_back(of.minus && leaves);
  }
  return sum_of(stresses, minus);
}

std::string sum_text(const Expression& node, Look look) {
  const std::vector<Term> terms = terms_of(node);
  if (look == Look::values && is_stress_sum(node) && all_leaves(terms))
    return stress_sum_of(terms).terms;
  std::string text;
  for (const Term& of : terms) {
    SignedText next = signed_text(*of.node, look);
    if (is_sum(*of.node)) next.text = in_parentheses(next.text);
    // A sign of the formula joins that of the sum; one of a value stays with its number.
    const bool minus = of.minus != next.negative;
    if (text.empty())
      text = minus ? "-" + term(next.text) : next.text;
    else
      text += (minus ? " - " : " + ") + term(next.text);
  }
  return text;
}

std::string call_text(const Expression& node, Look look) {
  const bool angle = is_angle_call(node);
  const Expression& first = *node.parts.front();
  if (angle && look == Look::symbols) {
    if (first.operation == Operation::symbol) return node.text + " " + first.text;
    if (first.operation == Operation::product && is_leaf(*first.parts[0]) &&
        first.parts[1]->operation == Operation::symbol) {
      return node.text + " " + first.parts[0]->text + first.parts[1]->text;
    }
  }
  std::string arguments;
  for (const auto& part : node.parts) {
    if (!arguments.empty()) arguments += ", ";
    arguments += text_of(*part, look);
  }
  return node.text + in_parentheses(arguments);
}

std::string power_text(const Expression& node, Look look) {
  const Expression& base = *node.parts[0];
  const Expression& exponent = *node.parts[1];
  std::string below = text_of(base, look), above = text_of(exponent, look);
  const bool bare = is_leaf(base) || base.operation == Operation::call;
  // A value would be read together with a fraction behind it.
  const bool value = look == Look::values && is_leaf(base) && !is_leaf(exponent);
  below = bare && !value ? base_text(below) : in_parentheses(below);
  if (!is_leaf(exponent)) above = in_parentheses(above);
  return below + "^" + above;
}

std::string text_of(const Expression& node, Look look) {
  switch (node.operation) {
    case Operation::constant:
    case Operation::symbol: return leaf_text(node, look);
    case Operation::sum:
    case Operation::difference: return sum_text(node, look);
    case Operation::negative:
    case Operation::product:
    case Operation::quotient: {
      const SignedText of = signed_text(node, look);
      return of.negative ? "-" + term(of.text) : of.text;
    }
    case Operation::power: return power_text(node, look);
    case Operation::call: return call_text(node, look);
  }
  return "";
}

/// Adds a formula that says more than the last one.
void add_formula(Step& step, std::string formula) {
  if (step.formulas.empty() || step.formulas.back() != formula)
    step.formulas.push_back(std::move(formula));
}

std::string note_text(const DerivationNote& note) {
  std::string text = note.text;
  std::size_t at = 0;
  for (const Traced& value : note.values) {
    at = text.find("{}", at);
    const std::string number = values_of(value);
    text.replace(at, 2, number);
    at += number.size();
  }
  return text;
}

Step step_of(const DerivationStep& of) {
  Step step{of.symbol, {}, {}};
  for (const DerivationNote& note : of.notes) step.notes.push_back(note_text(note));
  const Expression& node = of.value.expression();
  std::string result = value_text(of.value.value(), of.shown);
  if (of.role != DerivationStep::Role::given) add_formula(step, text_of(node, Look::symbols));
  if (of.role == DerivationStep::Role::stated) return step;
  if (of.role == DerivationStep::Role::defined) {
    add_formula(step, text_of(node, Look::values));
    if (is_stress_sum(node)) {
      StressSum sum = stress_sum_of(terms_of(node));
      add_formula(step, std::move(sum.terms));
      result = std::move(sum.sum);
    }
  }
  add_formula(step, std::move(result));
  return step;
}

}  // namespace

std::string value_text(double value, const Shown& shown) {
  // What round-off leaves of a zero: a millinewton, a pascal.
  const auto load = [&] { return std::abs(value) < 1e-3 ? 0.0 : value; };
  const auto stress = [&] { return std::abs(value) < 1.0 ? 0.0 : value; };
  switch (shown.kind) {
    case ValueKind::number: return text::significant(value, shown.digits > 0 ? shown.digits : 4);
    case ValueKind::factor: return number(value);
    case ValueKind::share: return share(value);
    case ValueKind::cycles:
      return shown.digits > 0 ? scientific(value, shown.digits) : text::cycles(value);
    case ValueKind::angle: return fmt::format("{:.10g} deg", value * 180.0 / std::numbers::pi);
    case ValueKind::length: return text::mm(value);
    case ValueKind::area: return mm2(value);
    case ValueKind::section_modulus: return mm3(value);
    case ValueKind::second_moment: return mm4(value);
    case ValueKind::force: return text::kN(load());
    case ValueKind::moment: return text::kNm(load());
    case ValueKind::stress: return text::MPa(stress());
    case ValueKind::per_area: return scientific(value * 1e-6, 4) + " mm^-2";
    case ValueKind::per_volume: return scientific(value * 1e-9, 4) + " mm^-3";
  }
  return "";
}

std::string symbols_of(const Traced& expression) {
  return text_of(expression.expression(), Look::symbols);
}

std::string values_of(const Traced& expression) {
  return text_of(expression.expression(), Look::values);
}

Steps steps_of(const Derivation& derivation) {
  Steps steps;
  for (const DerivationStep& step : derivation.steps()) steps.push_back(step_of(step));
  return steps;
}

}  // namespace boxbeam::report
