// Loads from files: against the same beam in other kinds of case, and what is said of bad input.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"
#include "support/table_cantilever.hpp"

namespace recorded_front_end_test {

using namespace boxbeam;
using test::contains;

namespace {

const std::string demands =
    "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n"
    "[fatigue]\ncategory = 71\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
    "required = 1.0\n";

const std::string box =
    "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
    "flange = \"10 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
    "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n";

std::string text_of(const std::string& loads) {
  return "[case]\nname = \"given\"\nkind = \"loads\"\n" + box + loads + demands;
}

Project given(const test::TemporaryFolder& folder, const std::string& loads) {
  return read_project(folder.write("case.toml", text_of(loads)));
}

/// What is said of a case that cannot be read.
std::string complaint(const test::TemporaryFolder& folder, const std::string& loads) {
  return test::complaints_of([&] { return given(folder, loads); });
}

void check_same_factors(const Verification& a, const Verification& b, std::size_t least) {
  std::size_t alike = 0;
  for (const CheckResult& of : a.checks) {
    const auto other = std::find_if(b.checks.begin(), b.checks.end(), [&](const CheckResult& at) {
      return at.check.id == of.check.id;
    });
    if (other == b.checks.end()) continue;
    ++alike;
    INFO(of.check.id);
    CHECK(of.check.safety_factor == Approx(other->check.safety_factor).epsilon(1e-9));
  }
  CHECK(alike >= least);
  CHECK(a.verdict == b.verdict);
  REQUIRE(!a.checks.empty());
  CHECK(a.checks.front().check.utilisation() ==
        Approx(b.checks.front().check.utilisation()).epsilon(1e-9));
}

const std::string file = "[files.measured]\npath = \"force.csv\"\n";
const std::string push = "[loads.push]\nstation = \"1 m\"\ncolumns = { F_z = \"force\" }\n";
const std::string root = "[balance]\nstation = \"0 m\"\nname = \"root\"\n";

}  // namespace

TEST_CASE("a force from a file has the factors of the same force in a mechanism", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  const Verification moving = verify(read_project(
      folder.write("planar.toml", table_cantilever::text("interpolation = \"linear\""))));
  const Verification record = verify(given(folder, file + push + root));
  check_same_factors(record, moving, 5);
}

TEST_CASE("cut forces from a file have the factors of the loads that cause them", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  // V = F and M(s) = F (1 m - s), sign as in the diagram: V_z(0) = F_tip, M_y(0) = -F L.
  folder.write("cuts.csv",
               "time [s], V [kN], M [kN m]\n0, 0, 0\n1, 0, 0\n2, 20, -20\n3, 20, -20\n"
               "4, 0, 0\n5, 0, 0\n");
  const Verification record = verify(given(folder, file + push + root));
  const Verification cuts =
      verify(given(folder,
                   "[files.measured]\npath = \"cuts.csv\"\n"
                   "[[cut_forces]]\nstation = \"0 m\"\ncolumns = { V_z = \"V\", M_y = \"M\" }\n"
                   "[[cut_forces]]\nstation = \"0.5 m\"\ncolumns = { V_z = \"V\", M_y = \"M\" "
                   "}\nfactor = 1.0\n"
                   "[[cut_forces]]\nstation = \"1 m\"\n"));
  // Between the last two stations the moment falls as it should; V falls to nothing, which it does
  // not: where both are right, at the root, the factors agree.
  const auto root_of = [](const Verification& of) {
    for (const CheckResult& result : of.checks) {
      if (result.check.criterion == Criterion::fatigue && result.check.station.s == Length{})
        return result.check.safety_factor;
    }
    return 0.0;
  };
  CHECK(root_of(cuts) == Approx(root_of(record)).epsilon(1e-9));
  CHECK(recorded_of(
            given(folder,
                  "[files.measured]\npath = \"cuts.csv\"\n"
                  "[[cut_forces]]\nstation = \"0 m\"\ncolumns = { V_z = \"V\", M_y = \"M\" }\n"
                  "[[cut_forces]]\nstation = \"1 m\"\n"))
            .shear_defect == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a unit load times a channel is the force of a file", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  folder.write("pressure.csv",
               "time [s], pressure [bar]\n0, 0\n1, 0\n2, 160\n3, 160\n4, 0\n5, 0\n");
  const Verification record = verify(given(folder, file + push + root));
  const Verification unit = verify(given(folder,
                                         "[files.cylinder]\npath = \"pressure.csv\"\n"
                                         "[loads.push]\nstation = \"1 m\"\nforce = [\"0 kN\", \"0 "
                                         "kN\", \"25 kN\"]\ntimes = \"pressure\"\n"
                                         "per = 200.0\n" +
                                             root));
  check_same_factors(unit, record, 5);
}

TEST_CASE("parts of a load in files of different steps add up on one time", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  // Half of it, seen at other instants, and a part that comes and goes: 4 kN at 2.5 s.
  folder.write("half.csv", "time [s], half [kN]\n0, 0\n1, 0\n1.5, 5\n2, 10\n3, 10\n4, 0\n5, 0\n");
  folder.write("rest.csv",
               "time [ms], half [N]\n0, 0\n1000, 0\n2000, 10000\n2500, 14000\n3000, 10000\n4000, "
               "0\n5000, 0\n");
  folder.write("sum.csv", "time [s], force [kN]\n0, 0\n1, 0\n2, 20\n2.5, 24\n3, 20\n4, 0\n5, 0\n");
  const Verification whole =
      verify(given(folder, "[files.measured]\npath = \"sum.csv\"\n" + push + root));
  const Verification parts = verify(
      given(folder,
            "[files.half]\npath = \"half.csv\"\n[files.rest]\npath = \"rest.csv\"\n"
            "[loads.push]\nstation = \"1 m\"\nfile = \"half\"\ncolumns = { F_z = \"half\" }\n"
            "[loads.other]\nstation = \"1 m\"\nfile = \"rest\"\ncolumns = { F_z = \"half\" }\n" +
                root));
  check_same_factors(parts, whole, 5);
}

TEST_CASE("forces that are not in balance are told with what is missing", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  const Project project = given(folder, file + push);
  try {
    verify(project);
    FAIL("no error");
  } catch (const AnalysisError& error) {
    CHECK(contains(error.failure().what, "(0, 0, 20) kN"));
    CHECK(contains(error.failure().what, "(0, -20, 0) kN m"));
    REQUIRE(error.failure().time);
    CHECK(*error.failure().time == 2.0);
  }
  // With the reactions of the support as further loads it is.
  folder.write("all.csv",
               "time [s], force [kN], R [kN], M [kN m]\n0, 0, 0, 0\n1, 0, 0, 0\n2, 20, -20, 20\n"
               "3, 20, -20, 20\n4, 0, 0, 0\n5, 0, 0, 0\n");
  const Verification all = verify(
      given(folder, "[files.measured]\npath = \"all.csv\"\n" + push +
                        "[loads.root]\nstation = \"0 m\"\ncolumns = { F_z = \"R\", M_y = \"M\" }\n"
                        "[balance]\nheld = [\"0 m\"]\n"));
  check_same_factors(all, verify(given(folder, file + push + root)), 5);
  REQUIRE(verify(given(folder, file + push + root)).motions.front().reactions.size() == 1);
  const SupportReaction reaction =
      verify(given(folder, file + push + root)).motions.front().reactions.front();
  CHECK(reaction.name == "root");
  CHECK(reaction.low[2] == Approx(-20e3));
  CHECK(reaction.high[4] == Approx(20e3));
}

TEST_CASE("compression is judged by how the beam is said to be held", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", "time [s], force [kN]\n0, 0\n1, -400\n2, 0\n");
  const std::string along =
      file + "[loads.push]\nstation = \"1 m\"\ncolumns = { F_x = \"force\" }\n" + root;
  // Box 100 x 200 x 10 about its weak axis.
  const double I = (0.2 * 0.1 * 0.1 * 0.1 - 0.18 * 0.08 * 0.08 * 0.08) / 12.0;
  const double euler = std::numbers::pi * std::numbers::pi * 2.1e11 * I;
  const Verification clamped = verify(given(folder, along));
  REQUIRE(clamped.model.second_order.across);
  CHECK(clamped.model.second_order.across->part == Approx(400e3 / (euler / 4.0)).epsilon(1e-3));
  const Verification pinned = verify(given(folder, along + "held = [\"0 m\", \"1 m\"]\n"));
  CHECK(pinned.model.second_order.across->part == Approx(400e3 / euler).epsilon(1e-3));
}

TEST_CASE("what is wrong in a case of given loads is said with what to write", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  folder.write("late.csv", "time [s], late [kN]\n10, 0\n11, 1\n12, 0\n");
  folder.write("once.csv", "time [s], force [kN]\n0, 5\n");
  folder.write("bare.csv", "time [s], force\n0, 5\n1, 6\n");
  CHECK(contains(
      complaint(folder, file +
                            "[loads.push]\nstation = \"1 m\"\ncolumns = { F_z = \"fource\" "
                            "}\n" +
                            root),
      "\"force\""));
  CHECK(contains(complaint(folder, push + root), "has no \"file\""));
  CHECK(contains(complaint(folder, file + root), "gives what acts on the beam, or its cut forces"));
  CHECK(contains(complaint(folder, "[files.measured]\npath = \"none.csv\"\n" + push + root),
                 "none.csv"));
  CHECK(contains(complaint(folder, "[files.measured]\npath = \"once.csv\"\n" + push + root),
                 "one instant only"));
  CHECK(
      contains(complaint(folder, "[files.measured]\npath = \"bare.csv\"\n" + push + root), "unit"));
  CHECK(complaint(folder, "[files.measured]\npath = \"bare.csv\"\nforce_unit = \"1 kN\"\n" + push +
                              root) == "");
  // The file has its force in kN: as much a unit is without effect, another one is a contradiction.
  CHECK(complaint(folder, file + "force_unit = \"1000 N\"\n" + push + root) == "");
  CHECK(contains(complaint(folder, file + "force_unit = \"1 N\"\n" + push + root),
                 "\"force\" has another, kN"));
  CHECK(contains(complaint(folder, file +
                                       "[files.late]\npath = \"late.csv\"\n"
                                       "[loads.push]\nstation = \"1 m\"\nfile = \"measured\"\n"
                                       "columns = { F_z = \"force\" }\n"
                                       "[loads.late]\nstation = \"1 m\"\nfile = \"late\"\n"
                                       "columns = { F_z = \"late\" }\n" +
                                       root),
                 "no time in common"));
  CHECK(
      contains(complaint(folder, file +
                                     "[loads.push]\nstation = \"2 m\"\ncolumns = { F_z = \"force\" "
                                     "}\n" +
                                     root),
               "behind the end of the beam"));
  CHECK(contains(complaint(folder, file + "[loads.push]\nstation = \"1 m\"\n" + root),
                 "gives its columns, or what does not change"));
  CHECK(contains(complaint(folder, file + "[[cut_forces]]\nstation = \"0 m\"\n"
                                          "columns = { V_z = \"force\" }\n"),
                 "both ends of the beam"));
  CHECK(contains(complaint(folder, file + "[[cut_forces]]\nstation = \"0 m\"\n"
                                          "columns = { M_y = \"force\" }\n"
                                          "[[cut_forces]]\nstation = \"1 m\"\n"),
                 "M_y"));
  CHECK(contains(complaint(folder, file + push + root + "[drivers.a]\nkind = \"hold\"\n"),
                 "\"drivers\" is not known"));
}

TEST_CASE("events are situations with files of their own", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("force.csv", table_cantilever::trapezoid);
  folder.write("small.csv", "time [s], force [kN]\n0, 0\n1, 10\n2, 0\n");
  std::string demanded = text_of(file + push + root);
  const std::size_t at = demanded.find("cycles = 2e6\n");
  demanded.erase(at, std::string("cycles = 2e6\n").size());
  const Verification both = verify(read_project(folder.write(
      "events.toml", demanded + "[[situations]]\nname = \"large\"\ncycles = 1e5\n"
                                "[[situations]]\nname = \"small\"\ncycles = 1e6\n"
                                "set = { \"files.measured.path\" = \"small.csv\" }\n")));
  // Of each event one cycle: ranges of F L/W and half of it, by Miner's sum on the line of
  // category 71 with slopes 3 and 5.
  const CheckResult* fatigue = both.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  const double range = 20e3 / table_cantilever::W;
  const double limit = 71e6 * std::cbrt(2.0 / 5.0);
  const auto lives = [&](double stress) {
    return stress > limit ? 2e6 * std::pow(71e6 / stress, 3) : 5e6 * std::pow(limit / stress, 5);
  };
  // The factor on all stresses at which the sum is one.
  double low = 0.01, high = 100.0;
  for (int i = 0; i < 200; ++i) {
    const double factor = std::sqrt(low * high);
    const double damage = 1e5 / lives(factor * range) + 1e6 / lives(factor * 0.5 * range);
    (damage < 1.0 ? low : high) = factor;
  }
  CHECK(fatigue->check.safety_factor == Approx(low).epsilon(1e-6));
}

namespace {

/// A record of three forces that wander, of so many instants.
std::string wandering(std::size_t instants) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> step(0.0, 1.0);
  std::string text = "time [s], F1 [kN], F2 [kN], F3 [kN]\n";
  double a = 0.0, b = 0.0, c = 0.0;
  for (std::size_t i = 0; i < instants; ++i) {
    a = 0.9 * a + step(random);
    b = 0.8 * b + step(random);
    c = 0.95 * c + step(random);
    text += fmt::format("{:.3f}, {:.4f}, {:.4f}, {:.4f}\n", 0.01 * static_cast<double>(i), a,
                        20.0 * b, 3.0 * c);
  }
  return text;
}

const std::string three_forces =
    "[files.measured]\npath = \"wandering.csv\"\n"
    "[loads.tip]\nstation = \"1 m\"\nz = \"20 mm\"\ncolumns = { F_x = \"F2\", F_z = \"F1\" }\n"
    "[loads.middle]\nstation = \"0.55 m\"\ncolumns = { F_z = \"F3\" }\n";

}  // namespace

