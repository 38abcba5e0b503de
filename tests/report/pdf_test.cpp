#include "boxbeam/report/pdf.hpp"

#include <rapidcheck.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "boxbeam/report/report.hpp"
#include "catch.hpp"
#include "support/latex.hpp"
#include "support/program.hpp"
#include "support/property.hpp"
#include "support/shipped_cases.hpp"

namespace pdf_test {

using namespace boxbeam::report;
using boxbeam::report_of;
using boxbeam::ReportLevel;

namespace {

namespace fs = std::filesystem;

Table table_of(std::size_t columns, std::size_t rows, const std::string& text) {
  Table table{text, {}, {}, {}};
  for (std::size_t k = 0; k < columns; ++k) table.header.push_back(text + " [kN m]");
  for (std::size_t i = 0; i < rows; ++i) {
    table.rows.emplace_back(columns, Cell{i % 2 == 0 ? text : "-1234.5", {}});
    table.marks.push_back(i % 3 == 0 ? Mark::fails : Mark::passes);
  }
  return table;
}

Sheet sheet_of_steps(int steps) {
  Sheet sheet{"yield/4.2/fibre+z",
              "yield at s = 4.2 m, fibre +z",
              {},
              "factor 1.21, required 2.00, utilisation 165 %",
              1.65,
              Mark::fails,
              "EN 1993-1-1:2005, 6.2.1(5)"};
  for (int i = 0; i < steps; ++i) {
    sheet.steps.push_back(
        {"sigma_max",
         {"N/A_eff + M_y z/I_y,eff",
          "(-27.66 kN)/(87240 mm^2) + (-215.6 kN m) 300.0 mm/(3.8657e9 mm^4)", "-17.05 MPa"},
         {"at t = 0.3571 s"}});
  }
  return sheet;
}

/// A document with something of everything.
Document document_of(const std::string& text, int size = 30) {
  Document document;
  document.title = document.subtitle = text;
  document.date = "2026-11-21";
  document.program = "boxbeam 0.1.0";
  document.input_sha256 = std::string(64, 'c');
  document.verdict = "FAIL";
  document.mark = Mark::fails;
  document.facts.entries = {{"file", "sections/some/where.toml"}, {text, text}};
  document.governing = table_of(4, 4, text);
  Chapter chapter{text, {}};
  chapter.blocks = {Subheading{text},
                    Paragraph{text},
                    Bullets{{text, text}},
                    table_of(1, 2, text),
                    table_of(7, 2 * static_cast<std::size_t>(size), text),
                    Subheading{text},
                    sheet_of_steps(size),
                    sheet_of_steps(1),
                    Listing{text + "\n  " + text},
                    Picture{"missing", text},
                    Facts{{{text, text}}}};
  document.chapters = {chapter, chapter};
  return document;
}

std::string latex_without_figures(const Document& document) {
  return latex_of(document, [](const std::string&) { return false; });
}

/// The lines of a document's PDF as they stand on its pages, without spaces.
std::vector<std::string> lines_of_pdf(const Document& document) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, "", path);
  std::istringstream text(test::text_of_pdf(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(test::without_spaces(line));
  return lines;
}

/// Whether a line has all of these one behind the other.
bool has_in_order(const std::string& line, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    at = line.find(part, at);
    if (at == std::string::npos) return false;
    at += part.size();
  }
  return true;
}

/// The numbers of a row.
std::vector<std::string> numbers_of(const std::vector<Cell>& row) {
  std::vector<std::string> numbers;
  for (const Cell& cell : row) {
    const std::size_t digit = cell.text.find_first_of("0123456789");
    if (digit == 0 || (digit == 1 && (cell.text[0] == '-' || cell.text[0] == '+')))
      numbers.push_back(test::without_spaces(cell.text));
  }
  return numbers;
}

/// A step whose parts are `size` digits long.
Document document_of_step(std::size_t size) {
  const std::string digits(size, '7');
  Sheet sheet{"id", "a sheet", {}, "factor 1.21", 0.5, Mark::passes, ""};
  sheet.steps = {{"a", {"b + 1" + digits, "2" + digits, "3" + digits}, {"noted beside"}}};
  Document document;
  document.chapters = {{"Sheets", {sheet}}};
  return document;
}

}  // namespace

