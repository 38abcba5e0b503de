// boxbeam compare as a user runs it.

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace compare_command_test {

using test::contains;

namespace {

using Json = nlohmann::ordered_json;

const std::string rig = "sections/sledge-rig/rig.toml";
const std::string header = "result,published,tolerance,reason,source\n";

/// Runs the comparison of the rig with a table of these rows.
test::ProgramResult compared(const std::string& rows, std::vector<std::string> more = {}) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments{"compare", rig, folder.write("table.csv", header + rows)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::run_program(arguments);
}

}  // namespace

TEST_CASE("compare: the shipped tables agree or say why", "[compare][whole]") {
  struct Row {
    const char* of_case;
    const char* table;
    int agree, explained;
  };
  // As the packs' README say.
  const Row rows[] = {
      {"sledge-rig/published.toml", "sledge-rig/thesis.csv", 308, 58},
      {"sledge-rig/rig.toml", "sledge-rig/thesis-rigorous.csv", 7, 30},
      {"landing-gear/gear.toml", "landing-gear/published.csv", 18, 10},
  };
  for (const Row& row : rows) {
    INFO(row.table);
    const test::ProgramResult result =
        test::run_program({"compare", std::string("sections/") + row.of_case,
                           std::string("sections/") + row.table, "--json", "-"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    const Json json = Json::parse(result.out);
    CHECK(json["agree"] == row.agree);
    CHECK(json["explained"] == row.explained);
    CHECK(json["differ"] == 0);
  }
}

TEST_CASE("compare: exit 1 where a value differs without a reason", "[compare][whole]") {
  CHECK(compared("beam.length,6.2 m,1 %,,\n").exit_code == 0);
  CHECK(compared("beam.length,7 m,1 %,another beam,\n").exit_code == 0);
  const test::ProgramResult result = compared("beam.length,7000 mm,1 %,,drawing 3\n");
  CHECK(result.exit_code == 1);
  CHECK(result.err.empty());
  for (const char* said : {"beam.length", "7000", "6200", "mm", "-11 %", "drawing 3"}) {
    INFO(said);
    CHECK(contains(result.out, said));
  }
}

TEST_CASE("compare: overrides and the load model count", "[compare][whole]") {
  CHECK(compared("mechanism.bodies.sledge.mass,20 t,0 t,,\n").exit_code == 1);
  CHECK(compared("mechanism.bodies.sledge.mass,20 t,0 t,,\n",
                 {"--set", "bodies.sledge.mass=\"20 t\""})
            .exit_code == 0);
  // The chain's loads are in the plane's forces on the beam.
  const std::string chain = "stations[6.2-].V.max,102.7 kN,0.5 %,,\n";
  CHECK(compared(chain).exit_code == 1);
  CHECK(compared(chain, {"--dynamics", "newton-chain"}).exit_code == 0);
}

TEST_CASE("compare: HTML and JSON go to files", "[compare][whole]") {
  const test::TemporaryFolder folder;
  const std::string html = (folder.path() / "c.html").string();
  const std::string json = (folder.path() / "c.json").string();
  const test::ProgramResult result = compared(
      "beam.length,7 m,1 %,<b>long</b> & \"bent\" \xC3\xB8,\n", {"--html", html, "--json", json});
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "<b>long</b> & \"bent\" \xC3\xB8"));
  const std::string page = test::read_file(html);
  CHECK(contains(page, "&lt;b&gt;long&lt;/b&gt; &amp;"));
  CHECK_FALSE(contains(page, "<b>long</b>"));
  CHECK(contains(page, "6.200"));
  CHECK(Json::parse(test::read_file(json))["explained"] == 1);
  CHECK(compared("beam.length,6.2 m,1 %,,\n", {"--html", "/dev/null/x/c.html"}).exit_code == 4);
}

TEST_CASE("compare: a broken table is refused with file, line and column", "[compare][whole]") {
  const test::ProgramResult result = compared("beam.lenght,6.2 m,1 %,,\nbeam.mass,5 m,1 %,,\n");
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(contains(result.err, "table.csv:2:1: error: there is no result \"beam.lenght\""));
  CHECK(contains(result.err, "did you mean beam.length?"));
  CHECK(contains(result.err, "table.csv:3:11: error: beam.mass is a mass"));
  CHECK(test::run_program({"compare", rig, "/nonexistent.csv"}).exit_code == 2);
  CHECK(test::run_program({"compare", rig}).exit_code == 2);
}

}  // namespace compare_command_test
