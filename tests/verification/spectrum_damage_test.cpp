// The damage of every row of a spectrum, with the loads as they are and partial factors applied.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/checks.hpp"
#include "catch.hpp"
#include "support/shipped_cases.hpp"

namespace spectrum_damage_test {

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

/// By so much the weld at the box end bears more than the tube's own modulus says: of each flange
/// of the box, 50 mm thick, 27.60 mm are idle by shear lag (EN 1993-1-5, 3.2, kappa = 175/6200), so
/// that of I = 6.117e-3 m^4 of box and tube 0.2093e-3 m^4 do not work.
constexpr double by_idle_flanges = 6.117 / (6.117 - 0.2093);

TEST_CASE("in the detailed rig normal running does the damage, not the rare over-stroke") {
  // The root of the weld, category 36: its ranges with gamma_Mf = 1.35 lie above the knee
  // 36 (2/5)^(1/3) = 26.5 MPa, where 2e6 (36/range)^3 cycles are endured; there are 1e8 of them.
  const test::ShippedCase& rig = case_of("rig-detailed.toml");
  const CheckBasis& basis = *rig.verification.governing(Criterion::fatigue)->basis;
  double running = 0.0, range = 0.0;
  for (const SpectrumRow& row : basis.spectrum) {
    if (row.situation != "normal running") continue;
    running += row.damage;
    range = 1.35 * row.cycle.range.value() / 1e6;
  }
  // By hand: 26.23 MPa in the fibre of 290 x 490 mm, wall 56 mm, and the section moduli of that
  // tube and of a line of 40 mm around it, 0.00204203 and 0.00219568 m^4 at the same distance.
  CHECK(range == Approx(1.35 * 26.23 * 0.00204203 / 0.00219568 * by_idle_flanges).epsilon(2e-3));
  REQUIRE(range > 36.0 * std::cbrt(2.0 / 5.0));
  CHECK(running == Approx(1e8 / (2e6 * std::pow(36.0 / range, 3.0))).epsilon(1e-9));
  CHECK(running > 0.999 * basis.damage);
}

TEST_CASE("captions of ranges name the largest of all, and what is factored") {
  const test::ShippedCase& rig = case_of("rig-detailed.toml");
  const CheckBasis& basis = *rig.verification.governing(Criterion::fatigue)->basis;
  double largest = 0.0, running = 0.0;
  for (const SpectrumRow& row : basis.spectrum) {
    const double range = row.cycle.range.value() / 1e6;
    largest = std::max(largest, range);
    if (row.situation == "normal running") running = std::max(running, range);
  }
  // Of the over-stroke.
  CHECK(largest == Approx(31.47 * 0.00204203 / 0.00219568 * by_idle_flanges).epsilon(2e-3));
  const std::string spectrum = caption_of(rig, "spectrum");
  CAPTURE(spectrum);
  CHECK(spectrum.find(fmt::format("the largest is {:.4g} MPa", largest)) != std::string::npos);
  CHECK(spectrum.find("without partial factors") != std::string::npos);
  CHECK(spectrum.find(fmt::format("{:.4g} MPa (normal running) does 100", running)) !=
        std::string::npos);
  const std::string sn = caption_of(rig, "sn");
  CAPTURE(sn);
  CHECK(sn.find(fmt::format("the largest range is {:.4g} MPa", largest)) != std::string::npos);
  CHECK(sn.find(fmt::format("{:.4g} MPa", 1.35 * largest)) != std::string::npos);
}

TEST_CASE("of elastic links the loads are prescribed, and nothing else at rest is called so") {
  const test::ShippedCase& truck = case_of("truck.toml");
  CHECK(caption_of(truck, "motion").find("drivers prescribe") == std::string::npos);
  CHECK(caption_of(truck, "motion").find("prescribed loads") != std::string::npos);
  CHECK(caption_of(truck, "mechanism").find("unloaded") != std::string::npos);
  CHECK(caption_of(case_of("rig.toml"), "mechanism").find("at t = 0 ") != std::string::npos);
}

}  // namespace spectrum_damage_test
