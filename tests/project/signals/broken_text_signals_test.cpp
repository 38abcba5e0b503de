#include <sys/stat.h>

#include "project/signals/broken_signals.hpp"
#include "project/signals/written_table.hpp"

namespace broken_text_signals_test {

using namespace boxbeam;

namespace {

using Rows = std::vector<test::BrokenSignals>;

SignalSource with_step(double step) { return {{}, {}, step, {}}; }

}  // namespace

TEST_CASE("what is wrong in a CSV file of signals is named with its line", "[bad_input]") {
  const char* const head = "time [s], force [kN]";
  const std::string good = "time [s],F [kN]\n0,1\n";
  test::check_broken(
      "a.csv",
      Rows{
          {"", 0, "the file is empty", "give a file of signals"},
          {"# nothing\n\n", 0, "the file is empty", head},
          {"time [s],F [kN]\n", 0, "the table has no rows", head},
          {"0,1\n1,2\n", 1, "the columns have no names", head},
          {"time [s]\n0\n1\n", 1, "the table has no column but the time", head},
          {"a\nb\nc\n1\n", 3, "a third line without numbers", head},
          {"time [s],\n0,1\n", 1, "a column has no name", head},
          {"F [kN],M [kN m]\n0,1\n", 1, "no column is the time", head},
          {"time,F [kN]\n0,1\n", 1, "the time has no unit", head},
          {"time [kg],F [kN]\n0,1\n", 1, "no column is the time", head},
          {"t,F,G\ns,kN\n0,1,2\n", 2, "the line above names 3 columns, here are units for 2",
           "commas between"},
          {good + "1\n", 3, "the head names 2 columns, here is 1", "commas between"},
          {good + "1,2,3\n", 3, "the head names 2 columns, here are 3", "a decimal comma wants"},
          {good + "1;2\n", 3, "the head names 2 columns, here is 1", "commas between"},
          {"time [s];F [kN]\n0;1\n1\t2\n", 3, "the head names 2 columns, here is 1",
           "semicolons between"},
          {"time [s] F [kN]\n0 1\n1 2 3\n", 3, "the head names 2 columns, here are 3",
           "blanks between"},
          {good + "1,\n", 3, "\"\" is not a number", "without unit"},
          {good + "1,nan\n", 3, "\"nan\" is not finite", "of the unit"},
          {good + "1,-inf\n", 3, "\"-inf\" is not finite", "of the unit"},
          {good + "1,1e21\n", 3, "1e+21 is not finite, or too large to be meant", "finite number"},
          {good + "1,1e999\n", 3, "\"1e999\" is not finite", "of the unit"},
          {good + "1,two\n", 3, "\"two\" is not a number", "decimal point"},
          {good + "0,2\n", 3, "the time 0 s does not come after 0 s", "in the order of time"},
          {good + "1,2\n0.5,2\n", 4, "the time 0.5 s does not come after 1 s", "each instant once"},
          {"t [s];F [kN]\n0;1.5\n1;2,5\n", 3, "another decimal sign", "all with a comma"},
          {"#TIMEstep= soon\n1\n", 1, "the time step cannot be read", "#TIMEstep= 0.01 Seconds"},
          {"#TIMEstep= -1\n1\n", 1, "the time step cannot be read", "#TIMEstep= 0.01 Seconds"},
          {"#TIMEstep= 1 kN\n1\n", 1, "the time step cannot be read", "#TIMEstep= 0.01 Seconds"},
          {good, 0, "the file has its own time", "take the time step away", with_step(0.1)},
          {good, 1, "the file has no channel \"axial\"", "it has \"F\"", {}, {{"axial"}}},
          {good,
           1,
           "\"F\" is to be a moment, but its unit \"kN\" is that of a force",
           "that kind",
           {},
           {{"F", wanted::moment}}},
          {"time [s],F\n0,1\n",
           1,
           "the file gives no unit for \"F\"",
           "\"10 kN\"",
           {},
           {{"F", wanted::force}}},
          {"time [s],F [kips]\n0,1\n",
           1,
           "\"kips\" is not a unit known here",
           "\"10 kN\"",
           {},
           {{"F", wanted::force}}},
          {"time [s],F [10 kN]\n0,1\n",
           1,
           "\"10 kN\" is not a unit known here",
           "\"10 kN\"",
           {},
           {{"F", wanted::force}}},
          {"time [s],F [kN],F [kN]\n0,1,2\n",
           1,
           "\"F\" is the name of 2 channels, 1 and 2",
           "names of their own",
           {},
           {{"F", wanted::force}}},
          {"time [s],F [kN]\n0,1\n" + std::string(std::size_t{3} << 20U, '1'), 3,
           "a line is over 1 MB", "a line for each instant"},
      });
}

TEST_CASE("what is wrong in OpenFAST's text is named with its line", "[bad_input]") {
  const char* const names = "a line of names begins with Time";
  const std::string good = "By OpenFAST\n\nTime\tA\tB\n(s)\t(kN)\t(m)\n0\t1\t2\n";
  SignalSource asked;
  asked.format = SignalFormat::openfast_text;
  test::check_broken(
      "a.out",
      Rows{
          {"", 0, "the file is empty", "give a file"},
          {"nothing\n", 0, "no line begins with Time", names, asked},
          {"Time\tA", 1, "the file ends behind the names", names, asked},
          {"Time A\n(s)\n", 2, "the line above names 2 columns, here is the unit of 1", names,
           asked},
          {"Time A\n(s) kN\n0 1\n", 2, "\"kN\" is no unit in parentheses", names},
          {"Time A\n(kN) (kN)\n0 1\n", 2, "the time is in \"kN\"", names},
          {"Time\n(s)\n0\n", 2, "no column but the time", "", asked},
          {"Time A\n(s) (kN)\n", 0, "the table has no rows", names},
          {"Time A\n(s) (kN)\nand so on\n0 1\n", 3, "this is no row of numbers", names},
          {good + "1\t2\n", 6, "the head names 3 columns, here are 2", "blanks between"},
          {good + "1\t2\t3\t4\n", 6, "the head names 3 columns, here are 4", "blanks"},
          {good + "1\t2\tNaN\n", 6, "\"NaN\" is not finite", "number"},
          {good + "1\t2\t********\n", 6, "\"********\" is not a number", "decimal point"},
          {good + "1\t2\t1.5-105\n", 6, "\"1.5-105\" is not a number", "decimal point"},
          {good + "1\t2\t1,5\n", 6, "\"1,5\" has another decimal sign", "a point"},
          {good + "0\t2\t3\n", 6, "the time 0 s does not come after 0 s", "order of time"},
          {good + "ended\n1\t2\t3\n", 7, "a row behind the closing line \"ended\"", "one run"},
          {good, 0, "the file has its own time", "take the time step away", with_step(1)},
          {good, 3, "the file has no channel \"AA\"", "did you mean \"A\"?", {}, {{"AA"}}},
          {good, 3, "\"B\" is to be a force", "that kind", {}, {{"B", wanted::force}}},
          {"Time A A\n(s) (m) (m)\n0 1 2\n",
           1,
           "the name of 2 channels, 1 and 2",
           "names of their own",
           {},
           {{"A"}}},
      });
}

TEST_CASE("what is wrong in a sensor file of Exudyn is named with its line", "[bad_input]") {
  const std::string head = "#Exudyn sensor output file\n#OutputVariableType = Force\n";
  const std::string good = head + "#number of sensor values = 2\n#\n0,1,2\n0.1,2,3\n";
  const char* const hint = "give a sensor file as Exudyn writes it";
  test::check_broken(
      "a.txt",
      Rows{
          {head, 0, "the file has no rows", hint},
          {head + "time, force\n0,1\n", 3, "neither a row of numbers nor a line with #", hint},
          {head + "0\n", 3, "a row holds the time and at least one value", hint},
          {head + "#number of sensor values = 3\n0,1,2\n", 4,
           "the head tells 3 sensor values, here are 2", hint},
          {head + "#number of sensor values = many\n0,1\n", 3, "\"many\" is no number of values",
           hint},
          {head + "#number of sensor values = 99999999999999999999\n0,1\n", 3,
           "is no number of values", hint},
          {good + "0.2,3\n", 7, "the head names 3 columns, here are 2", "commas between"},
          {good + "0.2,3,4,5\n", 7, "the head names 3 columns, here are 4", "commas between"},
          {good + "0.2,nan,4\n", 7, "\"nan\" is not finite", "number"},
          {good + "0.2,3,1e30\n", 7, "1e+30 is not finite, or too large", "finite"},
          {good + "0.2;3;4\n", 7, "the head names 3 columns, here is 1", "commas between"},
          {good + "0.1,3,4\n", 7, "the time 0.1 s does not come after 0.1 s", "keep one"},
          {good + good, 11, "the time 0 s does not come after 0.1 s", "keep one"},
          {good + "crash\n", 7, "the head names 3 columns, here is 1", "commas between"},
          {good, 0, "the file has its own time", "take the time step away", with_step(1)},
          {good,
           0,
           "the file has no channel \"Force.3\"",
           "did you mean \"Force.1\"?",
           {},
           {{"Force.3"}}},
          {good,
           0,
           "the file gives no unit for \"Force.1\"",
           "say what one of it is",
           {},
           {{"Force.1", wanted::force}}},
      });
  // As Exudyn itself writes it: 21 rows below 8 lines, 1 line behind them, then all again.
  const Problem appended = test::signal_problem_of(
      {test::project_file("tests/project/signals/samples/exudyn-appended.txt")});
  CHECK(test::has_part(appended.message, "the time 0 s does not come after 0.4 s"));
  CHECK(appended.source_line == "0,0,0,0");
  CHECK(appended.line > 8 + 21 + 8);
}

TEST_CASE("what is wrong in MBDyn's files is named with its line", "[bad_input]") {
  const char* const hint = "for each step a row for each label";
  const std::string row2 = "2 1 2 3 4 5 6 7 8 9 10 11 12\n";
  const std::string row3 = "3 1 2 3 4 5 6 7 8 9 10 11 12\n";
  test::check_broken(
      "a.jnt", Rows{
                   {row2 + row3, 0, "there is no", "put the .out file"},
                   {"\n\n", 0, "the file is empty", hint, with_step(0.1)},
                   {"two 1 2\n", 1, "\"two\" is no label", hint, with_step(0.1)},
                   {"2\n", 1, "a label without numbers", hint, with_step(0.1)},
                   {row2 + row3 + row3, 3, "the label 3 comes a second time before 2 does", hint,
                    with_step(0.1)},
                   {row2 + row3 + row2, 0, "the file ends within step 2: the label 3 is missing",
                    hint, with_step(0.1)},
                   {row2 + row3 + row2 + "4 1\n", 4, "the label 4 stands where 3 is due", hint,
                    with_step(0.1)},
                   {row2 + row2 + "2 1 2 3\n", 3, "12 numbers are expected here, there are 3", hint,
                    with_step(0.1)},
                   {row2 + "2 1 2 3 4 5 6 7 8 9 10 11 12 13\n", 2,
                    "12 numbers are expected here, there are 13", hint, with_step(0.1)},
                   {row2 + "2 1 2 3 4 5 x 7 8 9 10 11 12\n", 2, "\"x\" is not a number",
                    "decimal point", with_step(0.1)},
                   {row2 + "2 1 2 3 4 5 nan 7 8 9 10 11 12\n", 2, "nan is not finite",
                    "finite number", with_step(0.1)},
                   {row2 + "2,1 2 3 4 5 6 7 8 9 10 11 12 13\n", 2,
                    "\"2,1\" is no label of an element", hint, with_step(0.1)},
                   {row2,
                    0,
                    "the file has no channel \"2.local.FX\"",
                    "did you mean \"2.local.Fx\"?",
                    with_step(0.1),
                    {{"2.local.FX"}}},
                   {row2,
                    0,
                    "the file gives no unit for \"2.local.Mx\"",
                    "\"12 kN m\"",
                    with_step(0.1),
                    {{"2.local.Mx", wanted::moment}}},
               });

  // The instants beside them.
  const std::string key = "# Step Time TStep NIter ResErr SolErr SolConv Out\n";
  struct Beside {
    std::string out;
    bool in_out;
    int line;
    const char* message;
  };
  for (const Beside& row :
       {Beside{key + "Step 0 0 1 0 0 0 0 1\n", false, 2, "tells 1 instants, here ends step 2"},
        {key + "Step 0 0 1 0 0 0 0 1\nStep 1 1 1 0 0 0 0 0\n", false, 2, "tells 1 instants"},
        {key + "Step 0 0 1 0 0 0 0 1\nStep 1 1 1 0 0 0 0 1\nStep 2 2 1 0 0 0 0 1\n", false, 0,
         "tells 3 instants, here are 2 steps"},
        {key + "Step 0 0 1 0 0 0 0 1\nStep 1 0 1 0 0 0 0 1\n", true, 3,
         "the time 0 s does not come after 0 s"},
        {key + "Step 0 0 1 0 0 0 0 1\nStep 1 x 1 0 0 0 0 1\n", true, 3, "\"x\" is not a number"},
        {key + "Step 0 0 1 0 0 0 0 1\nStep 1 1 1\n", true, 3, "is not complete"},
        {"nothing\n", false, 1, "tells 0 instants, here ends step 1"},
        {"", false, 1, "tells 0 instants, here ends step 1"}}) {
    INFO(row.out);
    const test::TemporaryFolder folder;
    const std::string path = folder.write("b.frc", "2 1 2\n2 3 4\n");
    const std::string out = folder.write("b.out", row.out);
    const Problem problem = test::signal_problem_of({path});
    INFO(problem.message);
    CHECK(problem.file == (row.in_out ? out : path));
    CHECK(problem.line == row.line);
    CHECK(test::has_part(problem.message, row.message));
    CHECK_FALSE(problem.hint.empty());
  }
}

TEST_CASE("what is wrong in a table of a request is named with its line", "[bad_input]") {
  const char* const hint = "give the table of one request";
  const std::string good = " REQUEST 1\n TIME FX FY\n 0.0 1 2\n";
  test::check_broken(
      "a.tab",
      Rows{
          {"TIME FX\n", 0, "the table has no rows", hint},
          {"1\n2\n", 1, "a row holds the time and at least one value", hint},
          {"0 1 2\n", 1, "the words above the first row are 0, its numbers 3", hint},
          {"TIME FX\n0 1 2\n", 2, "the words above the first row are 2, its numbers 3", hint},
          {"FX FY\n0 1\n", 2, "the first column is called \"FX\", not TIME", hint},
          {good + " 1.0 2\n", 4, "the head names 3 columns, here are 2", "blanks between"},
          {good + " 1.0 2 3 4\n", 4, "the head names 3 columns, here are 4", "blanks between"},
          {good + " 1.0 2 NaN\n", 4, "\"NaN\" is not finite", "number"},
          {good + " 1.0 2 1e25\n", 4, "1e+25 is not finite, or too large", "finite"},
          {good + " 0.0 2 3\n", 4, "the time 0 s does not come after 0 s", "order of time"},
          {good + " 1.0,2,3\n", 4, "the head names 3 columns, here is 1", "blanks between"},
          {good + " TIME TX TY\n 0.0 2 3\n", 5, "a second table begins below \"TIME TX TY\"", hint},
          {good + " REQUEST 2\n TIME FX FY\n 0.0 2 3\n", 6, "does not come after", "keep one"},
          {good, 0, "the file has its own time", "take the time step away", with_step(1)},
          {good, 2, "the file has no channel \"FZ\"", "did you mean \"FX\"?", {}, {{"FZ"}}},
          {good, 2, "the file gives no unit for \"FX\"", "say what", {}, {{"FX", wanted::force}}},
          {" TIME FX FX\n 0 1 2\n", 1, "\"FX\" is the name of 2 channels", "names", {}, {{"FX"}}},
      });
}

TEST_CASE("what is wrong in a request file is named with its line", "[bad_input]") {
  const char* const hint = "a request file has its version, the number of requests";
  const std::string head = "RecurDyn\n2 1.0\n11 4 1 2 0\n12 4 1 2 0\n";
  const std::string good = head + "0\n1 2 3 4 5 6\n1 2 3 4 5 6\n";
  test::check_broken(
      "a.req",
      Rows{
          {"RecurDyn\n", 0, "the number of requests is missing", hint},
          {"RecurDyn\nmany\n", 2, "2 numbers are expected here, there is 1", hint},
          {"RecurDyn\n0 1.0\n", 2, "0 requests cannot be in a file", hint},
          {"RecurDyn\n-3 1.0\n", 2, "-3 requests cannot be in a file", hint},
          {"RecurDyn\n1.5 1.0\n", 2, "1.5 requests cannot be in a file", hint},
          {"RecurDyn\n4000000000 1.0\n11 4 1 2 0\n", 2, "requests cannot be in a file of", hint},
          {"RecurDyn\n2 1.0\n11 4 1 2 0\n", 0, "the file ends behind 1 of 2 requests", hint},
          {"RecurDyn\n1 1.0\n11 4 1 2\n0\n1 2 3 4 5 6\n", 3,
           "5 numbers are expected here, there are 4", hint},
          {"RecurDyn\n1 1.0\n-5 4 1 2 0\n0\n1 2 3 4 5 6\n", 3, "this is no request", hint},
          {head, 0, "the file has no steps", hint},
          {head + "0\n1 2 3 4 5 6\n", 0, "ends within the step at 0 s: 1 of 2 requests", hint},
          {good + "0\n1 2 3 4 5 6\n1 2 3 4 5 6\n", 8, "the time 0 s does not come after 0 s",
           "order of time"},
          {good + "1 2\n", 8, "1 number is expected here, there are 2", hint},
          {good + "1\n1 2 3 4 5\n", 9, "6 numbers are expected here, there are 5", hint},
          {good + "1\n1 2 3 4 5 6\n1 2 x 4 5 6\n", 10, "\"x\" is not a number", "decimal point"},
          {good + "1\n1 2 3 4 5 6\n1 2 inf 4 5 6\n", 10, "inf is not finite", "finite"},
          {good, 0, "the file has its own time", "take the time step away", with_step(1)},
          {good,
           0,
           "the file has no channel \"13.FX\"",
           "did you mean \"11.FX\"?",
           {},
           {{"13.FX"}}},
          {good,
           0,
           "the file gives no unit for \"11.TX\"",
           "say what",
           {},
           {{"11.TX", wanted::moment}}},
      });
}

TEST_CASE("what is no file, and what other programs write that is not read", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  for (const SignalFormat format : all_signal_formats) {
    CHECK(test::signal_problem_of({path + "/none", format}).message == "there is no such file");
    CHECK(test::signal_problem_of({path, format}).message == "this is a folder");
    CHECK(test::signal_problem_of({"/dev/null", format}).message ==
          "this is a pipe or a device, no file");
  }
  const std::string pipe = path + "/pipe.csv";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(test::signal_problem_of({pipe}).message == "this is a pipe or a device, no file");
  using namespace std::string_literals;
  for (const auto& [bytes, name] : {std::pair("MDF     4.10"s, "MDF"),
                                    {"TDSm"s, "TDMS"},
                                    {"MATLAB 5.0"s, "MATLAB"},
                                    {"PK\x03\x04"s, "spreadsheet"}}) {
    const Problem problem = test::signal_problem_of({folder.write("a.nc", bytes)});
    CHECK(test::has_part(problem.message, name));
    CHECK(test::has_part(problem.hint, "CSV"));
  }
  const Problem steps =
      test::signal_problem_of({test::project_file("tests/project/signals/samples/mbdyn.out")});
  CHECK(test::has_part(steps.message, "MBDyn's steps"));
}

TEST_CASE("in what a line is wrong is said in any encoding", "[bad_input]") {
  test::WrittenTable table{{"time", "Kr\u00e4fte"}, {"s", "kN"}, {{0, 1}, {1, 2}, {1, 3}}};
  const test::TemporaryFolder folder;
  using Encoding = test::Writing::Encoding;
  for (const Encoding encoding : {Encoding::utf8, Encoding::latin1, Encoding::utf16_big}) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
      test::Writing way;
      way.encoding = encoding;
      way.line_end = end;
      const Problem problem =
          test::signal_problem_of({folder.write("a.csv", test::text_of(table, way))});
      CHECK(problem.line == 4);
      CHECK(problem.column == 1);
      CHECK(problem.source_line == "1,3");
      table.names[1] += "\u00e4";
      const Problem missing = test::signal_problem_of(
          {folder.write("a.csv", test::text_of(table, way))}, {{"Kr\u00e4ften"}});
      CHECK(missing.hint == "did you mean \"" + table.names[1] + "\"?");
      table.names[1].resize(table.names[1].size() - 2);
    }
  }
}

}  // namespace broken_text_signals_test
