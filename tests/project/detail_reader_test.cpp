#include "boxbeam/project/detail_reader.hpp"

#include "boxbeam/project/detail_catalogue.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace detail_reader_test {

using namespace boxbeam;
using test::contains;

namespace {

/// A detail read from text, with the problems that were noted.
struct Reading {
  explicit Reading(const std::string& text, const std::vector<Length>& plates = {}) {
    const CaseDocument document = parse_document("case.toml", text, {});
    ProblemList list(document);
    TableReader table(list, document.root, "");
    detail = read_detail(table, plates);
    table.finish();
    try {
      list.raise();
    } catch (const InputError& error) {
      problems = error.problems();
    }
  }

  Detail detail;
  std::vector<Problem> problems;
};

/// Message and hint of the only problem.
std::string complaint(const std::string& text) {
  const Reading reading(text);
  REQUIRE(reading.problems.size() == 1);
  return reading.problems[0].message + " / " + reading.problems[0].hint;
}

}  // namespace

TEST_CASE("a detail by its row", "[detail_reader]") {
  const Reading reading("row = \"8.2/6\"\nname = \"bottom seam\"\n");
  CHECK(reading.problems.empty());
  const Detail& detail = reading.detail;
  CHECK(detail.name == "bottom seam");
  CHECK(detail.row == "8.2/6");
  CHECK(detail.curve.name == "100");
  CHECK(detail.curve.kind == StressKind::direct);
  CHECK(detail.where == StressPlace::gross);
  CHECK_FALSE(detail.compression_reduced);
  CHECK_FALSE(detail.unconfirmed);
  CHECK(detail.candidates.size() == 1);
}

TEST_CASE("a row of several categories takes the weakest until facts decide", "[detail_reader]") {
  const Reading open("row = \"8.2/4\"\n");
  CHECK(open.problems.empty());
  CHECK(open.detail.curve.name == "100");
  CHECK(open.detail.candidates.size() == 2);
  CHECK(open.detail.deciding == std::vector<std::string>{"stop_start"});
  REQUIRE_FALSE(open.detail.raises.empty());
  CHECK(to_text(open.detail.raises[0]) == "stop_start = no: 8.2/4, 112");
  const Reading closed("row = \"8.2/4\"\nfacts = { stop_start = \"no\" }\n");
  CHECK(closed.problems.empty());
  CHECK(closed.detail.curve.name == "112");
  CHECK(closed.detail.deciding.empty());
}

TEST_CASE("a detail by its facts", "[detail_reader]") {
  const Reading reading(
      "facts = { part = \"attachment\", direction = \"transverse\", member = \"diaphragm\", "
      "attachment_length = \"40 mm\" }\n");
  CHECK(reading.problems.empty());
  CHECK(reading.detail.row == "8.4/8");
  CHECK(reading.detail.curve.name == "80");
  CHECK(reading.detail.name == "diaphragm of a box girder");
}

TEST_CASE("a detail by its category", "[detail_reader]") {
  CHECK(Reading("category = 71\n").detail.curve.name == "71");
  CHECK(Reading("category = 71\n").detail.row.empty());
  CHECK(Reading("category = 80\nkind = \"shear\"\n").detail.curve.kind == StressKind::shear);
  CHECK(Reading("category = 36\nraise_asterisk = true\n").detail.curve.name == "36*");
  CHECK(Reading("category = 100\nstress_relieved = true\n").detail.compression_reduced);
}

TEST_CASE("the hole is judged on its net section, compression counts 60 %, the row is recalled",
          "[detail_reader]") {
  const Detail hole = Reading("row = \"8.1/11\"\n").detail;
  CHECK(hole.curve.name == "90");
  CHECK(hole.where == StressPlace::net);
  CHECK(hole.compression_reduced);
  CHECK(hole.unconfirmed);
}

