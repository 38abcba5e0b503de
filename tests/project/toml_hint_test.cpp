#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "catch.hpp"

namespace toml_hint_test {

using namespace boxbeam;

namespace {

Problem problem_of(const std::string& text) {
  try {
    parse_document("case.toml", text, {});
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong in: " << text);
  return {};
}

}  // namespace

TEST_CASE("what is no TOML is answered by what stands there") {
  struct Row {
    const char* text;
    const char* hint;
  };
  const Row rows[] = {
      {"length = 1.5 m\n", "a value with its unit stands in quotation marks: length = \"1.5 m\""},
      {"a = 9.81 m/s^2  # g\n",
       "a value with its unit stands in quotation marks: a = \"9.81 m/s^2\""},
      {"name = rig\n", "a text stands in quotation marks: name = \"rig\""},
      {"mass == \"1 kg\"\n", "a single = stands between a key and its value: mass = \"1 kg\""},
      {"length = 1,5\n", "the decimal sign is a point: length = 1.5"},
      {"length = 1,5 m\n", "the decimal sign is a point: length = \"1.5 m\""},
      {"x = \xE2\x88\x92"
       "5\n",
       "the minus sign U+2212 stands there; write the minus of the keyboard, -"},
      {"x = \xE2\x80\x93"
       "5\n",
       "the dash U+2013 stands there; write the minus of the keyboard, -"},
      {"length = \xE2\x80\x9C"
       "1.5 m\xE2\x80\x9D\n",
       "write straight quotation marks, \"1.5 m\", not typographic ones"},
      {"\xC2\xA0"
       "a = 1\n",
       "a blank that does not break, as from a word processor, stands there; write a plain one"},
      {"length = \"1.5 m\nx = 1\n",
       "the text is not closed: put its quotation mark at its end, in the same line"},
      {"name = 'rig\n",
       "the text is not closed: put its quotation mark at its end, in the same line"},
      {"name = \"ri\x01g\"\n", "a text holds no control characters; take this one away"},
      {"file = \"C:\\press\\f.csv\"\n",
       "a backslash begins an escape in \"..\"; write '..' with single quotation marks, or two "
       "backslashes"},
      {"[beam\nx = 1\n", "close the header of the table with ]"},
      {"[[situations]\nx = 1\n", "close the header of the table with ]]"},
      {"a = [1, 2\nb = 3\n", "put commas between the items of a list, and ] behind the last"},
      {"a = { b = 1,\n c = 2 }\n",
       "a table in braces stands in one line, commas between its keys and none behind the last; or "
       "give it a header of its own, [name]"},
      {"a = 1\na = 2\n", "a key stands once in its table; take one of the two away"},
      {"[a]\n[a]\n",
       "a table has one header; put what stands below both under the first, or give it another "
       "name"},
      {"a = 1\n[a]\nb = 1\n", "the name is that of a value already; take one of the two away"},
      {"length: \"1.5 m\"\n", "write an equals sign: length = \"1.5 m\""},
      {"length\n", "a line reads key = value, or [table]"},
      {"The rig is 3 m high.\n", "a line reads key = value, or [table]"},
      {"length =\n", "a value is missing: length = \"1.5 m\""},
      {"= 5\n", "a key is missing before the equals sign"},
      {"l\xC3\xA4nge = 5\n",
       "a key has letters without accents, digits, _ and -; others stand in quotation marks: "
       "\"l\xC3\xA4nge\" = ..."},
      {"shear lag = true\n",
       "a key has letters without accents, digits, _ and -; others stand in quotation marks: "
       "\"shear lag\" = ..."},
      {"shear_lag = True\n", "write shear_lag = true"},
      {"shear_lag = no\n", "write shear_lag = false"},
      {"a = .5\n", "a digit stands on both sides of the point: 0.5"},
      {"a = -.5\n", "a digit stands on both sides of the point: -0.5"},
      {"a = 5.\n", "a digit stands on both sides of the point: 5.0"},
      {"a = 007\n", "no zero stands before a number: 7"},
      {"a = 1e400\n", "the number is too large or too small to be meant"},
      {"a = 1 b = 2\n", "one key = value stands in a line; begin a new line"},
      {"a = 1;\n", "nothing stands behind a value; take away the ;"},
      {"a = \"x\" \"y\"\n", "behind the closing quotation mark the line ends"},
      {"// a rig\n", "a comment begins with #"},
      {"{\"case\": 1}\n",
       "a case is TOML: [tables] with lines key = value; boxbeam init planar writes one"},
      {"a = 1\rb = 2\r", "a line ends with LF or CR LF; save the file with such ends"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const Problem problem = problem_of(row.text);
    CHECK(problem.message.starts_with("not valid TOML: "));
    CHECK(problem.hint == row.hint);
  }
}

}  // namespace toml_hint_test
