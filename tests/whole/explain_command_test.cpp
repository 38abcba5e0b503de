// boxbeam explain and validate: what a check rests on, and what a case is.

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace explain_command_test {

using Json = nlohmann::json;

namespace {

const std::string rig = "sections/sledge-rig/rig.toml";

test::ProgramResult explain(const std::string& check, const std::string& case_file = rig) {
  return test::run_program({"explain", check, case_file});
}

Json results() {
  const test::TemporaryFolder folder;
  return Json::parse(test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--no-html",
                                        "--json", "-", "--out", folder.path().string()})
                         .out);
}

/// The id that a sheet is about: its first word that a check has.
bool is_about(const test::ProgramResult& sheet, const std::string& id) {
  return sheet.exit_code == 0 && sheet.out.find(id) != std::string::npos;
}

}  // namespace

TEST_CASE("explain: the check of an id with its factor, requirement and source", "[explain]") {
  const Json check = results()["governing"]["fatigue"];
  const test::ProgramResult result = explain(check["id"].get<std::string>());
  INFO(result.out << result.err);
  CHECK(is_about(result, check["id"].get<std::string>()));
  // tests/validation/independent_sledge_rig.py: factor 1.2126 of 2.
  for (const char* part : {"1.21", "2.00", "165 %", "EN 1993-1-9"}) {
    INFO(part);
    CHECK(result.out.find(part) != std::string::npos);
  }
}

TEST_CASE("explain: beginnings of ids stand for the worst check below them", "[explain]") {
  const Json checks = results()["checks"];
  const auto worst_below = [&](const std::string& begin) {
    for (const Json& check : checks) {  // worst first
      const std::string id = check["id"];
      if (begin.empty() || id.starts_with(begin + "/")) return id;
    }
    for (const Json& check : checks) {
      const std::string id = check["id"];
      if (id.starts_with(begin)) return id;
    }
    return std::string();
  };
  CHECK(is_about(explain("governing"), worst_below("")));
  for (const std::string begin :
       {"yield", "shear-fatigue", "weld", "fatigue/5.2+", "shear", "combined"}) {
    INFO(begin);
    CHECK(is_about(explain(begin), worst_below(begin)));
  }
}

TEST_CASE("explain list: every id once, worst first", "[explain]") {
  const Json checks = results()["checks"];
  const std::string list = explain("list").out;
  std::size_t at = 0;
  for (const Json& check : checks) {
    const std::size_t found = list.find("  " + check["id"].get<std::string>() + "\n", at);
    REQUIRE(found != std::string::npos);
    at = found + 1;
  }
  CHECK(static_cast<std::size_t>(std::count(list.begin(), list.end(), '\n')) == checks.size());
}

TEST_CASE("explain: every check of every kind of case can be explained", "[explain][unsanitized]") {
  for (const std::string case_file :
       {"sections/drill-truck/truck.toml", "sections/landing-gear/gear.toml",
        "sections/sledge-rig/rig-detailed.toml"}) {
    for (const std::string check : {"governing", "yield", "fatigue"}) {
      const test::ProgramResult result = explain(check, case_file);
      INFO(case_file << " " << check << " " << result.err);
      CHECK(result.exit_code == 0);
      CHECK(result.out.size() > 200);
    }
  }
}

TEST_CASE("explain: an unknown id is answered with the nearest one", "[explain]") {
  const auto refused = [](const std::string& check, const std::string& said) {
    const test::ProgramResult result = explain(check);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err.find(said) != std::string::npos);
  };
  refused("fatige", "did you mean fatigue?");
  refused("fatigue/4.2-/fibre+y", "did you mean fatigue/4.2-/fibre+z?");
  refused("moonlight-on-the-beam", "boxbeam explain list CASE shows all");
}

TEST_CASE("validate: says what a sound case is", "[validate]") {
  const test::ProgramResult result = test::run_program({"validate", rig});
  CHECK(result.exit_code == 0);
  for (const char* part :
       {"nothing is wrong", "planar", "5: beam, upper_rod, blade, lower_rod", "1: exciter",
        "6.2 m, 4946.95 kg", "3: hub, bolt 1, bolt 2", "S355", "1e+08 cycles"}) {
    INFO(part);
    CHECK(result.out.find(part) != std::string::npos);
  }
  for (const std::string case_file :
       {"sections/drill-truck/truck.toml", "sections/landing-gear/retraction.toml",
        "sections/sledge-rig/rig-detailed.toml", "sections/slider-crank-press/press.toml"}) {
    INFO(case_file);
    CHECK(test::run_program({"validate", case_file}).exit_code == 0);
  }
}

TEST_CASE("validate: lists everything that is wrong, in the order of the file", "[validate]") {
  const test::ProgramResult result = test::run_program(
      {"validate", rig, "--set", "bodies.sledge.mas=1 kg", "--set", "beam.density=7850"});
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(result.err.find("did you mean \"mass\"?") != std::string::npos);
  CHECK(result.err.find("a density, not a bare number") != std::string::npos);
  CHECK(result.err.find("2 errors; nothing was written") != std::string::npos);
}

TEST_CASE("validate, motion, section and errors show what a user's text would do to a terminal",
          "[explain]") {
  const test::TemporaryFolder folder;
  std::string text = test::read_file(test::project_file("sections/templates/planar.toml"));
  const std::size_t title = text.find("\ntitle = ");
  REQUIRE(title != std::string::npos);
  text.replace(title, text.find('\n', title + 1) - title,
               "\ntitle = \"a\\u001b[31mred\\u0007 \\u202e\\nend\"");
  const std::string file = folder.write("hostile.toml", text);
  const std::string shown = "a\\x1B[31mred\\x07 \\u202E\\nend";
  for (const std::string command : {"validate", "motion"}) {
    INFO(command);
    CHECK(test::run_program({command, file}).out.find(shown) != std::string::npos);
  }
  for (const test::ProgramResult& result :
       {test::run_program({"section", "RHS \x1b[31m"}),
        test::run_program({"motion", file, "--at", "\x1b[31m"}),
        test::run_program({"fatigue", "\x1b[31m", "--detail", "100"}),
        test::run_program({"verify", file, "--no-plots", "--no-pdf", "--out", file + "/\x1b[31m"}),
        test::run_program({"validate", folder.write("bad.toml", "\t\x1b[31m = 1\n")})}) {
    INFO(result.err);
    CHECK(result.err.find("\\x1B[31m") != std::string::npos);
    CHECK((result.err + result.out).find('\x1b') == std::string::npos);
  }
}

}  // namespace explain_command_test
