#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/core/units.hpp"

/// Formulas that say how they come to their value.
///
/// A formula is one function template over a recorder and the values that it takes:
///
///     template <class Record, class F>
///     auto shear_resistance(Record& record, const PinJoint& joint, ...) {
///       const auto d = record.given("d", joint.diameter, "pin");
///       const auto A = record.define("A", pi * d * d / 4.0);
///       return record.define("F_v,Rd", 0.6 * A * f_up / gamma_M2, "shear, one plane");
///     }
///
/// With `NoDerivation` its values are quantities or doubles, the recorder hands them through and is
/// gone when compiled. With `Derivation` they are `Traced`: the same expression builds its tree,
/// and the recorder keeps the steps, which a report prints.
namespace boxbeam {

/// What a number is, by which it is printed.
enum class ValueKind {
  number,  ///< without unit
  factor,  ///< a partial factor or the like, given with few digits
  share,   ///< a damage or a part of it, which may be tiny
  cycles,
  angle,  ///< [rad]
  length,
  area,
  section_modulus,  ///< also a first moment of area
  second_moment,
  force,
  moment,
  stress,
  per_area,    ///< stress per force
  per_volume,  ///< stress per moment
};

/// Powers of newton and metre.
struct Dimension {
  int newton = 0, metre = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

Dimension dimension_of(ValueKind kind);
/// The kind that a value of this dimension is; a plain number where it has none.
ValueKind kind_of(const Dimension& dimension);

inline ValueKind kind_of(const Dimensionless&) { return ValueKind::number; }
inline ValueKind kind_of(const Length&) { return ValueKind::length; }
inline ValueKind kind_of(const Area&) { return ValueKind::area; }
inline ValueKind kind_of(const Volume&) { return ValueKind::section_modulus; }
inline ValueKind kind_of(const SecondMoment&) { return ValueKind::second_moment; }
inline ValueKind kind_of(const Force&) { return ValueKind::force; }
inline ValueKind kind_of(const Moment&) { return ValueKind::moment; }
inline ValueKind kind_of(const Stress&) { return ValueKind::stress; }

/// How a value is shown: what it is, and with how many digits; 0 for as many as its kind has.
struct Shown {
  ValueKind kind = ValueKind::number;
  int digits = 0;
};

/// A node of an expression. SI.
struct Expression {
  enum class Operation {
    constant,    ///< stands in the formula itself: "0.6"; without text as its value is printed
    symbol,      ///< a value with a name
    sum,         ///< two parts
    difference,  ///< two parts
    negative,    ///< of its part
    product,     ///< two parts
    quotient,    ///< two parts
    power,       ///< base, exponent
    call,        ///< of a function, on its parts
  };
  Operation operation = Operation::constant;
  std::string text;  ///< of a constant, a symbol or a function
  double value = 0.0;
  Dimension dimension;
  Shown shown;  ///< of a symbol
  std::vector<std::shared_ptr<const Expression>> parts;
};

/// A value that knows the expression it comes from. Values of unlike dimension do not add; a
/// constant zero stands for what is not there, and leaves no trace in a sum or a product; nor does
/// a constant one in a product.
class Traced {
 public:
  /// A constant of a formula.
  Traced(double constant);
  explicit Traced(Expression expression);

  double value() const { return node_->value; }
  const Dimension& dimension() const { return node_->dimension; }
  const Expression& expression() const { return *node_; }

  friend Traced operator+(const Traced& a, const Traced& b);
  friend Traced operator-(const Traced& a, const Traced& b);
  friend Traced operator-(const Traced& a);
  friend Traced operator*(const Traced& a, const Traced& b);
  friend Traced operator/(const Traced& a, const Traced& b);
  friend bool operator<(const Traced& a, const Traced& b) { return a.value() < b.value(); }
  friend bool operator>(const Traced& a, const Traced& b) { return a.value() > b.value(); }
  friend bool operator<=(const Traced& a, const Traced& b) { return a.value() <= b.value(); }
  friend bool operator>=(const Traced& a, const Traced& b) { return a.value() >= b.value(); }

  friend Traced sqrt(const Traced& a);
  friend Traced exp(const Traced& a);
  friend Traced sin(const Traced& a);
  friend Traced cos(const Traced& a);
  friend Traced abs(const Traced& a);
  /// Of a number.
  friend Traced pow(const Traced& base, const Traced& exponent);

