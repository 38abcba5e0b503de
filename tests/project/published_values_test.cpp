// Tables of published values: what is read, and what is said of what cannot be.

#include "boxbeam/project/published_values.hpp"

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace published_values_test {

using namespace boxbeam;
using test::contains;

namespace {

PublishedValues read_text(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_published(folder.write("published.csv", text));
}

std::vector<Problem> problems_in(const std::string& text) {
  try {
    read_text(text);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

const std::string header = "result,published,tolerance,reason,source\n";

}  // namespace

TEST_CASE("a table of published values is read as it is written", "[published]") {
  const PublishedValues values = read_text(
      "\xEF\xBB\xBF# a comment, with a comma\r\n"
      "source, tolerance ,result,published\r\n"
      "\r\n"
      "\"p. 4, \"\"table 3\"\"\",1 %,beam.mass, 4.95 t\r\n"
      "  # another\r\n"
      "\xC3\xB8 \xCE\xA3,0.05 MPa,checks[yield/3.2/A].acting,\"16.3 MPa\"\r\n"
      ",0,motion[0].bodies.4.angle,-4.70e-1\r\n");
  REQUIRE(values.rows.size() == 3);
  const PublishedValue& mass = values.rows[0];
  CHECK(mass.key == "beam.mass");
  CHECK(mass.source == "p. 4, \"table 3\"");
  CHECK(mass.reason.empty());
  CHECK(mass.value.value == Approx(4950.0));
  CHECK(mass.value.exponents == wanted::mass.exponents);
  CHECK(mass.written == "4.95 t");
  CHECK(mass.unit == "t");
  CHECK(mass.scale == Approx(1000.0));
  CHECK(mass.digits == 3);
  CHECK(mass.tolerance.relative);
  CHECK(mass.tolerance.value == Approx(0.01));
  CHECK(mass.line == 4);
  CHECK(mass.key_column == 25);
  const PublishedValue& stress = values.rows[1];
  CHECK(stress.source == "\xC3\xB8 \xCE\xA3");
  CHECK(stress.value.value == Approx(16.3e6));
  CHECK_FALSE(stress.tolerance.relative);
  CHECK(stress.tolerance.value == Approx(0.05e6));
  CHECK(stress.key_column == 14);
  const PublishedValue& angle = values.rows[2];
  CHECK(angle.value.value == Approx(-0.47));
  CHECK(angle.unit.empty());
  CHECK(angle.scale == 1.0);
  CHECK(angle.digits == 3);
  CHECK(angle.tolerance.value == 0.0);
}

TEST_CASE("a result may have been published twice", "[published]") {
  const PublishedValues values =
      read_text(header + "beam.mass,4.9 t,1 %,,here\nbeam.mass,5.0 t,1 %,,there\n");
  CHECK(values.rows.size() == 2);
}

TEST_CASE("what is wrong in a table of published values is named with its place",
          "[published][bad_input]") {
  struct Row {
    std::string text;
    int line, column;
    const char* message;
    const char* hint;
  };
  const Row rows[] = {
      {"", 0, 0, "the file is empty", "result,published,tolerance"},
      {"# nothing\n\n", 0, 0, "the file is empty", "result,published,tolerance"},
      {header, 0, 0, "the table has no rows", "result,published,tolerance"},
      {"result,publishd,tolerance\n", 1, 8, "no column \"publishd\"", "did you mean published?"},
      {"result,published,note\n", 1, 18, "no column \"note\"", "the first line reads"},
      {"result,published,result,tolerance\n", 1, 18, "stands twice", "the first line reads"},
      {"result,published\n", 1, 1, "the column tolerance is missing", "the first line reads"},
      {"published,tolerance\n", 1, 1, "the column result is missing", "the first line reads"},
      {header + "beam.mass,4,95 t,1 %,,\n", 2, 23, "5 columns, here are 6", "a point"},
      {header + "beam.mass\n", 2, 1, "5 columns, here is 1", "quotation marks"},
      {header + "beam.mass,\"4,95 t\",1 %,,\n", 2, 11, "a point, not a comma", "16.3 MPa"},
      {header + "beam.mass,,1 %,,\n", 2, 11, "a number is missing", "16.3 MPa"},
      {header + "beam.mass,heavy,1 %,,\n", 2, 11, "does not begin with a number", "16.3 MPa"},
      {header + "beam.mass,5 tons,1 %,,\n", 2, 11, "\"tons\" is not a unit", "16.3 MPa"},
      {header + "beam.mass,nan,1 %,,\n", 2, 11, "must be finite", "16.3 MPa"},
      {header + ",5 t,1 %,,\n", 2, 1, "the result is missing", "safety_factor"},
      {header + "beam.mass,5 t,,,\n", 2, 15, "a number is missing", "1 % or 0.05 mm"},
      {header + "beam.mass,5 t,few,,\n", 2, 15, "does not begin with a number", "1 % or 0.05 mm"},
      {header + "beam.mass,5 t,-1 %,,\n", 2, 15, "is not negative", "its size"},
      {header + "beam.mass,5 t,1 kg %,,\n", 2, 15, "neither a part nor a size", "1 %"},
      {header + "beam.mass,0 t,1 %,,\n", 2, 15, "a part of zero is zero", "absolute"},
      {header + "beam.mass,5 t,1 m,,\n", 2, 15, "is a length, the published value a mass", "1 %"},
      {header + "beam.mass,5 t,0.1,,\n", 2, 15, "is a number without unit", "1 %"},
      {header + "beam.mass,5 t,1 %,\"why,\n", 2, 19, "not closed", "twice"},
      {header + "beam.mass,5 t,1 %,\"why\" so,\n", 2, 19, "a comma is wanted", "quotation mark"},
      {header + "beam.mass,5 t,1 %,,\nbeam.mass,6 t,1 %,,\n", 3, 1, "a second time", "leave out"},
      {header + "\xC3\xB8,\"x\",1 %,,\n", 2, 3, "does not begin with a number", "16.3 MPa"},
      {header + "\xFF,5 t,1 %,,\n", 2, 1, "not UTF-8", "UTF-8"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const std::vector<Problem> problems = problems_in(row.text);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].line == row.line);
    CHECK(problems[0].column == row.column);
    INFO(problems[0].message);
    CHECK(contains(problems[0].message, row.message));
    INFO(problems[0].hint);
    CHECK(contains(problems[0].hint, row.hint));
  }
}

TEST_CASE("all that is wrong in a table of published values is said at once",
          "[published][bad_input]") {
  const std::vector<Problem> problems =
      problems_in(header + "beam.mass,5 tons,few,,\nbeam.length,6.2 m,1 %,,\n,7,1 %,,\n");
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].line == 2);
  CHECK(problems[1].line == 2);
  CHECK(problems[2].line == 4);
}

TEST_CASE("a table of published values that is not there is said", "[published][bad_input]") {
  CHECK_THROWS_AS(read_published("/nonexistent/published.csv"), InputError);
  CHECK_THROWS_AS(read_published("/tmp"), InputError);
}

}  // namespace published_values_test
