// The climb to more modes where it is the parts of elastic links that miss, by figures given here.

#include "src/verification/model_choices.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace mode_climb_test {

using namespace boxbeam;

namespace {

/// What a model misses: a part for each mode left out, and that of its parts, which falls by four
/// where they are twice as many.
struct Missing {
  std::vector<double> by_modes;  ///< of 0, 1, 2, ... modes
  double by_eight_parts = 0.0;

  double of_parts(int parts) const { return by_eight_parts * 64.0 / (parts * parts); }
  double of(const ElasticModel& model) const {
    return by_modes[static_cast<std::size_t>(model.modes)] + of_parts(model.parts);
  }
};

struct Climbed {
  ModelChoice choice;
  std::string why;
  int asked_of_parts = 0;
};

/// `estimated`: what is estimated of so many modes, which knows nothing of parts.
Climbed climbed(const Missing& missing, const std::vector<double>& estimated,
                bool parts_known = true) {
  VibrationEstimate estimate;
  estimate.without_modes = estimated;
  estimate.frequencies = {1.0, 6.0, 17.0};
  Climbed of;
  of.choice.tolerance = 0.02;
  ElasticModel last;
  Climb climb{"", "", [&](const ElasticModel& model) {
                last = model;
                ElasticModel better = model;
                ++better.modes;
                better.parts *= 2;
                return missing.of(model) - missing.of(better);
              }};
  if (parts_known)
    climb.missed_by_parts = [&] {
      ++of.asked_of_parts;
      return missing.of_parts(last.parts) - missing.of_parts(2 * last.parts);
    };
  of.why = climb_modes(estimate, climb, of.choice);
  return of;
}

}  // namespace

TEST_CASE("what parts miss is mended by more parts, not by more modes", "[model_choice]") {
  // Of eight, sixteen and 32 parts 12, 3 and 0.75 % are missed.
  const Missing missing{{1.0, 0.05, 0.004, 0.0, 0.0}, 0.12};
  const Climbed of = climbed(missing, {1.0, 0.05, 0.004, 0.0});
  CHECK(of.why.empty());
  CHECK(of.choice.chosen.level == ModelLevel::modal);
  CHECK(of.choice.chosen.modes == 2);
  CHECK(of.choice.chosen.parts == 32);
  CHECK(missing.of(of.choice.chosen) < 0.02);
  CHECK(of.asked_of_parts == 2);
  // Each model that was weighed, and what it was found to miss.
  REQUIRE(of.choice.weighed.size() == 4);
  CHECK(of.choice.weighed[0].model.modes == 1);
  CHECK_FALSE(of.choice.weighed[0].found);
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(of.choice.weighed[i].model.modes == 2);
    CHECK(of.choice.weighed[i].model.parts == 4 << i);
    REQUIRE(of.choice.weighed[i].found);
    CHECK((*of.choice.weighed[i].found <= 0.02) == (i == 3));
  }
}

TEST_CASE("what modes miss is mended by more modes of as many parts", "[model_choice]") {
  const Missing missing{{1.0, 0.05, 0.004, 0.0, 0.0}, 0.002};
  // The estimate took one mode to be enough.
  const Climbed of = climbed(missing, {1.0, 0.01, 0.004, 0.0});
  CHECK(of.why.empty());
  CHECK(of.choice.chosen.modes == 2);
  CHECK(of.choice.chosen.parts == 8);
  CHECK(of.asked_of_parts == 1);
}

TEST_CASE("where neither modes nor parts are enough, it is said which", "[model_choice]") {
  const Climbed modes = climbed({{3.0, 2.0, 1.0, 0.5, 0.0}, 0.0}, {3.0, 0.01, 0.01, 0.01});
  CHECK(modes.choice.chosen.level == ModelLevel::rigid);
  CHECK_THAT(modes.why, Catch::Contains("3 modes of the beam are not known to be within 2 %"));
  // Of 64 parts, the most, 4 % are missed, and 1 % of twice as many.
  const Climbed parts = climbed({{1.0, 0.0, 0.0, 0.0}, 64.0 * 0.04}, {1.0, 0.0, 0.0});
  CHECK(parts.choice.chosen.level == ModelLevel::rigid);
  CHECK_THAT(parts.why, Catch::Contains("64 parts of each elastic link and twice as many") &&
                            Catch::Contains("differ by 3 %"));
  // Links that keep their parts: as many modes as there are are asked, each once.
  const Climbed kept =
      climbed({{1.0, 0.05, 0.004, 0.0, 0.0}, 0.12}, {1.0, 0.05, 0.004, 0.0}, false);
  CHECK(kept.choice.chosen.level == ModelLevel::rigid);
  CHECK(kept.choice.weighed.size() == 3);
}

// The axial force of a soft beam bends it more from part to part than eight parts have it, and the
// phase of what vibrates on behind the end runs off with its frequency.
TEST_CASE("a soft rocker that is moved once is divided as finely as it asks for",
          "[model_choice]") {
  Project project = read_project(test::project_file("sections/four-bar-rocker/rocker.toml"));
  constexpr double tolerance = 0.02;
  project.model.tolerance = tolerance;
  planar::Mechanism& mechanism = planar_of(project);
  for (planar::Joint& joint : mechanism.joints)
    if (planar::is_driver(joint))
      std::get<planar::Driven>(joint.kind).driver = StepDriver{0.0, 0.6, 0.0, 0.6};
  mechanism.duration = {};
  project.model.youngs_modulus = 1e9;
  project.model.shear_modulus = 0.4e9;
  const ModelledRuns chosen = run_by_chosen_model(project);
  const ElasticModel& model = chosen.model.chosen;
  INFO(chosen.model.reason);
  REQUIRE(model.level == ModelLevel::modal);
  CHECK(model.parts > 8);
  CHECK(chosen.model.weighed.back().found.value_or(1.0) <= tolerance);
  const std::deque<SituationRun> fine =
      run_situations(project, {ModelLevel::modal, model.modes + 2, 64, {}, false});
  const std::deque<SituationRun> coarse =
      run_situations(project, {ModelLevel::modal, model.modes, 8, {}, false});
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  const LoadHistory& of_fine = fine.front().loads;
  double largest = 0.0, apart = 0.0, by_eight = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const Time time = of_fine.begin() + of_fine.period() * (i / 200.0);
    const auto stresses = [&](const SituationRun& run) {
      return fibre_stresses(run.loads.diagram_at(time), places);
    };
    const Eigen::ArrayXd expected = stresses(fine.front());
    largest = std::max(largest, expected.abs().maxCoeff());
    apart = std::max(apart, (stresses(chosen.runs.front()) - expected).abs().maxCoeff());
    by_eight = std::max(by_eight, (stresses(coarse.front()) - expected).abs().maxCoeff());
  }
  INFO("apart " << apart / largest << ", of eight parts " << by_eight / largest);
  CHECK(apart < tolerance * largest);
  CHECK(by_eight > tolerance * largest);
}

}  // namespace mode_climb_test
