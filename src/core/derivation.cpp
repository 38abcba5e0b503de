#include "boxbeam/core/derivation.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace boxbeam {
namespace {

using Operation = Expression::Operation;

constexpr std::array<std::pair<ValueKind, Dimension>, 9> dimensions{
    {{ValueKind::length, {0, 1}},
     {ValueKind::area, {0, 2}},
     {ValueKind::section_modulus, {0, 3}},
     {ValueKind::second_moment, {0, 4}},
     {ValueKind::force, {1, 0}},
     {ValueKind::moment, {1, 1}},
     {ValueKind::stress, {1, -2}},
     {ValueKind::per_area, {0, -2}},
     {ValueKind::per_volume, {0, -3}}}};

constexpr Dimension none{};

bool is_one(const Traced& of) {
  return of.expression().operation == Operation::constant && of.value() == 1.0;
}

bool is_nothing(const Traced& of) {
  return of.expression().operation == Operation::constant && of.value() == 0.0;
}

}  // namespace

Dimension dimension_of(ValueKind kind) {
  for (const auto& [of, dimension] : dimensions) {
    if (of == kind) return dimension;
  }
  return none;
}

ValueKind kind_of(const Dimension& dimension) {
  for (const auto& [kind, of] : dimensions) {
    if (of == dimension) return kind;
  }
  return ValueKind::number;
}

Traced::Traced(Expression expression)
    : node_(std::make_shared<const Expression>(std::move(expression))) {}

Traced::Traced(double constant) : Traced(Expression{}) {
  Expression node;
  node.text = fmt::format("{}", constant);
  node.value = constant;
  node_ = std::make_shared<const Expression>(std::move(node));
}

Traced operator+(const Traced& a, const Traced& b) {
  if (is_nothing(a)) return b;
  if (is_nothing(b)) return a;
  assert(a.dimension() == b.dimension());
  return Traced({Operation::sum, "", a.value() + b.value(), a.dimension(), {}, {a.node_, b.node_}});
}

Traced operator-(const Traced& a, const Traced& b) {
  if (is_nothing(b)) return a;
  if (is_nothing(a)) return -b;
  assert(a.dimension() == b.dimension());
  return Traced(
      {Operation::difference, "", a.value() - b.value(), a.dimension(), {}, {a.node_, b.node_}});
}

Traced operator-(const Traced& a) {
  return Traced({Operation::negative, "", -a.value(), a.dimension(), {}, {a.node_}});
}

Traced operator*(const Traced& a, const Traced& b) {
  if (is_nothing(a) || is_nothing(b)) return 0.0;
  if (is_one(a)) return b;
  if (is_one(b)) return a;
  const Dimension dimension{a.dimension().newton + b.dimension().newton,
                            a.dimension().metre + b.dimension().metre};
  return Traced({Operation::product, "", a.value() * b.value(), dimension, {}, {a.node_, b.node_}});
}

Traced operator/(const Traced& a, const Traced& b) {
  if (is_nothing(a)) return 0.0;
  const Dimension dimension{a.dimension().newton - b.dimension().newton,
                            a.dimension().metre - b.dimension().metre};
  return Traced(
      {Operation::quotient, "", a.value() / b.value(), dimension, {}, {a.node_, b.node_}});
}

Traced sqrt(const Traced& a) {
  const Dimension& of = a.dimension();
  assert(of.newton % 2 == 0 && of.metre % 2 == 0);
  return Traced({Operation::call,
                 "sqrt",
                 std::sqrt(a.value()),
                 {of.newton / 2, of.metre / 2},
                 {},
                 {a.node_}});
}

Traced exp(const Traced& a) {
  assert(a.dimension() == none);
  return call_of("exp", std::exp(a.value()), {a});
}

Traced sin(const Traced& a) {
  assert(a.dimension() == none);
  return call_of("sin", std::sin(a.value()), {a});
}

Traced cos(const Traced& a) {
  assert(a.dimension() == none);
  return call_of("cos", std::cos(a.value()), {a});
}

Traced abs(const Traced& a) { return call_of("abs", std::abs(a.value()), {a}); }

Traced pow(const Traced& base, const Traced& exponent) {
  assert(base.dimension() == none && exponent.dimension() == none);
  return Traced({Operation::power,
                 "",
                 std::pow(base.value(), exponent.value()),
                 none,
                 {},
                 {base.node_, exponent.node_}});
}

Traced call_of(const char* function, double value, const std::vector<Traced>& arguments) {
  Expression node{Operation::call, function, value, arguments.front().dimension(), {}, {}};
  for (const Traced& argument : arguments) {
    assert(argument.dimension() == node.dimension);
    node.parts.push_back(argument.node_);
  }
  return Traced(std::move(node));
}

Traced polynomial(const Traced& x, std::span<const Traced> c) {
  Traced sum = c.front(), power = 1.0;
  for (std::size_t k = 1; k < c.size(); ++k) {
    power = k == 1 ? x : power * x;
    Expression size = c[k].expression();
    const bool minus = size.value < 0.0;
    if (minus) {
      size.value = -size.value;
      size.text.erase(0, 1);
    }
    const Traced term = Traced(size) * power;
    sum = minus ? sum - term : sum + term;
  }
  return sum;
}

Traced Derivation::known(Symbol symbol, double value, Shown shown) {
  return Traced({Operation::symbol, symbol.text(), value, dimension_of(shown.kind), shown, {}});
}

Traced Derivation::given(Symbol symbol, double value, Shown shown, std::string_view note) {
  Traced of = known(symbol, value, shown);
  steps_.push_back({symbol.text(), of, DerivationStep::Role::given, shown, {}});
  if (!note.empty()) steps_.back().notes.push_back({std::string(note), {}});
  return of;
}

Traced Derivation::constant(std::string_view text, double value, ValueKind kind) {
  return Traced({Operation::constant, std::string(text), value, dimension_of(kind), {kind}, {}});
}

Traced Derivation::literal(double value, ValueKind kind) { return constant("", value, kind); }

Traced Derivation::define(Symbol symbol, const Traced& expression, std::string_view note) {
  return define(symbol, expression, note, {kind_of(expression.dimension())});
}

Traced Derivation::define(Symbol symbol, const Traced& expression, std::string_view note,
                          Shown shown) {
  assert(dimension_of(shown.kind) == expression.dimension());
  steps_.push_back({symbol.text(), expression, DerivationStep::Role::defined, shown, {}});
  if (!note.empty()) steps_.back().notes.push_back({std::string(note), {}});
  return known(symbol, expression.value(), shown);
}

void Derivation::state(Symbol symbol, const Traced& expression, std::string_view note) {
  define(symbol, expression, note);
  steps_.back().role = DerivationStep::Role::stated;
}

}  // namespace boxbeam
