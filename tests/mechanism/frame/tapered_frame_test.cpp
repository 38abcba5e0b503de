// Frames of tapered members in cases of their own: against prismatic pieces that get shorter, and
// where statics alone decides, or stiffness of very different size.

#include <cmath>

#include "boxbeam/mechanism/frame/statics.hpp"
#include "catch.hpp"
#include "support/frame_by_stiffness.hpp"
#include "support/frame_differences.hpp"
#include "support/rest_frame.hpp"

namespace tapered_frame_test {

using namespace boxbeam;
using namespace boxbeam::frame;
using Eigen::Vector3d;

namespace {

Approx exactly(double value, double within = 1e-11) {
  return Approx(value).epsilon(within).margin(0.0);
}

Member member(const std::string& name, const Vector3d& start, const Vector3d& end,
              const Section& from, const Section& to) {
  Member of;
  of.name = name;
  of.start = start;
  of.beam.segments = {test::segment(0.0, (end - start).norm(), from, to)};
  of.beam.density = si<Density>(7850.0);
  of.axes.col(0) = (end - start).normalized();
  of.axes.col(2) = Vector3d::UnitZ().cross(of.axes.col(0));
  of.axes.col(1) = of.axes.col(2).cross(of.axes.col(0));
  return of;
}

void join(Structure& of, const Place& a, const Place& b, const std::array<double, 6>& held) {
  Joint joint;
  joint.name = "joint " + std::to_string(of.joints.size() + 1);
  joint.a = a;
  joint.b = b;
  joint.stiffness = held;
  of.joints.push_back(joint);
}

/// Columns that taper to their feet, a girder that tapers to its end.
Structure portal() {
  Structure of;
  of.plane = true;
  of.gravity = {0.0, -9.81, 0.0};
  const Vector3d a(0, 0, 0), b(0.3, 4, 0), c(6, 4.5, 0), d(6, 0, 0);
  of.members = {member("left", a, b, test::solid(0.1, 0.12), test::solid(0.1, 0.3)),
                member("girder", b, c, test::solid(0.1, 0.3), test::solid(0.08, 0.1)),
                member("right", d, c, test::solid(0.06, 0.08), test::solid(0.1, 0.16))};
  const auto end = [&](int m) {
    return Place{m, {of.members[static_cast<std::size_t>(m)].beam.length().value(), 0.0, 0.0}};
  };
  test::support(of, 0.0, test::fixed, 0);
  test::support(of, 0.0, test::pinned, 2);
  join(of, end(0), {1, Vector3d::Zero()}, test::fixed);
  join(of, end(1), end(2), test::fixed);
  return of;
}

TEST_CASE("ever shorter prismatic pieces tend to the tapered frame", "[frame]") {
  const Structure of = portal();
  const double half_up = 0.5 * of.members[0].beam.length().value();
  ActingLoads loads;
  loads.weight = 1.0;
  loads.lines.push_back(
      {1, 0.0, of.members[1].beam.length().value(), {0.0, -8e3, 0.0}, {0.0, -3e3, 0.0}});
  loads.points.push_back({"wind", {{0, {half_up, 0.0, 0.0}}, {5e3, 0.0, 0.0}, {0.0, 0.0, 1e3}}});
  loads.heat.push_back({1, 20.0, 0.0, 30.0});
  loads.settlements.push_back({1, {0.0, -0.004, 0.0}, Vector3d::Zero()});
  const Statics statics(of);
  const Equilibrium at = statics.solve(loads);
  // Pieces of the section in their middle: errors of even powers of their length, where loads stand
  // at their ends.
  const auto forces = [&](int pieces) {
    const test::FrameByStiffness by(of, loads, pieces);
    Eigen::VectorXd all(24);
    for (Eigen::Index j = 0; j < 4; ++j)
      all.segment<6>(6 * j) = by.solution().joints[static_cast<std::size_t>(j)];
    return all;
  };
  const Eigen::VectorXd f8 = forces(8), f16 = forces(16), f32 = forces(32);
  Eigen::VectorXd exact(24);
  for (Eigen::Index j = 0; j < 4; ++j)
    exact.segment<6>(6 * j) = at.joints[static_cast<std::size_t>(j)];
  const double e8 = (f8 - exact).norm(), e16 = (f16 - exact).norm(), e32 = (f32 - exact).norm();
  CHECK(e8 / e16 == Approx(4.0).epsilon(0.05));
  CHECK(e16 / e32 == Approx(4.0).epsilon(0.05));
  const Eigen::VectorXd once = (4.0 * f16 - f8) / 3.0, again = (4.0 * f32 - f16) / 3.0;
  CHECK((once - exact).norm() / (again - exact).norm() == Approx(16.0).epsilon(0.15));
  const Eigen::VectorXd twice = (16.0 * again - once) / 15.0;
  CHECK((twice - exact).norm() < 2e-4 * e8);
  CHECK(exact.norm() > 1e4);
}

TEST_CASE("where statics decides, forces do not depend on sections or on E", "[frame]") {
  // A Gerber beam with an arm off it, in space.
  const auto forces = [](double E, double size) {
    const auto plate = [size](double b, double h) { return test::solid(size * b, size * h); };
    Structure of;
    of.members = {member("root", {0, 0, 0}, {3, 0, 0}, plate(0.1, 0.3), plate(0.1, 0.1)),
                  member("hung", {3, 0, 0}, {5, 1, 0}, plate(0.2, 0.1), plate(0.05, 0.3)),
                  member("arm", {5, 1, 0}, {5, 1.5, 0}, plate(0.1, 0.1), plate(0.1, 0.2))};
    for (Member& of_frame : of.members) {
      of_frame.youngs_modulus = E;
      of_frame.shear_modulus = 0.4 * E;
      of_frame.beam.density = {};
    }
    test::support(of, 0.0, test::fixed, 0);
    // Free to turn about z and to twist, held across at its middle and against twist.
    join(of, {0, {3.0, 0.0, 0.0}}, {1, Vector3d::Zero()},
         {test::rigid, test::rigid, test::rigid, test::rigid, test::rigid, 0.0});
    join(of, {1, {std::sqrt(5.0), 0.0, 0.0}}, {2, Vector3d::Zero()}, test::fixed);
    test::support(of, 1.0, test::roller, 1);
    ActingLoads loads;
    loads.points.push_back({"", {{2, {0.5, 0.1, -0.2}}, {1e4, -3e4, 2e4}, {500.0, -700.0, 900.0}}});
    loads.lines.push_back({0, 0.5, 2.9, {1e3, -2e3, 500.0}, {0.0, 3e3, -4e3}});
    loads.heat.push_back({0, 50.0, 100.0, -300.0});
    loads.settlements.push_back({3, {0.0, -0.01, 0.0}, Vector3d::Zero()});
    const Statics statics(of);
    return statics.solve(loads);
  };
  const Equilibrium one = forces(2.1e11, 1.0);
  for (const auto& [E, size] : {std::pair{2.1e11, 3.0}, {7e10, 1.0}, {1e9, 0.3}}) {
    const Equilibrium other = forces(E, size);
    test::Differences joints(1.0), cuts(1.0);
    for (std::size_t j = 0; j < one.joints.size(); ++j) joints.add(other.joints[j], one.joints[j]);
    for (int m = 0; m < 3; ++m) {
      for (const double s : {0.01, 0.2, 0.45})
        cuts.add(test::cut_at(other, m, s, Side::both), test::cut_at(one, m, s, Side::both));
    }
    CHECK(joints.largest() < 1e-13);
    CHECK(cuts.largest() < 1e-13);
    CHECK(joints.size() > 1e4);
  }
}

TEST_CASE("two cantilevers that push at their tips share by their stiffness", "[frame]") {
  for (const double ratio : {1.0, 1e-3, 1e-6, 1e-9}) {
    INFO(ratio);
    Structure of =
        test::level_frame({test::segment(0.0, 3.0, test::solid(0.1, 0.2), test::solid(0.1, 0.2))});
    of.members.push_back(of.members[0]);
    of.members[1].youngs_modulus *= ratio;
    test::support(of, 0.0, test::fixed, 0);
    test::support(of, 0.0, test::fixed, 1);
    join(of, {0, {3.0, 0.0, 0.0}}, {1, {3.0, 0.0, 0.0}}, test::pinned);
    test::act(of, test::push(3.0, -1e4));
    const test::AtRest at(of);
    CHECK(at.reaction(0) == exactly(1e4 / (1.0 + ratio)));
    CHECK(at.reaction(1) == exactly(1e4 * ratio / (1.0 + ratio), 1e-10));
  }
}

TEST_CASE("a stiff frame on a soft arm is cut as on a stiff arm", "[frame]") {
  // Two unlike bars side by side between rigid ends, loaded on one of them: how they share is their
  // own matter, however far the arm lets them swing.
  const auto moment_in_bar = [](double softer) {
    Structure of =
        test::level_frame({test::segment(0.0, 3.0, test::solid(0.1, 0.2), test::solid(0.1, 0.2))});
    of.members[0].youngs_modulus /= softer;
    Member bar = test::level_member(
        {test::segment(0.0, 1.0, test::solid(0.1, 0.05), test::solid(0.1, 0.1))});
    bar.start = {3.0, -0.2, 0.0};
    of.members.push_back(bar);
    bar.start.y() = 0.2;
    bar.beam.segments[0].to = test::solid(0.1, 0.05);
    of.members.push_back(bar);
    test::support(of, 0.0, test::fixed);
    join(of, {0, {3.0, 0.0, -0.2}}, {1, Vector3d::Zero()}, test::fixed);
    join(of, {0, {3.0, 0.0, 0.2}}, {2, Vector3d::Zero()}, test::fixed);
    join(of, {1, {1.0, 0.0, 0.2}}, {2, {1.0, 0.0, -0.2}}, test::fixed);
    test::act(of, PointAction{{1, {0.6, 0.0, 0.0}}, {0.0, -1e4, 0.0}, Vector3d::Zero()});
    const Statics statics(of);
    return test::cut_at(statics.solve(acting_at(of, 0.0)), 2, 0.3, Side::both)[4];
  };
  const double expected = moment_in_bar(1.0);
  REQUIRE(std::abs(expected) > 100.0);
  CHECK(moment_in_bar(1e2) == exactly(expected, 1e-10));
  CHECK(moment_in_bar(1e4) == exactly(expected, 1e-9));
  CHECK(moment_in_bar(1e6) == exactly(expected, 1e-7));
}

TEST_CASE("wheels load the member as long as they are on it", "[frame]") {
  // A simple beam: P (L - s)/L on its first support of each wheel that is on it.
  constexpr double L = 10.0, P = 5e3, apart = 3.0;
  Structure of =
      test::level_frame({test::segment(0.0, L, test::solid(0.2, 0.4), test::solid(0.1, 0.2))});
  test::support(of, 0.0, test::pinned);
  test::support(of, L, test::roller);
  Wheels wheels;
  wheels.from = -2.0;
  wheels.to = L + apart + 2.0;
  wheels.speed = 0.5;
  wheels.wheels = {{0.0, {0.0, -P, 0.0}}, {apart, {0.0, -2.0 * P, 0.0}}};
  test::act(of, wheels);
  CHECK(wheels.duration() == Approx(34.0));
  // They run a ten thousand millionth of the length beside what they stand on.
  const auto near = [](double value) { return Approx(value).epsilon(1e-9); };
  const Statics statics(of);
  const auto first_support = [&](double front) {
    return statics.solve(acting_at(of, (front - wheels.from) / wheels.speed)).joints[0].y();
  };
  CHECK(first_support(-1.0) == 0.0);
  CHECK(first_support(0.0) == near(P));
  CHECK(first_support(2.0) == near(P * 0.8));
  CHECK(first_support(apart) == near(P * 0.7 + 2.0 * P));
  CHECK(first_support(7.0) == near(P * 0.3 + 2.0 * P * 0.6));
  CHECK(first_support(11.0) == near(2.0 * P * 0.2));
  // On the end they still stand on the second support.
  const auto second_support = [&](double front) {
    return statics.solve(acting_at(of, (front - wheels.from) / wheels.speed)).joints[1].y();
  };
  CHECK(second_support(L) == near(P + 2.0 * P * 0.7));
  CHECK(second_support(L + apart) == near(2.0 * P));
  CHECK(second_support(L + apart + 0.01) == 0.0);
}

TEST_CASE("many spans: inner reactions q l, moments q l^2/12, the first (1/2 - c) q l", "[frame]") {
  // Three moments M_k-1 + 4 M_k + M_k+1 = q l^2/2 from a free end: M_1 = q l^2/12 (1 - r),
  // r = -2 + sqrt 3, where the far end no longer matters. Source: Clapeyron.
  constexpr int spans = 60;
  constexpr double q = 4e3;
  Structure of =
      test::level_frame({test::segment(0.0, spans, test::solid(0.1, 0.2), test::solid(0.1, 0.2))});
  test::support(of, 0.0, test::pinned);
  for (int k = 1; k <= spans; ++k) test::support(of, k, test::roller);
  test::act(of, test::uniform(0.0, spans, -q));
  const test::AtRest at(of);
  const double r = std::sqrt(3.0) - 2.0;
  CHECK(at.moment(1.0) == exactly(q / 12.0 * (1.0 - r)));
  CHECK(at.reaction(0) == exactly(0.5 * q - q / 12.0 * (1.0 - r)));
  CHECK(at.reaction(spans) == exactly(at.reaction(0)));
  CHECK(at.reaction(spans / 2) == exactly(q));
  CHECK(at.moment(spans / 2) == exactly(q / 12.0, 1e-10));
}

}  // namespace

}  // namespace tapered_frame_test
