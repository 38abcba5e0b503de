// Slender beams in planar mechanisms by `verify`'s model against geometrically nonlinear beams: the
// results of another program, and corotational elements of the tests' own, which know neither modes
// nor postures nor linear theory.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/corotational_mechanism.hpp"
#include "support/program.hpp"
#include "support/random_scene.hpp"

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

/// What the chosen model states to miss, and what it misses of the corotational beam.
struct Missed {
  ModelChoice choice;
  bool refused = false, buckles = false;
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
  const test::CorotationalStress beam = test::corotational_stress(project);
  result.by_beam = beam.governing;
  return result;
}

void print(const std::string& name, const Missed& of) {
  if (of.refused || of.buckles) {
    fmt::print("{:28} {}\n", name, of.refused ? "refused" : "buckles, blocked");
    return;
  }
  fmt::print("{:28} {:13} N/N_cr {:6.3f}  stated {:8.5f}  missed {:+9.5f}  {:9.4f} MPa\n", name,
             to_text(of.choice.chosen.level), of.choice.second_order.in_plane.part, of.stated,
             of.missed(), of.by_beam * 1e-6);
}

}  // namespace

TEST_CASE("slender beams in mechanisms have the stress that geometrically exact beams have",
          "[elastic_scenes]") {
  const std::vector<std::pair<std::string, double>> scenes{
      {"v4.toml", 216.1e6}, {"v11.toml", 120.2e6}, {"v36.toml", 439.8e6}, {"v50.toml", 285.4e6}};
  for (const auto& [name, exact] : scenes) {
    const Project project = scene(name);
    const auto [choice, runs] = run_by_chosen_model(project);
    INFO(name << ": " << choice.reason);
    CHECK(governing_stress(project, runs) == Approx(exact).epsilon(project.model.tolerance));
  }
}

// The same cases as good as rigid in shear, for these elements are.
TEST_CASE("the four scenes by corotational elements", "[elastic_scenes]") {
  for (const std::string name : {"v4.toml", "v11.toml", "v36.toml", "v50.toml"}) {
    Project project = scene(name);
    project.model.shear_modulus = 1e15;
    const Missed of = missed_by(project);
    print(name, of);
    INFO(name << ": " << of.choice.reason);
    CHECK_FALSE(of.refused);
    CHECK(std::abs(of.missed()) <= project.model.tolerance);
  }
}

// Hidden, for it takes minutes: run it by name; BOXBEAM_SCENES and BOXBEAM_SEED change the number
// of scenes and where they begin.
TEST_CASE("stated and true error of many scenes", "[.elastic_scenes_table]") {
  const auto number = [](const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::atoi(text));
  };
  const unsigned scenes = number("BOXBEAM_SCENES", 200);
  const unsigned seed = number("BOXBEAM_SEED", 20261);
  unsigned judged = 0, covered = 0, within = 0, refused = 0, buckling = 0;
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
    ++judged;
    within += std::abs(missed.missed()) <= 0.01 ? 1 : 0;
    covered += std::abs(missed.missed()) <= std::max(missed.stated, 0.01) ? 1 : 0;
  }
  fmt::print("{} judged, {} within 1 %, {} covered, {} refused, {} buckle\n", judged, within,
             covered, refused, buckling);
  CHECK(covered >= 0.99 * judged);
}