TEST_CASE("root of a fillet weld: 36 strict, 36* raised, 80 in shear", "[detail_reader]") {
  CHECK(Reading("row = \"8.5/3\"\n").detail.curve.name == "36");
  CHECK(Reading("row = \"8.5/3\"\nraise_asterisk = true\n").detail.curve.name == "36*");
  const Detail shear = Reading("row = \"8.5/3\"\nkind = \"shear\"\n").detail;
  CHECK(shear.curve.name == "80");
  CHECK(shear.curve.kind == StressKind::shear);
  CHECK(shear.where == StressPlace::throat);
  CHECK(Reading("row = \"B.1/7\"\n").detail.where == StressPlace::hot_spot);
}

TEST_CASE("a size effect takes the thickness of the facts, else of the plate", "[detail_reader]") {
  const Reading from_facts("row = \"8.3/13\"\nfacts = { thickness = \"60 mm\" }\n",
                           {si<Length>(0.040)});
  CHECK(from_facts.problems.empty());
  CHECK(from_facts.detail.size_factor == Approx(0.8394).margin(5e-5));
  CHECK(from_facts.detail.curve.name == "36");
  const Reading from_plate("row = \"8.3/13\"\n", {si<Length>(0.040)});
  CHECK(from_plate.problems.empty());
  CHECK(from_plate.detail.size_factor == Approx(0.9103).margin(5e-5));
  CHECK(contains(complaint("row = \"8.3/13\"\n"), "depends on \"thickness\""));
  CHECK(contains(complaint("row = \"8.3/17\"\nfacts = { thickness = \"20 mm\" }\n"),
                 "\"eccentricity\""));
}

TEST_CASE("what is wrong is said with what to write", "[detail_reader]") {
  CHECK(contains(complaint("name = \"x\"\n"), "wants a row, facts or a category"));
  CHECK(contains(complaint("row = \"8.2/6\"\ncategory = 100\n"), "not both"));
  CHECK(contains(complaint("row = \"8.2/66\"\n"), "did you mean \"8.2/6\"?"));
  CHECK(contains(complaint("category = 95\n"), "95 is no detail category for direct stress"));
  CHECK(contains(complaint("category = 90\nkind = \"shear\"\n"), "one of 100, 80"));
  CHECK(contains(complaint("row = \"8.2/6\"\nkind = \"shear\"\n"),
                 "row 8.2/6 has no category for shear stress"));
  CHECK(contains(complaint("facts = { part = \"seem\" }\n"), "did you mean \"seam\"?"));
  CHECK(contains(complaint("facts = { part = \"seam\", stopstart = \"no\" }\n"),
                 "did you mean \"stop_start\"?"));
  CHECK(contains(complaint("facts = { part = \"seam\", thickness = 12 }\n"), "a length"));
  CHECK(contains(complaint("facts = { part = \"stud\", weld = \"fillet\", ground = \"yes\", "
                           "direction = \"transverse\", stress = \"weld\" }\n"),
                 "look again at"));
  CHECK(contains(complaint("row = \"8.2/1\"\nfacts = { stop_start = \"yes\" }\n"),
                 "no part of this row"));
  CHECK(contains(complaint("row = \"8.2/6\"\nraise_asterisk = true\n"), "has no asterisk"));
  CHECK(contains(complaint("row = \"8.2/6\"\nsize = 1\n"), "unknown key \"size\""));
}

TEST_CASE("a row for a stress of no section is no detail of a beam", "[detail_reader]") {
  for (const char* text :
       {"row = \"8.10/2\"\n",
        "facts = { part = \"rail web\", weld = \"butt\", stress = \"local\" }\n"}) {
    const std::string said = complaint(text);
    CHECK(contains(said, "no stresses of the beam's sections"));
    CHECK(contains(said, "boxbeam fatigue HISTORY.csv --detail 8.10/2"));
  }
  CHECK(contains(complaint("row = \"8.9/2\"\n"), "--detail 8.9/2"));
  CHECK(contains(complaint("kind = \"shear\"\nrow = \"8.5/10\"\n"), "--shear-detail 8.5/10"));
}

}  // namespace detail_reader_test
