// Which contacts stick, by numbers that are solved by hand.

#include "boxbeam/mechanism/common/sticking.hpp"

#include <string>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace sticking_test {

using namespace boxbeam;

namespace {

/// Contacts of unit mass, each pressed by 10 N and pushed by what is given.
FrictionResponse pushed(const std::vector<double>& by) {
  FrictionResponse of(by.size());
  for (std::size_t j = 0; j < by.size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    of.load_0[6 * k] = 10.0;
    of.rate_0[k] = by[j];
    of.rate(k, k) = 1.0;
  }
  return of;
}

const Friction law{0.3, 0.0, 0.0, 0.0, 0.5};

Sticking decided(const FrictionResponse& of, const Friction& friction = law) {
  const auto count = static_cast<std::size_t>(of.velocity.size());
  std::vector<std::string> names;
  for (std::size_t j = 0; j < count; ++j)
    names.push_back(std::string(1, static_cast<char>('a' + j)));
  return decide_sticking(std::vector<Friction>(count, friction), of, std::vector<char>(count, 1),
                         names, 0.0);
}

std::string refusal_of(const FrictionResponse& of, const Friction& friction = law) {
  return test::refusal_of<AnalysisError>([&] { return decided(of, friction); });
}

}  // namespace

TEST_CASE("a contact sticks up to its static coefficient and slides with its dynamic one") {
  const Sticking of = decided(pushed({4.9, -4.9, 5.1, -7.0}));
  CHECK(of.slips == std::vector<Slip>{Slip::none, Slip::none, Slip::ahead, Slip::back});
  CHECK(of.forces[0] == Approx(-4.9));
  CHECK(of.forces[1] == Approx(4.9));
  CHECK(of.forces[2] == Approx(-3.0));
  CHECK(of.forces[3] == Approx(3.0));
}

TEST_CASE("what breaks away may take others along") {
  // Each feels a half of the other's friction. Both sticking, the second one bears 7.3 N and breaks
  // away; with 5 N there the first one bears 7 - 2.5 = 4.5, with the 3 N of sliding 5.5 > 5.
  FrictionResponse of = pushed({7.0, 9.0});
  of.rate(1, 0) = of.rate(0, 1) = 0.5;
  const Sticking decision = decided(of);
  CHECK(decision.slips == std::vector<Slip>{Slip::ahead, Slip::ahead});
  CHECK(decision.forces.isApprox(Eigen::Vector2d(-3.0, -3.0)));
}

TEST_CASE("what Coulomb's law does not decide is refused by name") {
  FrictionResponse twins = pushed({2.0, 2.0});
  twins.rate.setOnes();
  CHECK_THAT(refusal_of(twins), Catch::Contains("hold the same movement"));
  twins.rate_0.setConstant(20.0);  // both slide: 20 - 6 > 0
  CHECK(decided(twins).forces.isApprox(Eigen::Vector2d(-3.0, -3.0)));
  // Friction presses with 3 N for every newton: mu 3 = 1.5. Pushed by 12 N it sticks, pressed by
  // |10 - 36| = 26 N, or slides, -f = (10 + 3 f)/2, f = -2 N.
  FrictionResponse wedged = pushed({12.0});
  wedged.load(0, 0) = 3.0;
  CHECK_THAT(refusal_of(wedged, {0.5, 0.0, 0.0}), Catch::Contains("more than one state"));
  // What moves it ahead cannot be held, and more friction presses more: 4 N for every newton.
  FrictionResponse held = pushed({1.0});
  held.rate.setZero();
  held.load(0, 0) = -4.0;
  CHECK_THAT(refusal_of(held, {0.5, 0.0, 0.0}), Catch::Contains("neither sticking nor sliding"));
}

TEST_CASE("impulses take what contacts slide, of twins a half each") {
  FrictionResponse of = pushed({0.0, 0.0});
  of.rate.setOnes();
  of.velocity.setConstant(1e-9);
  CHECK(holding_impulses(of, {1, 1}).isApprox(Eigen::Vector2d::Constant(-5e-10)));
  CHECK(holding_impulses(of, {0, 0}).isZero(0.0));
}

}  // namespace sticking_test
