#include "boxbeam/project/table_reader.hpp"

#include <cmath>

#include "catch.hpp"

namespace table_reader_test {

using namespace boxbeam;

namespace {

/// A document with its list of problems and a reader of the whole of it.
struct Reading {
  explicit Reading(const std::string& text)
      : document(parse_document("case.toml", text, {})),
        list(document),
        root(list, document.root, "") {}

  /// The problems in the order in which they are reported.
  std::vector<Problem> problems() const {
    try {
      list.raise();
    } catch (const InputError& error) {
      return error.problems();
    }
    return {};
  }

  CaseDocument document;
  ProblemList list;
  TableReader root;
};

bool says(const Problem& problem, const std::string& part) {
  return problem.message.find(part) != std::string::npos;
}

bool hints(const Problem& problem, const std::string& part) {
  return problem.hint.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a sound table is read without a problem") {
  Reading r(
      "length = \"250 mm\"\nat = [\"1 m\", \"-2 m\"]\nlist = [\"1 m\", \"2 m\", \"3 m\"]\n"
      "cycles = 1e8\ncategory = 100\nexact = true\nname = \"x\"\nnames = [\"a\", \"b\"]\n"
      "kind = \"pin\"\n[below]\nmass = \"20 t\"\n[[rows]]\na = 1\n[[rows]]\na = 2\n");
  CHECK(r.root.quantity("length", wanted::length) == Approx(0.25).epsilon(1e-14));
  CHECK(r.root.pair("at", wanted::length) == Eigen::Vector2d(1, -2));
  CHECK(r.root.quantities("list", wanted::length) == std::vector<double>{1, 2, 3});
  CHECK(r.root.number("cycles") == 1e8);
  CHECK(r.root.whole_number("category") == 100);
  CHECK(r.root.boolean("exact", false));
  CHECK(r.root.text("name") == "x");
  CHECK(r.root.texts("names", true) == std::vector<std::string>{"a", "b"});
  CHECK(r.root.choice("kind", {"slider", "pin"}) == 1);
  TableReader below = r.root.table("below");
  CHECK(below.positive("mass", wanted::mass) == 20e3);
  CHECK(below.name() == "below");
  std::vector<TableReader> rows = r.root.tables("rows");
  REQUIRE(rows.size() == 2);
  CHECK(rows[1].whole_number("a") == 2);
  below.finish();
  r.root.finish();
  CHECK(r.problems().empty());
}

TEST_CASE("what is absent takes its fallback without a problem") {
  Reading r("");
  CHECK(r.root.quantity("a", wanted::length, 2.5) == 2.5);
  CHECK(r.root.number("b", 3.0) == 3.0);
  CHECK(r.root.whole_number("c", 4) == 4);
  CHECK(r.root.boolean("d", true));
  CHECK(r.root.text("e", "none") == "none");
  CHECK(r.root.texts("f", false).empty());
  CHECK(r.root.choice("g", {"x", "y"}, 1) == 1);
  CHECK(r.root.pair("h", wanted::length, Eigen::Vector2d(1, 2)) == Eigen::Vector2d(1, 2));
  CHECK(r.root.tables("i").empty());
  r.root.table("j", false).finish();
  CHECK_FALSE(r.root.has("a"));
  CHECK(r.problems().empty());
}

TEST_CASE("every kind of problem is reported at once, in the order of the file, with its hint") {
  Reading r(
      "bare = 1.5\n"            // 1
      "wrong = \"3 kg\"\n"      // 2
      "unit = \"3 furlong\"\n"  // 3
      "zero = \"0 m\"\n"        // 4
      "below = \"-1 m\"\n"      // 5
      "pair = [\"1 m\"]\n"      // 6
      "number = \"5\"\n"        // 7
      "whole = 1.5\n"           // 8
      "yes = \"true\"\n"        // 9
      "name = 5\n"              // 10
      "names = [\"a\", 1]\n"    // 11
      "kind = \"pinn\"\n"       // 12
      "table = 3\n"             // 13
      "rows = 3\n"              // 14
      "lenght = \"1 m\"\n");    // 15
  // Read from the last to the first: the order of reading does not matter.
  r.root.tables("rows");
  r.root.table("table");
  r.root.choice("kind", {"pin", "slider"});
  r.root.texts("names", true);
  r.root.text("name");
  r.root.boolean("yes", false);
  r.root.whole_number("whole");
  r.root.number("number");
  r.root.pair("pair", wanted::length);
  r.root.not_negative("below", wanted::length);
  r.root.positive("zero", wanted::length);
  r.root.quantity("unit", wanted::length);
  r.root.quantity("wrong", wanted::length);
  r.root.quantity("bare", wanted::length);
  r.root.quantity("length", wanted::length, 0.0);
  r.root.finish();

  const std::vector<Problem> problems = r.problems();
  REQUIRE(problems.size() == 15);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    CHECK(problems[i].line == static_cast<int>(i) + 1);
    CHECK(problems[i].column > 0);
  }
  CHECK(says(problems[0], "a bare number"));
  CHECK(hints(problems[0], "0.25 m"));
  CHECK(says(problems[1], "is a mass"));
  CHECK(hints(problems[1], "0.25 m"));
  CHECK(says(problems[2], "furlong"));
  CHECK(says(problems[3], "above zero"));
  CHECK(says(problems[4], "below zero"));
  CHECK(says(problems[5], "two values"));
  CHECK(says(problems[6], "without quotation marks"));
  CHECK(hints(problems[6], "write number = 5"));
  CHECK(says(problems[7], "whole number"));
  CHECK(says(problems[8], "true or false"));
  CHECK(says(problems[9], "is a text"));
  CHECK(says(problems[10], "list of texts"));
  CHECK(hints(problems[11], "did you mean \"pin\""));
  CHECK(says(problems[12], "wanted as a table"));
  CHECK(says(problems[13], "list of tables"));
  CHECK(says(problems[14], "unknown key \"lenght\""));
  CHECK(hints(problems[14], "did you mean \"length\""));
}

TEST_CASE("a missing key is reported where its table stands, with an example") {
  Reading r("a = 1\n[beam]\nx = 1\n");
  r.root.table("beam").quantity("density", wanted::density);
  const auto problems = r.problems();
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].line == 2);
  CHECK(says(problems[0], "[beam] has no \"density\""));
  CHECK(hints(problems[0], "7850 kg/m^3"));
}

