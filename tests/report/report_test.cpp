#include "boxbeam/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "boxbeam/numerics/nine_digits.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/rig.hpp"
#include "support/shipped_cases.hpp"
#include "support/shown_figures.hpp"

namespace report_test {

using namespace boxbeam;
using namespace boxbeam::report;

namespace {

/// All that may stand in a report, in the order in which a reader needs it.
const std::vector<std::string> order{"Assumptions and remarks",
                                     "Model",
                                     "Inputs",
                                     "Mechanism",
                                     "Frame",
                                     "Motion",
                                     "Loads on the beam",
                                     "Cut forces",
                                     "Sections",
                                     "Stresses",
                                     "Governing checks",
                                     "Fatigue",
                                     "Checks",
                                     "Comparison",
                                     "Figures",
                                     "Appendix: the input"};

constexpr ReportLevel levels[] = {ReportLevel::summary, ReportLevel::governing, ReportLevel::full};

std::vector<std::string> titles_of(const Document& document) {
  std::vector<std::string> titles;
  for (const Chapter& chapter : document.chapters) titles.push_back(chapter.title);
  return titles;
}

template <class Kind, class Visit>
void for_each(const Document& document, Visit visit) {
  for (const Block& block : document.opening) {
    if (const Kind* of = std::get_if<Kind>(&block)) visit(*of);
  }
  for (const Chapter& chapter : document.chapters) {
    for (const Block& block : chapter.blocks) {
      if (const Kind* of = std::get_if<Kind>(&block)) visit(*of);
    }
  }
}

std::vector<Table> tables_of(const Document& document) {
  std::vector<Table> tables{document.governing};
  for_each<Table>(document, [&](const Table& table) { tables.push_back(table); });
  return tables;
}

std::set<std::string> pictures_of(const Document& document) {
  std::set<std::string> names;
  for_each<Picture>(document, [&](const Picture& picture) { names.insert(picture.name); });
  return names;
}

/// Everything that a reader finds: rows, sentences, pictures, sheets.
std::set<std::string> contents_of(const Document& document) {
  std::set<std::string> contents;
  for (const Table& table : tables_of(document)) {
    std::string above = table.caption;
    for (const std::string& title : table.header) above += "|" + title;
    for (const auto& row : table.rows) {
      std::string text = above;
      for (const report::Cell& cell : row) text += "|" + cell.text;
      contents.insert(std::move(text));
    }
  }
  for_each<Bullets>(document, [&](const Bullets& bullets) {
    contents.insert(bullets.items.begin(), bullets.items.end());
  });
  for_each<report::Facts>(document, [&](const report::Facts& facts) {
    for (const auto& [name, text] : facts.entries) contents.insert(name + ": " + text);
  });
  for_each<Picture>(document, [&](const Picture& picture) { contents.insert(picture.caption); });
  for_each<Sheet>(document, [&](const Sheet& sheet) { contents.insert("sheet " + sheet.id); });
  return contents;
}

const Table& checks_table(const Document& document) {
  const auto chapter = std::find_if(document.chapters.begin(), document.chapters.end(),
                                    [](const Chapter& of) { return of.title == "Checks"; });
  REQUIRE(chapter != document.chapters.end());
  for (const Block& block : chapter->blocks) {
    if (const Table* table = std::get_if<Table>(&block)) return *table;
  }
  throw std::runtime_error("no table of checks");
}

}  // namespace

TEST_CASE("reports of all cases have their chapters in the reader's order", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    for (const ReportLevel level : levels) {
      const Document document = report_of(of.project, of.verification, level);
      const std::vector<std::string> titles = titles_of(document);
      auto place = order.begin();
      for (const std::string& title : titles) {
        INFO(title);
        place = std::find(place, order.end(), title);
        REQUIRE(place != order.end());
      }
      for (const Chapter& chapter : document.chapters) CHECK_FALSE(chapter.blocks.empty());
    }
    const std::vector<std::string> titles = titles_of(report_of(of.project, of.verification));
    const bool at_rest = std::holds_alternative<frame::Structure>(of.project.mechanism);
    for (const char* always :
         {"Assumptions and remarks", "Model", "Inputs", at_rest ? "Frame" : "Mechanism", "Motion",
          "Loads on the beam", "Cut forces", "Stresses", "Governing checks", "Fatigue", "Checks"}) {
      INFO(always);
      CHECK(std::find(titles.begin(), titles.end(), always) != titles.end());
    }
    CHECK(std::find(titles.begin(), titles.end(), "Appendix: the input") == titles.end());
  }
}

