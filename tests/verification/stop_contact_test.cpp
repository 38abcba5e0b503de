// A mass that falls onto a stop on a beam: no contact is too short to be judged.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace stop_contact_test {

using namespace boxbeam;

namespace {

constexpr double m = 10.0, gravity = 9.81, height = 0.4;

Verification of(double stiffness, const char* driven = "", double damping = 0.0) {
  const std::string moved = *driven != '\0' ? driven : "moved_by = \"forces\"\nstart = \"0.5 m\"\n";
  return verify(parse_project(
      "stop.toml",
      fmt::format(
          "[case]\nname = \"stop\"\nkind = \"spatial\"\n[motion]\nduration = \"2 "
          "s\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-{} "
          "m/s^2\"]\n[bodies.arm]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"1 m\", "
          "\"0 m\", \"0 m\"] }}\n[joints.root]\nkind = \"fixed\"\nconnect = [\"ground\", "
          "\"arm.A\"]\n[bodies.m]\nmass = \"{} kg\"\npoints = {{ C = [\"0 m\", \"0 m\", \"0 "
          "m\"] }}\n[joints.fall]\nkind = \"prismatic\"\nconnect = [\"ground\", "
          "\"m.C\"]\nat = [\"1 m\", \"0 m\", \"0 m\"]\naxis = \"z\"\n{}",
          gravity, m, moved) +
          fmt::format("[forces.pad]\nkind = \"spring\"\nconnect = [\"arm.B\", "
                      "\"m.C\"]\nstiffness = \"{:.17g} N/m\"\nfree_length = \"0.1 m\"\nacts = "
                      "\"pushing\"\ndamping = \"{} N s/m\"\n",
                      stiffness, damping) +
          "[sections.s]\nkind = \"box\"\nwidth = \"120 mm\"\nheight = \"140 mm\"\nflange = \"10 "
          "mm\"\nweb = \"10 mm\"\n[beam]\nbody = \"arm\"\nstart = \"A\"\naxis = \"x\"\nz = "
          "\"z\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"1 m\"\nsection = "
          "\"s\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.5\n[model]\ndemand = "
          "\"rigid\"\n"));
}

double yield_of(const Verification& verified) {
  return pressed_beams::use_of(verified, Criterion::yield);
}

}  // namespace

TEST_CASE("a fall onto a stop is judged by its contact, however short that is") {
  // Half of a wave: F = m g + sqrt((m g)^2 + 2 m g h k); of the arm's own weight there is as much
  // in each.
  const auto force = [](double k) {
    const double weight = m * gravity;
    return weight + std::sqrt(weight * weight + 2.0 * weight * height * k);
  };
  const double soft = yield_of(of(1e6)), hard = yield_of(of(1e10));
  const double per_force = (hard - soft) / (force(1e10) - force(1e6));
  // What is left is the arm's own weight.
  CHECK(soft - per_force * force(1e6) > 0.0);
  CHECK(soft - per_force * force(1e6) < 0.01);
  for (const double k : {3e6, 1e7, 3e7, 1e8, 1e9}) {
    INFO("k = " << k);
    CHECK((yield_of(of(k)) - soft) == Approx(per_force * (force(k) - force(1e6))).epsilon(0.01));
  }
}

TEST_CASE("a driven mass that grazes a stop is judged by its contact") {
  // Down to 0.1 mm within the stop's length for 9 ms in 2 s: k times that.
  const auto use = [](double k) {
    return yield_of(of(k,
                       "[drivers.fall]\njoint = \"fall\"\nkind = \"harmonic\"\nmean = \"1.0999 "
                       "m\"\namplitude = \"1 m\"\nfrequency = \"0.5 Hz\"\n"));
  };
  const double own = use(1e-3), soft = use(1e6) - own;
  // 0.1 kN at the tip of the arm, 1 m from its root.
  CHECK(soft > 1e-3);
  for (const double k : {1e7, 1e8}) CHECK(use(k) - own == Approx(k / 1e6 * soft).epsilon(0.01));
}

TEST_CASE("a damped stop bears nothing before it is touched, and at once c v then") {
  const auto use = [](double k, double mean, double damping) {
    const std::string driven = fmt::format(
        "[drivers.fall]\njoint = \"fall\"\nkind = \"harmonic\"\nmean = \"{} m\"\namplitude = "
        "\"1 m\"\nfrequency = \"0.5 Hz\"\n",
        mean);
    return yield_of(of(k, driven.c_str(), damping));
  };
  // 0.1 kN by 0.1 mm of depth, without damping.
  const double own = use(1e-3, 1.0999, 0.0), per_force = (use(1e6, 1.0999, 0.0) - own) / 100.0;
  // Touched where the sine is -0.95: v = pi sqrt(1 - 0.95^2) m/s, and from there on less.
  constexpr double c = 1e3, mean = 1.05;
  const double v = 3.14159265358979 * std::sqrt(1.0 - 0.95 * 0.95);
  CHECK(use(1e3, mean, c) - own == Approx(per_force * c * v).epsilon(0.005));
  // It never comes near enough.
  CHECK(use(1e3, 1.15, c) == Approx(own).epsilon(1e-6));
}

}  // namespace stop_contact_test
