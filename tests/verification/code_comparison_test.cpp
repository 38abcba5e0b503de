// The same stress ranges under several codes, by the equations of their curves.

#include "boxbeam/verification/code_comparison.hpp"

#include <cmath>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace code_comparison_test {

using namespace boxbeam;

namespace {

/// A fatigue check of one range [MPa] so many times on a category, as the beam's checks give it.
CheckResult check_of(double category, double range, double cycles, double s = 1.0) {
  CheckResult result;
  result.check.criterion = Criterion::fatigue;
  result.check.station.s = si<Length>(s);
  result.check.point = "fibre +z";
  result.check.required = 1.2;
  CheckBasis& basis = result.basis.emplace();
  basis.spectrum.push_back({"", StressKind::direct, {si<Stress>(range * 1e6), {}, cycles}, 0.0});
  basis.curves.push_back(en_1993_1_9_direct(category));
  result.check.safety_factor =
      largest_factor({basis.spectrum.front().cycle}, basis.curves.front(), FatigueDemand{});
  return result;
}

std::vector<CodeResult> compared(const std::vector<std::string>& codes,
                                 const std::vector<CheckResult>& checks) {
  Project project;
  project.fatigue.codes = codes;
  return compare_codes(project, checks);
}

}  // namespace

TEST_CASE("EN 1993-1-9 100 and DNV-RP-C203 C2 bear the same above both knees") {
  // 1e6 cycles: EN 100 (2e6/1e6)^(1/3), DNV log N = 12.301 - 3 log S; log(2e6 100^3) = 12.30103.
  const auto results = compared({"DNV-RP-C203 air"}, {check_of(100, 50, 1e6)});
  REQUIRE(results.size() == 2);
  CHECK(results[0].curve == "100");
  CHECK(results[0].safety_factor == Approx(100.0 * std::cbrt(2.0) / 50.0).epsilon(1e-12));
  CHECK(results[1].code == "DNV-RP-C203:2016");
  CHECK(results[1].curve == "C2");
  CHECK(results[1].safety_factor ==
        Approx(std::pow(10.0, (12.301 - 6.0) / 3.0) / 50.0).epsilon(1e-9));
  CHECK(results[1].safety_factor == Approx(results[0].safety_factor).epsilon(1e-4));
  CHECK(results[1].required == 1.2);
  CHECK(results[1].missing.empty());
}

TEST_CASE("DNV-RP-C203 has no cut-off: at 1e9 cycles it bears less than EN 1993-1-9") {
  // EN: never less than its cut-off 100 (2/5)^(1/3) (5/100)^(1/5); DNV: log N = 15.835 - 5 log S.
  for (const double cycles : {1e8, 1e9}) {
    const auto results = compared({"DNV-RP-C203 air"}, {check_of(100, 30, cycles)});
    REQUIRE(results.size() == 2);
    const double cut_off = 100.0 * std::cbrt(0.4) * std::pow(0.05, 0.2);
    CHECK(results[0].safety_factor == Approx(cut_off / 30.0).epsilon(1e-9));
    CHECK(results[1].safety_factor ==
          Approx(std::pow(10.0, (15.835 - std::log10(cycles)) / 5.0) / 30.0).epsilon(1e-9));
    CHECK(results[1].safety_factor < results[0].safety_factor);
  }
}

TEST_CASE("a detail weaker than every curve of a code has no result there, and that is said") {
  // The hot-spot categories of EN 1993-1-9, table B.1, end at 90.
  const auto results = compared({"EN 1993-1-9 hot spot"}, {check_of(71, 50, 1e6, 1.25)});
  REQUIRE(results.size() == 2);
  CHECK(results[1].curve.empty());
  CHECK(results[1].safety_factor == 0.0);
  CHECK(results[1].missing.find("no curve is as low as 71 MPa at 2e6 cycles") == 0);
  CHECK(results[1].missing.find("s = 1.25 m, fibre +z") != std::string::npos);
}

TEST_CASE("a curve of recalled figures says so: BS 7608 F beside category 71") {
  // 2e6 S^3 = 0.63e12: F bears 68.0 MPa, E 80.4 MPa at 2e6 cycles.
  const auto results = compared({"BS 7608"}, {check_of(71, 50, 1e6)});
  REQUIRE(results.size() == 2);
  CHECK(results[1].curve == "F");
  CHECK(results[1].unconfirmed);
  CHECK(results[1].safety_factor == Approx(std::cbrt(0.63e6) / 50.0).epsilon(1e-9));
}