TEST_CASE("what a level says, the next says as well", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    std::set<std::string> before;
    for (const ReportLevel level : levels) {
      const std::set<std::string> now = contents_of(report_of(of.project, of.verification, level));
      for (const std::string& part : before) {
        INFO(part);
        CHECK(now.count(part) == 1);
      }
      CHECK(now.size() > before.size());
      before = now;
    }
  }
}

TEST_CASE("tables have a cell below every title, and marks and sheets for every row", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    for (const ReportLevel level : levels) {
      const Document document = report_of(of.project, of.verification, level);
      std::set<std::string> sheets;
      for_each<Sheet>(document, [&](const Sheet& sheet) { sheets.insert(sheet.id); });
      for (const Table& table : tables_of(document)) {
        INFO(table.caption << " " << table.header.front());
        CHECK_FALSE(table.rows.empty());
        for (const auto& row : table.rows) REQUIRE(row.size() == table.header.size());
        CHECK((table.marks.empty() || table.marks.size() == table.rows.size()));
        CHECK((table.sheets.empty() || table.sheets.size() == table.rows.size()));
        for (const std::string& id : table.sheets) CHECK((id.empty() || sheets.count(id) == 1));
      }
    }
  }
}

TEST_CASE("where a number belongs there is one", "[report]") {
  const std::regex no_number("\\b(nan|inf|-nan|-inf)\\b");
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::full);
    for (const Table& table : tables_of(document)) {
      for (std::size_t k = 0; k < table.header.size(); ++k) {
        INFO(table.caption << ": " << table.header[k]);
        const bool with_unit = table.header[k].find('[') != std::string::npos;
        for (const auto& row : table.rows) {
          if (with_unit && table.header[k] != "inside [mm]") CHECK_FALSE(row[k].text.empty());
          if (row[k].value) CHECK(std::isfinite(*row[k].value));
        }
      }
    }
    const std::string text = text_of(document);
    CHECK_FALSE(std::regex_search(text, no_number));
    CHECK(text.find(" -0 ") == std::string::npos);
  }
}

TEST_CASE("a report shows the figures that are drawn and no others, each once", "[report]") {
  const auto none = [](const std::string&) { return false; };
  const auto only_mechanism = [](const std::string& name) { return name == "mechanism"; };
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::full);
    const std::vector<std::string> drawn = test::shown_figures(of.project, of.verification);
    const std::set<std::string> shown = pictures_of(document);
    CHECK(shown == std::set<std::string>(drawn.begin(), drawn.end()));
    std::size_t count = 0;
    for_each<Picture>(document, [&](const Picture& picture) {
      ++count;
      INFO(picture.caption);
      CHECK(picture.caption.back() == '.');
      CHECK(std::any_of(picture.caption.begin(), picture.caption.end(),
                        [](char c) { return c >= '0' && c <= '9'; }));
    });
    CHECK(count == shown.size());
    CHECK(pictures_of(with_pictures(document, none)).empty());
    CHECK(pictures_of(with_pictures(document, only_mechanism)) ==
          std::set<std::string>{"mechanism"});
    // A summary shows what decides.
    const Document summary = report_of(of.project, of.verification, ReportLevel::summary);
    for (const Chapter& chapter : with_pictures(summary, none).chapters) {
      CHECK_FALSE(chapter.blocks.empty());
    }
    for (const std::string& name : pictures_of(summary)) {
      CHECK((name == "mechanism" || name == "cut-forces" || name == "utilisation" || name == "sn"));
    }
    CHECK(pictures_of(summary).count("mechanism") == 1);
    CHECK(pictures_of(summary).count("cut-forces") == 1);
  }
}

