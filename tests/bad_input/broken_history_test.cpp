#include <cmath>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/stress_history.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace broken_history_test {

using namespace boxbeam;
using test::contains;

namespace {

Problem problem_of(const StressHistorySource& source) {
  try {
    read_stress_history(source, [](const StressSamples&) {});
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong");
  return {};
}

}  // namespace

TEST_CASE("what is wrong in a stress history is named with its line and column", "[bad_input]") {
  struct Row {
    std::string text;
    int line;
    int column;
    const char* message;
    const char* hint;
  };
  const char* const header = "time [s], sigma [MPa], tau [MPa]";
  const Row rows[] = {
      {"", 0, 0, "the file is empty", header},
      {"# nothing\n\n", 0, 0, "the file is empty", header},
      {"sigma [MPa]\n", 0, 0, "the table has no rows", header},
      {"1\n2\n", 1, 1, "the column \"1\" has no unit in brackets", header},
      {"sigma\n1\n", 1, 1, "the column \"sigma\" has no unit in brackets", header},
      {"sigma [mm]\n1\n", 1, 1, "this column is a stress, but \"[mm]\" is a length", header},
      {"sigma [ksi]\n1\n", 1, 1, "\"ksi\" is not a unit known here", header},
      {"sigma []\n1\n", 1, 1, "a number without unit", header},
      {"time [s]\n1\n", 1, 1, "the table has no column of a stress", header},
      {"sigma [MPa], t [s]\n1, 2\n", 1, 14, "this column is a stress, but \"[s]\" is a time",
       header},
      {"a [MPa], b [MPa], c [MPa]\n1, 2, 3\n", 1, 19, "at most two stresses", "one place"},
      {"sigma [MPa]\n1\n2\ntwo\n", 4, 1, "\"two\" is not a number", "decimal point"},
      {"sigma [MPa]\n1 MPa\n", 2, 1, "\"1 MPa\" is not a number", "without unit"},
      {"sigma [MPa]\n1.2.3\n", 2, 1, "\"1.2.3\" is not a number", "decimal point"},
      {"sigma [MPa]\n-\n", 2, 1, "\"-\" is not a number", "decimal point"},
      {"sigma [MPa]\n1e\n", 2, 1, "\"1e\" is not a number", "decimal point"},
      {"sigma [MPa]\n+-1\n", 2, 1, "\"+-1\" is not a number", "decimal point"},
      {"sigma [MPa]\n0x10\n", 2, 1, "\"0x10\" is not a number", "decimal point"},
      {"sigma [MPa]\n1\n  nan\n", 3, 3, "\"nan\" is not finite", "of the unit"},
      {"sigma [MPa]\n-inf\n", 2, 1, "\"-inf\" is not finite", "of the unit"},
      {"sigma [MPa]\n1e999\n", 2, 1, "\"1e999\" is not finite", "of the unit"},
      {"sigma [MPa]\n1e21\n", 2, 1, "too large to be meant", "of the unit"},
      {"sigma [MPa], tau [MPa]\n1, 2\n3\n", 3, 1, "the first line names 2 columns, here is 1",
       "commas between them"},
      {"sigma [MPa]\n1\n2,5\n", 3, 1, "the first line names one column, here are 2",
       "a decimal comma wants semicolons"},
      {"t [s];sigma [MPa]\n1;2;3\n", 2, 1, "names 2 columns, here are 3", "semicolons between"},
      {"t [s]\tsigma [MPa]\n1\t\t3\n", 2, 1, "names 2 columns, here are 3", "tabs between"},
      {"t [s]\tsigma [MPa]\n1\t3\t\n", 2, 1, "names 2 columns, here are 3", "tabs between"},
      {"t [s]\tsigma [MPa]\n\t3\n", 2, 1, "\"\" is not a number", "without unit"},
      {"t [s], sigma [MPa]\n0, 1\n1,\n", 3, 3, "\"\" is not a number", "without unit"},
      {"t [s], sigma [MPa]\n0, 1\n1, 2\n1, 3\n", 4, 1, "the time 1 does not come after",
       "in the order of time"},
      {"t [s], sigma [MPa]\r\n0, 1\r\n-1, 2 # back\r\n", 3, 1, "the time -1 does not come after",
       "in the order of time"},
      {"sigma;tau\nMPa;mm\n1;2\n", 2, 5, "this column is a stress, but \"[mm]\" is a length",
       header},
      {"sigma;tau\n1;2\n", 1, 1, "the column \"sigma\" has no unit in brackets", header},
      {"sigma\n", 1, 1, "the column \"sigma\" has no unit in brackets", header},
      // 1.234 with a comma, or 1234: only one of the two signs tells it.
      {"t [s];sigma [MPa]\n0;1.5\n1;1,234\n", 3, 3, "\"1,234\" has another decimal sign",
       "between thousands"},
      {"t [s]\tsigma [MPa]\n0,5\t1\n1\t2.5\n", 3, 3, "\"2.5\" has another decimal sign",
       "all with a comma"},
      {"sigma [MPa]\n1\n2\xE9\n", 3, 2, "not UTF-8", "save it with UTF-8"},
      {"sigma [MPa]\n1" + std::string("\0", 1) + "\n", 2, 1, "is not a number", "decimal point"},
      {"sigma [MPa]\n" + std::string(std::size_t{1} << 21U, '1') + "\n", 0, 0,
       "a line is over 1 MB", "a line for each instant"},
  };
  const test::TemporaryFolder folder;
  for (const Row& row : rows) {
    INFO(row.text.substr(0, 100));
    const std::string path = folder.write("history.csv", row.text);
    const Problem problem = problem_of({path, std::nullopt});
    CHECK(problem.file == path);
    CHECK(problem.line == row.line);
    CHECK(problem.column == row.column);
    INFO(problem.message << " / " << problem.hint);
    CHECK(contains(problem.message, row.message));
    CHECK(contains(problem.hint, row.hint));
  }
}

TEST_CASE("far down in a stress history, the line is still right", "[bad_input]") {
  std::string text = "sigma [MPa]\n";
  for (int i = 0; i < 300000; ++i) text += "12.345\n";
  const test::TemporaryFolder folder;
  const Problem problem = problem_of({folder.write("long.csv", text + "x\n"), std::nullopt});
  CHECK(problem.line == 300002);
  CHECK(problem.source_line == "x");
}

TEST_CASE("a stress history that cannot be read is named", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  for (const std::optional<std::string>& unit : {std::optional<std::string>{}, {"MPa"}}) {
    CHECK(problem_of({path + "/none.csv", unit}).message == "there is no such file");
    CHECK(problem_of({path, unit}).message == "this is a folder");
    CHECK(problem_of({folder.write("empty", ""), unit}).message == "the file is empty");
  }
}

TEST_CASE("raw doubles that are none are refused", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string one("\0\0\0\0\0\0\xF0\x3F", 8);
  const std::string nan("\0\0\0\0\0\0\xF8\x7F", 8);
  const auto message = [&](const std::string& bytes, const char* unit) {
    return problem_of({folder.write("raw.bin", bytes), unit}).message;
  };
  CHECK(message(one + "abc", "MPa") == "the file has 11 bytes, no multiple of 8");
  CHECK(contains(message(one + nan, "MPa"), "sample 2 (byte 8) is nan"));
  CHECK(contains(message("sigma [MPa]\n1234", "MPa"), "too large to be meant"));
  CHECK(contains(message(one, "mm"), "\"mm\" is not the unit of a stress"));
  CHECK(contains(message(one, "furlong"), "\"furlong\" is not the unit of a stress"));
}

TEST_CASE("mutated stress histories are read or refused, never crash", "[bad_input]") {
  const std::string texts[] = {
      "t [s], sigma [MPa]\n0, 1.25\n1, -2e3 # x\n2, 17.123456789012345678\n",
      "\xEF\xBB\xBFsigma [MPa];tau [Pa]\r\n1,5;2\r\n-3,25;+4e-1\r\n", "sigma [N/mm^2]\n1\n2\n\n3"};
  const std::string letters = "0123456789+-.,;eE#\r\n\t nai[]\xC3\xA9\xEF";
  const test::TemporaryFolder folder;
  std::mt19937 random(1949);
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  int read = 0, refused = 0;
  for (std::size_t i = 0; i < 3000; ++i) {
    std::string text = texts[i % 3];
    for (std::size_t changes = 1 + pick(3); changes > 0; --changes) {
      const std::size_t at = pick(text.size());
      if (pick(2) == 0) {
        text[at] = letters[pick(letters.size())];
      } else {
        text.erase(at, 1 + pick(3));
      }
    }
    INFO(text);
    std::size_t normal = 0, shear = 0;
    bool finite = true;
    try {
      const StressHistory history = read_stress_history(
          {folder.write("history.csv", text), std::nullopt}, [&](const StressSamples& samples) {
            normal += samples.normal.size();
            shear += samples.shear.size();
            for (const double x : samples.normal) finite = finite && std::isfinite(x);
            for (const double x : samples.shear) finite = finite && std::isfinite(x);
          });
      REQUIRE(finite);
      REQUIRE(history.samples == normal);
      REQUIRE(shear == (history.has_shear ? normal : 0));
      REQUIRE(normal > 0);
      ++read;
    } catch (const InputError& error) {
      REQUIRE(error.problems().size() == 1);
      REQUIRE_FALSE(error.problems().front().message.empty());
      REQUIRE_FALSE(error.problems().front().hint.empty());
      ++refused;
    }
  }
  CHECK(read > 300);
  CHECK(refused > 300);
}

}  // namespace broken_history_test
