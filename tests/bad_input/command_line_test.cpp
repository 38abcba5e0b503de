#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/program.hpp"

extern char** environ;

namespace command_line_test {

namespace {

using Words = std::vector<std::string>;

const std::string rig = test::project_file("sections/sledge-rig/rig.toml");
const std::string published = test::project_file("sections/sledge-rig/published.toml");

/// Runs the program in an empty folder, which stays empty: nothing is written on wrong usage. What
/// is known before an output fails is said.
void refused(const Words& arguments, const Words& said, int exit_code = 2) {
  const test::TemporaryFolder folder;
  const test::ProgramResult result = test::run_program(arguments, folder.path());
  INFO(result.err);
  CHECK(result.exit_code == exit_code);
  if (exit_code == 2) CHECK(result.out.empty());
  CHECK(std::filesystem::is_empty(folder.path()));
  for (const std::string& part : said) {
    INFO("wanted: " << part);
    CHECK(result.err.find(part) != std::string::npos);
  }
}

nlohmann::json results_of(const Words& more) {
  const test::TemporaryFolder folder;
  Words arguments{"verify", rig, "--no-plots", "--no-pdf", "--out", folder.path().string(),
                  "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const test::ProgramResult result = test::run_program(arguments);
  INFO(result.err);
  CHECK((result.exit_code == 0 || result.exit_code == 1));
  CHECK(result.err.empty());
  return nlohmann::json::parse(result.out);
}

double factor_of(const nlohmann::json& results) {
  return results.at("governing").at("fatigue").at("safety_factor").get<double>();
}

/// The exit code with standard output opened on `output`, or closed where that is empty.
int exit_code_with_output(const std::string& output, Words arguments) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (output.empty())
    posix_spawn_file_actions_addclose(&actions, 1);
  else
    posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  arguments.insert(arguments.begin(), test::program());
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  REQUIRE(error == 0);
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a wrong or missing command is refused with what to write", "[bad_input]") {
  const std::string help = "Run boxbeam --help";
  refused({},
          {"write boxbeam verify CASE.toml, or one of the commands ", "motion", "section", help});
  refused({"verifi", rig}, {"did you mean \"boxbeam verify\"?", help});
  refused({"moton", rig}, {"did you mean \"boxbeam motion\"?", help});
  refused({"frobnicate", rig}, {"write boxbeam verify CASE.toml", help});
  refused({rig}, {"write boxbeam verify CASE.toml", help});
  refused({"verify"}, {"CASE is required", "write boxbeam verify CASE.toml", help});
  refused({"motion"}, {"CASE is required", "write boxbeam motion CASE.toml", help});
  refused({"verify", rig, rig}, {"not expected", help});
  refused({"help", "verifi"}, {"verifi", "did you mean verify?", help});
}

TEST_CASE("a wrong option or value of one is refused", "[bad_input]") {
  refused({"-v"}, {"did you mean -V?"});
  refused({"verify", rig, "-O", "x"}, {"-O", "did you mean -o?"});
  refused({"verify", rig, "--outt", "x"}, {"--outt", "did you mean --out?"});
  refused({"verify", rig, "--dynamic=rigorous"}, {"--dynamic", "did you mean --dynamics?"});
  refused({"motion", rig, "--ad", "1"}, {"--ad", "did you mean --at?"});
  refused({"motion", rig, "--no-plots"}, {"--no-plots"});
  refused({"verify", rig, "--out"}, {"--out"});
  refused({"verify", rig, "--dynamics", "fast"}, {"fast", "{rigorous,newton-chain}"});
  refused({"verify", rig, "--model", "soft"}, {"soft", "{auto,rigid,flexible}"});
  for (const std::string value : {"1", "0", "-0.01", "1%", "nan", "small"}) {
    refused({"verify", rig, "--tolerance=" + value},
            {"\"" + value + "\" is no tolerance", "write a fraction, for example 0.01"});
  }
  for (const std::string value : {"soon", "1 s", "1,5", "nan", "inf", "-inf", "1e300"}) {
    refused({"motion", rig, "--at=" + value, "--json", "motion.json"},
            {"--at: \"" + value + "\" is no instant", "write seconds without unit"});
  }
}

TEST_CASE("a check and a case that changed places are put right", "[bad_input]") {
  refused({"explain", rig, "fatigue"},
          {"the check stands before the case", "boxbeam explain fatigue " + rig});
  refused({"explain", "fatigue", "fatigue"}, {"fatigue: error: there is no such file"});
}

TEST_CASE("a place that cannot be written is found before the calculation", "[bad_input]") {
  const test::TemporaryFolder there;
  const std::string file = there.write("file", "x");
  const std::string nowhere = (there.path() / "none" / "r.json").string();
  const std::string gear = test::project_file("sections/landing-gear/gear.toml");
  const std::string values = test::project_file("sections/landing-gear/published.csv");
  // Where a calculation went before it, its result would be said.
  const auto refused_at_once = [](const Words& arguments, const std::string& said) {
    const test::ProgramResult result = test::run_program(arguments);
    INFO(result.out << result.err);
    CHECK(result.exit_code == 4);
    CHECK(result.out.empty());
    CHECK(result.err.find(said) != std::string::npos);
  };
  const std::string no_folder = "there is no folder " + (there.path() / "none").string();
  for (const Words& command :
       {Words{"verify", rig, "--out", there.path().string()}, Words{"motion", rig},
        Words{"section", "SHS 100x5"}, Words{"compare", gear, values}}) {
    Words arguments = command;
    arguments.insert(arguments.end(), {"--json", nowhere});
    refused_at_once(arguments, no_folder);
    arguments.back() = there.path().string();
    refused_at_once(arguments, there.path().string() + " is a folder");
  }
  refused_at_once({"compare", gear, values, "--html", nowhere}, no_folder);
  const std::string history = there.write("h.csv", "sigma [MPa]\n0\n100\n0\n");
  refused_at_once({"fatigue", history, "--detail", "71", "--json", nowhere}, no_folder);
  refused_at_once({"verify", rig, "--out", file}, file + " is no folder");
  refused_at_once({"verify", rig, "-o", file + "/below"}, file + " is no folder");
  refused_at_once({"chart", "section", "--quick", "--out", file}, file + " is no folder");
  CHECK_FALSE(std::filesystem::exists(there.path() / "none"));
  // The folder of the report is made with the report, and may hold the copy as well.
  const std::string report = (there.path() / "report").string();
  const test::ProgramResult result =
      test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--no-html", "-q", "-o", report,
                         "--json", report + "/copy.json"});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(test::read_file(report + "/copy.json") == test::read_file(report + "/results.json"));
}

