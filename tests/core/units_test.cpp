#include "boxbeam/core/units.hpp"

#include <type_traits>

#include "catch.hpp"

namespace units_test {

using namespace boxbeam;

namespace {

template <class A, class B>
concept addable = requires(A a, B b) {
  a + b;
};

template <class A, class B>
concept comparable = requires(A a, B b) {
  a < b;
};

// A unit system that lets a wrong sum compile is none.
static_assert(addable<Length, Length>);
static_assert(addable<Force, Force>);
static_assert(!addable<Length, Force>);
static_assert(!addable<Stress, Force>);
static_assert(!addable<Moment, Force>);
static_assert(!addable<Length, double>);
static_assert(!comparable<Length, Force>);

static_assert(!std::is_convertible_v<double, Length>);
static_assert(!std::is_convertible_v<Length, double>);
static_assert(!std::is_convertible_v<Length, Force>);

// Definitions of mechanics.
static_assert(std::is_same_v<decltype(Force{} * Length{}), Moment>);
static_assert(std::is_same_v<decltype(Force{} / Area{}), Stress>);
static_assert(std::is_same_v<decltype(Length{} * Length{}), Area>);
static_assert(std::is_same_v<decltype(Area{} * Length{}), SectionModulus>);
static_assert(std::is_same_v<decltype(Moment{} / SectionModulus{}), Stress>);
static_assert(std::is_same_v<decltype(Density{} * Area{}), MassPerLength>);
static_assert(std::is_same_v<decltype(Mass{} * Acceleration{}), Force>);
static_assert(std::is_same_v<decltype(MassPerLength{} * Acceleration{}), ForcePerLength>);
static_assert(std::is_same_v<decltype(Density{} * SecondMoment{} * Length{}), MassMoment>);

// Boost's own torque carries the plane angle and is another type.
static_assert(!std::is_same_v<boost::units::quantity<units::si::torque>, Moment>);

}  // namespace

TEST_CASE("si crosses from a plain double and value() back, unchanged") {
  CHECK(si<Length>(0.25).value() == 0.25);
  CHECK(si<Force>(-1.5e3).value() == -1.5e3);
  CHECK(si<Length>(0.25) == 0.25 * metre);
  static_assert(si<Length>(2.0).value() == 2.0);
}

TEST_CASE("quantities start at zero") {
  CHECK(Length{}.value() == 0.0);
  CHECK(Stress{}.value() == 0.0);
  CHECK(Moment{}.value() == 0.0);
}

TEST_CASE("the SI units are coherent: products of ones are ones") {
  CHECK((1.0 * newton * (1.0 * metre)).value() == 1.0);
  CHECK((si<Force>(1.0) / si<Area>(1.0) / (1.0 * pascal)).value() == 1.0);
  CHECK((si<Mass>(1.0) * si<Acceleration>(1.0) / (1.0 * newton)).value() == 1.0);
  CHECK(1.0 * kilogram == si<Mass>(1.0));
  CHECK(1.0 * second == si<Time>(1.0));
}

TEST_CASE("a moment is force times lever arm") {
  // Lever rule by hand: 12 kN at 250 mm are 3 kN m.
  const Moment moment = si<Force>(12e3) * si<Length>(0.25);
  CHECK(moment.value() == Approx(3e3).epsilon(1e-15));
}

}  // namespace units_test
