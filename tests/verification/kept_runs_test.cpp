#include "boxbeam/verification/kept_runs.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/project/case_source.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/random_design.hpp"
#include "support/rig.hpp"
#include "support/shipped_cases.hpp"

namespace kept_runs_test {

using namespace boxbeam;

namespace {

/// All case files that come with the program.
std::vector<std::string> all_cases() {
  std::vector<std::string> cases;
  const std::filesystem::path folder = test::project_file("sections");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    try {
      if (read_document(entry.path(), {}).root.find("case") != nullptr)
        cases.push_back(entry.path());
    } catch (const std::exception&) {  // a catalogue
    }
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

std::vector<test::WrittenNumber> those_with(const std::vector<test::WrittenNumber>& numbers,
                                            bool depend) {
  std::vector<test::WrittenNumber> some;
  for (const test::WrittenNumber& of : numbers)
    if (runs_depend_on(of.key) == depend) some.push_back(of);
  return some;
}

/// A walk through designs of a case: from one to the next a key or two get another number, more
/// often such as runs do not depend on. Returns how many were found by runs that are kept.
int compare_on_a_walk(const std::string& path, int steps, unsigned seed) {
  const CaseSource source(path);
  const std::vector<test::WrittenNumber> numbers = test::numbers_in(path);
  const std::vector<test::WrittenNumber> resisting = those_with(numbers, false);
  const std::vector<test::WrittenNumber> moving = those_with(numbers, true);
  std::mt19937 random(seed);
  std::vector<std::string> of_motion, of_resistance;
  auto kept = std::make_unique<KeptRuns>();
  int by_kept = 0;
  bool first = true;
  for (int i = 0; i < steps; ++i) {
    if (resisting.empty() || random() % 4 == 0) {
      // Another motion, of one key or of none.
      of_motion.clear();
      if (random() % 4 != 0)
        of_motion.push_back(test::changed(moving[random() % moving.size()], random));
      kept = std::make_unique<KeptRuns>();
      first = true;
    } else {
      of_resistance.clear();
      for (std::size_t k = 1 + random() % 2; k > 0; --k)
        of_resistance.push_back(test::changed(resisting[random() % resisting.size()], random));
    }
    std::vector<std::string> set = of_motion;
    set.insert(set.end(), of_resistance.begin(), of_resistance.end());
    CAPTURE(set, i);
    const std::string own = test::outcome_of([&] { return verify_beams(source.read_beams(set)); });
    const std::string found =
        test::outcome_of([&] { return kept->verify(source.read_beams(set)); });
    CHECK(found == own);
    if (!test::is_result(found)) {
      kept = std::make_unique<KeptRuns>();
      first = true;
      continue;
    }
    if (!first) ++by_kept;
    first = false;
  }
  return by_kept;
}

}  // namespace

TEST_CASE("designs that differ in what resists alone have every digit of a case of their own") {
  int by_kept = 0;
  for (const std::string& path : all_cases()) {
    CAPTURE(path);
    by_kept += compare_on_a_walk(path, 4, 7);
  }
  CHECK(by_kept > 20);
}

// 300 designs of each case.
TEST_CASE("designs on a long walk have every digit of a case of their own", "[.wide]") {
  for (const std::string& path : all_cases()) {
    CAPTURE(path);
    compare_on_a_walk(path, 300, 11);
  }
}

TEST_CASE("runs depend on all but on what resists") {
  CHECK_FALSE(runs_depend_on("fatigue.cycles=1e7"));
  CHECK_FALSE(runs_depend_on("strength.gamma_M0"));
  for (const char* key :
       {"drivers.exciter.frequency", "beam.segments.0.length", "material.steel",
        "sections.A1.web=50 mm", "fatigue={cycles = 1e7}", "points.0.z", "strength.required=2"})
    CHECK(runs_depend_on(key));
}

// Second order is looked at under the loads times what is asked for (EN 1993-1-1, 5.2.1(3)): what
// it adds to a stress grows with that.
TEST_CASE("what is asked of the strength decides what second order adds") {
  const auto growth = [](double required) {
    Project project = test::rig();
    project.strength.required = required;
    return run_by_chosen_model(project).model.second_order.growth;
  };
  const auto once = growth(1.0), thrice = growth(3.0);
  REQUIRE(once.size() == thrice.size());
  CHECK(std::any_of(once.begin(), once.end(), [&](const StressGrowth& at) {
    return at.stress != thrice[static_cast<std::size_t>(&at - once.data())].stress;
  }));
}

}  // namespace kept_runs_test
