// Several situations of use on the sledge rig: what must hold whatever the numbers are.

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "boxbeam/verification/worst_place.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace situations_test {

using namespace boxbeam;

namespace {

/// The rig's motion at so many times its frequency.
Situation at_speed(const std::string& name, double cycles, double speed = 1.0) {
  Situation situation;
  situation.name = name;
  situation.cycles = cycles;
  situation.changed = planar_of(test::rig());
  test::exciter_of(std::get<planar::Mechanism>(*situation.changed)).omega *= speed;
  return situation;
}

Situation change(const std::string& name, double cycles, std::vector<std::size_t> between) {
  Situation situation;
  situation.name = name;
  situation.cycles = cycles;
  situation.between = std::move(between);
  return situation;
}

/// The rig's motion with a force of 40 kN on the beam's end C in it.
Situation pushed_at_C() {
  Situation pushed = at_speed("pushed", 1e5);
  const double to_end = -mass_properties_of(test::rig().beam).centre.value();
  std::get<planar::Mechanism>(*pushed.changed)
      .forces.push_back(
          {"push",
           planar::PointForce{
               {test::rig().beam_body, {to_end, 0.0}}, 0.0, false, PolynomialDriver{{40e3}}}});
  return pushed;
}

/// The rig with these situations; category 36 everywhere, so that its ranges do damage.
Verification verified(std::vector<Situation> situations) {
  Project project = test::rig();
  project.situations = std::move(situations);
  project.fatigue.beam.detail.curve = en_1993_1_9_direct(36);
  for (BeamDetail& detail : project.fatigue.details) detail.detail.curve = en_1993_1_9_direct(36);
  return verify(project);
}

const CheckResult* find(const Verification& verification, const std::string& id) {
  for (const CheckResult& result : verification.checks) {
    if (result.check.id == id) return &result;
  }
  return nullptr;
}

/// Tells each check of a criterion that several verifications have in common; there are many.
template <class Look>
void for_each_common(Criterion criterion, const std::vector<const Verification*>& all, Look look) {
  int common = 0;
  for (const CheckResult& result : all.front()->checks) {
    if (result.check.criterion != criterion) continue;
    std::vector<const CheckResult*> found;
    for (const Verification* verification : all) {
      found.push_back(find(*verification, result.check.id));
    }
    if (std::count(found.begin(), found.end(), nullptr) > 0) continue;
    INFO(result.check.id);
    look(found);
    ++common;
  }
  CHECK(common > 20);
}

const Verification& running() {
  static const Verification verification = verified({at_speed("run", 1e8)});
  return verification;
}

}  // namespace

TEST_CASE(
    "a load factor of 1.1 divides the factors of strength by 1.1 and leaves fatigue as it is") {
  Situation heavy = at_speed("run", 1e8);
  heavy.load_factor = 1.1;
  const Verification factored = verified({heavy});
  REQUIRE(factored.checks.size() == running().checks.size());
  for (const CheckResult& result : running().checks) {
    INFO(result.check.id);
    const CheckResult* other = find(factored, result.check.id);
    REQUIRE(other != nullptr);
    const bool strength =
        result.check.criterion == Criterion::yield || result.check.criterion == Criterion::weld;
    CHECK(other->check.safety_factor ==
          Approx(result.check.safety_factor / (strength ? 1.1 : 1.0)).epsilon(1e-12));
  }
}

TEST_CASE("two situations of the same motion are one with the cycles of both") {
  const Verification both = verified({at_speed("day", 4e7), at_speed("night", 6e7)});
  REQUIRE(both.checks.size() == running().checks.size());
  for (const CheckResult& result : both.checks) {
    INFO(result.check.id);
    const CheckResult* one = find(running(), result.check.id);
    REQUIRE(one != nullptr);
    CHECK(result.check.safety_factor == Approx(one->check.safety_factor).epsilon(1e-9));
    if (result.check.criterion == Criterion::fatigue) {
      CHECK(result.basis->damage == Approx(one->basis->damage).epsilon(1e-9));
    }
  }
}

TEST_CASE("the strength is that of the worst situation") {
  Situation slow = at_speed("slow", 1e8, 0.5);
  Situation storm = at_speed("storm", 0.0, 1.2);
  storm.load_factor = 1.1;
  const Verification slow_alone = verified({slow});
  Situation lasting = storm;
  lasting.cycles = 1.0;  // a case wants one that happens
  const Verification storm_alone = verified({lasting});
  const Verification all = verified({slow, storm});
  for_each_common(Criterion::yield, {&all, &slow_alone, &storm_alone},
                  [](const std::vector<const CheckResult*>& checks) {
                    const double a = checks[1]->check.safety_factor;
                    const double b = checks[2]->check.safety_factor;
                    CHECK(checks[0]->check.safety_factor == Approx(std::min(a, b)).epsilon(1e-9));
                    CHECK(checks[0]->check.situation == (a < b ? "slow" : "storm"));
                  });
  // Without cycles it does no damage.
  for_each_common(Criterion::fatigue, {&all, &slow_alone},
                  [](const std::vector<const CheckResult*>& checks) {
                    CHECK(checks[0]->check.safety_factor ==
                          Approx(checks[1]->check.safety_factor).epsilon(1e-9));
                    CHECK(checks[0]->check.situation == "slow");
                  });
}

