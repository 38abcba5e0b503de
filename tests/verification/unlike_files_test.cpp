// Files of given loads that do not last equally long, or whose units are not known: what is refused
// and what the case may say of it, against moments by hand.

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace unlike_files_test {

using namespace boxbeam;
using test::contains;

namespace {

/// A cantilever of 4 m with a force at its end, from one file, and one in its middle, from another.
std::string text_of(const std::string& of_a, const std::string& of_b,
                    const std::string& tip = "4 m") {
  return "[case]\nname = \"given\"\nkind = \"loads\"\n"
         "[sections.box]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"300 mm\"\n"
         "flange = \"12 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
         "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n"
         "[files.a]\npath = \"a.csv\"\n" +
         of_a + "[files.b]\npath = \"b.csv\"\n" + of_b + "[loads.tip]\nstation = \"" + tip +
         "\"\nfile = \"a\"\ncolumns = { F_z = \"F\" }\n"
         "[loads.middle]\nstation = \"2 m\"\nfile = \"b\"\ncolumns = { F_z = \"G\" }\n"
         "[balance]\nstation = \"0 m\"\n[material]\nsteel = \"S355\"\n"
         "[strength]\nrequired = 1.0\n";
}

Project given(const test::TemporaryFolder& folder, const std::string& text) {
  return read_project(folder.write("case.toml", text));
}

std::string complaint(const test::TemporaryFolder& folder, const std::string& text) {
  return test::complaints_of([&] { return given(folder, text); });
}

double largest_moment(const Verification& of) {
  double largest = 0.0;
  for (const StationEnvelope& station : of.stations) {
    for (const Extreme* at :
         {&station.of[cut_force::M_y].smallest, &station.of[cut_force::M_y].largest})
      largest = std::max(largest, std::abs(at->value));
  }
  return largest;
}

double moment_of(const test::TemporaryFolder& folder, const std::string& of_a,
                 const std::string& of_b) {
  return largest_moment(verify(given(folder, text_of(of_a, of_b))));
}

}  // namespace

TEST_CASE("what a file has beyond the time of another one is asked for, not dropped",
          "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("a.csv", "t [s],F [kN]\n0,0\n1,-20\n8,-20\n9,-90\n10,0\n");
  folder.write("b.csv", "t [s],G [kN]\n0,0\n1,-1\n5,-1\n");
  const std::string refused = complaint(folder, text_of("", ""));
  CHECK(contains(refused, "b.csv goes from 0 to 5 s, a.csv from 0 to 10 s"));
  CHECK(contains(refused, "beyond = \"held\""));
  // At 9 s: 90 kN on 4 m, with 1 kN on 2 m where the other file's last value is held.
  CHECK(moment_of(folder, "", "beyond = \"held\"\n") == Approx(90e3 * 4.0 + 1e3 * 2.0));
  CHECK(moment_of(folder, "", "beyond = \"zero\"\n") == Approx(90e3 * 4.0));
  // Where the longer one says it, nothing is known of the shorter one.
  CHECK(
      contains(complaint(folder, text_of("beyond = \"held\"\n", "")), "b.csv goes from 0 to 5 s"));
  // The one that begins later.
  folder.write("b.csv", "t [s],G [kN]\n6,-1\n10,-1\n");
  CHECK(contains(complaint(folder, text_of("", "")), "b.csv goes from 6 to 10 s"));
}

TEST_CASE("files of unlike steps are looked at up to the last instant of each", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("a.csv", "t [s],F [kN]\n0,0\n1,-20\n2,-90\n");
  folder.write("b.csv", "t [s],G [kN]\n0,0\n0.8,-1\n1.6,-1\n");
  // The other file's next instant would be at 2.4 s: it is taken to go on as it was.
  CHECK(moment_of(folder, "", "") == Approx(90e3 * 4.0 + 1e3 * 2.0));
}

TEST_CASE("a unit that is not known is not that of the columns without unit", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("a.csv", "t [s],F [tf]\n0,0\n1,-20\n2,0\n");
  folder.write("b.csv", "t [s],G\n0,0\n1,-1\n2,0\n");
  const std::string bare = "force_unit = \"1 kN\"\n";
  const std::string refused = complaint(folder, text_of(bare, bare));
  CHECK(contains(refused, "\"tf\" is not a unit known here"));
  CHECK(contains(refused, "units = { F ="));
  // A ton-force is 9.80665 kN by definition.
  CHECK(moment_of(folder, "units = { F = \"9.80665 kN\" }\n", bare) ==
        Approx(20.0 * 9.80665e3 * 4.0 + 1e3 * 2.0));
  // By its column, which counts more than what holds for all.
  CHECK(moment_of(folder, "units = { F = \"9.80665 kN\" }\n",
                  "force_unit = \"1 N\"\nunits = { G = \"1 kN\" }\n") ==
        Approx(20.0 * 9.80665e3 * 4.0 + 1e3 * 2.0));
  CHECK(contains(complaint(folder, text_of("units = { F = \"9 kN m\" }\n", bare)),
                 "one of \"F\" is a moment"));
  CHECK(contains(complaint(folder, text_of("units = { F = \"tf\" }\n", bare)), "cannot be read"));
  CHECK(contains(complaint(folder, text_of("units = { F = \"0 kN\" }\n", bare)), "above zero"));
}

TEST_CASE("a station off the beam of given loads is the only thing that is said", "[recorded]") {
  const test::TemporaryFolder folder;
  folder.write("a.csv", "t [s],F [kN]\n0,0\n1,-20\n");
  folder.write("b.csv", "t [s],G [kN]\n0,0\n1,-1\n");
  const std::string said = complaint(folder, text_of("", "", "4.001 m"));
  CHECK(contains(said, "behind the end of the beam"));
  CHECK(std::count(said.begin(), said.end(), '\n') == 1);
}

}  // namespace unlike_files_test
