#include <cmath>

#include "project/small_case.hpp"
#include "support/program.hpp"

namespace time_tables_test {

using namespace small_case;
using namespace boxbeam;

namespace {

const std::string file_driver =
    "[drivers.X]\nkind = \"table\"\npoint = \"arm.B\"\ncoordinate = \"x\"\nfile = \"stroke.csv\"\n";

std::string mechanism(const std::string& more = {}) {
  return pivot + file_driver + more + for_a_second;
}

/// A case in a folder beside its table.
struct WithTable {
  explicit WithTable(const std::string& csv)
      : table(folder.write("stroke.csv", csv)), path((folder.path() / "small.toml").string()) {}

  Project read(const std::string& more = {}) const {
    return small_case::read(mechanism(more), path);
  }

  TableCurve curve(const std::string& more = {}) const {
    const Project project = read(more);
    const auto& driven = std::get<planar::Driven>(planar_of(project).joints.back().kind);
    REQUIRE(std::holds_alternative<TableDriver>(driven.driver));
    return std::get<TableDriver>(driven.driver).curve;
  }

  test::TemporaryFolder folder;
  std::string table;
  std::string path;
};

}  // namespace

TEST_CASE("a table of a stroke over time, from a file beside the case") {
  const WithTable written(
      "# measured on the rig\n\ntime [ms], stroke [mm]\n0, 0\n 500 ,\t+25  # middle\n"
      "1e3, -12.5\n\n1.5e3, 0.0\n");
  // Four points hold too little of their curve: it leaves them by more than 2 %.
  const std::string accepted = "overshoot = \"accept\"\n";
  const TableCurve spline = written.curve(accepted);
  CHECK(spline.interpolation() == Interpolation::cubic);
  CHECK(spline.beyond() == Beyond::nothing);
  REQUIRE(spline.points().size() == 4);
  const double times[] = {0.0, 0.5, 1.0, 1.5};
  const double values[] = {0.0, 0.025, -0.0125, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(spline.points()[i] == Approx(times[i]).epsilon(1e-14));
    CHECK(spline.at(times[i]).value == Approx(values[i]).margin(1e-15));
  }
  CHECK(written.curve(accepted + "periodic = true\n").beyond() == Beyond::periodic);
  CHECK(written.curve(accepted + "beyond = \"periodic\"\n").beyond() == Beyond::periodic);
  CHECK(written.curve(accepted + "beyond = \"hold\"\n").beyond() == Beyond::hold);
}

TEST_CASE("lines of a table may end with CR LF, its text may begin with a byte order mark") {
  const WithTable written("\xEF\xBB\xBFtime [s],stroke [m]\r\n0,1\r\n1,2\r\n2,1\r\n");
  CHECK(written.curve().points().size() == 3);
}

TEST_CASE("a table is read as spreadsheets of other countries write it") {
  // One table, as three numbers that hold no rounding: 0 mm, 2.5 mm, -1.25 mm at 0, 0.5 and 1 s.
  for (const char* text : {
           "time [s],stroke [mm]\n0,0\n0.5,2.5\n1,-1.25\n",
           "time [s];stroke [mm]\n0;0\n0,5;2,5\n1;-1,25\n",
           "time [s];stroke [mm]\n0;0\n0.5;2.5\n1;-1.25\n",
           "time [s]\tstroke [mm]\n0\t0\n0.5\t2.5\n1\t-1.25\n",
           "time [s]\tstroke [mm]\n0\t0\n0,5\t2,5\n1\t-1,25\n",
           "\"time, of the clock [s]\",\"stroke #1 [mm]\"\n0,0\n0.5,2.5\n1,-1.25\n",
           "\"time [s]\";\"stroke [mm]\"\n\"0\";\"0\"\n\"0,5\";\"2,5\"\n\"1\";\"-1,25\"\n",
           "time,stroke\ns,mm\n0,0\n0.5,2.5\n1,-1.25\n",
           "# rig\n\"time\";\"stroke\"\n[s];[mm]\n\n0;0\n0,5;2,5\n1;-1,25\n",
           "time\tstroke\n(s)\t(mm)\n0\t0\n0.5\t2.5\n1\t-1.25\n",
           "time [s];stroke [mm]\r0;0\r0,5;2,5\r1;-1,25\r",
           "time [s],stroke [mm]\r\n0,0\r\n0.5,2.5\r\n1,-1.25",
       }) {
    INFO(text);
    const TableCurve spline = WithTable(text).curve("overshoot = \"accept\"\n");
    REQUIRE(spline.points().size() == 3);
    CHECK(spline.at(0.0).value == 0.0);
    CHECK(spline.points()[1] == 0.5);
    CHECK(spline.at(0.5).value == Approx(0.0025).epsilon(1e-15));
    CHECK(spline.points()[2] == 1.0);
    CHECK(spline.at(1.0).value == Approx(-0.00125).epsilon(1e-15));
  }
}

TEST_CASE("a table that is to repeat is closed, but for the rounding of who wrote it") {
  const WithTable rounded("t [s], x [m]\n0, 0.1\n1, 2\n2, 0.10000000000000009\n");
  const TableCurve curve = rounded.curve("periodic = true\n");
  CHECK(curve.at(0.0).value == curve.at(2.0).value);
  const WithTable open("t [s], x [mm]\n0, 0\n1, 2\n2, 1\n# end\n");
  CHECK_NOTHROW(open.read());
  const Problem problem = problem_of(mechanism("periodic = true\n"), open.path);
  CHECK(problem.file == open.table);
  CHECK(problem.line == 4);
  CHECK(contains(problem.message, "its last value misses its first"));
  CHECK(contains(problem.hint, "beyond = \"hold\""));
}

TEST_CASE("a periodic table needs no duration, its period is that of the motion") {
  const WithTable written("t [s], angle [deg]\n0, 0\n1, 2\n2, 0\n");
  const std::string turned =
      pivot +
      "[joints.rod]\nkind = \"rigid\"\nconnect = [\"rod.P\", \"arm.B\"]\n"
      "[joints.wheel]\nkind = \"rigid\"\nconnect = [\"wheel.C\", \"arm.B\"]\n"
      "[drivers.X]\nkind = \"table\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\n"
      "file = \"stroke.csv\"\nperiodic = true\n";
  CHECK_NOTHROW(small_case::read(turned, written.path));
}

TEST_CASE("what is wrong in a table is named with its file and line") {
  struct Row {
    const char* text;
    int line;
    int column;
    const char* message;
    const char* hint;
  };
  const std::string example = "time [s], stroke [m]; below it numbers";
  const Row rows[] = {
      {"", 1, 1, "the table has 0 rows, at least 3 are wanted", example.c_str()},
      {"time [s], stroke [m]\n0, 1\n1, 2\n", 3, 1, "the table has 2 rows", example.c_str()},
      {"# x\n0, 1\n1, 2\n2, 3\n", 2, 1, "the column \"0\" has no unit", example.c_str()},
      {"time, stroke\n", 1, 1, "the column \"time\" has no unit", example.c_str()},
      {"time [s], stroke [kg]\n", 1, 11, "this column is a length, but \"[kg]\" is a mass",
       example.c_str()},
      {"time [mm], stroke [mm]\n", 1, 1, "this column is a time, but \"[mm]\" is a length",
       example.c_str()},
      {"time [s], stroke [furlong]\n", 1, 11, "\"furlong\" is not a unit known here",
       example.c_str()},
      {"time [s], stroke []\n", 1, 11, "a number without unit", example.c_str()},
      {"time [s] stroke [mm]\n", 1, 1, "a table has two columns, time and stroke", example.c_str()},
      {"time [s], x [m]\n0, 1, 2\n", 2, 1, "two columns with commas between them, here are 3",
       "a decimal comma wants semicolons or tabs"},
      {"time [s], x [m]\n0, 1\n1; 2\n", 3, 1, "two columns with commas between them, here is 1",
       "two numbers"},
      {"time [s]; x [m]\n0, 1\n", 2, 1, "two columns with semicolons between them, here is 1",
       "two numbers"},
      {"time [s]\tx [m]\n0 1\n", 2, 1, "two columns with tabs between them, here is 1",
       "two numbers"},
      // 1.234 with a comma, or 1234: only one of the two signs tells it.
      {"time [s]; x [m]\n0.5; 1\n1; 1,234\n", 3, 4, "another decimal sign", "between thousands"},
      {"time [s]\tx [m]\n0,5\t1\n1\t1.234\n", 3, 3, "another decimal sign", "all with a comma"},
      {"time [s]; x [m]\n0; 1.234.567\n", 2, 4, "\"1.234.567\" is not a number", "or comma"},
      {"time [s], x [m]\n0, \"1,5\"\n", 2, 4, "\"1,5\" is not a number", "decimal comma wants"},
      {"time;stroke\ns;kg\n0;1\n", 2, 3, "this column is a length, but \"[kg]\" is a mass",
       example.c_str()},
      {"time;stroke\n[s];[furlong]\n", 2, 5, "\"furlong\" is not a unit known here",
       example.c_str()},
      {"time;stroke\ns;\n0;1\n", 1, 1, "the column \"time\" has no unit", example.c_str()},
      {"time;stroke\ns;mm;mm\n", 1, 1, "the column \"time\" has no unit", example.c_str()},
      {"\"time [s], stroke [mm]\n0, 1\n", 1, 1, "a table has two columns", example.c_str()},
      {"time [s], x [m]\n0, 1\n1, two\n", 3, 4, "\"two\" is not a number", "decimal point"},
      {"time [s], x [m]\n0, 1\n1, 2 m\n", 3, 4, "\"2 m\" is not a number", "without unit"},
      {"time [s], x [m]\n0, 1\n1,\n", 3, 3, "\"\" is not a number", "without unit"},
      {"time [s], x [m]\n0, nan\n", 2, 4, "\"nan\" is not finite", "of the unit"},
      {"time [s], x [m]\n0, 1e999\n", 2, 4, "\"1e999\" is not finite", "of the unit"},
      {"time [s], x [m]\n0, 1e30\n", 2, 4, "too large to be meant", "of the unit"},
      {"time [s], x [m]\n0, 1\n1, 2\n1, 3\n", 4, 1, "the time 1 does not come after",
       "in the order of time"},
      {"time [s], x [m]\n0, 1\n2, 2\n1, 3\n", 4, 1, "the time 1 does not come after",
       "in the order of time"},
      {"time [s], x [m]\n0, 1\n1, 2 \xE9\n", 3, 6, "not UTF-8", "save it with UTF-8"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const WithTable written(row.text);
    const Problem problem = problem_of(mechanism(), written.path);
    CHECK(problem.file == written.table);
    CHECK(problem.line == row.line);
    CHECK(problem.column == row.column);
    CHECK(contains(problem.message, row.message));
    CHECK(contains(problem.hint, row.hint));
  }
}

TEST_CASE("a table that cannot be read is named where the case names it") {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "small.toml").string();
  const Problem missing = problem_of(mechanism(), path);
  CHECK(missing.file == path);
  CHECK(missing.source_line == "file = \"stroke.csv\"");
  CHECK(contains(missing.message, (folder.path() / "stroke.csv").string()));
  CHECK(contains(missing.message, "there is no such file"));
  CHECK(contains(missing.hint, "from the folder of the case file"));
  folder.write("stroke.csv", "#" + std::string(8u << 20, ' '));
  CHECK(contains(problem_of(mechanism(), path).message, "the file is over 8 MB"));
}

TEST_CASE("the same mistake in a table of two drivers is one problem, behind those of the case") {
  const WithTable written("time [s], x [m]\n0, 1\n1, two\n");
  const std::string twice =
      mechanism("phase = \"0 deg\"\n") +
      "[drivers.Y]\nkind = \"table\"\npoint = \"arm.B\"\ncoordinate = \"y\"\nfile = "
      "\"stroke.csv\"\n";
  try {
    small_case::read(twice, written.path);
    FAIL("nothing was found wrong");
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 2);
    CHECK(contains(error.problems()[0].message, "unknown key \"phase\""));
    CHECK(error.problems()[1].file == written.table);
  }
}

TEST_CASE("the hash of a case covers its tables") {
  const std::string csv = "time [s], x [m]\n0, 1\n1, 2\n2, 3\n";
  const WithTable one(csv), same(csv), other(csv + "# other\n");
  const Project project = one.read();
  CHECK(project.sha256 == same.read().sha256);
  CHECK(project.sha256 != other.read().sha256);
  REQUIRE(project.tables.size() == 1);
  CHECK(project.tables.front().written == "stroke.csv");
  // printf 'time [s], x [m]\n0, 1\n1, 2\n2, 3\n' | sha256sum
  CHECK(project.tables.front().sha256 ==
        "b2e2635c90b2c92588aa2513ddd2753b93be4ed52c89d21d0726ffedf6d0d42f");
}

}  // namespace time_tables_test
