// What a case leaves out that its verdict line must say.

#include "boxbeam/verification/unsaid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boxbeam/strength/transverse_stiffener.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace unsaid_test {

using namespace boxbeam;

namespace {

const std::string steel = "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";

std::string line_of(const std::string& text) {
  const Project project = parse_project("unsaid.toml", text);
  return verdict_text_of(project, verify(project)).line;
}

/// A beam on two supports whose flanges are as thick as said behind and ahead of its middle.
std::string stepped(double behind, double ahead, const char* more) {
  const auto box = [](const char* name, double flange) {
    return fmt::format(
        "[sections.{}]\nkind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\nflange = \"{} "
        "mm\"\nweb = \"12 mm\"\nseam_throat = \"12 mm\"\n",
        name, flange);
  };
  return "[case]\nname = \"step\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
         "m/s^2\"]\n" +
         box("a", behind) + box("b", ahead) +
         "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
         "\"a\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n"
         "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"4 m\"\ninto = \"webs\"\n"
         "[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n[supports.z]\nkind = \"roller\"\nat = "
         "\"4 m\"\n[loads.f]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"-300 kN\"]\n"
         "[[situations]]\nname = \"off\"\nloads = { }\n[[situations]]\nname = \"on\"\nloads = { f "
         "= 1.0 }\n[[situations]]\nname = \"change\"\nbetween = [\"off\", \"on\"]\ncycles = 2e6\n"
         "[fatigue]\nloading = \"spectrum\"\ncategory = 112\ngamma_Mf = 1.0\nrequired = 1.0\n" +
         more + steel;
}

}  // namespace

TEST_CASE("the joint of plates that step in thickness is said where no detail lies there") {
  CHECK_THAT(line_of(stepped(40.0, 20.0, "")), Catch::Contains("joint at s = 2 m in fatigue") &&
                                                   Catch::Contains("top flange, 40 and 20 mm"));
  CHECK_THAT(line_of(stepped(20.0, 40.0, "")),
             Catch::StartsWith("PASS; joint at s = 2 m in fatigue"));
  CHECK_THAT(line_of(stepped(20.0, 20.0, "")), !Catch::Contains("joint at"));
  // By hand: e = 10 mm, 71/(1 + 3 x 20^1.5/(20^1.5 + 40^1.5)) = 39.8.
  const auto said_with = [](const char* on, double from, double to, double category) {
    const std::string detail = fmt::format(
        "[[fatigue.details]]\nname = \"d\"\nfrom = \"{} m\"\nto = \"{} m\"\n{}category = {}\n",
        from, to, on, category);
    return line_of(stepped(40.0, 20.0, detail.c_str())).find("joint at") != std::string::npos;
  };
  const char* const webs = "on = \"webs\"\n";
  const char* const seams = "on = \"seams\"\n";
  const char* const fibres = "on = \"fibres\"\n";
  CHECK(said_with("", 0.5, 3.5, 40.0));
  CHECK_FALSE(said_with("", 0.5, 3.5, 36.0));
  CHECK_FALSE(said_with(fibres, 0.5, 3.5, 36.0));
  // One of the joint itself is what the case says of it; one of webs or seams says nothing of it.
  CHECK_FALSE(said_with(fibres, 2.0, 2.0, 90.0));
  CHECK(said_with(webs, 2.0, 2.0, 36.0));
  CHECK(said_with(seams, 2.0, 2.0, 36.0));
}

namespace {

/// What is said of the joint of the same beam of other sections; "" where nothing is.
std::string joint_between(const std::string& behind, const std::string& ahead) {
  std::string text = stepped(20.0, 20.0, "");
  const std::size_t from = text.find("[sections.a]"), to = text.find("[beam]");
  text.replace(from, to - from, "[sections.a]\n" + behind + "[sections.b]\n" + ahead);
  const std::vector<NotJudged> said = unsaid_joints_of(parse_project("unsaid.toml", text));
  return said.empty() ? "" : said.front().what + ": " + said.front().reason;
}

/// The box of `stepped` as a path, in line with the middle of its webs.
std::string path(double flange) {
  const double z = 300.0 - 0.5 * flange;
  return fmt::format(
      "kind = \"thin-walled\"\nnodes = {{ tl = [\"194 mm\", \"{0} mm\"], tr = [\"-194 mm\", \"{0} "
      "mm\"], bl = [\"194 mm\", \"-{0} mm\"], br = [\"-194 mm\", \"-{0} mm\"] }}\nwalls = [\n{{ "
      "from = \"tl\", to = \"tr\", thickness = \"{1} mm\" }},\n{{ from = \"bl\", to = \"br\", "
      "thickness = \"{1} mm\" }},\n{{ from = \"tl\", to = \"bl\", thickness = \"12 mm\" }},\n{{ "
      "from = \"tr\", to = \"br\", thickness = \"12 mm\" }}\n]\n",
      z, flange);
}

}  // namespace

