// The command "section" as a user runs it.

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace section_command_test {

using Json = nlohmann::json;

TEST_CASE("section RHS 200x100x8: EN 10210-2's properties in SI") {
  const test::ProgramResult result =
      test::run_program({"section", "RHS", "200x100x8", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  const Json json = Json::parse(result.out);
  CHECK(json["schema"] == "boxbeam.section/1");
  CHECK(json["area"].get<double>() * 1e4 == Approx(44.75).margin(0.005));
  CHECK(json["I_y"].get<double>() * 1e8 == Approx(2234).margin(0.5));
  CHECK(json["I_z"].get<double>() * 1e8 == Approx(739).margin(0.5));
  CHECK(json["I_T"].get<double>() * 1e8 == Approx(1804).margin(0.5));
}

TEST_CASE("section box: the rig's pivot section by hand, the same from its case file") {
  const test::ProgramResult words =
      test::run_program({"section", "box 400x1000 flange 50 web 50", "--json", "-"});
  REQUIRE(words.exit_code == 0);
  const Json json = Json::parse(words.out);
  CHECK(json["I_y"].get<double>() * 1e12 ==
        Approx((400e9 - 300.0 * 900 * 900 * 900) / 12).epsilon(1e-9));
  CHECK(json["I_T"].get<double>() * 1e12 == Approx(8.8577e9).epsilon(5e-4));
  const test::ProgramResult file = test::run_program(
      {"section", test::project_file("sections/sledge-rig/rig.toml") + ":A2", "--json", "-"});
  REQUIRE(file.exit_code == 0);
  CHECK(Json::parse(file.out)["I_T"] == json["I_T"]);
}

TEST_CASE("section: several profiles give a list, a table each") {
  const test::ProgramResult result =
      test::run_program({"section", "SHS 100x5", "CHS 168.3x8", "--json", "-"});
  REQUIRE(result.exit_code == 0);
  CHECK(Json::parse(result.out).size() == 2);
  const test::ProgramResult text = test::run_program({"section", "SHS", "100x5"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("class 1 up to") != std::string::npos);
}

TEST_CASE("section: wrong words are exit code 2 with a hint") {
  for (const std::string& wrong :
       {std::string("RHS 200x100x9"), std::string("box 400x600"), std::string("IPE 200"),
        std::string("no-such.toml:A"), std::string("box 400x600 flange 300 web 50"),
        test::project_file("sections/sledge-rig/rig.toml") + ":A9"}) {
    const test::ProgramResult result = test::run_program({"section", wrong});
    INFO(wrong << "\n" << result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(result.err.find("hint: ") != std::string::npos);
  }
  CHECK(test::run_program({"section"}).exit_code == 2);
  CHECK(test::run_program({"section", "SHS 100x5", "--steel", "S1"}).exit_code == 2);
}

}  // namespace section_command_test
