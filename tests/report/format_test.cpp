#include "boxbeam/report/format.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace format_test {

using namespace boxbeam;
using text::Quantity;

namespace {

constexpr std::array quantities{Quantity::force,
                                Quantity::moment,
                                Quantity::stress,
                                Quantity::length,
                                Quantity::station,
                                Quantity::factor,
                                Quantity::utilisation,
                                Quantity::time,
                                Quantity::area,
                                Quantity::second_moment,
                                Quantity::section_modulus,
                                Quantity::mass,
                                Quantity::inertia,
                                Quantity::frequency,
                                Quantity::ratio};

int digits_in(const std::string& number) {
  int digits = 0;
  bool leading = true;
  for (const char c : number) {
    if (c == 'e') break;
    if (c < '0' || c > '9') continue;
    leading = leading && c == '0';
    if (!leading) ++digits;
  }
  return digits;
}

}  // namespace

TEST_CASE("every quantity has its rule of rounding", "[format]") {
  // By hand from the table in format.hpp.
  CHECK(text::kN(31658.4) == "31.66 kN");
  CHECK(text::kNm(-319651.0) == "-319.7 kN m");
  CHECK(text::MPa(16.3251e6) == "16.33 MPa");
  CHECK(text::mm(0.0275984) == "27.60 mm");
  CHECK(text::rounded(Quantity::station, 6.2) == "6.200");
  CHECK(text::factor(1.21298) == "1.21");
  CHECK(text::percent(1.6487) == "165 %");
  CHECK(text::seconds(0.35714285) == "0.3571 s");
  CHECK(text::rounded(Quantity::area, 0.09) == "90.000");
  CHECK(text::rounded(Quantity::second_moment, 4.075e-3) == "4075.0");
  CHECK(text::rounded(Quantity::section_modulus, 0.0135833) == "13583");
  CHECK(text::with_unit(Quantity::mass, 4946.93) == "4946.9 kg");
  CHECK(text::with_unit(Quantity::frequency, 9.19341) == "9.193 Hz");
  CHECK(text::with_unit(Quantity::ratio, 1.1378) == "1.138");
  CHECK(text::kilograms(18626.7) == "18627 kg");
}

TEST_CASE("a number that rounds up to a power of ten has no digit more", "[format]") {
  CHECK(text::significant(9.9996, 4) == "10.00");
  CHECK(text::significant(99.96, 3) == "100");
  CHECK(text::significant(-0.99996, 4) == "-1.000");
  CHECK(text::significant(9.9994, 4) == "9.999");
}

TEST_CASE("a utilisation above 1 never reads as 100 %", "[format]") {
  CHECK(text::percent(1.0) == "100 %");
  CHECK(text::percent(0.9996) == "100 %");  // it passes, and 100 % does
  CHECK(text::percent(1.0009) == "100.1 %");
  CHECK(text::percent(1.00001) == "100.001 %");
  CHECK(text::percent(2.0) == "200 %");
  CHECK(text::percent(10.0) == "1000 %");
}

TEST_CASE("cycles are written as powers of ten", "[format]") {
  CHECK(text::cycles(1e8) == "1e8");
  CHECK(text::cycles(2e6) == "2e6");
  CHECK(text::cycles(9.99999e6) == "1e7");
  CHECK(text::cycles(12345678.0) == "1.235e7");
  CHECK(text::cycles(0.5) == "0.5");
  CHECK(text::cycles(0.0) == "0");
  CHECK(text::cycles(500.0) == "500");
}

TEST_CASE("rounding keeps the value to half a unit of its last digit", "[format]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-5.0, 8.0);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    const std::string shown = text::significant(value, 4);
    double read = 0.0;
    const auto [end, error] = std::from_chars(shown.data(), shown.data() + shown.size(), read);
    INFO(value << " as " << shown);
    REQUIRE(error == std::errc{});
    CHECK(end == shown.data() + shown.size());
    CHECK(std::abs(read - value) <= 0.5001e-3 * std::abs(value));
    // Whole digits are not dropped, so a large number may have more.
    CHECK(digits_in(shown) >= 4);
    if (std::abs(value) < 9999.0) CHECK(digits_in(shown) == 4);
  }
}

TEST_CASE("zero is 0 in every quantity, and the unit stands behind the number", "[format]") {
  for (const Quantity quantity : quantities) {
    const std::string number = text::rounded(quantity, 0.0);
    CHECK(number == (quantity == Quantity::time ? "0.0000" : "0"));
    const std::string unit = text::unit_of(quantity);
    CHECK(text::with_unit(quantity, 0.0) == (unit.empty() ? number : number + " " + unit));
  }
}

}  // namespace format_test