TEST_CASE("the first page says in one sentence what governs and lists the largest cut forces",
          "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::governing);
    const Check& worst = of.verification.checks.front().check;
    INFO(document.sentence);
    CHECK(document.sentence.starts_with(of.verification.verdict == Verdict::pass ? "passes"
                                        : of.verification.verdict == Verdict::fail
                                            ? "fails in "
                                            : "not applicable: "));
    CHECK(document.sentence.find(text::percent(worst.utilisation()) + " used") !=
          std::string::npos);
    if (!worst.situation.empty())
      CHECK(document.sentence.find("under \"" + worst.situation + "\"") != std::string::npos);
    const std::string text = text_of(document);
    CHECK(text.find("Largest cut forces") < text.find("1 Assumptions"));

    // No station has a larger one, and each is there once.
    std::map<std::string, double> listed;
    for (const Block& block : document.opening) {
      const auto* table = std::get_if<Table>(&block);
      if (table == nullptr) continue;
      for (const auto& row : table->rows) {
        CHECK_FALSE(listed.contains(row[0].text));
        listed[row[0].text] = *row[1].value;
      }
    }
    for (const CutForceName& name : cut_forces_looked_at(of.project)) {
      double largest = 0.0;
      for (const StationEnvelope& station : of.verification.stations) {
        const Envelope& envelope = station.of[name.which];
        largest = std::max(
            {largest, std::abs(envelope.smallest.value), std::abs(envelope.largest.value)});
      }
      if (listed.contains(name.name)) CHECK(std::abs(listed.at(name.name)) == Approx(largest));
    }
    CHECK_FALSE(listed.empty());
  }
}

TEST_CASE("the moving picture stands where the cycle is known", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    std::size_t count = 0;
    for_each<MovingPicture>(report_of(of.project, of.verification),
                            [&](const MovingPicture&) { ++count; });
    CHECK(count == (of.verification.pictures.cycles.empty() ? 0 : 1));
  }
}

TEST_CASE("the moving picture offers every situation and begins with the governing one",
          "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    if (of.verification.pictures.cycles.empty()) continue;
    std::vector<std::string> running;
    for (const Situation& situation : of.project.situations) {
      if (situation.between.empty()) running.push_back(situation.name);
    }
    for_each<MovingPicture>(
        report_of(of.project, of.verification), [&](const MovingPicture& picture) {
          REQUIRE(picture.cycles.size() == running.size());
          for (std::size_t i = 0; i < running.size(); ++i) {
            CHECK(picture.cycles[i].situation == running[i]);
          }
          const auto worst =
              std::find_if(of.verification.checks.begin(), of.verification.checks.end(),
                           [](const CheckResult& result) { return result.basis.has_value(); });
          if (worst == of.verification.checks.end()) return;
          CHECK(picture.cycles.at(picture.first).situation ==
                of.project.situations[worst->basis->running].name);
        });
  }
}

TEST_CASE("where not every situation is offered, the moving picture says so", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    if (of.path != "sections/landing-gear/retraction.toml") continue;
    REQUIRE(of.verification.pictures.cycles.size() == 3);  // retraction, extension, landing
    Verification fewer = of.verification;
    fewer.pictures.cycles.erase(fewer.pictures.cycles.begin());
    for_each<MovingPicture>(report_of(of.project, fewer), [](const MovingPicture& picture) {
      INFO(picture.caption);
      CHECK(picture.caption.find("(2 of 3 situations are offered)") != std::string::npos);
      CHECK(picture.cycles.at(picture.first).situation == "landing");
    });
  }
}

TEST_CASE("joint forces grow without bound at resonance only where nothing damps",
          "[report][unsanitized]") {
  const std::string path = test::project_file("sections/drill-truck/truck.toml");
  for (const bool damped : {false, true}) {
    const std::vector<std::string> set =
        damped ? std::vector<std::string>{"model.damping={ ratio = 0.02, at = \"25 Hz\" }"}
               : std::vector<std::string>{};
    const Project project = read_project(path, set);
    std::string caption;
    for_each<Picture>(report_of(project, verify(project, Figures::with)),
                      [&](const Picture& picture) {
                        if (picture.name == "frequency-response") caption = picture.caption;
                      });
    INFO(caption);
    CHECK((caption.find("grows without bound") != std::string::npos) == !damped);
    CHECK((caption.find("as high as the damping lets it") != std::string::npos) == damped);
  }
}