 private:
  friend Traced call_of(const char* function, double value, const std::vector<Traced>& arguments);
  std::shared_ptr<const Expression> node_;
};

/// A function of several values of one dimension.
Traced call_of(const char* function, double value, const std::vector<Traced>& arguments);

/// The largest and the least of some values, which remain an expression where they are traced.
template <class Value>
Value largest_of(std::initializer_list<Value> values) {
  return std::max(values);
}
template <class Value>
Value least_of(std::initializer_list<Value> values) {
  return std::min(values);
}
template <>
inline Traced largest_of(std::initializer_list<Traced> values) {
  return call_of("max", std::max(values).value(), values);
}
template <>
inline Traced least_of(std::initializer_list<Traced> values) {
  return call_of("min", std::min(values).value(), values);
}

/// c_0 + c_1 x + c_2 x^2 + ..., evaluated after Horner; an expression has its powers as written.
template <class Value, std::size_t count>
Value polynomial(const Value& x, const std::array<Value, count>& c) {
  Value sum = c.back();
  for (std::size_t k = count - 1; k-- > 0;) sum = c[k] + x * sum;
  return sum;
}
Traced polynomial(const Traced& x, std::span<const Traced> c);
template <std::size_t count>
Traced polynomial(const Traced& x, const std::array<Traced, count>& c) {
  return polynomial(x, std::span<const Traced>(c));
}

/// "kappa", or "kappa" and "_web".
struct Symbol {
  constexpr Symbol(const char* name) : base(name) {}
  constexpr Symbol(std::string_view name, std::string_view ending) : base(name), index(ending) {}
  std::string text() const { return std::string(base) + std::string(index); }

  std::string_view base, index;
};

/// What is said of a step; values stand where its text has "{}".
struct DerivationNote {
  std::string text;
  std::vector<Traced> values;
};

/// A step of a derivation.
struct DerivationStep {
  enum class Role {
    given,    ///< a value that is known from elsewhere
    defined,  ///< an expression gives the symbol its value
    stated,   ///< an expression in symbols alone
  };
  std::string symbol;
  Traced value;  ///< of a given one the symbol itself
  Role role = Role::given;
  Shown shown;
  std::vector<DerivationNote> notes;
};

/// Keeps the steps of a formula.
class Derivation {
 public:
  static constexpr bool records = true;

  /// A value that is known from elsewhere, as a step of its own.
  Traced given(Symbol symbol, double value, Shown shown, std::string_view note = {});
  template <class Unit>
  Traced given(Symbol symbol, boost::units::quantity<Unit> value, std::string_view note = {}) {
    return given(symbol, value.value(), {kind_of(value)}, note);
  }

  /// A value that is known from elsewhere and stands in formulas only.
  static Traced known(Symbol symbol, double value, Shown shown = {});
  template <class Unit>
  static Traced known(Symbol symbol, boost::units::quantity<Unit> value) {
    return known(symbol, value.value(), {kind_of(value)});
  }

  /// A constant of a formula as it is printed: "235 MPa", "pi".
  static Traced constant(std::string_view text, double value, ValueKind kind = ValueKind::number);
  template <class Unit>
  static Traced constant(std::string_view text, boost::units::quantity<Unit> value) {
    return constant(text, value.value(), kind_of(value));
  }

  /// A number of a formula without a name, printed as its kind is.
  static Traced literal(double value, ValueKind kind);

  /// A step that gives an expression a symbol; what is returned is that symbol from then on.
  Traced define(Symbol symbol, const Traced& expression, std::string_view note = {});
  Traced define(Symbol symbol, const Traced& expression, std::string_view note, Shown shown);

  /// A step that shows an expression in its symbols, without values.
  void state(Symbol symbol, const Traced& expression, std::string_view note = {});

  /// Says more of the last step; the words are asked for only where they are kept.
  template <class Words, class... Values>
  void note(const Words& words, const Values&... values) {
    steps_.back().notes.push_back({words(), {Traced(values)...}});
  }

  const std::vector<DerivationStep>& steps() const { return steps_; }

 private:
  std::vector<DerivationStep> steps_;
};

/// Keeps nothing: what it is given and told to define passes through.
struct NoDerivation {
  static constexpr bool records = false;

  template <class Value>
  static constexpr Value given(Symbol, Value value, std::string_view = {}) {
    return value;
  }
  static constexpr double given(Symbol, double value, Shown, std::string_view = {}) {
    return value;
  }
  template <class Value>
  static constexpr Value known(Symbol, Value value, Shown = {}) {
    return value;
  }
  template <class Value>
  static constexpr Value constant(std::string_view, Value value, ValueKind = ValueKind::number) {
    return value;
  }
  template <class Value>
  static constexpr Value define(Symbol, Value value, std::string_view = {}, Shown = {}) {
    return value;
  }
  template <class Words, class... Values>
  static constexpr void note(const Words&, const Values&...) {}
};

/// The recorder that keeps nothing.
inline constexpr NoDerivation plainly;

}  // namespace boxbeam
