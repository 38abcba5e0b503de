// Lateral torsional buckling of the beam of a case: hand values, and where it stops a verdict.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/program.hpp"

namespace lateral_estimate_test {

using namespace boxbeam;

namespace {

constexpr double E = 210e9, G = 81e9, L = 6.0, b = 0.02, h = 0.3;

/// A plate 20 x 300 on edge, 6 m long, clamped, with a force at its end.
Project plate(double force, const std::string& more = "", const std::string& factor = "1.0") {
  const std::string load = std::to_string(force) + " N\"]\n";
  return parse_project(
      "plate.toml",
      "[case]\nname = \"plate\"\nkind = \"static\"\n"
      "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[sections.plate]\nkind = \"plate\"\nwidth = \"20 mm\"\nheight = \"300 mm\"\n"
      "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"6 m\"\n"
      "section = \"plate\"\n[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
      "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"0 N\", \"-" +
          load + more + "[material]\nsteel = \"S355\"\n[strength]\nrequired = " + factor + "\n");
}

/// Of a strip with a force at its end at the upper edge, of the first order in the height.
/// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 6.3 (4.013, height left
/// out); what the height takes is by the quotient of Rayleigh with the shape of the level force,
/// found by finite differences: 1.025 h/2 sqrt(E I_z/(G I_T))/L.
double critical_force() {
  const double I_z = h * b * b * b / 12.0;
  // I_T of a strip: b^3 h/3 (1 - 0.630 b/h). Source: Timoshenko, Goodier, article 109.
  const double I_T = h * b * b * b / 3.0 * (1.0 - 0.630 * b / h);
  const double level = 4.013 * std::sqrt(E * I_z * G * I_T) / (L * L);
  return level * (1.0 - 1.025 * 0.5 * h / L * std::sqrt(E * I_z / (G * I_T)));
}

const Gate* turned_over(const Verification& of) {
  for (const Gate& gate : of.gates)
    if (gate.blocks && gate.finding.find("lateral torsional buckling") != std::string::npos)
      return &gate;
  return nullptr;
}

/// The check of turning over, or nullptr.
const Check* sideways(const Verification& of) {
  for (const CheckResult& result : of.checks)
    if (result.check.criterion == Criterion::member && result.member->turns_over)
      return &result.check;
  return nullptr;
}

bool fails_sideways(const Verification& of) {
  return turned_over(of) != nullptr || (sideways(of) != nullptr && !sideways(of)->passes());
}

double part_of(const Verification& of) {
  REQUIRE(of.model.second_order.lateral.has_value());
  return of.model.second_order.lateral->part;
}

}  // namespace

TEST_CASE("a plate on edge turns over at the load of the hand calculation", "[lateral]") {
  const Verification of = verify(plate(1000.0));
  // The bow of the bent plate counts as well: 1/(E I_z) - 1/(E I_y) in place of 1/(E I_z).
  const double bow = std::sqrt(1.0 - b * b / (h * h));
  CHECK(part_of(of) == Approx(1000.0 / critical_force() * bow).epsilon(5e-3));
}

TEST_CASE("a plate that tapers turns over as one of many steps does", "[lateral]") {
  const auto clamped = [](const std::string& sections, const std::string& segments) {
    return part_of(verify(parse_project(
        "plate.toml",
        "[case]\nname = \"plate\"\nkind = \"static\"\n"
        "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
            sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments +
            "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
            "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"0 N\", \"-1000 N\"]\n"
            "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n")));
  };
  const auto section = [](const std::string& name, double height) {
    return fmt::format("[sections.{}]\nkind = \"plate\"\nwidth = \"20 mm\"\nheight = \"{} mm\"\n",
                       name, height);
  };
  const auto even = [&](double height) {
    return clamped(section("plate", height),
                   "[[beam.segments]]\nlength = \"6 m\"\nsection = \"plate\"\n");
  };
  const double tapered =
      clamped(section("root", 300.0) + section("tip", 150.0),
              "[[beam.segments]]\nlength = \"6 m\"\nfrom = \"root\"\nto = \"tip\"\n");
  constexpr int steps = 24;
  std::string sections, segments;
  for (int k = 0; k < steps; ++k) {
    sections += section(fmt::format("s{}", k), 300.0 - 150.0 * (k + 0.5) / steps);
    segments += fmt::format("[[beam.segments]]\nlength = \"0.25 m\"\nsection = \"s{}\"\n", k);
  }
  CHECK(tapered == Approx(clamped(sections, segments)).epsilon(5e-3));
  CHECK(tapered > 1.05 * even(300.0));
  CHECK(tapered < 0.95 * even(150.0));
}

TEST_CASE("a plate that would turn over gets no verdict, though its stress is small", "[lateral]") {
  // 5.3 kN: 106 MPa at the wall.
  const Verification over = verify(plate(1.05 * critical_force()));
  CHECK(over.verdict == Verdict::not_applicable);
  REQUIRE(turned_over(over) != nullptr);
  CHECK(turned_over(over)->finding.find("it turns over") != std::string::npos);
  // By 6.3.4 with curve d: lambda^2 = (M/M_cr)/(M/(W f_y)), chi about 1/(1.3 lambda^2) here.
  const Verification near = verify(plate(0.9 * critical_force()));
  CHECK(near.verdict == Verdict::fail);
  CHECK(fails_sideways(near));
  const Verification far = verify(plate(0.3 * critical_force()));
  CHECK(far.verdict == Verdict::pass);
  const double lambda = std::sqrt(part_of(far) / (0.3 * critical_force() * L / 3e-4 / 345e6));
  const double chi = test::chi_of(lambda, 0.76);
  REQUIRE(sideways(far) != nullptr);
  CHECK(sideways(far)->utilisation() ==
        Approx(0.3 * critical_force() * L / 3e-4 / 345e6 / chi).epsilon(1e-6));
}

TEST_CASE("the sheet of a beam that may turn over ends with its factor", "[lateral][sheet]") {
  const Project project = plate(0.3 * critical_force());
  const Verification of = verify(project);
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion != Criterion::member) continue;
    test::sheet_to_factor(project, of, result, 1e-3);
  }
}