TEST_CASE("what only the other kind of case has is refused", "[bad_input]") {
  const std::string gear = test::project_file("sections/landing-gear/gear.toml");
  refused({"motion", gear, "--axes", "wheeel"},
          {"there is no body \"wheeel\" for --axes", "did you mean wheel?"});
  refused({"motion", gear, "--axes", "moon"}, {"no body \"moon\"", "one of world, climb"});
  refused({"motion", gear, "--assemblies"}, {"one assembly", "leave out --assemblies"});
  refused({"motion", rig, "--axes", "beam"}, {"world axes only", "leave out --axes"});
  const std::string published = test::project_file("sections/sledge-rig/published.toml");
  refused({"verify", published, "--dynamics", "newton-chain", "--model", "flexible"},
          {"is one of rigid bodies", "--dynamics rigorous"});
  const std::string truck = test::project_file("sections/drill-truck/truck.toml");
  refused({"motion", truck, "--at", "1"}, {"there are no instants to choose", "leave out --at"});
  refused({"motion", truck, "--assemblies"}, {"only assembly", "leave out --assemblies"});
  refused({"motion", truck, "--axes", "boom"}, {"world axes only", "leave out --axes"});
  refused({"verify", truck, "--dynamics", "newton-chain"}, {"a Newton chain", "rigorous"});
}