TEST_CASE("IIW allows half of the damage sum to ranges of many sizes, the whole to one size") {
  // FAT 71, above its knee: N S^3 = 2e6 71^3. With D = 0.5 a factor is 2^(-1/3) of that with 1.
  CheckResult two = check_of(71, 100, 1e6);
  two.basis->spectrum.push_back({"", StressKind::direct, {si<Stress>(80e6), {}, 1e6}, 0.0});
  const auto results = compared({"IIW"}, {two});
  REQUIRE(results.size() == 2);
  CHECK(results[1].curve == "FAT 71");
  CHECK(results[1].damage_limit == 0.5);
  const double sum = 1e6 * (1.0 + 0.8 * 0.8 * 0.8);
  CHECK(results[1].safety_factor == Approx(0.71 * std::cbrt(2e6 * 0.5 / sum)).epsilon(1e-9));
  const auto one = compared({"IIW"}, {check_of(71, 100, 1e6)});
  CHECK(one[1].damage_limit == 1.0);
  CHECK(one[1].safety_factor == Approx(0.71 * std::cbrt(2.0)).epsilon(1e-9));
}

TEST_CASE("each code corrects for the thickness of the plate by its own rule") {
  // 80 mm: DNV F (25/80)^0.25, BS 7608 F likewise, IIW (25/80)^0.3 at a toe and 0.2 at a butt weld.
  CheckResult thick = check_of(71, 50, 1e6);
  thick.basis->point.plate = si<Length>(0.08);
  const auto plain = compared({"DNV-RP-C203 air", "BS 7608", "IIW"}, {check_of(71, 50, 1e6)});
  const auto at_toe = compared({"DNV-RP-C203 air", "BS 7608", "IIW"}, {thick});
  REQUIRE(at_toe.size() == 4);
  const double shares[] = {1.0, std::pow(0.3125, 0.25), std::pow(0.3125, 0.25),
                           std::pow(0.3125, 0.3)};
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(at_toe[i].size_factor == Approx(shares[i]).epsilon(1e-12));
    // 1e6 cycles stay on the first slope: the factor falls with the strength.
    CHECK(at_toe[i].safety_factor == Approx(shares[i] * plain[i].safety_factor).epsilon(1e-9));
  }
  BeamDetail splice;
  splice.detail.curve = en_1993_1_9_direct(71);
  splice.detail.row = "8.3/13";
  thick.basis->point.detail = &splice;
  CHECK(compared({"IIW"}, {thick})[1].size_factor == Approx(std::pow(0.3125, 0.2)).epsilon(1e-12));
}

TEST_CASE("another place may govern under another code") {
  // Few large ranges on a strong detail beside many small ones below the cut-off of EN: there DNV
  // is weaker.
  const CheckResult many = check_of(100, 30, 1e10, 1.0);
  const CheckResult few = check_of(100, 100, 1e6, 2.0);
  REQUIRE(few.check.safety_factor < many.check.safety_factor);
  const auto results = compared({"DNV-RP-C203 air"}, {few, many});
  REQUIRE(results.size() == 2);
  CHECK(results[0].station.s.value() == 2.0);
  CHECK(results[1].station.s.value() == 1.0);
  CHECK(results[1].safety_factor ==
        Approx(std::pow(10.0, (15.835 - 10.0) / 5.0) / 30.0).epsilon(1e-9));
}

TEST_CASE("nothing is compared where no code is named or nothing changes") {
  CHECK(compared({}, {check_of(100, 50, 1e6)}).empty());
  CHECK(compared({"DNV-RP-C203 air"}, {}).empty());
}

TEST_CASE("EN 1993-1-9 beside itself gives the same place and factor, on the whole rig") {
  Project project = test::rig();
  project.fatigue.codes = {"EN 1993-1-9", "DNV-RP-C203 air"};
  const Verification verification = verify(project);
  REQUIRE(verification.codes.size() == 3);
  const CodeResult& own = verification.codes[0];
  CHECK(own.safety_factor == verification.governing(Criterion::fatigue)->check.safety_factor);
  CHECK(verification.codes[1].safety_factor == Approx(own.safety_factor).epsilon(1e-12));
  CHECK(verification.codes[1].station == own.station);
  CHECK(verification.codes[1].point == own.point);
  // One range 1e8 times, category 100: as above, by the ratio of the two strengths; DNV's C2 loses
  // (25/50)^0.15 in the 50 mm plates, category 100 as such has no size effect.
  const double cut_off = 100.0 * std::cbrt(0.4) * std::pow(0.05, 0.2);
  CHECK(verification.codes[2].thickness.value() == Approx(0.05));
  CHECK(verification.codes[2].size_factor == Approx(std::pow(0.5, 0.15)).epsilon(1e-12));
  CHECK(verification.codes[2].safety_factor / own.safety_factor ==
        Approx(std::pow(0.5, 0.15) * std::pow(10.0, 7.835 / 5.0) / cut_off).epsilon(1e-9));
}

}  // namespace code_comparison_test
