// Dry friction of contacts that slide slowly, or stand.

#include "boxbeam/verification/slow_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/report/motion_text.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace slow_friction_test {

using namespace boxbeam;

namespace {

/// A post of 2 m on a slider with mu = 0.3, pressed by a force at its tip and moved there along x
/// by a driver, which bends it by what the slider rubs.
Project post(const std::string& driver, const std::string& force, const std::string& creep = "",
             const std::string& more = "") {
  return parse_project(
      "post.toml",
      "[case]\nname = \"post\"\nkind = \"planar\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\"]\n[bodies.beam]\npoints = { A = [\"0 m\", \"0 m\"], C = [\"1 m\", \"0 m\"], B = "
      "[\"2 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"], angle = \"90 deg\" }\n"
      "[joints.A]\nkind = \"slider\"\npoint = \"beam.A\"\nthrough = [\"0 m\", \"0 m\"]\ndirection "
      "= \"0 deg\"\nangle = \"90 deg\"\nfriction = { coefficient = 0.3" +
          creep + " }\n[drivers.d]\npoint = \"beam.B\"\ncoordinate = \"x\"\n" + driver +
          "[forces.P]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"-90 deg\"\n" + force +
          more +
          "[sections.s]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 mm\"\nflange = \"12 "
          "mm\"\nweb = \"12 mm\"\n[beam]\nbody = \"beam\"\ndensity = \"78.5 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"2 m\"\nsection = \"s\"\n[[beam.load_introductions]]\nfrom "
          "= \"0 m\"\nto = \"2 m\"\ninto = \"webs\"\n[material]\nsteel = \"S355\"\n[strength]\n"
          "required = 1.0\nshear_lag = false\n");
}

std::string swaying(const char* frequency) {
  return fmt::format(
      "kind = \"harmonic\"\nmean = \"0 m\"\namplitude = \"1 mm\"\nfrequency = \"{}\"\n", frequency);
}

const std::string pressed = "size = \"300 kN\"\n";

/// Largest bending moment at the slider [N m].
double moment_at_slider(const Project& project) {
  const std::deque<SituationRun> runs = run_situations(project);
  const StationHistory root(runs.front().loads, {Length{}, Side::behind});
  double largest = 0.0;
  for (const CutForces& cut : root.samples())
    largest = std::max(largest, std::abs(cut.M_y.value()));
  return largest;
}

std::string line_of(const Project& project) {
  return verdict_text_of(project, verify(project)).line;
}

}  // namespace

TEST_CASE("dry friction knows no velocity: a slow slider rubs as much as a fast one") {
  // By hand: mu P L = 0.3 x 300 kN x 2 m = 180 kN m, at 1.26 mm/s as at 126 mm/s.
  for (const char* frequency : {"0.2 Hz", "2 Hz", "20 Hz"}) {
    CAPTURE(frequency);
    CHECK(moment_at_slider(post(swaying(frequency), pressed)) == Approx(180e3).epsilon(5e-3));
  }
  const Project slow = post(swaying("0.2 Hz"), pressed);
  CHECK_FALSE(verify(slow).verdict == Verdict::pass);
  CHECK_THAT(line_of(slow), !Catch::Contains("dry friction"));
}

TEST_CASE("a creep velocity is at most a fiftieth of the fastest, where drivers say how fast") {
  const auto creep_of = [](const Project& project) {
    return std::get<planar::Slider>(planar_of(project).joints.front().kind).friction.creep;
  };
  // By hand: 2 pi f x 1 mm.
  CHECK(creep_of(post(swaying("0.2 Hz"), pressed)) ==
        Approx(0.02 * 2.0 * 3.14159265 * 0.2e-3).epsilon(1e-3));
  CHECK(creep_of(post(swaying("200 Hz"), pressed)) == planar::Friction{}.creep);
  CHECK(creep_of(post(swaying("0.2 Hz"), pressed, ", creep = \"10 mm/s\"")) == 0.01);
}

TEST_CASE("friction that a given creep velocity takes away is said") {
  // By hand: 1.257 mm/s, of 90 kN 1.257/hypot(1.257, 10) = 0.125.
  const std::string line = line_of(post(swaying("0.2 Hz"), pressed, ", creep = \"10 mm/s\""));
  CHECK_THAT(line, Catch::Contains("dry friction of A: at most 11 of 90 kN act") &&
                       Catch::Contains("at most 1.26 mm/s (creep 10 mm/s)"));
  CHECK_THAT(line_of(post(swaying("0.2 Hz"), pressed, ", creep = \"0.1 mm/s\"")),
             !Catch::Contains("dry friction"));
}

