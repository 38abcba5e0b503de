// Friction of joints that slide in space: by hand, against the planar front end, and by balances
// that hold in every mechanism.

#include "boxbeam/mechanism/spatial/friction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"
#include "support/spatial_balance.hpp"

namespace spatial_friction_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::set_mass;

namespace {

constexpr double g = 9.81;

int add(Mechanism& mechanism, const char* name, JointKind kind, int parent, const Vector3d& at,
        const Vector3d& axis, MovedBy moved_by) {
  const int body = test::add(mechanism, test::joint_of(name, kind, parent, at, axis), false);
  mechanism.joints.back().moved_by = moved_by;
  return body;
}

/// The contact forces at both ends of a guide, by its wrench: N/2 and the pair whose couple is the
/// part of M across the guide, a/2 x F l - a/2 x (-F) l.
double pressure_by_ends(const Wrench& wrench, const Vector3d& a, double l) {
  const Vector3d N = wrench.force - a.dot(wrench.force) * a;
  if (l == 0.0) return N.norm();
  const Vector3d M = wrench.moment - a.dot(wrench.moment) * a;
  Vector3d F = M.cross(a) / l;
  REQUIRE((l * a.cross(F) - M).norm() <= 1e-12 * (1.0 + M.norm()));
  return (0.5 * N + F).norm() + (0.5 * N - F).norm();
}

/// Every contact's friction by what its joint carries; how many rub.
int check_laws(const Chain& chain, double time) {
  const Mechanism& mechanism = chain.mechanism();
  const State state = chain.at(time);
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  REQUIRE(state.friction.size() == chain.contacts().size());
  int rubbing = 0;
  for (std::size_t j = 0; j < chain.contacts().size(); ++j) {
    const std::size_t joint = chain.contacts()[j].joint;
    const Friction& law = chain.contacts()[j].law;
    double v = 0.0;
    Vector3d a;
    if (joint < mechanism.joints.size()) {
      v = state.coordinates[joint].rate;
      a = in_world(state, mechanism.joints[joint].parent, mechanism.joints[joint].axis);
    } else {
      const ClosingJoint& closing = mechanism.closing[joint - mechanism.joints.size()];
      a = in_world(state, closing.a.body, closing.axis);
      v = a.dot(velocity_of(state, closing.b) - velocity_of(state, closing.a));
    }
    const double P = pressure_by_ends(joints[joint], a, law.guide);
    const double expected = -law.coulomb * P * v / std::hypot(v, law.creep) - law.viscous * v;
    CHECK(state.friction[j] == Approx(expected).epsilon(1e-9).margin(1e-10));
    if (std::abs(expected) > 1e-6) ++rubbing;
  }
  return rubbing;
}

}  // namespace

TEST_CASE("what presses on a guide is the sizes of the contact forces at its two ends") {
  // By hand: N = 30 N at half on both ends; a couple of 8 N m over 0.2 m is 40 N at each. In one
  // plane 55 N and -25 N, together max(30, 2 x 40); square to each other twice hypot(15, 40).
  Friction law;
  law.guide = 0.2;
  GuideLoad load;
  load << 0.0, 30.0, 0.0, 0.0, 8.0, 0.0;
  CHECK(pressure_of(law, load) == Approx(80.0).epsilon(1e-14));
  load << 0.0, 30.0, 0.0, 0.0, 0.0, 8.0;
  CHECK(pressure_of(law, load) == Approx(2.0 * std::hypot(15.0, 40.0)).epsilon(1e-14));
  load << 0.0, 100.0, 0.0, 0.0, 8.0, 0.0;
  CHECK(pressure_of(law, load) == Approx(100.0).epsilon(1e-14));
  law.guide = 0.0;
  CHECK(pressure_of(law, load) == Approx(100.0).epsilon(1e-14));
}

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

TEST_CASE("friction changes nothing but the drive of a joint that a driver moves") {
  // It acts between the same bodies along the same line as the drive.
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Chance chance(seed);
    const Mechanism smooth = test::random_tree(chance, 12);
    Mechanism rough = smooth;
    for (Joint& joint : rough.joints)
      if (joint.kind == JointKind::prismatic) joint.friction = {0.3, 5.0, 0.1, 0.2};
    const Chain without(smooth), with(rough);
    const double time = 0.1 * seed;
    const State state = with.at(time);
    const std::vector<Wrench> one = without.joint_wrenches(without.at(time)),
                              two = with.joint_wrenches(state);
    double largest = 0.0;
    for (const Wrench& of : one) largest = std::max({largest, of.force.norm(), of.moment.norm()});
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK((one[i].force - two[i].force).norm() < 1e-12 * largest);
      CHECK((one[i].moment - two[i].moment).norm() < 1e-12 * largest);
      if (rough.joints[i].kind != JointKind::prismatic) continue;
      const double v = state.coordinates[i].rate;
      const Vector3d a = in_world(state, rough.joints[i].parent, rough.joints[i].axis);
      const double rubs = 0.3 * pressure_by_ends(one[i], a, 0.2) * v / std::hypot(v, 0.1) + 5.0 * v;
      CHECK(with.along_axis(state, i, two[i]) - a.dot(one[i].force) ==
            Approx(rubs).margin(1e-12 * largest));
    }
    CHECK(check_laws(with, time) > 0);
  }
}

