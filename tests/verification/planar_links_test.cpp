// A planar mechanism stopped in a posture as elastic links: frequencies by hand of a mass on a
// flexible beam that teeth hold.

#include "boxbeam/verification/planar_links.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/flexible/modes.hpp"
#include "catch.hpp"

namespace planar_links_test {

using namespace boxbeam;

namespace {

constexpr double L = 2.0, EI = 3e5, tip = 50.0;

ElasticBody light_beam() {
  flexible::LinkStretch stretch;
  stretch.length = L;
  stretch.EA.c[0] = 1e12;
  stretch.GA.c[0] = 1e14;
  stretch.EI.c[0] = EI;
  stretch.mass.c[0] = 1e-6;
  return {0, 0.5 * L, L, {stretch}, 0.0, 8};
}

/// A beam without mass to speak of, pinned to the ground at its start, with a mass at its tip; what
/// holds it from turning is the test's own. In an oblique posture.
struct HeldByTeeth {
  planar::Mechanism mechanism;
  planar::State state;
  double angle = 0.4;

  HeldByTeeth() {
    Body beam, end;
    beam.mass = 1e-6;
    beam.inertia = 1e-6;
    end.mass = tip;
    end.inertia = 1e-6;
    mechanism.bodies = {beam, end};
    planar::Pin pin;
    pin.a = {0, {-0.5 * L, 0.0}};
    planar::Rigid weld;
    weld.a = {0, {0.5 * L, 0.0}};
    weld.b = {1, {0.0, 0.0}};
    mechanism.joints = {{"pin", pin}, {"weld", weld}};
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    state.q.resize(6);
    state.q << 0.5 * L * along, angle, L * along, angle;
  }

  void add(const Body& body, const Eigen::Vector2d& place, double turned) {
    mechanism.bodies.push_back(body);
    const Eigen::Index n = state.q.size();
    state.q.conservativeResize(n + 3);
    state.q.tail(3) << place, turned;
  }