TEST_CASE("the governing place of a record is that of a dense search", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("wandering.csv", wandering(400));
  std::string tapered = text_of(three_forces + root);
  const std::string one = "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n";
  tapered.replace(
      tapered.find(one), one.size(),
      "[[beam.segments]]\nlength = \"1 m\"\nfrom = \"box\"\nto = \"low\"\n[sections.low]\n"
      "kind = \"box\"\nwidth = \"60 mm\"\nheight = \"60 mm\"\nflange = \"10 mm\"\n"
      "web = \"10 mm\"\n");
  const Verification searched = verify(read_project(folder.write("searched.toml", tapered)));
  std::string dense = tapered;
  for (int i = 1; i < 100; ++i)
    dense +=
        fmt::format("[[points]]\nname = \"p{}\"\nstation = \"{} mm\"\nz = \"0 m\"\n", i, 10 * i);
  const Verification looked_at = verify(read_project(folder.write("dense.toml", dense)));
  for (const Criterion criterion :
       {Criterion::fatigue, Criterion::shear_fatigue, Criterion::yield, Criterion::weld}) {
    const CheckResult* found = searched.governing(criterion);
    const CheckResult* everywhere = looked_at.governing(criterion);
    REQUIRE(found != nullptr);
    REQUIRE(everywhere != nullptr);
    CHECK(found->check.utilisation() >= everywhere->check.utilisation() * (1.0 - 1e-4));
  }
}

