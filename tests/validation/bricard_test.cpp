// Bricard's mechanism, IFToMM library of computational benchmark problems, A04: five bars of 1 m
// and 1 kg, 0.1 m square, and the ground, hinged along the edges of a cube; counting says that it
// does not move. It falls from rest under 9.81 m/s^2.
//
// Every second hinge turns alike, by a and by b, with cos(A) + cos(B) + cos(A) cos(B) = 0 for the
// angles A and B between neighbouring bars (the linkage of threefold symmetry; Chen, You and
// Tarnai, International Journal of Solids and Structures 42 (2005)), here sin(b) = -sin(a)/(1 +
// sin(a)). The x of the third vertex is cos(a), from one side of the cube to the other and back.
// Energy gives a over time by quadrature.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/forced_motion.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace bricard_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double g = 9.81, mass = 1.0, length = 1.0, side = 0.1;
constexpr double pi = std::numbers::pi;

const std::array<Vector3d, 6> vertices{Vector3d(0, 0, 0),  Vector3d(1, 0, 0),  Vector3d(1, -1, 0),
                                       Vector3d(1, -1, 1), Vector3d(0, -1, 1), Vector3d(0, 0, 1)};
/// The axis of the hinge at each vertex: y, z, x, y, z, x.
Vector3d axis_at(std::size_t vertex) { return Vector3d::Unit(static_cast<int>((vertex + 1) % 3)); }

Vector3d bar_at(std::size_t vertex) { return vertices[vertex + 1] - vertices[vertex]; }

/// About the middle of a bar along `along`.
Matrix3d inertia_of(const Vector3d& along) {
  const double across = mass * (length * length + side * side) / 12.0;
  const double about = mass * side * side / 6.0;
  return across * Matrix3d::Identity() + (about - across) * along * along.transpose();
}

Mechanism bricard() {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g, 0.0};
  int body = ground;
  for (std::size_t k = 0; k < 5; ++k) {
    const Vector3d from = k == 0 ? vertices[0] : bar_at(k - 1);
    body = test::add(mechanism,
                     test::joint_of("hinge", JointKind::revolute, body, from, axis_at(k)), true);
    spatial::Body& bar = mechanism.bodies.back();
    bar.mass = mass;
    bar.centre = 0.5 * bar_at(k);
    bar.inertia = inertia_of(bar_at(k));
  }
  mechanism.joints.front().moved_by = MovedBy::forces;
  ClosingJoint last =
      test::closing("last", ClosingKind::revolute, {ground, vertices[5]}, {body, bar_at(4)});
  last.axis = axis_at(5);
  mechanism.closing.push_back(last);
  return mechanism;
}

double other_angle(double a) { return std::asin(-std::sin(a) / (1.0 + std::sin(a))); }

/// Twice the kinetic energy where a turns by 1 rad/s, and the potential energy.
struct Energies {
  double inertia = 0.0;
  double potential = 0.0;
};

Energies energies_at(double a) {
  const double b = other_angle(a);
  const double rate = -std::cos(a) / (std::pow(1.0 + std::sin(a), 2) * std::cos(b));
  Energies of;
  Matrix3d R = Matrix3d::Identity();
  Vector3d place = vertices[0], velocity = Vector3d::Zero(), omega = Vector3d::Zero();
  for (std::size_t k = 0; k < 5; ++k) {
    omega += R * axis_at(k) * (k % 2 == 0 ? 1.0 : rate);
    R = (R * Eigen::AngleAxisd(k % 2 == 0 ? a : b, axis_at(k))).eval();
    const Vector3d along = R * bar_at(k);
    const Vector3d middle = velocity + omega.cross(0.5 * along);
    const Vector3d turned = R.transpose() * omega;
    of.inertia += mass * middle.squaredNorm() + turned.dot(inertia_of(bar_at(k)) * turned);
    of.potential += mass * g * (place + 0.5 * along).y();
    place += along;
    velocity += omega.cross(along);
  }
  return of;
}

/// When it first comes to an angle, from rest at 0; with a = (1 - cos(u)) pi/2 the integrand is
/// smooth where it rests.
double time_to(double a) {
  const double at_rest = energies_at(0.0).potential;
  const auto slowness = [&](double u) {
    const double angle = 0.5 * pi * (1.0 - std::cos(u));
    const Energies of = energies_at(angle);
    return 0.5 * pi * std::sin(u) * std::sqrt(of.inertia / (2.0 * (at_rest - of.potential)));
  };
  double time = 0.0;
  const double to = std::acos(1.0 - 2.0 * a / pi);
  constexpr int parts = 8;
  for (int i = 0; i < parts; ++i)
    time += boost::math::quadrature::gauss<double, 20>::integrate(slowness, to * i / parts,
                                                                  to * (i + 1) / parts);
  return time;
}

}  // namespace

TEST_CASE("Bricard's mechanism falls as its closed form, ten seconds long") {
  Mechanism mechanism = bricard();
  mechanism.duration.length = 10.0;
  const Chain chain(mechanism);
  CHECK(chain.loops()->equations() == 5);
  CHECK(chain.loops()->freedoms() == 4);
  CHECK(chain.loops()->repeating() == 1);
  CHECK(chain.forced()->freedoms() == 1);
  const double half = time_to(pi);
  INFO("half a period: " << half << " s");
  double worst = 0.0, open = 0.0;
  for (int i = 1; i <= 100; ++i) {
    const double time = 0.1 * i;
    const State state = chain.at(time);
    const double a = state.coordinates[0].value;
    const double in_swing = std::remainder(time, 2.0 * half);  // even in time about its ends
    worst = std::max(worst, std::abs(time_to(a) - std::abs(in_swing)));
    open = std::max(open, std::abs(position_of(state, {2, bar_at(2)}).x() - std::cos(a)));
    CHECK(std::abs(state.coordinates[1].value - other_angle(a)) < 1e-7);
  }
  CHECK(worst < 1e-8);
  CHECK(open < 1e-12);
  for (const double n : {1.0, 2.0, 3.0})
    CHECK(chain.at(n * half).coordinates[0].value == Approx(n == 2.0 ? 0.0 : pi).margin(1e-6));
}

}  // namespace bricard_test
