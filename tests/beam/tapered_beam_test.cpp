#include "boxbeam/beam/tapered_beam.hpp"

#include <cmath>
#include <tuple>

#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"

namespace tapered_beam_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Length m(double x) { return si<Length>(x); }

/// The lever beam of the sledge rig: segments S1 to S6 from the lower end, pivot at 3.2 m.
TaperedBeam rig() {
  const Profile a1 = symmetric_box(mm(400), mm(600), mm(50), mm(50));
  const Profile a2 = symmetric_box(mm(400), mm(1000), mm(50), mm(50));
  const Profile tube = symmetric_box(mm(290), mm(490), mm(56), mm(56));
  const Section A1{a1, {}}, A2{a2, {}}, A1_tube{a1, tube}, only_tube{tube, {}};
  TaperedBeam beam;
  beam.segments = {{"S1", m(0), m(1.5), A1, A1},
                   {"S2", m(1.5), m(1.7), A1, A2},
                   {"S3", m(3.2), m(1), A2, A1},
                   {"S4", m(4.2), m(0.5), A1, A1},
                   {"S5", m(4.7), m(0.5), A1_tube, A1_tube},
                   {"S6", m(5.2), m(1), only_tube, only_tube}};
  beam.marks = {m(3.2), m(3.2), m(1.0)};
  beam.points = {{"C", m(0)}, {"O", m(3.2)}, {"B", beam.length()}, {"mark", m(2.0)}};
  beam.density = si<Density>(7800);
  return beam;
}

/// A uniform box 400 x 600 x 50 mm in two pieces, A = 90e-3 m^2, I_y = 4.075e-3 m^4.
TaperedBeam uniform_bar() {
  const Section A1{symmetric_box(mm(400), mm(600), mm(50), mm(50)), {}};
  TaperedBeam beam;
  beam.segments = {{"a", m(0), m(1.25), A1, A1}, {"b", m(1.25), m(2.75), A1, A1}};
  beam.density = si<Density>(7800);
  return beam;
}

// Area of the rig's tube: 290*490 - 178*378 mm^2.
constexpr double A_tube = 74816e-6;

}  // namespace

TEST_CASE("masses of the rig's halves by hand: rho times length times mean area") {
  const TaperedBeam beam = rig();
  const double lower = mass_properties_of(beam, m(0), m(3.2)).mass.value();
  const double upper = mass_properties_of(beam, m(3.2), beam.length()).mass.value();
  // The taper's area varies linearly, for only the height does.
  CHECK(lower == Approx(7800 * (0.09 * 1.5 + 0.11 * 1.7)).epsilon(1e-12));
  CHECK(upper ==
        Approx(7800 * (0.11 + 0.09 * 0.5 + (0.09 + A_tube) * 0.5 + A_tube)).epsilon(1e-12));
  CHECK(mass_properties_of(beam).mass.value() == Approx(lower + upper).epsilon(1e-12));
  // Recomputed from the thesis' own table of areas: 2512 and 2436 kg.
  CHECK(lower == Approx(2512).margin(1));
  CHECK(upper == Approx(2436).margin(1));
}

TEST_CASE("centres of the rig's halves by hand, from the pivot") {
  const TaperedBeam beam = rig();
  // Sum of area length arm over sum of area length; a taper as uniform part and triangle.
  const double lower =
      (0.135 * (1.7 + 0.75) + 0.09 * 1.7 * 0.85 + 0.04 * 1.7 / 2 * 1.7 / 3) / (0.135 + 0.11 * 1.7);
  const double upper =
      (0.09 * 0.5 + 0.02 / 3.0 + 0.045 * 1.25 + (0.09 + A_tube) * 0.5 * 1.75 + A_tube * 2.5) /
      (0.11 + 0.045 + (0.09 + A_tube) * 0.5 + A_tube);
  CHECK(3.2 - mass_properties_of(beam, m(0), m(3.2)).centre.value() ==
        Approx(lower).epsilon(1e-12));
  CHECK(mass_properties_of(beam, m(3.2), beam.length()).centre.value() - 3.2 ==
        Approx(upper).epsilon(1e-12));
  // Recomputed from the thesis' table: 1.491 m; upper 1.407 m, printed there as 1.41.
  CHECK(lower == Approx(1.491).margin(5e-4));
  CHECK(upper == Approx(1.407).margin(1e-3));
}

