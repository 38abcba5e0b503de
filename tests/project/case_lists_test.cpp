// Lists of a case that remedies add to: their keys, and the boxes that must stay alike.

#include "boxbeam/project/case_lists.hpp"

#include "catch.hpp"

namespace case_lists_test {

using namespace boxbeam;

namespace {

std::string box(const std::string& name, const std::string& height) {
  return "[sections." + name + "]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"" + height +
         "\"\nflange = \"8 mm\"\nweb = \"6 mm\"\n";
}

/// Segments: a, a to b, c; on two supports.
std::string three_segments(const std::string& more) {
  return "[case]\nname = \"lists\"\nkind = \"static\"\n" + box("a", "300 mm") + box("b", "200 mm") +
         box("c", "200 mm") + "[beam]\ndensity = \"7850 kg/m^3\"\n" +
         "[[beam.segments]]\nlength = \"1 m\"\nsection = \"a\"\n"
         "[[beam.segments]]\nlength = \"1 m\"\nfrom = \"a\"\nto = \"b\"\n"
         "[[beam.segments]]\nlength = \"1 m\"\nsection = \"c\"\n" +
         more +
         "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
         "[loads.tip]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-1 kN\"]\n"
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

std::vector<std::string> names_of(const AlikeBoxes& alike) {
  std::vector<std::string> names;
  for (const NamedBox& of : alike.boxes) names.push_back(of.name);
  return names;
}

}  // namespace

TEST_CASE("boxes joined by a taper are alike, a box by itself is not one of them") {
  const Project project = parse_project("lists.toml", three_segments(""));
  const AlikeBoxes tapered = alike_boxes_of(project, 0);
  CHECK(names_of(tapered) == std::vector<std::string>{"a", "b"});
  CHECK(tapered.segments == std::vector<bool>{true, true, false});
  CHECK(tapered.boxes[1].box.height.value() == Approx(0.2));
  CHECK(names_of(alike_boxes_of(project, 1)) == names_of(tapered));
  const AlikeBoxes single = alike_boxes_of(project, 2);
  CHECK(names_of(single) == std::vector<std::string>{"c"});
  CHECK(single.segments == std::vector<bool>{false, false, true});
}

TEST_CASE("what is no box of the case's own has no boxes alike") {
  std::string tube = three_segments("");
  tube.replace(tube.find("[sections.c]"), std::string("[sections.c]\nkind = \"box\"\n").size(),
               "[sections.c]\nkind = \"standard\"\nprofile = \"RHS 200x100x8\"\n[sections.d]\n"
               "kind = \"box\"\n");
  const Project project = parse_project("lists.toml", tube);
  CHECK(alike_boxes_of(project, 2).boxes.empty());
  CHECK(alike_boxes_of(project, 0).boxes.size() == 2);
}

TEST_CASE("tables are added to a list behind those that are there, or make one") {
  const std::string diaphragm = "{station = \"1 m\", thickness = \"8 mm\"}";
  const Project none = parse_project("lists.toml", three_segments(""));
  const std::string key = diaphragms_key_of(none);
  CHECK(key == "beam.diaphragms");
  const auto made = added_to(none, key, {diaphragm, "{station = \"2 m\", thickness = \"8 mm\"}"});
  REQUIRE(made.size() == 1);
  CHECK(parse_project("lists.toml", three_segments(""), made).beam.diaphragms.size() == 2);

  const std::string one =
      three_segments("[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"10 mm\"\n");
  const auto added = added_to(parse_project("lists.toml", one), key, {diaphragm});
  CHECK(added == std::vector<std::string>{"beam.diaphragms.1=" + diaphragm});
  const Project both = parse_project("lists.toml", one, added);
  REQUIRE(both.beam.diaphragms.size() == 2);
  CHECK(both.beam.diaphragms[0].thickness.value() == Approx(0.010));
  CHECK(both.beam.diaphragms[1].s.value() == Approx(1.0));
  CHECK(added_to(both, key, {}).empty());
}

TEST_CASE("a beam in a list has its lists there, where it says them itself") {
  std::string text = three_segments("");
  text.replace(text.find("[beam]"), 6, "[[beam]]");
  CHECK(diaphragms_key_of(parse_project("lists.toml", text)) == "beam.0.diaphragms");
}

}  // namespace case_lists_test
