// Studies of a case as a user runs them: what cannot be judged counts for nothing, and a case that
// cannot be verified as it is may have designs that can.

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "support/box_cantilever.hpp"
#include "support/program.hpp"

namespace study_commands_test {

using nlohmann::json;
using test::box_of_cantilever;
using test::cantilever;
using test::mass_of_box;
using test::run_program;
using test::tube_of_cantilever;

namespace {

std::string study_of(const std::string& variable, const std::string& optimise) {
  return "[study]\ncase = \"beam.toml\"\n[variables.t]\n" + variable + "\n[optimise]\n" + optimise +
         "\n";
}

}  // namespace

// Yield by bending: the factor falls as the force grows, whatever the name of the force.
TEST_CASE("what changes the factors is found of names with dots, too", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  const auto ran = run_program({"verify", file, "--sensitivities", "--no-plots", "--no-html",
                                "--no-pdf", "--out", folder.path() / "out", "--json", "-"});
  REQUIRE(ran.exit_code == 0);
  bool found = false;
  const json results = json::parse(ran.out);
  for (const json& of : results.at("sensitivities")) {
    if (of.at("input") != "loads.\"tip.1\".force.1") continue;
    found = true;
    CHECK(of.at("slopes").at(0).at("slope").get<double>() == Approx(-1.0).epsilon(1e-6));
  }
  CHECK(found);
}

TEST_CASE("the best of a list is found where the case as it is cannot be verified", "[study]") {
  const test::TemporaryFolder folder;
  std::string section = box_of_cantilever;
  section.replace(section.find("10 mm"), 5, "160 mm");
  folder.write("beam.toml", cantilever(section));
  const std::string study = folder.write(
      "study.toml",
      study_of("key = \"sections.of.flange\"\nvalues = [\"155 mm\", \"12 mm\", \"14 mm\"]",
               "minimise = \"beam.mass\"\nsubject_to = [\"beam.mass - 150\"]"));
  const auto ran = run_program({"optimise", study, "--json", "-"});
  REQUIRE(ran.exit_code == 0);
  const json best = json::parse(ran.out);
  REQUIRE(mass_of_box(0.012) < 150.0);
  CHECK(best.at("variables").at("t") == 14.0);
  CHECK(best.at("objective").get<double>() == Approx(mass_of_box(0.014)).epsilon(1e-12));
}

// Round tubes are of class 4 above d/t = 90 235/355 = 59.6 (EN 1993-1-1, table 5.2): their use is
// no measure of them.
TEST_CASE("stresses that cannot be believed keep no limit of an optimum", "[study]") {
  REQUIRE(300.0 / 5.0 > 90.0 * 235.0 / 355.0);
  REQUIRE(300.0 / 6.0 < 90.0 * 235.0 / 355.0);
  const test::TemporaryFolder folder;
  folder.write("beam.toml", cantilever(tube_of_cantilever));
  const std::string list =
      "key = \"sections.of.wall\"\nvalues = [\"3 mm\", \"5 mm\", \"6 mm\", \"10 mm\"]";
  for (const char* limit : {"1 - utilisation", "checks", "yield.safety_factor - 1"}) {
    CAPTURE(limit);
    const std::string study = folder.write(
        "study.toml",
        study_of(list, std::string("minimise = \"beam.mass\"\nsubject_to = [\"") + limit + "\"]"));
    const auto ran = run_program({"optimise", study, "--json", "-"});
    REQUIRE(ran.exit_code == 0);
    const json best = json::parse(ran.out);
    CHECK(best.at("variables").at("t") == 6.0);
    CHECK(best.at("verdict") == "pass");
  }
  // What is no stress is what it is.
  const std::string study = folder.write(
      "study.toml", study_of(list, "minimise = \"beam.mass\"\nsubject_to = [\"t - 4\"]"));
  const auto ran = run_program({"optimise", study, "--json", "-"});
  REQUIRE(ran.exit_code == 0);
  CHECK(json::parse(ran.out).at("variables").at("t") == 5.0);
}

// Whichever variable changes first: then runs are kept for the designs behind, or each runs anew.
TEST_CASE("a design comes to the same whatever designs stand before it", "[study]") {
  const test::TemporaryFolder folder;
  folder.write("beam.toml", cantilever(box_of_cantilever));
  const std::string flange =
      "[variables.t]\nkey = \"sections.of.flange\"\n"
      "grid = { from = \"8 mm\", to = \"20 mm\", count = 13 }\n";
  const std::string factor =
      "[variables.g]\nkey = \"strength.gamma_M0\"\nvalues = [1.0, 1.05, 1.1]\n";
  const auto rows_of = [&](const std::string& variables) {
    const std::string study =
        folder.write("study.toml", "[study]\ncase = \"beam.toml\"\n" + variables +
                                       "[results]\ncolumns = [\"yield.safety_factor\", "
                                       "\"utilisation\", \"verdict\"]\n");
    const std::string out = folder.path() / "out";
    REQUIRE(run_program({"sweep", study, "--out", out, "--quiet", "--threads", "1"}).exit_code ==
            0);
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(test::read_file(out + "/rows.csv"));
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells;
      std::istringstream of(line);
      for (std::string cell; std::getline(of, cell, ',');) cells.push_back(cell);
      rows.push_back(cells);
    }
    return rows;
  };
  const auto kept = rows_of(flange + factor), anew = rows_of(factor + flange);
  REQUIRE(kept.size() == 40);
  REQUIRE(anew.size() == 40);
  for (std::size_t t = 0; t < 13; ++t)
    for (std::size_t g = 0; g < 3; ++g) {
      std::vector<std::string> one = kept[1 + 3 * t + g], other = anew[1 + 13 * g + t];
      std::swap(other[1], other[2]);
      other[0] = one[0];
      CHECK(one == other);
    }
}

