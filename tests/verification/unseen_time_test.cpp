// What lies outside the time that is looked at.

#include "boxbeam/verification/unseen_time.hpp"

#include <fmt/format.h>

#include <string>

#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace unseen_time_test {

using namespace boxbeam;

namespace {

enum class Kind { space, plane, frame };

/// A cantilever of 3 m under a force at its tip, looked at for so long.
std::string line_under(Kind kind, const std::string& law, const std::string& duration) {
  std::string text;
  const std::string force = "law = { " + law + " }\n";
  const std::string motion = duration.empty() ? "" : "[motion]\n" + duration;
  switch (kind) {
    case Kind::space:
      text =
          "kind = \"spatial\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
          "[bodies.b]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], D = [\"3 m\", \"0 m\", \"0 "
          "m\"] }\n[joints.A]\nkind = \"fixed\"\nconnect = [\"ground\", \"b.A\"]\nat = [\"0 "
          "m\", \"0 m\", \"0 m\"]\n[forces.F]\nkind = \"force\"\npoint = \"b.D\"\ndirection = "
          "\"-z\"\n" +
          force + "[beam]\nbody = \"b\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n";
      break;
    case Kind::plane:
      text =
          "kind = \"planar\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[bodies.b]\n"
          "points = { A = [\"0 m\", \"0 m\"], D = [\"3 m\", \"0 m\"] }\nsketch = { at = [\"0 "
          "m\", \"0 m\"], angle = \"0 deg\" }\n[joints.A]\nkind = \"rigid\"\nconnect = "
          "[\"b.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n[forces.F]\nkind = \"force\"\npoint = "
          "\"b.D\"\ndirection = \"-90 deg\"\n" +
          force + "[beam]\nbody = \"b\"\n";
      break;
    case Kind::frame:
      text =
          "kind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[supports.A]\nkind "
          "= \"fixed\"\nat = \"0 m\"\n[loads.F]\nkind = \"driven\"\nat = \"3 m\"\ndirection = "
          "\"-90 deg\"\n" +
          force + "[beam]\n";
      break;
  }
  const Project project = parse_project(
      "time.toml",
      "[case]\nname = \"time\"\n" + text +
          "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"3 m\"\nsection = \"s\"\n"
          "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"3 m\"\ninto = \"webs\"\n"
          "[sections.s]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"150 mm\"\nflange = \"8 "
          "mm\"\nweb = \"8 mm\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" +
          motion);
  return verdict_text_of(project, verify(project)).line;
}

std::string lasting(double seconds) { return fmt::format("duration = \"{} s\"\n", seconds); }

std::string harmonic(double hertz) {
  return fmt::format(
      "kind = \"harmonic\", mean = \"0 kN\", amplitude = \"10 kN\", frequency = \"{} Hz\"", hertz);
}

}  // namespace

TEST_CASE("a period that is longer than the time looked at is said, in every kind") {
  for (const Kind kind : {Kind::space, Kind::plane, Kind::frame}) {
    CAPTURE(static_cast<int>(kind));
    // By hand: 1/0.05 Hz = 20 s.
    CHECK_THAT(line_under(kind, harmonic(0.05), lasting(1.0)),
               Catch::Contains("the motion: 1 s of the period of F, 20 s, are looked at"));
    // Invariant: what repeats has nothing new behind its period.
    CHECK_THAT(line_under(kind, harmonic(0.05), lasting(20.0)), !Catch::Contains("the motion:"));
    CHECK_THAT(line_under(kind, harmonic(0.05), lasting(27.0)), !Catch::Contains("the motion:"));
    CHECK_THAT(line_under(kind, harmonic(0.05), ""), !Catch::Contains("the motion:"));
  }
}

TEST_CASE("a step that ends behind the time looked at is said") {
  const std::string step =
      "kind = \"smooth step\", from = \"0 kN\", to = \"10 kN\", begin = \"1 s\", end = \"10 s\"";
  for (const Kind kind : {Kind::space, Kind::plane, Kind::frame}) {
    CAPTURE(static_cast<int>(kind));
    CHECK_THAT(line_under(kind, step, lasting(5.0)),
               Catch::Contains("F goes on to 10 s, and 5 s are looked at"));
    CHECK_THAT(line_under(kind, step, lasting(10.0)), !Catch::Contains("the motion:"));
  }
}