TEST_CASE("a contact with a creep velocity that forces move more slowly than that says so") {
  // By hand: 0.5 of 0.9 kN balance the push at v = 10 mm/s (5/9)/sqrt(1 - (5/9)^2) = 6.68 mm/s.
  const auto pushed = [](const char* size, const std::string& creep = ", creep = \"10 mm/s\"") {
    std::string text = post(swaying("1 Hz"), "size = \"3 kN\"\n", creep).text;
    const std::size_t from = text.find("[drivers.d]"), to = text.find("[forces.P]");
    return parse_project(
        "post.toml", text.replace(from, to - from,
                                  fmt::format("[motion]\nduration = \"5 ms\"\n[forces.Q]\nkind "
                                              "= \"force\"\npoint = \"beam.B\"\ndirection = \"0 "
                                              "deg\"\nsize = \"{}\"\n",
                                              size)));
  };
  // Pushed at once it vibrates beside, which is why there is no verdict.
  const Project slowly = pushed("0.5 kN");
  CHECK_THAT(
      verdict_text_of(slowly, verify(slowly)).whole(),
      Catch::Contains("forces move it with at most 6.68 mm/s (creep 10 mm/s), at most 0.5 of "
                      "0.9 kN act, and it does not stick"));
  CHECK_THAT(line_of(pushed("0.95 kN")), !Catch::Contains("dry friction"));
  // Without one it sticks, and bears at its slider what is pushed, 0.5 kN x 2 m.
  const Project sticks = pushed("0.5 kN", "");
  CHECK_THAT(line_of(sticks), !Catch::Contains("dry friction"));
  CHECK(moment_at_slider(sticks) == Approx(1e3).epsilon(1e-9));
  CHECK_THAT(motion_text(sticks, motion_of(sticks, {})),
             Catch::Contains("A sticks once: from 0 s on"));
  CHECK_THAT(motion_text(pushed("0.95 kN", ""), motion_of(pushed("0.95 kN", ""), {})),
             Catch::Contains("A never sticks"));
}

TEST_CASE("the beam bears what its slider takes just before it breaks away") {
  // By hand: mu_s P L = 0.5 x 3 kN x 2 m; sliding (F + mu P) L/2 <= (1.6 + 0.9) kN m.
  std::string text = post(swaying("1 Hz"), "size = \"3 kN\"\n", ", static_coefficient = 0.5").text;
  const std::size_t from = text.find("[drivers.d]"), to = text.find("[forces.P]");
  text.replace(from, to - from,
               "[motion]\nduration = \"50 ms\"\n[forces.Q]\nkind = \"force\"\npoint = "
               "\"beam.B\"\ndirection = \"0 deg\"\nlaw = { kind = \"smooth step\", from = \"0 "
               "kN\", to = \"1.6 kN\", begin = \"0 s\", end = \"40 ms\" }\n");
  const Project project = parse_project("post.toml", text);
  CHECK(moment_at_slider(project) == Approx(3e3).epsilon(1e-6));
  CHECK_THAT(line_of(project), !Catch::Contains("dry friction"));
}

TEST_CASE("what more a contact may take standing than sliding is said where drivers move it") {
  // By hand: 0.3 and 0.5 of 300 kN.
  CHECK_THAT(
      line_of(post(swaying("2 Hz"), pressed, ", static_coefficient = 0.5")),
      Catch::Contains("dry friction of A: where it stands or turns round up to 150 kN may act "
                      "in either sense, and no more than 90 kN are looked at"));
}

TEST_CASE("friction of a contact that stands is said where it may count") {
  const std::string moved =
      "kind = \"smooth step\"\nfrom = \"0 m\"\nto = \"1 mm\"\nbegin = \"0 s\"\nend = \"1 s\"\n";
  const std::string lasting = "[motion]\nduration = \"10 s\"\n";
  const auto growing = [](double from, double to) {
    return fmt::format(
        "law = {{ kind = \"smooth step\", from = \"{} kN\", to = \"{} kN\", begin = \"4 s\", end "
        "= \"6 s\" }}\n",
        from, to);
  };
  // It is pressed most while it stands: 0.3 x 300 kN.
  CHECK_THAT(line_of(post(moved, growing(100.0, 300.0), "", lasting)),
             Catch::Contains("dry friction of A: at most 30 of 90 kN act"));
  // It stands as much pressed as it slid, and another force bends it most then.
  const std::string push =
      "[forces.Q]\nkind = \"force\"\npoint = \"beam.C\"\ndirection = \"0 "
      "deg\"\n" +
      growing(0.0, 200.0);
  CHECK_THAT(line_of(post(moved, "size = \"100 kN\"\n", "", push + lasting)),
             Catch::Contains("while it stands up to 30 kN in either sense"));
  // It bears no more then than before: sliding was worse.
  CHECK_THAT(line_of(post(moved, "size = \"100 kN\"\n", "", lasting)),
             !Catch::Contains("dry friction"));
}

