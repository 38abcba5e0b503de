// The cheapest model that is good enough: against a fine reference over beams by chance, and on the
// shipped cases.

#include "boxbeam/verification/model_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"
#include "support/rig.hpp"

namespace model_choice_test {

using namespace boxbeam;
using test::Chance;
using test::infinite;

namespace {

constexpr double E = 2.1e11;
constexpr double G = 8.1e10;

Section box(double height, double width, double plate) {
  Box of;
  of.width = si<Length>(width);
  of.height = si<Length>(height);
  of.top_flange = of.bottom_flange = si<Length>(plate);
  of.left_web = of.right_web = si<Length>(plate);
  return {of, {}};
}

/// A box beam that vibrates: the mechanism looks at nothing of it, the case at both.
struct VibratingBeam {
  TaperedBeam beam;
  flexible::Mechanism mechanism;

  LadderCase ladder() const { return {&mechanism, 0, &beam}; }
};

/// A uniform or tapered box of slenderness length/height 5 to 100, as a cantilever, pinned, clamped
/// and pinned, or on elastic joints; with or without attached masses; a load and a weight.
VibratingBeam beam_by_chance(Chance& chance) {
  VibratingBeam of;
  const double height = 0.35 + chance.any(0.25);
  const double length = height * test::power_of_ten(chance, std::log10(5.0), 2.0);
  const double width = height * (0.8 + chance.any(0.3));
  const double plate = height * (0.05 + chance.any(0.02));
  const Section start = box(height, width, plate);
  const double taper = chance.one_of(2) == 0 ? 1.0 : 0.75 + chance.any(0.25);
  const Section end = box(taper * height, width, plate);
  of.beam.segments = {{"", Length{}, si<Length>(length), start, end}};
  of.beam.density = si<Density>(7850.0);

  flexible::Link link;
  link.name = "beam";
  link.kind = flexible::LinkKind::bending;
  link.length = length;
  link.angle = chance.any(1.5);
  link.stretches = link_stretches_of(of.beam, E, G);
  link.parts = 1;
  flexible::Mechanism& mechanism = of.mechanism;
  mechanism.links = {link};
  mechanism.gravity = {0.0, -9.81};
  const auto hold = [&](double s, double along, double across, double turn) {
    mechanism.joints.push_back(test::hold(mechanism, s, {along, across, turn},
                                          fmt::format("held {}", mechanism.joints.size())));
  };
  const double stiffness = 3.0 * link.stretches[0].EI(0.0) / std::pow(length, 3);
  switch (chance.one_of(4)) {
    case 0: hold(0.0, infinite, infinite, infinite); break;
    case 1:
      hold(0.0, infinite, infinite, 0.0);
      hold(length, 0.0, infinite, 0.0);
      break;
    case 2:
      hold(0.0, infinite, infinite, infinite);
      hold(length, 0.0, infinite, 0.0);
      break;
    default: {
      const double soft = stiffness * test::power_of_ten(chance, 0.0, 3.0);
      hold(0.1 * length, 10.0 * soft, soft, 0.0);
      hold(0.9 * length, 0.0, soft, 0.0);
    }
  }
  const double mass = flexible::rigid_mass_of(link).mass;
  for (int i = chance.one_of(3); i > 0; --i) {
    flexible::Link attached;
    attached.name = fmt::format("mass {}", i);
    attached.kind = flexible::LinkKind::rigid;
    const double m = mass * test::power_of_ten(chance, -2.0, 0.0);
    const double radius = 0.5 * height;
    attached.rigid = {m, {0.0, 0.0}, m * radius * radius};
    const flexible::Attachment at{0, {length * (0.5 + chance.any(0.5)), 0.0}};
    attached.origin = flexible::in_world(mechanism, at);
    mechanism.links.push_back(attached);
    flexible::Joint joint;
    joint.name = attached.name;
    joint.a = at;
    joint.b = {static_cast<int>(mechanism.links.size()) - 1, {0.0, 0.0}};
    joint.stiffness = {infinite, infinite, infinite};
    mechanism.joints.push_back(joint);
  }
  const double force = 1e3;
  flexible::Load load;
  load.name = "load";
  load.at = {0, {length * (0.6 + chance.any(0.4)), 0.0}};
  load.constant = {chance.any(force), chance.any(force), 0.0};
  load.amplitude = {chance.any(force), force, chance.any(0.1 * force * length)};
  mechanism.loads = {load};
  return of;
}

/// Frequency between 0.02 and 3 times the first, more than 2 % from every natural one.
bool drive_by_chance(Chance& chance, flexible::Mechanism& mechanism) {
  const flexible::Mechanism fine =
      modelled(mechanism, {ModelLevel::flexible, 0, 64, flexible::Element::corrected, true});
  const flexible::Structure structure = flexible::structure_of(fine);
  const std::vector<flexible::Mode> modes = flexible::modes_of(structure, 6);
  mechanism.frequency =
      modes.front().frequency * test::power_of_ten(chance, std::log10(0.02), std::log10(3.0));
  return std::none_of(modes.begin(), modes.end(), [&](const flexible::Mode& mode) {
    return std::abs(mechanism.frequency / mode.frequency - 1.0) < 0.02;
  });
}

}  // namespace

// The reference: all elements of 256 parts with all deformations, solved directly.
TEST_CASE("over beams by chance the model chosen is within the tolerance, a cheaper one is not",
          "[model_choice]") {
  constexpr int beams = 200;
  const ElasticModel reference{ModelLevel::flexible, 0, 256, flexible::Element::corrected, true};
  struct Count {
    int chosen = 0, within = 0, with_cheaper = 0, cheaper_missed = 0;
  };
  std::map<std::string, Count> table;
  Count all;
  Chance chance(20260107);
  while (all.chosen < beams) {
    VibratingBeam of = beam_by_chance(chance);
    if (!drive_by_chance(chance, of.mechanism)) continue;
    const double tolerance = test::power_of_ten(chance, -3.0, std::log10(0.05));
    const ModelChoice choice = climb_ladder(of.ladder(), tolerance);
    const std::vector<ComparedPlace> places = places_of(of.ladder());
    const VibratingStress exact = stresses_by(of.ladder(), reference, places);
    const auto error = [&](const ElasticModel& model) {
      return difference_between(stresses_by(of.ladder(), model, places), exact);
    };
    const double left = error(choice.chosen);
    INFO(choice.reason);
    INFO(fmt::format("error {:.4g} %, tolerance {:.4g} %", 100.0 * left, 100.0 * tolerance));
    CHECK(left <= tolerance);
    Count one{1, left <= tolerance ? 1 : 0, 0, 0};
    if (choice.weighed.size() > 1) {
      one.with_cheaper = 1;
      const ElasticModel& cheaper = choice.weighed[choice.weighed.size() - 2].model;
      if (error(cheaper) > tolerance) one.cheaper_missed = 1;
    }
    std::string level = to_text(choice.chosen.level);
    if (choice.chosen.parts > 0) level += fmt::format(", {} parts", choice.chosen.parts);
    for (Count* count : {&table[level], &all}) {
      count->chosen += one.chosen;
      count->within += one.within;
      count->with_cheaper += one.with_cheaper;
      count->cheaper_missed += one.cheaper_missed;
    }
  }
  std::string text =
      fmt::format("{:<20}{:>8}{:>8}{:>24}\n", "model", "beams", "within", "next cheaper missed");
  const auto row = [&](const std::string& name, const Count& of) {
    text += fmt::format("{:<20}{:>8}{:>8}{:>18} of {}\n", name, of.chosen, of.within,
                        of.cheaper_missed, of.with_cheaper);
  };
  for (const auto& [name, count] : table) row(name, count);
  row("all", all);
  WARN(text);
  CHECK(all.within == beams);
  CHECK(all.cheaper_missed >= 0.8 * all.with_cheaper);
  CHECK(table.size() >= 4);
}

TEST_CASE("near a resonance only all elements or none are good enough, on it nothing is",
          "[model_choice]") {
  Chance chance(7);
  VibratingBeam of = beam_by_chance(chance);
  const flexible::Mechanism fine =
      modelled(of.mechanism, {ModelLevel::flexible, 0, 256, flexible::Element::corrected, true});
  const flexible::Structure structure = flexible::structure_of(fine);
  const double first = flexible::modes_of(structure, 1).front().frequency;
  of.mechanism.frequency = 1.001 * first;
  const ModelChoice near = climb_ladder(of.ladder(), 0.02);
  // 0.1 % from resonance an error of 1e-5 of the frequency is 1 % of the vibration.
  CHECK(near.chosen.parts >= 16);
  CHECK(error_of(of.ladder(), near.chosen) < 0.03);
  of.mechanism.frequency = first * (1.0 + 1e-9);
  CHECK_THROWS_AS(climb_ladder(of.ladder(), 0.01), AnalysisError);
}

namespace {

/// First frequency of the rig by hand: the sledge and the lower rod on the end of a beam without
/// mass, supported at O and B, delta = integral of M_1^2/EI.
double frequency_by_hand(const Project& project) {
  const double O = 3.2, B = 6.2;
  const int steps = 2000;
  double delta = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double s = B * (i + 0.5) / steps;
    const double M = s < O ? s : O * (B - s) / (B - O);
    const double I = properties_of(section_at(project.beam, {si<Length>(s)})).I_y.value();
    delta += M * M / (project.model.youngs_modulus * I) * B / steps;
  }
  double mass = 0.0;
  for (const Body& body : planar_of(project).bodies) {
    if (body.name == "sledge" || body.name == "lower_rod") mass += body.mass;
  }
  return std::sqrt(1.0 / (delta * mass)) / (2.0 * std::numbers::pi);
}

}  // namespace

