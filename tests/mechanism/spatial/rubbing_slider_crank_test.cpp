// A slider-crank that rubs in space, turned as it will, against the planar front end.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "catch.hpp"
#include "mechanism/spatial/rubbing.hpp"
#include "support/random_tree.hpp"
#include "support/spatial_balance.hpp"

namespace rubbing_slider_crank_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using namespace rubbing;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::set_mass;

namespace {

/// A crank of 0.3 m, a rod of 1 m that is the beam, and a slider on a line 0.1 m above the crank's
/// bearing, whose centre lies beside the pin and on which a force acts; or the rod's end alone in a
/// slot along that line.
struct SliderCrank {
  bool slot = false;
  Friction friction{0.25, 12.0, 0.02, 0.15};
  TaperedBeam beam;
  double mass = 0.0, inertia = 0.0, centre = 0.0;
  Driver turn = PolynomialDriver{{0.4, 2.0, 0.7}};
  Driver push = HarmonicDriver{150.0, 90.0, 5.0, 0.3, {}};
  static constexpr double r = 0.3, l = 1.0, height = 0.1, lean = 2.2;

  explicit SliderCrank(bool in_slot) : slot(in_slot) {
    const Box box = symmetric_box(0.05 * metre, 0.08 * metre, 0.004 * metre, 0.004 * metre);
    beam.density = si<Density>(7850.0);
    beam.rotary_inertia = true;
    beam.segments = {{"", 0.0 * metre, l * metre, {box, {}}, {box, {}}}};
    const MassProperties properties = mass_properties_of(beam);
    mass = properties.mass.value();
    inertia = properties.inertia.value();
    centre = properties.centre.value();
    if (slot) friction.guide = 0.0;
  }

  double rod_angle() const { return std::asin((height - r * std::sin(0.4)) / l); }
  double slide() const { return r * std::cos(0.4) + l * std::cos(rod_angle()); }

  planar::Mechanism in_plane() const {
    planar::Mechanism mechanism;
    mechanism.gravity = {0.0, -g};
    const Eigen::Vector2d pin(r * std::cos(0.4), r * std::sin(0.4));
    const double angle = rod_angle();
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    boxbeam::Body crank{"crank", 2.0, 0.03, {}, {0.5 * pin, 0.4}};
    boxbeam::Body rod{"rod", mass, inertia, {}, {pin + centre * along, angle}};
    boxbeam::Body slider{"slider", 5.0, 0.2, {}, {{slide() + 0.07, height + 0.04}, 0.0}};
    const planar::Attachment bearing{0, {-0.5 * r, 0.0}}, end{1, {l - centre, 0.0}};
    mechanism.bodies = {crank, rod};
    mechanism.joints = {{"bearing", planar::Pin{bearing, {}}},
                        {"motor", planar::Driven{bearing, planar::Coordinate::angle, turn, {}}},
                        {"crank pin", planar::Pin{{1, {-centre, 0.0}}, {0, {0.5 * r, 0.0}}}}};
    const planar::Attachment line{planar::ground, {0.0, height}};
    if (slot) {
      mechanism.joints.push_back({"slot", planar::PinInSlot{end, line, 0.0, friction}});
    } else {
      mechanism.bodies.push_back(slider);
      mechanism.joints.push_back({"pin", planar::Pin{end, {2, {-0.07, -0.04}}}});
      mechanism.joints.push_back(
          {"rail", planar::Slider{{2, {-0.07, -0.04}}, line, 0.0, 0.0, friction}});
    }
    const planar::Attachment at = slot ? end : planar::Attachment{2, {0.1, 0.2}};
    mechanism.forces = {{"push", planar::PointForce{at, lean, false, push}}};
    return mechanism;
  }