TEST_CASE("loops that rub: every body in equilibrium, and power in balance") {
  // A table on a slide, an arm on it that a ball-ended strut holds, whose other end a cylinder's
  // sleeve guides along a line askew in space, on a body that turns.
  int rubbing = 0, ended = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Chance chance(100 + seed);
    Mechanism mechanism;
    mechanism.gravity = chance.vector(10.0);
    const auto mass = [&](int of) {
      spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(of)];
      body.mass = 2.0 + chance.any(1.0);
      body.centre = chance.vector(0.3);
      body.inertia = chance.inertia(body.mass, 0.4);
    };
    const auto driven = [&](double rate) {
      mechanism.joints.back().driver = HarmonicDriver{0.0, 0.03, rate, 0.2, {}};
    };
    const int base = add(mechanism, "base", JointKind::revolute, ground, chance.vector(),
                         chance.direction(), MovedBy::driver);
    driven(2.0);
    const int table = add(mechanism, "table", JointKind::prismatic, base, chance.vector(),
                          chance.direction(), MovedBy::loops);
    mechanism.joints.back().friction = {0.06, 3.0, 0.01, 0.4};
    const int arm = add(mechanism, "arm", JointKind::revolute, table, chance.vector(0.3),
                        chance.direction(), MovedBy::driver);
    driven(3.0);
    const int first = add(mechanism, "first", JointKind::revolute, arm, chance.vector(0.5),
                          chance.direction(), MovedBy::loops);
    const int second = add(mechanism, "second", JointKind::revolute, first, Vector3d::Zero(),
                           chance.direction(), MovedBy::loops);
    const int other = add(mechanism, "other", JointKind::prismatic, ground, chance.vector(),
                          chance.direction(), MovedBy::driver);
    driven(1.5);
    mechanism.joints.back().friction = {0.2, 0.0, 0.01, 0.0};
    for (const int of : {base, table, arm, second, other}) mass(of);
    ClosingJoint closing;
    closing.name = "sleeve";
    constexpr ClosingKind kinds[] = {ClosingKind::slot, ClosingKind::cylindrical,
                                     ClosingKind::prismatic};
    closing.kind = kinds[seed % 3];
    int last = second;
    if (closing.kind == ClosingKind::slot) {
      // Two equations: the table and one turn.
      mechanism.joints[static_cast<std::size_t>(second)].moved_by = MovedBy::driver;
      closing.friction = {0.05, 1.0, 0.01, 0.0};
    } else {
      // Four equations or five: one more turn in the chain, or two.
      closing.friction = {0.05, 1.0, 0.01, 0.5};
      for (unsigned k = 0; k < seed % 3; ++k) {
        last = add(mechanism, "more", JointKind::revolute, last, chance.vector(0.4),
                   chance.direction(), MovedBy::loops);
        mass(last);
      }
    }
    closing.b = {last, chance.vector(0.5)};
    const Tree tree(mechanism);
    State state;
    tree.begin(state);
    tree.move(state);
    closing.axis = chance.direction();
    closing.turn = motion_of(state, other).R_WB.transpose() * motion_of(state, closing.b.body).R_WB;
    closing.a = {other, in_axes(state, other,
                                position_of(state, closing.b) - motion_of(state, other).position)};
    mechanism.closing = {closing};
    mechanism.loads = {{"load",
                        LoadKind::force,
                        second,
                        {second, chance.vector()},
                        ground,
                        chance.direction(),
                        PolynomialDriver{{30.0}}}};
    mechanism.duration.length = 0.3;
    try {
      const Chain chain(mechanism);
      for (int k = 0; k <= 20; ++k) {
        test::check_balance(chain, 0.015 * k, 1e-9);
        rubbing += check_laws(chain, 0.015 * k);
      }
    } catch (const AnalysisError&) {
      // By chance it may come to a dead point, or lock.
      ++ended;
    }
  }
  CHECK(ended <= 2);
  CHECK(rubbing > 450);
}