TEST_CASE("the sledge rig stays rigid, its sledge counted", "[model_choice]") {
  const ModelChoice choice = choose_model(test::rig());
  CHECK(choice.chosen.level == ModelLevel::rigid);
  REQUIRE_FALSE(choice.frequencies.empty());
  // Shear and the beam's own mass lower the frequency; together less than 10 %.
  const double by_hand = frequency_by_hand(test::rig());
  CHECK(choice.frequencies.front() < by_hand);
  CHECK(choice.frequencies.front() > 0.9 * by_hand);
  // One harmonic, 0.7 Hz, against it.
  const double r = 0.7 / choice.frequencies.front();
  REQUIRE(choice.harmonics.size() == 1);
  CHECK(choice.harmonics[0].frequency == Approx(0.7));
  CHECK(choice.weighed.front().error == Approx(1.0 / (1.0 - r * r) - 1.0).epsilon(0.05));
  CHECK_THAT(choice.reason, Catch::Contains("0.59 %") && Catch::Contains("9.19"));

  // Close to the tolerance the estimate is verified, here and just above it.
  Project closer = test::rig();
  closer.model.tolerance = 0.007;
  const ModelChoice verified = choose_model(closer);
  CHECK(verified.chosen.level == ModelLevel::rigid);
  REQUIRE(verified.weighed.front().found);
  CHECK(*verified.weighed.front().found == Approx(choice.weighed.front().error).epsilon(0.1));
  closer.model.tolerance = 0.005;
  CHECK(choose_model(closer).chosen.level == ModelLevel::modal);

  Project heavier = test::rig();
  for (Body& body : planar_of(heavier).bodies) {
    if (body.name == "sledge" || body.name == "lower_rod") body.mass *= 4.0;
  }
  CHECK(choose_model(heavier).frequencies.front() ==
        Approx(0.5 * choice.frequencies.front()).epsilon(0.05));
}