TEST_CASE("the same document gives the same PDF, byte for byte", "[report][pdf]") {
  if (!test::has_pdflatex()) return;
  const test::TemporaryFolder folder;
  const std::string first = (folder.path() / "one" / "report.pdf").string();
  const std::string second = (folder.path() / "two" / "other.pdf").string();
  write_pdf(document_of("a case"), "", first);
  write_pdf(document_of("a case"), "", second);
  const std::string pdf = test::read_file(first);
  CHECK(pdf.starts_with("%PDF-"));
  CHECK(pdf == test::read_file(second));
  // Nothing else is left beside it.
  CHECK(std::distance(fs::directory_iterator(folder.path() / "one"), fs::directory_iterator()) ==
        1);
}

TEST_CASE("nothing stands out of the page", "[report][pdf]") {
  if (!test::has_pdflatex()) return;
  for (const std::string& text :
       {std::string("fatigue"),
        std::string("at s = 4.2 m, fibre +z, t = 0.3571 s of the situation"), std::string(60, 'w'),
        "sections/sledge-rig/" + std::string(70, '_') + "rig.toml", std::string(200, '-'),
        std::string("\xE4\xB8\xAD\xE6\x96\x87\xE4\xB8\xAD\xE6\x96\x87")}) {
    INFO(text);
    const test::LatexRun run = test::run_latex(latex_without_figures(document_of(text)));
    CHECK(run.exit_code == 0);
    CHECK(run.too_wide.empty());
  }
}

TEST_CASE("tables of any number of columns fit the page", "[report][pdf]") {
  if (!test::has_pdflatex()) return;
  for (const std::size_t columns : {1, 5, 9, 14}) {
    Document document;
    document.chapters = {{"Tables",
                          {table_of(columns, 3, "word"), table_of(columns, 3, "1234567.8"),
                           table_of(columns, 3, "a text of several words that must wrap")}}};
    INFO(columns);
    const test::LatexRun run = test::run_latex(latex_without_figures(document));
    CHECK(run.exit_code == 0);
    CHECK(run.too_wide.empty());
  }
}

TEST_CASE("no report of a shipped case stands out of the page", "[report][pdf][shipped]") {
  if (!test::has_pdflatex()) return;
  for (const test::ShippedCase& of : test::shipped_cases()) {
    INFO(of.path);
    const Document document = report_of(of.project, of.verification, ReportLevel::governing);
    const test::LatexRun run = test::run_latex(latex_without_figures(document));
    CHECK(run.exit_code == 0);
    CHECK(run.too_wide.empty());
  }
}

TEST_CASE("every number of a report's tables stands in its PDF", "[report][pdf][shipped]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const test::ShippedCase& rig = test::shipped_cases().front();
  const Document document = report_of(rig.project, rig.verification, ReportLevel::governing);
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, "", path);
  const std::string text = test::text_of_pdf(path);
  int numbers = 0;
  const auto check_table = [&](const Table& table) {
    for (const std::vector<Cell>& row : table.rows) {
      for (const Cell& cell : row) {
        if (!cell.value || cell.text.find(' ') != std::string::npos) continue;
        INFO(table.caption << ": " << cell.text);
        CHECK(text.find(cell.text) != std::string::npos);
        ++numbers;
      }
    }
  };
  check_table(document.governing);
  for (const Chapter& chapter : document.chapters) {
    for (const Block& block : chapter.blocks) {
      if (const auto* table = std::get_if<Table>(&block)) check_table(*table);
    }
  }
  CHECK(numbers > 100);
}

TEST_CASE("a row of a table is a line with all its numbers", "[report][pdf][shipped]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  int rows = 0;
  for (const test::ShippedCase& of : test::shipped_cases()) {
    const bool rig = of.path == "sections/sledge-rig/rig.toml";
    if (!rig && of.path != "sections/landing-gear/retraction.toml") continue;
    const Document document = report_of(of.project, of.verification, ReportLevel::governing);
    const std::vector<std::string> lines = lines_of_pdf(document);
    for (const Chapter& chapter : document.chapters) {
      if (!rig && chapter.title != "Loads on the beam") continue;
      for (const Block& block : chapter.blocks) {
        const auto* table = std::get_if<Table>(&block);
        if (table == nullptr) continue;
        for (const std::vector<Cell>& row : table->rows) {
          const std::vector<std::string> numbers = numbers_of(row);
          INFO(of.path << ", " << chapter.title << ": "
                       << Catch::StringMaker<std::vector<std::string>>::convert(numbers));
          CHECK(std::any_of(lines.begin(), lines.end(),
                            [&](const std::string& line) { return has_in_order(line, numbers); }));
          ++rows;
        }
      }
    }
  }
  CHECK(rows > 100);
}

