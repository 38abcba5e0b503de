// How a derivation is printed; and that what is printed comes to what stands at its end.

#include "src/report/derivation_text.hpp"

#include "catch.hpp"

namespace derivation_text_test {

using namespace boxbeam;
using namespace report;

namespace {

using Texts = std::vector<std::string>;

struct Symbols {
  Derivation steps;
  Traced a = steps.known("a", 2.0), b = steps.known("b", 5.0), c = steps.known("c", -4.0),
         l = steps.known("l", si<Length>(0.3)), F = steps.known("F", si<Force>(12e3)),
         N = steps.known("N", si<Force>(-27.66e3)), A = steps.known("A_eff", si<Area>(0.0872)),
         s = steps.known("sigma_1", si<Stress>(16.33e6)),
         t = steps.known("sigma_2", si<Stress>(-17.05e6)),
         theta = steps.known("theta", 0.5235987755982988, {ValueKind::angle});
};

}  // namespace

TEST_CASE_METHOD(Symbols, "Products stand side by side in symbols, with an x in values") {
  CHECK(symbols_of(0.6 * A * a / b) == "0.6 A_eff a/b");
  CHECK(values_of(0.6 * a * b / 1.25) == "0.6 x 2.000 x 5.000/1.25");
  CHECK(symbols_of(2.0 * Traced(3.0) * a) == "2 x 3 a");
  CHECK(values_of(F * l) == "12.00 kN x 300.0 mm");
}

TEST_CASE_METHOD(Symbols, "A term has one slash") {
  CHECK(symbols_of(a / b / l) == "a/(b l)");
  CHECK(symbols_of(a / (2.0 * b)) == "a/(2 b)");
  CHECK(symbols_of(a / (b * (2.0 * l))) == "a/(2 b l)");
  CHECK(symbols_of(a / b * l) == "a l/b");
  CHECK(symbols_of(1.0 / a) == "1/a");
  CHECK(symbols_of(a * (1.0 / b)) == "a/b");
  CHECK(symbols_of(1.0 * (a + b)) == "a + b");
  CHECK(symbols_of(a / (1.0 - b)) == "a/(1 - b)");
  CHECK(symbols_of(a / (b / l)) == "a/(b/l)");
  CHECK(symbols_of((a + b) / 8.0) == "(a + b)/8");
  CHECK(symbols_of(F * (a + 4.0 * b) / 8.0) == "F (a + 4 b)/8");
  CHECK(values_of(a / (b * l)) == "2.000/(5.000 x 300.0 mm)");
  CHECK(values_of(a / c) == "2.000/(-4.000)");
}

TEST_CASE_METHOD(Symbols, "Equal factors behind each other are a power") {
  CHECK(symbols_of(3.0 * a * a / 4.0) == "3 a^2/4");
  CHECK(symbols_of((1.0 - a) * (1.0 - a) * (1.0 - a)) == "(1 - a)^3");
  CHECK(symbols_of(a * b * a) == "a b a");
  CHECK(symbols_of(1.0 / (l * l)) == "1/l^2");
  CHECK(values_of(a * a + b * b) == "2.000^2 + 5.000^2");
  CHECK(values_of(l * l) == "(300.0 mm)^2");
  CHECK(values_of(c * c) == "(-4.000)^2");
  CHECK(symbols_of(sqrt(a) * sqrt(a)) == "sqrt(a)^2");
}

TEST_CASE_METHOD(Symbols, "Exponents and functions") {
  CHECK(symbols_of(pow(a / b, 1.0 / Traced(5.0))) == "(a/b)^(1/5)");
  CHECK(symbols_of(pow(a, b)) == "a^b");
  CHECK(values_of(pow(a, 1.0 / Traced(3.0))) == "(2.000)^(1/3)");
  CHECK(symbols_of(sqrt(a * a - b * b)) == "sqrt(a^2 - b^2)");
  CHECK(symbols_of(largest_of({a, b, sqrt(b)})) == "max(a, b, sqrt(b))");
  CHECK(values_of(abs(c)) == "abs(-4.000)");
  CHECK(symbols_of(sin(theta) - sin(3.0 * theta)) == "sin theta - sin 3theta");
  CHECK(values_of(1.0 - 2.0 * cos(2.0 * theta)) == "1 - 2 x cos(2 x 30 deg)");
  CHECK(symbols_of(sin(a + b)) == "sin(a + b)");
  // Behind what they are multiplied by, where they cannot be read as its function.
  CHECK(symbols_of(4.0 / (1.0 - a) * sin(2.0 * theta) * b) == "4 b sin 2theta/(1 - a)");
}

TEST_CASE_METHOD(Symbols, "A minus of the formula is one of the sum; one of a value has brackets") {
  CHECK(symbols_of(a - b) == "a - b");
  CHECK(symbols_of(a - (b + l / l)) == "a - (b + l/l)");
  CHECK(symbols_of(a + (b + 1.0)) == "a + b + 1");
  CHECK(symbols_of(a + -b) == "a - b");
  CHECK(symbols_of(-a) == "-a");
  CHECK(symbols_of(-(a + b)) == "-(a + b)");
  CHECK(symbols_of(-4.0 * a * b / (1.0 - a)) == "-4 a b/(1 - a)");
  CHECK(values_of(a + c) == "2.000 + (-4.000)");
  CHECK(values_of(a - c) == "2.000 - (-4.000)");
  CHECK(values_of(-c) == "-(-4.000)");
  CHECK(values_of(N * l) == "(-27.66 kN) x 300.0 mm");
  CHECK(values_of(N / A + s) == "-27.66 kN/87200 mm^2 + 16.33 MPa");
}

TEST_CASE_METHOD(Symbols, "A constant stands as it is printed") {
  CHECK(symbols_of(Derivation::constant("235 MPa", 235e6 * pascal) / s) == "235 MPa/sigma_1");
  CHECK(symbols_of(Derivation::constant("0.600", 0.6) * a) == "0.600 a");
  const Traced cycles = Derivation::literal(2e6, ValueKind::cycles);
  CHECK(symbols_of(cycles * pow(a / b, 3.0)) == "2e6 (a/b)^3");
  CHECK(values_of(cycles * pow(a / b, 3.0)) == "2e6 x (2.000/5.000)^3");
  CHECK(symbols_of(pow(a / (b * l / l), 3.0)) == "(a/(b l/l))^3");
}

TEST_CASE_METHOD(Symbols, "A step is its symbols, its values and its result, none of them twice") {
  steps.given("d", si<Length>(0.05), "pin");
  const Traced n = steps.define("n", a * b);
  steps.define("m", n);
  steps.note([] { return "up to {} and {}"; }, n, s);
  steps.state("r", a * n);
  const Steps of = steps_of(steps);
  REQUIRE(of.size() == 4);
  CHECK(of[3].formulas == Texts{"a n"});
  CHECK(of[0].symbol == "d");
  CHECK(of[0].formulas == Texts{"50.00 mm"});
  CHECK(of[0].notes == Texts{"pin"});
  CHECK(of[1].formulas == Texts{"a b", "2.000 x 5.000", "10.00"});
  CHECK(of[2].formulas == Texts{"n", "10.00"});
  CHECK(of[2].notes == Texts{"up to 10.00 and 16.33 MPa"});
}

TEST_CASE_METHOD(Symbols, "A sum of stresses shows its terms with as many decimals as it needs") {
  steps.define("d_sigma", s - t);
  steps.define("sigma", N / A + F * l * l / (A * l * l));
  const Steps of = steps_of(steps);
  CHECK(of[0].formulas == Texts{"sigma_1 - sigma_2", "16.33 MPa - (-17.05 MPa)", "33.38 MPa"});
  // -0.31720 + 0.13761 = -0.17959 MPa.
  REQUIRE(of[1].formulas.size() == 4);
  CHECK(of[1].formulas[2] == "-0.3172 MPa + 0.1376 MPa");
  CHECK(of[1].formulas[3] == "-0.1796 MPa");
}

TEST_CASE("Values are printed in the units of their kind") {
  CHECK(value_text(0.025, {ValueKind::length}) == "25.00 mm");
  CHECK(value_text(1963.495e-6, {ValueKind::area}) == "1963.5 mm^2");
  CHECK(value_text(2.15e-3, {ValueKind::section_modulus}) == "2.1500e6 mm^3");
  CHECK(value_text(3.86572e-3, {ValueKind::second_moment}) == "3.8657e9 mm^4");
  CHECK(value_text(-27.66e3, {ValueKind::force}) == "-27.66 kN");
  CHECK(value_text(1e-5, {ValueKind::force}) == "0 kN");
  CHECK(value_text(12.5e3, {ValueKind::moment}) == "12.50 kN m");
  CHECK(value_text(355e6, {ValueKind::stress}) == "355.0 MPa");
  CHECK(value_text(1.25, {ValueKind::factor}) == "1.25");
  CHECK(value_text(0.123456789, {ValueKind::number}) == "0.1235");
  CHECK(value_text(0.123456789, {ValueKind::number, 6}) == "0.123457");
  CHECK(value_text(2.4863e-5, {ValueKind::share}) == "2.486e-5");
  CHECK(value_text(5e6, {ValueKind::cycles}) == "5e6");
  CHECK(value_text(3.52e7, {ValueKind::cycles, 4}) == "3.520e7");
  CHECK(value_text(457.2, {ValueKind::per_area}) == "4.572e-4 mm^-2");
  CHECK(value_text(457.2, {ValueKind::per_volume}) == "4.572e-7 mm^-3");
}

}  // namespace derivation_text_test
