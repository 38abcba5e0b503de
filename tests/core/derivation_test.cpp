// Values that know their expression, and recorders of formulas.

#include "boxbeam/core/derivation.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>

#include "catch.hpp"

namespace derivation_test {

using namespace boxbeam;

namespace {

using Operation = Expression::Operation;

/// A formula as the program has them: V of a cone and the length of its side.
template <class Record>
auto cone(Record& record, Length radius, Length height) {
  using std::sqrt;
  const auto pi = record.constant("pi", std::numbers::pi);
  const auto r = record.given("r", radius, "of the base");
  const auto h = record.known("h", height);
  const auto side = record.define("s", sqrt(r * r + h * h));
  record.note([] { return "of {}"; }, r);
  return record.define("V", pi * r * r * h / 3.0) + 0.0 * side * side * side;
}

}  // namespace

TEST_CASE("A formula without a recorder gives quantities of the units that it asks for") {
  constexpr NoDerivation nothing;
  const auto V = cone(nothing, 3.0 * metre, 4.0 * metre);
  static_assert(std::is_same_v<decltype(V), const Volume>);
  CHECK(V.value() == Approx(12.0 * std::numbers::pi));
}

TEST_CASE("The same formula with a recorder keeps what it was given and what it defined") {
  Derivation steps;
  const Traced V = cone(steps, 3.0 * metre, 4.0 * metre);
  constexpr NoDerivation nothing;
  CHECK(V.value() == cone(nothing, 3.0 * metre, 4.0 * metre).value());
  REQUIRE(steps.steps().size() == 3);
  const DerivationStep& r = steps.steps()[0];
  CHECK(r.symbol == "r");
  CHECK(r.role == DerivationStep::Role::given);
  CHECK(r.shown.kind == ValueKind::length);
  REQUIRE(r.notes.size() == 1);
  CHECK(r.notes.front().text == "of the base");
  const DerivationStep& s = steps.steps()[1];
  CHECK(s.symbol == "s");
  CHECK(s.role == DerivationStep::Role::defined);
  CHECK(s.value.value() == 5.0);
  REQUIRE(s.notes.size() == 1);
  REQUIRE(s.notes.front().values.size() == 1);
  CHECK(s.notes.front().values.front().value() == 3.0);
  CHECK(steps.steps()[2].shown.kind == ValueKind::section_modulus);
}

TEST_CASE("An expression is the tree of its operations") {
  Derivation steps;
  const Traced a = steps.known("a", 2.0), b = steps.known("b", 5.0);
  const Traced of = 3.0 * a - b / a;
  const Expression& top = of.expression();
  CHECK(of.value() == 3.5);
  CHECK(top.operation == Operation::difference);
  REQUIRE(top.parts.size() == 2);
  CHECK(top.parts[0]->operation == Operation::product);
  CHECK(top.parts[0]->parts[0]->operation == Operation::constant);
  CHECK(top.parts[0]->parts[0]->text == "3");
  CHECK(top.parts[0]->parts[1]->text == "a");
  CHECK(top.parts[1]->operation == Operation::quotient);
  CHECK((-a).expression().operation == Operation::negative);
  CHECK(pow(a, b).value() == 32.0);
  CHECK(pow(a, b).expression().operation == Operation::power);
}

TEST_CASE("A constant zero stands for what is not there") {
  Derivation steps;
  const Traced F = steps.known("F", si<Force>(2.0)), nothing = 0.0;
  CHECK((F + nothing).expression().text == "F");
  CHECK((nothing + F).expression().text == "F");
  CHECK((F - nothing).expression().text == "F");
  CHECK((nothing - F).expression().operation == Operation::negative);
  CHECK((F + nothing * F * F).expression().text == "F");
  CHECK((F + nothing / F).expression().text == "F");
}

TEST_CASE("A polynomial is evaluated after Horner and stands with its powers") {
  CHECK(polynomial(0.3, std::array{2.0, -0.5, 1.5}) == 2.0 + 0.3 * (-0.5 + 0.3 * 1.5));
  Derivation steps;
  const Traced x = steps.known("x", 0.3);
  const Traced of = polynomial(x, std::array<Traced, 3>{2.0, -0.5, 1.5});
  CHECK(of.value() == Approx(1.985).epsilon(1e-15));
  const Expression& top = of.expression();
  CHECK(top.operation == Operation::sum);
  CHECK(top.parts[0]->operation == Operation::difference);
  CHECK(top.parts[0]->parts[1]->parts[0]->text == "0.5");
}

TEST_CASE("What is stated is an expression without values") {
  Derivation steps;
  steps.state("x", 2.0 * steps.known("y", 1.0));
  CHECK(steps.steps().back().role == DerivationStep::Role::stated);
}

TEST_CASE("What is defined is from then on its symbol alone") {
  Derivation steps;
  const Traced a = steps.known("a", 2.0);
  const Traced c = steps.define("c", a + 1.0);
  CHECK(c.expression().operation == Operation::symbol);
  CHECK(c.expression().text == "c");
  CHECK(c.expression().parts.empty());
  CHECK(c.value() == 3.0);
}

TEST_CASE("Functions keep their name and their arguments") {
  Derivation steps;
  const Traced a = steps.known("a", 2.0), b = steps.known("b", -5.0);
  const auto name = [](const Traced& of) { return of.expression().text; };
  CHECK(sqrt(a).value() == std::sqrt(2.0));
  CHECK(exp(a).value() == std::exp(2.0));
  CHECK(sin(a).value() == std::sin(2.0));
  CHECK(cos(a).value() == std::cos(2.0));
  CHECK(abs(b).value() == 5.0);
  CHECK(name(sqrt(a)) == "sqrt");
  CHECK(name(abs(b)) == "abs");
  const Traced largest = largest_of({a, b, a * a}), least = least_of({a, b});
  CHECK(largest.value() == 4.0);
  CHECK(least.value() == -5.0);
  CHECK(name(largest) == "max");
  CHECK(name(least) == "min");
  CHECK(largest.expression().parts.size() == 3);
  CHECK(largest_of({1.0, 3.0, 2.0}) == 3.0);
  CHECK(least_of({1.0, 3.0, 2.0}) == 1.0);
}

TEST_CASE("Expressions carry their dimension, and what is defined is of its kind") {
  Derivation steps;
  const Traced F = steps.known("F", si<Force>(1.0)), l = steps.known("l", si<Length>(1.0)),
               f = steps.known("f", si<Stress>(1.0));
  CHECK((F * l).dimension() == dimension_of(ValueKind::moment));
  CHECK((F / (l * l)).dimension() == f.dimension());
  CHECK(sqrt(F / f).dimension() == dimension_of(ValueKind::length));
  CHECK((F / (f * l * l)).dimension() == Dimension{});
  CHECK(abs(F).dimension() == F.dimension());
  CHECK(largest_of({F, F + F}).dimension() == F.dimension());
  const auto kind = [&](const Traced& of) {
    steps.define("x", of);
    return steps.steps().back().shown.kind;
  };
  CHECK(kind(F / l / l) == ValueKind::stress);
  CHECK(kind(l * l) == ValueKind::area);
  CHECK(kind(l * l * l) == ValueKind::section_modulus);
  CHECK(kind(l * l * l * l) == ValueKind::second_moment);
  CHECK(kind(1.0 / (l * l)) == ValueKind::per_area);
  CHECK(kind(1.0 / (l * l * l)) == ValueKind::per_volume);
  CHECK(kind(F / F) == ValueKind::number);
}

TEST_CASE("Kinds of plain numbers have no dimension, the others one each") {
  for (const ValueKind kind : {ValueKind::number, ValueKind::factor, ValueKind::share,
                               ValueKind::cycles, ValueKind::angle}) {
    CHECK(dimension_of(kind) == Dimension{});
  }
  for (const ValueKind kind : {ValueKind::length, ValueKind::area, ValueKind::section_modulus,
                               ValueKind::second_moment, ValueKind::force, ValueKind::moment,
                               ValueKind::stress, ValueKind::per_area, ValueKind::per_volume}) {
    CHECK(kind_of(dimension_of(kind)) == kind);
  }
}

}  // namespace derivation_test
