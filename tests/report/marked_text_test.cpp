// Words that say a result are marked where they stand, whatever is written around them.

#include "boxbeam/report/marked_text.hpp"

#include "boxbeam/report/report.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/shipped_cases.hpp"

namespace marked_text_test {

using namespace boxbeam;
using report::Mark;
using report::MarkedText;

namespace {

std::string word_in(const MarkedText& text, const MarkedText::Word& word) {
  return text.text.substr(word.begin, word.end - word.begin);
}

}  // namespace

TEST_CASE("marked words stay where they stand when texts are joined") {
  MarkedText text("three checks: ");
  text += {"FAILS", Mark::fails};
  text += ", ";
  MarkedText more("one ");
  more += {"passes", Mark::passes};
  text += more;
  CHECK(text.text == "three checks: FAILS, one passes");
  REQUIRE(text.words.size() == 2);
  CHECK(word_in(text, text.words[0]) == "FAILS");
  CHECK(text.words[0].mark == Mark::fails);
  CHECK(word_in(text, text.words[1]) == "passes");
  CHECK(text.words[1].mark == Mark::passes);
}

TEST_CASE("a summary marks its verdict and the result of every criterion, a sheet its last word") {
  for (const test::ShippedCase& of : test::shipped_cases()) {
    CAPTURE(of.path);
    const MarkedText text = summary(of.project, of.verification);
    std::size_t criteria_checked = 0;
    for (const Criterion criterion : criteria)
      criteria_checked += of.verification.governing(criterion) != nullptr ? 1 : 0;
    REQUIRE(text.words.size() == 1 + criteria_checked);
    const Verdict verdict = of.verification.verdict;
    CHECK(text.words.front().begin == 0);
    CHECK(word_in(text, text.words.front()) == (verdict == Verdict::pass   ? "PASS"
                                                : verdict == Verdict::fail ? "FAIL"
                                                                           : "NOT APPLICABLE"));
    for (std::size_t i = 1; i < text.words.size(); ++i)
      CHECK(word_in(text, text.words[i]) == report::to_text(text.words[i].mark));
    const CheckResult& worst = of.verification.checks.front();
    const MarkedText sheet = report::text_of(sheet_of(of.project, of.verification, worst), 80);
    REQUIRE(sheet.words.size() == 1);
    CHECK(word_in(sheet, sheet.words.front()) == (worst.check.passes() ? "passes" : "FAILS"));
    CHECK(sheet.text[sheet.words.front().end] == '\n');
  }
}

}  // namespace marked_text_test
