// The damage of every row of a spectrum, with the loads as they are and partial factors applied.

#include <algorithm>
#include <cmath>

#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/checks.hpp"
#include "catch.hpp"
#include "support/shipped_cases.hpp"

using namespace boxbeam;

namespace {

const test::ShippedCase& case_of(const std::string& path) {
  return *std::find_if(test::shipped_cases().begin(), test::shipped_cases().end(),
                       [&](const test::ShippedCase& of) { return of.path.ends_with(path); });
}

std::string caption_of(const test::ShippedCase& of, const std::string& picture) {
  const report::Document document = report_of(of.project, of.verification);
  for (const report::Chapter& chapter : document.chapters) {
    for (const report::Block& block : chapter.blocks) {
      const auto* found = std::get_if<report::Picture>(&block);
      if (found != nullptr && found->name == picture) return found->caption;
    }
  }
  return "";
}

}  // namespace

TEST_CASE("the rows of a spectrum do the damage of its check, in all cases") {
  std::size_t seen = 0;
  for (const test::ShippedCase& of : test::shipped_cases()) {
    for (const CheckResult& result : of.verification.checks) {
      if (!result.basis || result.basis->spectrum.empty()) continue;
      CAPTURE(of.path, result.check.id);
      double sum = 0.0;
      for (const SpectrumRow& row : result.basis->spectrum) sum += row.damage;
      CHECK(sum == Approx(result.basis->damage).epsilon(1e-12));
      ++seen;
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("in the detailed rig normal running does the damage, not the rare over-stroke") {
  // Category 71, by hand: cut-off 71 (2/5)^(1/3) (5/100)^(1/5) = 28.7 MPa; 26.23 MPa times 1.35 is
  // 35.4 MPa, of which 5e6 (52.3/35.4)^5 = 3.52e7 cycles are endured; there are 1e8 of them.
  const test::ShippedCase& rig = case_of("rig-detailed.toml");
  const CheckBasis& basis = *rig.verification.governing(Criterion::fatigue)->basis;
  double running = 0.0;
  for (const SpectrumRow& row : basis.spectrum) {
    if (row.situation == "normal running") running += row.damage;
  }
  const double knee = 71.0 * std::cbrt(2.0 / 5.0);
  const double endured = 5e6 * std::pow(knee / (26.23 * 1.35), 5.0);
  CHECK(running == Approx(1e8 / endured).epsilon(2e-3));
  CHECK(running > 0.999 * basis.damage);
}

TEST_CASE("captions of ranges name the largest of all, and what is factored") {
  const test::ShippedCase& rig = case_of("rig-detailed.toml");
  const std::string spectrum = caption_of(rig, "spectrum");
  CAPTURE(spectrum);
  CHECK(spectrum.find("the largest is 31.47 MPa") != std::string::npos);
  CHECK(spectrum.find("without partial factors") != std::string::npos);
  CHECK(spectrum.find("26.23 MPa (normal running) does 100") != std::string::npos);
  const std::string sn = caption_of(rig, "sn");
  CAPTURE(sn);
  CHECK(sn.find("the largest range is 31.47 MPa") != std::string::npos);
  CHECK(sn.find("42.48 MPa") != std::string::npos);  // 31.47 x 1.35
}

TEST_CASE("of elastic links the loads are prescribed, and nothing else at rest is called so") {
  const test::ShippedCase& truck = case_of("truck.toml");
  CHECK(caption_of(truck, "motion").find("drivers prescribe") == std::string::npos);
  CHECK(caption_of(truck, "motion").find("prescribed loads") != std::string::npos);
  CHECK(caption_of(truck, "mechanism").find("unloaded") != std::string::npos);
  CHECK(caption_of(case_of("rig.toml"), "mechanism").find("at t = 0 ") != std::string::npos);
}
