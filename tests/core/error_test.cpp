#include "boxbeam/core/error.hpp"

#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"

namespace error_test {

using namespace boxbeam;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The characters (code points) of UTF-8 text.
std::vector<std::string> characters_of(const std::string& text) {
  std::vector<std::string> characters;
  for (char byte : text) {
    if ((static_cast<unsigned char>(byte) & 0xC0U) == 0x80U)
      characters.back() += byte;
    else
      characters.emplace_back(1, byte);
  }
  return characters;
}

Problem problem_in(const std::string& line, int column) {
  return {"case.toml", 7, column, line, "wrong", ""};
}

/// The character of the shown line above the caret; checks that a tab stands above every tab of
/// the margin, so that both lines are as wide on any terminal.
std::string above_caret(const Problem& problem) {
  const std::vector<std::string> lines = lines_of(to_text(problem));
  REQUIRE(lines.size() >= 3);
  const std::vector<std::string> shown = characters_of(lines[1]);
  const std::string& margin = lines[2];
  REQUIRE(margin.back() == '^');
  for (std::size_t i = 0; i + 1 < margin.size(); ++i) {
    REQUIRE(i < shown.size());
    CHECK((shown[i] == "\t") == (margin[i] == '\t'));
  }
  const std::size_t at = margin.size() - 1;
  return at < shown.size() ? shown[at] : "";
}

}  // namespace

TEST_CASE("a problem prints file:line:column, the line, a caret and the hint") {
  const Problem problem{"rig.toml", 12, 10, "length = 1.5", "a bare number", "write \"1.5 m\""};
  CHECK(to_text(problem) ==
        "rig.toml:12:10: error: a bare number\n"
        "    length = 1.5\n"
        "             ^\n"
        "    hint: write \"1.5 m\"\n");
}

TEST_CASE("a problem without a place prints no line and no caret") {
  CHECK(to_text({"rig.toml", 0, 0, "", "there is no such file", ""}) ==
        "rig.toml: error: there is no such file\n");
  CHECK(to_text({"", 0, 0, "", "wrong usage", "see --help"}) ==
        "error: wrong usage\n    hint: see --help\n");
}

TEST_CASE("the caret stands under the column that is meant, wherever it is") {
  const std::string plain = "abcdefghij";
  const std::string tabs = "\ta\tbc = \t1";
  const std::string accents = "µ = \"12 kN·m\" # Größe";
  for (const std::string& line : {plain, tabs, accents}) {
    const std::vector<std::string> characters = characters_of(line);
    for (std::size_t i = 0; i < characters.size(); ++i) {
      CAPTURE(line, i);
      CHECK(above_caret(problem_in(line, static_cast<int>(i) + 1)) == characters[i]);
    }
  }
}

TEST_CASE("a caret may stand just behind the line, where something is missing") {
  CHECK(above_caret(problem_in("length =", 9)).empty());
  CHECK(above_caret(problem_in("", 1)).empty());
  // A column far behind the line is brought back to its end.
  CHECK(above_caret(problem_in("abc", 1000)).empty());
}

TEST_CASE("a very long line is cut around the caret, not in the middle of a character") {
  std::string line;
  for (int i = 0; i < 20000; ++i) line += i % 10 == 0 ? "é" : std::string(1, char('a' + i % 10));
  const std::vector<std::string> characters = characters_of(line);
  for (const int column : {1, 2, 79, 80, 81, 82, 83, 84, 160, 9999, 10000, 10001, 19999, 20000}) {
    CAPTURE(column);
    const Problem problem = problem_in(line, column);
    CHECK(above_caret(problem) == characters[static_cast<std::size_t>(column) - 1]);
    const std::vector<std::string> lines = lines_of(to_text(problem));
    CHECK(lines[1].size() < 400);
    CHECK(lines[2].size() < 200);
  }
}

TEST_CASE("an input error joins the text of all its problems in their order") {
  const std::vector<Problem> problems{{"a.toml", 1, 1, "x", "first", ""},
                                      {"a.toml", 2, 1, "y", "second", "do that"}};
  const InputError error(problems);
  CHECK(error.what() == to_text(problems[0]) + to_text(problems[1]));
  REQUIRE(error.problems().size() == 2);
  CHECK(error.problems()[1].message == "second");
}

TEST_CASE("an input error from a message alone has one problem without a place") {
  const InputError error("wrong usage", "see --help");
  REQUIRE(error.problems().size() == 1);
  CHECK(error.problems()[0].line == 0);
  CHECK(std::string(error.what()) == "error: wrong usage\n    hint: see --help\n");
}

TEST_CASE("an analysis error says what, where, when and how far off") {
  const AnalysisError error({"the loop cannot close", "loop upper", 1.071, 2.5e-3, 4e17});
  CHECK(error.failure().where == "loop upper");
  CHECK(error.failure().time == 1.071);
  const std::string text = error.what();
  for (const char* part : {"the loop cannot close", "loop upper", "1.071 s", "0.0025", "4e+17"}) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("an analysis error leaves out what is not known") {
  const AnalysisError error({"no driver", "", {}, {}, {}});
  CHECK(std::string(error.what()) == "no driver");
}

}  // namespace error_test
