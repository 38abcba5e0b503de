// What files of loads and motions leave open, and what is made of the columns that they have.

#include "boxbeam/verification/recorded_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace recorded_notes_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

/// A cantilever of 4 m under files, held at its start.
Project beam(const test::TemporaryFolder& folder, const std::string& loads) {
  return read_project(folder.write(
      "case.toml",
      "[case]\nname = \"given\"\nkind = \"loads\"\n[files.a]\npath = \"a.csv\"\n"
      "[sections.s]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"180 mm\"\nflange = \"12 "
      "mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 "
      "m\"\nsection = \"s\"\n[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"4 m\"\ninto = "
      "\"webs\"\n[balance]\nstation = \"0 m\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired "
      "= 1.0\nshear_lag = false\n" +
          loads));
}

/// Swinging about its start by 0.5 rad, 1.75 times a second, as sensor and path give it.
std::string swinging(int per_wave) {
  std::string file =
      "time [s], ax [m/s^2], az [m/s^2], w [rad/s], dw [rad/s^2], x [m], z [m], a [rad]\n";
  const double omega = 2.0 * pi * 1.75;
  for (int i = 0; i <= 4 * per_wave; ++i) {
    const double t = i / (1.75 * per_wave), angle = 0.5 * std::sin(omega * t);
    file += fmt::format("{}, {}, {}, {}, {}, 0, 0, {}\n", t, 9.81 * std::sin(angle),
                        9.81 * std::cos(angle), -0.5 * omega * std::cos(omega * t),
                        0.5 * omega * omega * std::sin(omega * t), angle);
  }
  return file;
}

const std::string still = "[loads.none]\nstation = \"4 m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\n";

struct Judged {
  std::string line;
  double yield = 0.0;
};

Judged judged(const Project& project) {
  const Verification of = verify(project);
  return {verdict_text_of(project, of).line, of.governing(Criterion::yield)->check.utilisation()};
}

Judged moved_by(const std::string& columns, int per_wave) {
  const test::TemporaryFolder folder;
  folder.write("a.csv", swinging(per_wave));
  return judged(beam(folder, still + "[motion]\ncolumns = { " + columns + " }\n"));
}

}  // namespace

TEST_CASE("a rate of turning has the angular acceleration that it has", "[recorded]") {
  // Invariant: the column left out is the derivative of the one that stands.
  const Judged all = moved_by("a_x = \"ax\", a_z = \"az\", omega_y = \"w\", alpha_y = \"dw\"", 400);
  const Judged rate = moved_by("a_x = \"ax\", a_z = \"az\", omega_y = \"w\"", 400);
  CHECK(rate.yield == Approx(all.yield).epsilon(1e-4));
  CHECK_THAT(rate.line, !Catch::Contains("motion"));
  // By hand at the turning point, 0.5 rad: alpha = 0.5 (2 pi 1.75)^2 = 60.45 1/s^2, M = m L/2 g
  // cos(0.5) + m L^2/3 alpha; m = 53.13 kg/m x 4 m.
  const double A = 0.15 * 0.18 - 0.13 * 0.156, m = 7850.0 * A * 4.0;
  const double W = (0.15 * std::pow(0.18, 3) - 0.13 * std::pow(0.156, 3)) / 12.0 / 0.09;
  const double alpha = 0.5 * std::pow(2.0 * pi * 1.75, 2);
  const double M = m * 2.0 * 9.81 * std::cos(0.5) + m * 16.0 / 3.0 * alpha;
  CHECK(rate.yield == Approx(M / W / 355e6).epsilon(0.01));
}

TEST_CASE("a motion that does not say how the beam turns says so", "[recorded]") {
  const char* const word = "how it turns is not in it: give omega_y";
  CHECK_THAT(moved_by("a_z = \"az\"", 100).line, Catch::Contains(word));
  CHECK_THAT(moved_by("a_x = \"ax\", a_z = \"az\", alpha_y = \"dw\"", 100).line,
             Catch::Contains(word));
  CHECK_THAT(moved_by("a_z = \"az\", omega_y = \"w\"", 100).line, !Catch::Contains("turns"));
}

TEST_CASE("a path in few instants keeps its acceleration, or says what may be missing",
          "[recorded]") {
  const std::string path = "x = \"x\", z = \"z\", angle = \"a\"";
  const Judged fine = moved_by(path, 400);
  CHECK_THAT(fine.line, !Catch::Contains("motion"));
  // Twelve instants to a wave, peaks among them: 0.9992 by five instants, 0.977 by three.
  const Judged coarse = moved_by(path, 12);
  CHECK(coarse.yield == Approx(fine.yield).epsilon(2e-3));
  // The centripetal part has two waves to each of the angle, so that 16 give it eight.
  CHECK_THAT(moved_by(path, 16).line, Catch::Contains("accelerations have 8 instants to a wave"));
  CHECK_THAT(moved_by(path, 24).line, !Catch::Contains("instants to a wave"));
}

TEST_CASE("a gap in a record is said", "[recorded]") {
  const auto line_with = [](double gap, double back, double unlike = 0.0) {
    const test::TemporaryFolder folder;
    std::string file = "time [s], F [kN]\n";
    for (int i = 0; i <= 400; ++i) {
      const double t = 0.01 * (i + unlike * (i % 2));
      file += fmt::format("{}, {}\n", i < 200 ? t : t + gap,
                          i == 200 ? back : 10.0 * std::sin(2.0 * pi * t));
    }
    folder.write("a.csv", file);
    return judged(beam(folder, "[loads.f]\nstation = \"4 m\"\ncolumns = { F_z = \"F\" }\n")).line;
  };
  const double before = 10.0 * std::sin(2.0 * pi * 1.99);
  CHECK_THAT(line_with(498.0, 0.0),
             Catch::Contains("no instants between 1.99 and 500 s, 4.98e+04 of its usual steps"));
  CHECK_THAT(line_with(0.0, 0.0), !Catch::Contains("no instants"));
  // Where all other steps are alike a tenth of a second is lost, else it may be a long step.
  CHECK_THAT(line_with(0.5, 0.0), Catch::Contains("no instants between 1.99 and 2.5 s, 51 of its"));
  CHECK_THAT(line_with(0.08, 0.0), !Catch::Contains("no instants"));
  CHECK_THAT(line_with(0.5, 0.0, 0.3), !Catch::Contains("no instants"));
  // At rest nothing is missing between two instants.
  CHECK_THAT(line_with(498.0, before), !Catch::Contains("no instants"));
}

}  // namespace recorded_notes_test
