// Pins and rods of the mechanism beside the beam.

#include "boxbeam/verification/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/changed_rig.hpp"
#include "support/held_bar.hpp"
#include "support/path_cases.hpp"

namespace neighbours_test {

using namespace boxbeam;

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

/// The check of the only rod by a criterion.
NeighbourResult rod_result(const Project& project, const std::deque<SituationRun>& runs,
                           Criterion criterion) {
  for (NeighbourResult& result : check_rods(project, runs).results) {
    if (result.check.criterion == criterion) return result;
  }
  throw std::runtime_error(std::string("no check of ") + to_text(criterion));
}

NeighbourResult buckling_of(const Project& project, const std::deque<SituationRun>& runs) {
  return rod_result(project, runs, Criterion::buckling);
}

CompressionResistance compression_of(const NeighbourResult& result) {
  return compression_resistance_of(std::get<PressedRod>(result.basis));
}

TensionResistance tension_of(const NeighbourResult& result) {
  return tension_resistance_of(std::get<PulledRod>(result.basis));
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
      " of pin hub pin beside and before its hole (EN 1993-1-8, table 3.9): [[pins.lugs]] are not "
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
  const std::deque<SituationRun> runs = run_situations(project);
  const NeighbourResult result = buckling_of(project, runs);
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
  const double phi = 0.5 * (1.0 + 0.21 * (lambda - 0.2) + lambda * lambda);
  const double chi = 1.0 / (phi + std::sqrt(phi * phi - lambda * lambda));
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
    for (const NotJudged& of : check_rods(project, run_situations(project)).not_judged) {
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
  const double rod = buckling_of(project, runs).check.acting.value();
  const double pull = rod_result(project, runs, Criterion::rod).check.acting.value();
  project.situations.front().load_factor = 1.3;
  CHECK(check_pins(project, runs).results.front().check.acting.value() ==
        Approx(1.3 * pin).epsilon(1e-12));
  CHECK(buckling_of(project, runs).check.acting.value() == Approx(1.3 * rod).epsilon(1e-12));
  CHECK(rod_result(project, runs, Criterion::rod).check.acting.value() ==
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

TEST_CASE(
    "a rod that hangs the beam is pulled by W/2 and never pressed; one that props it bears W/2") {
  const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";
  const std::string rod =
      "[[rods]]\nname = \"hanger\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\nsection = \"bar\"\n"
      "curve = \"c\"\n";
  const Project hanging = test::held_bar(true, flat, rod);
  const NeighbourChecks pulled = check_rods(hanging, run_situations(hanging));
  REQUIRE(pulled.results.size() == 1);
  // 0.05 x 0.1 x 2 m^3 of 8000 kg/m^3 weigh 800 N; half of it is on the rod.
  const Check& tension = pulled.results.front().check;
  CHECK(tension.id == "rod/hanger");
  CHECK(tension.acting.value() == Approx(400.0).epsilon(1e-6));
  // 50 mm of S355 (EN 10025-2): f_y = 335, f_u = 470 MPa; 0.9 x 470/1.25 = 338.4 MPa is above f_y.
  CHECK(tension.resisting.value() == Approx(0.005 * 335e6).epsilon(1e-12));
  CHECK(pulled.gates.empty());
  CHECK(pulled.not_judged.empty());
  const Project propped = test::held_bar(false, flat, rod);
  const NeighbourChecks pressed = check_rods(propped, run_situations(propped));
  REQUIRE(pressed.results.size() == 1);
  const NeighbourResult& result = pressed.results.front();
  CHECK(result.check.acting.value() == Approx(400.0).epsilon(1e-6));
  // A flat of 50 x 100 buckles about its z axis: I = 0.1 0.05^3/12.
  CHECK(std::get<PressedRod>(result.basis).weak_axis);
  const double critical = std::numbers::pi * std::numbers::pi * 210e9 * 0.1 * 1.25e-4 / 12.0;
  CHECK(compression_of(result).slenderness ==
        Approx(std::sqrt(0.005 * 335e6 / critical)).epsilon(1e-9));  // 50 mm: 335 MPa
}

namespace {

/// The bar on a prop, or under a hanger, of the given section, which a force at its end pushes so
/// that the rod bears `size` beside the bar's own 400 N.
Project rod_under(bool from_above, const std::string& direction, const std::string& size,
                  const std::string& section, const std::string& more = "") {
  const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";
  return test::held_bar(from_above, flat,
                        "[forces.push]\nkind = \"force\"\npoint = \"bar.B\"\ndirection = \"" +
                            direction + "\"\nsize = \"" + size + "\"\n[sections.strut]\n" +
                            section +
                            "[[rods]]\nname = \"strut\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\n"
                            "section = \"strut\"\ncurve = \"c\"\n" +
                            more);
}

const std::string wire = "kind = \"plate\"\nwidth = \"5 mm\"\nheight = \"5 mm\"\n";

}  // namespace

TEST_CASE("a pitman of 5 x 5 mm at 4500 MPa fails, although it is never pressed") {
  // 112.9 kN up at the tip, less the bar's 0.4 kN: 112.5 kN on 25 mm^2.
  const Project project = rod_under(false, "90 deg", "112.9 kN", wire);
  const NeighbourResult result = rod_result(project, run_situations(project), Criterion::rod);
  CHECK(result.check.acting.value() == Approx(112.5e3).epsilon(1e-6));
  CHECK(result.check.acting.value() / 25e-6 == Approx(4500e6).epsilon(1e-6));
  // 5 mm of S355 by EN 10025-2: f_y = 355, f_u = 470 MPa.
  CHECK(tension_of(result).plastic.value() == Approx(25e-6 * 355e6).epsilon(1e-12));
  CHECK(tension_of(result).net.value() == Approx(0.9 * 25e-6 * 470e6 / 1.25).epsilon(1e-12));
  CHECK(result.check.resisting.value() == Approx(8460.0).epsilon(1e-12));
  CHECK_FALSE(result.check.passes());
  CHECK(verify(project).verdict == Verdict::fail);
}

TEST_CASE(
    "holes for fasteners weaken a rod: the net area the case gives, and its partial factors") {
  const std::string flat = "kind = \"plate\"\nwidth = \"10 mm\"\nheight = \"100 mm\"\n";
  const Project project =
      rod_under(false, "90 deg", "100.4 kN", flat,
                "net_area = \"780 mm^2\"\ngamma_M0 = 1.1\ngamma_M2 = 1.3\nrequired = 2.0\n");
  const NeighbourResult result = rod_result(project, run_situations(project), Criterion::rod);
  CHECK(tension_of(result).plastic.value() == Approx(1000e-6 * 355e6 / 1.1).epsilon(1e-12));
  CHECK(tension_of(result).net.value() == Approx(0.9 * 780e-6 * 470e6 / 1.3).epsilon(1e-12));
  CHECK(result.check.safety_factor == Approx(0.9 * 780e-6 * 470e6 / 1.3 / 100e3).epsilon(1e-6));
  CHECK(result.check.required == 2.0);
  CHECK(result.check.source == "EN 1993-1-1:2005, 6.2.3");
}

TEST_CASE("a strut of 600 x 600 x 1 bears about 66 kN, not the 851 kN of its whole area") {
  const std::string box =
      "kind = \"box\"\nwidth = \"600 mm\"\nheight = \"600 mm\"\nflange = \"1 mm\"\n"
      "web = \"1 mm\"\n";
  const Project project = rod_under(false, "-90 deg", "99.6 kN", box);
  const NeighbourResult result = buckling_of(project, run_situations(project));
  CHECK(result.check.acting.value() == Approx(100e3).epsilon(1e-6));
  // By hand: c/t = 598, eps = sqrt(235/355), lambda_p = 598/(56.8 eps) = 12.94,
  // rho = (12.94 - 0.22)/12.94^2; the bar of 1 m does not buckle as a whole: lambda < 0.2.
  const double lambda_p = 598.0 / (56.8 * std::sqrt(235.0 / 355.0));
  const double rho = (lambda_p - 0.22) / (lambda_p * lambda_p);
  const double effective = (2396.0 - 4.0 * 598.0 * (1.0 - rho)) * 1e-6;
  CHECK(compression_of(result).slenderness < 0.2);
  CHECK(result.check.resisting.value() == Approx(effective * 355e6).epsilon(1e-9));
  CHECK(result.check.resisting.value() == Approx(66e3).epsilon(0.01));
  CHECK(2396e-6 * 355e6 == Approx(851e3).epsilon(1e-3));
  CHECK_FALSE(result.check.passes());
  CHECK(result.check.source.find("EN 1993-1-5:2006, 4.4") != std::string::npos);
}

TEST_CASE("a stout strut bears no more than its section, by the partial factor of sections") {
  // 50 x 50 mm, 1 m: lambda = 0.88, chi = 0.61 by curve c; 150 x 150 mm: lambda = 0.27, chi = 0.96,
  // so that A f_y/1.5 is the less.
  const auto resistance = [](const std::string& side) {
    const Project project =
        rod_under(false, "-90 deg", "1 kN",
                  "kind = \"plate\"\nwidth = \"" + side + "\"\nheight = \"" + side + "\"\n",
                  "gamma_M0 = 1.5\n");
    return buckling_of(project, run_situations(project)).check.resisting.value();
  };
  const auto buckling = [](double side, double f_y) {
    const double lambda =
        std::sqrt(side * side * f_y * 12.0 / (210e9 * std::pow(side, 4))) / std::numbers::pi;
    const double phi = 0.5 * (1.0 + 0.49 * (lambda - 0.2) + lambda * lambda);
    return side * side * f_y / (phi + std::sqrt(phi * phi - lambda * lambda));
  };
  // S355 by EN 10025-2: 335 MPa from 40 to 63 mm, 295 MPa from 100 to 150 mm.
  CHECK(resistance("50 mm") == Approx(buckling(0.05, 335e6)).epsilon(1e-9));
  CHECK(resistance("50 mm") < 0.05 * 0.05 * 335e6 / 1.5);
  CHECK(resistance("150 mm") == Approx(0.15 * 0.15 * 295e6 / 1.5).epsilon(1e-12));
  CHECK(resistance("150 mm") < buckling(0.15, 295e6));
}

namespace {

constexpr double pi = std::numbers::pi;

/// A path as the strut's section, moved by so much along y and z [mm].
std::string strut_of(ThinWalled path, double by_y = 0.0, double by_z = 0.0) {
  for (SectionPlace& at : path.nodes) at = {at.y + paths::mm(by_y), at.z + paths::mm(by_z)};
  std::string text = path_cases::section("strut", path);
  return text.substr(text.find('\n') + 1);
}

/// Mid-lines of a channel, web `h` along z, flanges `b` along y, all `t` thick: closed forms [m].
struct ChannelByHand {
  double h, b, t;
  double A() const { return t * (h + 2.0 * b); }
  double centroid() const { return b * b * t / A(); }
  double I_y() const { return t * h * h * h / 12.0 + 0.5 * b * t * h * h; }
  double I_z() const { return 2.0 * t * b * b * b / 3.0 - A() * centroid() * centroid(); }
  double y_0() const { return b * b * h * h * t / (4.0 * I_y()) + centroid(); }
  double i_0_2() const { return (I_y() + I_z()) / A() + y_0() * y_0(); }
  double twisting(double L) const {
    const double I_w = t * b * b * b * h * h / 12.0 * (3.0 * b + 2.0 * h) / (6.0 * b + h);
    return (210e9 / 2.6 * A() * t * t / 3.0 + pi * pi * 210e9 * I_w / (L * L)) / i_0_2();
  }
  /// EN 1993-1-3, 6.2.3(7), with the axis of symmetry y.
  double critical(double L) const {
    const double N_y = pi * pi * 210e9 * I_y() / (L * L), N_z = N_y * I_z() / I_y();
    const double beta = 1.0 - y_0() * y_0() / i_0_2(), r = twisting(L) / N_y;
    const double both =
        N_y / (2.0 * beta) * (1.0 + r - std::sqrt((1.0 - r) * (1.0 - r) + 4.0 * (1.0 - beta) * r));
    return std::min(N_z, both);
  }
};

/// Curve c.
double chi_of(double lambda) {
  const double phi = 0.5 * (1.0 + 0.49 * (lambda - 0.2) + lambda * lambda);
  return std::min(1.0, 1.0 / (phi + std::sqrt(phi * phi - lambda * lambda)));
}

}  // namespace

TEST_CASE("an open strut twists as it buckles: a channel by hand", "[twisting]") {
  // Walls as long as their mid-lines; S355 by EN 10025-2, 8 mm. I_z of mid-lines leaves out the
  // web's own, 0.5 %.
  const ChannelByHand hand{0.2, 0.08, 0.008};
  const ThinWalled channel = paths::channel(208.0, 80.0, 8.0, 8.0);
  const double centred = -1e3 * hand.centroid();
  for (const double length : {1.0, 1.6, 3.0}) {
    CAPTURE(length);
    const Project project = rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, centred),
                                      fmt::format("buckling_length = \"{} m\"\n", length));
    const NeighbourChecks checks = check_rods(project, run_situations(project));
    CHECK(checks.gates.empty());
    REQUIRE(checks.results.size() == 1);
    const double lambda = std::sqrt(hand.A() * 355e6 / hand.critical(length));
    CHECK(compression_of(checks.results.front()).slenderness == Approx(lambda).epsilon(4e-3));
    CHECK(checks.results.front().check.resisting.value() ==
          Approx(chi_of(lambda) * hand.A() * 355e6).epsilon(5e-3));
  }
  // It bends about z alone where it is long, and twists as well where it is short.
  CHECK(hand.critical(1.0) < 0.97 * pi * pi * 210e9 * hand.I_z());
}

TEST_CASE("what a force beside the centroid of a strut bends counts, pressed and pulled",
          "[twisting]") {
  // The line of the rod on the web.
  const ChannelByHand hand{0.2, 0.08, 0.008};
  const ThinWalled channel = paths::channel(208.0, 80.0, 8.0, 8.0);
  const double e = hand.centroid(), W_z = hand.I_z() / (0.08 - e);
  const double m = hand.A() * e / W_z;
  const Project pressed = rod_under(false, "-90 deg", "9.6 kN", strut_of(channel));
  const double chi = chi_of(std::sqrt(hand.A() * 355e6 / hand.critical(1.0)));
  CHECK(
      buckling_of(pressed, run_situations(pressed)).check.resisting.value() ==
      Approx(std::min(chi * hand.A() * 355e6 / (1.0 + 1.6 * chi * m), hand.A() * 355e6 / (1.0 + m)))
          .epsilon(6e-3));
  const Project pulled = rod_under(false, "90 deg", "10.4 kN", strut_of(channel));
  CHECK(rod_result(pulled, run_situations(pulled), Criterion::rod).check.resisting.value() ==
        Approx(hand.A() * 0.9 * 470e6 / 1.25 / (1.0 + m)).epsilon(3e-3));
  // Off its centroid in the stiffer plane it may turn over: no verdict.
  const Project high =
      rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, -1e3 * hand.centroid(), 30.0));
  const NeighbourChecks checks = check_rods(high, run_situations(high));
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("may turn the open section over") != std::string::npos);
  CHECK(checks.results.empty());
}