TEST_CASE("mass properties of a taper in every dimension equal Simpson's rule on the sections") {
  const Section from{symmetric_box(mm(400), mm(600), mm(50), mm(40)), RoundTube{mm(200), mm(20)}};
  const Section to{symmetric_box(mm(300), mm(900), mm(30), mm(25)), RoundTube{mm(150), mm(30)}};
  TaperedBeam beam;
  beam.segments = {{"taper", m(0), m(2.5), from, to}};
  beam.density = si<Density>(7800);
  beam.rotary_inertia = true;
  const double low = 0.4, high = 2.1;
  double mass = 0, first = 0, second = 0;
  const int steps = 400;
  for (int i = 0; i <= steps; ++i) {
    const double s = low + (high - low) * i / steps;
    const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 3.0;
    const SectionProperties p = properties_of(section_at(beam, {m(s)}));
    const double dm = weight * (high - low) / steps * 7800 * p.area.value();
    mass += dm;
    first += dm * s;
    second += dm * (s * s + p.I_y.value() / p.area.value());
  }
  const MassProperties piece = mass_properties_of(beam, m(low), m(high));
  CHECK(piece.mass.value() == Approx(mass).epsilon(1e-10));
  CHECK(piece.centre.value() == Approx(first / mass).epsilon(1e-10));
  CHECK(piece.inertia.value() == Approx(second - first * first / mass).epsilon(1e-9));
}

TEST_CASE("a uniform bar: m L^2/12, and rho I_y L more where rotary inertia counts") {
  TaperedBeam beam = uniform_bar();
  const double mass = 7800 * 0.09 * 4.0;
  const MassProperties line = mass_properties_of(beam);
  CHECK(line.mass.value() == Approx(mass).epsilon(1e-13));
  CHECK(line.centre.value() == Approx(2.0).epsilon(1e-13));
  CHECK(line.inertia.value() == Approx(mass * 16.0 / 12.0).epsilon(1e-12));
  beam.rotary_inertia = true;
  CHECK(mass_properties_of(beam).inertia.value() ==
        Approx(mass * 16.0 / 12.0 + 7800 * 4.075e-3 * 4.0).epsilon(1e-12));
}

TEST_CASE("pieces put together are the whole, by Steiner's theorem") {
  TaperedBeam beam = rig();
  beam.rotary_inertia = true;
  const MassProperties whole = mass_properties_of(beam);
  for (const double cut : {0.3, 1.5, 2.0, 3.2, 4.9, 6.0}) {
    const MassProperties a = mass_properties_of(beam, m(0), m(cut));
    const MassProperties b = mass_properties_of(beam, m(cut), beam.length());
    const auto about_whole = [&](const MassProperties& p) {
      return p.inertia.value() + p.mass.value() * std::pow((p.centre - whole.centre).value(), 2);
    };
    CAPTURE(cut);
    CHECK((a.mass + b.mass).value() == Approx(whole.mass.value()).epsilon(1e-12));
    CHECK((a.mass * a.centre + b.mass * b.centre).value() ==
          Approx((whole.mass * whole.centre).value()).epsilon(1e-12));
    CHECK(about_whole(a) + about_whole(b) == Approx(whole.inertia.value()).epsilon(1e-11));
  }
}

