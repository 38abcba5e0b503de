// Pins and rods of the mechanism beside the beam.

#include "boxbeam/verification/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/buckling_curve.hpp"
#include "support/changed_rig.hpp"
#include "support/held_rod.hpp"

namespace neighbours_test {

using namespace boxbeam;
using test::buckling_of;
using test::compression_of;
using test::rod_result;
using test::rods_of;

namespace {

constexpr double period = 1.0 / 0.7;
constexpr double g = 9.815;

const std::string pin_lines =
    "[[pins]]\nname = \"hub pin\"\njoint = \"O\"\ndiameter = \"80 mm\"\ninner_plate = \"60 mm\"\n"
    "outer_plate = \"30 mm\"\ngap = \"2 mm\"\nrequired = 1.5\n";
const std::string tube_lines =
    "[sections.rod]\nkind = \"round tube\"\ndiameter = \"114.3 mm\"\nwall = \"10 mm\"\n";
const std::string rod_lines =
    "[[rods]]\nname = \"upper rod\"\nfrom = \"upper_rod.B\"\nto = \"upper_rod.A\"\n"
    "section = \"rod\"\nbuckling_length = \"6 m\"\ncurve = \"a\"\ngamma_M1 = 1.1\n";

std::string with(const std::string& lines) { return test::rig_text({}, "\n" + tube_lines + lines); }

Project read(const std::string& lines) { return parse_project("rig.toml", with(lines)); }

/// Every thousandth of the period.
const std::vector<InstantResult>& states() {
  static const MotionResult motion = [] {
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) times.push_back(period * i / 1000.0);
    return motion_of(read(""), times);
  }();
  return motion.states;
}

const JointReaction& reaction(const InstantResult& state, const std::string& joint) {
  for (const JointReaction& reaction : state.reactions) {
    if (reaction.joint == joint) return reaction;
  }
  throw std::runtime_error("no joint " + joint);
}

const BodyMotion& body(const InstantResult& state, const std::string& name) {
  for (const BodyMotion& body : state.bodies) {
    if (body.name == name) return body;
  }
  throw std::runtime_error("no body " + name);
}

}  // namespace

TEST_CASE("a pin bears the largest reaction of its joint, by EN 1993-1-8 table 3.10") {
  const Project project = read(pin_lines);
  const std::deque<SituationRun> runs = run_situations(project);
  const std::vector<NeighbourResult> results = check_pins(project, runs).results;
  REQUIRE(results.size() == 1);
  const Check& check = results.front().check;
  double largest = 0.0;
  for (const InstantResult& state : states()) {
    largest = std::max(largest, reaction(state, "O").force.norm());
  }
  const double F = check.acting.value();
  CHECK(F >= largest * (1.0 - 1e-12));
  CHECK(F == Approx(largest).epsilon(1e-4));  // between two of the instants

  // By hand, S355: a pin of 80 mm has 325 and 470 MPa, plates of 60 and 30 mm 335 and 345 MPa
  // (EN 10025-2); gamma_M0 = 1.0, gamma_M2 = 1.25.
  const double d = 0.08;
  const double f_yp = project.pins[0].strength.pin_yield.value();
  const double f_up = project.pins[0].strength.pin_tensile.value();
  CHECK(f_yp == 325e6);
  CHECK(f_up == 470e6);
  CHECK(project.pins[0].strength.inner_yield.value() == 335e6);
  CHECK(project.pins[0].strength.outer_yield.value() == 345e6);
  const double shear = 0.5 * F / (0.6 * std::numbers::pi * d * d / 4.0 * f_up / 1.25);
  const double inner = F / (1.5 * 0.06 * d * 325e6);
  const double outer = 0.5 * F / (1.5 * 0.03 * d * 325e6);
  const double moment = F * (0.06 + 4.0 * 0.002 + 2.0 * 0.03) / 8.0;
  const double bending = moment / (1.5 * std::numbers::pi * d * d * d / 32.0 * f_yp);
  const auto& pin = std::get<LoadedPin>(results.front().basis);
  const PinUtilisation use =
      pin_utilisation(si<Force>(check.acting.value()), pin.geometry, pin.strength);
  CHECK(use.shear == Approx(shear).epsilon(1e-12));
  CHECK(use.bearing_inner == Approx(inner).epsilon(1e-12));
  CHECK(use.bearing_outer == Approx(outer).epsilon(1e-12));
  CHECK(use.bending == Approx(bending).epsilon(1e-12));
  CHECK(use.combined == Approx(bending * bending + shear * shear).epsilon(1e-12));
  const double largest_use =
      std::max({shear, inner, outer, bending, std::sqrt(bending * bending + shear * shear)});
  CHECK(check.safety_factor == Approx(1.0 / largest_use).epsilon(1e-12));
  CHECK(check.required == 1.5);
  CHECK(check.id == "pin/hub-pin");
  CHECK_FALSE(check.on_beam);
}

