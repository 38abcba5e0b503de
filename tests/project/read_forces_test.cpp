#include <cmath>
#include <numbers>

#include "project/small_case.hpp"

namespace read_forces_test {

using namespace small_case;
using namespace boxbeam;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

template <class Kind>
Kind of_kind(const std::string& kind, const std::string& lines) {
  return force<Kind>("[forces.F]\nkind = \"" + kind + "\"\n" + lines);
}

double constant_of(const Driver& size) {
  REQUIRE(std::holds_alternative<PolynomialDriver>(size));
  REQUIRE(std::get<PolynomialDriver>(size).c.size() == 1);
  return std::get<PolynomialDriver>(size).c.front();
}

}  // namespace

TEST_CASE("a spring with and without damper, between bodies and to the ground") {
  const auto spring = of_kind<planar::Spring>(
      "spring",
      "connect = [\"arm.B\", \"rod.Q\"]\nstiffness = \"200 kN/m\"\nfree_length = \"300 mm\"\n"
      "damping = \"1.5 kN s/m\"\n");
  CHECK(at(spring.a, arm, 0.5, 0.0));
  CHECK(at(spring.b, rod, 1.5, 0.0));
  CHECK(spring.stiffness == Approx(200e3).epsilon(1e-14));
  CHECK(spring.free_length == Approx(0.3).epsilon(1e-14));
  CHECK(spring.damping == Approx(1500.0).epsilon(1e-14));
  const auto damper = of_kind<planar::Spring>(
      "spring",
      "connect = [\"arm.B\", \"ground\"]\nat = [\"1 m\", \"2 m\"]\nstiffness = \"0 N/m\"\n"
      "damping = \"1 N s/m\"\n");
  CHECK(at(damper.b, planar::ground, 1.0, 2.0));
  CHECK(damper.stiffness == 0.0);
  CHECK(damper.free_length == 0.0);
}

TEST_CASE("a cable, a stop, and a stop that parts again") {
  const std::string line =
      "connect = [\"arm.B\", \"rod.Q\"]\nstiffness = \"200 kN/m\"\nfree_length = \"300 mm\"\n";
  CHECK(of_kind<planar::Spring>("spring", line).acts == Acts::both);
  const auto cable = of_kind<planar::Spring>("spring", line + "acts = \"pulling\"\n");
  CHECK(cable.acts == Acts::pulling);
  CHECK_FALSE(cable.impact);
  const auto stop =
      of_kind<planar::Spring>("spring", line + "acts = \"pushing\"\nrestitution = 0.8\n");
  CHECK(stop.acts == Acts::pushing);
  REQUIRE(stop.impact);
  CHECK(stop.impact->restitution == 0.8);
  CHECK(stop.impact->exponent == 1.0);
  CHECK(stop.stiffness == Approx(200e3).epsilon(1e-14));
  // 200 kN/m at 0.1 mm are 20 N, as k (0.1 mm)^1.5 are.
  const auto round = of_kind<planar::Spring>(
      "spring", line +
                    "acts = \"pushing\"\nrestitution = 0.8\nexponent = 1.5\n"
                    "stiffness_at = \"0.1 mm\"\n");
  CHECK(round.stiffness * std::pow(1e-4, 1.5) == Approx(20.0).epsilon(1e-14));
}

TEST_CASE("what an impact does not say is asked for, and what it cannot be is refused") {
  struct Broken {
    std::string lines;
    const char *message, *hint;
  };
  const std::string spring =
      "[forces.F]\nkind = \"spring\"\nconnect = [\"arm.B\", \"rod.Q\"]\n"
      "free_length = \"300 mm\"\n";
  const std::string stiff = spring + "stiffness = \"200 kN/m\"\n";
  const std::string stop = stiff + "acts = \"pushing\"\n";
  for (const Broken& of : {
           Broken{stop + "restitution = 0.01\n", "goes from 0.05 to 1", "0.5 to 0.9"},
           Broken{stop + "restitution = 1.2\n", "goes from 0.05 to 1", "nothing is lost"},
           Broken{stop + "restitution = 0.8\nexponent = 2\n", "is 1 or 1.5", "leave it out"},
           Broken{stop + "restitution = 0.8\ndamping = \"1 N s/m\"\n", "said twice",
                  "write restitution, or damping"},
           Broken{stop + "restitution = 0.8\nstiffness_at = \"1 mm\"\n",
                  "the stiffness is that of any depth", "exponent = 1.5"},
           Broken{stop + "restitution = 0.8\nexponent = 1.5\n", "stiffness_at", ""},
           Broken{stop + "exponent = 1.5\n", "parts again after it touches", "restitution = 0.8"},
           Broken{stiff + "restitution = 0.8\n", "touches nothing", "acts = \"pushing\""},
       }) {
    CAPTURE(of.lines);
    const Problem problem = problem_of(pivot + of.lines + for_a_second);
    CHECK(contains(problem.message, of.message));
    CHECK(contains(problem.hint, of.hint));
  }
}

