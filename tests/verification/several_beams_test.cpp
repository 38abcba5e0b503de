// Cases of several beams. What is expected of each is what a case with that beam alone says, in
// which the others are bodies with the mass and inertia of a uniform bar by hand, members or links;
// these ways through the reader share nothing but the mechanism itself.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "boxbeam/report/json.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace several_beams_test {

using namespace boxbeam;
using test::contains;

namespace {

std::string common(const std::string& kind) {
  return "[case]\nname = \"pair\"\nkind = \"" + kind + "\"\n" + R"(
[sections.tube]
kind = "round tube"
diameter = "100 mm"
wall = "5 mm"
[material]
steel = "S355"
[strength]
required = 1.0
[fatigue]
category = 100
cycles = 1e6
loading = "spectrum"
gamma_Mf = 1.0
required = 1.0
)";
}

const std::string segment_of_arm = "[[beam.segments]]\nlength = \"1 m\"\nsection = \"tube\"\n";
const std::string segments_of_rod = "[[beam.segments]]\nlength = \"2 m\"\nsection = \"tube\"\n";
const std::string density = "density = \"7850 kg/m^3\"\n";

/// Mass of the tube over a length, and the inertia of a bar about its centre, m l^2/12.
std::string mass_of(double length) {
  const double area = std::numbers::pi / 4.0 * (0.1 * 0.1 - 0.09 * 0.09);
  const double mass = 7850.0 * area * length;
  return fmt::format(
      "mass = \"{:.17g} kg\"\ninertia = \"{:.17g} kg m^2\"\ncentre = [\"{} m\", \"0 m\"]\n", mass,
      mass * length * length / 12.0, length / 2.0);
}

/// An arm that swings, and a rod that is joined to it at an angle; what stands for their mass.
std::string kinked_pair(const std::string& of_arm, const std::string& of_rod,
                        const std::string& beams) {
  return common("planar") + R"(
[mechanism]
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[model]
demand = "rigid"
[bodies.arm]
points = { A = ["0 m", "0 m"], B = ["1 m", "0 m"] }
sketch = { at = ["0 m", "0 m"] }
)" + of_arm +
         R"([bodies.rod]
points = { P = ["0 m", "0 m"], Q = ["2 m", "0 m"] }
sketch = { at = ["1 m", "0 m"], angle = "40 deg" }
)" + of_rod +
         R"([joints.pivot]
kind = "pin"
connect = ["arm.A", "ground"]
at = ["0 m", "0 m"]
[joints.knee]
kind = "rigid"
connect = ["arm.B", "rod.P"]
angle = "40 deg"
[drivers.swing]
kind = "harmonic"
point = "arm.A"
coordinate = "angle"
mean = "0 deg"
amplitude = "20 deg"
frequency = "0.3 Hz"
[forces.load]
kind = "force"
point = "rod.Q"
direction = "-90 deg"
size = "500 N"
)" + beams;
}

/// Factors of all checks, by their names.
std::map<std::string, double> factors_of(const Verification& verification) {
  std::map<std::string, double> factors;
  for (const CheckResult& result : verification.checks)
    factors[result.check.id] = result.check.safety_factor;
  return factors;
}

void check_alike(const Verification& of, const Verification& alone) {
  const auto factors = factors_of(of), expected = factors_of(alone);
  REQUIRE(!factors.empty());
  REQUIRE(factors.size() == expected.size());
  for (const auto& [id, factor] : expected) {
    INFO(id);
    REQUIRE(factors.count(id) == 1);
    CHECK(factors.at(id) == Approx(factor).epsilon(1e-9));
  }
}

std::vector<VerifiedBeam> verified(const std::string& text) {
  const test::TemporaryFolder folder;
  return verify_beams(read_beams(folder.write("case.toml", text)));
}

Verification alone(const std::string& text) { return verify(parse_project("alone.toml", text)); }

std::string complaints(const std::string& text) {
  const test::TemporaryFolder folder;
  return test::complaints_of([&] { return read_beams(folder.write("case.toml", text)); });
}

const std::string arm = "[[beam]]\nname = \"arm\"\nbody = \"arm\"\n" + density + segment_of_arm;
const std::string rod = "[[beam]]\nname = \"rod\"\nbody = \"rod\"\n" + density + segments_of_rod;

}  // namespace

