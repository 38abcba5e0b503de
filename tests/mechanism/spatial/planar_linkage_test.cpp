// Three bars in a row that move in a plane, as a chain in space against the planar front end, which
// shares neither equations nor solver with it.

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "catch.hpp"

namespace planar_linkage_test {

using namespace boxbeam;
using Eigen::Vector3d;

namespace {

/// Three segments, the middle one tapered; 1.75 m.
TaperedBeam tapered_beam() {
  const Box from = symmetric_box(0.1 * metre, 0.2 * metre, 0.01 * metre, 0.01 * metre);
  Box to = from;
  to.height = 0.3 * metre;
  TaperedBeam beam;
  beam.density = si<Density>(7850.0);
  beam.rotary_inertia = true;
  const Length a = 0.5 * metre, b = 0.75 * metre;
  beam.segments = {{"", 0.0 * metre, a, {from, {}}, {from, {}}},
                   {"", a, b, {from, {}}, {to, {}}},
                   {"", a + b, a, {to, {}}, {to, {}}}};
  return beam;
}

CutForces cut(const CutForceDiagram& diagram, double s) {
  return diagram.at({si<Length>(s), Side::both});
}

/// Three bars of 1.75 m on pins, each driven against the one before; the middle one is the beam; a
/// force on the last. Angles counter-clockwise from x in the plane.
struct OpenLinkage {
  TaperedBeam beam = tapered_beam();
  std::array<Driver, 3> drivers = {HarmonicDriver{0.4, 0.7, 3.0, 0.5, {}},
                                   StepDriver{-0.5, 1.2, 0.1, 1.1},
                                   PolynomialDriver{{-0.3, 0.8, 0.6, -0.9}}};
  Driver size = HarmonicDriver{300.0, 150.0, 2.0, 0.1, {}};
  double lean = 0.6;  ///< of the force, against x of the last bar
  double gravity = 9.81;
  double length = 1.75;
  std::array<double, 3> mass = {40.0, 0.0, 25.0}, inertia = {9.0, 0.0, 6.0};
  double centre = 0.0;  ///< of the beam's mass from its start

  OpenLinkage() {
    const MassProperties properties = mass_properties_of(beam);
    mass[1] = properties.mass.value();
    inertia[1] = properties.inertia.value();
    centre = properties.centre.value();
  }
  std::array<double, 3> centres() const { return {0.5 * length, centre, 0.7}; }

  planar::Mechanism in_plane() const {
    planar::Mechanism mechanism;
    mechanism.gravity = {0.0, -gravity};
    Eigen::Vector2d pin(0.0, 0.0);
    double angle = 0.0;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      angle += driver_at(drivers[k], 0.0).value;
      const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
      const planar::Attachment start{i, {-centres()[k], 0.0}};
      Body bar{"", mass[k], inertia[k], {}, {pin + centres()[k] * along, angle}};
      mechanism.bodies.push_back(bar);
      const planar::Attachment before =
          i == 0 ? planar::Attachment{}
                 : planar::Attachment{i - 1, {length - centres()[k - 1], 0.0}};
      mechanism.joints.push_back({"pin", planar::Pin{start, before}});
      mechanism.joints.push_back(
          {"motor", planar::Driven{start, planar::Coordinate::angle, drivers[k], before}});
      pin += length * along;
    }
    mechanism.forces = {{"push", planar::PointForce{{2, {0.9, 0.2}}, lean, true, size}}};
    return mechanism;
  }

  /// The same with the plane's y as z of the world: counter-clockwise is about -y. The beam's body
  /// has its origin at the start of the axis.
  spatial::Mechanism in_space() const {
    spatial::Mechanism mechanism;
    mechanism.gravity = {0.0, 0.0, -gravity};
    mechanism.bodies.resize(3);
    mechanism.joints.resize(3);
    for (std::size_t i = 0; i < 3; ++i) {
      spatial::Joint& joint = mechanism.joints[i];
      joint.kind = spatial::JointKind::revolute;
      joint.parent = static_cast<int>(i) - 1;
      joint.axis = -Vector3d::UnitY();
      joint.driver = drivers[i];
      if (i > 0) joint.at = {length, 0.0, 0.0};
      spatial::Body& body = mechanism.bodies[i];
      body.mass = mass[i];
      body.centre = {centres()[i], 0.0, 0.0};
      body.inertia(1, 1) = inertia[i];
    }
    spatial::give_mass(mechanism.bodies[1], placement(), beam);
    mechanism.loads = {{"push",
                        spatial::LoadKind::force,
                        2,
                        {2, {0.9 + centres()[2], 0.0, 0.2}},
                        2,
                        {std::cos(lean), 0.0, std::sin(lean)},
                        size}};
    return mechanism;
  }

