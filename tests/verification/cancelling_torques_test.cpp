// Torques of one place that cancel: they rack a box as torques a little apart do, in strength, in
// fatigue and in what diaphragms bear; what comes evenly by both webs racks nothing.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "boxbeam/verification/distortion_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"
#include "support/path_cases.hpp"

namespace cancelling_torques_test {

using namespace boxbeam;
using test::blocks;
using namespace slender_cases;
using namespace paths;
using path_cases::section;

namespace {

struct Force {
  double s, y, z, F_y, F_z;  ///< [m, kN]
  double T = 0.0;            ///< [kN m]
};

std::string load(const std::string& name, const Force& of) {
  return fmt::format(
      "[loads.{}]\nkind = \"force\"\nat = [\"{:.17g} m\", \"{:.17g} m\", \"{:.17g} m\"]\n"
      "force = [\"0 kN\", \"{:.17g} kN\", \"{:.17g} kN\"]\n"
      "moment = [\"{:.17g} kN m\", \"0 kN m\", \"0 kN m\"]\n",
      name, of.s, of.y, of.z, of.F_y, of.F_z, of.T);
}

const std::string stout = box("a", 800.0, 800.0, 20.0, 20.0, "seam_throat = \"16 mm\"\n");

/// A weightless beam of 6 m between forks, with strong diaphragms there.
Project project(const std::string& loads, const std::string& more = "",
                const std::string& sections = stout) {
  return parse_project(
      "racked.toml",
      "[case]\nname = \"racked\"\nkind = \"static\"\n[frame]\nspace = true\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
          sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segment(6.0, "a") +
          diaphragms({0.0, 6.0}, 25.0) +
          "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"6 m\"\nstiff_length = \"400 mm\"\n"
          "[supports.a]\nkind = \"pinned\"\nat = [\"0 m\", \"0 m\", \"0 m\"]\nfork = true\n"
          "[supports.z]\nkind = \"roller\"\nat = [\"6 m\", \"0 m\", \"0 m\"]\ndirection = \"z\"\n"
          "fork = true\n"
          "[supports.y]\nkind = \"roller\"\nat = [\"6 m\", \"0 m\", \"0 m\"]\ndirection = \"y\"\n" +
          loads + more + steel + "[strength]\nrequired = 1.0\nshear_lag = false\n");
}

DistortionChecks distortion(const Project& of) {
  const std::deque<SituationRun> runs = run_situations(of);
  return check_distortion(of, runs, bending_zones_of(of, runs), {});
}

/// How much plates bend across at most [MPa]; 0 where nothing is distorted.
double across(const Project& of) {
  const DistortionChecks found = distortion(of);
  return found.estimates.empty() ? 0.0 : 1e-6 * found.estimates.front().across.value();
}

/// On one web and at the top flange, in the middle of both plates.
const Force wheel{3.0, 0.39, 0.0, 0.0, -300.0}, sideways{3.0, 0.0, 0.39, -300.0, 0.0};

Force moved(Force of, double by) {
  of.s += by;
  return of;
}

}  // namespace

TEST_CASE("torques that cancel at one place rack a box by both of their sizes", "[distortion]") {
  // d = (F_z y + F_y z)/2: of the wheel and the force sideways -117 kN m, T = 0. What passes
  // diaphragms at the forks, 3 m away, is next to nothing.
  const double alone = across(project(load("p", wheel)));
  REQUIRE(alone > 10.0);
  const double both = across(project(load("p", wheel) + load("s", sideways)));
  CHECK(both == Approx(2.0 * alone).epsilon(0.01));
  // By a couple of which nothing says how it comes, likewise; of two of these as well.
  const Force couple{3.0, 0.0, 0.0, 0.0, 0.0, 117.0};
  Force back = couple;
  back.T = -117.0;
  CHECK(across(project(load("p", wheel) + load("c", couple))) == Approx(2.0 * alone).epsilon(0.01));
  CHECK(across(project(load("b", back) + load("c", couple))) == Approx(2.0 * alone).epsilon(0.01));
  // 1 mm apart, where T jumps by both, it is the same.
  CHECK(
      both ==
      Approx(across(project(load("p", wheel) + load("s", moved(sideways, 0.001))))).epsilon(0.01));
}

TEST_CASE("what comes evenly by both webs or both flanges racks nothing", "[distortion]") {
  Force other = wheel;
  other.y = -wheel.y;
  CHECK(across(project(load("p", wheel) + load("q", other))) == 0.0);
  Force below = sideways;
  below.z = -sideways.z;
  CHECK(across(project(load("p", sideways) + load("q", below))) == 0.0);
  // A couple by the webs alone is that of one force: by halves or not.
  Force half = wheel, against = other;
  half.F_z *= 0.5;
  against.F_z *= -0.5;
  CHECK(across(project(load("p", half) + load("q", against))) ==
        Approx(across(project(load("p", wheel)))).epsilon(1e-9));
}

TEST_CASE("forces in plates that the case does not name rack as if it said nothing",
          "[distortion]") {
  const std::string by_webs =
      "[[beam.load_introductions]]\nstation = \"3 m\"\nstiff_length = \"400 mm\"\n"
      "torque_by = \"webs\"\n";
  const std::string loads = load("p", wheel) + load("s", sideways);
  REQUIRE(across(project(loads)) > 10.0);
  CHECK(across(project(loads, by_webs)) == Approx(across(project(loads))).epsilon(1e-6));
}

TEST_CASE("a wheel with a force sideways: no 1 mm decides on a verdict", "[distortion]") {
  // In strength.
  const std::string square = box("a", 500.0, 500.0, 14.0, 14.0, "seam_throat = \"16 mm\"\n");
  const Force on_web{3.0, 0.243, 0.0, 0.0, -420.0}, on_flange{3.0, 0.0, 0.243, -300.0, 0.0};
  const auto use = [&](double apart) {
    return use_of(
        verify(project(load("p", on_web) + load("s", moved(on_flange, apart)), "", square)),
        Criterion::distortion);
  };
  CHECK(use(0.0) > 1.0);
  CHECK(use(0.0) == Approx(use(0.001)).epsilon(0.01));

  // In fatigue: off, on, 2e5 times.
  const std::string often =
      "[[situations]]\nname = \"off\"\nloads = {}\n"
      "[[situations]]\nname = \"on\"\nloads = { p = 1.0, s = 1.0 }\n"
      "[[situations]]\nname = \"change\"\nbetween = [\"off\", \"on\"]\ncycles = 2e5\n"
      "[fatigue]\nloading = \"spectrum\"\ncategory = 71\ngamma_Ff = 1.0\ngamma_Mf = 1.35\n"
      "required = 1.0\n";
  const auto damage = [&](double apart) {
    return use_of(verify(project(load("p", wheel) + load("s", moved(sideways, apart)), often)),
                  Criterion::distortion_fatigue);
  };
  CHECK(damage(0.0) > 0.5);
  CHECK(damage(0.0) == Approx(damage(0.001)).epsilon(0.01));
}

TEST_CASE("a beam that forces in balance at one place rack alone is judged", "[distortion]") {
  // No cut force anywhere, d = -F y.
  Force other = wheel, against = sideways;
  other.y = -wheel.y;
  other.F_z = -wheel.F_z;
  against.z = -sideways.z;
  against.F_y = -sideways.F_y;
  const auto of = [&](double times) {
    std::string loads;
    int k = 0;
    for (Force one : {wheel, other, sideways, against}) {
      one.F_y *= times;
      one.F_z *= times;
      loads += load(fmt::format("f{}", k++), one);
    }
    return verify(project(loads));
  };
  CHECK(use_of(of(1.0), Criterion::distortion) > 0.3);
  CHECK(use_of(of(2.0), Criterion::distortion) ==
        Approx(2.0 * use_of(of(1.0), Criterion::distortion)).epsilon(1e-6));
}

TEST_CASE("a diaphragm keeps a box in shape under couples that cancel, or does not",
          "[distortion]") {
  // +260 and -260 kN m, each by other plates: d = 260 kN m, less what the frame bears, d/b = 333 kN
  // along each web of 2 mm.
  const Force one{3.0, 0.0, 0.0, 0.0, 0.0, 260.0}, other{3.0, 0.0, 0.0, 0.0, 0.0, -260.0};
  const auto held = [&](double thickness) {
    return verify(project(load("t", one) + load("u", other) + load("p", {3.0, 0, 0, 0, -10.0}),
                          diaphragms({3.0}, thickness)));
  };
  const std::string words = "so that the box keeps its shape";
  CHECK(blocks(held(2.0), words));
  CHECK_FALSE(blocks(held(20.0), words));
  const Project thin = project(load("t", one) + load("u", other), diaphragms({3.0}, 2.0));
  const auto holding = distortion(thin).estimates.front().holding;
  REQUIRE(holding);
  CHECK(holding->shear.value() < 260e3 / 0.78);
  CHECK(holding->shear.value() > 0.8 * 260e3 / 0.78);
}

TEST_CASE("other cells under torques that cancel are kept in shape, or have no verdict",
          "[distortion]") {
  // Webs that lean: top 400 and bottom 300 wide, 10 mm all around.
  ThinWalled path = box_path(400.0, 400.0, 10.0, 10.0);
  path.nodes[2].y = mm(150.0);
  path.nodes[3].y = mm(-150.0);
  const std::string sections = section("a", path);
  const std::string loads = load("t", {3.0, 0, 0, 0, 0, 30.0}) +
                            load("u", {3.0, 0, 0, 0, 0, -30.0}) + load("p", {3.0, 0, 0, 0, -10.0});
  const std::string words = "cells that are no rectangle";
  CHECK(blocks(verify(project(loads, "", sections)), words));
  CHECK_FALSE(blocks(verify(project(loads, diaphragms({3.0}, 12.0), sections)), words));
  CHECK_FALSE(blocks(verify(project(load("p", {3.0, 0, 0, 0, -10.0}), "", sections)), words));
}

TEST_CASE("lines of force beside the axis rack a box though their torques cancel", "[distortion]") {
  // A jib of 6 m at rest in space, lines from 1 to 5 m over a web (y = 0.39 m) and along the top
  // flange (z = 0.39 m).
  struct Line {
    double y, z;
    std::string direction;
  };
  const auto across_under = [](const std::vector<Line>& lines) {
    std::string points = "B = [\"0 m\", \"0 m\", \"0 m\"]", forces;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      points +=
          fmt::format(", P{} = [\"1 m\", \"{} m\", \"{} m\"], Q{} = [\"5 m\", \"{} m\", \"{} m\"]",
                      i, lines[i].y, lines[i].z, i, lines[i].y, lines[i].z);
      forces += fmt::format(
          "[forces.l{}]\nkind = \"line force\"\nfrom = \"jib.P{}\"\nto = \"jib.Q{}\"\n"
          "axes = \"world\"\ndirection = \"{}\"\nsize = \"80 kN/m\"\n",
          i, i, i, lines[i].direction);
    }
    return across(parse_project(
        "jib.toml",
        "[case]\nname = \"jib\"\nkind = \"spatial\"\n[mechanism]\n"
        "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n[motion]\nduration = \"1 s\"\n"
        "[bodies.jib]\npoints = { " +
            points +
            " }\n[joints.slew]\nkind = \"revolute\"\nconnect = [\"ground\", \"jib.B\"]\n"
            "at = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"z\"\n[drivers.slewing]\n"
            "joint = \"slew\"\nkind = \"hold\"\nvalue = \"0 rad\"\n" +
            forces + stout + "[beam]\nbody = \"jib\"\ndensity = \"7850 kg/m^3\"\n" +
            "start = \"B\"\naxis = \"x\"\nz = \"z\"\n" + segment(1.0, "a") + segment(4.0, "a") +
            segment(1.0, "a") + diaphragms({0.0, 6.0}, 25.0) + steel +
            "[strength]\nrequired = 1.0\nshear_lag = false\n"));
  };
  const Line on_web{0.39, 0.0, "-z"}, on_flange{0.0, 0.39, "-y"};
  const double one = across_under({on_web}), other = across_under({on_flange});
  REQUIRE(one > 5.0);
  CHECK(other == Approx(one).epsilon(0.02));
  CHECK(across_under({on_web, on_flange}) >= 0.97 * (one + other));
  CHECK(across_under({on_web, on_flange}) <= 1.3 * (one + other));
  // Evenly by both webs; a rail over a web at the top flange without a force sideways.
  CHECK(across_under({on_web, {-0.39, 0.0, "-z"}}) == 0.0);
  CHECK(across_under({{0.39, 0.39, "-z"}}) == Approx(one).epsilon(1e-6));
}

}  // namespace cancelling_torques_test