TEST_CASE("a step stands on one line where it fits", "[report][pdf]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const std::vector<std::string> lines = lines_of_pdf(document_of_step(3));
  CHECK(std::count(lines.begin(), lines.end(), "a=b+1777=2777=3777notedbeside") == 1);
}

TEST_CASE("a step too long for a line is broken before its equals signs", "[report][pdf]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const std::string digits(60, '7');
  const std::vector<std::string> lines = lines_of_pdf(document_of_step(digits.size()));
  for (const std::string& line : {"a=b+1" + digits, "=2" + digits, "=3" + digits + "notedbeside"}) {
    INFO(line);
    CHECK(std::count(lines.begin(), lines.end(), line) == 1);
  }
}

TEST_CASE("a summary is two pages, three at most", "[report][pdf][shipped][unsanitized]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  for (const std::string& path : test::shipped_paths()) {
    const test::TemporaryFolder folder;
    test::run_program({"verify", test::project_file(path), "--level", "summary", "--no-html",
                       "--quiet", "--out", folder.path().string()});
    const std::string text = test::text_of_pdf((folder.path() / "report.pdf").string());
    const auto pages = std::count(text.begin(), text.end(), '\f');  // one ends each page
    INFO(path);
    CHECK(pages > 0);
    CHECK(pages <= (path == "sections/sledge-rig/rig.toml" ? 2 : 3));
  }
}

TEST_CASE("figures are numbered through, those beside each other as well", "[report][pdf]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const test::TemporaryFolder folder;
  Document figure;
  figure.title = "of the figure";
  write_pdf(figure, "", (folder.path() / "figures" / "page.pdf").string());
  Document document;
  document.title = "numbers";
  document.chapters = {{"First", {Picture{"page", "first caption"}, Paragraph{"words"}}},
                       {"Second", {Picture{"page", "second caption"}}}};
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, (folder.path() / "figures").string(), path);
  const std::string text = test::text_of_pdf(path);
  CAPTURE(text);
  CHECK(text.find("Figure 1. first caption") != std::string::npos);
  CHECK(text.find("Figure 2. second caption") != std::string::npos);
}

TEST_CASE("a figure waits where a page has no room for it", "[report][pdf]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const test::TemporaryFolder folder;
  Document figure;  // a page as a figure
  figure.title = "of the figure";
  write_pdf(figure, "", (folder.path() / "figures" / "page.pdf").string());
  // Of a page two thirds are full, then comes a figure of at least a quarter, then words.
  Document document;
  Listing listing;
  for (int i = 0; i < 45; ++i) listing.text += "line\n";
  document.chapters = {
      {"First", {listing, Picture{"page", "a caption"}, Paragraph{"words behind"}}},
      {"Second", {Paragraph{"words of the second"}}}};
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, (folder.path() / "figures").string(), path);
  const std::string text = test::text_of_pdf(path);
  const std::size_t page_end = text.find('\f');
  CHECK(text.find("words behind") < page_end);
  CHECK(text.find("a caption") > page_end);
  CHECK(text.find("a caption") < text.find("words of the second"));
}

TEST_CASE("every text makes a PDF", "[report][pdf][property]") {
  if (!test::has_pdflatex()) return;
  // Any byte, and signs that LaTeX or its fonts treat in their own way, put together at random.
  // Many texts share a document: starting pdflatex costs more than any of them.
  const auto piece = rc::gen::oneOf(rc::gen::container<std::string>(rc::gen::arbitrary<char>()),
                                    rc::gen::elementOf(std::vector<std::string>{"\\",
                                                                                "{",
                                                                                "}",
                                                                                "$",
                                                                                "%",
                                                                                "^^M",
                                                                                "^^5c",
                                                                                "\\end{document}",
                                                                                "\\\\[",
                                                                                "]",
                                                                                "*",
                                                                                "--",
                                                                                "``",
                                                                                "?`",
                                                                                "\n\n",
                                                                                "\t",
                                                                                " ",
                                                                                "\xC3\xB8",
                                                                                "\xC5\x82",
                                                                                "\xCE\xA3",
                                                                                "\xE2\x89\xA4",
                                                                                "\xC2\xB1",
                                                                                "\xE4\xB8\xAD",
                                                                                "\xCC\x81",
                                                                                "\xEF\xBB\xBF",
                                                                                "\\par",
                                                                                "&",
                                                                                "#1",
                                                                                "~",
                                                                                "_",
                                                                                "\"",
                                                                                "'"}));
  test::holds(
      [&] {
        const auto texts =
            *rc::gen::resize(12, rc::gen::container<std::vector<std::vector<std::string>>>(
                                     8, rc::gen::container<std::vector<std::string>>(piece)));
        Document document;
        for (const std::vector<std::string>& pieces : texts) {
          std::string text;
          for (const std::string& each : pieces) text += each;
          std::vector<Chapter> before = std::move(document.chapters);
          document = document_of(text, 3);
          document.chapters.pop_back();
          document.chapters.insert(document.chapters.end(), before.begin(), before.end());
        }
        const test::LatexRun run = test::run_latex(latex_without_figures(document));
        RC_LOG() << run.first_error << '\n';
        for (const std::string& line : run.too_wide) RC_LOG() << line << '\n';
        RC_ASSERT(run.exit_code == 0);
        RC_ASSERT(run.too_wide.empty());
      },
      15);
}