TEST_CASE("a pin that says no partial factors has those of [strength]") {
  std::string text = with(pin_lines);
  const std::string strength = "[strength]\n";
  text.replace(text.find(strength), strength.size(),
               strength + "gamma_M0 = 1.1\ngamma_M1 = 1.2\ngamma_M2 = 2.5\n");
  const Project project = parse_project("rig.toml", text);
  const Check check = check_pins(project, run_situations(project)).results.front().check;
  // Shear in two planes and bending together, as above by hand: EN 1993-1-8, table 3.10.
  const double d = 0.08, F = check.acting.value();
  const double shear = 0.5 * F / (0.6 * std::numbers::pi * d * d / 4.0 * 470e6 / 2.5);
  const double bending = F * (0.06 + 4.0 * 0.002 + 2.0 * 0.03) / 8.0 /
                         (1.5 * std::numbers::pi * d * d * d / 32.0 * 325e6 / 1.1);
  const double bearing = F / (1.5 * 0.06 * d * 325e6 / 1.1);
  CHECK(check.safety_factor ==
        Approx(1.0 / std::max({std::hypot(shear, bending), shear, bearing})).epsilon(1e-9));
  // Its own ones hold before these.
  std::string said = text;
  const std::string required = "gap = \"2 mm\"\n";
  said.replace(said.find(required), required.size(), required + "gamma_M2 = 1.25\n");
  CHECK(parse_project("rig.toml", said).pins[0].strength.gamma_M2 == 1.25);
}

TEST_CASE("plates of a pin that are not given stand in the verdict line") {
  const auto said = [](const std::string& lugs) {
    const Project project = read(pin_lines + lugs);
    std::string all;
    for (const NotJudged& of : check_pins(project, run_situations(project)).not_judged)
      all += of.what + ": " + of.reason + "\n";
    return all;
  };
  const std::string inner =
      "[[pins.lugs]]\nplate = \"inner\"\nwidth = \"200 mm\"\nend = \"80 mm\"\n";
  const std::string outer =
      "[[pins.lugs]]\nplate = \"outer\"\nwidth = \"200 mm\"\nend = \"80 mm\"\n";
  const std::string where =
      " of hub pin beside and before its hole (EN 1993-1-8, table 3.9): [[pins.lugs]] are not "
      "given\n";
  CHECK(said("") == "plates" + where);
  CHECK(said(inner) == "outer plates" + where);
  CHECK(said(outer) == "inner plate" + where);
  CHECK(said(inner + outer).empty());
}