TEST_CASE("a force beside the centroid of any strut bends it", "[rods]") {
  // Box 100 x 100, flanges 20 and 5, webs 5: A = 2000 + 500 + 2 x 75 x 5 = 3250 mm^2, from the
  // middle e = (2000 x 40 - 500 x 47.5 + 750 x (-7.5))/3250 = 15.58 mm.
  const std::string unlike =
      "kind = \"box\"\nwidth = \"100 mm\"\nheight = \"100 mm\"\ntop_flange = \"20 mm\"\n"
      "bottom_flange = \"5 mm\"\nweb = \"5 mm\"\n";
  const double e = (2000.0 * 40.0 - 500.0 * 47.5 - 750.0 * 7.5) / 3250.0;
  const double I = 100.0 * 8000.0 / 12.0 + 2000.0 * std::pow(40.0 - e, 2) + 100.0 * 125.0 / 12.0 +
                   500.0 * std::pow(47.5 + e, 2) + 10.0 * std::pow(75.0, 3) / 12.0 +
                   750.0 * std::pow(7.5 + e, 2);
  const double m = 3250.0 * e * (50.0 + e) / I;
  const Project pulled = rod_under(false, "90 deg", "10.4 kN", unlike);
  CHECK(rod_result(pulled, run_situations(pulled), Criterion::rod).check.resisting.value() ==
        Approx(3250.0 * std::min(345.0, 0.9 * 470.0 / 1.25) / (1.0 + m)).epsilon(1e-6));
  const Project pressed = rod_under(false, "-90 deg", "9.6 kN", unlike);
  const NeighbourResult found = buckling_of(pressed, run_situations(pressed));
  // 345 MPa of the flange of 20 mm.
  const double chi = compression_of(found).reduction;
  CHECK(found.check.resisting.value() ==
        Approx(3250.0 * 345.0 * std::min(chi / (1.0 + 1.6 * chi * m), 1.0 / (1.0 + m)))
            .epsilon(1e-6));
  // A bar of 100 x 50 whose corner is at y = 500 mm: e_y = 550, W_z = 50 x 100^2/6. In y it is
  // stiffer, and may turn over; e_z = 25.
  const std::string aside =
      "kind = \"polygon\"\nouter = [[\"500 mm\", \"0 mm\"], [\"600 mm\", \"0 mm\"], "
      "[\"600 mm\", \"50 mm\"], [\"500 mm\", \"50 mm\"]]\n";
  const Project bar = rod_under(false, "90 deg", "10.4 kN", aside);
  const double of_bar = 5000.0 * (550.0 / (50.0 * 1e4 / 6.0) + 25.0 / (100.0 * 2500.0 / 6.0));
  CHECK(rod_result(bar, run_situations(bar), Criterion::rod).check.resisting.value() ==
        Approx(5000.0 * 335.0 / (1.0 + of_bar)).epsilon(1e-6));
  const Project strut = rod_under(false, "-90 deg", "9.6 kN", aside);
  const NeighbourChecks checks = check_rods(strut, run_situations(strut));
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("may turn the open section over") != std::string::npos);
  // Plates of class 4 that bend: not computed.
  const std::string thin =
      "kind = \"box\"\nwidth = \"300 mm\"\nheight = \"300 mm\"\ntop_flange = \"20 mm\"\n"
      "bottom_flange = \"4 mm\"\nweb = \"4 mm\"\n";
  const Project slender = rod_under(false, "90 deg", "10.4 kN", thin);
  const NeighbourChecks none = check_rods(slender, run_situations(slender));
  REQUIRE(none.gates.size() == 1);
  CHECK(none.gates.front().blocks);
  CHECK(none.results.empty());
}

