// Sections and pieces of the beam as results.json has them.

#include "boxbeam/verification/beam_properties.hpp"
#include "boxbeam/verification/verify.hpp"

#include "catch.hpp"
#include "support/rig.hpp"

namespace beam_properties_test {

using namespace boxbeam;

TEST_CASE("pieces of the beam lie between its named places and make up the whole") {
  const TaperedBeam& beam = test::rig().beam;
  const std::vector<BeamPart> parts = parts_of(beam);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].from == "C");
  CHECK(parts[0].to == "O");
  CHECK(parts[1].to == "B");
  // By hand, S1 and S2: 7800 (0.09 x 1.5 + 0.11 x 1.7) = 2511.6 kg.
  CHECK(parts[0].mass.mass.value() == Approx(2511.6));
  const MassProperties whole = mass_properties_of(beam);
  CHECK((parts[0].mass.mass + parts[1].mass.mass).value() == Approx(whole.mass.value()));
  // Steiner: the pieces' own inertia and their distances to the common centre.
  double inertia = 0.0;
  for (const BeamPart& part : parts) {
    const double arm = (part.mass.centre - whole.centre).value();
    inertia += part.mass.inertia.value() + part.mass.mass.value() * arm * arm;
  }
  CHECK(inertia == Approx(whole.inertia.value()));
}

TEST_CASE("a place with two names bounds one piece") {
  TaperedBeam beam = test::rig().beam;
  beam.points = {{"end", 6.2 * metre}, {"a", 0.0 * metre}, {"also a", 0.0 * metre}};
  const std::vector<BeamPart> parts = parts_of(beam);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].from == "a");
  CHECK(parts[0].to == "end");
  beam.points.clear();
  CHECK(parts_of(beam).empty());
}

TEST_CASE("sections at the verified stations: by hand at the pivot") {
  static const Verification verification = verify(test::rig());
  const auto all = station_properties_of(test::rig(), verification.stations, verification.checks);
  REQUIRE(all.size() == verification.stations.size());
  std::size_t pivots = 0;
  for (const StationProperties& at : all) {
    CHECK(at.net.area <= at.gross.area);
    if (at.station.s != 3.2 * metre) {
      CHECK(at.levels.empty());
      continue;
    }
    ++pivots;
    CHECK(at.gross.area.value() == Approx(0.4 * 1.0 - 0.3 * 0.9));
    // Four times 18 x 50 and twice 145 x 50 mm of holes: 18.1e3 mm^2.
    CHECK((at.gross.area - at.net.area).value() == Approx(18.1e-3));
    CHECK(at.weight.value() == Approx(7800 * 0.13 * 9.815));
    REQUIRE(at.levels.size() == 2);
    CHECK(at.levels[0].name == "thesis A");
    CHECK(at.levels[0].first_moment.value() == Approx(0.0).margin(1e-12));
    // Beyond 475 mm: half of the flange, 400 x 25 mm at 487.5 mm.
    CHECK(at.levels[1].first_moment.value() == Approx(0.4 * 0.025 * 0.4875));
    CHECK(at.levels[1].width.value() == Approx(0.4));
    REQUIRE(at.shear_lag);
    CHECK(at.shear_lag->b_0.value() == Approx(0.175));
  }
  CHECK(pivots == 2);
}

}  // namespace beam_properties_test