  double first_frequency() const {
    const flexible::Mechanism links = links_of(mechanism, state, light_beam());
    const flexible::Structure structure = flexible::structure_of(links);
    return flexible::modes_of(structure, 1).front().frequency;
  }
};

/// Of the tip's mass on a flexibility.
double frequency(double flexibility) {
  return 1.0 / (2.0 * std::numbers::pi * std::sqrt(tip * flexibility));
}

}  // namespace

TEST_CASE("a beam on a wheel in mesh with another: its spring counts by the square of the ratio") {
  for (const double r_b : {0.1, 0.3}) {
    for (const bool internal : {false, true}) {
      HeldByTeeth of;
      const double r_a = 0.5;
      // An annulus about the smaller wheel has a negative radius.
      const double r_1 = internal ? -r_a : r_a;
      const Eigen::Vector2d direction(std::cos(1.1), std::sin(1.1));
      Body wheel;
      wheel.mass = 1e-6;
      wheel.inertia = 1e-8;
      const Eigen::Vector2d centre = (r_1 + r_b) * direction;
      of.add(wheel, centre, 0.0);
      planar::Pin shaft;
      shaft.a = {2, {0.0, 0.0}};
      shaft.b = {planar::ground, centre};
      planar::Gear gear;
      gear.a = {0, {-0.5 * L, 0.0}};
      gear.b = {2, {0.0, 0.0}};
      gear.radius_a = r_1;
      gear.radius_b = r_b;
      of.mechanism.joints.push_back({"shaft", shaft});
      of.mechanism.joints.push_back({"gear", gear});
      planar::TorsionSpring spring;
      spring.a = {2, {0.0, 0.0}};
      spring.stiffness = 8e4;
      of.mechanism.forces = {{"spring", spring}};
      CHECK(obstacle_to_links(of.mechanism).empty());
      // The tooth force M/r_a turns the other wheel by M r_b/(r_a k), and that the beam by r_b/r_a
      // of it.
      const double ratio = r_b / r_a;
      CAPTURE(r_b, internal);
      CHECK(of.first_frequency() ==
            Approx(frequency(L * L * L / (3 * EI) + L * L * ratio * ratio / spring.stiffness))
                .epsilon(1e-5));
    }
  }
}

TEST_CASE("a beam on a pinion: the spring of its rack counts by the square of the radius") {
  for (const double r : {0.25, -0.4}) {
    HeldByTeeth of;
    const double line = 0.7;
    const Eigen::Vector2d e(std::cos(line), std::sin(line)), left(-e.y(), e.x());
    Body rack;
    rack.mass = 1e-6;
    rack.inertia = 1e-6;
    const Eigen::Vector2d place = -r * left + 0.3 * e;
    of.add(rack, place, line);
    planar::Slider guide;
    guide.point = {2, {0.0, 0.0}};
    guide.guide = {planar::ground, place};
    guide.direction = line;
    planar::Rack teeth;
    teeth.pinion = {0, {-0.5 * L, 0.0}};
    teeth.rack = {2, {0.0, 0.0}};
    teeth.radius = r;
    of.mechanism.joints.push_back({"guide", guide});
    of.mechanism.joints.push_back({"teeth", teeth});
    planar::Spring spring;
    spring.a = {2, {0.0, 0.0}};
    spring.b = {planar::ground, place + 0.5 * e};
    spring.stiffness = 2e6;
    of.mechanism.forces = {{"spring", spring}};
    CAPTURE(r);
    CHECK(
        of.first_frequency() ==
        Approx(frequency(L * L * L / (3 * EI) + L * L / (r * r * spring.stiffness))).epsilon(1e-5));
  }
}

TEST_CASE(
    "a cable holds a stopped beam where it is tight, a stop where it is touched, else neither") {
  HeldByTeeth of;
  planar::TorsionSpring root;
  root.a = {0, {-0.5 * L, 0.0}};
  root.stiffness = 4e5;
  const double own = L * L * L / (3 * EI) + L * L / root.stiffness;
  const double distance = 0.7, k = 2e5;
  planar::Spring spring;
  spring.a = {1, {0.0, 0.0}};
  spring.b = {planar::ground,
              of.state.q.tail<3>().head<2>() +
                  distance * Eigen::Vector2d(-std::sin(of.angle), std::cos(of.angle))};
  spring.stiffness = k;
  of.state.v.setZero(6);
  const auto frequency_with = [&](Acts acts, double free_length, std::optional<Impact> impact) {
    spring.acts = acts;
    spring.free_length = free_length;
    spring.impact = impact;
    of.mechanism.forces = {{"root", root}, {"spring", spring}};
    return of.first_frequency();
  };
  const double depth = 1e-4;
  const double held = frequency(1.0 / (1.0 / own + k));
  const auto is = [](double value) { return Approx(value).epsilon(1e-5); };
  CHECK(frequency_with(Acts::pulling, distance - depth, {}) == is(held));
  CHECK(frequency_with(Acts::pulling, distance + depth, {}) == is(frequency(own)));
  CHECK(frequency_with(Acts::pushing, distance + depth, {}) == is(held));
  CHECK(frequency_with(Acts::pushing, distance - depth, {}) == is(frequency(own)));
  // Of round bodies k d^1.5 rises by 1.5 k sqrt(d).
  CHECK(frequency_with(Acts::pushing, distance + depth, Impact{1.5, 0.8}) ==
        is(frequency(1.0 / (1.0 / own + 1.5 * k * std::sqrt(depth)))));
}

TEST_CASE("a gearbox that couples two turns by moments alone is named as what links cannot do") {
  HeldByTeeth of;
  planar::AngleCoupling gearbox;
  gearbox.a = {0, {0.0, 0.0}};
  gearbox.ratio = 2.0;
  of.mechanism.joints.push_back({"gearbox", gearbox});
  CHECK(obstacle_to_links(of.mechanism) == "gearbox");
}

}  // namespace planar_links_test
