// Second order where it is not in the cut forces: one cantilever in every kind of case, what cannot
// move, and mechanisms of many bodies.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "boxbeam/verification/planar_links.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"

namespace second_order_kinds_test {

using namespace boxbeam;
using test::blocks;

namespace {

/// 4 m of box 60 x 60 x 4, pressed by 1.5 kN: N_cr = pi^2 EI/(2 L)^2 = 15.24 kN.
constexpr double L = 4.0, N = 1500.0;
const double EI = 2.1e11 * (std::pow(0.06, 4) - std::pow(0.052, 4)) / 12.0;

/// What compression adds to the moment of a force across the tip, at the other end:
///
///     M/(F L) = tan(k L)/(k L), k^2 = N/EI
///
/// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 1.3.
double growth_by_hand() {
  const double kL = L * std::sqrt(N / EI);
  return std::tan(kL) / kL - 1.0;
}

const std::string section =
    "[sections.root]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"60 mm\"\nflange = \"4 mm\"\n"
    "web = \"4 mm\"\n";
const std::string segment =
    "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = \"root\"\n";

std::string demands(const char* cycles) {
  return fmt::format(
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n[fatigue]\ncategory = 71\n{}"
      "loading = \"spectrum\"\ngamma_Mf = 1.35\nrequired = 1.0\n",
      cycles);
}

std::string header(const char* kind) {
  return fmt::format("[case]\nname = \"cantilever\"\nkind = \"{}\"\n", kind);
}

const char* const of_time = "cycles = 2e6\n";
const char* const of_situations =
    "[[situations]]\nname = \"swing\"\nbetween = [\"up\", \"down\"]\ncycles = 2e6\n";

/// Pressed, and pushed to and fro across its tip by `kN`.
std::string moved(const char* kind, double kN) {
  const bool space = std::string(kind) == "spatial";
  const char* const zero = space ? "[\"0 m\", \"0 m\", \"0 m\"]" : "[\"0 m\", \"0 m\"]";
  return header(kind) +
         fmt::format(
             "[mechanism]\ngravity = {}\n[bodies.b]\npoints = {{ C = {}, D = {} }}\n{}"
             "[joints.C]\nkind = \"{}\"\nconnect = [\"ground\", \"b.C\"]\nat = {}\n"
             "[forces.tip]\nkind = \"force\"\npoint = \"b.D\"\ndirection = {}\n"
             "law = {{ kind = \"harmonic\", mean = \"0 kN\", amplitude = \"{:.17g} kN\", "
             "frequency = \"0.01 Hz\" }}\n"
             "[forces.push]\nkind = \"force\"\npoint = \"b.D\"\ndirection = {}\n"
             "size = \"1.5 kN\"\n[motion]\nduration = \"100 s\"\n",
             space ? "[\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]" : "[\"0 m/s^2\", \"0 m/s^2\"]", zero,
             space ? "[\"4 m\", \"0 m\", \"0 m\"]" : "[\"4 m\", \"0 m\"]",
             space ? "" : "sketch = { at = [\"0 m\", \"0 m\"] }\n", space ? "fixed" : "rigid", zero,
             space ? "\"-z\"" : "\"-90 deg\"", kN, space ? "\"-x\"" : "\"180 deg\"") +
         section + "[beam]\nbody = \"b\"\n" + (space ? "axis = \"x\"\nz = \"z\"\n" : "") + segment +
         demands(of_time);
}

std::string flexible(double kN) {
  return header("flexible") +
         "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[motion]\nfrequency = \"0.01 Hz\"\n"
         "[links.boom]\nkind = \"bending\"\norigin = [\"0 m\", \"0 m\"]\nangle = \"0 deg\"\n"
         "parts = 16\n[joints.wall]\nkind = \"revolute\"\nconnect = [\"boom.start\", \"ground\"]\n"
         "stiffness = \"rigid\"\nturning_stiffness = \"rigid\"\n" +
         fmt::format(
             "[loads.tip]\non = \"boom.end\"\nforce = [\"-1.5 kN\", \"0 kN\"]\n"
             "amplitude_force = [\"0 kN\", \"{:.17g} kN\"]\n",
             kN) +
         section + "[beam]\nlink = \"boom\"\n" + segment + demands(of_time);
}

std::string at_rest(double kN) {
  return header("static") + section + "[beam]\n" + segment +
         "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n" +
         fmt::format(
             "[loads.tip]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"0 kN\", \"{:.17g} kN\"]\n",
             kN) +
         "[loads.push]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"-1.5 kN\", \"0 kN\"]\n"
         "[[situations]]\nname = \"up\"\nloads = { tip = 1.0, push = 1.0 }\n"
         "[[situations]]\nname = \"down\"\nloads = { tip = -1.0, push = 1.0 }\n" +
         of_situations + demands("");
}

std::string given(double kN) {
  const std::string up = fmt::format("force = [\"-1.5 kN\", \"0 kN\", \"{:.17g} kN\"]\n", kN);
  const std::string down =
      fmt::format("\"loads.tip.force\" = [\"-1.5 kN\", \"0 kN\", \"{:.17g} kN\"]\n", -kN);
  return header("loads") + section + "[beam]\n" + segment + "[loads.tip]\nstation = \"4 m\"\n" +
         up + "[balance]\nstation = \"0 m\"\n[[situations]]\nname = \"up\"\n" +
         "[[situations]]\nname = \"down\"\n[situations.set]\n" + down + of_situations + demands("");
}

double fatigue_use(const Verification& of) {
  return of.governing(Criterion::fatigue)->check.utilisation();
}

/// A lever on a pin and a prop, loaded by so much; neither moves.
std::string propped(double kN) {
  return header("planar") +
         "[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
         "[bodies.b]\npoints = { C = [\"0 m\", \"0 m\"], P = [\"2 m\", \"0 m\"], "
         "D = [\"4 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] }\n"
         "[bodies.rod]\nmass = \"1 kg\"\nuniform_rod = \"1 m\"\n"
         "points = { P = [\"-0.5 m\", \"0 m\"], Q = [\"0.5 m\", \"0 m\"] }\n"
         "sketch = { at = [\"2 m\", \"-0.5 m\"], angle = \"-90 deg\" }\n"
         "[joints.C]\nkind = \"pin\"\nconnect = [\"b.C\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
         "[joints.P]\nkind = \"pin\"\nconnect = [\"b.P\", \"rod.P\"]\n"
         "[joints.Q]\nkind = \"pin\"\nconnect = [\"rod.Q\", \"ground\"]\nat = [\"2 m\", \"-1 m\"]\n"
         "[forces.tip]\nkind = \"force\"\npoint = \"b.D\"\ndirection = \"-90 deg\"\n" +
         fmt::format("size = \"{} kN\"\n[motion]\nduration = \"1 s\"\n", kN) +
         "[sections.root]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\n"
         "flange = \"12 mm\"\nweb = \"8 mm\"\n[sections.rod]\nkind = \"box\"\nwidth = \"100 mm\"\n"
         "height = \"100 mm\"\nflange = \"10 mm\"\nweb = \"10 mm\"\n[beam]\nbody = \"b\"\n" +
         segment +
         "[[rods]]\nname = \"prop\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\nsection = \"rod\"\n"
         "curve = \"c\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

/// The cantilever with so many bodies joined to its tip.
std::string with_bodies(int count) {
  std::string text = moved("planar", 0.01);
  for (int k = 1; k < count; ++k) {
    text += fmt::format(
        "[bodies.e{0}]\nmass = \"1 kg\"\ninertia = \"0.1 kg m^2\"\npoints = {{ P = [\"0 m\", "
        "\"0 m\"] }}\nsketch = {{ at = [\"4 m\", \"0 m\"] }}\n[joints.e{0}]\nkind = \"rigid\"\n"
        "connect = [\"e{0}.P\", \"b.D\"]\n",
        k);
  }
  return text;
}

}  // namespace

TEST_CASE("a cantilever that second order makes fail passes in no kind of case", "[second_order]") {
  CHECK(growth_by_hand() == Approx(0.0897).epsilon(1e-3));
  // In the plane second order is in the cut forces: there it fails.
  const Verification counted = verify(parse_project("c.toml", moved("planar", 0.0991)));
  CHECK(counted.verdict == Verdict::fail);
  // In space as well.
  const Verification in_space = verify(parse_project("c.toml", moved("spatial", 0.0991)));
  CHECK(in_space.verdict == Verdict::fail);
  CHECK(in_space.model.counts_second_order);
  CHECK(fatigue_use(in_space) == Approx(fatigue_use(counted)).epsilon(1e-3));
  for (const std::string& text : {flexible(0.0991), at_rest(0.0991), given(0.0991)}) {
    const Verification straight = verify(parse_project("c.toml", text));
    CAPTURE(straight.model.reason);
    CHECK(straight.verdict == Verdict::not_applicable);
    CHECK(blocks(straight, "second order (bending by N w) is not in the cut forces"));
    CHECK(straight.model.reason.find("second order is estimated to change it by") !=
          std::string::npos);
    const double growth = second_order_growth_at(straight.model.second_order, Length{}, true);
    CHECK(growth > 0.99 * growth_by_hand());
    // Of a frame, 1/(alpha_cr - 1) is more: 1/9.2.
    CHECK(growth < 0.112);
    CHECK(fatigue_use(straight) * (1.0 + growth_by_hand()) ==
          Approx(fatigue_use(counted)).epsilon(5e-3));
  }
  // The same with half of the force across: it stays below 1 however it bends.
  for (const std::string& text :
       {moved("spatial", 0.05), flexible(0.05), at_rest(0.05), given(0.05)})
    CHECK(verify(parse_project("c.toml", text)).verdict == Verdict::pass);
}

TEST_CASE("tension adds nothing that keeps a verdict back", "[second_order]") {
  std::string text = given(0.0991);
  for (std::size_t at = text.find("-1.5 kN"); at != std::string::npos; at = text.find("-1.5 kN"))
    text.erase(at, 1);
  const Verification pulled = verify(parse_project("c.toml", text));
  CHECK(pulled.verdict == Verdict::pass);
  CHECK(second_order_growth_at(pulled.model.second_order, Length{}, true) < 1e-6);
}

TEST_CASE("second order of what stands still is no ratio of round-off", "[second_order]") {
  for (const double kN : {0.2, 0.5, 1.0, 5.0, 50.0}) {
    CAPTURE(kN);
    const ModelChoice choice = choose_model(parse_project("c.toml", propped(kN)));
    CAPTURE(choice.reason);
    // Bending grows as 1/(1 - N/N_cr); the beam itself bears next to no axial force.
    CHECK(choice.chosen.level == ModelLevel::rigid);
    CHECK(choice.second_order.in_plane.part < 0.01);
    CHECK(choice.second_order.change.value() < 2.0 * choice.second_order.in_plane.part + 1e-6);
  }
}

TEST_CASE("of more bodies than are computed with neither vibration nor second order is estimated",
          "[second_order]") {
  const auto most = static_cast<int>(most_elastic_bodies);
  const Verification many = verify(parse_project("c.toml", with_bodies(most + 1)));
  CHECK(many.verdict == Verdict::not_applicable);
  CHECK(blocks(many, "51 bodies"));
  const Verification few = verify(parse_project("c.toml", with_bodies(3)));
  CHECK_FALSE(blocks(few, "bodies: of more than"));
}

}  // namespace second_order_kinds_test
