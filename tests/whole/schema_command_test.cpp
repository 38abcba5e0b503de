// boxbeam schema: every document has one; tests/schema/ validates documents and cases by them.

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace schema_command_test {

TEST_CASE("schema: of the case by default, of every document by name", "[schema]") {
  const test::ProgramResult of_case = test::run_program({"schema"});
  CHECK(of_case.exit_code == 0);
  CHECK(of_case.out == test::run_program({"schema", "case"}).out);
  for (const std::string document :
       {"case", "results", "motion", "fatigue", "section", "comparison", "reliability"}) {
    INFO(document);
    const test::ProgramResult result = test::run_program({"schema", document});
    CHECK(result.exit_code == 0);
    const auto schema = nlohmann::json::parse(result.out);
    CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
    CHECK(schema["$id"] == "urn:boxbeam:schema:" + document + ":1");
    CHECK(schema.contains("title"));
  }
}

TEST_CASE("schema: another document is refused with those that there are", "[schema]") {
  const test::ProgramResult result = test::run_program({"schema", "report"});
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(result.err.find("{case,results,motion,fatigue,section,comparison,solution,optimum,study,"
                        "reliability,keys}") != std::string::npos);
}

}  // namespace schema_command_test
