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
#include "boxbeam/verification/model_ladder.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"

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
    if (choice.chosen.modes > 0) level += fmt::format(", {} modes", choice.chosen.modes);
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