TEST_CASE("a change between standstill and running ranges over both") {
  // Nearly standing still: a thousandth of the frequency. There the stress is not that of running
  // turned smaller: the weight acts alone.
  const Situation still = at_speed("still", 0.0, 1e-3);
  const Situation run = at_speed("run", 0.0);
  Situation still_lasting = still;
  Situation run_lasting = run;
  still_lasting.cycles = run_lasting.cycles = 1e5;
  const Verification still_alone = verified({still_lasting});
  const Verification run_alone = verified({run_lasting});
  const Verification changing = verified({still, run, change("start and stop", 1e5, {0, 1})});
  for_each_common(Criterion::fatigue, {&changing, &still_alone, &run_alone},
                  [](const std::vector<const CheckResult*>& checks) {
                    const CheckBasis& a = *checks[1]->basis;
                    const CheckBasis& b = *checks[2]->basis;
                    // A hole has its worst place on the edge in each situation.
                    if (a.point.concentration) return;
                    const double high = std::max(a.highest.value, b.highest.value);
                    const double low = std::min(a.lowest.value, b.lowest.value);
                    const Check& check = checks[0]->check;
                    CHECK(check.acting.value() == Approx(high - low).epsilon(1e-7));
                    CHECK(check.situation == "start and stop");
                    // One cycle 1e5 times, by hand: category 36 bears 36 (2e6/1e5)^(1/3) MPa.
                    CHECK(check.safety_factor ==
                          Approx(36e6 * std::cbrt(20.0) / check.acting.value()).epsilon(1e-9));
                  });
}

TEST_CASE("a change between two situations may have a larger range than each of them") {
  const Situation run = at_speed("run", 1e5);
  const Situation pushed = pushed_at_C();
  Situation run_only = run, pushed_only = pushed;
  run_only.cycles = pushed_only.cycles = 0.0;
  const Verification run_alone = verified({run});
  const Verification pushed_alone = verified({pushed});
  const Verification changing = verified({run_only, pushed_only, change("start", 1e5, {1, 0})});
  double most = 0.0;
  for_each_common(Criterion::fatigue, {&changing, &run_alone, &pushed_alone},
                  [&](const std::vector<const CheckResult*>& checks) {
                    const CheckBasis& a = *checks[1]->basis;
                    const CheckBasis& b = *checks[2]->basis;
                    // A hole has its worst place on the edge in each situation.
                    if (a.point.concentration) return;
                    const double high = std::max(a.highest.value, b.highest.value);
                    const double low = std::min(a.lowest.value, b.lowest.value);
                    const double range = checks[0]->check.acting.value();
                    const double larger =
                        std::max(checks[1]->check.acting.value(), checks[2]->check.acting.value());
                    CHECK(range >= larger * (1.0 - 1e-9));
                    // On a hole's edge each verification finds a worst place of its own.
                    if (!checks[0]->basis->point.concentration) {
                      CHECK(range == Approx(high - low).epsilon(1e-7));
                    }
                    most = std::max(most, range / larger);
                  });
  CHECK(most > 1.01);
}

TEST_CASE("on a hole's edge the place with the largest range of the change is found") {
  // The two motions do no cycles of their own: their own ranges must not decide.
  Project project = test::rig();
  Situation pushed = pushed_at_C();
  pushed.cycles = 0.0;
  project.situations = {at_speed("run", 0.0), pushed, change("start", 1e5, {0, 1})};
  const std::deque<SituationRun> runs = run_situations(project);
  int edges = 0;
  for (const Side side : {Side::before, Side::behind}) {
    const Station hub{si<Length>(3.2), side};
    const std::vector<SituationHistory> histories = histories_at(runs, hub);
    const auto range_at = [&](const StressInfluence& influence) {
      double high = -1e300, low = 1e300;
      for (const SituationHistory& at : histories) {
        for (const CutForces& cut : at.history.samples()) {
          const double stress = stress_at(influence, cut).normal.value();
          high = std::max(high, stress);
          low = std::min(low, stress);
        }
      }
      return high - low;
    };
    for (const StressPoint& point :
         stress_points_at(project, bending_zones_of(project, runs), hub)) {
      if (point.edges.empty()) continue;
      double largest = 0.0;
      for (const HoleEdge& edge : point.edges) {
        largest = std::max(largest, range_at(edge.influence));
      }
      const Criterion by = Criterion::fatigue;
      const StressPoint worst =
          at_worst_edges(StationSamples(project, histories), point, {&by, 1}).front();
      // Between two places of the list, 3 degrees apart, a peak has at most 0.4 % more.
      CHECK(range_at(worst.influence) >= largest * (1.0 - 1e-9));
      CHECK(range_at(worst.influence) <= largest * 1.004);
      ++edges;
    }
  }
  CHECK(edges == 6);  // the hub's hole and two bolts, on both sides of the force
}