TEST_CASE("compression across the plane and turning over count together", "[lateral]") {
  // 1 kN pushes along the plate: N/N_cr = 1000 x 4 L^2/(pi^2 E I_z) sideways, A f_y for yielding.
  Project project = plate(1000.0,
                          "[loads.push]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"-1 "
                          "kN\", \"0 N\"]\n");
  const Verification of = verify(project);
  const double pi = std::numbers::pi;
  const double pushed = 1000.0 * 4.0 * L * L / (pi * pi * E * h * b * b * b / 12.0);
  REQUIRE(of.model.second_order.across.has_value());
  CHECK(of.model.second_order.across->part == Approx(pushed).epsilon(2e-3));
  const double yielding = 1000.0 / (b * h * 345e6) + of.model.second_order.bending;
  CHECK(of.model.second_order.bending == Approx(1000.0 * L / 3e-4 / 345e6).epsilon(1e-2));
  const double lambda = std::sqrt((pushed + part_of(of)) / yielding);
  const double chi = test::chi_of(lambda, 0.76);
  REQUIRE(sideways(of) != nullptr);
  CHECK(sideways(of)->utilisation() == Approx(yielding / chi).epsilon(2e-3));
}

TEST_CASE("a safety factor and a load factor bring the limit of turning over nearer", "[lateral]") {
  const double force = 0.5 * critical_force();
  CHECK_FALSE(fails_sideways(verify(plate(force))));
  CHECK(fails_sideways(verify(plate(force, "", "2.0"))));
  const std::string storm =
      "[[situations]]\nname = \"storm\"\nloads = { tip = 1.0 }\nload_factor = 2.0\n";
  CHECK(fails_sideways(verify(plate(force, storm))));
}

TEST_CASE("a beam turns over alike whichever axes of space it lies in", "[lateral]") {
  const auto in_space = [](const std::string& z, const std::string& force) {
    return verify(
        parse_project("plate.toml",
                      "[case]\nname = \"plate\"\nkind = \"static\"\n"
                      "[frame]\nspace = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                      "[sections.plate]\nkind = \"plate\"\nwidth = \"20 mm\"\nheight = \"300 mm\"\n"
                      "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis "
                      "= \"x\"\nz = \"" +
                          z +
                          "\"\n[[beam.segments]]\nlength = \"6 m\"\nsection = \"plate\"\n"
                          "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
                          "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\nforce = " +
                          force + "\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"));
  };
  const double plane = part_of(verify(plate(3000.0)));
  CHECK(part_of(in_space("z", "[\"0 N\", \"0 N\", \"-3 kN\"]")) == Approx(plane).epsilon(3e-5));
  CHECK(part_of(in_space("y", "[\"0 N\", \"3 kN\", \"0 N\"]")) == Approx(plane).epsilon(3e-5));
  CHECK(turned_over(in_space("y", "[\"0 N\", \"6 kN\", \"0 N\"]")) != nullptr);
  // Flat it does not turn over but by the force beside its axis.
  CHECK(part_of(in_space("z", "[\"0 N\", \"0.2 kN\", \"0 N\"]")) < 0.01);
}

TEST_CASE("a peak of bending without compression turns a beam over in any of its instants",
          "[lateral]") {
  // The plate under a force at its end that is small but at one instant: as if it were there all
  // along, wherever in the record it is.
  const test::TemporaryFolder folder;
  const auto part = [&](int rows, int peak) {
    std::string csv = "t [s],F [N]\n";
    for (int i = 0; i < rows; ++i)
      csv += fmt::format("{},{}\n", 0.1 * i, i == peak ? -3000.0 : -100.0 - i % 7);
    folder.write("force.csv", csv);
    const Verification of = verify(read_project(folder.write(
        "case.toml",
        "[case]\nname = \"given\"\nkind = \"loads\"\n[sections.plate]\nkind = \"plate\"\n"
        "width = \"20 mm\"\nheight = \"300 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
        "[[beam.segments]]\nlength = \"6 m\"\nsection = \"plate\"\n"
        "[files.f]\npath = \"force.csv\"\n[loads.tip]\nstation = \"6 m\"\n"
        "columns = { F_z = \"F\" }\n[balance]\nstation = \"0 m\"\nname = \"root\"\n"
        "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n")));
    REQUIRE(of.model.second_order.lateral);
    return of.model.second_order.lateral->part;
  };
  const double whole = part(40, 20);
  CHECK(whole > 0.1);
  for (const auto& [rows, peak] : {std::pair{100, 51}, {200, 99}, {3000, 1001}}) {
    CAPTURE(rows, peak);
    CHECK(part(rows, peak) == Approx(whole).epsilon(1e-4));
  }
}

}  // namespace lateral_estimate_test