// The place that governs has a name that somebody gave it.
TEST_CASE("a comma in the name of what governs ends no cell of a row", "[study]") {
  const test::TemporaryFolder folder;
  const std::string study = folder.write(
      "study.toml", "[study]\ncase = \"" +
                        test::project_file("sections/sledge-rig/rig-detailed.toml") +
                        "\"\n[variables.a]\nkey = \"fatigue.gamma_Ff\"\nvalues = [1.0, 1.1]\n"
                        "[results]\ncolumns = [\"governing\", \"verdict\"]\n");
  const std::string out = folder.path() / "out";
  REQUIRE(run_program({"sweep", study, "--out", out, "--quiet"}).exit_code == 0);
  const std::string rows = test::read_file(out + "/rows.csv");
  CHECK(
      rows.find("1,1,\"fatigue/5.2/weld-around-the-tube-at-the-box-end,-top-flange\",fail,ok\n") !=
      std::string::npos);
}

TEST_CASE("numbers that have not the dimension of their key are refused before any design",
          "[study]") {
  const test::TemporaryFolder folder;
  folder.write("beam.toml", cantilever(box_of_cantilever));
  for (const char* values : {"[8, 10]", "[\"8 kg\", \"10 kg\"]"}) {
    const std::string study = folder.write("study.toml",
                                           "[study]\ncase = \"beam.toml\"\n[variables.t]\nkey = "
                                           "\"sections.of.flange\"\nvalues = " +
                                               std::string(values) + "\n");
    const auto ran = run_program({"sweep", study, "--out", folder.path() / "out"});
    CHECK(ran.exit_code == 2);
    CHECK(ran.err.find("sections.of.flange") != std::string::npos);
    CHECK(ran.err.find("the case has \"10 mm\"") != std::string::npos);
  }
}

// Chunks of 200 designs are of 3, the last of 2: the second half of the chunks has 33 of 3.
TEST_CASE("as many designs as are missing are said to be", "[study]") {
  const test::TemporaryFolder folder;
  const std::string study = folder.write("study.toml",
                                         "[variables.a]\ngrid = { from = 1, to = 200, count = 200 "
                                         "}\n[results]\ncolumns = [\"f = a\"]\n");
  const std::string half = folder.path() / "half";
  REQUIRE(run_program({"sweep", study, "--shard", "2/2", "--out", half, "--quiet"}).exit_code == 0);
  const auto merged = run_program({"merge", half});
  CHECK(merged.exit_code == 2);
  CHECK(merged.err.find("101 of 200 designs are missing") != std::string::npos);
}

TEST_CASE("a case for a study, or a study for a case, is one thing wrong and not many", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  const std::string study =
      folder.write("study.toml",
                   "[study]\ncase = \"beam.toml\"\n[variables.t]\nkey = \"sections.of.flange\"\n"
                   "distribution = \"normal\"\nmean = \"8 mm\"\n");
  for (const char* command : {"sweep", "optimise", "reliability"}) {
    const auto ran = run_program({command, file});
    CHECK(ran.exit_code == 2);
    CHECK(ran.err.find("1:1: error: this is a case, not a study") != std::string::npos);
    CHECK(ran.err.find("error:", ran.err.find("error:") + 1) == std::string::npos);
  }
  const auto verified = run_program({"verify", study});
  CHECK(verified.exit_code == 2);
  CHECK(verified.err.find("1:1: error: this is a study, not a case") != std::string::npos);
  // What is not there has no value that could be wrong as well.
  const auto swept = run_program({"sweep", study});
  CHECK(swept.err.find("\"sd\" is missing") != std::string::npos);
  CHECK(swept.err.find("not above zero") == std::string::npos);
}

// A new key may need others that stand beside it, and the first design need not be one.
TEST_CASE("a key that the case has not is refused unless some design can be read with it",
          "[study]") {
  const test::TemporaryFolder folder;
  folder.write("beam.toml", cantilever(box_of_cantilever));
  const auto swept = [&](const std::string& more) {
    const std::string study =
        folder.write("study.toml",
                     "[study]\ncase = \"beam.toml\"\n[variables.t]\nkey = \"sections.of.flange\"\n"
                     "values = [\"160 mm\", \"10 mm\"]\n" +
                         more + "[results]\ncolumns = [\"verdict\"]\n");
    return run_program({"sweep", study, "--out", folder.path() / "out", "--quiet"});
  };
  CHECK(swept("[variables.g]\nkey = \"strength.gamma_M0\"\nvalues = [1.0, 1.1]\n").exit_code == 0);
  const auto wrong = swept("[variables.g]\nkey = \"strength.gama_M0\"\nvalues = [1.0, 1.1]\n");
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("unknown key \"gama_M0\"") != std::string::npos);
}

}  // namespace study_commands_test