TEST_CASE("a rate and a polynomial that still grow at the last instant say so") {
  const std::string rate = "kind = \"constant rate\", start = \"0 kN\", rate = \"3 kN/s\"";
  const std::string polynomial =
      "kind = \"polynomial\", coefficients = [\"1 kN\", \"0 kN/s\", \"1 kN/s^2\"]";
  // 10 kN - 1 kN/s t: the largest stands at the beginning.
  const std::string falling = "kind = \"constant rate\", start = \"10 kN\", rate = \"-1 kN/s\"";
  for (const Kind kind : {Kind::space, Kind::plane, Kind::frame}) {
    CAPTURE(static_cast<int>(kind));
    CHECK_THAT(line_under(kind, rate, lasting(5.0)), Catch::Contains("its last instant, 5 s"));
    CHECK_THAT(line_under(kind, polynomial, lasting(3.0)),
               Catch::Contains("its last instant, 3 s"));
    CHECK_THAT(line_under(kind, falling, lasting(5.0)), !Catch::Contains("last instant"));
  }
}

TEST_CASE("a part of a turn has not all ranges of it") {
  // An arm of 3 m that turns about one end once a second: its weight bends it to both sides.
  const auto line_of = [](const char* duration, const char* fatigue) {
    const Project project = parse_project(
        "turn.toml",
        std::string("[case]\nname = \"turn\"\nkind = \"planar\"\n[mechanism]\ngravity = [\"0 "
                    "m/s^2\", \"-9.81 m/s^2\"]\n[bodies.b]\npoints = { A = [\"0 m\", \"0 m\"], D "
                    "= [\"3 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"], angle = \"0 "
                    "deg\" }\n[joints.A]\nkind = \"pin\"\nconnect = [\"b.A\", \"ground\"]\nat = "
                    "[\"0 m\", \"0 m\"]\n[drivers.turn]\npoint = \"b.D\"\ncoordinate = "
                    "\"angle\"\nkind = \"constant rate\"\nstart = \"0 deg\"\nrate = \"360 "
                    "deg/s\"\n[motion]\nduration = \"") +
            duration +
            "\"\n[sections.s]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"150 mm\"\nflange = "
            "\"8 mm\"\nweb = \"8 mm\"\n[beam]\nbody = \"b\"\ndensity = \"7850 kg/m^3\"\n"
            "[[beam.segments]]\nlength = \"3 m\"\nsection = \"s\"\n[[beam.load_introductions]]\n"
            "from = \"0 m\"\nto = \"3 m\"\ninto = \"webs\"\n[material]\nsteel = \"S355\"\n"
            "[strength]\nrequired = 1.0\n" +
            fatigue);
    return verdict_text_of(project, verify(project)).line;
  };
  const char* const asked =
      "[fatigue]\ncategory = 71\ncycles = 1e5\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = "
      "1.0\n";
  CHECK_THAT(line_of("0.4 s", asked),
             Catch::Contains("0.4 s of the period of turn, 1 s, are looked at"));
  CHECK_THAT(line_of("1 s", asked), !Catch::Contains("the motion:"));
  // Of strength alone it may be all of a slewing.
  CHECK_THAT(line_of("0.4 s", ""), !Catch::Contains("the period of"));
}

TEST_CASE("what happens while a motion settles is not looked at, and said") {
  const std::string step =
      "kind = \"smooth step\", from = \"0 kN\", to = \"10 kN\", begin = \"0 s\", end = \"2 s\"";
  CHECK_THAT(line_under(Kind::plane, step, "settle = \"1 s\"\n" + lasting(3.0)),
             Catch::Contains("the motion: what happens before 1 s is not looked at"));
  CHECK_THAT(line_under(Kind::plane, step, lasting(4.0)), !Catch::Contains("settle"));
  // What only repeats is the same before.
  CHECK_THAT(line_under(Kind::plane, harmonic(1.0), "settle = \"0.3 s\"\n" + lasting(1.7)),
             !Catch::Contains("settle"));
}

}  // namespace unseen_time_test