TEST_CASE("the edge of a hole has the same worst places whether criteria are asked for together") {
  const Project project = test::rig();
  const std::deque<SituationRun> runs = run_situations(project);
  const Station hub{si<Length>(3.2), Side::before};
  const std::vector<SituationHistory> histories = histories_at(runs, hub);
  const StationSamples samples(project, histories);
  int edges = 0;
  for (const StressPoint& point : stress_points_at(project, bending_zones_of(project, runs), hub)) {
    if (point.edges.empty()) continue;
    const std::vector<StressPoint> together = at_worst_edges(samples, point, stress_criteria);
    REQUIRE(together.size() == stress_criteria.size());
    for (std::size_t k = 0; k < stress_criteria.size(); ++k) {
      const StressPoint alone = at_worst_edges(samples, point, {&stress_criteria[k], 1}).front();
      CHECK(together[k].influence.normal == alone.influence.normal);
      CHECK(together[k].concentration->edge.angle == alone.concentration->edge.angle);
      CHECK(together[k].edges.empty());
      // Places of the list itself are no worse.
      for (const HoleEdge& edge : point.edges) {
        const Criterion by = stress_criteria[k];
        const double there = samples.judge(point, edge.influence, {by}).of(by);
        CHECK(samples.judge(together[k], {by}).of(by) >= there * (1.0 - 1e-6));
      }
    }
    ++edges;
  }
  CHECK(edges == 3);
}

TEST_CASE("sections that do not change have one stress field wherever they are") {
  const Project project = test::rig();
  StressFields fields;
  const Section plain = section_at(project.beam, {si<Length>(0.7)});
  const auto field = fields.of(plain, {}, {});
  CHECK(fields.of(section_at(project.beam, {si<Length>(1.2)}), {}, {}) == field);
  CHECK(fields.of(section_at(project.beam, {si<Length>(4.9)}), {}, {}) != field);
  CHECK(fields.of(plain, holes_at(project, si<Length>(3.2)), {}) != field);
  const Station tapers{si<Length>(2.0)};
  CHECK(fields.of(plain, {}, taper_at(project.beam, tapers)) != field);
}

TEST_CASE("the order of the situations does not matter") {
  const Situation slow = at_speed("slow", 1e7, 0.8);
  const Situation fast = at_speed("fast", 1e5, 1.1);
  const Verification there = verified({slow, fast, change("start", 1e4, {0, 1})});
  const Verification back = verified({fast, slow, change("start", 1e4, {1, 0})});
  REQUIRE(there.checks.size() == back.checks.size());
  for_each_common(Criterion::fatigue, {&there, &back},
                  [](const std::vector<const CheckResult*>& checks) {
                    CHECK(checks[0]->check.safety_factor ==
                          Approx(checks[1]->check.safety_factor).epsilon(1e-9));
                    CHECK(checks[0]->check.situation == checks[1]->check.situation);
                  });
  for_each_common(Criterion::yield, {&there, &back},
                  [](const std::vector<const CheckResult*>& checks) {
                    CHECK(checks[0]->check.safety_factor ==
                          Approx(checks[1]->check.safety_factor).epsilon(1e-9));
                  });
}

TEST_CASE("the damage of several situations is the sum of the damages of each") {
  const Situation slow = at_speed("slow", 5e7, 0.9);
  const Situation fast = at_speed("fast", 2e6, 1.2);
  const Verification slow_alone = verified({slow});
  const Verification fast_alone = verified({fast});
  const Verification both = verified({slow, fast});
  double most = 0.0;
  for (const Criterion criterion : {Criterion::fatigue, Criterion::shear_fatigue}) {
    for_each_common(criterion, {&both, &slow_alone, &fast_alone},
                    [&](const std::vector<const CheckResult*>& checks) {
                      // Each run takes the place on a hole's edge that is worst for itself.
                      if (checks[0]->basis->point.concentration) return;
                      const double sum = checks[1]->basis->damage + checks[2]->basis->damage;
                      CHECK(checks[0]->basis->damage == Approx(sum).epsilon(1e-9));
                      most = std::max(most, sum);
                    });
  }
  CHECK(most > 0.1);
}

TEST_CASE("the governing situation is named: strength in the storm, fatigue in normal use") {
  const Verification verification =
      verified({at_speed("normal", 1e8), at_speed("storm", 1.0, 1.3)});
  CHECK(verification.governing(Criterion::yield)->check.situation == "storm");
  CHECK(verification.governing(Criterion::fatigue)->check.situation == "normal");
  CHECK(verification.governing(Criterion::stress_range)->check.situation == "storm");
  // Forces grow with the square of the speed, beside the weight: the critical bending is in the
  // storm too.
  for (const CriticalInstant& instant : verification.critical_instants) {
    if (instant.quantity() == "M") CHECK(instant.situation == 1);
  }
  REQUIRE(verification.motions.size() == 2);
  CHECK(verification.motions[1].period.value() == Approx(1.0 / 0.7 / 1.3).epsilon(1e-12));
}

}  // namespace situations_test
