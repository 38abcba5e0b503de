// Plates of pins where the joint keeps no axis: eyes of rods without mass, which turn with neither
// body, and balls; by statics.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/box_boom.hpp"
#include "support/refusals.hpp"

namespace rod_lugs_test {

using namespace boxbeam;

namespace {

std::string pin(const std::string& joint) {
  return fmt::format(
      "\n[[pins]]\nname = \"pin\"\njoint = \"{}\"\ndiameter = \"50 mm\"\ninner_plate = \"20 mm\"\n"
      "outer_plate = \"10 mm\"\n[[pins.lugs]]\nplate = \"inner\"\nwidth = \"100 mm\"\nend = \"60 "
      "mm\"\nstress_factor = 1.0\ncategory = 71\n[fatigue]\ncategory = 71\ncycles = "
      "1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n",
      joint);
}

/// Two cranks of 1 m side by side, a rod without mass of 2 m between their ends, which stays level
/// while they swing by 80 degrees to either side; at the end of one a level force to and fro, so
/// slowly and of a beam so light that nothing else counts: the rod bears that force.
std::string cranks(bool in_space) {
  const char* const third = in_space ? ", \"0 m\"" : "";
  const auto at = [&](double x) { return fmt::format("[\"{} m\", \"0 m\"{}]", x, third); };
  std::string text = fmt::format(
      "[case]\nname = \"cranks\"\nkind = \"{}\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\"{}]\n",
      in_space ? "spatial" : "planar", in_space ? ", \"0 m/s^2\"" : "");
  for (const auto& [name, x] : {std::pair{"one", 0.0}, {"two", 2.0}}) {
    text += fmt::format("[bodies.{}]\npoints = {{ O = {}, A = {} }}\n", name, at(0.0), at(1.0));
    if (!in_space && x == 0.0) text += "mass = \"1e-6 kg\"\ninertia = \"1e-6 kg m^2\"\n";
    if (!in_space) text += fmt::format("sketch = {{ at = {}, angle = \"90 deg\" }}\n", at(x));
    text += in_space ? fmt::format(
                           "[joints.{0}]\nkind = \"revolute\"\nconnect = [\"ground\", "
                           "\"{0}.O\"]\nat = {1}\naxis = \"z\"\n{2}",
                           name, at(x), x > 0.0 ? "start = \"90 deg\"\n" : "")
                     : fmt::format(
                           "[joints.{0}]\nkind = \"pin\"\nconnect = [\"{0}.O\", "
                           "\"ground\"]\nat = {1}\n",
                           name, at(x));
  }
  return text +
         fmt::format(
             "[joints.rod]\nkind = \"distance\"\nconnect = [\"one.A\", \"two.A\"]\nlength "
             "= \"2 m\"\n[drivers.motor]\n{}\nkind = \"harmonic\"\nmean = \"90 "
             "deg\"\namplitude = \"80 deg\"\nfrequency = \"0.001 Hz\"\n",
             in_space ? "joint = \"one\"" : "point = \"one.O\"\ncoordinate = \"angle\"") +
         fmt::format(
             "[forces.push]\nkind = \"force\"\npoint = \"two.A\"\ndirection = {}\nlaw = {{ "
             "kind = \"harmonic\", mean = \"0 kN\", amplitude = \"10 kN\", frequency = "
             "\"0.001 Hz\" }}\n",
             in_space ? "\"x\"" : "\"0 deg\"") +
         "[sections.a]\nkind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n[beam]\nbody = "
         "\"two\"\ndensity = \"1 kg/m^3\"\n" +
         (in_space ? "axis = \"x\"\nz = \"y\"\n" : "") +
         "[[beam.segments]]\nlength = \"1 m\"\nsection = \"a\"\n[material]\nsteel = "
         "\"S355\"\n[strength]\nrequired = 1.0\n[model]\ndemand = \"rigid\"\n";
}

NeighbourResult lug_of(const std::string& text) {
  const Project project = parse_project("lugs.toml", text);
  return check_lugs(project, run_situations(project)).results.at(0);
}

}  // namespace

TEST_CASE("the eye of a rod bears the whole range of its force, however both its bodies turn") {
  // In the axes of either crank the force goes from the one side to the other as they turn: there
  // no direction sees half of it.
  for (const bool in_space : {false, true}) {
    CAPTURE(in_space);
    const NeighbourResult found = lug_of(cranks(in_space) + pin("rod"));
    const auto& tired = std::get<TiredLug>(found.basis);
    CHECK(tired.seen == "along the rod");
    CHECK(tired.range.value() == Approx(20e3).epsilon(1e-5));
    CHECK(found.check.acting.value() == Approx(20e3 / (0.05 * 0.02)).epsilon(1e-5));
  }
}

TEST_CASE("plates of a ball are judged along the worst of all directions") {
  // Under 10 to 30 kN at its end, twice as far out as a strut of 45 degrees.
  const double range = 20e3 * 4.0 / std::numbers::sqrt2;
  const std::string text = test::box_boom::boom(
      test::box_boom::hinged +
          "[joints.head]\nkind = \"spherical\"\nconnect = [\"strut.b\", \"arm.lug\"]\ncloses = "
          "true\n",
      "direction = \"-z\"\nlaw = { kind = \"harmonic\", mean = \"20 kN\", amplitude = \"10 kN\", "
      "frequency = "
      "\"0.001 Hz\" }\n[bodies.strut]\npoints = { a = [\"0 m\", \"0 m\", \"0 m\"], b = "
      "[\"2.8284271247461903 m\", \"0 m\", \"0 m\"] }\n[joints.foot]\nkind = "
      "\"universal\"\nconnect = [\"ground\", \"strut.a\"]\nat = [\"0 m\", \"0 m\", \"-2 "
      "m\"]\naxis = \"y\"\nsecond_axis = \"z\"\nstart = [\"-45 deg\", \"0 deg\"]\n",
      pin("head"));
  const NeighbourResult found = lug_of(text);
  const auto& tired = std::get<TiredLug>(found.basis);
  CHECK(tired.range.value() == Approx(range).epsilon(1e-4));
  CHECK(tired.seen.find("along (") == 0);
  const Project project = parse_project("lugs.toml", text);
  const Verification of = verify(project);
  CHECK(std::none_of(of.not_judged.begin(), of.not_judged.end(), [](const NotJudged& unsaid) {
    return unsaid.what.find("inner plate") != std::string::npos;
  }));
}

TEST_CASE("the pin of a ball that carries a body bears all of its force") {
  // A load hangs in a ball at the tip, 3 kN to and fro, however the ball is turned; of a
  // cylindrical joint across its axis; a turn of the ball by itself is no pin.
  const auto text = [](const std::string& joint, const std::string& drivers,
                       const std::string& name) {
    return test::box_boom::boom(
        "[joints.heel]\nkind = \"fixed\"\nconnect = [\"ground\", \"arm.heel\"]\n[bodies.load]\n"
        "points = { O = [\"0 m\", \"0 m\", \"0 m\"] }\n[joints.hook]\n" +
            joint + "connect = [\"arm.tip\", \"load.O\"]\n" + drivers,
        "direction = \"-x\"\nsize = \"1 kN\"\n[forces.swing]\nkind = \"force\"\npoint = "
        "\"load.O\"\ndirection = [0, 0.6, 0.8]\nlaw = { kind = \"harmonic\", mean = \"0 kN\", "
        "amplitude = \"3 kN\", frequency = \"0.001 Hz\" }\n",
        pin(name));
  };
  const auto held = [](int count, const char* turn, const char* last) {
    std::string drivers;
    for (int i = 1; i <= count; ++i)
      drivers += fmt::format(
          "[drivers.d{0}]\njoint = \"hook.{0}\"\nkind = \"hold\"\nvalue = "
          "\"{1}\"\n",
          i, i == count ? last : turn);
    return drivers;
  };
  const std::string ball = "kind = \"spherical\"\n";
  for (const char* turn : {"0 deg", "25 deg"}) {
    CAPTURE(turn);
    const auto& tired = lug_of(text(ball, held(3, turn, "-40 deg"), "hook"));
    CHECK(std::get<TiredLug>(tired.basis).range.value() == Approx(6e3).epsilon(1e-4));
  }
  const std::string along_z = "kind = \"cylindrical\"\naxis = \"z\"\n";
  const auto& across = lug_of(text(along_z, held(2, "0 deg", "0 m"), "hook"));
  CHECK(std::get<TiredLug>(across.basis).range.value() == Approx(0.6 * 6e3).epsilon(1e-5));
  CHECK(test::refusal_of([&] {
          parse_project("lugs.toml", text(ball, held(3, "0 deg", "0 deg"), "hook.1"));
        }).find("write joint = \"hook\"") != std::string::npos);
}

TEST_CASE("pins between beams of unlike demands are held to those of each") {
  // Two cranks with a rod between them; below the knee the range that fails is as the cube root of
  // the cycles.
  const auto bar = [](const char* name, double cycles) {
    return fmt::format(
        "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\ndensity = \"1 kg/m^3\"\nsegments = [{{ length = "
        "\"1 m\", section = \"a\" }}]\nfatigue = {{ cycles = {1} }}\n",
        name, cycles);
  };
  const auto text = [&](double of_one, double of_two) {
    std::string all = cranks(false);
    const std::size_t at = all.find("[beam]"), end = all.find("[material]");
    all.replace(at, end - at, bar("two", of_one) + bar("one", of_two));
    // Of the crank that is a beam now the sections give the mass.
    const std::string mass = "mass = \"1e-6 kg\"\ninertia = \"1e-6 kg m^2\"\n";
    all.erase(all.find(mass), mass.size());
    return all + pin("rod");
  };
  const auto use_in = [&](const std::vector<Project>& projects, std::size_t beam) {
    const Project& project = projects.at(beam);
    return check_lugs(project, run_situations(project)).results.at(0).check.utilisation();
  };
  const auto projects = parse_beams("lugs.toml", text(1e4, 1e6), {}, std::nullopt);
  REQUIRE(projects.size() == 2);
  CHECK(use_in(projects, 1) == Approx(std::cbrt(100.0) * use_in(projects, 0)).epsilon(1e-6));
}

}  // namespace rod_lugs_test