TEST_CASE("an angle bears the same however it is turned about its line", "[twisting]") {
  // Legs 100 x 6, the line through the heel: bent about its weak principal axis alone.
  const auto angle = [](double by) {
    ThinWalled of;
    const auto leg = [&](double at) {
      return paths::mm_place(100.0 * std::cos(at), 100.0 * std::sin(at));
    };
    const std::size_t heel = paths::add_node(of, paths::mm_place(0.0, 0.0));
    paths::add_wall(of, heel, paths::add_node(of, leg(by)), 6.0);
    paths::add_wall(of, heel, paths::add_node(of, leg(by + 0.5 * pi)), 6.0);
    return rod_under(false, "-90 deg", "2 kN", strut_of(of));
  };
  const Project by_principal = angle(-0.25 * pi), by_legs = angle(0.0);
  const double principal =
      buckling_of(by_principal, run_situations(by_principal)).check.resisting.value();
  const double legs = buckling_of(by_legs, run_situations(by_legs)).check.resisting.value();
  // Both moments add up by their sizes, on the safe side.
  CHECK(legs <= principal * (1.0 + 1e-6));
  CHECK(legs > 0.5 * principal);
}

TEST_CASE("a slender open strut by its effective area, and where its centroid moves",
          "[twisting]") {
  const double eps = std::sqrt(235.0 / 355.0);
  const auto outstand = [&](double c_over_t) {
    const double lambda = c_over_t / (28.4 * eps * std::sqrt(0.43));
    return lambda <= 0.748 ? 1.0 : (lambda - 0.188) / (lambda * lambda);
  };
  const auto internal = [&](double c_over_t) {
    const double lambda = c_over_t / (28.4 * eps * 2.0);
    return lambda <= 0.673 ? 1.0 : (lambda - 0.22) / (lambda * lambda);
  };
  SECTION("an I, which mirrors itself") {
    // Flanges 200 x 6, web 300 x 5: c/t = 97.5/6 and 60.
    const Project project =
        rod_under(false, "-90 deg", "9.6 kN", strut_of(paths::i_section(200.0, 6.0, 300.0, 5.0)));
    const NeighbourResult result = buckling_of(project, run_situations(project));
    const auto& rod = std::get<PressedRod>(result.basis);
    CHECK(rod.section.class_4);
    CHECK_FALSE(rod.beside);
    const double A_eff = 1e-6 * (2.0 * 6.0 * (5.0 + 2.0 * outstand(97.5 / 6.0) * 97.5) +
                                 5.0 * 300.0 * internal(60.0));
    CHECK(rod.section.effective.value() == Approx(A_eff).epsilon(1e-9));
    // Torsion: N_cr,T = (G I_T + pi^2 E I_w)/i_0^2 of 1 m.
    const double I_z = 2.0 * 0.006 * std::pow(0.2, 3) / 12.0 + 0.3 * std::pow(0.005, 3) / 12.0;
    CHECK(result.check.resisting.value() <= A_eff * 355e6);
    const double N_z = pi * pi * 210e9 * I_z;
    CHECK(compression_of(result).slenderness ==
          Approx(std::sqrt(A_eff * 355e6 / N_z)).epsilon(0.02));
  }
  SECTION("a channel, whose flanges lose their tips") {
    // Web 200 x 4, flanges 100 x 4: c/t = 49 and 24.5; centred on its whole section.
    const ChannelByHand hand{0.2, 0.1, 0.004};
    const ThinWalled channel = paths::channel(204.0, 100.0, 4.0, 4.0);
    const Project project =
        rod_under(false, "-90 deg", "9.6 kN", strut_of(channel, -1e3 * hand.centroid()));
    const NeighbourResult result = buckling_of(project, run_situations(project));
    const auto& rod = std::get<PressedRod>(result.basis);
    // Of flanges 98 mm beyond the web's face, of the web 196 between flanges.
    const double flange = 2.0 + outstand(98.0 / 4.0) * 98.0;
    const double idle_web = (1.0 - internal(196.0 / 4.0)) * 196.0;
    const double A_eff = 4.0 * (2.0 * flange + 200.0 - idle_web);
    CHECK(1e6 * rod.section.effective.value() == Approx(A_eff).epsilon(1e-3));
    const double moved = 4.0 * flange * flange / A_eff - 1e3 * hand.centroid();
    CHECK(moved < -2.0);
    REQUIRE(rod.beside);
    CHECK(1e3 * rod.beside->e_y.value() == Approx(-moved).epsilon(5e-3));
    CHECK(rod.beside->e_z == Length{});
    const double m = 1e-6 * A_eff * -1e-3 * moved / rod.beside->W_z.value();
    const double chi = compression_of(result).reduction;
    CHECK(result.check.resisting.value() ==
          Approx(std::min(chi / (1.0 + 1.6 * chi * m), 1.0 / (1.0 + m)) * 1e-6 * A_eff * 355e6)
              .epsilon(2e-3));
  }
  SECTION("longer struts and thinner walls bear less") {
    double before = 1e12;
    for (const double length : {1.0, 2.0, 4.0, 8.0}) {
      const Project project =
          rod_under(false, "-90 deg", "9.6 kN", strut_of(paths::i_section(200.0, 6.0, 300.0, 5.0)),
                    fmt::format("buckling_length = \"{} m\"\n", length));
      const double bears = buckling_of(project, run_situations(project)).check.resisting.value();
      CHECK(bears < before);
      before = bears;
    }
  }
}

