// Frames at rest from the case file to the factor: against the same beam in other kinds of case,
// closed forms of moving loads, and combinations by hand.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/clamped_beam.hpp"
#include "support/refusals.hpp"

namespace frame_front_end_test {

using namespace boxbeam;
using test::contains;

namespace {

const std::string section =
    "[sections.box]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\n"
    "flange = \"12 mm\"\nweb = \"8 mm\"\n";

std::string beam(const std::string& length, const std::string& density = "7850 kg/m^3") {
  return "[beam]\ndensity = \"" + density + "\"\n[[beam.segments]]\nlength = \"" + length +
         "\"\nsection = \"box\"\n";
}

const std::string demands = "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";

Project parse(const std::string& text) {
  return parse_project("frame.toml",
                       "[case]\nname = \"frame\"\nkind = \"static\"\n" + section + text + demands);
}

const std::string fixed_at_start = "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n";
const std::string ends =
    "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
    "[supports.right]\nkind = \"roller\"\nat = \"6 m\"\n";

double largest_moment(const Verification& of) {
  double largest = 0.0;
  for (const StationEnvelope& station : of.stations) {
    for (const Extreme* at :
         {&station.of[cut_force::M_y].smallest, &station.of[cut_force::M_y].largest})
      largest = std::max(largest, std::abs(at->value));
  }
  return largest;
}

TEST_CASE("forces of a joint act at the place that is written, whatever the beam's angle",
          "[frame]") {
  // The axes of an inclined beam turn 1.106897187059307 m in the world into its neighbour.
  const Verification verification = verify(
      parse("[beam]\ndensity = \"7850 kg/m^3\"\nangle = \"-0.3829 rad\"\n"
            "points = { prop = [\"1.106897187059307 m\", \"0 m\"] }\n"
            "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n" +
            fixed_at_start +
            "[members.leg]\nfrom = [\"0.7 m\", \"-3.1 m\"]\nto = \"beam.prop\"\nsection = \"box\"\n"
            "[supports.foot]\nkind = \"fixed\"\nat = \"leg.start\"\n"
            "[joints.top]\nkind = \"rigid\"\nconnect = [\"leg.end\", \"beam.prop\"]\n"
            "[loads.tip]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"7 kN\", \"-30 kN\"]\n"));
  const BeamLoadRow* top = nullptr;
  for (const BeamLoadRow& row : verification.pictures.loads) {
    if (row.name == "top") top = &row;
  }
  REQUIRE(top != nullptr);
  CHECK(top->s.value() == 1.106897187059307);
  // The jump from one side of the station to the other is the joint's force, by equilibrium.
  std::map<Side, double> N;
  for (const StationEnvelope& station : verification.stations) {
    if (station.station.s.value() == 1.106897187059307)
      N[station.station.side] = station.of[cut_force::N].largest.value;
  }
  REQUIRE(N.contains(Side::before));
  REQUIRE(N.contains(Side::behind));
  CHECK(N[Side::before] - N[Side::behind] == Approx(top->force.x()).epsilon(1e-9));
}

TEST_CASE("a cantilever at rest has the factors of the same beam in a mechanism", "[frame]") {
  const Verification moving = verify(test::clamped_beam(test::clamped::steady, ""));
  const Verification still = verify(
      parse("[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("4 m") + fixed_at_start +
            "[loads.tip]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"0 kN\", \"-30 kN\"]\n"));
  // The mechanism has one more place of interest; where both are judged, they are alike.
  std::size_t alike = 0;
  for (const CheckResult& at_rest : still.checks) {
    const auto other =
        std::find_if(moving.checks.begin(), moving.checks.end(),
                     [&](const CheckResult& of) { return of.check.id == at_rest.check.id; });
    if (other == moving.checks.end()) continue;
    ++alike;
    CHECK(at_rest.check.safety_factor == Approx(other->check.safety_factor).epsilon(1e-9));
  }
  CHECK(alike >= 8);
  CHECK(still.checks.front().check.id == moving.checks.front().check.id);
  CHECK(still.verdict == moving.verdict);
}

/// A tapered cantilever of two segments with its weight and a force at its tip, in a kind of case.
std::string tapered(const std::string& kind, const std::string& held, const std::string& of_beam) {
  return "[case]\nname = \"tapered\"\nkind = \"" + kind + "\"\n" + section +
         "[sections.low]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"140 mm\"\n"
         "flange = \"12 mm\"\nweb = \"8 mm\"\n" +
         held + "[beam]\ndensity = \"7850 kg/m^3\"\n" + of_beam +
         "[[beam.segments]]\nlength = \"1.5 m\"\nsection = \"box\"\n"
         "[[beam.segments]]\nlength = \"2.5 m\"\nfrom = \"box\"\nto = \"low\"\n" +
         demands;
}

TEST_CASE(
    "a tapered beam at rest, in a mechanism, elastic and under given loads has the same factors",
    "[frame]") {
  const std::string gravity = "gravity = [\"1 m/s^2\", \"-9.81 m/s^2\"]\n";
  const Verification still = verify(parse_project(
      "a.toml",
      tapered("static",
              "[frame]\n" + gravity + fixed_at_start +
                  "[loads.tip]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"5 kN\", \"-20 kN\"]\n",
              "")));
  const Verification moving = verify(parse_project(
      "b.toml",
      tapered(
          "planar",
          "[mechanism]\n" + gravity +
              "[motion]\nduration = \"1 s\"\n[bodies.beam]\npoints = { A = [\"0 m\", \"0 m\"], B = "
              "[\"4 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] }\n"
              "[joints.root]\nkind = \"rigid\"\nconnect = [\"beam.A\", \"ground\"]\n"
              "at = [\"0 m\", \"0 m\"]\nangle = \"0 deg\"\n"
              "[forces.x]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"0 deg\"\nsize = \"5 "
              "kN\"\n"
              "[forces.y]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"-90 deg\"\nsize = "
              "\"20 kN\"\n",
          "body = \"beam\"\n")));
  const Verification elastic = verify(parse_project(
      "c.toml",
      tapered("flexible",
              "[mechanism]\n" + gravity +
                  "[links.beam]\nkind = \"full\"\norigin = [\"0 m\", \"0 m\"]\nparts = 16\n"
                  "[joints.root]\nkind = \"general\"\nconnect = [\"beam.start\", \"ground\"]\n"
                  "stiffness = \"rigid\"\nturning_stiffness = \"rigid\"\n"
                  "[loads.tip]\non = \"beam.end\"\nforce = [\"5 kN\", \"-20 kN\"]\n",
              "link = \"beam\"\n")));
  // Forces of the beam's axes, x along it and z to its left.
  const Verification given = verify(parse_project(
      "d.toml", tapered("loads",
                        "[loads.tip]\nstation = \"4 m\"\nforce = [\"5 kN\", \"0 kN\", \"-20 kN\"]\n"
                        "[balance]\nstation = \"0 m\"\n"
                        "gravity = [\"1 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n",
                        "")));
  const CheckResult* at_rest = still.governing(Criterion::yield);
  REQUIRE(at_rest != nullptr);
  for (const Verification* other : {&moving, &elastic, &given}) {
    const CheckResult* yield = other->governing(Criterion::yield);
    REQUIRE(yield != nullptr);
    CHECK(yield->check.safety_factor == Approx(at_rest->check.safety_factor).epsilon(1e-9));
    const CheckResult* weld = other->governing(Criterion::weld);
    REQUIRE(weld != nullptr);
    CHECK(weld->check.safety_factor ==
          Approx(still.governing(Criterion::weld)->check.safety_factor).epsilon(1e-9));
  }
}

std::string complaints_of(const std::string& text) {
  return test::complaints_of([&] { return parse(text); });
}

TEST_CASE("what is wrong with a member does not hide what is wrong with its supports and loads",
          "[frame]") {
  const std::string said = complaints_of(
      "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlenght = \"4 m\"\nsection = \"box\"\n"
      "[supports.root]\nkind = \"fixd\"\nat = \"0 m\"\n"
      "[members.strut]\nfrom = [\"0 m\", \"-1 m\"]\nto = \"beam.end\"\nsection = \"bax\"\n"
      "[joints.top]\nkind = \"hinge\"\nconnect = [\"strut.end\", \"beam.end\"]\n"
      "[loads.tip]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"5 kN\"]\n"
      "[loads.sinks]\nkind = \"settlement\"\nsupport = \"root\"\nshift = [\"0 m\", \"1 mm\"]\n");
  CHECK(contains(said, "unknown key \"lenght\" | did you mean \"length\"?"));
  CHECK(contains(said, "\"kind\" cannot be \"fixd\""));
  CHECK(contains(said, "\"bax\""));
  CHECK(contains(said, "\"force\""));
  // Each mistake is said once, and nothing that only follows from another.
  CHECK(std::count(said.begin(), said.end(), '\n') == 4);
}

TEST_CASE("of several beams a load says on which it stands", "[frame]") {
  const std::string two =
      "[[beam]]\nname = \"boom\"\ndensity = \"7850 kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"box\"\n"
      "[[beam]]\nname = \"jib\"\nfrom = \"boom.end\"\ndensity = \"7850 kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n"
      "[joints.knee]\nkind = \"rigid\"\nconnect = [\"boom.end\", \"jib.start\"]\n"
      "[supports.foot]\nkind = \"fixed\"\nat = \"boom.start\"\n";
  const std::string load =
      "[loads.tip]\nkind = \"force\"\nat = \"1 m\"\nforce = [\"0 kN\", \"-5 kN\"]\n";
  CHECK(complaints_of(two + load) ==
        "on which of the 2 beams it is, is not said | write for example on = \"boom\"\n");
  CHECK(complaints_of(two + load + "on = \"jib\"\n").empty());
}

TEST_CASE("of what stands still no instants are shown, of wheels that run they are", "[frame]") {
  const std::string held = beam("6 m") + ends;
  const auto instants_in = [&](const std::string& load) {
    const Project project = parse(held + load);
    const report::Document document = report_of(project, verify(project), ReportLevel::full);
    std::size_t tables = 0;
    const auto count = [&](const report::Table& table) {
      tables +=
          static_cast<std::size_t>(std::count(table.header.begin(), table.header.end(), "t [s]"));
      for (const auto& row : table.rows) CHECK(row.size() == table.header.size());
    };
    count(document.governing);
    for (const report::Chapter& chapter : document.chapters) {
      for (const report::Block& block : chapter.blocks) {
        if (const auto* table = std::get_if<report::Table>(&block)) count(*table);
      }
    }
    return tables;
  };
  CHECK(instants_in("[loads.mid]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-20 "
                    "kN\"]\n") == 0);
  CHECK(instants_in("[loads.trolley]\nkind = \"wheels\"\n"
                    "wheels = [{ force = [\"0 kN\", \"-20 kN\"] }]\n") >= 3);
}

TEST_CASE("two wheels: largest moment R (L/2 - a/4)^2/L under the first", "[frame]") {
  // Two equal forces P = R/2 at a distance a. Source: Timoshenko, Young, Theory of Structures, 3.7.
  constexpr double L = 6.0, a = 1.2, R = 40e3;
  const Verification of = verify(
      parse("[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("6 m") + ends +
            "[loads.trolley]\nkind = \"wheels\"\nwheels = [{ force = [\"0 kN\", \"-20 kN\"] }, "
            "{ behind = \"1.2 m\", force = [\"0 kN\", \"-20 kN\"] }]\n"));
  const double expected = R * std::pow(0.5 * L - 0.25 * a, 2) / L;
  CHECK(largest_moment(of) == Approx(expected).epsilon(1e-4));
  CHECK(largest_moment(of) <= expected * (1.0 + 1e-9));
  const CheckResult* yield = of.governing(Criterion::yield);
  REQUIRE(yield != nullptr);
  const double W = test::clamped::inertia() / 0.150;
  // Von Mises adds a little shear to the bending stress.
  CHECK(yield->check.safety_factor == Approx(355e6 * W / expected).epsilon(2e-3));
  CHECK(yield->check.safety_factor <= 355e6 * W / expected);
  // Reactions run from nothing to nearly all.
  const std::vector<SupportReaction>& reactions = of.motions.front().reactions;
  REQUIRE(reactions.size() == 2);
  CHECK(reactions[0].high[1] == Approx(R * (L - 0.5 * a) / L).epsilon(1e-9));
  CHECK(reactions[1].high[1] == Approx(R * (L - 0.5 * a) / L).epsilon(1e-9));
}

TEST_CASE("wheels far apart run on and off: the largest moment is that of one alone, P L/4",
          "[frame]") {
  constexpr double P = 350e3, L = 6.0;
  const auto moment = [](const std::string& apart, const std::string& way) {
    return largest_moment(
        verify(parse("[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("6 m") + ends +
                     "[loads.trolley]\nkind = \"wheels\"\n" + way +
                     "wheels = [{ force = [\"0 kN\", \"-350 kN\"] }, { behind = \"" + apart +
                     "\", force = [\"0 kN\", \"-350 kN\"] }]\n")));
  };
  CHECK(moment("5 m", "") == Approx(P * L / 4.0).epsilon(1e-4));
  CHECK(moment("5 m", "from = \"0 m\"\nto = \"11 m\"\n") == Approx(P * L / 4.0).epsilon(1e-4));
  // Farther apart than the beam is long.
  CHECK(moment("7 m", "") == Approx(P * L / 4.0).epsilon(1e-4));
  // As long as both stand on the beam, which is asked for: one over a support, the other 1 m from
  // the other one.
  CHECK(moment("5 m", "from = \"5 m\"\nto = \"6 m\"\n") == Approx(P * 1.0 * 5.0 / L).epsilon(1e-4));
}

TEST_CASE("the search is as close as it says where wheels stand at the ends of their way",
          "[frame]") {
  const Verification of =
      verify(parse("[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("6 m") + ends +
                   "[supports.middle]\nkind = \"roller\"\nat = \"2.6 m\"\n"
                   "[loads.trolley]\nkind = \"wheels\"\nfrom = \"0.9 m\"\nto = \"5.3 m\"\n"
                   "wheels = [{ force = [\"0 kN\", \"-20 kN\"] }]\n"));
  CHECK(of.search.tolerance <= 1e-4);
}

TEST_CASE("wheels that run over the ends load only what is on the beam", "[frame]") {
  const Verification of =
      verify(parse("[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("6 m") + ends +
                   "[loads.trolley]\nkind = \"wheels\"\nfrom = \"0 m\"\nto = \"10 m\"\nwheels = "
                   "[{ force = [\"0 kN\", \"-20 kN\"] }, { behind = \"4 m\", force = [\"0 kN\", "
                   "\"-20 kN\"] }]\n"));
  // So far apart that one alone in the middle is worse than both.
  CHECK(largest_moment(of) == Approx(20e3 * 6.0 / 4.0).epsilon(1e-4));
  CHECK(of.motions.front().reactions[0].high[1] == Approx(20e3 * (1.0 + 2.0 / 6.0)).epsilon(1e-9));
}

/// Names of situations and the factors of their load cases.
std::map<std::string, std::vector<double>> combinations_of(const Project& project) {
  std::map<std::string, std::vector<double>> of;
  for (const Situation& situation : project.situations)
    of[situation.name] = frame_in(project, situation).factors;
  return of;
}

const std::string loads =
    "[loads.wind]\nkind = \"line\"\nforce_per_length = [\"0 N/m\", \"300 N/m\"]\n"
    "[loads.snow]\nkind = \"line\"\nforce_per_length = [\"0 N/m\", \"-500 N/m\"]\n"
    "[load_cases.wind]\nkind = \"variable\"\npsi_0 = 0.6\npsi_1 = 0.2\npsi_2 = 0.0\n"
    "[load_cases.snow]\nkind = \"variable\"\npsi_0 = 0.5\npsi_1 = 0.2\npsi_2 = 0.0\n";

TEST_CASE("EN 1990 6.10: every variable action leads once, what helps is left out", "[frame]") {
  const auto found =
      combinations_of(parse(beam("6 m") + ends + loads + "[combinations]\nrule = \"6.10\"\n"));
  // Table by hand, of (weight, wind, snow): G 1.35 or 1.0; Q leading 1.5, beside it 1.5 psi_0 or 0.
  std::vector<std::vector<double>> expected;
  for (const double G : {1.35, 1.0}) {
    expected.push_back({G, 1.5, 0.75});
    expected.push_back({G, 1.5, 0.0});
    expected.push_back({G, 0.9, 1.5});
    expected.push_back({G, 0.0, 1.5});
    expected.push_back({G, 0.0, 0.0});
  }
  CHECK(found.size() == expected.size());
  for (const std::vector<double>& of : expected) {
    INFO(of[0] << " " << of[1] << " " << of[2]);
    const bool there = std::any_of(found.begin(), found.end(), [&](const auto& entry) {
      return (Eigen::Map<const Eigen::Vector3d>(entry.second.data()) -
              Eigen::Map<const Eigen::Vector3d>(of.data()))
                 .norm() < 1e-12;
    });
    CHECK(there);
  }
  CHECK(found.count("6.10: 1.35 weight + 1.5 wind + 0.75 snow") == 1);
}

TEST_CASE("EN 1990 6.10a and 6.10b", "[frame]") {
  const auto found =
      combinations_of(parse(beam("6 m") + ends + loads + "[combinations]\nrule = \"6.10a/b\"\n"));
  // a: psi_0 on the leader, too; b: xi gamma_G = 1.1475.
  CHECK(found.count("6.10a: 1.35 weight + 0.9 wind + 0.75 snow") == 1);
  CHECK(found.count("6.10b: 1.1475 weight + 1.5 wind + 0.75 snow") == 1);
  CHECK(found.count("6.10b: 1.1475 weight + 0.9 wind + 1.5 snow") == 1);
  // a: 2 x 2 x 2; b: 2 x 5, of which 1.0 G alone is in a already.
  CHECK(found.size() == 8 + 10 - 1);
}

TEST_CASE("deflection has combinations of its own and strength does not see them", "[frame]") {
  const Project project = parse(beam("6 m") + ends + loads +
                                "[combinations]\nrule = \"6.10\"\ndeflection = \"characteristic\"\n"
                                "[deflection]\nlimit = \"10 mm\"\n");
  const Verification of = verify(project);
  const CheckResult* bent = of.governing(Criterion::deflection);
  REQUIRE(bent != nullptr);
  CHECK(bent->check.situation == "characteristic: 1 weight + 1 snow");
  // 5 q L^4/(384 E I) and q L^2/(8 G A_v) of shear.
  const double q = 500.0 + 9.81 * 7850.0 * (0.150 * 0.300 - 0.134 * 0.276);
  const double expected = 5.0 * q * std::pow(6.0, 4) / (384.0 * 210e9 * test::clamped::inertia()) +
                          q * 36.0 / (8.0 * 81e9 * test::clamped::shear_area());
  CHECK(bent->check.acting.value() == Approx(expected).epsilon(1e-9));
  const CheckResult* yield = of.governing(Criterion::yield);
  REQUIRE(yield != nullptr);
  CHECK(yield->check.situation == "6.10: 1.35 weight + 1.5 snow");
}

TEST_CASE("what all variable actions relieve bends most where none of them acts", "[frame]") {
  const std::string wind =
      "[loads.wind]\nkind = \"line\"\nforce_per_length = [\"0 N/m\", \"100 N/m\"]\n"
      "[load_cases.wind]\nkind = \"variable\"\npsi_0 = 0.6\npsi_1 = 0.2\npsi_2 = 0.0\n";
  for (const std::string rule : {"characteristic", "frequent", "quasi-permanent"}) {
    const Verification of = verify(parse(beam("6 m") + ends + wind +
                                         "[combinations]\nrule = \"6.10\"\ndeflection = \"" + rule +
                                         "\"\n[deflection]\nlimit = \"10 mm\"\n"));
    const CheckResult* bent = of.governing(Criterion::deflection);
    REQUIRE(bent != nullptr);
    CHECK(bent->check.situation == rule + ": 1 weight");
  }
}

TEST_CASE("fatigue counts the cycle between two load situations without partial factors",
          "[frame]") {
  const std::string text =
      beam("6 m") + ends +
      "[loads.lift]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-20 kN\"]\n"
      "[load_cases.lift]\nkind = \"variable\"\npsi_0 = 1.0\n[combinations]\nrule = \"6.10\"\n"
      "[[situations]]\nname = \"empty\"\nloads = { weight = 1.0 }\n"
      "[[situations]]\nname = \"full\"\nloads = { weight = 1.0, lift = 1.0 }\n"
      "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"full\"]\ncycles = 2e6\n"
      "[fatigue]\ncategory = 71\nloading = \"constant amplitude\"\ngamma_Mf = 1.35\nrequired = "
      "1.0\n";
  const Verification of = verify(parse(text));
  const CheckResult* fatigue = of.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  const double range = 20e3 * 6.0 / 4.0 * 0.150 / test::clamped::inertia();
  CHECK(fatigue->check.safety_factor == Approx(71e6 / 1.35 / range).epsilon(1e-6));
}

namespace {

/// A beam whose weight presses where its lift pulls and the other way round; `relieved`: of its
/// compression 60 % count.
std::string lifted(bool relieved, const std::string& changes) {
  const auto situation = [](const std::string& name, const std::string& share) {
    return "[[situations]]\nname = \"" + name + "\"\nloads = { weight = 1.0, lift = " + share +
           " }\n";
  };
  return beam("6 m") + ends +
         "[loads.lift]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"28 kN\"]\n" +
         "[[situations]]\nname = \"empty\"\nloads = { weight = 1.0 }\n" + situation("full", "1.0") +
         situation("half", "0.5") + situation("little", "0.125") + changes +
         "[fatigue]\ncategory = 71\nloading = \"spectrum\"\ngamma_Mf = 1.35\nrequired = 1.0\n" +
         (relieved ? "stress_relieved = true\n" : "");
}

double fatigue_factor(const std::string& text) {
  const Verification of = verify(parse(text));
  const CheckResult* const fatigue = of.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  return fatigue->check.safety_factor;
}

}  // namespace

TEST_CASE("levels of a change count as changes to loads of their share", "[frame]") {
  for (const bool relieved : {false, true}) {
    CAPTURE(relieved);
    const double one_by_one = fatigue_factor(
        lifted(relieved,
               "[[situations]]\nname = \"1\"\nbetween = [\"empty\", \"full\"]\ncycles = 1e5\n"
               "[[situations]]\nname = \"2\"\nbetween = [\"empty\", \"half\"]\ncycles = 3e6\n"
               "[[situations]]\nname = \"3\"\nbetween = [\"empty\", \"little\"]\ncycles = 4e7\n"));
    const auto levels = [&](const std::string& of) {
      return fatigue_factor(lifted(relieved, "[[situations]]\nname = \"levels\"\n" + of + "\n"));
    };
    CHECK(levels("between = [\"empty\", \"full\"]\nspectrum = [{ share = 0.125, cycles = 4e7 }, { "
                 "share = 1.0, cycles = 1e5 }, { share = 0.5, cycles = 3e6 }]") ==
          Approx(one_by_one).epsilon(1e-9));
    // A spectrum for each of so many years, one level written in two parts.
    CHECK(
        levels("between = [\"empty\", \"full\"]\ncycles = 20\nspectrum = [{ share = 1.0, cycles = "
               "5e3 }, { share = 0.5, cycles = 5e4 }, { share = 0.5, cycles = 1e5 }, { share = "
               "0.125, cycles = 2e6 }]") == Approx(one_by_one).epsilon(1e-9));
    // Only whole changes.
    CHECK(levels("between = [\"empty\", \"full\"]\nspectrum = [{ share = 1.0, cycles = 1e5 }]") ==
          Approx(levels("between = [\"empty\", \"full\"]\ncycles = 1e5")).epsilon(1e-12));
    // From the full load down the same levels are others where the mean counts.
    const double from_full = levels(
        "between = [\"full\", \"empty\"]\nspectrum = [{ share = 0.125, cycles = 4e7 }, { share = "
        "1.0, cycles = 1e5 }, { share = 0.5, cycles = 3e6 }]");
    if (relieved) {
      CHECK(std::abs(from_full / one_by_one - 1.0) > 1e-3);
    } else {
      CHECK(from_full == Approx(one_by_one).epsilon(1e-9));
    }
  }
}

TEST_CASE("levels of a change are Miner's sum by hand", "[frame]") {
  const double factor = fatigue_factor(
      lifted(false,
             "[[situations]]\nname = \"levels\"\nbetween = [\"empty\", \"full\"]\nspectrum = "
             "[{ share = 1.0, cycles = 1e6 }, { share = 0.8, cycles = 1e6 }]\n"));
  // Both ranges above the constant amplitude limit at the factor's stress: slope 3 alone.
  const double range = 28e3 * 6.0 / 4.0 * 0.150 / test::clamped::inertia();
  const double equivalent = range * std::cbrt((1.0 + std::pow(0.8, 3)) / 2.0);
  CHECK(factor == Approx(71e6 / 1.35 / equivalent).epsilon(1e-6));
}

TEST_CASE("a load over time bends a frame as it stands at that time", "[frame]") {
  // Two forces at quarter points, one swinging: M in the middle is (F_1 + F_2(t)) L/8 each.
  const Verification of = verify(parse(
      "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" + beam("6 m") + ends +
      "[loads.steady]\nkind = \"driven\"\nat = \"1.5 m\"\ndirection = \"-90 deg\"\nsize = "
      "\"8 kN\"\n[loads.swinging]\nkind = \"driven\"\nat = \"4.5 m\"\ndirection = \"-90 deg\"\n"
      "law = { kind = \"harmonic\", mean = \"4 kN\", amplitude = \"6 kN\", frequency = \"2 Hz\" "
      "}\n"));
  CHECK(of.motions.front().period.value() == Approx(0.5));
  CHECK(of.motions.front().closed);
  // At s = 4.5 m: F_1 L/16 + 3 F_2 L/16.
  CHECK(largest_moment(of) == Approx(8e3 * 6.0 / 16.0 + 3.0 * 10e3 * 6.0 / 16.0).epsilon(1e-9));
  // At the right support: F_1/4 + 3 F_2/4.
  CHECK(of.motions.front().reactions[1].high[1] == Approx(2e3 + 7.5e3).epsilon(1e-9));
  CHECK(of.motions.front().reactions[1].low[1] == Approx(2e3 - 1.5e3).epsilon(1e-9));
}

TEST_CASE("a frame buckles under the worst of all instants", "[frame]") {
  // A free-standing column under pulses P (1 + 2 cos wt + .. + 2 cos 8wt)/17, P at their peak.
  // Source of N_cr = pi^2 E I/(4 L^2): Timoshenko, Gere, Theory of Elastic Stability (1961), 2.1.
  std::string further;
  for (int k = 2; k <= 8; ++k) {
    further += (k > 2 ? ", " : "") + std::string("{ amplitude = \"20 kN\", phase = \"90 deg\", ") +
               "frequency = \"" + std::to_string(k) + " Hz\" }";
  }
  const Verification of = verify(parse(
      "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[beam]\nangle = \"90 deg\"\ndensity = "
      "\"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"10 m\"\nsection = \"box\"\n" +
      fixed_at_start +
      "[loads.press]\nkind = \"driven\"\nat = \"10 m\"\ndirection = \"-90 deg\"\n"
      "law = { kind = \"harmonic\", mean = \"10 kN\", amplitude = \"20 kN\", phase = \"90 deg\", "
      "frequency = \"1 Hz\", further = [" +
      further + "] }\n"));
  const double critical = std::pow(std::numbers::pi / 20.0, 2) * 210e9 * test::clamped::inertia();
  CHECK(of.verdict == Verdict::not_applicable);
  double found = 0.0;
  for (const Gate& gate : of.gates) {
    const std::string before = "buckles elastically at ";
    const std::size_t at = gate.finding.find(before);
    if (at != std::string::npos) found = std::stod(gate.finding.substr(at + before.size()));
  }
  CHECK(found == Approx(critical / 170e3).epsilon(3e-3));
}

TEST_CASE("what a frame cannot be is said with what to write", "[frame]") {
  const auto refusal = [](const std::string& text) {
    try {
      parse(text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal(beam("6 m") + "[supports.a]\nkind = \"pinned\"\nat = \"7 m\"\n"),
             Contains("s = 7 m is beyond member \"beam\""));
  CHECK_THAT(
      refusal(beam("6 m") + ends +
              "[loads.a]\nkind = \"force\"\nat = \"beem.end\"\nforce = [\"0 N\", \"1 N\"]\n"),
      Contains("not a point of a member"));
  CHECK_THAT(refusal(beam("6 m") + ends + loads +
                     "[combinations]\nrule = \"6.10\"\n[load_cases.rain]\nkind = \"permanent\"\n"),
             Contains("no load is in a case \"rain\""));
  CHECK_THAT(refusal(beam("6 m") + ends +
                     "[loads.a]\nkind = \"force\"\nat = \"1 m\"\nforce = [\"0 N\", \"1 "
                     "N\"]\n[combinations]\nrule = \"6.10\"\n"),
             Contains("how load case \"a\" combines is not said"));
  const auto wheels = [](const std::string& name) {
    return "[loads." + name + "]\nkind = \"wheels\"\nwheels = [{ force = [\"0 N\", \"-1 N\"] }]\n";
  };
  CHECK_THAT(refusal(beam("6 m") + ends + wheels("crab") + wheels("crane")),
             Contains("wheels \"crane\" and load \"crab\" change independently"));
  CHECK_THAT(refusal(beam("6 m") + ends + wheels("crab") +
                     "[loads.swing]\nkind = \"driven\"\nat = \"3 m\"\ndirection = \"-90 deg\"\n"
                     "law = { kind = \"harmonic\", mean = \"4 kN\", amplitude = \"6 kN\", "
                     "frequency = \"2 Hz\" }\n"),
             Contains("change independently"));
  CHECK_THAT(refusal(beam("6 m") + ends + "[bodies.a]\nmass = \"1 kg\"\n"),
             Contains("not known of frames at rest"));
  CHECK_THAT(
      refusal(beam("6 m") + ends +
              "[members.a]\nfrom = [\"0 m\", \"1 m\"]\nto = [\"1 m\", \"1 m\"]\nsection = \"box\"\n"
              "[joints.j]\nkind = \"rigid\"\nconnect = [\"beam.end\", \"a.end\"]\n"),
      Contains("mm apart"));
}

}  // namespace

TEST_CASE("a situation without the weight, and load cases that no one combines, are said",
          "[frame]") {
  const auto remarks = [](const std::string& situations) {
    const Project project =
        parse(beam("2 m") + fixed_at_start +
              "[loads.tip]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"-1 kN\"]\n" +
              situations);
    std::string all;
    for (const Remark& remark : remarks_of(project, verify(project))) all += remark.text + "\n";
    return all;
  };
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string left_out =
      remarks("[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n");
  CHECK(contains(left_out, "own weight is left out of situation loaded"));
  CHECK(!contains(left_out, "all load cases act together"));
  const std::string counted =
      remarks("[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0, weight = 1.0 }\n");
  CHECK(!contains(counted, "left out"));
  const std::string together = remarks("");
  CHECK(!contains(together, "left out"));
  CHECK(contains(together, "all load cases act together, each with the factor 1.0"));
}

}  // namespace frame_front_end_test
