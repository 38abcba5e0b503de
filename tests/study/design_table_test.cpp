// Designs of a table: each row one, together with whatever else varies; and what is wrong with
// tables.

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "catch.hpp"

namespace design_table_test {

using namespace boxbeam;

namespace {

/// A study beside a table, in a folder that goes with it.
class StudyBesideTable {
 public:
  StudyBesideTable(const std::string& table, const std::string& variables,
                   const std::string& more = "") {
    folder_ = std::filesystem::temp_directory_path() /
              fmt::format("boxbeam-design-table-{}", static_cast<const void*>(this));
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "designs.csv") << table;
    text_ = "[study]\ntable = \"designs.csv\"\n" + more + variables +
            "[results]\ncolumns = [\"f = t\"]\n";
  }
  ~StudyBesideTable() { std::filesystem::remove_all(folder_); }
  StudyBesideTable(const StudyBesideTable&) = delete;
  StudyBesideTable& operator=(const StudyBesideTable&) = delete;

  Study read() const { return parse_study((folder_ / "study.toml").string(), text_); }

 private:
  std::filesystem::path folder_;
  std::string text_;
};

constexpr const char* t_and_steel =
    "[variables.t]\ncolumn = \"t\"\n[variables.steel]\ncolumn = \"steel\"\n";

}  // namespace

TEST_CASE("each row of a table is a design", "[study]") {
  const StudyBesideTable files(
      "\xEF\xBB\xBF# from the stock\r\nt [mm], steel\r\n8, S235\r\n\r\n10, \"S355\"\r\n12.5, "
      "S355\r\n",
      t_and_steel);
  const Study study = files.read();
  CHECK(study.variables[0].unit == "mm");
  const DesignSpace space(study);
  REQUIRE(space.size() == 3);
  CHECK(space.at(0)[0].number == 8.0);
  CHECK(space.at(0)[1].word == "S235");
  CHECK(space.at(2)[0].number == 12.5);
  CHECK(space.at(2)[1].word == "S355");
}

TEST_CASE("rows are combined with what else varies", "[study]") {
  const StudyBesideTable files("t [mm],w [mm],steel\n8,1,S235\n10,2 cm,S355\n",
                               "[variables.a]\nvalues = [1, 2, 3]\n[variables.t]\ncolumn = \"t\"\n"
                               "[variables.b]\nvalues = [5, 6]\n[variables.w]\ncolumn = \"w\"\n"
                               "[variables.x]\ndistribution = \"uniform\"\nmin = 0\nmax = 1\n"
                               "[variables.sum]\nexpression = \"t + w\"\nunit = \"mm\"\n",
                               "samples = 4\n");
  const Study study = files.read();
  const DesignSpace space(study);
  REQUIRE(space.size() == 3 * 2 * 2 * 4);
  // t and w always of the same row; every combination as often as it should.
  std::map<std::array<double, 3>, int> seen;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const std::vector<Setting> design = space.at(i);
    CHECK(design[3].number == (design[1].number == 8.0 ? 1.0 : 20.0));
    CHECK(design[5].number == design[1].number + design[3].number);
    ++seen[{design[0].number, design[1].number, design[2].number}];
  }
  CHECK(seen.size() == 12);
  for (const auto& [design, count] : seen) CHECK(count == 4);
}

TEST_CASE("a changed table is another study", "[study]") {
  const StudyBesideTable one("t [mm],steel\n8,S235\n", t_and_steel);
  const StudyBesideTable other("t [mm],steel\n9,S235\n", t_and_steel);
  CHECK(one.read().text != other.read().text);
}

TEST_CASE("tables of which no designs can be had say why", "[study]") {
  struct Broken {
    std::string table, variables, says;
  };
  const std::vector<Broken> all = {
      {"", t_and_steel, "no row below"},
      {"t [mm],steel\n", t_and_steel, "no row below"},
      {"t [mm],steel\n8,S235,x\n", t_and_steel, "designs.csv:2"},
      {"t [mm,steel\n8,S235\n", t_and_steel, "no name of a column"},
      {"t [milli],steel\n8,S235\n", t_and_steel, "no name of a column"},
      {"t,t\n8,8\n", t_and_steel, "two columns"},
      {"t [mm],grade\n8,S235\n", t_and_steel, "one of t, grade"},
      {"t [mm],steel\n8,S235\nthick,S355\n", t_and_steel, "line 3: \"thick\" is no number in mm"},
      {"t [mm],steel\n8,S235\n9 s,S355\n", t_and_steel, "line 3: \"9 s\""},
      {"t [mm],steel\n8,S235\n", "[variables.t]\ncolumn = \"t\"\nvalues = [1]\n", "one of"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.table, broken.variables, broken.says);
    try {
      StudyBesideTable(broken.table, broken.variables).read();
      FAIL("it was read");
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains(broken.says));
    }
  }
  CHECK_THROWS_WITH(parse_study("study.toml",
                                "[study]\n[variables.t]\ncolumn = \"t\"\n[results]\n"
                                "columns = [\"f = t\"]\n"),
                    Catch::Contains("no table of designs"));
}

}  // namespace design_table_test