TEST_CASE("in a full report every check has its row, the worst of a station its sheet",
          "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::full);
    const Table& table = checks_table(document);
    REQUIRE(table.rows.size() == of.verification.checks.size());
    std::map<std::string, int> sheets;
    std::set<std::pair<Criterion, std::string>> seen;
    for_each<Sheet>(document, [&](const Sheet& sheet) { ++sheets[sheet.id]; });
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const Check& check = of.verification.checks[i].check;
      // Worst first: the first of its criterion and place is the worst there.
      const std::string place = check.on_beam ? to_text(check.station) : check.point;
      const bool worst = seen.emplace(check.criterion, place).second;
      CHECK(sheets[check.id] == (worst ? 1 : 0));
      CHECK(table.sheets[i] == (worst ? check.id : ""));
      CHECK(table.rows[i][0].value == check.utilisation());
      CHECK(table.rows[i][1].value == check.safety_factor);
      CHECK(table.marks[i] == (check.passes() ? Mark::passes : Mark::fails));
      // Rounded to three digits: half a unit of the last is 0.5 % at most.
      CHECK(std::stod(table.rows[i][0].text) ==
            Approx(100.0 * check.utilisation()).epsilon(0.0051));
      CHECK(std::stod(table.rows[i][1].text) == Approx(check.safety_factor).epsilon(0.0051));
    }
  }
}

TEST_CASE("criteria that are used alike but for round-off stand as their checks do") {
  const Project project = test::rig();
  Verification verification = verify(project);
  std::vector<CheckResult>& checks = verification.checks;
  const auto other = std::find_if(checks.begin(), checks.end(), [&](const CheckResult& of) {
    return of.check.criterion != checks.front().check.criterion;
  });
  REQUIRE(other != checks.end());
  other->check.required = checks.front().check.required;
  other->check.safety_factor = checks.front().check.safety_factor * (1.0 - 1e-14);
  REQUIRE(other->check.utilisation() > checks.front().check.utilisation());
  const auto& rows = report_of(project, verification).governing.rows;
  CHECK(rows.at(0).front().text == to_text(checks.front().check.criterion));
  CHECK(rows.at(1).front().text == to_text(other->check.criterion));
}

TEST_CASE(
    "governing: the worst check of every criterion, all checks from 50 % on, the rest counted",
    "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification);
    std::set<std::string> criteria_shown;
    double before = 1e300;
    for (const auto& row : document.governing.rows) {
      criteria_shown.insert(row[0].text);
      CHECK(nine_digits(*row[1].value) <= before);
      before = nine_digits(*row[1].value);
    }
    std::set<std::string> all;
    std::size_t above = 0;
    for (const CheckResult& result : of.verification.checks) {
      all.insert(to_text(result.check.criterion));
      if (result.check.utilisation() >= 0.50) ++above;
    }
    CHECK(criteria_shown == all);
    const std::size_t shown = std::max<std::size_t>(above, 1);
    CHECK(checks_table(document).rows.size() == shown);
    // One row per criterion says how many are left and which is the worst of them.
    std::map<std::string, std::pair<std::size_t, double>> rest;
    for (std::size_t i = shown; i < of.verification.checks.size(); ++i) {
      const Check& check = of.verification.checks[i].check;
      auto& [count, highest] = rest[to_text(check.criterion)];
      ++count;
      highest = std::max(highest, check.utilisation());
    }
    for_each<Table>(document, [&](const Table& table) {
      if (table.header.size() < 2 || table.header[1] != "checks") return;
      CHECK(table.rows.size() == rest.size());
      for (const auto& row : table.rows) {
        CHECK(std::stoul(row[1].text) == rest[row[0].text].first);
        CHECK(nine_digits(*row[2].value) == nine_digits(rest[row[0].text].second));
        rest.erase(row[0].text);
      }
    });
    CHECK(rest.empty());
  }
}

TEST_CASE("the appendix is the case file as it was read, also where the file is gone", "[report]") {
  const std::string text = test::read_file(test::project_file("sections/sledge-rig/rig.toml"));
  const Project project = parse_project("gone.toml", text);
  CHECK(project.text == text);
  const Document document = report_of(project, verify(project), ReportLevel::full);
  const auto* listing = std::get_if<Listing>(&document.chapters.back().blocks.front());
  REQUIRE(listing != nullptr);
  CHECK(listing->text == text);
}