TEST_CASE("cycles of a long record are shown in classes that take the same life", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("wandering.csv", wandering(6000));
  const Verification of = verify(given(folder, three_forces + root), Figures::without);
  const CheckResult* fatigue = of.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  const CheckBasis& basis = *fatigue->basis;
  REQUIRE(basis.spectrum.size() > 100);
  CHECK(basis.spectrum.size() <= 1000);
  double damage = 0.0, life = 0.0, largest = 0.0;
  for (const SpectrumRow& row : basis.spectrum) {
    damage += row.damage;
    life += row.cycle.count / row.endured;
    largest = std::max(largest, row.cycle.range.value());
  }
  CHECK(damage == Approx(basis.damage).epsilon(1e-9));
  CHECK(life == Approx(1.0).epsilon(1e-6));
  CHECK(largest == Approx(fatigue->check.acting.value()).epsilon(1e-9));
  // Pictures have fewer points, and the same extremes.
  CHECK(basis.history.size() <= 4002);
  const auto [low, high] = std::minmax_element(basis.history.begin(), basis.history.end());
  CHECK(*high - *low == Approx(largest).epsilon(1e-9));
}

TEST_CASE("a beam that swings has the factors of the same beam in a mechanism", "[recorded]") {
  // An arm of 1 m about its end, 40 deg up and down at 1 Hz, with a force across its tip.
  const std::string arm =
      "[case]\nname = \"arm\"\nkind = \"planar\"\n[model]\ndemand = \"rigid\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
      "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"] }\n"
      "[joints.A]\nkind = \"pin\"\nconnect = [\"arm.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[drivers.swing]\nkind = \"harmonic\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\namplitude "
      "= \"40 deg\"\n"
      "frequency = \"1 Hz\"\nmean = \"0 deg\"\n";
  std::string in_mechanism = text_of("");
  in_mechanism.replace(0, in_mechanism.find("[sections.box]"), arm);
  const std::string beam = "[beam]\n";
  in_mechanism.replace(in_mechanism.find(beam), beam.size(), "[beam]\nbody = \"arm\"\n");
  const test::TemporaryFolder folder;
  const Verification moving = verify(read_project(folder.write("arm.toml", in_mechanism)));
  constexpr double pi = std::numbers::pi;
  constexpr int steps = 4000;
  std::string path = "time [s], x [m], z [m], angle [rad]\n";
  std::string sensor = "time [s], ax [m/s^2], az [m/s^2], wy [rad/s], dwy [rad/s^2]\n";
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, amplitude = 40.0 * pi / 180.0;
    const double angle = amplitude * std::sin(2.0 * pi * t);
    path += fmt::format("{}, 0, 0, {}\n", t, angle);
    sensor += fmt::format("{}, {}, {}, {}, {}\n", t, 9.81 * std::sin(angle), 9.81 * std::cos(angle),
                          -2.0 * pi * amplitude * std::cos(2.0 * pi * t),
                          4.0 * pi * pi * amplitude * std::sin(2.0 * pi * t));
  }
  folder.write("path.csv", path);
  folder.write("sensor.csv", sensor);
  const auto swinging = [&](const std::string& file_name, const std::string& columns) {
    return verify(given(folder, "[files.measured]\npath = \"" + file_name +
                                    "\"\n[motion]\ncolumns = { " + columns +
                                    " }\n[loads.none]\nstation = \"1 m\"\n"
                                    "force = [\"0 N\", \"0 N\", \"0 N\"]\n" +
                                    root));
  };
  const Verification by_path = swinging("path.csv", "x = \"x\", z = \"z\", angle = \"angle\"");
  const Verification by_sensor =
      swinging("sensor.csv", "a_x = \"ax\", a_z = \"az\", omega_y = \"wy\", alpha_y = \"dwy\"");
  for (const Criterion criterion :
       {Criterion::fatigue, Criterion::shear_fatigue, Criterion::yield}) {
    const CheckResult* truth = moving.governing(criterion);
    REQUIRE(truth != nullptr);
    // Instants are 1/4000 of a turn apart: a peak is missed by (pi/4000)^2/2, a path's second
    // difference by (2 pi/4000)^2/12.
    CHECK(by_sensor.governing(criterion)->check.utilisation() ==
          Approx(truth->check.utilisation()).epsilon(2e-6));
    CHECK(by_path.governing(criterion)->check.utilisation() ==
          Approx(truth->check.utilisation()).epsilon(2e-5));
  }
}

