// Loads on a beam that moves in space: balance, turned worlds, loads off the axis and on stretches.

#include "boxbeam/mechanism/spatial/beam_loads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"

namespace beam_loads_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

Section box(double width, double height, double wall) {
  return {symmetric_box(si<Length>(width), si<Length>(height), si<Length>(wall), si<Length>(wall)),
          {}};
}

/// Three segments, the middle one tapered; unequal walls, so that I_yz is not zero.
TaperedBeam tapered_beam() {
  Box from = symmetric_box(0.1 * metre, 0.2 * metre, 0.01 * metre, 0.01 * metre);
  from.stiffeners = {{BoxPlate::top_flange, 0.02 * metre, 0.03 * metre, 0.01 * metre}};
  Box to = from;
  to.height = 0.3 * metre;
  TaperedBeam beam;
  beam.density = si<Density>(800.0);
  beam.rotary_inertia = true;
  const Length a = 0.5 * metre, b = 0.75 * metre;
  beam.segments = {{"", 0.0 * metre, a, {from, {}}, {from, {}}},
                   {"", a, b, {from, {}}, {to, {}}},
                   {"", a + b, a, {to, {}}, {to, {}}}};
  return beam;
}

/// The beam takes the place of a body of a random tree; line forces on it lie along its axis.
struct BeamTree {
  TaperedBeam beam = tapered_beam();
  Mechanism mechanism;
  BeamBody body;

  explicit BeamTree(test::Chance& chance) : mechanism(test::random_tree(chance, 12)) {
    BeamPlacement placement;
    placement.body = 4;
    placement.axes = chance.rotation();
    placement.start = chance.vector();
    give_mass(mechanism.bodies[4], placement, beam);
    for (LineForce& line : mechanism.line_forces) {
      line.on = 4;
      line.from = placement.start + (chance.one_of(2) == 0 ? 0.5 : 1.25) * placement.axes.col(0);
      line.to = placement.start + (chance.one_of(2) == 0 ? 0.0 : 1.75) * placement.axes.col(0);
    }
    for (std::size_t i = 0; i < 4; ++i) mechanism.loads[i].on = 4;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      if (mechanism.joints[i].kind == JointKind::revolute)
        mechanism.torsion_springs.push_back({"bar " + std::to_string(i), static_cast<int>(i),
                                             30.0 + chance.any(20.0), chance.any(), 2.0});
    }
    body = beam_body_of(beam, placement, mechanism);
  }
};

double largest_of(const BeamLoads& loads) {
  double largest = 0.0;
  for (const PointLoad& load : loads.points) {
    largest = std::max({largest, load.force.norm(), load.moment.norm()});
  }
  return largest;
}

CutForces cut(const CutForceDiagram& diagram, double s) {
  return diagram.at({si<Length>(s), Side::both});
}

}  // namespace

// Newton's third law: in beam axes a load has the length of the joint's force in the world.
TEST_CASE("every load in space is named after its joint or force") {
  test::Chance chance(67);
  for (int tree = 0; tree < 20; ++tree) {
    BeamTree random(chance);
    Mechanism& mechanism = random.mechanism;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      mechanism.joints[i].name = "joint " + std::to_string(i);
    }
    for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
      mechanism.loads[i].name = "load " + std::to_string(i);
    }
    const Chain chain(mechanism);
    const State state = chain.at(0.4);
    const BeamLoads loads = beam_loads_of(chain, state, random.body);
    const std::vector<Wrench> wrenches = chain.joint_wrenches(state);
    std::size_t expected = 0;
    const auto check = [&](const std::string& name, double size, bool is_force) {
      ++expected;
      const auto load = std::find_if(loads.points.begin(), loads.points.end(),
                                     [&](const PointLoad& l) { return l.name == name; });
      REQUIRE(load != loads.points.end());
      if (is_force) CHECK(load->force.norm() == Approx(size).epsilon(1e-10));
    };
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      if (i != 4 && mechanism.joints[i].parent != 4) continue;
      check(mechanism.joints[i].name, wrenches[i].force.norm(), true);
    }
    for (const AppliedLoad& load : mechanism.loads) {
      if (load.on != 4) continue;
      check(load.name, std::abs(driver_at(load.size, state.time).value) * load.direction.norm(),
            load.kind == LoadKind::force);
    }
    for (TorsionSpring& spring : mechanism.torsion_springs) {
      const int parent = mechanism.joints[static_cast<std::size_t>(spring.joint)].parent;
      if (spring.joint == 4 || parent == 4) check(spring.name, 0.0, false);
    }
    CHECK(loads.points.size() == expected);
  }
}

