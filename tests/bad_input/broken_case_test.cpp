#include "bad_input/broken_case.hpp"

#include <cmath>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "catch.hpp"
#include "project/small_case.hpp"

namespace broken_case_test {

using namespace bad_input;

TEST_CASE("a file that is no case is refused", "[bad_input]") {
  const std::string dots = "a" + [] {
    std::string more;
    for (int i = 0; i < 100000; ++i) more += ".a";
    return more;
  }();
  const std::string nested = std::string(100000, '[') + std::string(100000, ']');
  check_refused({
      {"empty", "", 1, {"the case is empty", "boxbeam init planar my.toml"}},
      {"comments only", "# nothing\n\n", 1, {"the case is empty"}},
      {"not UTF-8", "[case]\nname = \"sl\xE4t\"\n", 2, {"not UTF-8", "save it with UTF-8"}},
      {"overlong UTF-8", "# \xC0\xAF\n", 1, {"not UTF-8"}},
      {"cut in a UTF-8 character",
       rig() + "# \xE2\x82",
       line_of("# \xE2\x82", rig() + "# \xE2\x82"),
       {"not UTF-8"}},
      {"a zero byte", std::string("[case]\nname = \"a\0b\"\n", 20), 2, {"not valid TOML"}},
      {"100 000 dots", "[case]\n" + dots + " = 1\n", 2, {"a key of more than 32 parts"}},
      {"100 000 dots in a table's name", "\n[" + dots + "]\n", 2, {"a key of more than 32 parts"}},
      {"100 000 quoted parts", "\"a\"." + dots + " = 1\n", 1, {"a key of more than 32 parts"}},
      {"100 000 brackets", "a = " + nested + "\n", 1, {"not valid TOML"}},
      {"not TOML", "\n\nThe rig is 3 m high.\n", 3, {"not valid TOML"}},
      {"JSON", "{\"case\": 1}\n", 1, {"not valid TOML"}},
  });
}

TEST_CASE("TOML that cannot be read is named with its line", "[bad_input]") {
  check_refused({
      replaced(
          "unit without quotation marks", "mass = \"119 kg\"", "mass = 119 kg",
          {"not valid TOML", "a value with its unit stands in quotation marks: mass = \"119 kg\""}),
      replaced("text without its end", "name = \"sledge-rig\"", "name = \"sledge-rig",
               {"not valid TOML"}),
      replaced("table without its end", "[drivers.exciter]", "[drivers.exciter",
               {"not valid TOML"}),
      replaced("duplicate key", "mass = \"119 kg\"", "mass = \"119 kg\"\nmass = \"120 kg\"",
               {"not valid TOML", "mass"}, "mass = \"120 kg\""),
      appended("duplicate table", "\n[material]  # again\nsteel = \"S235\"\n",
               "[material]  # again", {"not valid TOML", "material"}),
      replaced("bare decimal comma", "cycles = 1e8", "cycles = 1,5",
               {"not valid TOML", "the decimal sign is a point: cycles = 1.5"}),
      replaced("key without value", "cycles = 1e8", "cycles =", {"not valid TOML"}),
  });
}

TEST_CASE("a mechanism that cannot move as wanted is refused", "[bad_input]") {
  const std::string exciter =
      "[drivers.exciter]\nkind = \"harmonic\"\npoint = \"blade.A\"\ncoordinate = \"x\"\n"
      "mean = \"0.5 m\"\namplitude = \"0.25 m\"\nfrequency = \"0.7 Hz\"\n";
  check_refused({
      replaced("joint missing",
               "[joints.C]\nkind = \"pin\"\nconnect = [\"beam.C\", \"lower_rod.C\"]\n", "",
               {"15 coordinates, joints and drivers give 13 equations", "not determined",
                "2 more equations are wanted"},
               "[joints.O]"),
      replaced("driver without amplitude", "amplitude = \"0.25 m\"\n", "",
               {"[drivers.exciter] has no \"amplitude\"", "write amplitude = \"0.25 m\""},
               "[drivers.exciter]"),
      replaced("driver that stands still", "amplitude = \"0.25 m\"", "amplitude = \"0 m\"",
               {"the driver does not move", "an amplitude other than zero"}),
      replaced("no driver", exciter, "[drivers]  # none\n",
               {"nothing drives the mechanism", "[drivers.<name>]"}, "[drivers]  # none"),
      replaced("pin of one body", "connect = [\"beam.B\", \"upper_rod.B\"]",
               "connect = [\"beam.B\", \"beam.C\"]",
               {"a pin connects two different bodies", "write connect = "}),
      appended("coupling of one body",
               "\n[joints.gear]\nkind = \"angle coupling\"\npoints = [\"beam.O\", \"beam.B\"]\n",
               "points = [\"beam.O\", \"beam.B\"]",
               {"a coupling connects two different bodies", "write points = "}),
      replaced(
          "ground as a body", "[bodies.blade]",
          "[bodies.ground]\nmass = \"1 kg\"\npoints = {}\nsketch = { at = [\"0 m\", \"0 m\"] }\n"
          "[bodies.blade]",
          {"\"ground\" is the world and no body", "another name"}, "[bodies.ground]"),
      replaced("loop without measure", "turn = [\"beam.O\", \"blade.A\", \"beam.B\"]\n", "",
               {"loop \"upper\" wants either \"turn\" or \"along\"", "[three points]"},
               "[loops.upper]"),
      replaced("loop of two points", "turn = [\"beam.O\", \"blade.A\", \"beam.B\"]",
               "turn = [\"beam.O\", \"blade.A\"]", {"\"turn\" wants 3 points", "beam.B"}),
      replaced("part of the chain reversed", "{ from = \"3.2 m\", to = \"6.2 m\" }",
               "{ from = \"6.2 m\", to = \"3.2 m\" }",
               {"the part ends before it begins", "exchange"}),
  });
}

TEST_CASE("a missing table is named, and nothing that follows from it", "[bad_input]") {
  // Without [fatigue] the strength alone is checked.
  const std::vector<std::string> tables{"case", "mechanism", "material", "strength", "beam"};
  std::vector<BrokenCase> cases;
  for (const std::string& table : tables) {
    std::string text = rig();
    const std::size_t from = text.find("[" + table + "]");
    REQUIRE(from != std::string::npos);
    // A table ends where the next one begins that is not part of it.
    std::size_t to = text.find("\n[", from);
    while (text.compare(to + 2, table.size() + 2, "[" + table + ".") == 0) {
      to = text.find("\n[", to + 1);
    }
    text.erase(from, to + 1 - from);
    cases.push_back(
        {"without " + table,
         text,
         1,
         {"the case has no \"" + table + "\"", "write [" + table + "] and its keys below"}});
  }
  check_refused(cases);
}

TEST_CASE("all errors of a file are reported at once, in its order", "[bad_input]") {
  const test::TemporaryFolder folder;
  const BrokenCase first = replaced("", "mass = \"119 kg\"", "mass = 119", {});
  const BrokenCase last = replaced("", "steel = \"S355\"", "steel = \"S356\"", {});
  std::string text = first.text;
  text.replace(text.find("steel = \"S355\""), 14, "steel = \"S356\"");
  const std::string file = folder.write("two.toml", text);
  const std::string one = file + ":" + std::to_string(first.line) + ":8: error: ";
  const std::string two = file + ":" + std::to_string(last.line) + ":9: error: ";
  const std::string err = refused(file, {one, two, "2 errors; nothing was written"});
  CHECK(err.find(one) < err.find(two));
  // The line as written, and a caret under the value.
  CHECK(err.find("    mass = 119\n           ^\n") != std::string::npos);
}

TEST_CASE("control characters of a file do not reach the terminal", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string err = refused(folder.write("escape.toml", "\"\\u001b[2J\" = 1\n" + rig()),
                                  {"unknown key \"\\x1B[2J\""});
  CHECK(err.find('\x1b') == std::string::npos);
}

TEST_CASE("what is no readable file is refused", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  refused(path, {path + ": error: this is a folder", "give a case file in it"});
  refused(path + "/none.toml",
          {path + "/none.toml: error: there is no such file", "give the path"});
  refused("", {"there is no such file"});
  const std::string large = folder.write("large.toml", rig() + "#" + std::string(8u << 20, ' '));
  refused(large, {large + ": error: the file is over 8 MB", "a few kB of TOML"});
  refused("/dev/zero", {"the file is over 8 MB"});
}

namespace {

/// Whether nothing in a project is NaN, infinite or of a sign that cannot be.
bool makes_sense(const boxbeam::Project& project) {
  using namespace boxbeam;
  const auto some = [](double x) { return std::isfinite(x) && x > 0.0; };
  bool good = some(planar::time_span_of(planar_of(project)).length) &&
              some(project.situations.front().cycles) &&
              some(mass_properties_of(project.beam).inertia.value());
  for (const Body& body : planar_of(project).bodies) {
    good =
        good && std::isfinite(body.mass + body.inertia) && body.mass >= 0.0 && body.inertia >= 0.0;
    for (const BodyPoint& point : body.points) good = good && point.p.allFinite();
  }
  for (const Segment& segment : project.beam.segments) {
    good =
        good && some(segment.length.value()) && !defect_of(segment.from) && !defect_of(segment.to);
  }
  return good && sketch_of(planar_of(project)).allFinite() && !project.name.empty();
}

/// A value out of `values` for the value of one line, a line taken away or twice, or other bytes.
std::string mutated(const std::string& text, std::mt19937& random) {
  static const std::vector<std::string> values{
      "\"0 m\"", "\"-1 m\"",   "\"1e300 m\"", "\"1e-300 kg\"", "nan",        "inf",        "0",
      "-1",      "[]",         "{}",          "\"\"",          "true",       "[[]]",       "[{}]",
      "1e300",   "1979-05-27", "\"ground\"",  "\"beam\"",      "\"beam.O\"", "\"nested\"", "\"A1\"",
      "\"\"\"",  "\"-\"",      "\"1 rad\""};
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  std::string result = text;
  const std::size_t at = pick(result.size());
  const std::size_t line = result.rfind('\n', at) + 1;  // npos + 1 = 0 in the first line
  const std::size_t end = std::min(result.find('\n', at), result.size() - 1);
  const std::size_t value = result.find(" = ", line);
  switch (pick(5)) {
    case 0: result.erase(at, 1 + pick(4)); break;
    case 1: result[at] = static_cast<char>(pick(256)); break;
    case 2: result.erase(line, end - line); break;
    case 3: result.insert(line, result.substr(line, end + 1 - line)); break;
    default:
      if (value < end) result.replace(value + 3, end - value - 3, values[pick(values.size())]);
  }
  return result;
}

}  // namespace

TEST_CASE("mutated cases are read or refused, never crash", "[bad_input]") {
  const std::string cases[] = {
      rig(), test::read_file(test::project_file("sections/sledge-rig/published.toml")),
      small_case::bodies + small_case::all_kinds};
  std::mt19937 random(1908);  // the same cases on every machine
  int read = 0;
  for (std::size_t i = 0; i < 450; ++i) {
    const std::string text = mutated(cases[i % 3], random);
    INFO("mutation " << i);
    try {
      const boxbeam::Project project = boxbeam::parse_project("mutated.toml", text);
      CHECK(makes_sense(project));
      ++read;
    } catch (const boxbeam::InputError& error) {
      REQUIRE_FALSE(error.problems().empty());
      for (const boxbeam::Problem& problem : error.problems()) {
        CHECK(problem.line >= 1);
        CHECK_FALSE(problem.message.empty());
      }
    }
  }
  CHECK(read > 20);  // comments and texts may change freely
  CHECK(read < 420);
}

}  // namespace broken_case_test
