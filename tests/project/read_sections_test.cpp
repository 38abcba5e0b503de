#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/named_section.hpp"
#include "boxbeam/project/standard_profiles.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace read_sections_test {

using namespace boxbeam;

namespace {

Section read(const std::string& lines) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("s.toml", "[sections.X]\n" + lines);
  return sections_from_words({file + ":X"}).at(0).section;
}

/// What the reader says about a broken section; it must say one thing.
std::string refused(const std::string& lines) {
  try {
    read(lines);
  } catch (const InputError& error) {
    CHECK(error.problems().size() == 1);
    CHECK_FALSE(error.problems()[0].hint.empty());
    CHECK(error.problems()[0].line > 0);
    return error.what();
  }
  return "";
}

Length mm(double x) { return si<Length>(1e-3 * x); }

const std::string size = "kind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\n";

}  // namespace

TEST_CASE("box: plates alike or each of its own, stiffeners, throat") {
  CHECK(std::get<Box>(read(size + "flange = \"20 mm\"\nweb = \"10 mm\"\n").outer) ==
        symmetric_box(mm(400), mm(600), mm(20), mm(10)));
  const Box box = std::get<Box>(
      read(size +
           "top_flange = \"20 mm\"\nbottom_flange = \"25 mm\"\nleft_web = \"10 mm\"\n"
           "right_web = \"12 mm\"\nseam_throat = \"8 mm\"\n"
           "[[sections.X.stiffeners]]\non = \"right web\"\nat = \"-50 mm\"\ndepth = \"80 mm\"\n"
           "thickness = \"9 mm\"\n")
          .outer);
  CHECK(box == Box{mm(400),
                   mm(600),
                   mm(20),
                   mm(25),
                   mm(10),
                   mm(12),
                   {{BoxPlate::right_web, mm(-50), mm(80), mm(9)}},
                   mm(8)});
}

TEST_CASE("tubes, plate, polygon, path and standard profile are read") {
  CHECK(std::get<RectangularTube>(
            read("kind = \"rectangular tube\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
                 "wall = \"8 mm\"\nouter_radius = \"12 mm\"\ninner_radius = \"8 mm\"\n")
                .outer) == RectangularTube{mm(100), mm(200), mm(8), mm(12), mm(8)});
  CHECK(std::get<Plate>(read("kind = \"plate\"\nwidth = \"20 mm\"\nheight = \"100 mm\"\n").outer) ==
        Plate{mm(20), mm(100)});
  const Section polygon = read(
      "kind = \"polygon\"\n"
      "outer = [[\"0 mm\", \"0 mm\"], [\"60 mm\", \"0 mm\"], [\"0 mm\", \"60 mm\"]]\n"
      "holes = [[[\"10 mm\", \"10 mm\"], [\"20 mm\", \"10 mm\"], [\"10 mm\", \"20 mm\"]]]\n");
  CHECK(properties_of(polygon).area.value() * 1e6 == Approx(1800 - 50).epsilon(1e-12));
  const Section path = read(
      "kind = \"thin-walled\"\n[sections.X.nodes]\na = [\"0 mm\", \"0 mm\"]\n"
      "b = [\"100 mm\", \"0 mm\"]\nc = [\"100 mm\", \"80 mm\"]\n"
      "[[sections.X.walls]]\nfrom = \"a\"\nto = \"b\"\nthickness = \"5 mm\"\n"
      "[[sections.X.walls]]\nfrom = \"b\"\nto = \"c\"\nthickness = \"4 mm\"\n"
      "trim_from = \"2.5 mm\"\n");
  CHECK(properties_of(path).area.value() * 1e6 == Approx(500 + 77.5 * 4).epsilon(1e-12));
  CHECK(read("kind = \"standard\"\nprofile = \"RHS 200x100x8\"\n").outer ==
        Profile{RectangularTube{mm(100), mm(200), mm(8), 1.5 * mm(8), 1.0 * mm(8)}});
}

TEST_CASE("broken sections are refused with one error each") {
  const auto says = [](const std::string& lines, const std::string& wanted) {
    INFO(lines);
    const std::string said = refused(lines);
    INFO(said);
    CHECK(said.find(wanted) != std::string::npos);
  };
  says(
      size +
          "flange = \"20 mm\"\ntop_flange = \"20 mm\"\nbottom_flange = \"20 mm\"\nweb = \"9 mm\"\n",
      "either \"flange\" or \"top_flange\" and \"bottom_flange\"");
  says(size + "web = \"9 mm\"\n", "either \"flange\" or");
  says(size + "flange = \"20 mm\"\nleft_web = \"9 mm\"\n", "right_web");
  says(size +
           "flange = \"20 mm\"\nweb = \"9 mm\"\n[[sections.X.stiffeners]]\non = \"floor\"\n"
           "at = \"0 mm\"\ndepth = \"80 mm\"\nthickness = \"9 mm\"\n",
       "floor");
  says(size +
           "flange = \"20 mm\"\nweb = \"9 mm\"\n[[sections.X.stiffeners]]\non = \"left web\"\n"
           "at = \"290 mm\"\ndepth = \"80 mm\"\nthickness = \"9 mm\"\n",
       "stiffener 1 does not fit inside the box");
  says(
      "kind = \"polygon\"\nouter = [[\"0 mm\", \"0 mm\"], [\"60 mm\", \"60 mm\"], [\"60 mm\", "
      "\"0 mm\"], [\"0 mm\", \"60 mm\"]]\n",
      "cross each other");
  says("kind = \"polygon\"\nouter = [[\"0 mm\"], [\"60 mm\", \"60 mm\"], [\"60 mm\", \"0 mm\"]]\n",
       "wants two values");
  says(
      "kind = \"thin-walled\"\n[sections.X.nodes]\na = [\"0 mm\", \"0 mm\"]\n"
      "b = [\"100 mm\", \"0 mm\"]\n"
      "[[sections.X.walls]]\nfrom = \"a\"\nto = \"bb\"\nthickness = \"5 mm\"\n",
      "there is no node \"bb\"");
  says("kind = \"standard\"\nprofile = \"RHS 200x100x9\"\n",
       "there is no standard profile \"RHS 200x100x9\"");
}

TEST_CASE("every profile of the catalogue can be, and EN 10210's heaviest square is among them") {
  for (const char* name : {"RHS 50x30x5", "RHS 200x100x16", "RHS 500x300x20", "SHS 40x5",
                           "SHS 400x20", "CHS 21.3x3.2", "CHS 508x16"}) {
    const auto profile = find_standard_profile(name);
    INFO(name);
    REQUIRE(profile);
    CHECK(profile->unconfirmed);
    CHECK(properties_of({profile->profile, {}}).area.value() > 0.0);
  }
}

}  // namespace read_sections_test