TEST_CASE("all loads on a beam in a random tree are in balance") {
  test::Chance chance(61);
  for (int tree = 0; tree < 60; ++tree) {
    const BeamTree of(chance);
    const Chain chain(of.mechanism);
    for (const double time : {0.2, 0.5, 0.9}) {
      const BeamLoads loads = beam_loads_of(chain, chain.at(time), of.body);
      const Imbalance open = imbalance_of(loads);
      CHECK(open.force.norm() < 1e-12 * largest_of(loads));
      CHECK(open.moment.norm() < 1e-12 * largest_of(loads));
    }
  }
}

TEST_CASE("the whole world turned: the same loads on the beam and the same cut forces") {
  test::Chance chance(62);
  for (int tree = 0; tree < 40; ++tree) {
    const BeamTree of(chance);
    const Mechanism turned = test::turned_world(of.mechanism, chance.rotation());
    const Chain chain(of.mechanism), turned_chain(turned);
    const BeamLoads one = beam_loads_of(chain, chain.at(0.5), of.body);
    const BeamLoads two = beam_loads_of(turned_chain, turned_chain.at(0.5), of.body);
    const double size = 1e-11 * largest_of(one);
    REQUIRE(one.points.size() == two.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
      CHECK(std::abs((one.points[i].s - two.points[i].s).value()) < 1e-11);
      CHECK((one.points[i].force - two.points[i].force).norm() < size);
      CHECK((one.points[i].moment - two.points[i].moment).norm() < size);
    }
    const CutForceDiagram first = cut_forces_of(one);
    const CutForceDiagram second = cut_forces_of(two);
    for (double s = 0.03; s < 1.7; s += 0.1) {
      for (std::size_t k = 0; k < cut_force::count; ++k) {
        const auto which = static_cast<cut_force::Index>(k);
        CHECK(std::abs(value_of(cut(first, s), which) - value_of(cut(second, s), which)) < size);
      }
    }
  }
}

TEST_CASE("a beam alone in its body has the mass of its segments where they lie") {
  // Two uniform segments by hand: of the whole section, A = 0.2 0.3 - 0.16 0.26.
  TaperedBeam beam;
  beam.density = si<Density>(1000.0);
  beam.segments = {{"", 0.0 * metre, 2.0 * metre, box(0.2, 0.3, 0.02), box(0.2, 0.3, 0.02)}};
  const double m = 1000.0 * 2.0 * (0.2 * 0.3 - 0.16 * 0.26);
  BeamPlacement placement;
  placement.start = {1.0, -2.0, 3.0};
  placement.axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // x of the beam along y of the body, y along z
  Body body;
  give_mass(body, placement, beam);
  CHECK(body.mass == Approx(m));
  CHECK((body.centre - Vector3d(1.0, -1.0, 3.0)).norm() < 1e-14);
  const Vector3d diagonal(m * 4.0 / 12.0, 0.0, m * 4.0 / 12.0);
  CHECK((body.inertia - Eigen::Matrix3d(diagonal.asDiagonal())).norm() < 1e-12 * m);
  CHECK((in_beam(placement, {4.0, -1.5, 5.0}) - Vector3d(0.5, 2.0, 3.0)).norm() < 1e-15);
}

