// What a case says of itself stands in its reports.

#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/summary.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/clamped_beam.hpp"

namespace case_header_test {

using namespace boxbeam;

TEST_CASE("project, client, revision, standard and names stand on the first page") {
  Project project = test::clamped_beam(test::clamped::steady, "");
  project.header = {"Boom <7>",   "Works & Co",         "C_2", "EN 1993 with DIN NA", "A. Author",
                    "B. Checker", {"rail not modelled"}};
  const Verification verification = verify(project, Figures::without);
  const report::Document document = report_of(project, verification, ReportLevel::summary);
  const std::string text = report::text_of(document);
  for (const std::string words :
       {"Boom <7>", "Works & Co", "C_2", "EN 1993 with DIN NA", "prepared by   A. Author",
        "checked by    B. Checker", "- rail not modelled"}) {
    CAPTURE(words);
    CHECK(text.find(words) != std::string::npos);
  }
  const std::string page =
      report::html_of(document, [](const std::string&) { return std::optional<std::string>(); });
  CHECK(page.find("Boom &lt;7&gt;") != std::string::npos);
  CHECK(page.find("Works &amp; Co") != std::string::npos);
  const std::string tex = report::latex_of(document, [](const std::string&) { return false; });
  CHECK(tex.find("signfield{prepared: ") != std::string::npos);
  CHECK(tex.find("signfield{approved}") != std::string::npos);
}

TEST_CASE("without a header its entries do not stand there") {
  const Project project = test::clamped_beam(test::clamped::steady, "");
  const Verification verification = verify(project, Figures::without);
  const std::string text = report::text_of(report_of(project, verification, ReportLevel::summary));
  CHECK(text.find("client") == std::string::npos);
  CHECK(text.find("prepared by") == std::string::npos);
}

TEST_CASE("what a change did is said by criterion") {
  const auto verified = [](const char* required) {
    Project project = test::clamped_beam(test::clamped::steady, "");
    project.strength.required = std::stod(required);
    return std::pair{project, verify(project, Figures::without)};
  };
  const auto [project, before] = verified("1");
  const auto [stricter, now] = verified("1000");
  const std::string same = what_changed(before, project, before).text;
  CHECK(same.find("every criterion as before") != std::string::npos);
  CHECK(same.find("was") == std::string::npos);
  const std::string changed = what_changed(before, stricter, now).text;
  CHECK(changed.find("FAIL") != std::string::npos);
  CHECK(changed.find("(was pass)") != std::string::npos);
  CHECK(changed.find("yield") != std::string::npos);
  CHECK(changed.find("fatigue") == std::string::npos);
}

}  // namespace case_header_test
