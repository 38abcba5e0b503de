// What a study says wrongly is answered with what to write; nothing said is left out.

#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/study.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace read_study_test {

using namespace boxbeam;

namespace {

const std::string head = "[study]\ncase = \"rig.toml\"\n";

/// The first problem of a study.
Problem problem_of(const std::string& text, const std::string& path = "study.toml") {
  try {
    parse_study(path, text);
  } catch (const InputError& error) {
    return error.problems().front();
  }
  return {};
}

std::string variable(const std::string& name, const std::string& says) {
  return "[variables." + name + "]\n" + says + "\n";
}

}  // namespace

// Before, the one that stood last counted.
TEST_CASE("a correlation that is said twice is refused", "[study]") {
  const std::string two = "[study]\nsamples = 8\n" +
                          variable("a", "distribution = \"normal\"\nmean = 1\nsd = 0.1") +
                          variable("b", "distribution = \"normal\"\nmean = 1\nsd = 0.1") +
                          "[results]\ncolumns = [\"f = a + b\"]\n[correlation]\n\"a,b\" = 0.5\n";
  CHECK(problem_of(two).message.empty());
  const Problem twice = problem_of(two + "\"b, a\" = -0.5\n");
  CHECK(twice.message.find("said twice") != std::string::npos);
  CHECK(twice.line == 15);
}

TEST_CASE("keys that set the same, or a part of what another sets, are refused", "[study]") {
  const auto keys = [](const std::string& one, const std::string& other) {
    return problem_of(head + variable("a", "values = [1]\nkey = '" + one + "'") +
                      variable("b", "values = [1]\nkey = '" + other + "'"))
        .message;
  };
  CHECK(keys("a.b", "a.c").empty());
  CHECK(keys("a.b", "a.bc").empty());
  CHECK(keys("beam.segments.0.length", "beam.segments.10.length").empty());
  CHECK(keys("a.b", "a.b").find("two variables") != std::string::npos);
  CHECK(keys("a.b", " a.\"b\" ").find("two variables") != std::string::npos);
  CHECK(keys("beam.segments.0.length", "beam.segments.00.length").find("two variables") !=
        std::string::npos);
  CHECK(keys("drivers.exciter.amplitude", "drivers.exciter").find("part of the other") !=
        std::string::npos);
  CHECK(keys("drivers.exciter", "drivers.exciter.amplitude").find("part of the other") !=
        std::string::npos);
}

TEST_CASE("what a list of values cannot be is named", "[study]") {
  const Problem mixed = problem_of(head + variable("a", "values = [\"8 mm\", \"S355\"]"));
  CHECK(mixed.message.find("\"S355\"") != std::string::npos);
  const Problem twice =
      problem_of(head + variable("a", "values = [1, 2]\ngrid = { from = 1, to = 2, count = 2 }"));
  CHECK(twice.message.find("says twice") != std::string::npos);
  const Problem never = problem_of(head + variable("a", "key = \"a.b\""));
  CHECK(never.message.find("does not say") != std::string::npos);
}

// Of EN 1990 the rules of combination are "6.10" and "6.10a/b".
TEST_CASE("among words a number is a word, and is set as one", "[study]") {
  const Study study = parse_study(
      "study.toml",
      head + variable("rule", "key = \"load_cases.rule\"\nvalues = [\"6.10\", \"6.10a/b\"]"));
  REQUIRE(study.variables.front().words.size() == 2);
  const DesignSpace space(study);
  CHECK(space.overrides(space.at(0)) == std::vector<std::string>{"load_cases.rule=\"6.10\""});
  CHECK(space.overrides(space.at(1)) == std::vector<std::string>{"load_cases.rule=6.10a/b"});
}

// Before, "t = 3" made t 3 and was fulfilled, and of two limits with a comma the last counted.
TEST_CASE("an expression has one value, and changes no variable", "[study]") {
  const auto limit = [](const std::string& text) {
    return problem_of("[study]\nsamples = 8\n" +
                      variable("t", "distribution = \"normal\"\nmean = 1\nsd = 0.1") +
                      "[limit_state]\nexpression = \"" + text + "\"\n")
        .message;
  };
  for (const char* good : {"t - 3", "(t == 3) - 0.5", "(t <= 3) + (t >= 4) - (t != 5)",
                           "min(t, 3) - max(t, 2)", "t < 3 ? 1 : 2"})
    CHECK(limit(good).empty());
  for (const char* bad : {"t = 3", "t - 3, t - 4", "(t = 3)", "t =3 + t", "min(t = 3, 2)"})
    CHECK_FALSE(limit(bad).empty());
  const auto keep = [](const std::string& text) {
    return problem_of("[study]\n" + variable("t", "values = [1, 2]") +
                      "[results]\ncolumns = [\"f = 2*t\"]\nkeep = \"" + text + "\"\n")
        .message;
  };
  CHECK(keep("f == 2").empty());
  CHECK(keep("f = 2").find("\"==\"") != std::string::npos);
  CHECK_FALSE(problem_of("[study]\n" + variable("t", "values = [1, 2]") +
                         "[results]\ncolumns = [\"f = t = 3\"]\n")
                  .message.empty());
  CHECK_FALSE(problem_of(head + variable("_pi", "values = [1, 2]")).message.empty());
}

// A limit is what is not below zero: a condition, which is 0 where it does not hold, would always
// be.
TEST_CASE("a condition is no limit", "[study]") {
  const auto limit = [](const std::string& text) {
    return problem_of("[study]\n" + variable("t", "grid = { from = 1, to = 2, count = 2 }") +
                      "[optimise]\nminimise = \"t\"\nsubject_to = [\"" + text + "\"]\n")
        .message;
  };
  const auto state = [](const std::string& text) {
    return problem_of("[study]\nsamples = 8\n" +
                      variable("t", "distribution = \"normal\"\nmean = 1\nsd = 0.1") +
                      "[limit_state]\nexpression = \"" + text + "\"\n")
        .message;
  };
  for (const char* bad : {"t >= 2", "t > 2", "(t > 2)", " ((t <= 2)) ", "t == 2", "t > 1 && t < 2",
                          "(t > 1) || (t < 0)", "2*t != 1"}) {
    CAPTURE(bad);
    CHECK(limit(bad).find("never below zero") != std::string::npos);
    CHECK(state(bad).find("never below zero") != std::string::npos);
  }
  for (const char* good : {"t - 2", "(t > 2) - 0.5", "(t > 2) * (t - 2)", "t > 2 ? 1 : -1",
                           "min(t > 1, t < 2) - 1", "-(t - 2)"}) {
    CAPTURE(good);
    CHECK(limit(good).empty());
    CHECK(state(good).empty());
  }
}

TEST_CASE("a table of which no variable takes a column is refused", "[study]") {
  const ::test::TemporaryFolder folder;
  folder.write("designs.csv", "t [mm],w\n8,1\n");
  const Problem unused = problem_of(
      "[study]\ncase = \"rig.toml\"\ntable = \"designs.csv\"\n" + variable("a", "values = [1, 2]"),
      (folder.path() / "study.toml").string());
  CHECK(unused.message.find("no variable takes") != std::string::npos);
  CHECK(unused.hint.find("\"t\"") != std::string::npos);
}

}  // namespace read_study_test
