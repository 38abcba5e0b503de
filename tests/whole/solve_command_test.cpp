// boxbeam solve as a user runs it: which results it knows, and what it says of the values found.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.hpp"
#include "support/box_cantilever.hpp"
#include "support/program.hpp"

namespace solve_command_test {

using nlohmann::json;
using test::box_of_cantilever;
using test::cantilever;
using test::mass_of_box;
using test::run_program;
using test::tube_of_cantilever;

namespace {

/// The roots that solve finds of the cantilever for its flange.
json roots_of(const std::string& file, const std::string& wanted) {
  const auto ran = run_program(
      {"solve", file, "--for", "sections.of.flange", "--such-that", wanted, "--json", "-"});
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  return json::parse(ran.out).at("roots");
}

}  // namespace

TEST_CASE("a value is solved for in a case that cannot be verified as it is", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  const std::string wanted = "beam.mass = " + std::to_string(mass_of_box(0.012)) + " kg";
  // Flanges of 160 mm do not fit into 300 mm.
  const auto ran = run_program({"solve", file, "--set", "sections.of.flange=160 mm", "--for",
                                "sections.of.flange", "--such-that", wanted, "--between", "5 mm",
                                "170 mm", "--json", "-"});
  REQUIRE(ran.exit_code == 0);
  const json solved = json::parse(ran.out);
  REQUIRE(solved.at("roots").size() == 1);
  CHECK(solved.at("roots").at(0).at("value").get<double>() == Approx(12.0).epsilon(1e-6));
  // Where nothing can be verified the case's own trouble is said.
  const auto none =
      run_program({"solve", file, "--set", "sections.of.flange=160 mm", "--for",
                   "sections.of.flange", "--such-that", wanted, "--between", "155 mm", "170 mm"});
  CHECK(none.exit_code == 2);
  CHECK(none.err.find("sections.of") != std::string::npos);
}

TEST_CASE("that a key does not change a result is said", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  const auto ran = run_program(
      {"solve", file, "--for", "loads.\"tip.1\".force.1", "--such-that", "beam.mass = 1 t"});
  CHECK(ran.exit_code == 1);
  CHECK(ran.out.find("does not change it") != std::string::npos);
}

// Use is required over existing factor, so that all of these ask the same.
TEST_CASE("the use of what is used most is solved for, as a part or in per cent", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  const double by_factor = roots_of(file, "yield.safety_factor = 10").at(0).at("value");
  for (const char* wanted :
       {"utilisation = 0.1", "utilisation = 10 %", "yield.utilisation = 10%"}) {
    CAPTURE(wanted);
    CHECK(roots_of(file, wanted).at(0).at("value").get<double>() ==
          Approx(by_factor).epsilon(1e-9));
  }
}

// Of slender plates that are used by what works of them, no check of which is yield or fatigue.
TEST_CASE("every criterion that is judged has a result by its name", "[study]") {
  const test::TemporaryFolder folder;
  std::string slender = box_of_cantilever;
  slender.replace(slender.find("10 mm"), 5, "5 mm");
  slender.replace(slender.find("8 mm"), 4, "4 mm");
  const std::string file = folder.write("beam.toml", cantilever(slender));
  for (const char* wanted :
       {"effective section.utilisation = 0.2", "effective_section.utilisation = 0.2"}) {
    const json root = roots_of(file, wanted).at(0);
    const double flange = root.at("value");
    const auto ran = run_program(
        {"verify", file, "--set", "sections.of.flange=" + json(flange).dump() + " mm", "--out",
         folder.path() / "out", "--no-plots", "--no-html", "--no-pdf", "--json", "-"});
    double most = 0.0;
    const json results = json::parse(ran.out);
    for (const json& check : results.at("checks"))
      if (check.at("criterion") == "effective section")
        most = std::max(most, check.at("utilisation").get<double>());
    CHECK(most == Approx(0.2).epsilon(1e-9));
  }
  const auto none = run_program(
      {"solve", file, "--for", "sections.of.flange", "--such-that", "fatigue.utilisation = 1"});
  CHECK(none.exit_code == 2);
  CHECK(none.err.find("the case has no check of it") != std::string::npos);
}

// Round tubes are of class 4 above d/t = 90 235/355 = 59.6 (EN 1993-1-1, table 5.2): the number is
// there, but it is no measure of the tube.
TEST_CASE("values at which no stress counts are told from others", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(tube_of_cantilever));
  const auto ran = run_program({"solve", file, "--for", "sections.of.wall", "--such-that",
                                "utilisation = 0.2", "--json", "-"});
  REQUIRE(ran.exit_code == 0);
  const json root = json::parse(ran.out).at("roots").at(0);
  CHECK(root.at("value").get<double>() < 5.0);
  CHECK(root.at("verdict") == "not applicable");
  CHECK_FALSE(root.at("gate").get<std::string>().empty());
  const std::string table =
      folder.write("published.csv", "result,published,tolerance\nutilisation,0.2,100 %\n");
  const auto compared = run_program({"compare", file, table, "--set", "sections.of.wall=4 mm"});
  CHECK(compared.exit_code == 0);
  CHECK(compared.out.find("count for nothing") != std::string::npos);
}

// Categories are 36, 40, .. 112, 125, 140, 160; the factor on the ranges is in proportion to them
// (EN 1993-1-9, 8(2)), whatever the beam.
TEST_CASE("of a key of whole numbers these alone are looked at", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = test::project_file("sections/templates/loads.toml");
  const auto solved = [&](const std::string& wanted) {
    const auto ran = run_program({"solve", file, "--for", "fatigue.category", "--such-that", wanted,
                                  "--between", "71", "112", "--json", "-"});
    return json::parse(ran.out);
  };
  const auto factor_of = [&](const std::string& category) {
    const auto ran =
        run_program({"verify", file, "--set", "fatigue.category=" + category, "--out",
                     folder.path() / "out", "--no-plots", "--no-html", "--no-pdf", "--json", "-"});
    const json results = json::parse(ran.out);
    return results.at("governing").at("fatigue").at("safety_factor").get<double>();
  };
  const double with_80 = factor_of("80"), with_90 = factor_of("90");
  REQUIRE(with_90 == Approx(90.0 / 80.0 * with_80).epsilon(1e-9));
  const json exact = solved("fatigue.safety_factor = " + json(with_90).dump());
  REQUIRE(exact.at("roots").size() == 1);
  CHECK(exact.at("roots").at(0).at("value") == 90.0);
  const json between = solved("fatigue.safety_factor = " + json(0.5 * (with_80 + with_90)).dump());
  CHECK(between.at("roots").empty());
  REQUIRE(between.at("jumps").size() == 1);
  const json& jump = between.at("jumps").at(0);
  CHECK(jump.at("value") == 85.0);
  CHECK(jump.at("apart") == 10.0);
  CHECK(jump.at("before").get<double>() == Approx(with_80).epsilon(1e-12));
  CHECK(jump.at("behind").get<double>() == Approx(with_90).epsilon(1e-12));
  CHECK(between.at("reason").get<std::string>().find("between 80 and 90") != std::string::npos);
}

TEST_CASE("what is no single value is said to be none", "[study]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("beam.toml", cantilever(box_of_cantilever));
  for (const char* wanted : {"utilisation <= 1", "utilisation < = 1", "utilisation == 1"}) {
    CAPTURE(wanted);
    const auto ran =
        run_program({"solve", file, "--for", "sections.of.flange", "--such-that", wanted});
    CHECK(ran.exit_code == 2);
    CHECK(ran.err.find("is no single value") != std::string::npos);
  }
}

}  // namespace solve_command_test