// Invariants: the box of the first test, said there, as a path; and as a tube beside a box.
TEST_CASE("the joint of plates of paths and of unlike profiles is said, too") {
  CHECK_THAT(
      joint_between(path(40.0), path(20.0)),
      Catch::Contains("joint at s = 2 m in fatigue") && Catch::Contains("wall 1, 40 and 20 mm"));
  CHECK(joint_between(path(20.0), path(20.0)).empty());
  const auto box = [](double wall) {
    return fmt::format(
        "kind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\nflange = \"{0} mm\"\nweb = "
        "\"{0} mm\"\n",
        wall);
  };
  const std::string tube =
      "kind = \"rectangular tube\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\nwall = \"12 "
      "mm\"\nouter_radius = \"0 mm\"\n";
  CHECK_THAT(joint_between(box(20.0), tube), Catch::Contains("top flange, 20 and 12 mm"));
  CHECK(joint_between(box(12.0), tube).empty());
}

TEST_CASE("a motion by forces that ends while its use grows says so") {
  // It falls 0.1 m and is stopped: half of the stop's wave lasts pi sqrt(m/k) = 23 ms, behind 0.14
  // s of the fall.
  const auto fall = [](double duration) {
    return line_of(
        fmt::format("[case]\nname = \"fall\"\nkind = \"spatial\"\n[motion]\nduration = \"{} "
                    "s\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n",
                    duration) +
        "[bodies.car]\nmass = \"80 kg\"\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"] }\n"
        "[bodies.arm]\npoints = { B = [\"0 m\", \"0 m\", \"0 m\"], D = [\"1 m\", \"0 "
        "m\", \"0 m\"] }\n[bodies.load]\nmass = \"80 kg\"\npoints = { D = [\"0 m\", "
        "\"0 m\", \"0 m\"] }\n[joints.fall]\nkind = \"prismatic\"\nconnect = "
        "[\"ground\", \"car.A\"]\naxis = \"z\"\nmoved_by = \"forces\"\nstart = \"0.3 "
        "m\"\n[joints.root]\nkind = \"fixed\"\nconnect = [\"car.A\", \"arm.B\"]\n"
        "[joints.end]\nkind = \"fixed\"\nconnect = [\"arm.D\", \"load.D\"]\n"
        "[forces.stop]\nkind = \"spring\"\nconnect = [\"ground\", \"car.A\"]\nat = "
        "[\"0 m\", \"0 m\", \"0 m\"]\nstiffness = \"4000 kN/m\"\nfree_length = \"0.2 "
        "m\"\nacts = \"pushing\"\n[sections.s]\nkind = \"rectangular tube\"\nwidth = "
        "\"150 mm\"\nheight = \"250 mm\"\nwall = \"8 mm\"\nouter_radius = \"0 mm\"\n"
        "[beam]\nbody = \"arm\"\nstart = \"B\"\naxis = \"x\"\nz = \"z\"\ndensity = "
        "\"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"1 m\"\nsection = \"s\"\n"
        "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"1 m\"\ninto = \"webs\"\n" +
        steel);
  };
  CHECK_THAT(fall(0.147), Catch::Contains("its last instant, 0.147 s"));
  CHECK_THAT(fall(0.25), !Catch::Contains("last instant"));
}

namespace {

/// A jib in space on a hinge, with a rod under its tip where it is so long, under a force across.
std::string jib(double length, const char* hinge, const char* more) {
  return fmt::format(
             "[case]\nname = \"jib\"\nkind = \"spatial\"\n[mechanism]\ngravity = [\"0 m/s^2\", "
             "\"0 m/s^2\", \"0 m/s^2\"]\n[bodies.jib]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 "
             "m\"], B = [\"{0} m\", \"0 m\", \"0 m\"] }}\n[joints.root]\nconnect = "
             "[\"ground\", \"jib.A\"]\n{1}{2}[sections.s]\nkind = \"box\"\nwidth = \"100 "
             "mm\"\nheight = \"200 mm\"\nflange = \"8 mm\"\nweb = \"8 mm\"\n[beam]\nbody = "
             "\"jib\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\ndensity = \"7850 "
             "kg/m^3\"\n[[beam.segments]]\nlength = \"{0} m\"\nsection = "
             "\"s\"\n[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"{0} m\"\ninto = "
             "\"webs\"\n",
             length, hinge, more) +
         steel;
}

}  // namespace