TEST_CASE("Each of two beams of a mechanism has the factors that it has alone, the other a bar") {
  const std::vector<VerifiedBeam> both = verified(kinked_pair("", "", arm + rod));
  REQUIRE(both.size() == 2);
  check_alike(
      both[0].verification,
      alone(kinked_pair("", mass_of(2.0), "[beam]\nbody = \"arm\"\n" + density + segment_of_arm)));
  check_alike(
      both[1].verification,
      alone(kinked_pair(mass_of(1.0), "", "[beam]\nbody = \"rod\"\n" + density + segments_of_rod)));
  // The knee passes the same moment from one beam to the other.
  const auto moment_at = [](const VerifiedBeam& beam, double s, Side side) {
    for (const StationEnvelope& station : beam.verification.stations) {
      if (station.station.s.value() == s && station.station.side != side)
        return station.of[cut_force::M_y];
    }
    FAIL("no station at " << s);
    return Envelope{};
  };
  const Envelope of_arm = moment_at(both[0], 1.0, Side::behind);
  const Envelope of_rod = moment_at(both[1], 0.0, Side::before);
  CHECK(of_arm.largest.value == Approx(of_rod.largest.value).epsilon(1e-9));
  CHECK(of_arm.smallest.value == Approx(of_rod.smallest.value).epsilon(1e-9));
}

TEST_CASE("Each of two beams of a frame has the factors that it has alone, the other a member") {
  const auto frame = [](const std::string& members) {
    return common("static") + members + R"(
[supports.foot]
kind = "fixed"
at = "arm.start"
[joints.knee]
kind = "rigid"
connect = ["arm.end", "rod.start"]
[loads.lift]
kind = "force"
at = "rod.end"
force = ["0 kN", "-1 kN"]
[[situations]]
name = "empty"
loads = { weight = 1.0 }
[[situations]]
name = "loaded"
loads = { weight = 1.0, lift = 1.0 }
[[situations]]
name = "cycle"
between = ["empty", "loaded"]
cycles = 1e6
)";
  };
  const auto without_cycles = [](std::string text) {
    const std::string cycles = "cycles = 1e6\nloading";
    return text.replace(text.find(cycles), cycles.size(), "loading");
  };
  const std::string arm_at = "from = [\"0 m\", \"0 m\"]\nangle = \"0 deg\"\n";
  const std::string rod_at = "from = \"arm.end\"\nangle = \"40 deg\"\n";
  const auto two = verified(
      without_cycles(frame("[[beam]]\nname = \"arm\"\n" + arm_at + density + segment_of_arm +
                           "[[beam]]\nname = \"rod\"\n" + rod_at + density + segments_of_rod)));
  REQUIRE(two.size() == 2);
  // A single beam is called "beam" where it has no name of its own.
  const Verification only_arm = alone(without_cycles(frame(
      "[beam]\nname = \"arm\"\n" + arm_at + density + segment_of_arm + "[members.rod]\n" + rod_at +
      density + "[[members.rod.segments]]\nlength = \"2 m\"\nsection = \"tube\"\n")));
  check_alike(two[0].verification, only_arm);
  // By hand: M at the knee is 1 kN times the rod's reach, W of the tube by its diameters.
  const double reach = 2.0 * std::cos(40.0 * std::numbers::pi / 180.0);
  const double W = std::numbers::pi / 32.0 * (std::pow(0.1, 4) - std::pow(0.09, 4)) / 0.1;
  const double range = 1000.0 * reach / W * 1e-6;
  const CheckResult* const fatigue = two[1].verification.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  CHECK(fatigue->check.station.s.value() == 0.0);
  // N of the load, -1 kN sin 40 deg, adds to the range on one side.
  const double area = std::numbers::pi / 4.0 * (0.1 * 0.1 - 0.09 * 0.09);
  const double axial = 1000.0 * std::sin(40.0 * std::numbers::pi / 180.0) / area * 1e-6;
  CHECK(fatigue->check.acting.value() * 1e-6 == Approx(range + axial).epsilon(1e-9));
}

