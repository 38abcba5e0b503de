// Given cut forces whose shear forces and bending moments contradict each other: by hand.

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace given_cuts_test {

using namespace boxbeam;

namespace {

struct Given {
  double s, V, M;  ///< m, kN, kN m
};

/// Box 300 x 500, flanges 16, webs 8 mm, under cut forces at t = 0 and none at 1 s.
std::string text_of(const test::TemporaryFolder& folder, const std::vector<Given>& stations,
                    const char* words = "V_z = \"V{0}\", M_y = \"M{0}\"") {
  const std::string plate = "thickness = \"20 mm\"\nthroat = \"10 mm\"\n";
  std::string head = "time [s]", first = "\n0", last = "\n1", cuts;
  int i = 0;
  for (const Given& of : stations) {
    head += fmt::format(", V{0} [kN], M{0} [kN m]", i);
    first += fmt::format(", {}, {}", of.V, of.M);
    last += ", 0, 0";
    cuts += fmt::format("[[cut_forces]]\nstation = \"{} m\"\ncolumns = {{ {} }}\n", of.s,
                        fmt::format(fmt::runtime(words), i));
    ++i;
  }
  folder.write("cuts.csv", head + first + last + "\n");
  return fmt::format(
             "[case]\nname = \"g\"\nkind = \"loads\"\n[sections.s]\nkind = \"box\"\nwidth = \"300 "
             "mm\"\nheight = \"500 mm\"\nflange = \"16 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = "
             "\"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"{} m\"\nsection = \"s\"\n"
             "[files.f]\npath = \"cuts.csv\"\n",
             stations.back().s) +
         cuts + "[[beam.diaphragms]]\nstation = \"0 m\"\n" + plate +
         fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\n", stations.back().s) + plate +
         "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
         "1.0\nshear_lag = false\n";
}

struct Judged {
  Verification of;
  std::string line;
};

Judged judged(const test::TemporaryFolder& folder, const std::string& text) {
  const Project project = read_project(folder.write("case.toml", text));
  Judged judged{verify(project), ""};
  judged.line = verdict_text_of(project, judged.of).line;
  return judged;
}

}  // namespace

TEST_CASE("shear forces that change by q L hide q L^2/8 between two stations", "[recorded]") {
  const test::TemporaryFolder folder;
  const double L = 4.5, V = 1000.0, hidden = 2.0 * V * L / 8.0;
  const Judged coarse = judged(folder, text_of(folder, {{0.0, V, -50.0}, {L, -V, -50.0}}));
  CHECK(coarse.of.verdict == Verdict::not_applicable);
  REQUIRE(!coarse.of.gates.empty());
  const double I = (0.3 * std::pow(0.5, 3) - 0.284 * std::pow(0.468, 3)) / 12.0;
  const std::string by_hand =
      fmt::format("{:.4g} kN m, {:.3g} MPa", hidden, 1e-3 * hidden * 0.25 / I);
  const auto names = [&](const Gate& gate) {
    return gate.blocks && gate.finding.find(by_hand) != std::string::npos;
  };
  CHECK(std::any_of(coarse.of.gates.begin(), coarse.of.gates.end(), names));
}

TEST_CASE("shear forces that agree with the moments say nothing", "[recorded]") {
  const test::TemporaryFolder folder;
  // Less of it at eleven stations: q h^2/8 = 0.01 of the moment in the middle.
  const double L = 4.5, q = 200.0;
  std::vector<Given> fine;
  for (int i = 0; i <= 10; ++i) {
    const double s = L * i / 10.0;
    fine.push_back({s, q * (0.5 * L - s), 0.5 * q * s * (L - s)});
  }
  const Judged of = judged(folder, text_of(folder, fine));
  CHECK(of.of.verdict == Verdict::pass);
  CHECK_THAT(of.line, !Catch::Contains("given cut forces"));
  // With the other sign of V they differ by 2 M.
  std::vector<Given> turned = fine;
  for (Given& at : turned) {
    at.V *= -0.2;
    at.M *= 0.2;
  }
  const Judged wrong = judged(folder, text_of(folder, turned));
  CHECK(wrong.of.verdict == Verdict::pass);
  CHECK_THAT(wrong.line,
             Catch::Contains("given cut forces") &&
                 Catch::Contains(fmt::format("{:.4g} kN m", 2.0 * 0.2 * q * L * L / 8)));
}

TEST_CASE("shear forces without moments are refused, as the other way around", "[recorded]") {
  const test::TemporaryFolder folder;
  const auto complaint = [&](const char* words) {
    try {
      judged(folder, text_of(folder, {{0.0, 1000.0, 0.0}, {3.0, 1000.0, 0.0}}, words));
    } catch (const InputError& error) {
      return error.problems().front().message;
    }
    return std::string();
  };
  CHECK_THAT(complaint("V_z = \"V{0}\""), Catch::Contains("V_z is given without M_y"));
  CHECK_THAT(complaint("V_y = \"V{0}\""), Catch::Contains("V_y is given without M_z"));
  CHECK_THAT(complaint("M_y = \"M{0}\""), Catch::Contains("M_y is given without V_z"));
}

}  // namespace given_cuts_test
