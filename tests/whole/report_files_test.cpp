// What stands in the reports is what stands in results.json, in every form and for every shipped
// case; the same input gives the same bytes; a tool that is missing costs its own output only.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "boxbeam/report/latex_writer.hpp"
#include "boxbeam/report/report.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/shipped_cases.hpp"

namespace report_files_test {

using namespace boxbeam;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

using Row = std::vector<std::string>;

/// Sets a variable of the environment as long as it lives.
class Environment {
 public:
  Environment(std::string name, const std::string& value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) before_ = before;
    ::setenv(name_.c_str(), value.c_str(), 1);
  }
  ~Environment() {
    if (before_)
      ::setenv(name_.c_str(), before_->c_str(), 1);
    else
      ::unsetenv(name_.c_str());
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

std::string replaced(std::string text, const std::string& part, const std::string& with) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + with.size())) {
    text.replace(at, part.size(), with);
  }
  return text;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
}

std::vector<std::string> split(const std::string& text, const std::string& at) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(at); end != std::string::npos; end = text.find(at, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + at.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// Rows of a text: what two spaces separate.
std::vector<Row> rows_of_text(const std::string& text) {
  std::vector<Row> rows;
  for (const std::string& line : split(text, "\n")) {
    Row row;
    for (const std::string& cell :
         split(line.substr(std::min<std::size_t>(1, line.size())), "  ")) {
      if (!trimmed(cell).empty()) row.push_back(trimmed(cell));
    }
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> rows_of_html(const std::string& html) {
  std::vector<Row> rows;
  for (const std::string& part : split(html, "<tr")) {
    Row row;
    for (const std::string& cell : split(part.substr(0, part.find("</tr>")), "</t")) {
      std::size_t begin = std::max(cell.rfind("<td"), cell.rfind("<th"));
      if (cell.rfind("<td") == std::string::npos) begin = cell.rfind("<th");
      if (cell.rfind("<th") == std::string::npos) begin = cell.rfind("<td");
      if (begin == std::string::npos) continue;
      std::string text = std::regex_replace(cell.substr(begin), std::regex("<[^>]*>"), "");
      for (const auto& [entity, letter] : {std::pair{"&minus;", "-"},
                                           {"&#8722;", "-"},
                                           {"\u2212", "-"},
                                           {"&lt;", "<"},
                                           {"&gt;", ">"},
                                           {"&quot;", "\""},
                                           {"&#39;", "'"},
                                           {"&amp;", "&"}}) {
        text = replaced(text, entity, letter);
      }
      row.push_back(trimmed(text));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> rows_of_latex(const std::string& latex) {
  std::vector<Row> rows;
  for (std::string part : split(latex, "\\tabularnewline")) {
    part = part.substr(part.rfind('\n') == std::string::npos ? 0 : part.rfind('\n') + 1);
    for (const auto& [command, letter] : {std::pair{"\\as{002D}{\\textminus}", "-"},
                                          {"{}", ""},
                                          {"\\_", "_"},
                                          {"\\%", "%"},
                                          {"\\#", "#"},
                                          {"\\textcolor{fails}{\\textbf{!}}", "!"}}) {
      part = replaced(part, command, letter);
    }
    Row row;
    for (const std::string& cell : split(part, " &")) row.push_back(trimmed(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// A cell that is a number and nothing else.
std::optional<double> number_in(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

/// Whether a shown number is a value to half a unit of its last digit.
bool agrees(const std::string& cell, double value) {
  const std::optional<double> shown = number_in(cell);
  if (!shown) return false;
  if (cell == "0") return std::abs(value) < 1e-9;
  const std::size_t exponent = std::min(cell.find('e'), cell.size());
  const std::size_t point = std::min(cell.find('.'), exponent);
  const double decimals = exponent > point ? static_cast<double>(exponent - point - 1) : 0.0;
  double unit = std::pow(10.0, -decimals);
  if (exponent < cell.size()) unit *= std::pow(10.0, std::stod(cell.substr(exponent + 1)));
  return std::abs(*shown - value) <= 0.5 * unit * (1.0 + 1e-9);
}

/// Without the column that says whether it passes.
Row unmarked(Row row) {
  const auto is_mark = [](const std::string& cell) {
    return cell.empty() || cell == "!" || cell == "?" || cell == "FAILS" || cell == "passes";
  };
  while (!row.empty() && is_mark(row.front())) row.erase(row.begin());
  return row;
}

/// "use, factor, required" as in results.json.
bool shows(const Json& check, const Row& row, std::size_t first) {
  return row.size() > first + 2 && agrees(row[first], 100.0 * check["utilisation"].get<double>()) &&
         agrees(row[first + 1], check["safety_factor"].get<double>()) &&
         agrees(row[first + 2], check["required"].get<double>());
}

/// A cell that may be the first line of a wrapped one.
bool begins(const std::string& cell, const std::string& whole) {
  return !cell.empty() && whole.starts_with(cell);
}

/// The rows of the table of checks are those whose fourth cell is a criterion behind three numbers.
std::vector<Row> check_rows(const std::vector<Row>& rows) {
  std::vector<Row> found;
  for (const Row& of : rows) {
    Row row = unmarked(of);
    if (row.size() < 9 || !number_in(row[0]) || !number_in(row[1]) || !number_in(row[2])) continue;
    const bool named = std::any_of(criteria.begin(), criteria.end(), [&](Criterion criterion) {
      return begins(row[3], to_text(criterion));
    });
    if (named) found.push_back(std::move(row));
  }
  return found;
}

/// The same numbers as results.json has.
void compare(const std::vector<Row>& rows, const test::ShippedCase& of, const Json& results) {
  for (const auto& [name, check] : results["governing"].items()) {
    INFO("governing " << check["id"]);
    const std::string criterion = check["criterion"];
    CHECK(std::any_of(rows.begin(), rows.end(), [&](const Row& marked) {
      const Row row = unmarked(marked);
      return !row.empty() && row[0] == criterion && shows(check, row, 1);
    }));
  }
  const std::vector<Row> checks = check_rows(rows);
  // Those used half and more, at least the worst; the others are summed up.
  const auto much_used =
      std::count_if(results["checks"].begin(), results["checks"].end(),
                    [](const Json& check) { return check["utilisation"].get<double>() >= 0.5; });
  const auto shown = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, much_used));
  // Behind them stand those of slender plates by the route that does not judge.
  Json beside = Json::array();
  if (results.contains("plates") && results["plates"].is_object())
    beside = results["plates"]["beside"];
  REQUIRE(checks.size() == shown + beside.size());
  REQUIRE(shown <= results["checks"].size());
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const Json& check = i < shown ? results["checks"][i] : beside[i - shown];
    INFO(check["id"]);
    CHECK(shows(check, checks[i], 0));
    CHECK(begins(checks[i][3], check["criterion"].get<std::string>()));
    CHECK(begins(checks[i][5], check["point"].get<std::string>()));
  }
  const Json& stations = results["beam"]["stations"];
  REQUIRE(stations.size() == of.verification.stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const std::string label = to_text(of.verification.stations[i].station);
    const auto extremes = [&](const std::vector<const char*>& names) {
      std::vector<double> values;
      for (const char* name : names) {
        for (const Json& value : stations[i][name]) values.push_back(value.get<double>() * 1e-3);
      }
      return values;
    };
    std::vector<std::vector<double>> expected;
    if (of.project.in_space) {
      expected = {extremes({"N", "V_y", "V_z"}), extremes({"T", "M_y", "M_z"})};
    } else {
      expected.push_back(extremes({"N", "V", "M"}));
    }
    for (const std::vector<double>& values : expected) {
      INFO("cut forces at " << label);
      CHECK(std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        if (row.size() != values.size() + 1 || row[0] != label) return false;
        for (std::size_t k = 0; k < values.size(); ++k) {
          if (!agrees(row[k + 1], values[k])) return false;
        }
        return true;
      }));
    }
  }
}

/// All files of a folder by their path in it, with their bytes.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).string()] = test::read_file(entry.path());
  }
  return files;
}

/// A folder with the programs that may be found, as a PATH.
void link_programs(const test::TemporaryFolder& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    for (const char* place : {"/usr/bin/", "/bin/", "/usr/local/bin/"}) {
      std::error_code error;
      if (!fs::exists(place + name)) continue;
      fs::create_symlink(place + name, folder.path() / name, error);
      break;
    }
  }
}

const char* const rig = "sections/sledge-rig/rig.toml";

}  // namespace

TEST_CASE("text, HTML and PDF hold the numbers of results.json, for all shipped cases",
          "[files][unsanitized]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const test::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const test::ProgramResult run =
        test::run_program({"verify", of.path, "--out", out, "--no-plots", "--no-pdf"});
    INFO(run.err);
    REQUIRE((run.exit_code == 0 || run.exit_code == 1));
    const Json results = Json::parse(test::read_file(out + "/results.json"));
    {
      INFO("text");
      compare(rows_of_text(test::read_file(out + "/report.txt")), of, results);
    }
    {
      INFO("HTML");
      compare(rows_of_html(test::read_file(out + "/report.html")), of, results);
    }
    {
      INFO("LaTeX");
      const auto no_picture = [](const std::string&) { return false; };
      compare(rows_of_latex(report::latex_of(report_of(of.project, of.verification), no_picture)),
              of, results);
    }
  }
}

TEST_CASE("figures are drawn into a folder that is not there yet, with or without PDF", "[files]") {
  const test::TemporaryFolder folder;
  for (const bool pdf : {false, true}) {
    const fs::path out = folder.path() / (pdf ? "with" : "without") / "folder";
    std::vector<std::string> words{"verify", rig, "--out", out.string()};
    if (!pdf) words.emplace_back("--no-pdf");
    const test::ProgramResult result = test::run_program(words);
    INFO(result.err);
    CHECK(result.exit_code == 1);
    CHECK(fs::exists(out / "mechanism.svg"));
    CHECK(fs::exists(out / "report.pdf") == pdf);
  }
}

TEST_CASE("two runs give the same bytes in every file", "[files]") {
  const Environment epoch("SOURCE_DATE_EPOCH", "1700000000");
  const test::TemporaryFolder folder;
  const auto run = [&](const char* name) {
    const fs::path out = folder.path() / name;
    const test::ProgramResult result = test::run_program({"verify", rig, "--out", out.string()});
    INFO(result.err);
    REQUIRE(result.exit_code == 1);
    return files_in(out);
  };
  const std::map<std::string, std::string> first = run("first");
  const std::map<std::string, std::string> second = run("second");
  for (const char* name : {"report.txt", "report.html", "report.pdf", "results.json",
                           "mechanism.svg", "plots/motion.gp"}) {
    INFO(name);
    CHECK(first.count(name) == 1);
  }
  REQUIRE(first.size() == second.size());
  for (const auto& [name, bytes] : first) {
    INFO(name);
    CHECK(second.count(name) == 1);
    CHECK((second.count(name) == 1 && bytes == second.at(name)));
  }
  CHECK(first.at("report.txt").find("2023-11-14") != std::string::npos);
  CHECK(first.at("report.html").find("2023-11-14") != std::string::npos);
}

TEST_CASE("a level is taken from the command line; full ends with the case file", "[files]") {
  const test::TemporaryFolder folder;
  std::size_t before = 0;
  for (const char* level : {"summary", "governing", "full"}) {
    INFO(level);
    const std::string out = (folder.path() / level).string();
    test::run_program({"verify", rig, "--out", out, "--no-plots", "--no-pdf", "--level", level});
    const std::string text = test::read_file(out + "/report.txt");
    CHECK(text.size() > before);
    before = text.size();
    const std::string last = "[fatigue]";
    REQUIRE(test::read_file(test::project_file(rig)).find(last) != std::string::npos);
    CHECK((text.find(last) != std::string::npos) == (std::string(level) == "full"));
  }
}

TEST_CASE("without pdflatex text, HTML, JSON and figures are written, with 4", "[files]") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder programs;
  link_programs(programs, {"gnuplot"});
  const Environment path("PATH", programs.path().string());
  const std::string out = (folder.path() / "out").string();
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", out});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("texlive-latex-base") != std::string::npos);
  for (const char* name : {"report.txt", "report.html", "results.json", "mechanism.svg"}) {
    INFO(name);
    CHECK(fs::exists(out + "/" + name));
  }
  CHECK_FALSE(fs::exists(out + "/report.pdf"));
}

TEST_CASE("a pdflatex that fails is reported with its first error line", "[files]") {
  const test::TemporaryFolder folder;
  const std::string fake = folder.write(
      "pdflatex", "#!/bin/sh\necho '! LaTeX Error: no fonts today.' > report.log\nexit 1\n");
  fs::permissions(fake, fs::perms::owner_all);
  const Environment path("PATH", folder.path().string() + ":" + std::getenv("PATH"));
  const std::string out = (folder.path() / "out").string();
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", out, "--no-plots"});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("no fonts today") != std::string::npos);
  CHECK(fs::exists(out + "/report.html"));
  CHECK_FALSE(fs::exists(out + "/report.pdf"));
}

TEST_CASE("without gnuplot no form speaks of figures that are not there", "[files]") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder programs;
  const Environment path("PATH", programs.path().string());
  const std::string out = (folder.path() / "out").string();
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", out, "--no-pdf"});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find("gnuplot-nox") != std::string::npos);
  CHECK(test::read_file(out + "/report.txt").find(".svg") == std::string::npos);
  CHECK(fs::exists(out + "/report.html"));
}

}  // namespace report_files_test