TEST_CASE("a wrong override is refused as in the file", "[bad_input]") {
  const auto refused_set = [](const std::string& text, Words said) {
    INFO(text);
    refused({"verify", rig, "--set", text}, said);
    refused({"motion", rig, "--set", text}, said);
  };
  const std::string form = "--set wants KEY=VALUE, not ";
  const std::string example = "--set bodies.sledge.mass=\"20 t\"";
  refused_set("bodies.sledge.mass", {form + "\"bodies.sledge.mass\"", example});
  refused_set("=20 t", {form + "\"=20 t\"", example});
  refused_set("bodies..mass=20 t", {form, example});
  refused_set("bodies.sledge.mass.=20 t", {form, example});
  refused_set(
      "bodies.sledge.mas=20 t",
      {"--set bodies.sledge.mas=20 t:1:7: error: unknown key \"mas\"", "did you mean \"mass\"?"});
  refused_set("strenght.required=1", {"--set strenght.required=1", "did you mean \"strength\"?"});
  refused_set("bodies.upper_rod.uniform_rod=0.5",
              {"--set bodies.upper_rod.uniform_rod=0.5:1:", "a length, not a bare number",
               "write it as text with its unit, \"0.25 m\" or \"250 mm\""});
  refused_set("bodies.sledge.mass=20 m", {"but \"20 m\" is a length", "\"119 kg\" or \"20 t\""});
  refused_set("bodies.sledge.mass=nan kg", {"the number must be finite"});
  refused_set("beam.segments.6.length=1 m", {"the case has no \"6\" to set something in",
                                             "items of an array go by their number from 0"});
  refused_set("case.name=a/b", {"the name of its report folder", "use letters"});
  refused_set("case.title=sl\xE4t", {"--set is not UTF-8"});
}

TEST_CASE("an override that works changes the result", "[bad_input]") {
  const double given = factor_of(results_of({}));
  const double heavier = factor_of(results_of({"--set", "bodies.sledge.mass=20 t"}));
  const double quoted = factor_of(results_of({"--set", "bodies.sledge.mass=\"20 t\""}));
  CHECK(given > 0.0);
  CHECK(heavier < given);  // 20 t instead of 18.6 t to swing
  CHECK(quoted == heavier);
}

TEST_CASE("loads that a case cannot give are refused with the reason", "[bad_input]") {
  refused({"verify", published, "--dynamics", "rigorous"},
          {"published.toml:", "rigorous loads need the beam to be one body",
           "given stresses replace the computed ones", "use --dynamics newton-chain"});
}

TEST_CASE("output that cannot be written ends with 4", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "a regular file");
  for (const std::string& folder_wanted : {file + "/report", std::string("/proc/x/y")}) {
    refused({"verify", rig, "--out", folder_wanted}, {folder_wanted + " cannot be made"}, 4);
    // Known before anything is calculated: no summary stands before it.
    CHECK(test::run_program({"verify", rig, "--out", folder_wanted}).out.empty());
  }
  refused({"motion", rig, "--json", file + "/motion.json"}, {file}, 4);
  CHECK(test::read_file(file) == "a regular file");

  const std::string out = (folder.path() / "out").string();
  for (const std::string output : {"/dev/full", ""}) {
    INFO("standard output: " << output);
    CHECK(exit_code_with_output(output, {"verify", rig, "--no-plots", "--no-pdf", "--out", out}) ==
          4);
    CHECK(exit_code_with_output(
              output, {"verify", rig, "--no-plots", "--no-pdf", "--out", out, "--json", "-"}) == 4);
    CHECK(exit_code_with_output(output, {"motion", rig}) == 4);
    CHECK(exit_code_with_output(output, {"motion", rig, "--json", "-"}) == 4);
    CHECK(exit_code_with_output(output, {"--help"}) == 4);
    CHECK(exit_code_with_output(output, {"--version"}) == 4);
    // Wrong usage comes before an output that would fail.
    CHECK(exit_code_with_output(output, {"verify"}) == 2);
  }
}

TEST_CASE("an analysis that cannot be done names the instant and writes nothing", "[bad_input]") {
  // The beam's end B is on a circle of 3 m about O, the blade on the line y = 3 m up to x = 0.75 m:
  // sqrt(0.75^2 + 3^2) - 3 = 0.092 m lie between them, and this rod is 0.08 m long.
  const Words short_rod{"--set", "bodies.upper_rod.points.A=[\"-0.17 m\", \"0 m\"]"};
  for (const std::string command : {"verify", "motion"}) {
    Words arguments{command, rig};
    arguments.insert(arguments.end(), short_rod.begin(), short_rod.end());
    refused(arguments, {"the analysis cannot be done", "time ", " s\n", "residual"}, 3);
  }
}

}  // namespace command_line_test
