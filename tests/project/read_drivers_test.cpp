#include <cmath>
#include <numbers>

#include "project/small_case.hpp"

namespace read_drivers_test {

using namespace small_case;
using namespace boxbeam;
using planar::Coordinate;
using planar::Driven;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

Driven driven(const std::string& lines) { return joint<Driven>("[drivers.X]\n" + lines); }

const std::string angle = "point = \"arm.A\"\ncoordinate = \"angle\"\n";
const std::string x = "point = \"arm.B\"\ncoordinate = \"x\"\n";

template <class Function>
Function function(const std::string& lines) {
  const Driver driver = driven(lines).driver;
  REQUIRE(std::holds_alternative<Function>(driver));
  return std::get<Function>(driver);
}

}  // namespace

TEST_CASE("what is driven: a point, an angle, an angle between bodies, a length") {
  const std::string rate = "kind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"6 rpm\"\n";
  const std::string stroke = "kind = \"constant rate\"\nstart = \"1 m\"\nrate = \"0.1 m/s\"\n";
  const Driven on_x = driven(stroke + x);
  CHECK(on_x.coordinate == Coordinate::x);
  CHECK(at(on_x.point, arm, 0.5, 0.0));
  CHECK(on_x.other.body == planar::ground);
  CHECK(driven(stroke + "point = \"arm.B\"\ncoordinate = \"y\"\n").coordinate == Coordinate::y);

  const Driven turned = driven(rate + angle);
  CHECK(turned.coordinate == Coordinate::angle);
  CHECK(turned.other.body == planar::ground);

  const Driven relative =
      driven(rate + "coordinate = \"relative angle\"\npoints = [\"rod.P\", \"arm.B\"]\n");
  CHECK(relative.coordinate == Coordinate::angle);
  CHECK(at(relative.point, rod, -0.5, 0.0));
  CHECK(at(relative.other, arm, 0.5, 0.0));

  const Driven cylinder =
      driven(stroke + "coordinate = \"length\"\npoints = [\"rod.Q\", \"arm.B\"]\n");
  CHECK(cylinder.coordinate == Coordinate::length);
  CHECK(at(cylinder.point, rod, 1.5, 0.0));
  CHECK(at(cylinder.other, arm, 0.5, 0.0));
  // A length has no sense: the point on a body comes first.
  const Driven to_ground = driven(
      stroke +
      "coordinate = \"length\"\npoints = [\"ground\", \"arm.B\"]\nat = [\"2 m\", \"1 m\"]\n");
  CHECK(at(to_ground.point, arm, 0.5, 0.0));
  CHECK(at(to_ground.other, planar::ground, 2.0, 1.0));
}

TEST_CASE("a harmonic with further ones, written below or inline") {
  const std::string first =
      "kind = \"harmonic\"\nmean = \"10 deg\"\namplitude = \"5 deg\"\nfrequency = \"0.5 Hz\"\n"
      "phase = \"90 deg\"\n" +
      angle;
  const auto plain = function<HarmonicDriver>(first);
  CHECK(plain.mean == Approx(10.0 * degree).epsilon(1e-14));
  CHECK(plain.amplitude == Approx(5.0 * degree).epsilon(1e-14));
  CHECK(plain.omega == Approx(pi).epsilon(1e-14));
  CHECK(plain.phase == Approx(pi / 2.0).epsilon(1e-14));
  CHECK(plain.further.empty());

  const std::string rows =
      "[[drivers.X.further]]\namplitude = \"1 deg\"\nfrequency = \"1 Hz\"\n"
      "[[drivers.X.further]]\namplitude = \"2 deg\"\nangular_frequency = \"3 rad/s\"\n"
      "phase = \"1 rad\"\n";
  const std::string inlined =
      "further = [{ amplitude = \"1 deg\", frequency = \"1 Hz\" }, { amplitude = \"2 deg\", "
      "angular_frequency = \"3 rad/s\", phase = \"1 rad\" }]\n";
  for (const std::string& more : {rows, inlined}) {
    const auto summed = function<HarmonicDriver>(first + more);
    REQUIRE(summed.further.size() == 2);
    CHECK(summed.further[0].amplitude == Approx(degree).epsilon(1e-14));
    CHECK(summed.further[0].omega == Approx(2.0 * pi).epsilon(1e-14));
    CHECK(summed.further[0].phase == 0.0);
    CHECK(summed.further[1].omega == 3.0);
    CHECK(summed.further[1].phase == 1.0);
  }
}

