// A sudden start is looked at until its peak has been: of the load, and of what vibrates.

#include "boxbeam/verification/sudden_start.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace sudden_start_test {

using namespace boxbeam;

namespace {

constexpr double length = 3.0, side = 0.150, wall = 0.008;  // [m]

/// A cantilever under a force across its tip.
double use_of(double force, double frequency, double damping, bool sudden,
              const std::string& more = "") {
  const Verification of = verify(parse_project(
      "start.toml",
      fmt::format("[case]\nname = \"start\"\nkind = \"flexible\"\n[mechanism]\ngravity = [\"0 "
                  "m/s^2\", \"0 m/s^2\"]\n[motion]\nfrequency = \"{0} Hz\"\n[model]\ndamping = {{ "
                  "ratio = {1}, at = \"{0} Hz\" }}\n[links.boom]\nkind = \"bending\"\norigin = "
                  "[\"0 m\", \"0 m\"]\nangle = \"0 deg\"\nparts = 8\n[joints.foot]\nkind = "
                  "\"revolute\"\nconnect = [\"boom.start\", \"ground\"]\nstiffness = "
                  "\"rigid\"\nturning_stiffness = \"rigid\"\n[loads.s]\non = "
                  "\"boom.end\"\namplitude_force = [\"0 N\", \"{2} N\"]\nforce = [\"0 N\", \"0 "
                  "N\"]\n",
                  frequency, damping, force) +
          more +
          fmt::format("[sections.s]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"150 "
                      "mm\"\nflange = \"8 mm\"\nweb = \"8 mm\"\n[beam]\nlink = "
                      "\"boom\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"3 "
                      "m\"\nsection = \"s\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired "
                      "= 1.0\n[[situations]]\nname = \"s\"\nsudden_start = {}\n",
                      sudden)));
  return pressed_beams::use_of(of, Criterion::yield);
}

/// Largest bending stress by statics, over f_y.
double still(double force) {
  const double inner = side - 2.0 * wall;
  const double I = (std::pow(side, 4) - std::pow(inner, 4)) / 12.0;
  return force * length * 0.5 * side / I / 355e6;
}

}  // namespace

TEST_CASE("a slow load that starts suddenly has its peak a quarter of a period later") {
  // At 0.5 Hz, far below the beam's 18.6 Hz: F L/W in the end, after 0.5 s.
  CHECK(use_of(30e3, 0.5, 0.01, true) == Approx(still(30e3)).epsilon(0.01));
}

TEST_CASE("a start that nobody asks for hinders no verdict, however slow the load is") {
  // Two forces a quarter of a period apart, far below the beam's 18.6 Hz: sqrt(F^2 + G^2) L/W.
  const std::string quarter =
      "[loads.q]\non = \"boom.end\"\namplitude_force = [\"0 N\", \"6000 N\"]\nphase = \"90 deg\"\n";
  for (const double f : {0.1, 0.01})
    CHECK(use_of(8e3, f, 0.005, false, quarter) == Approx(still(10e3)).epsilon(0.002));
}

TEST_CASE("a start near resonance is looked at until the beats are highest") {
  // Beside the steady vibration of one mode stands its own, r times as large; both add up half a
  // beat after the start, the latter died down by exp(-zeta omega t).
  constexpr double f = 17.1, own = 18.58, zeta = 0.005;  // 3.516/(2 pi L^2) sqrt(E I/m) [Hz]
  const double r = f / own, half_beat = 0.5 / (own - f);
  const double beside = r * std::exp(-zeta * 2.0 * 3.14159265 * own * half_beat);
  CHECK(use_of(1e3, f, zeta, true) ==
        Approx((1.0 + beside) * use_of(1e3, f, zeta, false)).epsilon(0.02));
}

TEST_CASE("a start near resonance is looked at until it has come up to the steady vibration") {
  for (const double f : {18.57, 18.5}) {
    INFO(f << " Hz");
    CHECK(use_of(300.0, f, 0.003, true) > 0.98 * use_of(300.0, f, 0.003, false));
  }
}

}  // namespace sudden_start_test
