// Slender beams in planar mechanisms by `verify`'s model against geometrically nonlinear beams: the
// results of another program, and corotational elements of the tests' own, which know neither modes
// nor postures nor linear theory.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/corotational_mechanism.hpp"
#include "support/gates.hpp"
#include "support/program.hpp"
#include "support/random_scene.hpp"

namespace elastic_scenes_test {

using namespace boxbeam;

namespace {

Project scene(const std::string& name) {
  return read_project(test::project_file("tests/validation/data/elastic-scenes/" + name));
}

/// Largest |N/A +- M/W| over the cycle and the beam [Pa].
double governing_stress(const Project& project, const std::deque<SituationRun>& runs) {
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  return stress_history(runs.front().loads, places).cwiseAbs().maxCoeff();
}

/// Whether the verdict says that the beam's vibration is not known well enough.
bool says_not_proven(const std::vector<Gate>& gates) {
  return std::any_of(gates.begin(), gates.end(), [](const Gate& gate) {
    return gate.blocks && gate.finding.find("vibration is not proven") != std::string::npos;
  });
}

/// What the chosen model states to miss, and what it misses of the corotational beam.
struct Missed {
  ModelChoice choice;
  bool refused = false, buckles = false, not_proven = false, settled = true;
  double stated = 0.0, by_model = 0.0, by_beam = 0.0;
  double missed() const { return by_model / by_beam - 1.0; }
};

Missed missed_by(const Project& project) {
  Missed result;
  std::deque<SituationRun> runs;
  try {
    auto [choice, by_model] = run_by_chosen_model(project);
    result.choice = choice;
    result.by_model = governing_stress(project, by_model);
  } catch (const AnalysisError&) {
    result.refused = true;
    return result;
  }
  result.buckles = result.choice.second_order.in_plane.part >= 1.0;
  if (result.buckles) return result;
  const ModelEstimate& last = result.choice.weighed.back();
  result.stated = last.found.value_or(last.error);
  result.not_proven = says_not_proven(model_gates_of(project, result.choice));
  // Near a resonance a coarse step, which lowers the frequency, is an error of its own.
  test::CorotationalOptions options;
  options.steps = 600;
  const test::CorotationalStress beam = test::corotational_stress(project, options);
  result.settled = beam.settled;
  result.by_beam = beam.governing;
  return result;
}

void print(const std::string& name, const Missed& of) {
  if (of.refused || of.buckles) {
    fmt::print("{:28} {}\n", name, of.refused ? "refused" : "buckles, blocked");
    return;
  }
  fmt::print("{:28} {:13} N/N_cr {:6.3f}  stated {:8.5f}  missed {:+9.5f}  {:9.4f} MPa{}{}\n", name,
             to_text(of.choice.chosen.level), of.choice.second_order.in_plane.part, of.stated,
             of.missed(), of.by_beam * 1e-6, of.not_proven ? ", not proven" : "",
             of.settled ? "" : ", does not settle");
}

}  // namespace

// Three of the four; the other, near its buckling load, see below.
TEST_CASE("slender beams in mechanisms have the stress that geometrically exact beams have",
          "[elastic_scenes]") {
  const std::vector<std::pair<std::string, double>> scenes{
      {"v4.toml", 216.1e6}, {"v11.toml", 120.2e6}, {"v50.toml", 285.4e6}};
  for (const auto& [name, exact] : scenes) {
    const Project project = scene(name);
    const auto [choice, runs] = run_by_chosen_model(project);
    INFO(name << ": " << choice.reason);
    CHECK(governing_stress(project, runs) == Approx(exact).epsilon(project.model.tolerance));
  }
}

// As good as rigid in shear, for these elements are. They give what the other program gives.
TEST_CASE("slender beams in mechanisms have the stress of corotational beams",
          "[elastic_scenes][unsanitized]") {
  const std::vector<std::pair<std::string, double>> scenes{{"v4.toml", 216.1e6},
                                                           {"v50.toml", 285.4e6}};
  for (const auto& [name, exact] : scenes) {
    Project project = scene(name);
    project.model.shear_modulus = 1e15;
    const Missed of = missed_by(project);
    INFO(name << ": " << of.choice.reason);
    CHECK_FALSE(of.refused);
    CHECK(of.by_beam == Approx(exact).epsilon(5e-3));
    CHECK(std::abs(of.missed()) <= project.model.tolerance);
  }
}

// Exudyn has 439.8 MPa. At 0.83 of the buckling load the beam shortens so much by bending that the
// inertia of what it moves changes its axial force: beyond theory of the second order.
TEST_CASE("a beam that vibrates near its buckling load does not pass", "[elastic_scenes]") {
  Project project = scene("v36.toml");
  CHECK(verify(project).verdict != Verdict::pass);  // under the loads times `required` it buckles
  project.strength.required = 1.0;
  const Verification verification = verify(project);
  INFO(verification.model.reason);
  CHECK(verification.model.second_order.in_plane.part > 0.8);
  CHECK(verification.verdict != Verdict::pass);
  const auto says = [&](const std::string& words) { return test::blocks(verification, words); };
  CHECK(says("vibration is not proven"));
  CHECK(says("across it"));
}

// Slider-cranks, four-bars and levers with three joints, by chance.
TEST_CASE("beams in mechanisms by chance have the stress of corotational beams",
          "[elastic_scenes][unsanitized]") {
  unsigned judged = 0;
  for (unsigned seed = 1; judged < 4 && seed < 20; ++seed) {
    const test::RandomScene of = test::random_scene(seed);
    const Missed missed = missed_by(parse_project("scene.toml", of.text));
    if (missed.refused || missed.buckles) continue;
    ++judged;
    INFO(seed << " " << of.kind << ": " << missed.choice.reason);
    CHECK(std::abs(missed.missed()) <= 0.01);
  }
  CHECK(judged == 4);
}

// Hidden, for it takes minutes: run it by name; BOXBEAM_SCENES and BOXBEAM_SEED change the number
// of scenes and where they begin. Not judged are scenes whose verdict says that their vibration is
// not proven. Of the 200 from seed 20261 these are 11, of which 5 miss more than 1 %, and 182 are
// judged; of those from seed 31000, 14, of which 8 do, and 171. All that are judged are within 1 %;
// with those that are not, the stated error covers 193 of 193 and 183 of 185. In the median it is
// 1.4 times the true one.
TEST_CASE("stated and true error of many scenes", "[.elastic_scenes_table]") {
  const auto number = [](const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::atoi(text));
  };
  const unsigned scenes = number("BOXBEAM_SCENES", 200);
  const unsigned seed = number("BOXBEAM_SEED", 20261);
  unsigned judged = 0, covered = 0, within = 0, refused = 0, buckling = 0, unsettled = 0;
  unsigned not_proven = 0, not_proven_covered = 0;
  for (unsigned i = 0; i < scenes; ++i) {
    const test::RandomScene of = test::random_scene(seed + i);
    Missed missed;
    try {
      missed = missed_by(parse_project("scene.toml", of.text));
    } catch (const InputError&) {
      continue;
    } catch (const AnalysisError&) {
      continue;
    } catch (const std::runtime_error& error) {
      fmt::print("{} {}: oracle: {}\n", seed + i, of.kind, error.what());
      continue;
    }
    print(fmt::format("{} {}", seed + i, of.kind), missed);
    refused += missed.refused ? 1 : 0;
    buckling += missed.buckles ? 1 : 0;
    if (missed.refused || missed.buckles) continue;
    if (!missed.settled) {
      ++unsettled;
      continue;
    }
    const bool is_covered = std::abs(missed.missed()) <= std::max(missed.stated, 0.01);
    if (missed.not_proven) {
      ++not_proven;
      not_proven_covered += is_covered ? 1 : 0;
      continue;
    }
    ++judged;
    within += std::abs(missed.missed()) <= 0.01 ? 1 : 0;
    covered += is_covered ? 1 : 0;
  }
  fmt::print(
      "{} judged, {} within 1 %, {} covered; {} whose verdict says that their vibration is not "
      "proven, {} covered; {} refused, {} buckle, {} whose corotational beam does not settle\n",
      judged, within, covered, not_proven, not_proven_covered, refused, buckling, unsettled);
  CHECK(covered >= 0.99 * judged);
  // A verdict that says nothing of most beams would cover all.
  if (scenes >= 100) CHECK(judged >= 0.9 * (judged + not_proven));
}

}  // namespace elastic_scenes_test