TEST_CASE("the factor of a pin is one on the force: with it the joint is just used up") {
  const Project project = read(pin_lines);
  const std::deque<SituationRun> runs = run_situations(project);
  const Check check = check_pins(project, runs).results.front().check;
  const PinInput& pin = project.pins.front();
  const PinUtilisation use = pin_utilisation(si<Force>(check.acting.value() * check.safety_factor),
                                             pin.geometry, pin.strength);
  CHECK(std::max({use.shear, use.bearing_inner, use.bearing_outer, use.bending, use.combined}) ==
        Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a replaceable pin is judged in service too, without load factors") {
  std::string lines = pin_lines;
  lines.replace(lines.find("gap ="), 0, "hole = \"82 mm\"\nreplaceable = true\n");
  Project project = read(lines);
  project.situations.front().load_factor = 1.35;
  const std::deque<SituationRun> runs = run_situations(project);
  const std::vector<NeighbourResult> results = check_pins(project, runs).results;
  REQUIRE(results.size() == 2);
  const double factored = results[0].check.acting.value(), F = results[1].check.acting.value();
  CHECK(factored == Approx(1.35 * F).epsilon(1e-12));
  CHECK(results[1].check.id == "pin/hub-pin-in-service");
  CHECK(results[1].check.required == 1.5);
  // By hand, as above; 0.6 of bearing, 0.8 of bending, 2.5 f_y of Hertz's pressure.
  const double d = 0.08, f_y = 325e6;
  const double bearing = std::max(F / (0.6 * 0.06 * d * f_y), 0.5 * F / (0.6 * 0.03 * d * f_y));
  const double moment = F * (0.06 + 4.0 * 0.002 + 2.0 * 0.03) / 8.0;
  const double bending = moment / (0.8 * std::numbers::pi * d * d * d / 32.0 * f_y);
  const double pressed = 0.591 * std::sqrt(210e9 * F * 0.002 / (d * d * 0.06)) / (2.5 * f_y);
  CHECK(results[1].check.safety_factor ==
        Approx(1.0 / std::max({bearing, bending, pressed * pressed})).epsilon(1e-9));
}

TEST_CASE("a rod is pressed by what its free body asks for, and buckles by EN 1993-1-1 6.3.1") {
  const Project project = read(rod_lines);
  const NeighbourResult result = buckling_of(project);
  const Check& check = result.check;
  // The rod from B to A: what the beam feels at B, reversed, presses it at B; Newton's law of its
  // 119 kg gives the force at A.
  double largest = -1e300;
  for (const InstantResult& state : states()) {
    const BodyMotion& rod = body(state, "upper_rod");
    const JointReaction& at_B = reaction(state, "B");
    REQUIRE(at_B.on == "beam");
    const Eigen::Vector2d from_B = -at_B.force;
    const Eigen::Vector2d from_A =
        119.0 * (rod.acceleration.head<2>() + Eigen::Vector2d(0.0, g)) - from_B;
    const Eigen::Vector2d along(std::cos(rod.position.z()), std::sin(rod.position.z()));
    largest = std::max({largest, from_B.dot(along), -from_A.dot(along)});
  }
  const double N = check.acting.value();
  CHECK(N >= largest * (1.0 - 1e-12));
  CHECK(N == Approx(largest).epsilon(1e-4));

  // Tube 114.3 x 10, 6 m, S355, curve a (alpha = 0.21).
  const double D = 0.1143;
  const double d = 0.0943;
  const double area = std::numbers::pi / 4.0 * (D * D - d * d);
  const double inertia = std::numbers::pi / 64.0 * (std::pow(D, 4) - std::pow(d, 4));
  const double critical = std::numbers::pi * std::numbers::pi * 210e9 * inertia / 36.0;
  const double lambda = std::sqrt(area * 355e6 / critical);
  const double chi = test::chi_of(lambda, 0.21);
  CHECK(compression_of(result).slenderness == Approx(lambda).epsilon(1e-9));
  CHECK(compression_of(result).reduction == Approx(chi).epsilon(1e-9));
  CHECK(check.resisting.value() == Approx(chi * area * 355e6 / 1.1).epsilon(1e-9));
  CHECK(check.safety_factor == Approx(check.resisting.value() / N).epsilon(1e-12));
  CHECK(check.id == "buckling/upper-rod");
}

TEST_CASE("the buckling length is the rod's own where nothing is said, and the steel the beam's") {
  const Project project = read(
      "[[rods]]\nname = \"upper rod\"\nfrom = \"upper_rod.B\"\nto = \"upper_rod.A\"\n"
      "section = \"rod\"\ncurve = \"c\"\n");
  CHECK(project.rods.front().buckling_length.value() == Approx(0.5));
  CHECK(project.rods.front().yield_strength.value() == 355e6);
  CHECK(project.rods.front().required == 2.0);
}

TEST_CASE("that a rod is bent by its own weight and inertia is said where it counts") {
  // At every instant m (g - a) across it, linear between its ends, on 400 parts of it between pins.
  const double L = 0.5;
  double most = 0.0;
  for (const InstantResult& state : states()) {
    const BodyMotion& rod = body(state, "upper_rod");
    const Eigen::Vector2d across(-std::sin(rod.position.z()), std::cos(rod.position.z()));
    const double mean = across.dot(Eigen::Vector2d(0.0, -g) - rod.acceleration.head<2>());
    const double alpha = rod.acceleration.z();
    constexpr int parts = 400;
    double at_start = 0.0;
    std::array<double, parts> load{};
    for (int k = 0; k < parts; ++k) {
      const double x = L * (k + 0.5) / parts;
      load[static_cast<std::size_t>(k)] = 119.0 / parts * (mean - alpha * (x - 0.5 * L));
      at_start += load[static_cast<std::size_t>(k)] * (1.0 - x / L);
    }
    double shear = at_start, moment = 0.0;
    for (const double part : load) {
      moment += (shear - 0.5 * part) * L / parts;
      shear -= part;
      most = std::max(most, std::abs(moment));
    }
  }
  const auto said = [](double diameter) {
    const Project project = parse_project(
        "rig.toml",
        test::rig_text({},
                       fmt::format("\n[sections.rod]\nkind = \"round tube\"\ndiameter = \"{} mm\"\n"
                                   "wall = \"5 mm\"\n",
                                   diameter) +
                           rod_lines));
    for (const NotJudged& of : rods_of(project).not_judged) {
      const std::size_t by = of.reason.find("bend it, by ");
      if (by != std::string::npos) return std::stod(of.reason.substr(by + 12));
    }
    return 0.0;
  };
  const double W = std::numbers::pi / 32.0 * (std::pow(0.03, 4) - std::pow(0.02, 4)) / 0.03;
  const double by_hand = 1e-6 * most / W;
  CHECK(by_hand > 0.04 * 355.0);
  CHECK(said(30.0) >= by_hand * (1.0 - 5e-3));
  CHECK(said(30.0) <= by_hand * 1.15);
  CHECK(said(114.3) == 0.0);
}

TEST_CASE("the load factor of a situation multiplies the force of a pin and of a rod") {
  Project project = read(pin_lines + rod_lines);
  const std::deque<SituationRun> runs = run_situations(project);
  const double pin = check_pins(project, runs).results.front().check.acting.value();
  const double rod = buckling_of(project).check.acting.value();
  const double pull = rod_result(project, Criterion::rod).check.acting.value();
  project.situations.front().load_factor = 1.3;
  CHECK(check_pins(project, runs).results.front().check.acting.value() ==
        Approx(1.3 * pin).epsilon(1e-12));
  CHECK(buckling_of(project).check.acting.value() == Approx(1.3 * rod).epsilon(1e-12));
  CHECK(rod_result(project, Criterion::rod).check.acting.value() ==
        Approx(1.3 * pull).epsilon(1e-12));
}

TEST_CASE("the checks of neighbours count for the verdict") {
  Project project = read(pin_lines + rod_lines);
  project.fatigue.required = 0.01;
  project.pins.front().required = project.rods.front().required = 0.01;
  const Verification verification = verify(project);
  CHECK(verification.neighbours.size() == 3);  // the rod is pulled and pressed
  REQUIRE(verification.governing(Criterion::pin) != nullptr);
  REQUIRE(verification.governing(Criterion::rod) != nullptr);
  REQUIRE(verification.governing(Criterion::buckling) != nullptr);
  CHECK(verification.verdict == Verdict::pass);
  project.pins.front().required = 1e6;
  CHECK(verify(project).verdict == Verdict::fail);
}

TEST_CASE("a rod that turns is pulled most inside: the sum of its mass elements says how much") {
  // The upper rod as an even bar of 119 kg: the tension is summed from B in 4000 pieces, each with
  // the acceleration of its own middle.
  const Project project = read(rod_lines);
  const double found = rod_result(project, Criterion::rod).check.acting.value();
  constexpr int pieces = 4000;
  double largest = -1e300;
  for (const InstantResult& state : states()) {
    const BodyMotion& rod = body(state, "upper_rod");
    const Eigen::Vector2d along(std::cos(rod.position.z()), std::sin(rod.position.z()));
    const double omega = rod.velocity.z();
    double tension = reaction(state, "B").force.dot(along);
    largest = std::max(largest, tension);
    for (int i = 0; i < pieces; ++i) {
      const double from_centre = 0.5 * ((i + 0.5) / pieces - 0.5);
      const double acceleration =
          rod.acceleration.head<2>().dot(along) - omega * omega * from_centre;
      tension += 119.0 / pieces * (acceleration + g * along.y());
      largest = std::max(largest, tension);
    }
  }
  CHECK(found >= largest * (1.0 - 1e-9));
  CHECK(found == Approx(largest).epsilon(1e-4));
}

TEST_CASE("pins and rods that cannot be are refused at their place") {
  const auto replaced = [](std::string lines, const std::string& part, const std::string& by) {
    return with(lines.replace(lines.find(part), part.size(), by));
  };
  test::check_refused(replaced(pin_lines, "\"O\"\n", "\"Q\" # here\n"), "# here", "\"Q\"", "O");
  test::check_refused(replaced(pin_lines, "gap", "hole = \"79 mm\"\ngap"), "hole = \"79 mm\"",
                      "the pin does not fit its hole", "its diameter or more");
  test::check_refused(replaced(pin_lines, "\"60 mm\"", "\"0 mm\""), "inner_plate = \"0 mm\"",
                      "\"inner_plate\" must be above zero", "");
  test::check_refused(replaced(pin_lines, "\"80 mm\"", "\"900 mm\""), "diameter = \"900 mm\"",
                      "has no strength for a thickness of 900 mm", "its table ends at");
  const std::string again = "[[pins]]\nname = \"hub pin\" # again\n";
  test::check_refused(with(pin_lines + again + pin_lines.substr(pin_lines.find("joint"))),
                      "# again", "\"hub pin\" is there already", "a name of its own");
  test::check_refused(replaced(rod_lines, "upper_rod.A", "lower_rod.C"), "to = \"lower_rod.C\"",
                      "from one point of a body to another one of the same body", "two of its");
  test::check_refused(replaced(rod_lines, "to = \"upper_rod.A\"", "to = \"upper_rod.B\""),
                      "to = \"upper_rod.B\"", "another one of the same body", "two of its");
  test::check_refused(replaced(rod_lines, "\"rod\"", "\"rood\""), "section = \"rood\"", "rood",
                      "rod");
  test::check_refused(replaced(rod_lines, "curve = \"a\"", "curve = \"e\""), "curve = \"e\"", "e",
                      "a0");
  // 114.3 x 10: pi (114.3^2 - 94.3^2)/4 = 3277 mm^2.
  test::check_refused(replaced(rod_lines, "curve", "net_area = \"33 cm^2\"\ncurve"), "net_area",
                      "larger than the whole section, 3276", "less the holes");
}

}  // namespace neighbours_test
