// What can move is refused by its name, what is held twice likewise, and what is only just held is
// solved; loads and joints where something else is.

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "catch.hpp"
#include "support/rest_frame.hpp"

namespace frame_mechanism_test {

using namespace boxbeam;
using namespace boxbeam::frame;
using Catch::Matchers::Contains;

namespace {

constexpr double L = 3.0, q = 4e3;

Approx exactly(double value, double within = 1e-10) {
  return Approx(value).epsilon(within).margin(0.0);
}

Structure bar() {
  return test::level_frame({test::segment(0.0, L, test::solid(0.1, 0.2), test::solid(0.1, 0.2))});
}

TEST_CASE("a bar in space that is free in one component is refused by it", "[frame]") {
  const char* what[] = {"shift along x", "shift along y", "shift along z",
                        "turn about x",  "turn about y",  "turn about z"};
  for (std::size_t k = 0; k < 6; ++k) {
    INFO(what[k]);
    Structure of = bar();
    of.plane = false;
    std::array<double, 6> hold = test::fixed;
    hold[k] = 0.0;
    test::support(of, 0.5 * L, hold);
    CHECK_THROWS_WITH(Statics(of), Contains("member \"beam\" can " + std::string(what[k])));
    of.joints[0].stiffness[k] = 1e4;
    CHECK_NOTHROW(Statics(of));
  }
}

TEST_CASE("of several members the loose one is named", "[frame]") {
  Structure of = bar();
  Member second = of.members[0];
  second.name = "swing";
  second.start = {L, 0.0, 0.0};
  of.members.push_back(second);
  test::support(of, 0.0, test::fixed);
  Joint hinge;
  hinge.name = "hinge";
  hinge.a = {0, {L, 0.0, 0.0}};
  hinge.b = {1, Eigen::Vector3d::Zero()};
  hinge.stiffness = test::pinned;
  of.joints.push_back(hinge);
  CHECK_THROWS_WITH(Statics(of), Contains("member \"swing\" can turn about z"));
  SECTION("held by a spring it is not") {
    test::support(of, L, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 1);
    test::act(of, PointAction{{1, {L, 0.0, 0.0}}, {0.0, -3.0, 0.0}, Eigen::Vector3d::Zero()});
    CHECK(test::AtRest(of).reaction(2) == exactly(3.0));
  }
  SECTION("a second hinge in the same place shares the load nobody knows how") {
    test::support(of, L, test::roller, 1);
    hinge.name = "other hinge";
    of.joints.push_back(hinge);
    CHECK_THROWS_WITH(Statics(of),
                      Contains("joint \"other hinge\" holds rigidly along its x axis"));
    // Where one of them yields, the stiff one bears all of it.
    of.joints.back().stiffness = {1e3, 1e3, 0.0, 0.0, 0.0, 0.0};
    test::act(of,
              PointAction{{1, {0.5 * L, 0.0, 0.0}}, {0.0, -10.0, 0.0}, Eigen::Vector3d::Zero()});
    const test::AtRest at(of);
    CHECK(at.reaction(1) == exactly(-5.0));
    CHECK(std::abs(at.reaction(3)) < 1e-12);
  }
}

TEST_CASE("two rigid supports at one place are refused, a metre or a micron apart not", "[frame]") {
  Structure of = bar();
  test::support(of, 0.0, test::pinned);
  test::support(of, L, test::roller);
  test::support(of, L, test::roller);
  CHECK_THROWS_WITH(Statics(of), Contains("joint \"support 3\" holds rigidly along its y axis"));
  // Apart they clamp: the propped cantilever, 3/8 q L.
  of.joints[2].a.p.x() = L - 1e-6;
  test::act(of, test::uniform(0.0, L, -q));
  CHECK(test::AtRest(of).reaction(0) == exactly(3.0 * q * L / 8.0, 2e-6));
}

TEST_CASE("on springs of 1 N/m a bar floats: half of the load on each", "[frame]") {
  Structure of = bar();
  test::support(of, 0.0, {1e6, 1.0, 0.0, 0.0, 0.0, 0.0});
  test::support(of, L, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0});
  test::act(of, test::uniform(0.0, L, -1.0));
  const test::AtRest at(of);
  CHECK(at.reaction(0) == exactly(0.5 * L));
  CHECK(at.rise(0.0) == exactly(-0.5 * L));
}

TEST_CASE("loads within 1e-9 of an end or a support stand on it", "[frame]") {
  for (const double off : {0.0, 1e-15, 1e-13, 1e-11, 5e-10}) {
    INFO(off);
    Structure of = bar();
    test::support(of, 0.0, test::fixed);
    test::support(of, L, test::roller);
    // Its whole length: 3/8 q L. A line that ends just before the end counts as a whole.
    test::act(of, test::uniform(off * L, L * (1.0 - off), -q));
    test::act(of, test::push(L * (1.0 - off), -7.0));
    test::act(of, test::push(L * off, -5.0));
    const test::AtRest at(of);
    CHECK(at.reaction(1) == exactly(3.0 * q * L / 8.0 + 7.0, 1e-8));
    CHECK(at.reaction(0) == exactly(5.0 * q * L / 8.0 + 5.0, 1e-8));
    CHECK(at.moment(0.0) == exactly(q * L * L / 8.0, 1e-8));
    CHECK(at.rise(std::nextafter(L, 4.0)) == at.rise(L));
  }
}

TEST_CASE("without loads, and without a density, nothing is cut", "[frame]") {
  Structure of = bar();
  of.gravity = {0.0, -9.81, 0.0};
  test::support(of, 0.0, test::fixed);
  test::support(of, L, test::roller);
  SECTION("no loads") {}
  SECTION("weight of nothing") { test::act(of, OwnWeight{}); }
  const test::AtRest at(of);
  CHECK(at.reaction(0) == 0.0);
  CHECK(at.moment(0.4) == 0.0);
  CHECK(at.rise(1.0) == 0.0);
}

TEST_CASE("a tie along the axis of a member takes its share of the stretch", "[frame]") {
  // A spring k beside a bar of E A/h: k/(k + E A/h) of the pull.
  Structure of = bar();
  test::support(of, 0.0, test::fixed);
  constexpr double k = 5e8, h = 1.0;
  Joint tie;
  tie.a = {0, {1.0, 0.0, 0.0}};
  tie.b = {0, {1.0 + h, 0.0, 0.0}};
  tie.stiffness = {k, 0.0, 0.0, 0.0, 0.0, 0.0};
  of.joints.push_back(tie);
  test::act(of, PointAction{{0, {L, 0.0, 0.0}}, {1e5, 0.0, 0.0}, Eigen::Vector3d::Zero()});
  const test::AtRest at(of);
  const double EA = 2.1e11 * 0.1 * 0.2;
  CHECK(at.equilibrium.joints[1].x() == exactly(1e5 * k / (k + EA / h)));
}

}  // namespace

}  // namespace frame_mechanism_test
