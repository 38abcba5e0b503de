// Pins and rods of mechanisms in space, against statics by hand, the closed form of a rod that
// turns, and the same mechanism in the plane.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/box_boom.hpp"

namespace spatial_neighbours_test {

using namespace boxbeam;
using test::box_boom::boom;
using test::box_boom::hinged;

namespace {

constexpr double g = 9.81;

/// A boom under a force at its end that swings between 10 and 30 kN, and what holds it.
std::string strutted(const std::string& by, const std::string& more) {
  return boom(
      hinged + by,
      "direction = [0, 0, -1]\nlaw = { kind = \"harmonic\", mean = \"20 kN\", amplitude = "
      "\"10 kN\", frequency = \"1 Hz\" }\n",
      "[sections.tube]\nkind = \"round tube\"\ndiameter = \"114.3 mm\"\nwall = \"10 mm\"\n" + more);
}

const std::string linked_rod = R"(
[[rods]]
name = "strut"
link = "strut"
section = "tube"
curve = "a"
)";

std::string pin_in(const std::string& joint) {
  return fmt::format(
      "\n[[pins]]\nname = \"pin\"\njoint = \"{}\"\ndiameter = \"60 mm\"\ninner_plate = \"40 "
      "mm\"\nouter_plate = \"25 mm\"\ngap = \"2 mm\"\n",
      joint);
}

Project read(const std::string& text) { return parse_project("arm.toml", text); }

const NeighbourResult& of(const NeighbourChecks& checks, Criterion criterion) {
  for (const NeighbourResult& result : checks.results)
    if (result.check.criterion == criterion) return result;
  throw std::runtime_error(std::string("no check of ") + to_text(criterion));
}

}  // namespace

TEST_CASE("space: a strut that is a joint bears what statics says, and buckles as a rod does") {
  // The beam's weight and the load about its hinge, over the lever of the strut, 2 m / sqrt(2).
  const Project project = read(strutted(test::box_boom::strut, linked_rod));
  const std::deque<SituationRun> runs = run_situations(project);
  const NeighbourChecks checks = check_rods(project, runs);
  const double force = 30e3 * 4.0 / (2.0 / std::numbers::sqrt2);
  const NeighbourResult& buckling = of(checks, Criterion::buckling);
  CHECK(buckling.check.acting.value() == Approx(force).epsilon(1e-9));
  const PressedRod& rod = std::get<PressedRod>(buckling.basis);
  CHECK(rod.buckling_length.value() == Approx(std::sqrt(8.0)));
  CHECK(buckling.check.safety_factor ==
        Approx(compression_resistance_of(rod).least.value() / force));
  CHECK(std::none_of(checks.results.begin(), checks.results.end(), [](const NeighbourResult& one) {
    return one.check.criterion == Criterion::rod;
  }));
  CHECK(checks.gates.empty());
}

TEST_CASE("space: a spring is a rod whose length changes") {
  const std::string spring =
      "\n[forces.strut]\nkind = \"spring\"\nconnect = [\"ground\", \"arm.lug\"]\nat = [\"0 m\", "
      "\"0 m\", \"-2 m\"]\nstiffness = \"9000 kN/m\"\nfree_length = \"2.83 m\"\n";
  const std::string driven =
      "\n[drivers.still]\njoint = \"heel\"\nkind = \"hold\"\nvalue = \"0 deg\"\n";
  const std::string rod =
      "\n[[rods]]\nname = \"strut\"\nlink = \"strut\"\nsection = \"tube\"\ncurve = "
      "\"a\"\nbuckling_length = "
      "\"2.85 m\"\n";
  const Project project = read(strutted(spring + driven, rod));
  const NeighbourChecks checks = check_rods(project, run_situations(project));
  // The beam stands still: the spring is pressed by what it is shorter than it would be.
  const double force = 9e6 * (2.83 - std::sqrt(8.0));
  CHECK(of(checks, Criterion::buckling).check.acting.value() == Approx(force).epsilon(1e-9));
  try {
    read(strutted(
        spring + driven,
        "\n[[rods]]\nname = \"strut\"\nlink = \"strut\"\nsection = \"tube\"\ncurve = \"a\"\n"));
    FAIL("its length is not known");
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Catch::Contains("the length of the rod changes"));
  }
  try {
    read(strutted(spring + driven, rod + "from = \"arm.heel\"\nto = \"arm.lug\"\n"));
    FAIL("it is two things");
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Catch::Contains("a rod is a link or lies between two points"));
  }
}

TEST_CASE("space: a pin bears what its joint does across it") {
  // Of the hinge: the strut's force less the load, along x and z.
  const double strut = 30e3 * 4.0 / std::numbers::sqrt2 * 1.0;
  const double x = strut / std::numbers::sqrt2, z = strut / std::numbers::sqrt2 - 30e3;
  const Project project = read(strutted(test::box_boom::strut, pin_in("heel")));
  const NeighbourChecks checks = check_pins(project, run_situations(project));
  CHECK(of(checks, Criterion::pin).check.acting.value() == Approx(std::hypot(x, z)).epsilon(1e-9));
  CHECK(checks.gates.empty());
  REQUIRE(checks.not_judged.size() == 1);
  CHECK(checks.not_judged.front().reason == "[[pins.lugs]] are not given");

  SECTION("in the joint that the strut is, all of its force") {
    const Project at_strut = read(strutted(test::box_boom::strut, pin_in("strut")));
    const NeighbourChecks found = check_pins(at_strut, run_situations(at_strut));
    CHECK(of(found, Criterion::pin).check.acting.value() == Approx(strut).epsilon(1e-9));
  }
}