TEST_CASE("a torsion spring takes its radian written or left out") {
  const std::string points = "points = [\"arm.A\", \"rod.P\"]\nfree_angle = \"-45 deg\"\n";
  const auto written = of_kind<planar::TorsionSpring>(
      "torsion spring", points + "stiffness = \"5 kN m/rad\"\ndamping = \"20 N m s/rad\"\n");
  const auto left_out = of_kind<planar::TorsionSpring>(
      "torsion spring", points + "stiffness = \"5 kN m\"\ndamping = \"20 N m s\"\n");
  for (const auto& spring : {written, left_out}) {
    CHECK(at(spring.a, arm, -0.5, 0.0));
    CHECK(at(spring.b, rod, -0.5, 0.0));
    CHECK(spring.stiffness == Approx(5e3).epsilon(1e-14));
    CHECK(spring.free_angle == Approx(-45.0 * degree).epsilon(1e-14));
    CHECK(spring.damping == Approx(20.0).epsilon(1e-14));
  }
  const auto per_degree = of_kind<planar::TorsionSpring>(
      "torsion spring", "points = [\"arm.A\", \"ground\"]\nstiffness = \"1 N m/deg\"\n");
  CHECK(per_degree.stiffness == Approx(1.0 / degree).epsilon(1e-14));
  CHECK(per_degree.b.body == planar::ground);
  CHECK(per_degree.damping == 0.0);
}

TEST_CASE("a force of constant size or after a law") {
  const auto constant = of_kind<planar::PointForce>(
      "force", "point = \"arm.B\"\ndirection = \"-90 deg\"\nsize = \"10 kN\"\n");
  CHECK(at(constant.at, arm, 0.5, 0.0));
  CHECK(constant.direction == Approx(-90.0 * degree).epsilon(1e-14));
  CHECK_FALSE(constant.turns);
  CHECK(constant_of(constant.size) == Approx(10e3).epsilon(1e-14));

  const auto swinging = of_kind<planar::PointForce>(
      "force",
      "point = \"rod.Q\"\ndirection = \"0 deg\"\nturns_with_body = true\n"
      "law = { kind = \"harmonic\", mean = \"0 N\", amplitude = \"2 kN\", frequency = \"1 Hz\" "
      "}\n");
  CHECK(at(swinging.at, rod, 1.5, 0.0));
  CHECK(swinging.turns);
  REQUIRE(std::holds_alternative<HarmonicDriver>(swinging.size));
  CHECK(std::get<HarmonicDriver>(swinging.size).amplitude == Approx(2e3).epsilon(1e-14));

  const auto growing = of_kind<planar::PointForce>(
      "force",
      "point = \"rod.Q\"\ndirection = \"0 deg\"\n[forces.F.law]\nkind = \"constant rate\"\n"
      "start = \"1 N\"\nrate = \"2 kN/s\"\n");
  REQUIRE(std::holds_alternative<RateDriver>(growing.size));
  CHECK(std::get<RateDriver>(growing.size).rate == Approx(2e3).epsilon(1e-14));
}

TEST_CASE("a couple acts on one body, or between two") {
  const auto one = of_kind<planar::Couple>("couple", "points = [\"arm.A\"]\nsize = \"-2 kN m\"\n");
  CHECK(at(one.a, arm, -0.5, 0.0));
  CHECK(one.b.body == planar::ground);
  CHECK(constant_of(one.size) == Approx(-2e3).epsilon(1e-14));
  const auto same =
      of_kind<planar::Couple>("couple", "points = [\"arm.A\", \"ground\"]\nsize = \"1 N m\"\n");
  CHECK(same.b.body == planar::ground);
  const auto two = of_kind<planar::Couple>(
      "couple",
      "points = [\"arm.B\", \"rod.P\"]\n"
      "law = { kind = \"smooth step\", from = \"0 N m\", to = \"5 N m\", end = \"1 s\" }\n");
  CHECK(at(two.a, arm, 0.5, 0.0));
  CHECK(at(two.b, rod, -0.5, 0.0));
  REQUIRE(std::holds_alternative<StepDriver>(two.size));
  CHECK(std::get<StepDriver>(two.size).to == 5.0);
}

TEST_CASE("forces have names of their own") {
  const std::string push =
      "[forces.pivot]\nkind = \"couple\"\npoints = [\"arm.A\"]\nsize = \"1 N m\"\n";
  const Problem problem = problem_of(pivot + push + for_a_second);
  CHECK(contains(problem.message, "\"pivot\" is already the name of a joint"));
  CHECK(contains(problem.hint, "give the force another name"));
}

}  // namespace read_forces_test
