#include "boxbeam/report/latex_writer.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "catch.hpp"
#include "support/refusals.hpp"

namespace latex_writer_test {

using test::contains;
using namespace boxbeam::report;

namespace {

Document small_document() {
  Document document;
  document.title = "a_b & c";
  document.subtitle = "100 % of #1";
  document.date = "2026-11-21";
  document.program = "boxbeam 0.1.0";
  document.input_sha256 = std::string(64, 'a');
  document.verdict = "FAIL";
  document.mark = Mark::fails;
  document.governing = {
      "worst", {"criterion", "factor"}, {{{"yield", {}}, {"1.21", 1.21}}}, {Mark::fails}};
  return document;
}

std::string latex_without_figures(const Document& document) {
  return latex_of(document, [](const std::string&) { return false; });
}

}  // namespace

TEST_CASE("the ten special characters of LaTeX are escaped", "[report][latex]") {
  // Source: L. Lamport, LaTeX: A Document Preparation System, 2nd ed., 2.1: # $ % & ~ _ ^ \ { }.
  CHECK(latex_escaped("#$%&_{}") == "\\#\\$\\%\\&\\_\\{\\}");
  CHECK(latex_escaped("~") == "\\textasciitilde{}");
  CHECK(latex_escaped("^") == "\\textasciicircum{}");
  CHECK(latex_escaped("\\") == "\\textbackslash{}");
}

TEST_CASE("no two signs are joined that the fonts would join", "[report][latex]") {
  // Ligatures of encoding T1. Source: LaTeX2e font encodings (fntguide), T1: -- --- ,, << >> `` ''.
  for (const std::string pair : {"--", ",,", "<<", ">>", "``", "''", "?`", "!`"}) {
    INFO(pair);
    CHECK(latex_escaped(pair).find(pair) == std::string::npos);
  }
}

TEST_CASE("a bracket or star cannot become an argument of the row before", "[report][latex]") {
  CHECK(latex_escaped("[2pt]*") == "{[}2pt{]}{*}");
}

TEST_CASE("what would not be seen stands as its code", "[report][latex]") {
  CHECK(latex_escaped(std::string("\x07\x1b\x7f\0", 4)) ==
        "\\textbackslash{}x07\\textbackslash{}x1B\\textbackslash{}x7F\\textbackslash{}x00");
  CHECK(contains(latex_escaped("\xE4\xB8\xAD"), "U+4E2D"));
  CHECK(contains(latex_escaped("\xE2\x80\xAE"), "\\textbackslash{}u202E"));
  CHECK(contains(latex_escaped("\xF0\x9F\x98\x80"), "U+1F600"));
}

TEST_CASE("bytes that are no UTF-8 stand as such", "[report][latex]") {
  // Source: M. Kuhn, UTF-8 decoder capability and stress test, 3.1 (unexpected continuation bytes),
  // 3.3 (sequences cut short), 4.1 (overlong "/"), 5.1 (surrogates).
  const std::string byte = "\\textbackslash{}x";
  CHECK(latex_escaped("a\x80") == "a" + byte + "80");
  CHECK(latex_escaped("\xC3") == byte + "C3");
  CHECK(latex_escaped("\xC0\xAF") == byte + "C0" + byte + "AF");
  CHECK(latex_escaped("\xED\xA0\x80") == byte + "ED" + byte + "A0" + byte + "80");
}

TEST_CASE("a hyphen before a number is set as a minus and copied as a hyphen", "[report][latex]") {
  CHECK(latex_escaped("-27.66") == "\\as{002D}{\\textminus}27.66");
  CHECK(latex_escaped("fibre -z") == "fibre \\as{002D}{\\textminus}z");
  CHECK(latex_escaped("EN 1993-1-9") == "EN 1993-{}1-{}9");
  CHECK(latex_escaped("4.7- m") == "4.7-{} m");
  CHECK(latex_escaped("cut-forces") == "cut-{}forces");
}

TEST_CASE("every sign that has a glyph is told from every other", "[report][latex]") {
  std::map<std::string, std::string> first;
  const auto take = [&first](const std::string& sign) {
    const auto [at, is_new] = first.emplace(latex_escaped(sign), sign);
    INFO(sign << " and " << at->second);
    CHECK(is_new);
  };
  for (int c = 0x21; c < 0x7F; ++c) take(std::string(1, static_cast<char>(c)));
  for (unsigned c = 0xA0; c < 0x800; ++c)
    take({static_cast<char>(0xC0U | (c >> 6U)), static_cast<char>(0x80U | (c & 0x3FU))});
}

TEST_CASE("what a user wrote is escaped wherever a report has it", "[report][latex]") {
  const std::string hostile = "\\input{/etc/passwd}%$&";
  const std::string safe = latex_escaped(hostile);
  Document document = small_document();
  document.title = document.subtitle = document.program = document.input_sha256 = hostile;
  document.facts.entries = {{hostile, hostile}};
  document.governing = {hostile, {hostile}, {{{hostile, {}}}}, {}};
  Chapter chapter{hostile, {}};
  chapter.blocks = {
      Paragraph{hostile},
      Bullets{{hostile}},
      Facts{{{hostile, hostile}}},
      Table{hostile, {hostile}, {{{hostile, {}}}}, {}},
      Picture{"there", hostile},
      Sheet{hostile, hostile, {{hostile, {hostile}, {hostile}}}, hostile, 1, {}, hostile},
      Listing{hostile},
      Subheading{hostile}};
  document.chapters = {chapter};
  const std::string latex = latex_of(document, [](const std::string&) { return true; });
  CHECK_FALSE(contains(latex, "\\input"));
  CHECK_FALSE(contains(latex, "passwd}%"));
}

TEST_CASE("failing rows are marked by a sign, not by colour only", "[report][latex]") {
  Document document = small_document();
  CHECK(contains(latex_without_figures(document), "\\textbf{!}} & yield & 1.21"));
  document.governing.marks = {Mark::passes};
  CHECK_FALSE(contains(latex_without_figures(document), "\\textbf{!}"));
}

TEST_CASE("columns of numbers stand at the right", "[report][latex]") {
  const std::string latex = latex_without_figures(small_document());
  CHECK(contains(latex, ">{\\Left}p{"));
  CHECK(contains(latex, ">{\\Right}p{"));
}

TEST_CASE("names of points and empty cells are no numbers", "[report][latex]") {
  for (const std::string cell : {"-z", "+y web", "", "4.2 m", "-", "+1"}) {
    INFO(cell);
    Document document = small_document();
    document.governing = {"", {"one"}, {{{cell, {}}}, {{"-27.66", {}}}}, {}};
    const bool number = cell == "4.2 m" || cell == "-" || cell == "+1";
    CHECK(contains(latex_without_figures(document), ">{\\Right}p{") == number);
  }
}

TEST_CASE("a document of few chapters needs no contents", "[report][latex]") {
  Document document = small_document();
  document.chapters.assign(3, {"Text", {Paragraph{"words"}}});
  CHECK_FALSE(contains(latex_without_figures(document), "\\contentsentry{1}"));
  document.chapters.assign(9, {"Text", {Paragraph{"words"}}});
  CHECK(contains(latex_without_figures(document), "\\contentsentry{1}"));
}

TEST_CASE("a figure that was not drawn is left out", "[report][latex]") {
  Document document = small_document();
  document.chapters = {{"Pictures", {Picture{"there", "one"}, Picture{"missing", "two"}}}};
  const std::string latex =
      latex_of(document, [](const std::string& name) { return name == "there"; });
  CHECK(contains(latex, "\\takefigure{there}"));
  CHECK_FALSE(contains(latex, "missing"));
}

}  // namespace latex_writer_test
