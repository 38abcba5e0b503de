// A published example of Miner's rule (Anvilate, fatigue life by EN 1993-1-9): 1e5 cycles of 90,
// 1e6 of 60 and 1e7 of 40 MPa.

#include "boxbeam/fatigue/damage.hpp"
#include "catch.hpp"

namespace anvilate_miner_test {

using namespace boxbeam;

namespace {

const std::vector<Cycle> example{
    {si<Stress>(90e6), {}, 1e5}, {si<Stress>(60e6), {}, 1e6}, {si<Stress>(40e6), {}, 1e7}};

double damage(double category, double gamma_Mf) {
  return damage_of(example, en_1993_1_9_direct(category), {Loading::spectrum, 1.0, gamma_Mf});
}

double endured(double category, double range) {
  return cycles_to_failure(en_1993_1_9_direct(category), si<Stress>(range * 1e6),
                           Loading::spectrum);
}

}  // namespace

TEST_CASE("Miner's sum of a published example: 2.5 for category 56, 0.33 for category 90") {
  // Published 2.5 and 0.33; to more digits from the equations of EN 1993-1-9, 7.1, apart from
  // this program.
  CHECK(damage(56, 1.0) == Approx(2.535004).margin(1e-6));
  CHECK(damage(90, 1.0) == Approx(0.331002).margin(1e-6));
}

TEST_CASE("cycles to failure in the published example") {
  CHECK(endured(56, 90) == Approx(481800).margin(1));
  CHECK(endured(56, 60) == Approx(1626074).margin(1));
  CHECK(endured(56, 40) == Approx(5839516).margin(1));
  CHECK(endured(90, 90) == Approx(2.0e6).margin(1));
  CHECK(endured(90, 60) == Approx(8245044).margin(1));
  CHECK(endured(90, 40) == Approx(62610799).margin(1));
}

TEST_CASE("the same with gamma_Mf = 1.15 and 1.35 on the whole curve, EN 1993-1-9 annex A.5") {
  CHECK(damage(56, 1.15) == Approx(4.022244).margin(1e-6));
  CHECK(damage(90, 1.15) == Approx(0.622606).margin(1e-6));
  CHECK(damage(56, 1.35) == Approx(6.506931).margin(1e-6));
  CHECK(damage(90, 1.35) == Approx(1.203694).margin(1e-6));
}

}  // namespace anvilate_miner_test