  static spatial::BeamPlacement placement() {
    spatial::BeamPlacement placement;
    placement.body = 1;
    return placement;
  }
};

}  // namespace

TEST_CASE("an open linkage in a plane: motion, reactions and cut forces of the planar front end") {
  const OpenLinkage linkage;
  const planar::Mechanism plane = linkage.in_plane();
  const spatial::Mechanism space = linkage.in_space();
  const spatial::Chain chain(space);
  const auto planar_beam = planar::beam_body_of(linkage.beam, 1);
  const spatial::BeamBody beam =
      spatial::beam_body_of(linkage.beam, OpenLinkage::placement(), space);
  planar::InstantSolver solver(plane);
  planar::State planar_state = solver.solve_from_sketch(0.0, planar::sketch_of(plane));
  const auto from_plane = [](const Eigen::Vector2d& p) { return Vector3d(p.x(), 0.0, p.y()); };
  for (int k = 1; k <= 60; ++k) {
    planar::State next;
    solver.solve_near(0.02 * k, planar_state, next);
    planar_state = next;
    const spatial::State state = chain.at(0.02 * k);
    double fastest = 1.0;
    for (int i = 0; i < 3; ++i) {
      const spatial::Attachment centre{i, space.bodies[static_cast<std::size_t>(i)].centre};
      const Vector3d p = from_plane(planar_state.q.segment<2>(3 * i));
      const Vector3d velocity = from_plane(planar_state.v.segment<2>(3 * i));
      const Vector3d a = from_plane(planar_state.a.segment<2>(3 * i));
      const spatial::BodyMotion& body = state.bodies[static_cast<std::size_t>(i)];
      fastest = std::max({fastest, a.norm(), std::abs(planar_state.a[3 * i + 2])});
      CHECK((position_of(state, centre) - p).norm() < 1e-11);
      CHECK((velocity_of(state, centre) - velocity).norm() < 1e-11 * fastest);
      CHECK((acceleration_of(state, centre) - a).norm() < 1e-11 * fastest);
      CHECK((body.omega + planar_state.v[3 * i + 2] * Vector3d::UnitY()).norm() < 1e-11 * fastest);
      CHECK((body.alpha + planar_state.a[3 * i + 2] * Vector3d::UnitY()).norm() < 1e-11 * fastest);
    }
    // Pin and motor together, on the bar that they carry.
    const std::vector<spatial::Wrench> joints = chain.joint_wrenches(state);
    double largest = 0.0;
    for (const spatial::Wrench& joint : joints) {
      largest = std::max({largest, joint.force.norm(), joint.moment.norm()});
    }
    for (int i = 0; i < 3; ++i) {
      spatial::Wrench sum;
      for (const planar::Reaction& reaction : planar::reactions_of(plane, planar_state)) {
        if (reaction.on != i || reaction.joint / 2 != i) continue;
        sum.force += from_plane(reaction.force);
        sum.moment -= reaction.moment * Vector3d::UnitY();
      }
      CHECK((joints[static_cast<std::size_t>(i)].force - sum.force).norm() < 1e-11 * largest);
      CHECK((joints[static_cast<std::size_t>(i)].moment - sum.moment).norm() < 1e-11 * largest);
    }
    const CutForceDiagram one =
        cut_forces_of(planar::beam_loads_of(plane, planar_state, planar_beam));
    const CutForceDiagram two = cut_forces_of(beam_loads_of(chain, state, beam));
    for (double s = 0.03; s < linkage.length; s += 0.1) {
      for (std::size_t i = 0; i < cut_force::count; ++i) {
        const auto which = static_cast<cut_force::Index>(i);
        CHECK(std::abs(value_of(cut(one, s), which) - value_of(cut(two, s), which)) <
              1e-11 * largest);
      }
    }
  }
}

}  // namespace planar_linkage_test
