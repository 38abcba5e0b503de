#include <random>

#include "bad_input/broken_case.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"

namespace broken_links_test {

using namespace bad_input;

namespace {

const std::string& truck() {
  static const std::string text =
      test::read_file(test::project_file("sections/drill-truck/truck.toml"));
  return text;
}

/// The truck with a part of it replaced; the problem stands in the line of `at`, or where the
/// replacement begins.
BrokenCase changed(const std::string& part, const std::string& with, std::vector<std::string> said,
                   const std::string& at = {}) {
  INFO("replaced: " << part);
  REQUIRE(count_of(part, truck()) == 1);
  std::string text = truck();
  text.replace(text.find(part), part.size(), with);
  return {part, text, at.empty() ? line_of(part, truck()) : line_of(at, text), std::move(said)};
}

/// The truck with lines behind it.
BrokenCase with(const std::string& lines, const std::string& at, std::vector<std::string> said) {
  const std::string text = truck() + "\n" + lines;
  return {lines, text, line_of(at, text), std::move(said)};
}

/// The exact form without nodes at joints.
BrokenCase exact_with_equal_parts() {
  std::string text = truck();
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"corrected\"", "\"exact\""},
                                 {"\"nodes at joints\"", "\"equal\""}}) {
    text.replace(text.find(from), from.size(), to);
  }
  return {"exact, equal parts", text, line_of("division = ", text), {"has its nodes at joints"}};
}

}  // namespace