TEST_CASE("what acts off the axis adds its moment; a place may belong to another body") {
  // A beam along x at rest; on its tip at (2, 0.3, -0.4) a body whose own point feels 5 N along z
  // of the world, and a load of 7 N along y of the beam at a place of that body, (2.5, 0.3, -0.4).
  TaperedBeam beam;
  beam.density = si<Density>(0.0);
  beam.segments = {{"", 0.0 * metre, 3.0 * metre, box(0.2, 0.3, 0.02), box(0.2, 0.3, 0.02)}};
  Mechanism mechanism;
  mechanism.bodies.resize(2);
  mechanism.joints.resize(2);
  mechanism.joints[1].parent = 0;
  mechanism.joints[1].at = {2.0, 0.3, -0.4};
  mechanism.loads = {
      {"tip", LoadKind::force, 1, {1, {0, 0, 0}}, ground, {0, 0, 1}, PolynomialDriver{{5.0}}},
      {"side", LoadKind::force, 0, {1, {0.5, 0, 0}}, ground, {0, 1, 0}, PolynomialDriver{{7.0}}},
      {"twist", LoadKind::couple, 0, {1, {0.5, 0, 0}}, ground, {1, 0, 0}, PolynomialDriver{{3.0}}}};
  const Chain chain(mechanism);
  BeamPlacement placement;
  placement.body = 0;
  const BeamLoads loads =
      beam_loads_of(chain, chain.at(0.0), beam_body_of(beam, placement, mechanism));
  REQUIRE(loads.points.size() == 4);
  // The joint with the ground, at the start: the opposite of all.
  CHECK(loads.points[0].s.value() == 0.0);
  CHECK((loads.points[0].force - Vector3d(0, -7, -5)).norm() < 1e-14);
  // The joint of the tip: moment (0, 0.3, -0.4) x (0, 0, 5).
  CHECK(loads.points[1].s.value() == 2.0);
  CHECK((loads.points[1].force - Vector3d(0, 0, 5)).norm() < 1e-14);
  CHECK((loads.points[1].moment - Vector3d(1.5, 0, 0)).norm() < 1e-14);
  // The load: moment (0, 0.3, -0.4) x (0, 7, 0), and the couple where it enters.
  CHECK(loads.points[2].s.value() == 2.5);
  CHECK((loads.points[2].moment - Vector3d(2.8, 0, 0)).norm() < 1e-14);
  CHECK(loads.points[3].s.value() == 2.5);
  CHECK((loads.points[3].moment - Vector3d(3, 0, 0)).norm() < 1e-14);
  CHECK(loads.points[3].force.norm() == 0.0);
  CHECK((loads.points[0].moment + Vector3d(1.5 + 2.8 + 3.0, -2.0 * 5.0, 2.5 * 7.0)).norm() < 1e-13);
}

TEST_CASE("a line force acts between its ends, whichever comes first, and nowhere else") {
  TaperedBeam beam;
  beam.density = si<Density>(0.0);
  const Section tube = box(0.2, 0.3, 0.02);
  beam.segments = {{"", 0.0 * metre, 1.0 * metre, tube, tube},
                   {"", 1.0 * metre, 2.0 * metre, tube, tube},
                   {"", 3.0 * metre, 1.0 * metre, tube, tube}};
  Mechanism mechanism;
  mechanism.bodies.resize(1);
  mechanism.joints.resize(1);
  mechanism.joints[0].turn = rotation_about({0.0, 0.0, 0.5 * std::numbers::pi});
  BeamPlacement placement;
  placement.body = 0;
  for (const bool reversed : {false, true}) {
    const Vector3d low(1.0, 0.0, 0.0), high(3.0, 0.0, 0.0);
    mechanism.line_forces = {{"air",
                              0,
                              reversed ? high : low,
                              reversed ? low : high,
                              ground,
                              {-1, 0, 0},
                              PolynomialDriver{{40.0}}}};
    const Chain chain(mechanism);
    const BeamLoads loads =
        beam_loads_of(chain, chain.at(0.0), beam_body_of(beam, placement, mechanism));
    // -x of the world is y of the beam.
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(loads.lines[i].force[0](0.3) == Approx(0.0).margin(1e-13));
      CHECK(loads.lines[i].force[1](0.3) == Approx(i == 1 ? 40.0 : 0.0).margin(1e-13));
      CHECK(loads.lines[i].force[2](0.3) == Approx(0.0).margin(1e-13));
    }
    // 80 N at 2 m from the start.
    CHECK((loads.points[0].force - Vector3d(0, -80, 0)).norm() < 1e-12);
    CHECK((loads.points[0].moment - Vector3d(0, 0, -160)).norm() < 1e-12);
    CHECK(imbalance_of(loads).moment.norm() < 1e-12);
  }
}

}  // namespace beam_loads_test