TEST_CASE("the PDF says what was written", "[report][pdf]") {
  if (!test::has_pdflatex() || !test::has_pdftotext()) return;
  const std::string text =
      "#$%&_{}~^\\\"'`<>| -- << >> ,, ?` !` \xC3\xB8 \xC5\x82 \xC5\x91 \xCE\xA3 \xCF\x83 \xCE\x94 "
      "\xC2\xB1 \xC3\x97 \xC2\xB7 \xC2\xB0 \xE2\x89\xA4 \xC2\xBD \xE2\x88\x9E \xE2\x86\x92 "
      "\xE2\x80\xA6 -12.5 U+4E2D";
  Document document;
  document.chapters = {{"Text", {Table{"", {"one"}, {{{text, {}}}}, {}}}}};
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, "", path);
  CHECK(test::without_spaces(test::text_of_pdf(path)).find(test::without_spaces(text)) !=
        std::string::npos);
}

TEST_CASE("a figure beside the report is in it, in its own size at most", "[report][pdf]") {
  if (!test::has_pdflatex()) return;
  const test::TemporaryFolder folder;
  // A report is a figure as good as any other: it is larger than the text of a page.
  Document page;
  page.title = "figure";
  write_pdf(page, "", (folder.path() / "figures" / "large.pdf").string());
  Document document = page;
  document.chapters = {{"Figures", {Picture{"large", "a page on a page"}, Picture{"none", "no"}}}};
  const std::string path = (folder.path() / "report.pdf").string();
  write_pdf(document, (folder.path() / "figures").string(), path);
  const auto with_figure = fs::file_size(path);
  write_pdf(document, "", path);
  CHECK(with_figure > fs::file_size(path));
}

TEST_CASE("where pdflatex is missing the message names the packages", "[report][pdf]") {
  const test::TemporaryFolder folder;
  const std::string stale = folder.write("report.pdf", "of an earlier run");
  const char* set = std::getenv("PATH");
  const std::string path = set != nullptr ? set : "";
  ::setenv("PATH", folder.path().c_str(), 1);
  CHECK_THROWS_AS(write_pdf(document_of("a"), "", stale), boxbeam::OutputError);
  try {
    write_pdf(document_of("a"), "", stale);
  } catch (const boxbeam::OutputError& error) {
    CHECK(std::string(error.what()).find("texlive-latex-recommended") != std::string::npos);
  }
  ::setenv("PATH", path.c_str(), 1);
  // What becomes of it is for whoever replaces the whole report.
  CHECK(test::read_file(stale) == "of an earlier run");
}

TEST_CASE("where pdflatex fails its first error is shown and its log kept", "[report][pdf]") {
  if (!test::has_pdflatex()) return;
  const test::TemporaryFolder folder;
  folder.write("broken.pdf", "no PDF");
  Document document;
  document.chapters = {{"Figures", {Picture{"broken", "cannot be read"}}}};
  const std::string path = (folder.path() / "out" / "report.pdf").string();
  std::string message;
  try {
    write_pdf(document, folder.path().string(), path);
  } catch (const boxbeam::OutputError& error) {
    message = error.what();
  }
  CHECK(message.find("pdflatex failed: !") != std::string::npos);
  CHECK(message.find((folder.path() / "out" / "report.log").string()) != std::string::npos);
  CHECK(fs::exists(folder.path() / "out" / "report.log"));
  CHECK_FALSE(fs::exists(path));
}

}  // namespace pdf_test
