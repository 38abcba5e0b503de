#include "section_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/section/wall_stretches.hpp"
#include "catch.hpp"

namespace section_stress_test {

/// The oracle's stresses against hand formulas, and against the program's own, from which they are
/// calculated apart.
namespace {

using namespace boxbeam;
using oracle::LocalSection;
using oracle::Place;
using oracle::PlaceKind;

constexpr double pi = std::numbers::pi;

Length mm(double x) { return si<Length>(1e-3 * x); }

double largest(const std::vector<Place>& places, std::size_t which, bool shear) {
  double most = 0.0;
  for (const Place& place : places)
    most = std::max(most, std::abs(shear ? place.shear[which] : place.normal[which]));
  return most;
}

LocalSection prismatic(const Section& section, bool space = false) {
  return {section, {}, {}, space, 1.0, 1.0};
}

/// Unlike in every plate, with a bar on the top flange and one on a web.
Section crooked_box(double height) {
  Box box{mm(200), mm(height), mm(12), mm(16), mm(8), mm(11)};
  box.stiffeners = {{BoxPlate::top_flange, mm(20), mm(40), mm(6)},
                    {BoxPlate::right_web, mm(-30), mm(35), mm(7)}};
  return {box, {}};
}

/// Sections on both sides of a place of a segment that tapers over a metre, as the oracle takes
/// them, and as the program does.
struct Tapered {
  LocalSection section;
  Taper taper;
};

Tapered tapered(const Section& from, const Section& to, bool space) {
  TaperedBeam beam;
  beam.segments.push_back({"a", Length{}, si<Length>(1.0), from, to});
  const Station station{si<Length>(0.4)};
  Tapered of{prismatic(section_at(beam, station), space), taper_at(beam, station)};
  const double h = 1e-4;
  of.section.nearby = {{interpolate(from, to, 0.4 + h), 0.5 / h},
                       {interpolate(from, to, 0.4 - h), -0.5 / h}};
  return of;
}

/// The places of the oracle on the walls that the program knows as stretches have the program's
/// stresses.
void compare_with_program(const LocalSection& section, const Taper& taper) {
  const StressField field = stress_field_of(section.here, section.holes, taper);
  std::vector<SectionPoint> known;
  for (const WallStretch& stretch : wall_stretches_of(field)) {
    for (int k = 0; k <= 1000; ++k) known.push_back(point_on_stretch(field, stretch, k / 1000.0));
  }
  const std::vector<Place> places = oracle::places_of(section, 60);
  int compared = 0;
  for (std::size_t which = 0; which < cut_force::count; ++which) {
    double scale = 0.0;
    for (const SectionPoint& point : known)
      scale = std::max(scale, std::abs(point.influence.shear[which]));
    for (const Place& place : places) {
      if (place.kind == PlaceKind::throat || place.name.find("corner") != std::string::npos)
        continue;
      if (place.name.find("stiffener") != std::string::npos) continue;
      const auto distance = [&](const SectionPoint& point) {
        return std::hypot(point.y.value() - place.y, point.z.value() - place.z);
      };
      const SectionPoint& nearest = *std::min_element(
          known.begin(), known.end(),
          [&](const SectionPoint& a, const SectionPoint& b) { return distance(a) < distance(b); });
      // At the foot of a bar the flow jumps.
      const bool foot = std::abs(place.y - 0.020) < 1e-3 || std::abs(place.z + 0.030) < 1e-3;
      if (distance(nearest) > 1e-4 || foot) continue;
      // The two may walk along a wall in opposite senses.
      const double T = nearest.influence.shear[cut_force::T] * place.shear[cut_force::T];
      const double sense = T < 0.0 ? -1.0 : 1.0;
      ++compared;
      INFO(place.name << ", cut force " << which);
      // Between two of a thousand places of a wall the flow changes by less.
      CHECK(std::abs(nearest.influence.shear[which] - sense * place.shear[which]) <
            2e-3 * scale + 1e-12);
    }
  }
  CHECK(compared > 100);
}

}  // namespace

TEST_CASE("the oracle's stresses of a solid plate are the textbook's", "[oracle]") {
  const Section plate{Plate{mm(20), mm(100)}, {}};
  const auto places = oracle::places_of(prismatic(plate), 200);
  CHECK(largest(places, cut_force::M_y, false) == Approx(6.0 / (0.02 * 0.1 * 0.1)));
  CHECK(largest(places, cut_force::N, false) == Approx(1.0 / (0.02 * 0.1)));
  CHECK(largest(places, cut_force::V_z, true) == Approx(1.5 / (0.02 * 0.1)));
  // Timoshenko and Goodier, article 109: b/a = 5, tau = T/(0.291 b a^2).
  CHECK(largest(places, cut_force::T, true) ==
        Approx(1.0 / (0.291 * 0.1 * 0.02 * 0.02)).epsilon(2e-3));
}

TEST_CASE("the oracle's stresses of tubes and boxes are the textbook's", "[oracle]") {
  const Section round{RoundTube{mm(200), mm(10)}, {}};
  const double I = pi / 64.0 * (std::pow(0.2, 4) - std::pow(0.18, 4));
  const auto around = oracle::places_of(prismatic(round, true), 200);
  CHECK(largest(around, cut_force::M_y, false) == Approx(0.1 / I));
  CHECK(largest(around, cut_force::M_z, false) == Approx(0.1 / I));
  // T r/I_p on the outer face.
  CHECK(largest(around, cut_force::T, true) == Approx(0.1 / (2.0 * I)).epsilon(2e-3));
  // V S/(I 2t), S of half a ring: 2/3 (R^3 - r^3).
  const double S = 2.0 / 3.0 * (std::pow(0.1, 3) - std::pow(0.09, 3));
  CHECK(largest(around, cut_force::V_z, true) == Approx(S / (I * 0.02)).epsilon(1e-3));

  const Section box{symmetric_box(mm(150), mm(300), mm(12), mm(8)), {}};
  const auto walls = oracle::places_of(prismatic(box), 400);
  const double I_y = (0.15 * std::pow(0.3, 3) - 0.134 * std::pow(0.276, 3)) / 12.0;
  CHECK(largest(walls, cut_force::M_y, false) == Approx(0.15 / I_y));
  const double half = 0.15 * 0.012 * 0.144 + 2.0 * 0.008 * 0.138 * 0.069;
  CHECK(largest(walls, cut_force::V_z, true) == Approx(half / (I_y * 0.016)).epsilon(1e-3));
}

TEST_CASE("the oracle's shear flow is the program's in crooked, tapered and nested sections",
          "[oracle]") {
  compare_with_program(prismatic(crooked_box(300), true), {});
  const Tapered box = tapered(crooked_box(300), crooked_box(220), true);
  compare_with_program(box.section, box.taper);
  const Section wide{Box{mm(260), mm(320), mm(14), mm(10), mm(9), mm(12)},
                     Profile{symmetric_box(mm(120), mm(150), mm(8), mm(6))}};
  Section narrow = wide;
  std::get<Box>(narrow.outer).height = mm(240);
  const Tapered nested = tapered(wide, narrow, true);
  compare_with_program(nested.section, nested.taper);
}

}  // namespace section_stress_test