TEST_CASE("links that cannot be are refused", "[bad_input][flexible]") {
  const std::string feed = "length = \"5 m\"";
  const std::string rod = "[links.rod]\nkind = \"axial\"\n";
  const std::string steel = "EA = \"1 MN\"\nmass_per_length = \"1 kg/m\"\n";
  check_refused({
      changed("kind = \"rigid\"", "kind = \"stiff\"", {"\"kind\" cannot be \"stiff\"", "bending"}),
      changed("origin = \"chassis.boom\"", "origin = \"chasis.boom\"",
              {"there is no link \"chasis\"", "did you mean \"chassis\"?"}),
      changed("origin = \"chassis.boom\"", "origin = \"chassis.bom\"",
              {"link \"chassis\" has no point \"bom\"", "did you mean \"boom\"?"}),
      changed("origin = \"chassis.boom\"", "origin = \"chassis\"",
              {"\"chassis\" is not a point of a link", "or [x, y] of the world"}),
      changed("origin = \"chassis.boom\"", "origin = \"telescope.start\"",
              {"is placed by links that are placed by it", "in the world"}),
      changed("origin = \"chassis.boom\"\n", "",
              {"wants one of \"origin\", \"place\" and \"from\""}, "[links.boom]"),
      changed("from = \"chassis.lift\"", "from = \"chassis.lift\"\norigin = [\"0 m\", \"0 m\"]",
              {"wants one of \"origin\", \"place\" and \"from\""}, "[links.lift]"),
      changed("to = \"boom.lift\"", "to = \"chassis.lift\"",
              {"the link has no length", "two places apart"}),
      changed("point = \"head\", at", "point = \"hed\", at",
              {"link \"feed\" has no point \"hed\"", "did you mean \"head\"?"}),
      changed(feed, "length = \"2 m\"",
              {"point \"tilt\" lies off the link, at s = 2.7 m", "0 to 2"}, "tilt = [\"2.7 m\""),
      changed(feed + "\n", "", {"[links.feed] has no \"length\"", "write length"}, "[links.feed]"),
      changed(feed, "length = \"0 m\"", {"\"length\" must be above zero"}),
      changed("section = \"telescope\"", "section = \"telescop\"",
              {"there is no section \"telescop\"", "did you mean \"telescope\"?"}),
      changed("section = \"telescope\"\n", "",
              {"wants one of \"section\", \"sections\", \"segments\" and \"EA\""},
              "[links.telescope]"),
      changed("section = \"telescope\"", "section = \"telescope\"\nEA = \"1 MN\"",
              {"wants one of \"section\", \"sections\", \"segments\" and \"EA\""},
              "[links.telescope]"),
      changed("section = \"telescope\"", "sections = [\"telescope\"]",
              {"a taper goes from one section to another", "or one \"section\""}),
      changed("parts = 8\npoints = { lift", "parts = 8\npoints = { end = [\"4 m\", \"0 m\"], lift",
              {"\"end\" is the end of the link by itself", "another name"}, "points = { end"),
      changed("angle = \"25 deg\"\nparts = 8\npoints", "angle = \"25 deg\"\nparts = 0\npoints",
              {"a link has 1 to 2000 parts", "parts = 16"}, "parts = 0"),
      changed("extra_mass = \"60 kg/m\"", "extra_mass = \"60 kg\"",
              {"a mass per length, but \"60 kg\" is a mass", "60 kg/m"}),
      changed("extra_mass = \"60 kg/m\"", "extra_mas = \"60 kg/m\"",
              {"unknown key \"extra_mas\"", "extra_mass"}),
      changed("mass = \"9000 kg\"\n", "", {"has no \"mass\""}, "[links.chassis]"),
      changed("mass = \"9000 kg\"", "mass = \"-1 kg\"", {"\"mass\" must not be below zero"}),
      changed("[links.lift]", "[links.ground]", {"is the world and no link", "another name"}),
      changed("parts = 8\npoints = { lift",
              "damping = { ratio = 2, at = \"25 Hz\" }\npoints = { lift",
              {"a damping ratio is from 0 to below 1", "ratio = 0.01"}, "damping = "),
      changed("parts = 8\npoints = { lift", "EI = \"1 MN m^2\"\npoints = { lift",
              {"mass and stiffness of the beam come from the sections of [beam]", "remove"},
              "EI = "),
      changed("parts = 8\npoints = { lift", "length = \"4 m\"\npoints = { lift",
              {"the segments of the link are 4.2 m long", "leave it out"},
              "length = \"4 m\"\npoints"),
      changed("link = \"boom\"", "link = \"bom\"",
              {"there is no link \"bom\"", "did you mean \"boom\"?"}),
      changed("[beam]\nlink = \"boom\"\ndensity = \"7850 kg/m^3\"\n\n[[beam.segments]]\nname = "
              "\"boom\"\nlength = \"4.2 m\"\nsection = \"boom\"\n",
              "", {"the case has no \"beam\"", "write [beam]"}, "# A drill truck"),
      with(rod + "origin = [\"0 m\", \"0 m\"]\nlength = \"1 m\"\nmass_per_length = \"1 kg/m\"\n",
           "[links.rod]", {"[links.rod] has no \"EA\"", "write EA = "}),
      with(rod + steel + "from = \"boom.start\"\nto = \"boom.end\"\nlength = \"4 m\"\n",
           "to = \"boom.end\"", {"the link is 4 m long, its ends lie 4.2 m apart", "change its"}),
  });
}