namespace {

/// A block on an incline that rises along its x at an angle, turned about the vertical; by forces.
Mechanism block_on_incline(double angle, const Friction& law, double rate) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -g};
  const double s = std::sin(angle), c = std::cos(angle);
  add(mechanism, "block", JointKind::prismatic, ground, Vector3d::Zero(),
      Vector3d(-0.6 * c, -0.8 * c, -s), MovedBy::forces);
  mechanism.joints[0].friction = law;
  mechanism.joints[0].start_rate = rate;
  set_mass(mechanism.bodies[0], 7.0, Vector3d::Zero(), {0.1, 0.2, 0.3});
  mechanism.duration.length = 0.5;
  return mechanism;
}

}  // namespace

TEST_CASE("a block slides down an incline with g (sin a - mu cos a)") {
  const double angle = 0.6, mu = 0.3, creep = 1e-6;
  const Mechanism mechanism = block_on_incline(angle, {mu, 0.0, creep, 0.0}, 1.0);
  const Chain chain(mechanism);
  const double a = g * (std::sin(angle) - mu * std::cos(angle));
  for (const double time : {0.0, 0.2, 0.5}) {
    const State state = chain.at(time);
    // (creep/v)^2/2 of the friction is missing: 5e-13.
    CHECK(state.coordinates[0].acceleration == Approx(a).epsilon(1e-11));
    CHECK(state.coordinates[0].value == Approx(time + 0.5 * a * time * time).epsilon(1e-9));
    CHECK(state.friction[0] == Approx(-mu * 7.0 * g * std::cos(angle)).epsilon(1e-11));
    test::check_balance(chain, time);
  }
}

TEST_CASE("a block that friction holds creeps as slowly as its law says") {
  // v/hypot(v, creep) = tan a/mu: the share of mu P that holds it.
  const double angle = 0.25, mu = 0.5, creep = 0.01;
  const Mechanism mechanism = block_on_incline(angle, {mu, 0.0, creep, 0.0}, 0.0);
  const Chain chain(mechanism);
  const double share = std::tan(angle) / mu;
  const State state = chain.at(0.5);
  CHECK(state.coordinates[0].rate ==
        Approx(creep * share / std::sqrt(1.0 - share * share)).epsilon(1e-8));
  CHECK(state.coordinates[0].acceleration == Approx(0.0).margin(1e-7));
}

namespace {

/// A slide along x without weight, on a guide of 0.3 m, that a rod parallel to it, beside it by 0.2
/// m, pushes slowly against a force of 100 N through the guide.
Mechanism pushed_beside(double mu) {
  Mechanism mechanism;
  add(mechanism, "slide", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX(),
      MovedBy::loops);
  mechanism.joints[0].friction = {mu, 0.0, 1e-9, 0.3};
  const Vector3d beside(0.0, 0.12, 0.16);
  ClosingJoint rod;
  rod.name = "rod";
  rod.kind = ClosingKind::distance;
  rod.a = {ground, beside - 2.0 * Vector3d::UnitX()};
  rod.b = {0, beside};
  rod.length = PolynomialDriver{{2.0, 0.1}};
  rod.driver_name = "push";
  mechanism.closing = {rod};
  mechanism.loads = {{"load",
                      LoadKind::force,
                      0,
                      {0, {0.05, 0.0, 0.0}},
                      ground,
                      -Vector3d::UnitX(),
                      PolynomialDriver{{100.0}}}};
  mechanism.duration.length = 1.0;
  return mechanism;
}

}  // namespace

TEST_CASE("a slide pushed beside its guide needs F/(1 - 2 mu e/l), and jams at mu = l/(2 e)") {
  // By hand: the rod's couple R e is taken by R e/l at both ends, whose friction is mu 2 R e/l.
  const double jams = 0.3 / (2.0 * 0.2);
  for (const double mu : {0.1, 0.5, 0.99 * jams}) {
    const Mechanism mechanism = pushed_beside(mu);
    const Chain chain(mechanism);
    const State state = chain.at(0.4);
    const double R = 100.0 / (1.0 - mu / jams);
    CHECK(chain.joint_wrenches(state)[1].force.x() == Approx(R).epsilon(1e-10));
    CHECK(state.friction[0] == Approx(100.0 - R).epsilon(1e-9));
    test::check_balance(chain, 0.4);
  }
  const Mechanism locked = pushed_beside(1.01 * jams);
  const Chain chain(locked);
  try {
    static_cast<void>(chain.at(0.4));
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint slide");
    CHECK(error.failure().what.find("locks") != std::string::npos);
    CHECK(error.failure().time == 0.4);
  }
}