  /// The plane's x and y are x and z here, counter-clockwise is about -y.
  Mechanism in_space() const {
    Mechanism mechanism;
    mechanism.gravity = {0.0, 0.0, -g};
    const Vector3d about = -Vector3d::UnitY();
    add(mechanism, "crank", JointKind::revolute, ground, Vector3d::Zero(), about, MovedBy::driver);
    mechanism.joints[0].driver = turn;
    int rod = add(mechanism, "rod", JointKind::revolute, 0, {r, 0.0, 0.0}, about, MovedBy::loops);
    mechanism.joints[1].start = rod_angle() - 0.4;
    set_mass(mechanism.bodies[0], 2.0, {0.5 * r, 0.0, 0.0}, {0.0, 0.03, 0.0});
    ClosingJoint closing;
    closing.name = "closing";
    closing.kind = ClosingKind::slot;
    if (slot) {
      // In space the rod may leave the plane, and stays in it.
      rod = add(mechanism, "tilt", JointKind::revolute, rod, Vector3d::Zero(), Vector3d::UnitZ(),
                MovedBy::loops);
      closing.a = {ground, {0.0, 0.0, height}};
      closing.b = {rod, {l, 0.0, 0.0}};
      closing.axis = Vector3d::UnitX();
      closing.friction = friction;
    } else {
      const int slider = add(mechanism, "rail", JointKind::prismatic, ground, {0.0, 0.0, height},
                             Vector3d::UnitX(), MovedBy::loops);
      mechanism.joints.back().start = slide();
      mechanism.joints.back().friction = friction;
      set_mass(mechanism.bodies.back(), 5.0, {0.07, 0.0, 0.04}, {0.0, 0.2, 0.0});
      // A pin that leaves open where it is along its axis, so that nothing is held twice.
      closing.a = {slider, Vector3d::Zero()};
      closing.b = {rod, {l, 0.0, 0.0}};
      closing.axis = Vector3d::UnitY();
    }
    mechanism.closing = {closing};
    spatial::give_mass(mechanism.bodies[static_cast<std::size_t>(rod)], placement(), beam);
    const int on = slot ? rod : 2;
    const Vector3d at = slot ? Vector3d(l, 0.0, 0.0) : Vector3d(0.17, 0.0, 0.24);
    mechanism.loads = {{"push",
                        LoadKind::force,
                        on,
                        {on, at},
                        ground,
                        {std::cos(lean), 0.0, std::sin(lean)},
                        push}};
    mechanism.duration.length = 2.0;
    return mechanism;
  }

  BeamPlacement placement() const {
    BeamPlacement placement;
    placement.body = slot ? 2 : 1;
    return placement;
  }
};

/// The whole world turned, with closing joints on the ground.
Mechanism turned(const Mechanism& mechanism, const Matrix3d& turn) {
  Mechanism other = test::turned_world(mechanism, turn);
  for (ClosingJoint& joint : other.closing) {
    if (joint.a.body != ground) continue;
    joint.a.p = turn * joint.a.p;
    joint.axis = turn * joint.axis;
    joint.turn = turn * joint.turn;
  }
  return other;
}

}  // namespace

