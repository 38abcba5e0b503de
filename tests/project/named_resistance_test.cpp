// What resists a history that stands by itself: rows with their sizes and marks, curves of codes.

#include "boxbeam/project/named_resistance.hpp"

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"

namespace named_resistance_test {

using namespace boxbeam;

namespace {

Length mm(double value) { return si<Length>(value * 1e-3); }

double strength_of(const NamedResistance& resistance) {
  return resistance.curve.reference.value() * 1e-6;
}

bool says(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE(
    "a row's size effect counts where the thickness is known, else it is said to be missing") {
  // EN 1993-1-9, 7.2.2: (25/40)^0.2 = 0.91028 on category 90 of row 8.3/5.
  const NamedResistance thick = resistance_named("8.3/5", StressKind::direct, mm(40.0));
  CHECK(thick.size_factor == Approx(0.91028).margin(5e-6));
  CHECK(strength_of(thick) == Approx(90.0 * std::pow(25.0 / 40.0, 0.2)).epsilon(1e-12));
  CHECK(thick.not_applied.empty());
  const NamedResistance thin = resistance_named("8.3/5", StressKind::direct, mm(20.0));
  CHECK(thin.size_factor == 1.0);
  CHECK(strength_of(thin) == Approx(90.0));
  const NamedResistance unknown = resistance_named("8.3/5", StressKind::direct, {});
  CHECK(strength_of(unknown) == Approx(90.0));
  CHECK(says(unknown.not_applied, "--thickness is not given"));
  CHECK(says(resistance_named("8.3/17", StressKind::direct, mm(40.0)).not_applied, "eccentricity"));
  CHECK(resistance_named("8.2/6", StressKind::direct, {}).not_applied.empty());
}

TEST_CASE("a row of several lines: the weakest that the thickness leaves") {
  // Table 8.5, row 6: 56 up to 20 mm, 50 up to 30 mm, 45 up to 50 mm for covers thinner than the
  // flange, one line lower for thicker ones; unknown which, the lower counts.
  CHECK(strength_of(resistance_named("8.5/6", StressKind::direct, mm(25.0))) == Approx(45.0));
  CHECK(strength_of(resistance_named("8.5/6", StressKind::direct, mm(15.0))) == Approx(50.0));
  CHECK(strength_of(resistance_named("8.5/6", StressKind::direct, {})) == Approx(36.0));
}

TEST_CASE("the mark of a recalled row stays with its curve") {
  CHECK(resistance_named("8.1/11", StressKind::direct, {}).curve.unconfirmed);
  CHECK_FALSE(resistance_named("8.2/6", StressKind::direct, {}).curve.unconfirmed);
}

TEST_CASE("curves of other codes have the thickness correction of their code") {
  // DNV-RP-C203 table 2-1: D has k = 0.2, F 0.25; BS 7608 (t/25)^0.25; IIW 0.3 for what is not
  // known.
  const auto factor = [](const char* name, double t) {
    return resistance_named(name, StressKind::direct, mm(t)).size_factor;
  };
  CHECK(factor("DNV-RP-C203 air:D", 50.0) == Approx(std::pow(0.5, 0.2)).epsilon(1e-12));
  CHECK(factor("DNV-RP-C203 air:F", 50.0) == Approx(std::pow(0.5, 0.25)).epsilon(1e-12));
  CHECK(factor("DNV-RP-C203 air:B1", 50.0) == 1.0);
  CHECK(factor("DNV-RP-C203 air:F", 25.0) == 1.0);
  CHECK(factor("BS 7608:F", 40.0) == Approx(std::pow(25.0 / 40.0, 0.25)).epsilon(1e-12));
  CHECK(factor("IIW:FAT 71", 40.0) == Approx(std::pow(25.0 / 40.0, 0.3)).epsilon(1e-12));
  CHECK(says(resistance_named("BS 7608:F", StressKind::direct, {}).not_applied, "not applied"));
}

TEST_CASE("a category as such has no row, and that its size effect is missing is said") {
  const NamedResistance category = resistance_named("71", StressKind::direct, mm(60.0));
  CHECK(strength_of(category) == Approx(71.0));
  CHECK(says(category.not_applied, "a category is given"));
}

TEST_CASE("what there is not is refused by name", "[bad_input]") {
  CHECK_THROWS_AS(resistance_named("8.3/99", StressKind::direct, {}), InputError);
  CHECK_THROWS_AS(resistance_named("57", StressKind::direct, {}), InputError);
  CHECK_THROWS_AS(resistance_named("DVN:C", StressKind::direct, {}), InputError);
  CHECK_THROWS_AS(resistance_named("8.3/5", StressKind::shear, {}), InputError);
}

}  // namespace named_resistance_test