TEST_CASE("an amplitude of zero is a driver where a further harmonic moves it") {
  const std::string still =
      "kind = \"harmonic\"\nmean = \"0 m\"\namplitude = \"0 m\"\nfrequency = \"1 Hz\"\n" + x;
  const std::string more = "further = [{ amplitude = \"1 m\", frequency = \"2 Hz\" }]\n";
  CHECK(function<HarmonicDriver>(still + more).further.size() == 1);
  CHECK(contains(problem_of(pivot + "[drivers.X]\n" + still + for_a_second).message,
                 "does not move"));
}

TEST_CASE("constant rate, polynomial and smooth step") {
  const auto rate = function<RateDriver>(
      "kind = \"constant rate\"\nstart = \"90 deg\"\nrate = \"-30 rpm\"\n" + angle);
  CHECK(rate.start == Approx(pi / 2.0).epsilon(1e-14));
  CHECK(rate.rate == Approx(-pi).epsilon(1e-14));

  const auto polynomial = function<PolynomialDriver>(
      "kind = \"polynomial\"\ncoefficients = [\"1 mm\", \"2 mm/s\", \"3 mm/s^2\", \"4 mm/s^3\"]\n" +
      x);
  REQUIRE(polynomial.c.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(polynomial.c[k] == Approx(0.001 * static_cast<double>(k + 1)).epsilon(1e-14));
  }

  const auto step = function<StepDriver>(
      "kind = \"smooth step\"\nfrom = \"10 mm\"\nto = \"-10 mm\"\nend = \"500 ms\"\n" + x);
  CHECK(step.from == Approx(0.01).epsilon(1e-14));
  CHECK(step.to == Approx(-0.01).epsilon(1e-14));
  CHECK(step.begin == 0.0);
  CHECK(step.end == Approx(0.5).epsilon(1e-14));
}

namespace {

/// The rest of a mechanism that is determined: what no driver moves is held.
const std::string held =
    pivot +
    "[joints.rod]\nkind = \"rigid\"\nconnect = [\"rod.P\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
    "[joints.wheel]\nkind = \"rigid\"\nconnect = [\"wheel.C\", \"ground\"]\nat = [\"0 m\", \"0 "
    "m\"]\n";

std::string turning(const std::string& name, const std::string& frequency) {
  return "[drivers." + name + "]\nkind = \"harmonic\"\nmean = \"0 deg\"\namplitude = \"1 deg\"\n" +
         "frequency = \"" + frequency + "\"\n" + angle;
}

}  // namespace

TEST_CASE("drivers of one common period need no duration, others do") {
  CHECK_NOTHROW(read(held + turning("a", "0.7 Hz")));
  CHECK_NOTHROW(read(held + turning("a", "0.7 Hz") + turning("b", "1.4 Hz")));
  CHECK_NOTHROW(read(held + turning("a", "0.7 Hz") + turning("b", "0.8 Hz")));
  const std::string apart = held + turning("a", "0.7 Hz") + turning("b", "0.71234 Hz");
  const Problem problem = problem_of(apart);
  CHECK(contains(problem.message, "no common period"));
  CHECK(contains(problem.hint, "a whole number of cycles"));
  CHECK(contains(problem.hint, "[motion] with duration"));
  CHECK_NOTHROW(read(apart + for_a_second));
}

TEST_CASE("a driver that does not repeat ends, or wants a duration") {
  // A turn at constant rate repeats, a length at constant rate does not.
  const std::string turn =
      "[drivers.X]\nkind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"6 rpm\"\n" + angle;
  CHECK_NOTHROW(read(held + turn));
  const std::string away =
      "[drivers.X]\nkind = \"constant rate\"\nstart = \"0 m\"\nrate = \"0.1 m/s\"\n" + x;
  const Problem problem = problem_of(held + away);
  CHECK(contains(problem.message, "\"X\" neither repeats nor ends"));
  CHECK(contains(problem.hint, "[motion] with duration"));
  CHECK_NOTHROW(read(held + away + for_a_second));
  const std::string step =
      "[drivers.Y]\nkind = \"smooth step\"\nfrom = \"0 m\"\nto = \"1 m\"\nend = \"2 s\"\n" + x;
  CHECK_NOTHROW(read(held + step));
  CHECK(contains(problem_of(held + step + away).message, "\"X\" neither repeats nor ends"));
}

TEST_CASE("nothing drives a mechanism without drivers, but a force over a duration may") {
  const std::string free = held;
  CHECK(contains(problem_of(free).message, "nothing drives the mechanism"));
  CHECK_NOTHROW(read(free + for_a_second));
}

}  // namespace read_drivers_test
