// Two published examples of Miner's rule (Tempest, cumulative damage): one slope without end, and
// one slope with a limit below which nothing damages.

#include <cmath>
#include <limits>

#include "boxbeam/fatigue/damage.hpp"
#include "catch.hpp"

namespace tempest_miner_test {

using namespace boxbeam;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

std::vector<Cycle> cycles_of(const std::vector<std::pair<double, double>>& range_and_count) {
  std::vector<Cycle> cycles;
  for (const auto& [range, count] : range_and_count) {
    cycles.push_back({si<Stress>(range * 1e6), {}, count});
  }
  return cycles;
}

const std::vector<Cycle> three_blocks = cycles_of({{100, 1e5}, {60, 5e5}, {40, 2e6}});

}  // namespace

TEST_CASE("category 71 with one slope m = 3 without limit: 0.46939, a life of 2.1304 blocks") {
  SnCurve curve;
  curve.reference = si<Stress>(71e6);
  curve.branches = {{3.0, endless}};
  const auto endured = [&](double range) {
    return cycles_to_failure(curve, si<Stress>(range * 1e6), Loading::spectrum);
  };
  CHECK(endured(100) == Approx(715822).margin(1));
  CHECK(endured(60) == Approx(3313991).margin(1));
  CHECK(endured(40) == Approx(11184719).margin(1));
  const double damage = damage_of(three_blocks, curve, {});
  CHECK(damage == Approx(0.46939).margin(5e-6));
  CHECK(1.0 / damage == Approx(2.1304).margin(5e-5));
}

TEST_CASE("the same on the whole curve of EN 1993-1-9 71: 0.39512") {
  // The third block lies behind the knee, m = 5: 19130593 cycles instead of 11184719. By the
  // equations of 7.1, apart from this program.
  const SnCurve curve = en_1993_1_9_direct(71);
  CHECK(cycles_to_failure(curve, si<Stress>(40e6), Loading::spectrum) ==
        Approx(19130593).margin(1));
  CHECK(damage_of(three_blocks, curve, {}) == Approx(0.395120).margin(1e-6));
}

TEST_CASE("150 MPa at 1e6 cycles, m = 5, limit 60 MPa: 0.65536 + 0.77760 + 0 = 1.4330") {
  SnCurve curve;
  curve.reference = si<Stress>(150e6);
  curve.reference_cycles = 1e6;
  curve.cut_off = 1e6 * std::pow(150.0 / 60.0, 5);
  curve.branches = {{5.0, *curve.cut_off}};
  const auto damage = [&](double range, double count) {
    return damage_of(cycles_of({{range, count}}), curve, {});
  };
  CHECK(damage(120, 2e6) == Approx(0.65536).margin(5e-6));
  CHECK(damage(90, 1e7) == Approx(0.77760).margin(5e-6));
  CHECK(damage(50, 1e7) == 0.0);
  CHECK(damage_of(cycles_of({{120, 2e6}, {90, 1e7}, {50, 1e7}}), curve, {}) ==
        Approx(1.4330).margin(5e-5));
}

}  // namespace tempest_miner_test
