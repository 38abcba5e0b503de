#include "boxbeam/project/quantity_text.hpp"

#include <numbers>

#include "catch.hpp"

namespace quantity_text_test {

using namespace boxbeam;

namespace {

ParsedQuantity good(std::string_view text) {
  const auto parsed = parse_quantity(text);
  CAPTURE(text);
  REQUIRE(std::holds_alternative<ParsedQuantity>(parsed));
  return std::get<ParsedQuantity>(parsed);
}

/// What is wrong with a text; "" where it can be read.
std::string trouble(std::string_view text) {
  const auto parsed = parse_quantity(text);
  return std::holds_alternative<std::string>(parsed) ? std::get<std::string>(parsed) : "";
}

void check(std::string_view text, double value, const DimensionExponents& exponents) {
  const ParsedQuantity quantity = good(text);
  CAPTURE(text);
  CHECK(quantity.value == Approx(value).epsilon(1e-14));
  CHECK(quantity.exponents == exponents);
}

constexpr DimensionExponents force{1, 1, -2, 0};
constexpr DimensionExponents moment{2, 1, -2, 0};

}  // namespace

// Expected values: the SI brochure's definitions of units and prefixes.

TEST_CASE("every unit known, in SI base units") {
  check("1 m", 1, {1, 0, 0, 0});
  check("1 kg", 1, {0, 1, 0, 0});
  check("1 g", 1e-3, {0, 1, 0, 0});
  check("20 t", 20e3, {0, 1, 0, 0});
  check("1 s", 1, {0, 0, 1, 0});
  check("2 min", 120, {0, 0, 1, 0});
  check("2 h", 7200, {0, 0, 1, 0});
  check("1 rad", 1, {0, 0, 0, 1});
  check("180 deg", std::numbers::pi, {0, 0, 0, 1});
  check("0.7 Hz", 0.7, {0, 0, -1, 0});
  check("60 rpm", 2 * std::numbers::pi, {0, 0, -1, 1});
  check("1 N", 1, force);
  check("1 Pa", 1, wanted::stress.exponents);
  check("1 bar", 1e5, wanted::stress.exponents);
  check("1 J", 1, moment);
  check("1 W", 1, {2, 1, -3, 0});
}

TEST_CASE("prefixes") {
  check("250 mm", 0.25, {1, 0, 0, 0});
  check("25 cm", 0.25, {1, 0, 0, 0});
  check("2 km", 2000, {1, 0, 0, 0});
  check("5 um", 5e-6, {1, 0, 0, 0});
  check("5 µm", 5e-6, {1, 0, 0, 0});
  check("5 nm", 5e-9, {1, 0, 0, 0});
  check("355 MPa", 355e6, wanted::stress.exponents);
  check("210 GPa", 210e9, wanted::stress.exponents);
  check("12 kN", 12e3, force);
  check("3 ms", 3e-3, {0, 0, 1, 0});
  check("1 Mg", 1e3, {0, 1, 0, 0});
}

TEST_CASE("minutes, metres and milli do not mix") {
  check("1 min", 60, {0, 0, 1, 0});
  check("1 mm", 1e-3, {1, 0, 0, 0});
  check("1 m m", 1, {2, 0, 0, 0});
}

TEST_CASE("products, quotients and exponents") {
  check("12 kN m", 12e3, moment);
  check("12 kN*m", 12e3, moment);
  check("12 kN·m", 12e3, moment);
  check("9.81 m/s^2", 9.81, wanted::acceleration.exponents);
  check("9.81 m s^-2", 9.81, wanted::acceleration.exponents);
  check("9.81 m/s/s", 9.81, wanted::acceleration.exponents);
  check("9.81 m/s²", 9.81, wanted::acceleration.exponents);
  check("7850 kg/m^3", 7850, wanted::density.exponents);
  check("7.85 g/cm³", 7850, wanted::density.exponents);
  check("7.43 kg m^2", 7.43, wanted::inertia.exponents);
  check("1 N/mm^2", 1e6, wanted::stress.exponents);
  check("6.89 kN/m", 6890, {0, 1, -2, 0});
  check("4.396 rad/s", 4.396, wanted::angular_frequency.exponents);
  check("4075e6 mm^4", 4.075e-3, {4, 0, 0, 0});
}

TEST_CASE("numbers as they are written") {
  check("-5 m", -5, {1, 0, 0, 0});
  check("+5 m", 5, {1, 0, 0, 0});
  check("  5 m  ", 5, {1, 0, 0, 0});
  check("5m", 5, {1, 0, 0, 0});
  check(".5 m", 0.5, {1, 0, 0, 0});
  check("1.5e3 mm", 1.5, {1, 0, 0, 0});
  check("1E-3 km", 1, {1, 0, 0, 0});
  check("0 m", 0, {1, 0, 0, 0});
  check("3", 3, {0, 0, 0, 0});
}

TEST_CASE("what cannot be read is refused") {
  for (const char* text : {"",        "   ",   "m",     "abc",    "m 5",     "--5 m", "1e400 m",
                           "5 5 m",   "5 m 5", "5 m^",  "5 m^0",  "5 m^10",  "5 m^x", "5 m^2^3",
                           "5 m^1.5", "5 /",   "5 (m)", "0x10 m", "5 \"m\"", "5 m;"}) {
    CAPTURE(text);
    CHECK_FALSE(trouble(text).empty());
  }
}

TEST_CASE("not a number and infinity are refused, written or reached") {
  for (const char* text :
       {"nan m", "NaN m", "-nan m", "inf m", "-inf m", "infinity m", "nan", "1e300 km^9"}) {
    CAPTURE(text);
    CHECK_FALSE(trouble(text).empty());
  }
  CHECK(trouble("nan m").find("finite") != std::string::npos);
}

TEST_CASE("a decimal comma is named as such") {
  CHECK(trouble("1,5 m").find("comma") != std::string::npos);
}

TEST_CASE("an unknown unit is named") {
  CHECK(trouble("5 furlong").find("furlong") != std::string::npos);
  // Prefixes stand only before units that take them.
  CHECK(trouble("5 kmin").find("kmin") != std::string::npos);
  CHECK(trouble("5 kt").find("kt") != std::string::npos);
  CHECK(trouble("5 mdeg").find("mdeg") != std::string::npos);
  // Upper and lower case differ.
  CHECK_FALSE(trouble("5 KN").empty());
  CHECK_FALSE(trouble("5 hz").empty());
  CHECK_FALSE(trouble("5 mpa").empty());
}

TEST_CASE("dimensions are named as a person would") {
  CHECK(name_of(good("1 mm").exponents) == "a length");
  CHECK(name_of(good("1 kN").exponents) == "a force");
  CHECK(name_of(good("1 kN m").exponents) == "a moment");
  CHECK(name_of(good("1 MPa").exponents) == "a stress");
  CHECK(name_of(good("1 Hz").exponents) == "a frequency");
  CHECK(name_of(good("1 rad/s").exponents) == "an angular frequency");
  CHECK(name_of(good("1 mm^2").exponents) == "an area");
  CHECK(name_of(good("1").exponents) == "a number without unit");
  CHECK(name_of(good("1 W").exponents) == "something in kg m^2 s^-3");
}

TEST_CASE("the example of every wanted dimension is of that dimension") {
  for (const WantedDimension& dimension :
       {wanted::length, wanted::mass, wanted::time, wanted::angle, wanted::frequency,
        wanted::angular_frequency, wanted::acceleration, wanted::stress, wanted::density,
        wanted::inertia, wanted::velocity, wanted::force, wanted::moment, wanted::stiffness,
        wanted::damping, wanted::torsional_stiffness, wanted::torsional_damping}) {
    const std::string example = dimension.example;
    const std::string first = example.substr(1, example.find('"', 1) - 1);
    CAPTURE(example);
    CHECK(good(first).exponents == dimension.exponents);
    CHECK(name_of(dimension.exponents) == dimension.name);
  }
}

TEST_CASE("a radian that may be left out is none that may be added") {
  CHECK(is_of(good("5 kN m/rad").exponents, wanted::torsional_stiffness));
  CHECK(is_of(good("5 kN m").exponents, wanted::torsional_stiffness));
  CHECK_FALSE(is_of(good("5 kN m rad").exponents, wanted::torsional_stiffness));
  CHECK(is_of(good("5 N m s").exponents, wanted::torsional_damping));
  CHECK_FALSE(is_of(good("5 kN m/rad").exponents, wanted::moment));
  CHECK_FALSE(is_of(good("5 Hz").exponents, wanted::angular_frequency));
}

TEST_CASE("the nearest word is one typing error away, or none") {
  const std::vector<std::string> known{"length", "section", "density", "id"};
  CHECK(nearest_word("lenght", known) == "length");
  CHECK(nearest_word("sectoin", known) == "section");
  CHECK(nearest_word("densty", known) == "density");
  CHECK(nearest_word("length", known) == "length");
  CHECK(nearest_word("ib", known) == "id");
  CHECK(nearest_word("frequency", known).empty());
  // As many letters are other ones, but of "B" only the size is.
  CHECK(nearest_word("lever.b", {"lever.A", "lever.B", "lever.C"}) == "lever.B");
  CHECK(nearest_word("LENGTH", known) == "length");
  CHECK(nearest_word("b", {"B", "b"}) == "b");
  CHECK(nearest_word("B", {"b", "B"}) == "B");
  CHECK(nearest_word("", known).empty());
  CHECK(nearest_word("length", {}).empty());
  CHECK(nearest_word(std::string(100000, 'x'), known).empty());
}

TEST_CASE("signs that look like a minus are named") {
  for (const auto& [text, name] : {std::pair{"\u22121.5 m", "the minus sign U+2212"},
                                   {"\u20131.5 m", "the dash U+2013"},
                                   {"\u2212 1.5 m", "the minus sign U+2212"}}) {
    const auto parsed = parse_quantity(text);
    REQUIRE(std::holds_alternative<std::string>(parsed));
    CHECK(std::get<std::string>(parsed) ==
          std::string(name) + " stands there; write the minus of the keyboard, -");
  }
  CHECK(look_alike_sign_in("-1.5 m").empty());
  CHECK(look_alike_sign_in("Stra\u00dfe \u2013x").empty());
}

}  // namespace quantity_text_test
