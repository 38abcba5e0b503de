// Values at which a result is what is wanted: closed forms, jumps, gaps, touches.

#include "boxbeam/study/roots.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "boxbeam/study/written_quantity.hpp"
#include "catch.hpp"

namespace roots_test {

using namespace boxbeam;

namespace {

Roots roots(double from, double to, double wanted, const std::function<double(double)>& result) {
  RootQuestion question;
  question.from = from;
  question.to = to;
  question.wanted = wanted;
  question.at = [&](double x) { return Trial{result(x), ""}; };
  return roots_of(question);
}

}  // namespace

TEST_CASE("all values at which a result is the wanted one are found", "[study]") {
  const double pi = std::numbers::pi;
  const Roots sine = roots(0.1, 20.0, 0.5, [](double x) { return std::sin(x); });
  REQUIRE(sine.roots.size() == 7);
  for (std::size_t k = 0; k < sine.roots.size(); ++k) {
    const double n = static_cast<double>(k);
    const double exact = k % 2 == 0 ? pi / 6.0 + n * pi : 5.0 * pi / 6.0 + (n - 1.0) * pi;
    CHECK(sine.roots[k].value == Approx(exact).epsilon(1e-13));
    CHECK(std::abs(sine.roots[k].result - 0.5) <= 0.5e-9);
  }
  CHECK(sine.jumps.empty());
  CHECK(sine.failed == 0);
}

TEST_CASE("a factor that falls with the third power is met to the last digits", "[study]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-4.0, 4.0);
  for (int i = 0; i < 200; ++i) {
    const double at = std::pow(10.0, exponent(random));
    const Roots found =
        roots(0.1 * at, 30.0 * at, 2.0, [&](double x) { return 2.0 * std::pow(at / x, 3); });
    REQUIRE(found.roots.size() == 1);
    CHECK(found.roots[0].value == Approx(at).epsilon(1e-14));
  }
}

TEST_CASE("a result that jumps over the wanted one has no root there", "[study]") {
  const Roots found = roots(0.0, 1.0, 2.0, [](double x) { return x < 0.3 ? 1.0 : 3.0; });
  CHECK(found.roots.empty());
  REQUIRE(found.jumps.size() == 1);
  CHECK(found.jumps[0].value == Approx(0.3).epsilon(1e-12));
  CHECK(found.jumps[0].before == 1.0);
  CHECK(found.jumps[0].behind == 3.0);
}

TEST_CASE("what touches the wanted result, or dips below it between two places, is found",
          "[study]") {
  const Roots dip =
      roots(0.0, 1.0, 1.0, [](double x) { return 1.0 - 1e-6 + (x - 0.31) * (x - 0.31); });
  REQUIRE(dip.roots.size() == 2);
  CHECK(dip.roots[0].value == Approx(0.309).epsilon(1e-9));
  CHECK(dip.roots[1].value == Approx(0.311).epsilon(1e-9));
  const Roots touch = roots(0.0, 1.0, 1.0, [](double x) { return 1.0 + (x - 0.31) * (x - 0.31); });
  REQUIRE(touch.roots.size() == 1);
  CHECK(touch.roots[0].value == Approx(0.31).margin(1e-4));
}

TEST_CASE("where nothing can be calculated that is said, and roots beside it are found",
          "[study]") {
  RootQuestion question;
  question.from = -1.0;
  question.to = 3.0;
  question.wanted = 0.25;
  question.at = [](double x) {
    if (x < 0.0) return Trial{std::nullopt, "no assembly"};
    return Trial{std::sqrt(x), ""};
  };
  const Roots found = roots_of(question);
  REQUIRE(found.roots.size() == 1);
  CHECK(found.roots[0].value == Approx(0.0625).epsilon(1e-12));
  CHECK(found.first_trouble == "no assembly");
  CHECK(found.failed_at == -1.0);
  CHECK(found.failed >= 12);
  question.wanted = 9.0;
  const Roots none = roots_of(question);
  CHECK(none.roots.empty());
  REQUIRE(none.nearest);
  CHECK(none.nearest->value == 3.0);
  CHECK(none.nearest->result == Approx(std::sqrt(3.0)));
}

namespace {

Roots roots_where(double wanted, const std::function<double(double)>& result,
                  const std::function<bool(double)>& is_there) {
  RootQuestion question;
  question.from = 0.0;
  question.to = 1.0;
  question.wanted = wanted;
  question.at = [&](double x) {
    return is_there(x) ? Trial{result(x), ""} : Trial{std::nullopt, "no assembly"};
  };
  return roots_of(question);
}

}  // namespace

// By hand: the scan has places at k/48; 0.5 is one, the next 0.5208.
TEST_CASE("a value just before results end is found, from either side", "[study]") {
  const auto line = [](double x) { return x; };
  const Roots below = roots_where(0.515, line, [](double x) { return x < 0.518; });
  REQUIRE(below.roots.size() == 1);
  CHECK(below.roots[0].value == Approx(0.515).epsilon(1e-14));
  const Roots above = roots_where(0.515, line, [](double x) { return x > 0.511; });
  REQUIRE(above.roots.size() == 1);
  CHECK(above.roots[0].value == Approx(0.515).epsilon(1e-14));
  const Roots none = roots_where(0.519, line, [](double x) { return x < 0.518; });
  CHECK(none.roots.empty());
  REQUIRE(none.nearest);
  CHECK(none.nearest->value == Approx(0.518).margin(1.0 / 48.0 / 4096.0));
}

// A gap in which nothing can be calculated has no result that could jump.
TEST_CASE("where results end between two sides of the wanted one there is no jump", "[study]") {
  const auto gap = [](double x) { return x < 0.508 || x > 0.515; };
  const Roots none = roots_where(
      0.5115, [](double x) { return x; }, gap);
  CHECK(none.roots.empty());
  CHECK(none.jumps.empty());
  CHECK(none.failed > 0);
  // One on each side of the gap, across which it falls back.
  const Roots two = roots_where(
      0.505, [](double x) { return x < 0.51 ? x : x - 0.012; }, gap);
  REQUIRE(two.roots.size() == 2);
  CHECK(two.roots[0].value == Approx(0.505).epsilon(1e-13));
  CHECK(two.roots[1].value == Approx(0.517).epsilon(1e-13));
}

TEST_CASE("a dip between the first two places of the scan is found, and between the last",
          "[study]") {
  for (const double at : {0.004, 0.996}) {
    const Roots dip = roots(0.0, 1.0, 0.0, [&](double x) { return (x - at) * (x - at) - 1e-6; });
    REQUIRE(dip.roots.size() == 2);
    CHECK(dip.roots[0].value == Approx(at - 1e-3).epsilon(1e-9));
    CHECK(dip.roots[1].value == Approx(at + 1e-3).epsilon(1e-9));
  }
}

TEST_CASE("an end of the interval may be the root", "[study]") {
  const auto line = [](double x) { return x; };
  CHECK(roots(2.0, 3.0, 2.0, line).roots.size() == 1);
  CHECK(roots(1.0, 2.0, 2.0, line).roots.size() == 1);
  CHECK(roots(1.0, 3.0, 2.0, line).roots.size() == 1);
}

TEST_CASE("a quantity keeps its unit and its digits", "[study]") {
  const std::optional<WrittenQuantity> plate = quantity_written_in("12.5 mm");
  REQUIRE(plate);
  CHECK(plate->value == 12.5);
  CHECK(plate->unit == "mm");
  CHECK(to_text(*plate) == "12.5 mm");
  CHECK(quantity_written_in("-3e2 kN m")->value == -300.0);
  CHECK(quantity_written_in("1.5")->unit.empty());
  CHECK_FALSE(quantity_written_in("S355"));
  CHECK_FALSE(quantity_written_in("12 parsec"));
  CHECK_FALSE(quantity_written_in("nan mm"));
  CHECK_FALSE(quantity_written_in("inf"));
  CHECK(*ratio_of_units("m", "mm") == Approx(1e-3));
  CHECK(*ratio_of_units("mm", "m") == Approx(1e3));
  CHECK_FALSE(ratio_of_units("m", "s"));
  CHECK_FALSE(ratio_of_units("m", ""));
  CHECK(to_text(WrittenQuantity{0.1 + 0.2, ""}) == "0.30000000000000004");
}

TEST_CASE("of whole numbers all are looked at, and nothing between them", "[study]") {
  RootQuestion question;
  question.from = 1.5;
  question.to = 9.2;
  question.whole = true;
  const auto squares = [](double step) {
    return [step](double value) -> Trial {
      CHECK(value == std::round(value));
      if (std::fmod(value, step) != 0.0) return {std::nullopt, "none"};
      return {value * value, ""};
    };
  };
  question.at = squares(1.0);
  question.wanted = 49.0;
  const Roots seven = roots_of(question);
  CHECK(seven.trials == 8);
  REQUIRE(seven.roots.size() == 1);
  CHECK(seven.roots[0].value == 7.0);
  CHECK(seven.jumps.empty());
  question.wanted = 50.0;
  question.at = squares(2.0);  // 36 at 6, 64 at 8
  const Roots passed = roots_of(question);
  CHECK(passed.roots.empty());
  REQUIRE(passed.jumps.size() == 1);
  CHECK(passed.jumps[0].value == 7.0);
  CHECK(passed.jumps[0].apart == 2.0);
  CHECK(passed.jumps[0].before == 36.0);
  CHECK(passed.jumps[0].behind == 64.0);
  question.to = 1e6;
  question.at = squares(1.0);
  const Roots narrowed = roots_of(question);
  CHECK(narrowed.trials <= 1001 + 10);
  REQUIRE(narrowed.jumps.size() == 1);
  CHECK(narrowed.jumps[0].value == 7.5);
  CHECK(narrowed.jumps[0].apart == 1.0);
  question.wanted = 49.0;
  const Roots found = roots_of(question);
  REQUIRE(found.roots.size() == 1);
  CHECK(found.roots[0].value == 7.0);
}

}  // namespace roots_test