TEST_CASE("a slide that a force beside its guide moves stands still from mu = l/(2 e) on") {
  // By hand: m a = F - mu 2 F e/l.
  const double jams = 0.3 / (2.0 * 0.2), F = 40.0, m = 2.0;
  for (const double mu : {0.5 * jams, 1.5 * jams}) {
    CAPTURE(mu);
    Mechanism mechanism = pushed_beside(mu);
    mechanism.closing.clear();
    mechanism.joints[0].moved_by = MovedBy::forces;
    mechanism.joints[0].friction.creep = 1e-3;
    set_mass(mechanism.bodies[0], m, Vector3d::Zero(), {0.0, 0.0, 0.0});
    mechanism.loads = {{"load",
                        LoadKind::force,
                        0,
                        {0, {0.0, 0.12, 0.16}},
                        ground,
                        Vector3d::UnitX(),
                        PolynomialDriver{{F}}}};
    mechanism.duration.length = 0.4;
    const Chain chain(mechanism);
    const State state = chain.at(0.4);
    if (mu < jams) {
      CHECK(state.coordinates[0].acceleration == Approx(F / m * (1.0 - mu / jams)).epsilon(1e-5));
    } else {
      // The share jams/mu of the friction holds it.
      CHECK(state.coordinates[0].rate == Approx(1e-3 / std::sqrt(1.5 * 1.5 - 1.0)).epsilon(1e-7));
    }
  }
}

TEST_CASE("a slide with its mass beside its guide brakes itself, and locks at mu = l/(2 e)") {
  // By hand: braked by F along the guide, m |a| e tilts it, and m |a| = F + mu 2 m |a| e/l.
  // Pushed ahead as fast, m a = F - mu 2 m a e/l. No acceleration is enough from mu = l/(2 e) on.
  const double jams = 0.3 / (2.0 * 0.2), F = 40.0, m = 2.0;
  const auto sliding = [&](double mu, double sense) {
    Mechanism mechanism = pushed_beside(mu);
    mechanism.closing.clear();
    mechanism.joints[0].moved_by = MovedBy::forces;
    mechanism.joints[0].start_rate = 1.0;
    set_mass(mechanism.bodies[0], m, {0.0, 0.12, 0.16}, {0.0, 0.0, 0.0});
    mechanism.loads[0].direction = sense * Vector3d::UnitX();
    mechanism.loads[0].size = PolynomialDriver{{F}};
    mechanism.duration.length = 0.01;
    return mechanism;
  };
  for (const double mu : {0.3 * jams, 0.9 * jams}) {
    const Mechanism braked = sliding(mu, -1.0), pushed = sliding(mu, 1.0);
    CHECK(Chain(braked).at(0.0).coordinates[0].acceleration ==
          Approx(-F / m / (1.0 - mu / jams)).epsilon(1e-9));
    CHECK(Chain(pushed).at(0.0).coordinates[0].acceleration ==
          Approx(F / m / (1.0 + mu / jams)).epsilon(1e-9));
    test::check_balance(Chain(braked), 0.001);
  }
  const Mechanism locked = sliding(1.2 * jams, -1.0);
  try {
    const Chain chain(locked);
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint slide");
    CHECK(error.failure().what.find("locks") != std::string::npos);
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

TEST_CASE("a creep velocity is a fiftieth of the fastest that drivers give a contact") {
  // By hand: 0.2 m x 3 rad/s.
  Mechanism mechanism;
  add(mechanism, "sled", JointKind::prismatic, ground, Vector3d::Zero(), {1.0, 2.0, 2.0},
      MovedBy::driver);
  mechanism.joints[0].driver = HarmonicDriver{0.0, 0.2, 3.0, 0.0, {}};
  mechanism.joints[0].friction.coulomb = 0.1;
  mechanism.joints[0].friction.creep = 1.0;
  Mechanism given = mechanism;
  fit_creep(mechanism, {0});
  CHECK(mechanism.joints[0].friction.creep == Approx(0.02 * 0.6).epsilon(1e-6));
  fit_creep(given, {});
  CHECK(given.joints[0].friction.creep == 1.0);
  CHECK(fitted_creep(given.joints[0].friction, 1e-17, 1.0) == 1.0);  // it stands
  given.joints[0].moved_by = MovedBy::forces;
  fit_creep(given, {});
  CHECK(given.joints[0].friction.creep == 1.0);
  fit_creep(given, {0});
  CHECK(given.joints[0].friction.creep == 0.0);  // it sticks
}

}  // namespace spatial_friction_test