// Rigid bodies are demanded: by modes the jib would be judged with its vibration.
TEST_CASE("what vibration adds stands in the line where nobody estimates it and loads change") {
  const auto under = [](const char* motion, const char* law) {
    return line_of(jib(3.0, "kind = \"fixed\"\n",
                       fmt::format("{}[forces.f]\nkind = \"force\"\npoint = \"jib.B\"\ndirection "
                                   "= \"y\"\n{}\n",
                                   motion, law)
                           .c_str()));
  };
  // Invariant: a force that stays excites nothing.
  CHECK_THAT(under("[motion]\nduration = \"1 s\"\n", "size = \"10 kN\""),
             !Catch::Contains("vibration"));
  // By hand, clamped: 1.875^2 sqrt(E I_z/(rho A L^4))/(2 pi) = 18 Hz; at 0.2 Hz the amplitude grows
  // by r^2 = 0.0001, at 6 Hz by 0.1, at 18 Hz by so much that nothing passes.
  const auto shaken = [&](const char* frequency) {
    return under("[model]\ndemand = \"rigid\"\n",
                 fmt::format("law = {{ kind = \"harmonic\", mean = \"0 kN\", amplitude = "
                             "\"10 kN\", frequency = \"{} Hz\" }}",
                             frequency)
                     .c_str());
  };
  CHECK_THAT(shaken("0.2"), !Catch::Contains("vibration"));
  CHECK_THAT(shaken("6"), Catch::Contains("vibration: estimated to change the governing stress"));
  CHECK_THAT(shaken("18"), Catch::Contains("NOT APPLICABLE"));
}

TEST_CASE("a rod in one plane is no hold across it") {
  // 24.05 kN along 8 m, I_z = 7.58e6 mm^4: pi^2 E I_z/(4 L^2) = 61.3 kN clamped at the hinge alone,
  // N/N_cr = 0.39. The strut, 3 m, leans with the tip under half the jib's weight, of which
  // 3 E I_z/L^3 = 9.3 kN/m bears 28 kN. Both together are below the sum (Dunkerley).
  const auto under = [](double force) {
    return jib(
        8.0,
        "kind = \"revolute\"\nat = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"y\"\nstart = \"0 deg\"\n",
        fmt::format("[motion]\nduration = \"1 s\"\n[joints.strut]\nkind = \"distance\"\nconnect "
                    "= [\"ground\", \"jib.B\"]\nat = [\"8 m\", \"0 m\", \"-3 m\"]\nlength = \"3 "
                    "m\"\n[forces.P]\nkind = \"force\"\npoint = \"jib.B\"\ndirection = "
                    "\"-x\"\nsize = \"{} kN\"\n",
                    force)
            .c_str());
  };
  const Verification of = verify(parse_project("unsaid.toml", under(24.05)));
  REQUIRE(of.model.second_order.across);
  const double part = of.model.second_order.across->part, alone = 24.05 / 61.3;
  const double leaning = 0.5 * of.beam_mass.mass.value() * 9.81 / 28e3;
  CHECK(part > 0.995 * alone);
  CHECK(part < 1.005 * (alone + leaning));
  CHECK_FALSE(of.model.second_order.across->assumed);
  // Nothing is assumed that could be said.
  CHECK_THAT(line_of(under(24.05)), !Catch::Contains("how joints hold the beam"));
}

TEST_CASE("a weld around a profile larger than the beam is no weld of the beam") {
  const auto gates = [](const char* around) {
    return weld_gates_of(parse_project(
        "weld.toml",
        fmt::format(
            "[case]\nname = \"weld\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
            "m/s^2\"]\n[sections.s]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 mm\"\n"
            "flange = \"10 mm\"\nweb = \"8 mm\"\n[sections.big]\nkind = \"box\"\nwidth = \"400 "
            "mm\"\nheight = \"400 mm\"\nflange = \"10 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = "
            "\"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"s\"\n[supports.a]\n"
            "kind = \"fixed\"\nat = \"0 m\"\n[[welds]]\nname = \"w\"\nstation = \"0 m\"\naround = "
            "\"{}\"\nthroat = \"5 mm\"\n[loads.f]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 "
            "kN\", \"-60 kN\"]\n",
            around) +
            steel));
  };
  CHECK(gates("s").empty());
  REQUIRE(gates("big").size() == 1);
  CHECK_THAT(gates("big").front().finding, Catch::Contains("weld \"w\" at s = 0 m"));
}

// By hand: sigma_m = 12 870 kN/3 m (1/2 + 1/2 per m) = 4.29 MPa; (b/pi)^4 = 0.8315 m^4; w_0 = 2/300
// m, 1 + 300 w_0/b = 5/3.
TEST_CASE("what holds a compressed plate has the second moment of 9.2.1(5)") {
  const HeldPlate plate{si<Force>(12.87e6), 3.0 * metre, 2.0 * metre, 2.0 * metre};
  const double by_hand = 4.29e6 / 210e9 * std::pow(3.0 / std::numbers::pi, 4) * (1.0 + 2.0 / 3.0);
  // u is one up to e_max = f_y 300 b/(pi^2 E) = 0.154 m, beyond it grows with e_max.
  CHECK(holding_stiffener_inertia(plate, 0.1 * metre, si<Stress>(355e6), 1.0).value() ==
        Approx(by_hand).epsilon(1e-9));
  CHECK(holding_stiffener_inertia(plate, 0.2 * metre, si<Stress>(355e6), 1.0).value() >
        1.1 * by_hand);
}

}  // namespace unsaid_test
