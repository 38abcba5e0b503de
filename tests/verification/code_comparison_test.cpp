// The same stress ranges under several codes, by the equations of their curves.

#include "boxbeam/verification/code_comparison.hpp"

#include <cmath>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

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
  // One range 1e8 times, category 100: as above, by the ratio of the two strengths.
  const double cut_off = 100.0 * std::cbrt(0.4) * std::pow(0.05, 0.2);
  CHECK(verification.codes[2].safety_factor / own.safety_factor ==
        Approx(std::pow(10.0, 7.835 / 5.0) / cut_off).epsilon(1e-9));
}