TEST_CASE("elastic joints and loads that cannot be are refused", "[bad_input][flexible]") {
  const std::string w8 = "connect = [\"telescope.end\", \"feed.head\"]\nstiffness = \"300 MN/m\"";
  const std::string ends = "connect = [\"telescope.end\", \"feed.head\"]";
  const auto joint = [](const std::string& connect, const std::string& rest) {
    return "[joints.new]\nkind = \"revolute\"\nconnect = " + connect + "\n" + rest;
  };
  const std::string stiff = "stiffness = \"1 MN/m\"\n";
  check_refused({
      changed(w8, ends + "\nstiffness = \"0 N/m\"",
              {"holds its point in both directions", "kind = \"general\""},
              "stiffness = \"0 N/m\""),
      changed(w8, ends + "\nstiffness = \"-1 N/m\"", {"\"stiffness\" must not be below zero"},
              "stiffness = \"-1 N/m\""),
      changed(w8, ends + "\nstiffness = \"stiff\"", {"does not begin with a number"},
              "stiffness = \"stiff\""),
      changed(w8, ends + "\nstiffness = [\"1 N/m\", \"1 N/m\", \"1 N/m\"]",
              {"one value, or one for each of 2 directions"}, "stiffness = [\"1 N/m\", \"1 N/m\""),
      changed(w8, ends, {"[joints.w8] has no \"stiffness\"", "or \"rigid\""}, "[joints.w8]"),
      changed(ends, "connect = [\"telescope.end\", \"fed.head\"]",
              {"there is no link \"fed\"", "did you mean \"feed\"?"}),
      changed(ends, "connect = [\"telescope.end\", \"feed.hed\"]",
              {"link \"feed\" has no point \"hed\"", "did you mean \"head\"?"}),
      changed(ends, "connect = [\"telescope.end\", \"feed\"]",
              {"\"feed\" is not a point of a link", "link.point"}),
      changed(ends, "connect = [\"telescope.end\"]",
              {"a joint connects two points", "write connect"}),
      changed(ends, "connect = [\"telescope.end\", \"telescope.start\"]",
              {"a joint connects two different links", "write connect"}),
      changed(ends, "connect = [\"telescope.end\", \"feed.start\"]",
              {"the two parts of the joint are 1500 mm apart in the unstressed posture",
               "move a link or a point so that they meet"}),
      changed("connect = [\"boom.end\", \"telescope.sleeve\"]",
              "connect = [\"boom.end\", \"telescope.tilt\"]",
              {"are 250 mm apart in the unstressed posture, across its axis"}),
      changed("normal = \"200 MN/m\"\n\n# The boom's end", "normal = \"0 N/m\"\n\n# The boom's end",
              {"a sliding contact holds across its axis"}, "normal = \"0 N/m\""),
      changed("stiffness = [\"0 N/m\", \"4 MN/m\"]", "stiffness = \"0 N/m\"",
              {"the joint holds nothing", "write for example"}),
      with(joint("[\"boom.end\", \"ground\"]", "at = [\"0 m\", \"0 m\"]\n" + stiff),
           "connect = [\"boom.end\", \"ground\"]", {"mm apart in the unstressed posture"}),
      with(joint("[\"ground\", \"ground\"]", stiff), "connect = [\"ground\", \"ground\"]",
           {"a joint connects two points"}),
      with("[loads.w8]\non = \"feed.end\"\nforce = [\"1 N\", \"0 N\"]\n", "[loads.w8]",
           {"\"w8\" is already the name of a joint", "another name"}),
      changed("on = \"feed.end\"", "on = \"feed.edn\"",
              {"link \"feed\" has no point \"edn\"", "did you mean \"end\"?"}),
      changed("amplitude_moment = \"500 N m\"", "amplitude_moment = \"500 N\"",
              {"a moment, but \"500 N\" is a force"}),
      changed("[motion]\nfrequency = \"25 Hz\"", "",
              {"load \"drill\" has an amplitude, but nothing says how fast", "[motion]"},
              "[loads.drill]"),
      changed("frequency = \"25 Hz\"", "frequency = \"25 Hz\"\nduration = \"1 s\"",
              {"unknown key \"duration\""}, "duration = "),
  });
}

