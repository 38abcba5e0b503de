#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/verification/elastic_motion.hpp"

/// A box beam of 12 m, 80 x 100 mm, plates of 5 mm, in mechanisms of the plane.
namespace test::slender {

inline constexpr double E = 2.1e11, G = 8.1e10, rho = 7850.0;
inline constexpr double L = 12.0;
inline constexpr double w = 0.08, h = 0.1, plate = 0.005;
inline constexpr double A = w * h - (w - 2 * plate) * (h - 2 * plate);
inline const double I = (w * h * h * h - (w - 2 * plate) * std::pow(h - 2 * plate, 3)) / 12.0;

/// Clamped at its start, free at its end [Hz].
inline double first_frequency() {
  return std::pow(1.8751040687119612 / L, 2) * std::sqrt(E * I / (rho * A)) /
         (2 * std::numbers::pi);
}

/// The first body of a mechanism, along x from the origin; nothing holds it.
struct Beam {
  boxbeam::TaperedBeam beam;
  boxbeam::planar::Mechanism mechanism;
  boxbeam::planar::Motion motion;
  boxbeam::planar::BeamBody body;
  std::shared_ptr<boxbeam::planar::StatesAround> finder;
  double centre = 0.5 * L;  ///< of mass, from its start [m]

  explicit Beam(double density = rho) {
    using namespace boxbeam;
    const Section box{symmetric_box(w * metre, h * metre, plate * metre, plate * metre), {}};
    beam.density = si<Density>(density);
    beam.segments = {{"", Length{}, si<Length>(L), box, box}};
    Body of;
    of.name = "beam";
    const MassProperties properties = mass_properties_of(beam);
    of.mass = properties.mass.value();
    of.inertia = properties.inertia.value();
    of.sketch.centre = {0.5 * L, 0.0};
    mechanism.bodies = {of};
    body = planar::beam_body_of(beam, 0);
  }

  boxbeam::planar::Attachment start() const { return {0, {-centre, 0.0}}; }

  void solve(int instants) {
    motion = boxbeam::planar::solve_motion(mechanism, instants);
    finder = std::make_shared<boxbeam::planar::StatesAround>(mechanism, motion);
  }

  boxbeam::RigidMotion rigid() const {
    return {&mechanism, &motion, &beam, [this](boxbeam::Time time) {
              return boxbeam::planar::beam_loads_of(mechanism, finder->at(time.value()), body);
            }};
  }

  boxbeam::ElasticBody elastic(double modulus = E, double shear_modulus = G,
                               double retardation = 0.0) const {
    return {0,           centre, L, boxbeam::link_stretches_of(beam, modulus, shear_modulus),
            retardation, 16};
  }

  boxbeam::LoadHistory history() const {
    using boxbeam::si;
    return {{si<boxbeam::Time>(motion.begin), si<boxbeam::Time>(motion.period),
             motion.states.size(), motion.closed},
            rigid().loads};
  }
};

/// A coordinate of its start is driven.
inline boxbeam::planar::Joint driven(const Beam& of, boxbeam::planar::Coordinate coordinate,
                                     boxbeam::Driver driver) {
  boxbeam::planar::Driven kind;
  kind.point = of.start();
  kind.coordinate = coordinate;
  kind.driver = std::move(driver);
  return {"drive", kind};
}

/// It narrows to 60 x 50 mm.
inline Beam tapered() {
  using namespace boxbeam;
  Beam of;
  of.beam.segments.front().to = {
      symmetric_box(0.06 * metre, 0.05 * metre, plate * metre, plate * metre), {}};
  const MassProperties properties = mass_properties_of(of.beam);
  of.centre = properties.centre.value();
  Body& body = of.mechanism.bodies.front();
  body.mass = properties.mass.value();
  body.inertia = properties.inertia.value();
  body.sketch.centre = {of.centre, 0.0};
  of.body = planar::beam_body_of(of.beam, 0);
  return of;
}

/// Its base follows a driver across its axis; `length`: how long it is looked at, where the driver
/// does not say so [s].
inline Beam carried(boxbeam::Driver driver, int instants, double length = 0.0,
                    bool narrows = false) {
  Beam of = narrows ? tapered() : Beam();
  boxbeam::planar::Slider slider;
  slider.point = of.start();
  slider.direction = std::numbers::pi / 2;
  of.mechanism.joints = {{"base", slider}};
  of.mechanism.joints.push_back(driven(of, boxbeam::planar::Coordinate::y, std::move(driver)));
  of.mechanism.duration.length = length;
  of.solve(instants);
  return of;
}

/// Its base shakes across its axis, r times as fast as its first frequency.
inline Beam shaken(double r, int instants, double amplitude = 0.01) {
  const double omega = 2 * std::numbers::pi * r * first_frequency();
  return carried(boxbeam::HarmonicDriver{0.0, amplitude, omega, 0.0}, instants);
}

/// Tapered, its start is a pin about which a driver turns it; `length`: how long it is looked at,
/// where the driver does not say so [s].
inline Beam tapered_and_turned(boxbeam::Driver driver, double length = 0.0) {
  using namespace boxbeam;
  Beam of = tapered();
  planar::Pin pin;
  pin.a = of.start();
  of.mechanism.joints = {{"base", pin}, driven(of, planar::Coordinate::angle, std::move(driver))};
  of.mechanism.duration.length = length;
  return of;
}

}  // namespace test::slender