TEST_CASE("the section at a station, and on either side of a jump") {
  const TaperedBeam beam = rig();
  const auto height = [&](double s, Side side) {
    return height_of(section_at(beam, {m(s), side}).outer).value();
  };
  CHECK(height(0.7, Side::both) == Approx(0.6));
  CHECK(height(1.5 + 0.85, Side::both) == Approx(0.8));  // the middle of the taper
  CHECK(height(3.2, Side::before) == Approx(1.0));
  CHECK(height(3.2, Side::behind) == Approx(1.0));
  CHECK(height(3.7, Side::both) == Approx(0.8));
  // At 5.2 m the box ends on the tube.
  CHECK(section_at(beam, {m(5.2), Side::before}) == beam.segments[4].to);
  CHECK(section_at(beam, {m(5.2), Side::behind}) == beam.segments[5].from);
  CHECK(section_at(beam, {m(5.2), Side::both}) == beam.segments[5].from);
  CHECK(section_at(beam, {m(4.7), Side::before}) == beam.segments[3].to);
  CHECK(section_at(beam, {m(0), Side::behind}) == beam.segments[0].from);
  CHECK(section_at(beam, {beam.length(), Side::before}) == beam.segments[5].to);
}

TEST_CASE("places: ends, holes and points, ascending and each once") {
  const std::vector<Length> places = places_of(rig());
  const double expected[] = {0, 1.0, 1.5, 2.0, 3.2, 4.2, 4.7, 5.2, 6.2};
  REQUIRE(places.size() == std::size(expected));
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(places[i].value() == Approx(expected[i]).epsilon(1e-14));
  }
}

TEST_CASE("a station within round-off of a place is that place") {
  const std::vector<Length> places{m(0), m(1.1), m(3.3)};
  CHECK(place_near(places, m(1.1 + 1e-12)) == m(1.1));
  CHECK(place_near(places, m(3 * 1.1)) == m(3.3));
  CHECK(place_near(places, m(1.1001)) == m(1.1001));
  CHECK(place_near(places, m(2.0)) == m(2.0));
}

TEST_CASE("of two places within round-off of a station the nearer is meant") {
  const std::vector<Length> places{m(0), m(1.0), m(1.0 + 1e-10), m(3.3)};
  CHECK(place_near(places, m(1.0 + 9e-11)) == m(1.0 + 1e-10));
  CHECK(place_near(places, m(1.0 + 1e-11)) == m(1.0));
}

TEST_CASE("taper: the slope of h^3 of a plate, up to the thin end of a wedge and in a step") {
  for (const double length : {2.0, 1e-6, 1e-11}) {
    for (const double thin : {0.1, 1e-3, 1e-9}) {
      TaperedBeam beam;
      const Section high{Plate{mm(50), m(0.2)}, {}}, low{Plate{mm(50), m(0.2 * thin)}, {}};
      beam.segments = {{"even", m(0), m(1), high, high},
                       {"down", m(1), m(length), high, low},
                       {"up", m(1) + m(length), m(length), low, high}};
      const Length tip = beam.segments[1].end();
      for (const auto& [station, h, sense] :
           {std::tuple{Station{m(1), Side::behind}, 0.2, -1.0},
            std::tuple{Station{tip, Side::before}, 0.2 * thin, -1.0},
            std::tuple{Station{tip, Side::behind}, 0.2 * thin, 1.0},
            std::tuple{Station{beam.length(), Side::before}, 0.2, 1.0}}) {
        CAPTURE(length, thin, station.s.value(), to_text(station.side));
        double slope = 0.0;
        for (const NearbySection& near : taper_at(beam, station)) {
          slope += near.weight * std::pow(height_of(near.section.outer).value(), 3);
        }
        // d(h^3)/ds = 3 h^2 h', h' = -+0.2 (1 - thin)/length.
        CHECK(slope == Approx(sense * 3.0 * h * h * 0.2 * (1.0 - thin) / length).epsilon(1e-8));
        CHECK(height_of(section_at(beam, station).outer).value() == Approx(h).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("sides are written -, + and 0") {
  CHECK(std::string(to_text(Side::before)) == "-");
  CHECK(std::string(to_text(Side::behind)) == "+");
  CHECK(std::string(to_text(Side::both)) == "0");
}

}  // namespace tapered_beam_test
