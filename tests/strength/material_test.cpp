#include "boxbeam/strength/material.hpp"

#include <algorithm>

#include "boxbeam/project/catalogue.hpp"
#include "catch.hpp"

using namespace boxbeam;

namespace {

/// Yield strength in MPa, 0 where the table gives none.
double yield(const char* steel, double thickness_mm) {
  const auto strength = yield_strength_of(*find_steel(steel), si<Length>(1e-3 * thickness_mm));
  return strength ? strength->value() * 1e-6 : 0.0;
}

struct Step {
  double up_to;  ///< mm
  double yield;  ///< MPa
};

/// Checks each step at its upper end and just above the step before.
void check_steps(const char* steel, const std::vector<Step>& steps) {
  double above = 0.0;
  for (const Step& step : steps) {
    CAPTURE(steel, step.up_to);
    CHECK(yield(steel, above + 0.001) == Approx(step.yield).epsilon(1e-12));
    CHECK(yield(steel, step.up_to) == Approx(step.yield).epsilon(1e-12));
    above = step.up_to;
  }
  CHECK(yield(steel, above + 0.001) == 0.0);
}

}  // namespace

TEST_CASE("S355, minimum yield strength by thickness, EN 10025-2 table 7") {
  check_steps("S355", {{16, 355},
                       {40, 345},
                       {63, 335},
                       {80, 325},
                       {100, 315},
                       {150, 295},
                       {200, 285},
                       {250, 275},
                       {400, 265}});
}

TEST_CASE("S235, S275 and S450 by thickness, EN 10025-2 table 7") {
  check_steps("S235", {{16, 235}, {40, 225}, {63, 215}, {80, 215}, {100, 215}, {150, 195}});
  check_steps("S275", {{16, 275}, {40, 265}, {63, 255}, {80, 245}, {100, 235}, {150, 225}});
  check_steps("S450", {{16, 450}, {40, 430}, {63, 410}, {80, 390}, {100, 380}});
}

TEST_CASE("a plate of 50 mm of S355 yields at 335 MPa, as the sledge-rig thesis takes it") {
  CHECK(yield("S355", 50) == Approx(335).epsilon(1e-12));
}

TEST_CASE("a thickness a bit of round-off above a step still belongs to it") {
  const Material steel = *find_steel("S355");
  const Length sum = si<Length>(0.1 + 0.2 - 0.26);  // 40 mm and round-off
  CHECK(sum > si<Length>(0.04));
  CHECK(yield_strength_of(steel, sum) == si<Stress>(345e6));
}

TEST_CASE("no plate is stronger than a thinner one of the same steel") {
  for (const std::string& name : steel_names()) {
    const Material steel = *find_steel(name);
    REQUIRE_FALSE(steel.yield.empty());
    CHECK_FALSE(steel.source.empty());
    for (std::size_t i = 1; i < steel.yield.size(); ++i) {
      CHECK(steel.yield[i].up_to > steel.yield[i - 1].up_to);
      CHECK(steel.yield[i].yield_strength <= steel.yield[i - 1].yield_strength);
    }
  }
}

TEST_CASE("a steel of another name is not found") {
  CHECK_FALSE(find_steel("S356"));
  CHECK_FALSE(find_steel(""));
  const auto names = steel_names();
  CHECK(std::find(names.begin(), names.end(), "S355") != names.end());
}
