// Which stresses are drawn over time, and what they are: by the cut forces of the loads at the
// instants that are drawn, and by the extremes that the check has found in another way.

#include "boxbeam/verification/drawn_histories.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace drawn_histories_test {

using namespace boxbeam;

TEST_CASE("three stresses are drawn over time, each of a station of its own", "[drawn-histories]") {
  const Project& project = test::rig();
  const Verification of = verify(project, Figures::without);
  const std::vector<std::size_t> drawn = drawn_over_time(of.checks);
  REQUIRE(drawn.size() == 3);
  CHECK(&of.checks[drawn.front()] == of.governing(Criterion::fatigue));
  std::set<std::pair<double, Side>> stations;
  const std::deque<SituationRun> runs = run_situations(project, of.model.chosen);
  for (const std::size_t i : drawn) {
    const CheckResult& result = of.checks[i];
    const CheckBasis& basis = *result.basis;
    CHECK(result.check.criterion == Criterion::fatigue);
    stations.emplace(result.check.station.s.value(), result.check.station.side);
    REQUIRE(basis.times.size() == basis.history.size());
    REQUIRE(basis.times.size() > 20);
    // Once round: the end is the beginning.
    CHECK(basis.times.back() - basis.times.front() ==
          Approx(runs.front().loads.period().value()).epsilon(1e-12));
    CHECK(basis.history.back() == basis.history.front());
    // sigma = sum of stress per cut force times cut force, by hand from a diagram solved anew.
    double apart = 0.0;
    for (std::size_t k = 0; k < basis.times.size(); k += 7) {
      const CutForces cut =
          runs.front().loads.diagram_at(si<Time>(basis.times[k])).at(result.check.station);
      const auto& per = basis.point.influence.normal;
      const double stress = basis.stress_factor * (per[cut_force::N] * cut.N.value() +
                                                   per[cut_force::M_y] * cut.M_y.value());
      apart = std::max(apart, std::abs(stress - basis.history[k]));
    }
    CHECK(apart < 1e-9 * result.check.acting.value());
    // Extremes are found between instants: no value is beyond them, and the highest is near.
    const auto [low, high] = std::minmax_element(basis.history.begin(), basis.history.end());
    const double range = basis.highest.value - basis.lowest.value;
    CHECK(*high <= basis.highest.value + 1e-9 * range);
    CHECK(*low >= basis.lowest.value - 1e-9 * range);
    CHECK(*high - *low == Approx(range).epsilon(0.01));
  }
  CHECK(stations.size() == 3);
  // No other check keeps one.
  for (std::size_t i = 0; i < of.checks.size(); ++i) {
    const bool is_drawn = std::find(drawn.begin(), drawn.end(), i) != drawn.end();
    if (of.checks[i].basis) CHECK(of.checks[i].basis->history.empty() != is_drawn);
  }
}

TEST_CASE("without fatigue it is the yield strength that governs what is drawn",
          "[drawn-histories]") {
  Project project = test::rig();
  project.fatigue.asked = false;
  const Verification of = verify(project, Figures::without);
  const std::vector<std::size_t> drawn = drawn_over_time(of.checks);
  REQUIRE(!drawn.empty());
  CHECK(&of.checks[drawn.front()] == of.governing(Criterion::yield));
  CHECK(drawn_over_time({}).empty());
}

}  // namespace drawn_histories_test
