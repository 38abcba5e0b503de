#include "boxbeam/strength/material.hpp"

#include <algorithm>

#include "boxbeam/project/catalogue.hpp"
#include "catch.hpp"

namespace material_test {

using namespace boxbeam;

namespace {

struct Step {
  double up_to;    ///< mm
  double yield;    ///< MPa
  double tensile;  ///< MPa
};

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

/// Checks each step at its upper end and just above the step before, and that nothing follows.
void check_steps(const std::optional<Material>& steel, const std::vector<Step>& steps) {
  REQUIRE(steel);
  double above = 0.0;
  for (const Step& step : steps) {
    CAPTURE(steel->name, steel->source, step.up_to);
    for (const double thickness : {above + 0.001, step.up_to}) {
      CHECK(yield_strength_of(*steel, mm(thickness)) == MPa(step.yield));
      CHECK(tensile_strength_of(*steel, mm(thickness)) == MPa(step.tensile));
    }
    above = step.up_to;
  }
  CHECK_FALSE(yield_strength_of(*steel, mm(above + 0.001)));
  CHECK_FALSE(tensile_strength_of(*steel, mm(above + 0.001)));
}

/// Yield strength in MPa.
double yield(const char* steel, double thickness_mm) {
  return yield_strength_of(*find_steel(steel), mm(thickness_mm)).value().value() * 1e-6;
}

}  // namespace

TEST_CASE("strengths by thickness, EN 10025-2 table 7") {
  const auto product = [](const char* name) { return find_steel(name, "EN 10025-2"); };
  check_steps(product("S235"), {{16, 235, 360},
                                {40, 225, 360},
                                {63, 215, 360},
                                {80, 215, 360},
                                {100, 215, 360},
                                {150, 195, 350}});
  check_steps(product("S275"), {{16, 275, 410},
                                {40, 265, 410},
                                {63, 255, 410},
                                {80, 245, 410},
                                {100, 235, 410},
                                {150, 225, 400}});
  check_steps(product("S355"), {{16, 355, 470},
                                {40, 345, 470},
                                {63, 335, 470},
                                {80, 325, 470},
                                {100, 315, 470},
                                {150, 295, 450},
                                {200, 285, 450},
                                {250, 275, 450},
                                {400, 265, 450}});
  check_steps(product("S450"),
              {{16, 450, 550}, {40, 430, 550}, {63, 410, 550}, {80, 390, 550}, {100, 380, 550}});
}

TEST_CASE("strengths by thickness, EN 1993-1-1:2005 table 3.1") {
  const auto design = [](const char* name) { return find_steel(name, "EN 1993-1-1"); };
  check_steps(design("S235"), {{40, 235, 360}, {80, 215, 360}});
  check_steps(design("S275"), {{40, 275, 430}, {80, 255, 410}});
  check_steps(design("S355"), {{40, 355, 490}, {80, 335, 470}});
  check_steps(design("S450"), {{40, 440, 550}, {80, 410, 550}});
}

TEST_CASE("fine-grained steels, EN 10025-3, -4 and -6") {
  check_steps(find_steel("S355N", "EN 10025-3"), {{16, 355, 470},
                                                  {40, 345, 470},
                                                  {63, 335, 470},
                                                  {80, 325, 470},
                                                  {100, 315, 470},
                                                  {150, 295, 450}});
  check_steps(find_steel("S460NL", "EN 10025-3"), {{16, 460, 540},
                                                   {40, 440, 540},
                                                   {63, 430, 540},
                                                   {80, 410, 540},
                                                   {100, 400, 540},
                                                   {150, 380, 530}});
  check_steps(find_steel("S420M", "EN 10025-4"), {{16, 420, 520},
                                                  {40, 400, 520},
                                                  {63, 390, 500},
                                                  {80, 380, 480},
                                                  {100, 370, 470},
                                                  {120, 365, 460}});
  check_steps(find_steel("S460ML", "EN 10025-4"), {{16, 460, 540},
                                                   {40, 440, 540},
                                                   {63, 430, 530},
                                                   {80, 410, 510},
                                                   {100, 400, 500},
                                                   {120, 385, 490}});
  check_steps(find_steel("S690QL1", "EN 10025-6"),
              {{50, 690, 770}, {100, 650, 760}, {150, 630, 710}});
  check_steps(find_steel("S890Q"), {{50, 890, 940}, {100, 830, 880}});
  check_steps(find_steel("S960QL"), {{50, 960, 980}});
}

TEST_CASE(
    "fine-grained steels in the design code, EN 1993-1-1 table 3.1 and EN 1993-1-12 table 1") {
  check_steps(find_steel("S460N", "EN 1993-1-1"), {{40, 460, 540}, {80, 430, 540}});
  check_steps(find_steel("S460M", "EN 1993-1-1"), {{40, 460, 540}, {80, 430, 530}});
  check_steps(find_steel("S420M", "EN 1993-1-1"), {{40, 420, 520}, {80, 390, 500}});
  check_steps(find_steel("S460Q", "EN 1993-1-1"), {{40, 460, 570}, {80, 440, 550}});
  check_steps(find_steel("S690Q", "EN 1993-1-12"), {{50, 690, 770}, {100, 650, 760}});
  CHECK_FALSE(find_steel("S690Q", "EN 1993-1-1"));
  CHECK_FALSE(find_steel("S355", "EN 10025-6"));
}

TEST_CASE("another name of a steel is its own name and has its strengths") {
  const Material steel = *find_steel("S690QL");
  CHECK(steel.name == "S690QL");
  CHECK(yield("S690QL", 50) == Approx(690).epsilon(1e-12));
  CHECK(sources_of_steel("S690QL") == std::vector<std::string>{"EN 10025-6", "EN 1993-1-12"});
}

TEST_CASE("without a source: the lowest strength of all, the thickest by one alone") {
  for (const std::string& name : steel_names()) {
    const Material lower = *find_steel(name);
    std::vector<Material> all;
    double thickest = 0.0;
    for (const std::string& source : sources_of_steel(name)) {
      all.push_back(*find_steel(name, source));
      thickest = std::max(thickest, all.back().steps.back().up_to.value() * 1e3);
    }
    for (double t = 0.25; t <= thickest; t += 0.25) {
      CAPTURE(name, t);
      const auto expected = [&](auto strength_of) {
        std::optional<Stress> lowest;
        for (const Material& material : all) {
          const auto of = strength_of(material, mm(t));
          if (of && (!lowest || *of < *lowest)) lowest = of;
        }
        return lowest;
      };
      CHECK(yield_strength_of(lower, mm(t)) == expected(yield_strength_of));
      CHECK(tensile_strength_of(lower, mm(t)) == expected(tensile_strength_of));
    }
    CHECK_FALSE(yield_strength_of(lower, mm(thickest + 0.001)));
  }
}

TEST_CASE("EN 1993-1-1 is the lower one for thin S450 only") {
  CHECK(yield("S450", 16) == Approx(440).epsilon(1e-12));
  CHECK(yield("S450", 40) == Approx(430).epsilon(1e-12));
  CHECK(yield("S355", 40) == Approx(345).epsilon(1e-12));
  CHECK(yield("S355", 80) == Approx(325).epsilon(1e-12));
}

TEST_CASE("the lower of two sources of one step each, whichever comes first") {
  const Material one{"steel", "one", 0.8, {{mm(40), MPa(300), MPa(400)}}};
  const Material other{"steel", "other", 0.9, {{mm(20), MPa(310), MPa(390)}}};
  for (const Material& lower : {lower_of(one, other), lower_of(other, one)}) {
    check_steps(lower, {{20, 300, 390}, {40, 300, 400}});
    CHECK(lower.beta_w == 0.9);
  }
  CHECK(lower_of(one, other).source == "the lower of one, and other");
  check_steps(lower_of(one, one), {{40, 300, 400}});
}

TEST_CASE("correlation factors of fillet welds, EN 1993-1-8 table 4.1") {
  CHECK(find_steel("S235")->beta_w == 0.8);
  CHECK(find_steel("S275")->beta_w == 0.85);
  CHECK(find_steel("S355")->beta_w == 0.9);
  // Not in the table: its largest.
  CHECK(find_steel("S450")->beta_w == 1.0);
  CHECK(find_steel("S355", "EN 1993-1-1")->beta_w == 0.9);
  CHECK(find_steel("S275M")->beta_w == 0.85);
  CHECK(find_steel("S355NL")->beta_w == 0.9);
  CHECK(find_steel("S420N")->beta_w == 1.0);
  CHECK(find_steel("S460M")->beta_w == 1.0);
}

TEST_CASE("a plate of 50 mm of S355 yields at 335 MPa, as the sledge-rig thesis takes it") {
  CHECK(yield("S355", 50) == Approx(335).epsilon(1e-12));
}

TEST_CASE("a thickness a bit of round-off above a step still belongs to it") {
  const Material steel = *find_steel("S355");
  const Length sum = si<Length>(0.1 + 0.2 - 0.26);  // 40 mm and round-off
  CHECK(sum > si<Length>(0.04));
  CHECK(yield_strength_of(steel, sum) == MPa(345));
  CHECK(tensile_strength_of(steel, sum) == MPa(470));
}

TEST_CASE("no plate is stronger than a thinner one of the same steel, and none yields late") {
  for (const std::string& name : steel_names()) {
    std::vector<Material> all{*find_steel(name)};
    for (const std::string& source : sources_of_steel(name))
      all.push_back(*find_steel(name, source));
    for (const Material& steel : all) {
      CAPTURE(name, steel.source);
      REQUIRE_FALSE(steel.steps.empty());
      for (std::size_t i = 0; i < steel.steps.size(); ++i) {
        CHECK(steel.steps[i].yield_strength < steel.steps[i].tensile_strength);
        if (i == 0) continue;
        CHECK(steel.steps[i].up_to > steel.steps[i - 1].up_to);
        CHECK(steel.steps[i].yield_strength <= steel.steps[i - 1].yield_strength);
        CHECK(steel.steps[i].tensile_strength <= steel.steps[i - 1].tensile_strength);
      }
    }
  }
}

TEST_CASE("a steel of another name is not found") {
  CHECK_FALSE(find_steel("S356"));
  CHECK_FALSE(find_steel(""));
  CHECK_FALSE(find_steel("S356", "EN 1993-1-1"));
  const auto names = steel_names();
  CHECK(std::find(names.begin(), names.end(), "S355") != names.end());
}

}  // namespace material_test