TEST_CASE("Each of two beams in space has the factors that it has alone, the other a rod") {
  const auto chain =
      [](const std::string& of_arm, const std::string& of_rod, const std::string& beams) {
        return common("spatial") + R"(
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[model]
demand = "rigid"
[bodies.arm]
points = { A = ["0 m", "0 m", "0 m"], B = ["1 m", "0 m", "0 m"] }
)" + of_arm + R"([bodies.rod]
points = { P = ["0 m", "0 m", "0 m"], Q = ["0 m", "2 m", "0 m"] }
)" + of_rod + R"([joints.pivot]
kind = "revolute"
axis = "z"
connect = ["ground", "arm.A"]
at = ["0 m", "0 m", "0 m"]
[joints.knee]
kind = "fixed"
connect = ["arm.B", "rod.P"]
[drivers.turn]
joint = "pivot"
kind = "harmonic"
mean = "0 deg"
amplitude = "60 deg"
frequency = "0.7 Hz"
)" + beams;
      };
  const std::string of_arm = "body = \"arm\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n" + density;
  const std::string of_rod = "body = \"rod\"\nstart = \"P\"\naxis = \"y\"\nz = \"z\"\n" + density;
  const auto mass = [](double length, const char* ends) {
    const double area = std::numbers::pi / 4.0 * (0.1 * 0.1 - 0.09 * 0.09);
    return fmt::format("mass = \"{:.17g} kg\"\nuniform_rod = {}\n", 7850.0 * area * length, ends);
  };
  const auto two = verified(chain("", "",
                                  "[[beam]]\nname = \"arm\"\n" + of_arm + segment_of_arm +
                                      "[[beam]]\nname = \"rod\"\n" + of_rod + segments_of_rod));
  REQUIRE(two.size() == 2);
  check_alike(two[0].verification,
              alone(chain("", mass(2.0, "[\"P\", \"Q\"]"), "[beam]\n" + of_arm + segment_of_arm)));
  check_alike(two[1].verification,
              alone(chain(mass(1.0, "[\"A\", \"B\"]"), "", "[beam]\n" + of_rod + segments_of_rod)));
}

TEST_CASE("What beams have in common is solved once, and only what is the same") {
  const SharedMotions shared;
  int solved = 0;
  const auto solve = [&] { return ++solved; };
  CHECK(*shared.once<int>(0, solve) == 1);
  const SharedMotions copy = shared;
  CHECK(*copy.once<int>(0, solve) == 1);
  CHECK(*copy.once<int>(1, solve) == 2);  // another situation
  CHECK(*SharedMotions().once<int>(0, solve) == 3);
}

TEST_CASE("A beam says itself what differs, key by key") {
  std::string strict = rod;
  strict.insert(strict.find("[[beam.segments]]"), R"([beam.strength]
required = 2.0
[beam.material]
steel = "S235"
[beam.fatigue]
category = 50
[[beam.fatigue.details]]
name = "lug"
from = "0.5 m"
to = "0.6 m"
category = 36
)");
  const test::TemporaryFolder folder;
  const std::vector<Project> beams =
      read_beams(folder.write("case.toml", kinked_pair("", "", arm + strict)));
  REQUIRE(beams.size() == 2);
  CHECK(beams[0].material.name == "S355");
  CHECK(beams[1].material.name == "S235");
  CHECK(beams[0].strength.required == 1.0);
  CHECK(beams[1].strength.required == 2.0);
  CHECK(beams[0].fatigue.details.empty());
  REQUIRE(beams[1].fatigue.details.size() == 1);
  // At 2e6 cycles the curve has the value of its category.
  const auto category = [](const Project& project) {
    return strength_at(curve_of(project.fatigue.beam.detail), 2e6, Loading::spectrum).value() *
           1e-6;
  };
  CHECK(category(beams[0]) == Approx(100.0));
  CHECK(category(beams[1]) == Approx(50.0));
  CHECK(beams[1].fatigue.required == 1.0);  // of the case
}