TEST_CASE("a stress range is never called an amplitude", "[report]") {
  // The codes have "constant amplitude" and "variable amplitude" in the names of loading, limit and
  // curve; a driver has one by its key.
  const std::regex allowed("([Cc]onstant[- ]|variable |[.])$");
  const std::regex word("amplitude", std::regex::icase);
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::full);
    std::set<std::string> texts = contents_of(document);
    for_each<Sheet>(document, [&](const Sheet& sheet) { texts.insert(text_of(sheet).text); });
    for_each<Paragraph>(document, [&](const Paragraph& of_text) { texts.insert(of_text.text); });
    for_each<Subheading>(document, [&](const Subheading& title) { texts.insert(title.text); });
    for (const std::string& text : texts) {
      const std::sregex_iterator end;
      for (std::sregex_iterator it(text.begin(), text.end(), word); it != end; ++it) {
        INFO(text);
        CHECK(std::regex_search(it->prefix().str(), allowed));
      }
    }
  }
}

TEST_CASE("what the category of a detail asks of the shop stands beside it", "[report]") {
  const Project project = read_project(test::project_file("sections/sledge-rig/rig-detailed.toml"));
  const std::set<std::string> said =
      contents_of(report_of(project, verify(project), ReportLevel::full));
  // EN 1993-1-9:2005, table 8.1, detail 4, requirements.
  const auto stands = [](const std::string& of) {
    return of.find("table 8.1, row 4") != std::string::npos &&
           of.find("no repair by filling with weld metal") != std::string::npos;
  };
  CHECK(std::count_if(said.begin(), said.end(), stands) == 1);
}

TEST_CASE("text keeps to its 110 columns", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    std::istringstream lines(text_of(report_of(of.project, of.verification)));
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK(line.size() <= 110);
    }
  }
}

TEST_CASE("the terminal's summary: verdict first, worst checks, few remarks", "[report]") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const std::string text = summary(of.project, of.verification).text;
    const std::string verdict = of.verification.verdict == Verdict::pass   ? "PASS"
                                : of.verification.verdict == Verdict::fail ? "FAIL"
                                                                           : "NOT APPLICABLE";
    CHECK(text.starts_with(verdict));
    // What is not judged stands between.
    const std::string first = text.substr(0, text.find(of.project.title + "\n"));
    CHECK((first == verdict + "  " || first.starts_with(verdict + "; ")));
    CHECK(std::count(text.begin(), text.end(), '\n') < 40);
    for (const CheckResult& result : of.verification.checks) {
      if (&result != of.verification.governing(result.check.criterion)) continue;
      CHECK(text.find(to_text(result.check.criterion)) != std::string::npos);
      // A long name goes on below.
      const std::string& point = result.check.point;
      CHECK(text.find(point.substr(0, point.find(' '))) != std::string::npos);
    }
    // What stops a verdict stands there, whatever the lines break at.
    const std::string words = std::regex_replace(text, std::regex("\\s+"), " ");
    for (const Gate& gate : of.verification.gates) {
      if (gate.blocks) CHECK(words.find(gate.finding.substr(0, 40)) != std::string::npos);
    }
    CHECK(words.find(" model ") != std::string::npos);
  }
}

TEST_CASE("the date is that of SOURCE_DATE_EPOCH, else today in UTC", "[report]") {
  const char* before = std::getenv("SOURCE_DATE_EPOCH");
  const std::string kept = before == nullptr ? "" : before;
  const auto date_at = [](const char* epoch) {
    ::setenv("SOURCE_DATE_EPOCH", epoch, 1);
    return report_date();
  };
  // By `date -u -d @SECONDS +%F`.
  CHECK(date_at("0") == "1970-01-01");
  CHECK(date_at("951782399") == "2000-02-28");
  CHECK(date_at("951782400") == "2000-02-29");
  CHECK(date_at("1700000000") == "2023-11-14");
  CHECK(date_at("253402300799") == "9999-12-31");
  const std::regex date("20\\d\\d-[01]\\d-[0-3]\\d");
  for (const char* no_epoch : {"", "yesterday", "12.5", "-1", "999999999999999"}) {
    INFO(no_epoch);
    CHECK(std::regex_match(date_at(no_epoch), date));
  }
  ::unsetenv("SOURCE_DATE_EPOCH");
  CHECK(std::regex_match(report_date(), date));
  if (before != nullptr) ::setenv("SOURCE_DATE_EPOCH", kept.c_str(), 1);
}

}  // namespace report_test
