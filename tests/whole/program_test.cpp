// The program as a user runs it: exit codes, files, JSON, without gnuplot, read-only places.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace program_test {

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string rig = "sections/sledge-rig/rig.toml";
const std::string published = "sections/sledge-rig/published.toml";

Json results(const std::string& case_file, std::vector<std::string> more = {}) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments{
      "verify",     case_file,  "--json", "-",
      "--no-plots", "--no-pdf", "--out",  (folder.path() / "out").string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const test::ProgramResult result = test::run_program(arguments);
  INFO(result.err);
  REQUIRE((result.exit_code == 0 || result.exit_code == 1));
  Json document = Json::parse(result.out);
  CHECK(result.exit_code == (document["verdict"] == "pass" ? 0 : 1));
  return document;
}

std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

}  // namespace

TEST_CASE("verify rig.toml: fails, with the factors of the independent calculation") {
  // tests/validation/independent_sledge_rig.py, with shear lag and without.
  const Json document = results(rig);
  CHECK(document["verdict"] == "fail");
  // That of the fibre; at the end of the flange the web's shear comes to it, so that the
  // governing one is a little lower.
  const auto factor_of = [](const Json& of, const std::string& id) {
    for (const Json& check : of["checks"]) {
      if (check["id"] == id) return check["safety_factor"].get<double>();
    }
    return 0.0;
  };
  const std::string fibre = "yield/4.2-/fibre+z";
  CHECK(factor_of(document, fibre) == Approx(19.6478234324).epsilon(1e-9));
  CHECK(document["governing"]["yield"]["safety_factor"].get<double>() <= 19.6478234324);
  CHECK(document["governing"]["fatigue"]["safety_factor"].get<double>() ==
        Approx(1.21259437284).epsilon(1e-9));
  CHECK(document["governing"]["fatigue"]["station"].get<double>() == Approx(4.2));
  CHECK(document["beam"]["mass"].get<double>() == Approx(4946.9472).epsilon(1e-9));
  const Json plain = results(rig, {"--set", "strength.shear_lag=false"});
  CHECK(factor_of(plain, fibre) == Approx(20.7031295803).epsilon(1e-9));
  CHECK(plain["governing"]["fatigue"]["safety_factor"].get<double>() ==
        Approx(1.27819703418).epsilon(1e-9));
}

TEST_CASE("verify published.toml: N_y = 20.6, N_ud = 1.69") {
  const Json document = results(published);
  CHECK(document["governing"]["yield"]["safety_factor"].get<double>() == Approx(20.6).margin(0.05));
  CHECK(document["governing"]["fatigue"]["safety_factor"].get<double>() ==
        Approx(1.69).margin(0.005));
}

TEST_CASE("results.json: keys in their order, two records at every jump") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  REQUIRE(test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--out", out}).exit_code ==
          1);
  const auto document = nlohmann::ordered_json::parse(test::read_file(out + "/results.json"));
  CHECK(keys_of(document) == std::vector<std::string>{"schema",
                                                      "case",
                                                      "version",
                                                      "input_sha256",
                                                      "verdict",
                                                      "model",
                                                      "critical_instants",
                                                      "beam",
                                                      "checks",
                                                      "governing",
                                                      "codes",
                                                      "remarks",
                                                      "mechanism",
                                                      "freedom",
                                                      "equivalent_mass",
                                                      "newton_chain",
                                                      "loads",
                                                      "sections",
                                                      "concentrations",
                                                      "sn",
                                                      "verdict_text",
                                                      "not_judged",
                                                      "search",
                                                      "remedies"});
  CHECK(keys_of(document["checks"][0]) ==
        std::vector<std::string>{"id", "criterion", "point", "station", "side", "situation", "time",
                                 "acting", "resisting", "safety_factor", "required", "utilisation",
                                 "unit", "source", "normal_stress", "shear_stress",
                                 "sufficient_throat"});
  int sides = 0;
  for (const auto& station : document["beam"]["stations"]) {
    if (station["s"].get<double>() != 3.2) continue;
    CHECK((station["side"] == "-" || station["side"] == "+"));
    ++sides;
  }
  CHECK(sides == 2);
  CHECK(fs::exists(out + "/report.txt"));
}

TEST_CASE("the hash in the results is that of the case file") {
  // Known from `sha256sum` run by the shell, an independent program.
  const test::TemporaryFolder folder;
  const Json document = results(rig);
  const std::string listing = (folder.path() / "sum").string();
  REQUIRE(std::system(
              ("sha256sum '" + test::project_file(rig) + "' > '" + listing + "'").c_str()) == 0);
  CHECK(test::read_file(listing).substr(0, 64) == document["input_sha256"].get<std::string>());
  const Json other = results(rig, {"--set", "strength.required=2.5"});
  CHECK(other["input_sha256"] != document["input_sha256"]);
}

TEST_CASE("the same input gives the same bytes") {
  const test::TemporaryFolder folder;
  const std::string a = (folder.path() / "a").string();
  const std::string b = (folder.path() / "b").string();
  test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--out", a});
  test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--out", b});
  for (const char* name : {"/report.txt", "/results.json"}) {
    CHECK(test::read_file(a + name) == test::read_file(b + name));
  }
}