TEST_CASE("Of several beams the worst decides, and the results name each") {
  std::string weak = rod;
  weak.insert(weak.find("[[beam.segments]]"), "[beam.strength]\nrequired = 1000.0\n");
  const std::vector<VerifiedBeam> beams = verified(kinked_pair("", "", arm + weak));
  CHECK(worst_of(beams).project.beam_name == "rod");
  CHECK(beams[0].verification.verdict == Verdict::pass);
  const nlohmann::json json = nlohmann::json::parse(results_json(beams));
  CHECK(json["verdict"] == "fail");
  REQUIRE(json["beams"].size() == 2);
  CHECK(json["beams"][0]["name"] == "arm");
  CHECK(json["beams"][0]["verdict"] == to_text(beams[0].verification.verdict));
  CHECK(json["beams"][1]["verdict"] == "fail");
  CHECK(json["beam"]["length"] == json["beams"][1]["length"]);
  std::map<std::string, std::size_t> counts;
  double last = INFINITY;
  for (const auto& check : json["checks"]) {
    ++counts[check["beam"]];
    CHECK(check["utilisation"].get<double>() <= last);
    last = check["utilisation"];
  }
  CHECK(counts["arm"] == beams[0].verification.checks.size());
  CHECK(counts["rod"] == beams[1].verification.checks.size());
}

TEST_CASE("What is wrong with several beams is said") {
  const std::string unnamed = "[[beam]]\nbody = \"rod\"\n" + density + segments_of_rod;
  CHECK(
      contains(complaints(kinked_pair("", "", arm + unnamed)), "of several beams each has a name"));
  std::string twice = rod;
  twice.replace(twice.find("\"rod\""), 5, "\"arm\"");
  CHECK(contains(complaints(kinked_pair("", "", arm + twice)), "there is already a beam \"arm\""));
  std::string same_body = rod;
  same_body.replace(same_body.find("body = \"rod\""), 12, "body = \"arm\"");
  CHECK(contains(complaints(kinked_pair("", mass_of(2.0), arm + same_body)),
                 "two beams are the body \"arm\""));
  CHECK(
      contains(complaints(kinked_pair("", "", arm + rod) +
                          "[[points]]\nname = \"a\"\nstation = \"0.1 m\"\nz = \"0 mm\"\n"),
               "which of the 2 beams \"points\" is on is not said | write it within its [[beam]], "
               "as \"beam.section_points\""));
  CHECK(contains(complaints(kinked_pair("", "", arm + rod) +
                            "[[fatigue.details]]\nname = \"a\"\nfrom = \"0.1 m\"\nto = \"0.2 m\"\n"
                            "category = 80\n"),
                 "which of the 2 beams \"fatigue.details\" is on"));
  CHECK(contains(complaints(common("loads") + arm + rod), "loads that are given act on one beam"));
  std::string many;
  for (int i = 0; i < 1000; ++i) {
    std::string another = rod;
    many += another.replace(another.find("\"rod\""), 5, fmt::format("\"rod{}\"", i));
  }
  CHECK(contains(complaints(kinked_pair("", "", many)), "1000 beams are too many | at most 50"));
  std::string folder = rod;
  folder.replace(folder.find("\"rod\""), 5, "\"../x\"");
  CHECK(contains(complaints(kinked_pair("", "", arm + folder)), "name of its report folder"));
}

TEST_CASE("The reports of several beams stand in folders of their names, one of all above") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string file = folder.write("case.toml", kinked_pair("", "", arm + rod));
  const test::ProgramResult result =
      test::run_program({"verify", file, "--no-pdf", "--no-plots", "--out", out});
  CHECK(result.exit_code == 0);
  for (const char* name : {"report.txt", "report.html", "results.json", "arm/report.txt",
                           "arm/report.html", "rod/report.txt", "rod/report.html"}) {
    INFO(name);
    CHECK(std::filesystem::exists(std::filesystem::path(out) / name));
  }
  CHECK(!std::filesystem::exists(std::filesystem::path(out) / "arm/results.json"));
  const test::ProgramResult only =
      test::run_program({"verify", file, "--beam", "rod", "--no-pdf", "--no-plots", "--json", "-",
                         "--out", out + "/rod-alone"});
  CHECK(only.exit_code == 0);
  CHECK(nlohmann::json::parse(only.out)["beam"]["length"] == 2.0);
  const test::ProgramResult none = test::run_program({"verify", file, "--beam", "leg"});
  CHECK(none.exit_code == 2);
  CHECK(contains(none.err, "the case has no beam \"leg\""));
}

}  // namespace several_beams_test