namespace {

/// A beam of 2 m in space, pressed in the middle by 30 kN square to it, that a sled moves along
/// itself by a hinge at its start; its end slides in a guide on the ground.
Project pulled_beam(const std::string& driver, const std::string& friction) {
  return parse_project(
      "beam.toml",
      "[case]\nname = \"beam\"\nkind = \"spatial\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\", "
      "\"0 m/s^2\"]\n[motion]\nduration = \"1 s\"\n[bodies.sled]\npoints = { P = [\"0 m\", \"0 "
      "m\", "
      "\"0 m\"] }\n[bodies.beam]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], C = [\"1 m\", \"0 "
      "m\", \"0 "
      "m\"], B = [\"2 m\", \"0 m\", \"0 m\"] }\n[joints.sled]\nkind = \"prismatic\"\nconnect = "
      "[\"ground\", \"sled.P\"]\naxis = \"x\"\n[joints.hinge]\nkind = \"universal\"\nconnect = "
      "[\"sled.P\", \"beam.A\"]\naxis = \"y\"\nsecond_axis = \"z\"\n[joints.guide]\nkind = "
      "\"slot\"\n"
      "connect = [\"ground\", \"beam.B\"]\nat = [\"2 m\", \"0 m\", \"0 m\"]\naxis = "
      "\"x\"\nfriction = { "
      "coefficient = 0.3" +
          friction + " }\n[drivers.pull]\njoint = \"sled\"\n" + driver +
          "[forces.P]\nkind = \"force\"\npoint = \"beam.C\"\ndirection = [0, 0.6, -0.8]\nsize = "
          "\"30 "
          "kN\"\n[sections.s]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 mm\"\nflange = "
          "\"12 "
          "mm\"\nweb = \"12 mm\"\n[beam]\nbody = \"beam\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n"
          "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"s\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n");
}

std::string at_rate(const char* rate) {
  return fmt::format("kind = \"constant rate\"\nstart = \"0 m\"\nrate = \"{}\"\n", rate);
}

/// Axial force in the middle of the first half, at the begin [N].
double axial_force(const Project& project) {
  const std::deque<SituationRun> runs = run_situations(project);
  return runs.front().loads.diagram_at(si<Time>(0.0)).at({si<Length>(0.5), Side::both}).N.value();
}

/// A post of 2 m on a slide along x that a rod on the ground pushes; a force at its tip along y.
Project post_in_space(const std::string& friction) {
  return parse_project(
      "post.toml",
      "[case]\nname = \"post\"\nkind = \"spatial\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\", "
      "\"0 m/s^2\"]\n[motion]\nduration = \"1 s\"\n[bodies.beam]\npoints = { A = [\"0 m\", \"0 "
      "m\", \"0 "
      "m\"], B = [\"2 m\", \"0 m\", \"0 m\"] }\n[joints.slide]\nkind = \"prismatic\"\nconnect = "
      "[\"ground\", \"beam.A\"]\nturn = [\"y\", \"-90 deg\"]\naxis = \"-z\"\nfriction = { "
      "coefficient = "
      "0.3" +
          friction +
          " }\n[joints.push]\nkind = \"distance\"\nconnect = [\"ground\", \"beam.A\"]\nat = [\"-3 "
          "m\", "
          "\"0 m\", \"0 m\"]\n[drivers.push]\njoint = \"push\"\nkind = \"constant rate\"\nstart = "
          "\"3 m\"\n"
          "rate = \"0.1 m/s\"\n[forces.P]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = "
          "\"y\"\nsize "
          "= \"1 kN\"\n[sections.s]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 "
          "mm\"\nflange = "
          "\"12 mm\"\nweb = \"12 mm\"\n[beam]\nbody = \"beam\"\nstart = \"A\"\naxis = \"x\"\nz = "
          "\"z\"\n"
          "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"s\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n");
}

}  // namespace

TEST_CASE("a beam in space that its guide rubs is pressed or pulled by the friction") {
  // By hand: half the force presses on the guide, mu P = 0.3 x 15 kN, of which a creep velocity of
  // a fiftieth leaves 1/hypot(1, 0.02). Moved ahead the sled pushes the beam, back it pulls.
  const double friction = 4500.0 / std::hypot(1.0, 0.02);
  CHECK(axial_force(pulled_beam(at_rate("0.1 m/s"), "")) == Approx(-friction).epsilon(1e-9));
  CHECK(axial_force(pulled_beam(at_rate("-0.1 m/s"), "")) == Approx(friction).epsilon(1e-9));
  CHECK(axial_force(pulled_beam(at_rate("0.1 m/s"), ", viscous = \"2 kN s/m\"")) ==
        Approx(-friction - 200.0).epsilon(1e-9));
}

TEST_CASE("a contact in space with a creep velocity that forces move more slowly says so") {
  // By hand, as in the plane: 0.5 of 0.3 x 3 kN balance the push at v = 10 mm/s (5/9)/sqrt(1 -
  // (5/9)^2) = 6.68 mm/s. At the start the push moves a mass whose centre is 1 m above the slide.
  for (const bool creeps : {true, false}) {
    std::string text = post_in_space(creeps ? ", creep = \"10 mm/s\"" : "").text;
    const auto replace = [&](const char* from, const char* until, const std::string& by) {
      const std::size_t at = text.find(from);
      text.replace(at, text.find(until) - at, by);
    };
    replace("duration = \"1 s\"", "[bodies.beam]", "duration = \"5 ms\"\n");
    replace("[joints.push]", "[forces.P]",
            "moved_by = \"forces\"\n[forces.Q]\nkind = \"force\"\npoint = \"beam.A\"\ndirection = "
            "\"x\"\naxes = \"world\"\nsize = \"0.5 kN\"\n");
    replace("direction = \"y\"", "[sections.s]", "direction = \"-z\"\nsize = \"3 kN\"\n");
    replace("density", "[[beam.segments]]", "density = \"78.5 kg/m^3\"\n");
    const std::string line = line_of(parse_project("post.toml", text));
    if (creeps) {
      CHECK_THAT(
          line, Catch::Contains("dry friction of slide: a couple of up to 0.5 kN m on its guide") &&
                    Catch::Contains("presses nowhere; forces move it with at most 6.68 mm/s (creep "
                                    "10 mm/s), at most 0.5 of 0.9 kN act, and it does not stick"));
    } else {
      // It sticks: nothing moves the mass, and push and friction lie in one line.
      CHECK_THAT(line, !Catch::Contains("dry friction"));
    }
  }
}

TEST_CASE("what is not looked at of dry friction in space is said") {
  CHECK_THAT(line_of(pulled_beam(at_rate("0.1 m/s"), "")), !Catch::Contains("dry friction"));
  // By hand: of 4.5 kN 100/hypot(100, 1000).
  CHECK_THAT(line_of(pulled_beam(at_rate("0.1 m/s"), ", creep = \"1 m/s\"")),
             Catch::Contains("dry friction of guide: at most 0.45 of 4.5 kN act") &&
                 Catch::Contains("at most 100 mm/s (creep 1e+03 mm/s)"));
  CHECK_THAT(line_of(pulled_beam("kind = \"hold\"\nvalue = \"0.1 m\"\n", "")),
             Catch::Contains("dry friction of guide: it stands, and up to 4.5 kN in either sense"));
  // The couple of the tip's force about the line of the slide: 1 kN x 2 m.
  CHECK_THAT(line_of(post_in_space("")),
             Catch::Contains("dry friction of slide: a couple of up to 2 kN m on its guide, which "
                             "has no guide_length, presses nowhere"));
  CHECK_THAT(line_of(post_in_space(", guide_length = \"0.5 m\"")),
             Catch::Contains("a couple of up to 2 kN m about its guide presses nowhere"));
  // A creep velocity that takes most of it away is said beside: 100/hypot(100, 1000) of 0.3 kN.
  CHECK_THAT(line_of(post_in_space(", creep = \"1 m/s\"")),
             Catch::Contains("presses nowhere; at most 0.03 of 0.3 kN act"));
}

}  // namespace slow_friction_test