TEST_CASE("what belongs to rigid mechanisms is refused in one of elastic links",
          "[bad_input][flexible]") {
  // One situation only, which a Newton chain would know.
  std::string chain = truck();
  chain.erase(chain.find("[[situations]]"));
  const auto replace = [&](const std::string& a, const std::string& b) {
    chain.replace(chain.find(a), a.size(), b);
  };
  replace("[fatigue]\n", "[fatigue]\ncycles = 5e7\n");
  replace("kind = \"flexible\"", "kind = \"flexible\"\ndynamics = \"newton-chain\"");
  check_refused({
      {"a Newton chain", chain, line_of("[case]", chain), {"a Newton chain", "rigorous"}},
      with("[deflection]\nlimit = \"1 mm\"\n", "[deflection]",
           {"\"deflection\" is known for rigid mechanisms, static and loads cases only",
            "kind = \"flexible\""}),
      with("[loops.a]\nsign = \"+\"\n", "[loops.a]", {"\"loops\" is known for rigid mechanisms"}),
      with("[bodies.a]\nmass = \"1 kg\"\n", "[bodies.a]",
           {"\"bodies\" is known for rigid mechanisms only", "[links.<name>]"}),
      with("[drivers.a]\nkind = \"hold\"\n", "[drivers.a]",
           {"\"drivers\" is known for rigid mechanisms only", "[loads.<name>]"}),
      with("[forces.a]\nkind = \"force\"\n", "[forces.a]",
           {"\"forces\" is known for rigid mechanisms only", "[loads.<name>]"}),
      changed("element = \"corrected\"", "element = \"precise\"",
              {"\"element\" cannot be \"precise\"", "classical"}),
      exact_with_equal_parts(),
      changed("element = \"corrected\"", "tolerance = 1.5",
              {"the tolerance is a fraction", "tolerance = 0.01"}),
      replaced("elements of a rigid case", "[mechanism]",
               "[model]\nelement = \"classical\"\n[mechanism]", {"unknown key \"element\""},
               "element = "),
  });
}

TEST_CASE("a situation cannot move points of the beam's link", "[bad_input][flexible]") {
  std::string text = truck();
  text.erase(text.find("cycles = 5e7\n"), 13);
  const std::string situation = "[[situations]]\nname = \"other\"\ncycles = 1\nset = { ";
  const auto row = [&](const std::string& set, std::vector<std::string> said) {
    const std::string whole = text + situation + set + " }\n";
    return BrokenCase{set, whole, line_of("set = { ", whole), std::move(said)};
  };
  check_refused({
      row("\"links.boom.points.lift\" = [\"1 m\", \"0 m\"]",
          {"a situation cannot change the beam itself", "a case of its own"}),
      row("\"beam.density\" = \"1 kg/m^3\"",
          {"a situation cannot change \"beam.density\"", "links, joints, loads"}),
      row("\"links.bom.parts\" = 3", {"the case has no [links.bom]", "did you mean \"boom\"?"}),
      row("\"links.feed.parts\" = -3", {"a link has 1 to 2000 parts"}),
  });
}

TEST_CASE("mutated cases of elastic links are read or refused, never crash",
          "[bad_input][flexible]") {
  const std::vector<std::string> values{
      "\"0 m\"",    "\"-1 m\"",    "\"1e300 m\"", "nan",  "0",         "-1",    "[]",
      "{}",         "\"\"",        "true",        "[[]]", "\"rigid\"", "\".\"", "\"boom.start\"",
      "\"ground\"", "\"feed.end\""};
  std::mt19937 random(1987);  // the same cases on every machine
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  int read = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text = truck();
    const std::size_t at = pick(text.size());
    const std::size_t line = text.rfind('\n', at) + 1;  // npos + 1 = 0 in the first line
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    const std::size_t value = text.find(" = ", line);
    switch (pick(4)) {
      case 0: text.erase(at, 1 + pick(4)); break;
      case 1: text.erase(line, end - line); break;
      case 2: text.insert(line, text.substr(line, end + 1 - line)); break;
      default:
        if (value < end) text.replace(value + 3, end - value - 3, values[pick(values.size())]);
    }
    INFO("mutation " << i << "\n" << text.substr(line, 80));
    try {
      const boxbeam::Project project = boxbeam::parse_project("mutated.toml", text);
      for (const boxbeam::flexible::Link& link : flexible_of(project).links) {
        CHECK(link.origin.allFinite());
        CHECK((link.stretches.empty() || link.length > 0.0));
      }
      ++read;
    } catch (const boxbeam::InputError& error) {
      REQUIRE_FALSE(error.problems().empty());
      for (const boxbeam::Problem& problem : error.problems()) CHECK(problem.line >= 1);
    }
  }
  CHECK(read > 20);
  CHECK(read < 290);
}

}  // namespace broken_links_test