TEST_CASE("a thin-walled strut around a small cell twists, too", "[twisting]") {
  // Fins 200 x 20 around a cell of 20 x 20 x 4: G I_T/i_0^2.
  ThinWalled cross{{paths::mm_place(10, 10), paths::mm_place(-10, 10), paths::mm_place(-10, -10),
                    paths::mm_place(10, -10), paths::mm_place(210, 10), paths::mm_place(-10, 210),
                    paths::mm_place(-210, -10), paths::mm_place(10, -210)},
                   {}};
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    paths::add_wall(cross, k, (k + 1) % 4, 4.0);
    paths::add_wall(cross, k, k + 4, 20.0);
  }
  const Project project = rod_under(false, "-90 deg", "9.6 kN", strut_of(cross));
  const NeighbourResult result = buckling_of(project, run_situations(project));
  const Section& section = project.rods.front().section;
  const SectionProperties p = properties_of(section);
  const double critical = 210e9 / 2.6 * torsion_properties_of(section).I_T->value() *
                          p.area.value() / (p.I_y + p.I_z).value();
  CHECK(compression_of(result).slenderness ==
        Approx(std::sqrt(p.area.value() * project.rods.front().yield_strength.value() / critical))
            .epsilon(1e-6));
}

TEST_CASE("a strut whose section cannot be judged stops the verdict; as a tie it may be checked") {
  // d/t = 600/2 = 300 is far above 90 eps^2 = 59.6.
  const std::string shell = "kind = \"round tube\"\ndiameter = \"600 mm\"\nwall = \"2 mm\"\n";
  const Project pressed = rod_under(false, "-90 deg", "0.1 kN", shell);
  const NeighbourChecks checks = check_rods(pressed, run_situations(pressed));
  CHECK(checks.results.empty());
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding.find("rod strut: round wall: d/t = 300") == 0);
  CHECK(verify(pressed).verdict == Verdict::not_applicable);
  const Project pulled = rod_under(false, "90 deg", "0.8 kN", shell);
  const NeighbourChecks tie = check_rods(pulled, run_situations(pulled));
  CHECK(tie.gates.empty());
  REQUIRE(tie.results.size() == 1);
  CHECK(tie.results.front().check.criterion == Criterion::rod);
}

TEST_CASE("what loads a rod beside its ends stops the verdict, for its bending is not counted") {
  const std::string bar = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"50 mm\"\n";
  const Project project =
      rod_under(false, "-90 deg", "1 kN", bar,
                "[forces.side]\nkind = \"couple\"\npoints = [\"rod.P\"]\nsize = \"1 N m\"\n");
  const NeighbourChecks checks = check_rods(project, run_situations(project));
  REQUIRE(checks.gates.size() == 1);
  CHECK(checks.gates.front().blocks);
  CHECK(checks.gates.front().finding ==
        "rod strut: side loads it beside its ends or turns it, and its bending is not counted");
}

TEST_CASE("a rod that turns is pulled most inside: the sum of its mass elements says how much") {
  // The upper rod as an even bar of 119 kg: the tension is summed from B in 4000 pieces, each with
  // the acceleration of its own middle.
  const Project project = read(rod_lines);
  const std::deque<SituationRun> runs = run_situations(project);
  const double found = rod_result(project, runs, Criterion::rod).check.acting.value();
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