TEST_CASE("a missing table is one problem, its keys none") {
  Reading r("");
  TableReader beam = r.root.table("beam");
  beam.quantity("density", wanted::density);
  beam.text("name");
  beam.finish();
  REQUIRE(r.list.size() == 1);
  CHECK(says(r.problems()[0], "\"beam\""));
}

TEST_CASE("an unknown key far from all known ones lists what is known") {
  Reading r("zzzzzzzz = 1\n");
  r.root.text("name", "");
  r.root.text("title", "");
  r.root.finish();
  const auto problems = r.problems();
  REQUIRE(problems.size() == 1);
  CHECK(hints(problems[0], "name, title"));
}

TEST_CASE("keys of the user's own names are all taken") {
  Reading r("[bodies.beam]\nmass = \"1 kg\"\n[bodies.rod]\nmass = \"2 kg\"\n");
  TableReader bodies = r.root.table("bodies");
  double sum = 0.0;
  std::string names;
  for (auto& [name, body] : bodies.named_tables()) {
    names += name + " ";
    sum += body.positive("mass", wanted::mass);
    CHECK(body.name() == "bodies." + name);
    body.finish();
  }
  bodies.finish();
  r.root.finish();
  CHECK(names == "beam rod ");
  CHECK(sum == 3.0);
  CHECK(r.problems().empty());
}

TEST_CASE("a number must be finite and above zero") {
  Reading r("a = nan\nb = inf\nc = -1\nd = 0\n");
  for (const char* key : {"a", "b", "c", "d"}) CHECK(std::isnan(r.root.number(key)));
  CHECK(r.list.size() == 4);
}