TEST_CASE("what is not estimated is said with its reason", "[model_choice]") {
  const auto reason_of = [](const std::string& path) {
    const ModelChoice choice = choose_model(read_project(test::project_file(path)));
    CHECK(choice.chosen.level == ModelLevel::rigid);
    return choice.reason;
  };
  CHECK_THAT(reason_of("sections/sledge-rig/published.toml"), Catch::Contains("Newton chain"));
}

TEST_CASE("the slender rig vibrates with its lowest mode", "[model_choice]") {
  const Project project = read_project(test::project_file("sections/sledge-rig/slender.toml"));
  const ModelChoice choice = choose_model(project);
  CHECK(choice.chosen.level == ModelLevel::modal);
  CHECK(choice.chosen.modes == 1);
  const double r = 0.9 / choice.frequencies.front();
  CHECK(choice.weighed.front().error == Approx(1.0 / (1.0 - r * r) - 1.0).epsilon(0.05));
  REQUIRE(choice.weighed.back().found);
  CHECK(*choice.weighed.back().found < 0.01);

  Project rigid = project;
  rigid.model.demand = ModelDemand::rigid;
  CHECK(choose_model(rigid).chosen.level == ModelLevel::rigid);
}

// Axially rigid bending links cannot be taken on faith: an independent finite element model finds
// the 25 Hz amplitude in w1 changed by 70 % with the real EA.
TEST_CASE("the drill truck's links need their elasticity along the axes", "[model_choice]") {
  Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const ModelChoice choice = choose_model(project);
  CHECK(choice.chosen.axial);
  REQUIRE(choice.weighed.back().found);
  CHECK(*choice.weighed.back().found <= 0.01);
  CHECK_THAT(choice.reason, Catch::Contains("rigid along their axes"));
  project.model.demand = ModelDemand::flexible;
  const ModelChoice written = choose_model(project);
  CHECK(written.chosen.level == ModelLevel::flexible);
  CHECK_FALSE(written.chosen.axial);
  CHECK(written.weighed.back().error > 0.05);
}

