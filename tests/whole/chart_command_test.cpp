// boxbeam chart as a user runs it: data, pictures and pages; what it says where it cannot.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "catch.hpp"
#include "support/program.hpp"

namespace chart_command_test {

namespace fs = std::filesystem;

namespace {

/// A topic that takes little time.
constexpr const char* topic = "cut-forces";

test::ProgramResult charted(const test::TemporaryFolder& folder,
                            const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"chart", topic, "--quick", "--out",
                                     (folder.path() / "charts").string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::run_program(arguments);
}

/// Files of a folder by their ending, without it, sorted.
std::vector<std::string> names_of(const fs::path& folder, const std::string& ending) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The lines of a table of settings without the columns of times, which stand in the fifth to
/// the seventh field; for tables without quotes.
std::vector<std::string> without_times(const std::string& csv) {
  std::vector<std::string> lines;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string kept;
    std::size_t number = 0;
    bool quotes = false;
    for (const char c : line) {
      if (c == '"') quotes = !quotes;
      if (c == ',' && !quotes) ++number;
      if (number < 4 || number > 6) kept += c;
    }
    lines.push_back(kept);
  }
  return lines;
}

/// A path without the programs that draw.
class NoTools {
 public:
  explicit NoTools(const fs::path& folder) : before_(std::getenv("PATH")) {
    setenv("PATH", folder.c_str(), 1);
  }
  ~NoTools() { setenv("PATH", before_.c_str(), 1); }
  NoTools(const NoTools&) = delete;
  NoTools& operator=(const NoTools&) = delete;

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("chart: data, pictures, scripts and pages of a topic", "[chart]") {
  const test::TemporaryFolder folder;
  const test::ProgramResult result = charted(folder, {});
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  const fs::path charts = folder.path() / "charts";
  const std::vector<std::string> tables = names_of(charts, ".csv");
  REQUIRE_FALSE(tables.empty());
  CHECK(names_of(charts, ".svg") == tables);
  CHECK(names_of(charts / "plots", ".gp") == tables);
  for (const std::string& name : tables) CHECK(result.out.find(name) != std::string::npos);
  CHECK(result.out.find("chart.html and chart.pdf") != std::string::npos);
  CHECK(test::read_file(charts / "chart.pdf").starts_with("%PDF-"));
  const std::string page = test::read_file(charts / "chart.html");
  CHECK(page.find("Default settings") != std::string::npos);
  CHECK(page.find("Verdict") == std::string::npos);
  // Nothing else stays.
  for (const fs::directory_entry& entry : fs::directory_iterator(charts)) {
    const std::string name = entry.path().filename().string();
    CHECK((name == "plots" || name == "chart.html" || name == "chart.pdf" ||
           name.ends_with(".csv") || name.ends_with(".svg")));
  }
}

TEST_CASE("chart: two runs differ in times only, and other charts of the folder stay", "[chart]") {
  const test::TemporaryFolder folder;
  const fs::path charts = folder.path() / "charts";
  REQUIRE(charted(folder, {"--no-pdf"}).exit_code == 0);
  CHECK_FALSE(fs::exists(charts / "chart.pdf"));
  std::vector<std::vector<std::string>> first;
  const std::vector<std::string> tables = names_of(charts, ".csv");
  for (const std::string& name : tables)
    first.push_back(without_times(test::read_file(charts / (name + ".csv"))));
  const std::string other = folder.write("charts/other.csv", "of another topic\n");
  REQUIRE(charted(folder, {"--no-pdf"}).exit_code == 0);
  CHECK(test::read_file(other) == "of another topic\n");
  for (std::size_t i = 0; i < tables.size(); ++i) {
    CAPTURE(tables[i]);
    CHECK(without_times(test::read_file(charts / (tables[i] + ".csv"))) == first[i]);
  }
}

TEST_CASE("chart: a word that is no topic is wrong input, with the nearest one", "[chart]") {
  const test::TemporaryFolder folder;
  const test::ProgramResult result =
      test::run_program({"chart", "cut-force", "--out", folder.path() / "charts"});
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("did you mean cut-forces?") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "charts"));
}

TEST_CASE("chart: what overrides a case needs one", "[chart]") {
  const test::ProgramResult result =
      test::run_program({"chart", topic, "--set", "bodies.sledge.mass=20 t"});
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("--case") != std::string::npos);
}

TEST_CASE("chart: where no topic applies to the case that is said, and nothing is written",
          "[chart]") {
  const test::TemporaryFolder folder;
  // A chain in space, whose motion is explicit: no equations are solved for its positions.
  const test::ProgramResult result = test::run_program(
      {"chart", "kinematics", "--case", test::project_file("sections/landing-gear/gear.toml"),
       "--out", (folder.path() / "charts").string()});
  CHECK(result.exit_code == 3);
  CHECK(result.err.find("kinematics: ") != std::string::npos);
  CHECK(result.out.empty());
  CHECK_FALSE(fs::exists(folder.path() / "charts"));
}

TEST_CASE("chart: without gnuplot and LaTeX all the rest is written", "[chart]") {
  const test::TemporaryFolder folder;
  const fs::path charts = folder.path() / "charts";
  fs::create_directories(charts);
  folder.write("charts/cut-forces-moment.svg", "of an earlier run");
  folder.write("charts/chart.pdf", "of an earlier run");
  const NoTools path(folder.path());
  const test::ProgramResult result = charted(folder, {});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("gnuplot-nox") != std::string::npos);
  CHECK(result.err.find("texlive") != std::string::npos);
  CHECK_FALSE(names_of(charts, ".csv").empty());
  CHECK(names_of(charts, ".svg").empty());
  CHECK_FALSE(fs::exists(charts / "chart.pdf"));
  const std::string page = test::read_file(charts / "chart.html");
  CHECK(page.find("<figure") == std::string::npos);
  CHECK(page.find("Default settings") != std::string::npos);
}

TEST_CASE("chart: a folder that cannot be written is said in one line", "[chart]") {
  const test::TemporaryFolder folder;
  folder.write("charts", "a file where the folder should be");
  const test::ProgramResult result = charted(folder, {"--no-pdf"});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("cannot be made") != std::string::npos);
}

}  // namespace chart_command_test