TEST_CASE("a slider-crank that rubs, in any orientation: forces and beam loads of the plane") {
  for (const bool slot : {false, true}) {
    const SliderCrank linkage(slot);
    const planar::Mechanism plane = linkage.in_plane();
    test::Chance chance(7);
    const Matrix3d turn = chance.rotation();
    const Mechanism space = turned(linkage.in_space(), turn);
    const Chain chain(space);
    REQUIRE(chain.loops()->repeating() == 0);
    const auto planar_beam = planar::beam_body_of(linkage.beam, 1);
    const BeamBody beam = spatial::beam_body_of(linkage.beam, linkage.placement(), space);
    planar::InstantSolver solver(plane);
    planar::State planar_state = solver.solve_from_sketch(0.0, planar::sketch_of(plane));
    const auto from_plane = [&](const Eigen::Vector2d& p) -> Vector3d {
      return turn * Vector3d(p.x(), 0.0, p.y());
    };
    const int sliding = slot ? 3 : 4;  // the joint of the plane
    double rubbed = 0.0;
    for (int k = 1; k <= 80; ++k) {
      CAPTURE(slot, k);
      planar::State next;
      solver.solve_near(0.025 * k, planar_state, next);
      planar_state = next;
      const State state = chain.at(0.025 * k);
      const std::vector<Wrench> joints = chain.joint_wrenches(state);
      double largest = 0.0;
      for (const Wrench& joint : joints)
        largest = std::max({largest, joint.force.norm(), joint.moment.norm()});
      for (const planar::Reaction& reaction : planar::reactions_of(plane, planar_state)) {
        const Vector3d force = from_plane(reaction.force);
        const Vector3d moment = -reaction.moment * turn.col(1);
        if (reaction.joint == sliding) {
          // On the slider, or on the rod's end.
          const Wrench& of = joints[slot ? 3 : 2];
          CHECK((of.force - force).norm() < 1e-9 * largest);
          CHECK((of.moment - moment).norm() < 1e-9 * largest);
          rubbed = std::max(rubbed, std::abs(reaction.force.x()) / largest);
        } else if (reaction.joint == 2 && reaction.on == 1) {
          CHECK((joints[1].force - force).norm() < 1e-9 * largest);
        } else if (reaction.joint == 1 && reaction.on == 0) {
          CHECK((joints[0].moment - moment).norm() < 1e-9 * largest);
        }
      }
      const CutForceDiagram one =
          cut_forces_of(planar::beam_loads_of(plane, planar_state, planar_beam));
      const CutForceDiagram two = cut_forces_of(spatial::beam_loads_of(chain, state, beam));
      for (double s = 0.03; s < linkage.l; s += 0.1) {
        const Station station{si<Length>(s), Side::both};
        for (std::size_t i = 0; i < cut_force::count; ++i) {
          const auto which = static_cast<cut_force::Index>(i);
          CHECK(std::abs(value_of(one.at(station), which) - value_of(two.at(station), which)) <
                1e-9 * largest);
        }
      }
      test::check_balance(chain, 0.025 * k);
      check_laws(chain, 0.025 * k);
    }
    CHECK(rubbed > 0.02);
  }
}

TEST_CASE("a slider-crank that forces move and that rubs goes as in the plane") {
  SliderCrank linkage(false);
  linkage.friction.creep = 0.05;
  planar::Mechanism plane = linkage.in_plane();
  plane.joints.erase(plane.joints.begin() + 1);
  plane.duration.length = 1.0;
  Mechanism space = linkage.in_space();
  space.joints[0].moved_by = MovedBy::forces;
  space.joints[0].start = 0.4;
  space.duration.length = 1.0;
  const Chain chain(space);
  planar::StateSolver solver(plane);
  REQUIRE(solver.integrates());
  planar::State planar_state = solver.start();
  for (int k = 1; k <= 20; ++k) {
    CAPTURE(k);
    planar_state = solver.near(0.05 * k, planar_state);
    const State state = chain.at(0.05 * k);
    CHECK(std::abs(state.coordinates[0].value - planar_state.q[2]) < 1e-7);
    CHECK(std::abs(state.coordinates[0].rate - planar_state.v[2]) < 1e-6);
    CHECK(std::abs(state.coordinates[2].rate - planar_state.v[6]) < 1e-6);
    test::check_balance(chain, 0.05 * k, 1e-9);
    check_laws(chain, 0.05 * k);
  }
}

TEST_CASE("what presses on a joint that rubs must be known") {
  // A slider-crank of pins and a slide: in space they hold each other across the plane.
  SliderCrank linkage(false);
  Mechanism mechanism = linkage.in_space();
  mechanism.closing[0].kind = ClosingKind::revolute;
  try {
    const Chain chain(mechanism);
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint rail");
    CHECK(error.failure().what.find("repeat each other") != std::string::npos);
  }
  mechanism.joints[2].friction.coulomb = 0.0;
  CHECK_NOTHROW(Chain(mechanism));  // what is viscous does not ask
}

}  // namespace rubbing_slider_crank_test