TEST_CASE("a motion that does not repeat is estimated as it begins and ends at rest",
          "[model_choice]") {
  // Slow against the beam's 9.2 Hz: what the slope of its acceleration leaves at both ends is
  // 2 60/(5.77 omega T) of what accelerations do, 2.3 %.
  Project slow = test::rig();
  auto& driven = std::get<planar::Driven>(planar_of(slow).joints.back().kind);
  const double at = driver_at(driven.driver, 0.0).value;
  driven.driver = StepDriver{at, at + 0.05, 0.0, 16.0};
  slow.model.tolerance = 0.03;
  const ModelChoice choice = choose_model(slow);
  CHECK(choice.chosen.level == ModelLevel::rigid);
  REQUIRE_FALSE(choice.weighed.empty());
  CHECK(choice.weighed.front().error < 0.03);
  CHECK(choice.harmonics.empty());
  CHECK_THAT(choice.reason, Catch::Contains("vibration is estimated"));
  CHECK_THAT(choice.weighed.front().basis, Catch::Contains("over time"));

  // A start at full speed: what it does is estimated, and what a blow leaves is said.
  Project once = test::rig();
  planar_of(once).duration.length = 1.0;
  once.model.demand = ModelDemand::rigid;
  const ModelledRuns runs = run_by_chosen_model(once);
  CHECK_THAT(runs.model.reason, !Catch::Contains("not estimated"));
  const std::vector<NotJudged> said = unestimated_vibration_of(once, runs.model, runs.runs);
  REQUIRE(said.size() == 1);
  CHECK_THAT(said.front().what, Catch::Contains("at the beginning"));
}

