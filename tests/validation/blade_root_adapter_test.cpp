// The shipped adapter under an OpenFAST file, against figures of other programs: the file read by
// the Python package weio 2.0.0, cycles counted by rainflow 3.2.0, damage by EN 1993-1-9 in
// sections/blade-root-adapter/check_damage.py.

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace blade_root_adapter_test {

using namespace boxbeam;

TEST_CASE("blade-root adapter: stress and damage as weio and rainflow have them", "[validation]") {
  const Verification verification =
      verify(read_project(test::project_file("sections/blade-root-adapter/adapter.toml")));
  CHECK(verification.verdict == Verdict::pass);

  const CheckResult* yield = verification.governing(Criterion::yield);
  REQUIRE(yield != nullptr);
  CHECK(yield->check.station.s.value() == Approx(1.2));
  CHECK(yield->check.time.value() == Approx(160.0));
  // N/A + M/W, to the digits that the script prints; the place round the tube is searched to 1e-4.
  CHECK(yield->basis->stress_at_time.normal.value() == Approx(99.51e6).epsilon(2e-4));

  const CheckResult* fatigue = verification.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  CHECK(fatigue->check.station.s.value() == Approx(1.2));
  // The script looks every half degree, so that it may find a little less.
  CHECK(fatigue->check.safety_factor == Approx(1.175384).epsilon(2e-5));
  CHECK(fatigue->basis->damage == Approx(0.534328).epsilon(2e-4));
}

}  // namespace blade_root_adapter_test
