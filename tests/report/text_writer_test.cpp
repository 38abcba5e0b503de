#include "boxbeam/report/text_writer.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"

namespace text_writer_test {

using namespace boxbeam::report;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Code points, which is what a letter of Latin or Greek takes on a terminal.
std::size_t letters_in(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

Document document_of(std::vector<Block> blocks) {
  Document document;
  document.title = "case";
  document.subtitle = "a case";
  document.date = "2026-11-21";
  document.program = "boxbeam";
  document.verdict = "PASS";
  document.chapters.push_back({"Chapter", std::move(blocks)});
  return document;
}

/// What the writer makes of the blocks, without what stands before them.
std::vector<std::string> lines_with(std::vector<Block> blocks) {
  std::vector<std::string> lines = lines_of(text_of(document_of(std::move(blocks))));
  const auto heading = std::find(lines.begin(), lines.end(), "1 Chapter");
  REQUIRE(heading != lines.end());
  lines.erase(lines.begin(), heading + 2);
  return lines;
}

bool contains(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

std::vector<Cell> row(const std::vector<std::string>& texts) {
  std::vector<Cell> cells;
  for (const std::string& text : texts) cells.push_back({text, {}});
  return cells;
}

}  // namespace

TEST_CASE("the title block says what was verified, by what, when, and the verdict", "[text]") {
  Document document = document_of({});
  document.input_sha256 = "85c7";
  document.facts.entries = {{"file", "rig.toml"}};
  document.governing = {
      "", {"factor"}, {row({"1.21"}), row({"0.98"})}, {Mark::passes, Mark::fails}};
  const std::vector<std::string> lines = lines_of(text_of(document));
  CHECK(lines[0] == "boxbeam: case, 2026-11-21");
  CHECK(lines[1] == "a case");
  CHECK(lines[3] == "VERDICT: PASS");
  CHECK(lines[5] == "  result  factor");
  CHECK(lines[6] == "  passes    1.21");
  CHECK(lines[7] == "  FAILS     0.98");
  CHECK(contains(lines, "  file          rig.toml"));
  CHECK(contains(lines, "  input sha256  85c7"));
}

TEST_CASE("a document without a governing table, and tables without rows or marks", "[text]") {
  Document document = document_of({Table{}, Table{"caption", {"a", "b"}, {}, {}}});
  CHECK(text_of(document).find("VERDICT: PASS\n\n") != std::string::npos);
  CHECK(text_of(document).find("input sha256") == std::string::npos);
  document.input_sha256 = "85c7";
  CHECK(text_of(document).find("VERDICT: PASS\n\n  input sha256") != std::string::npos);
  CHECK(text_of(document).find("  caption\n  a  b\n") != std::string::npos);
  document.governing = {"", {"value"}, {row({"1.21"})}, {}};
  CHECK(text_of(document).find("\n\n  value\n   1.21\n") != std::string::npos);
}

TEST_CASE("paragraphs, bullets and facts are wrapped at 110 columns and lose no word", "[text]") {
  std::string text;
  for (int i = 0; i < 80; ++i) text += "word" + std::to_string(i) + (i % 7 == 0 ? "  " : " ");
  for (Block block :
       {Block{Paragraph{text}}, Block{Bullets{{text}}}, Block{Facts{{{"name", text}}}}}) {
    const std::vector<std::string> lines = lines_with({std::move(block)});
    CHECK(lines.size() >= 5);
    std::vector<std::string> words;
    for (const std::string& line : lines) {
      CHECK(line.size() <= 110);
      std::istringstream stream(line);
      for (std::string word; stream >> word;) words.push_back(word);
    }
    for (int i = 0; i < 80; ++i) {
      CHECK(std::count(words.begin(), words.end(), "word" + std::to_string(i)) == 1);
    }
    // Every line but the last takes what it can.
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) CHECK(lines[i].size() > 110 - 8);
  }
}

TEST_CASE("a word longer than a line is broken and stays whole otherwise", "[text]") {
  const std::string word(500, 'x');
  const std::vector<std::string> lines = lines_with({Paragraph{"before " + word + " behind"}});
  std::string joined;
  for (const std::string& line : lines) {
    CHECK(line.size() <= 110);
    joined += line.substr(line.find_first_not_of(' '));
  }
  CHECK(joined.find(word) != std::string::npos);
}

TEST_CASE("columns stand below each other where letters are of several bytes", "[text]") {
  const Table table{
      "",
      {"name", "d [mm]"},
      {row({"Bolzen ø 25", "25.00"}), row({"Łożysko Σ", "7.5"}), row({"plain", "-3"})},
      {}};
  const std::vector<std::string> lines = lines_with({table});
  REQUIRE(lines.size() == 4);
  for (const std::string& line : lines) CHECK(letters_in(line) == letters_in(lines[0]));
  CHECK(lines[1] == "  Bolzen ø 25   25.00");
  CHECK(lines[2] == "  Łożysko Σ       7.5");
}

TEST_CASE("wide letters take two columns, combining marks none", "[text]") {
  const Table table{
      "", {"name", "n"}, {row({"\u6881", "1"}), row({"e\u0301", "1"}), row({"ab", "1"})}, {}};
  const std::vector<std::string> lines = lines_with({table});
  CHECK(lines[1] == "  \u6881    1");
  CHECK(lines[2] == "  e\u0301     1");
  CHECK(lines[3] == "  ab    1");
}

TEST_CASE("a row that fails begins with ! and one that does not apply with ?", "[text]") {
  const Table table{"",
                    {"a"},
                    {row({"one"}), row({"two"}), row({"three"})},
                    {Mark::passes, Mark::fails, Mark::not_applicable}};
  CHECK(lines_with({table}) == std::vector<std::string>{"  a", "  one", "! two", "? three"});
}

TEST_CASE("a table wider than the page wraps its texts, never its numbers", "[text]") {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "word" + std::to_string(i) + " ";
  const Table table{"",
                    {"a long title of a number column [mm]", "text", "more"},
                    {row({"-12345.678", text, text}), row({"1", "short", text})},
                    {}};
  const std::vector<std::string> lines = lines_with({table});
  for (const std::string& line : lines) CHECK(line.size() <= 110);
  CHECK(contains(lines, "-12345.678"));
  for (int i = 0; i < 30; ++i) CHECK(contains(lines, "word" + std::to_string(i)));
}

TEST_CASE("keys stay whole while texts can give way, else they break at a dot", "[text]") {
  const std::string key = "motion[0.357].newton_chain.steps.2.moment";
  std::string prose = "word";
  for (int i = 0; i < 30; ++i) prose += " word";
  Table table;
  table.header = {"result", "why", "number"};
  table.rows = {row({key, prose, "-12.5"})};
  CHECK(contains(lines_with({table}), "  " + key + "  "));
  // Three of them are too many for a line.
  table.header = {"a", "b", "c"};
  table.rows = {row({key, key, key})};
  const std::vector<std::string> lines = lines_with({table});
  for (const std::string& line : lines) CHECK(letters_in(line) <= 110);
  for (const std::string& line : lines) {
    if (line == lines.front()) continue;
    // Every piece ends where a name of the key ends, and none begins within a number.
    std::istringstream pieces(line);
    for (std::string piece; pieces >> piece;) {
      INFO(piece);
      const std::size_t at = key.find(piece);
      REQUIRE(at != std::string::npos);
      const std::size_t end = at + piece.size();
      CHECK((end == key.size() || key[end] == '.'));
      CHECK((at == 0 || piece.front() == '.'));
    }
  }
}

TEST_CASE("what would move a terminal's cursor is shown as an escape", "[text]") {
  const std::string hostile = "a\x1b[31mred\x07 \r\x7f \u202Eturned\u2066 \u009b2J \xff";
  const std::string shown = "a\\x1B[31mred\\x07";
  for (Block block :
       {Block{Paragraph{hostile}}, Block{Bullets{{hostile}}}, Block{Facts{{{hostile, hostile}}}},
        Block{Table{hostile, {hostile}, {row({hostile})}, {}}}, Block{Picture{"p", hostile}},
        Block{Listing{hostile}}, Block{Subheading{hostile}}}) {
    Document document = document_of({std::move(block)});
    document.title = document.subtitle = document.chapters[0].title = hostile;
    const std::string text = text_of(document);
    CHECK(text.find(shown) != std::string::npos);
    CHECK(text.find("\\u202E") != std::string::npos);
    CHECK(text.find("\\u2066") != std::string::npos);
    CHECK(text.find("\\x9B") != std::string::npos);
    CHECK(text.find("\\xFF") != std::string::npos);
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      CHECK((byte >= 0x20 || c == '\n'));
      CHECK(byte != 0x7f);
      CHECK(byte != 0xff);
    }
  }
}

TEST_CASE("a listing keeps lines, tabs and blank lines as they are", "[text]") {
  const std::vector<std::string> lines =
      lines_with({Listing{"[beam]\n\n\tlength = \"1 m\"  # two  blanks\n"}});
  CHECK(lines == std::vector<std::string>{"  [beam]", "", "  \tlength = \"1 m\"  # two  blanks"});
}

TEST_CASE("a picture is named by its file, and what moves is not mentioned", "[text]") {
  const std::vector<std::string> lines =
      lines_with({MovingPicture{{}, 0, "moves"}, Picture{"sn", "The S-N curve."}});
  CHECK(lines == std::vector<std::string>{"  Figure 1 [sn.svg]: The S-N curve."});
}

TEST_CASE("chapters are counted, and blocks stand apart but below their subheading", "[text]") {
  Document document = document_of({Subheading{"Under"}, Paragraph{"one"}, Paragraph{"two"}});
  document.chapters.push_back({"Second", {Paragraph{"three"}}});
  const std::string text = text_of(document);
  CHECK(text.find("\n1 Chapter\n---------\n  Under\n  one\n\n  two\n\n2 Second\n--------\n"
                  "  three\n") != std::string::npos);
}

}  // namespace text_writer_test