TEST_CASE("without gnuplot everything else is written and the exit code is 4") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", out});
  ::setenv("PATH", path.c_str(), 1);
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("gnuplot-nox") != std::string::npos);
  CHECK(fs::exists(out + "/report.txt"));
  CHECK(fs::exists(out + "/results.json"));
  CHECK_FALSE(fs::exists(out + "/cut-forces.svg"));
  // Nothing temporary is left behind.
  for (const auto& entry : fs::directory_iterator(out)) {
    CHECK(entry.path().filename().string().front() != '.');
  }
}

TEST_CASE("a gnuplot that fails is reported with its first words") {
  const test::TemporaryFolder folder;
  const std::string fake = folder.write("gnuplot", "#!/bin/sh\necho 'no terminal today'\nexit 3\n");
  fs::permissions(fake, fs::perms::owner_all);
  const std::string out = (folder.path() / "out").string();
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.path().string() + ":/bin:/usr/bin").c_str(), 1);
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", out});
  ::setenv("PATH", path.c_str(), 1);
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("no terminal today") != std::string::npos);
  CHECK(fs::exists(out + "/results.json"));
}

TEST_CASE("with gnuplot figures are written, and the scripts of those that it plots") {
  if (std::system("command -v gnuplot > /dev/null") != 0) {
    WARN("gnuplot is not installed: its plots are not tested");
    return;
  }
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  REQUIRE(test::run_program({"verify", rig, "--out", out}).exit_code == 1);
  for (const char* name : {"cut-forces", "mechanism", "section", "stress", "sn"}) {
    const std::string drawing = test::read_file(out + "/" + name + ".svg");
    CHECK(drawing.find("</svg>") != std::string::npos);
    const bool plotted = std::string(name) != "mechanism" && std::string(name) != "section";
    CHECK(fs::exists(out + "/plots/" + name + ".gp") == plotted);
  }
}

TEST_CASE("figures and reports of an earlier run do not stand beside a newer report") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  fs::create_directories(out + "/plots");
  const std::string old = folder.write("out/sn.svg", "<svg/>");
  const std::string report = folder.write("out/report.pdf", "%PDF");
  const std::string log = folder.write("out/report.log", "!");
  const std::string mine = folder.write("out/mine.svg", "<svg/>");
  REQUIRE(test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--out", out}).exit_code ==
          1);
  for (const std::string& file : {old, report, log}) CHECK_FALSE(fs::exists(file));
  CHECK_FALSE(fs::exists(out + "/plots"));
  CHECK(fs::exists(mine));
}

TEST_CASE("motion: bodies, points and reactions at the asked instants") {
  const test::ProgramResult result =
      test::run_program({"motion", rig, "--at", "1.071", "--at", "0", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  const Json document = Json::parse(result.out);
  CHECK(document["schema"] == "boxbeam.motion/1");
  CHECK(document["degrees_of_freedom"] == 1);
  REQUIRE(document["states"].size() == 2);
  const Json& state = document["states"][0];
  CHECK(state["time"] == 1.071);
  CHECK(state["branch"]["upper"] == "+");
  CHECK(state["reactions"]["B"]["on"] == "beam");
  CHECK(state["reactions"]["B"]["fx"].get<double>() == Approx(110300.111187).epsilon(1e-9));
  CHECK(state["points"]["beam.B"]["x"].get<double>() < 0.0);
  CHECK(state["bodies"].size() == 5);
}

TEST_CASE("motion as tables names what it shows") {
  const test::ProgramResult result = test::run_program({"motion", published, "--at", "0"});
  REQUIRE(result.exit_code == 0);
  for (const char* word : {"degree of freedom", "branch", "upper +", "lower -", "reaction of"}) {
    CHECK(result.out.find(word) != std::string::npos);
  }
}

TEST_CASE("the committed reports are those of the committed cases", "[unsanitized]") {
  const std::pair<std::string, const char*> committed_runs[] = {
      {rig, "reports/sledge-rig"},
      {published, "reports/sledge-rig-published"},
      {test::project_file("sections/sledge-rig/friction.toml"), "reports/sledge-rig-friction"},
      {test::project_file("sections/sledge-rig/rig-detailed.toml"), "reports/sledge-rig-detailed"},
      {test::project_file("sections/slider-crank-press/press.toml"), "reports/slider-crank-press"},
      {test::project_file("sections/four-bar-rocker/rocker.toml"), "reports/four-bar-rocker"},
      {test::project_file("sections/scissor-lift/lift.toml"), "reports/scissor-lift"},
      {test::project_file("sections/pump-jack/beam.toml"), "reports/pump-jack"},
      {test::project_file("sections/drill-truck/truck.toml"), "reports/drill-truck"},
      {test::project_file("sections/sledge-rig/slender.toml"), "reports/sledge-rig-slender"},
      {test::project_file("sections/landing-gear/retraction.toml"),
       "reports/landing-gear-retraction"}};
  for (const auto& [case_file, folder] : committed_runs) {
    CAPTURE(case_file);
    const Json now = results(case_file);
    const Json committed =
        Json::parse(test::read_file(test::project_file(std::string(folder) + "/results.json")));
    CHECK(committed["input_sha256"] == now["input_sha256"]);
    CHECK(committed["verdict"] == now["verdict"]);
    REQUIRE(committed["checks"].size() == now["checks"].size());
    for (const char* criterion : {"yield", "fatigue"}) {
      CHECK(committed["governing"][criterion]["safety_factor"].get<double>() ==
            Approx(now["governing"][criterion]["safety_factor"].get<double>()).epsilon(1e-9));
    }
  }
}

}  // namespace program_test