TEST_CASE("the excavator's boom passes alike as a mechanism and under recorded forces",
          "[recorded]") {
  // The record is computed by a script of its own, from the balance of moments about the foot.
  const Verification moving =
      verify(read_project(test::project_file("sections/excavator-boom/boom.toml")));
  const Verification record =
      verify(read_project(test::project_file("sections/excavator-boom/measured.toml")));
  CHECK(record.verdict == moving.verdict);
  for (const Criterion criterion : {Criterion::fatigue, Criterion::yield}) {
    CHECK(record.governing(criterion)->check.utilisation() ==
          Approx(moving.governing(criterion)->check.utilisation()).epsilon(5e-5));
  }
}

TEST_CASE("what is extreme in no cut force by itself is found among very many rows", "[recorded]") {
  // N, M_y or both at three rows: an effective section weighs N more than M, so that the third is
  // the worst, 2600 kN/16 427 mm^2 + 2000 kN m/9.354e6 mm^3 = 372 MPa of 355, though the whole
  // section's stress is largest at the second.
  const auto use_among = [](int count) {
    const test::TemporaryFolder folder;
    std::string table = "time [s],N [kN],M [kN m]\n";
    for (int i = 0; i < count; ++i) {
      std::pair<int, int> row{-10 * (i % 7), -30 * (i % 11)};
      if (i == count / 4) row = {-4000, 0};
      if (i == count / 2) row = {0, -3000};
      if (i == count / 3) row = {-2600, -2000};
      table += fmt::format("{:.2f},{},{}\n", 0.01 * i, row.first, row.second);
    }
    folder.write("f.csv", table);
    const std::string held = "holds = [\"along y\", \"along z\", \"turning over\"]\n";
    const Verification of = verify(read_project(folder.write(
        "case.toml",
        "[case]\nname = \"given\"\nkind = \"loads\"\n"
        "[sections.a]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1224 mm\"\n"
        "flange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
        "[[beam.segments]]\nlength = \"4 m\"\nsection = \"a\"\n"
        "[[beam.restraints]]\nstation = \"0 m\"\n" +
            held + "[[beam.restraints]]\nstation = \"4 m\"\n" + held +
            "[files.f]\npath = \"f.csv\"\n"
            "[loads.tip]\nstation = \"4 m\"\ncolumns = { F_x = \"N\", M_y = \"M\" }\n"
            "[balance]\nstation = \"0 m\"\nname = \"root\"\n"
            "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n")));
    double use = 0.0;
    for (const CheckResult& result : of.checks)
      if (result.check.criterion == Criterion::effective_section)
        use = std::max(use, result.check.utilisation());
    return use;
  };
  const double among_few = use_among(1000);
  CHECK(among_few == Approx(372.0 / 355.0).epsilon(2e-3));
  CHECK(use_among(320000) == Approx(among_few).epsilon(1e-6));
}

}  // namespace recorded_front_end_test