TEST_CASE("a number of either sign, and a quantity that is not zero") {
  Reading r("a = -2.5\nb = 0\nc = \"-1 m\"\nd = inf\ne = 1e-30\nf = \"0 m\"\ng = \"1e-30 m\"\n");
  CHECK(r.root.any_number("a") == -2.5);
  CHECK(r.root.any_number("b") == 0.0);
  CHECK(r.root.any_number("z", -1.0) == -1.0);
  CHECK(r.root.not_zero("c", wanted::length) == -1.0);
  CHECK(r.list.empty());
  CHECK(std::isnan(r.root.any_number("d")));
  CHECK(std::isnan(r.root.any_number("e")));
  CHECK(std::isnan(r.root.not_zero("f", wanted::length)));
  CHECK(std::isnan(r.root.not_zero("g", wanted::length)));
  const auto problems = r.problems();
  REQUIRE(problems.size() == 4);
  CHECK(says(problems[0], "must be finite"));
  CHECK(says(problems[1], "too small"));
  CHECK(says(problems[2], "must not be zero"));
  CHECK(says(problems[3], "too small"));
}

TEST_CASE("quantities of a dimension each, and not more than these") {
  const WantedDimension each[] = {wanted::length, wanted::velocity};
  Reading r(
      "a = [\"1 mm\", \"2 m/s\"]\nb = [\"1 m\"]\nc = [\"1 m\", \"2 m\"]\n"
      "d = [\"1 m\", \"2 m/s\", \"3 m\"]\n");
  CHECK(r.root.quantities("a", each) == std::vector<double>{0.001, 2.0});
  CHECK(r.root.quantities("b", each) == std::vector<double>{1.0});
  CHECK(r.list.empty());
  r.root.quantities("c", each);
  CHECK(r.root.quantities("d", each).empty());
  const auto problems = r.problems();
  REQUIRE(problems.size() == 2);
  CHECK(says(problems[0], "\"c\", value 2, is a velocity, but \"2 m\" is a length"));
  CHECK(says(problems[1], "\"d\" takes at most 2 values"));
}

TEST_CASE("a problem that is noted twice is reported once") {
  Reading r("a = 1\n");
  r.root.text("a");
  r.root.text("a");
  CHECK(r.problems().size() == 1);
}

TEST_CASE("a wrong value does not pass for a right one: it becomes not-a-number or empty") {
  Reading r("a = 1\nb = [1, 2]\n");
  CHECK(std::isnan(r.root.quantity("a", wanted::length)));
  CHECK(std::isnan(r.root.positive("a", wanted::length)));
  CHECK(r.root.pair("b", wanted::length).hasNaN());
  CHECK(r.root.text("a").empty());
  CHECK(r.root.texts("b", true).empty());
}

TEST_CASE("a size that nobody means is refused, large or small") {
  Reading r("a = \"1e30 m\"\nb = \"1e-30 m\"\nc = 1e30\nd = 1e-30\n");
  CHECK(std::isnan(r.root.quantity("a", wanted::length)));
  CHECK(std::isnan(r.root.positive("b", wanted::length)));
  CHECK(std::isnan(r.root.number("c")));
  CHECK(std::isnan(r.root.number("d")));
  CHECK(r.list.size() == 4);
}

TEST_CASE("a required text must not be empty") {
  Reading r("name = \"\"\n");
  r.root.text("name");
  CHECK(r.list.size() == 1);
  CHECK(r.root.text("name", "fallback").empty());
  CHECK(r.list.size() == 1);
}

TEST_CASE("a value that is no table is one problem, its keys none") {
  Reading r("beam = 3\n");
  TableReader beam = r.root.table("beam");
  beam.quantity("density", wanted::density);
  beam.problem("density", "not said");
  CHECK(r.list.size() == 1);
}

TEST_CASE("no problem, no error") {
  Reading r("a = 1\n");
  CHECK(r.list.empty());
  CHECK_NOTHROW(r.list.raise());
}

}  // namespace table_reader_test