TEST_CASE("dry friction is estimated; where it excites more than the tolerance, that is said",
          "[model_choice]") {
  const auto with_friction = [](double coefficient) {
    Project project = read_project(test::project_file("sections/sledge-rig/friction.toml"));
    for (planar::Joint& joint : planar_of(project).joints) {
      auto* slider = std::get_if<planar::Slider>(&joint.kind);
      if (slider != nullptr && joint.name == "rail") slider->friction.coulomb = coefficient;
    }
    return std::pair{project, choose_model(project)};
  };
  const ModelChoice smooth = choose_model(test::rig());
  // Next to none: what the smooth rig misses.
  const auto [slight_project, slight] = with_friction(1e-4);
  CHECK(model_gates_of(slight_project, slight).empty());
  CHECK(slight.chosen.level == ModelLevel::rigid);
  REQUIRE_FALSE(slight.weighed.empty());
  CHECK(slight.frequencies.front() == Approx(smooth.frequencies.front()).epsilon(1e-9));
  CHECK(slight.weighed.front().error == Approx(smooth.weighed.front().error).epsilon(0.2));
  CHECK_THAT(slight.reason, !Catch::Contains("not known"));
  // The rig's lowest frequency is next to its 13th harmonic, which friction of 0.05 excites.
  const auto [project, choice] = with_friction(0.05);
  CHECK(choice.chosen.level == ModelLevel::rigid);
  REQUIRE_FALSE(choice.weighed.empty());
  CHECK(choice.weighed.front().error > 0.05);
  CHECK_THAT(choice.reason, Catch::Contains("dry friction in joint rail"));
  // Checks that pass do not make a verdict there.
  const std::vector<Gate> gates = model_gates_of(project, choice);
  REQUIRE(gates.size() == 1);
  CHECK(gates.front().blocks);
  CHECK_THAT(gates.front().finding, Catch::Contains("not known"));
}

TEST_CASE("one model serves all situations of elastic links", "[model_choice]") {
  const Project one = read_project(test::project_file("sections/drill-truck/truck.toml"));
  std::vector<Situation> situations;
  std::vector<ElasticModel> alone;
  Project project = one;
  for (const double frequency : {3.0, 12.0, 25.0}) {
    Situation& situation = situations.emplace_back(one.situations.front());
    flexible::Mechanism mechanism = flexible_of(one);
    mechanism.frequency = frequency;
    situation.name = fmt::format("at {} Hz", frequency);
    situation.changed = mechanism;
    project.situations = {situation};
    alone.push_back(choose_model(project).chosen);
  }
  project.situations = situations;
  const ModelChoice choice = choose_model(project);
  for (const ElasticModel& model : alone) {
    CHECK(choice.chosen.level >= model.level);
    CHECK(choice.chosen.parts >= model.parts);
    CHECK(choice.chosen.axial >= model.axial);
    CAPTURE(describe(model), choice.reason);
    if (choice.chosen.level == ModelLevel::modal) CHECK(choice.chosen.modes >= model.modes);
  }
  for (const Situation& situation : project.situations) {
    const LadderCase of{&flexible_in(project, situation), project.beam_body, &project.beam};
    CHECK(error_of(of, choice.chosen) <= choice.tolerance);
  }
  CHECK(choice.harmonics.size() == 3);
  CHECK_THAT(choice.reason, Catch::Contains("situation \"at "));
}

TEST_CASE("where no model is good enough, what stands against it is named", "[model_choice]") {
  Project truck = read_project(test::project_file("sections/drill-truck/truck.toml"));
  truck.model.tolerance = 1e-9;
  CHECK_THROWS_WITH(choose_model(truck),
                    Catch::Contains("256 parts") && !Catch::Contains("too near"));
  // Its fifth frequency is 12.76 Hz.
  flexible_of(truck).frequency = 12.8;
  CHECK_THROWS_WITH(choose_model(truck), Catch::Contains("too near the natural frequency of 12.7"));

  Project slender = read_project(test::project_file("sections/sledge-rig/slender.toml"));
  slender.model.tolerance = 1e-6;
  CHECK_THROWS_WITH(choose_model(slender), Catch::Contains("what the beam's rotation couples"));
}

}  // namespace model_choice_test