TEST_CASE("space: a moment across a pin, and a force along it, are said") {
  // 30 kN along the pin, at 4 m from it: as much along it, and 120 kN m across.
  std::string text = strutted(test::box_boom::strut, pin_in("heel"));
  const std::string down = "direction = [0, 0, -1]";
  text.replace(text.find(down), down.size(), "direction = [0, 1, -1]");
  const Project project = read(text);
  const NeighbourChecks checks = check_pins(project, run_situations(project));
  REQUIRE(checks.gates.size() == 1);
  const double along = 30.0 / std::numbers::sqrt2;
  CHECK_THAT(checks.gates.front().finding,
             Catch::Contains(fmt::format("moment of {:.3g} kN m across the pin", 4.0 * along)));
  REQUIRE(checks.not_judged.size() == 2);
  CHECK_THAT(checks.not_judged.front().reason,
             Catch::Contains(fmt::format("{:.3g} kN along it", along)));
}

TEST_CASE("space: a rod that is a body bears its own centrifugal force, about any axis") {
  // Turned at 30 rad/s about its end, 2 m of 40 kg: m omega^2 L/2 there. What holds its other end
  // is a spring without force.
  const std::string axis = GENERATE(as<std::string>{}, "\"z\"", "[0, 0.6, 0.8]");
  const std::string rod = fmt::format(R"(
[bodies.bar]
mass = "40 kg"
centre = ["1 m", "0 m", "0 m"]
inertia = ["0.01 kg m^2", "13.333333333 kg m^2", "13.333333333 kg m^2"]
points = {{ a = ["0 m", "0 m", "0 m"], b = ["2 m", "0 m", "0 m"] }}

[joints.turn]
kind = "revolute"
connect = ["ground", "bar.a"]
at = ["0 m", "5 m", "0 m"]
axis = {}

[drivers.turning]
joint = "turn"
kind = "constant rate"
start = "0 rad"
rate = "30 rad/s"

[motion]
duration = "1 s"

[forces.none]
kind = "spring"
connect = ["ground", "bar.b"]
at = ["0 m", "5 m", "3 m"]
stiffness = "1e-9 N/m"
free_length = "1 m"
)",
                                      axis);
  const std::string checked =
      "\n[[rods]]\nname = \"bar\"\nfrom = \"bar.a\"\nto = \"bar.b\"\nsection = \"tube\"\ncurve = "
      "\"a\"\n";
  const Project project = read(strutted(test::box_boom::strut + rod, checked));
  const NeighbourChecks checks = check_rods(project, run_situations(project));
  CHECK(of(checks, Criterion::rod).check.acting.value() ==
        Approx(40.0 * 900.0 * 2.0 / 2.0).epsilon(1e-6));
}

TEST_CASE("space: a rod that a couple turns is not judged, one that is only pressed is") {
  // The strut as a body of 60 kg between two places: hinged below, its upper end free along y, so
  // that nothing holds it twice.
  const auto strut = [](const std::string& weight) {
    return fmt::format(R"(
[bodies.bar]
mass = "60 kg"
centre = ["1.4142135623730951 m", "0 m", "0 m"]
inertia = ["0.1 kg m^2", "40 kg m^2", "40 kg m^2"]
points = {{ a = ["0 m", "0 m", "0 m"], b = ["2.8284271247461903 m", "0 m", "0 m"] }}

[joints.foot]
kind = "revolute"
connect = ["ground", "bar.a"]
at = ["0 m", "0 m", "-2 m"]
axis = "-y"
start = "45 deg"

[joints.head]
kind = "slot"
connect = ["arm.lug", "bar.b"]
axis = "y"

{})",
                       weight);
  };
  const std::string rod =
      "\n[[rods]]\nname = \"bar\"\nfrom = \"bar.a\"\nto = \"bar.b\"\nsection = \"tube\"\ncurve = "
      "\"a\"\n";
  const Project even = read(strutted(strut(""), rod));
  const NeighbourChecks checks = check_rods(even, run_situations(even));
  CHECK(checks.gates.empty());
  const double force = 30e3 * 4.0 / std::numbers::sqrt2;
  CHECK(of(checks, Criterion::buckling).check.acting.value() == Approx(force).epsilon(1e-9));

  SECTION("a couple on it bends it") {
    const Project bent = read(strutted(strut("[forces.twist]\nkind = \"couple\"\npoint = "
                                             "\"bar.a\"\ndirection = \"y\"\nsize = \"9 kN "
                                             "m\"\n"),
                                       rod));
    const NeighbourChecks found = check_rods(bent, run_situations(bent));
    REQUIRE(found.gates.size() == 1);
    CHECK_THAT(found.gates.front().finding, Catch::Contains("rod bar: twist loads it"));
  }
}

TEST_CASE("space: the plates of a pin in fatigue are those of the same mechanism in the plane") {
  const std::string lugs =
      "\n[[pins.lugs]]\nplate = \"inner\"\nwidth = \"200 mm\"\nend = \"90 mm\"\n"
      "\n[fatigue]\ncategory = 71\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired "
      "= 1.0\n";
  const Project project = read(strutted(test::box_boom::strut, pin_in("heel") + lugs));
  const NeighbourChecks checks = check_lugs(project, run_situations(project));
  // The hinge's force is proportional to the load: its range is two thirds of its largest.
  const double strut = 30e3 * 4.0 / std::numbers::sqrt2;
  const double largest =
      std::hypot(strut / std::numbers::sqrt2, strut / std::numbers::sqrt2 - 30e3);
  const NeighbourResult& lug = of(checks, Criterion::lug_fatigue);
  CHECK(std::get<TiredLug>(lug.basis).range.value() == Approx(largest * 2.0 / 3.0).epsilon(1e-6));
}

}  // namespace spatial_neighbours_test
