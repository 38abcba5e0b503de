// Bennett's linkage of four bars and Goldberg's of five, which is two of Bennett's that have lost
// the bar that they share: both move though counting says that they do not. Sources: Bennett,
// Engineering 76 (1903); Goldberg, Transactions of the ASME 65 (1943).

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace bennett_goldberg_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;
using test::add;
using test::closing;
using test::joint_of;

namespace {

/// A bar between two hinges, after Denavit and Hartenberg: along x by its length [m] and about x by
/// its twist.
struct Bar {
  double length = 0.0;
  double twist = 0.0;
};

Eigen::Isometry3d across(const Bar& bar) {
  Eigen::Isometry3d of = Eigen::Isometry3d::Identity();
  of.translate(Vector3d(bar.length, 0.0, 0.0));
  of.rotate(rotation_about({bar.twist, 0.0, 0.0}));
  return of;
}

Eigen::Isometry3d about_z(double angle) {
  Eigen::Isometry3d of = Eigen::Isometry3d::Identity();
  of.rotate(rotation_about({0.0, 0.0, angle}));
  return of;
}

/// Bars that hinges about z carry one from another, at these angles; the first hinge is driven. A
/// hinge behind the last bar, about z again, closes the loop on the ground.
Mechanism loop_of(const std::vector<Bar>& bars, const std::vector<double>& angles,
                  const Driver& driver) {
  Mechanism mechanism;
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();
  int body = ground;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    Joint joint = joint_of("bar", JointKind::revolute, body, Vector3d::Zero(), Vector3d::UnitZ());
    if (k > 0) {
      const Eigen::Isometry3d before = across(bars[k - 1]);
      joint.at = before.translation();
      joint.turn = before.linear();
      joint.axis = joint.turn.col(2);
    }
    joint.start = angles[k];
    if (k == 0) joint.driver = driver;
    body = add(mechanism, joint, k > 0);
    end = end * about_z(angles[k]) * across(bars[k]);
  }
  const Vector3d tip(bars.back().length, 0.0, 0.0);
  ClosingJoint last =
      closing("last", ClosingKind::revolute, {ground, end.translation()}, {body, tip});
  last.axis = end.linear().col(2);
  last.turn = end.linear() * rotation_about({-bars.back().twist, 0.0, 0.0});
  mechanism.closing.push_back(last);
  return mechanism;
}

/// The angle of a hinge of Bennett's linkage from the one before: tan(theta/2) tan(phi/2) =
/// sin((beta + alpha)/2)/sin((beta - alpha)/2), where bars of a twist alpha and beta alternate.
double next_angle(double theta, double alpha, double beta) {
  return 2.0 * std::atan(std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)) /
                         std::tan(0.5 * theta));
}

}  // namespace

TEST_CASE("Bennett's linkage moves though counting says that it does not") {
  // Opposite bars alike, a/sin(alpha) = b/sin(beta).
  constexpr double alpha = 0.6, beta = 1.1, a = 0.5, theta = 1.0;
  const double b = a * std::sin(beta) / std::sin(alpha);
  const double phi = next_angle(theta, alpha, beta);
  const HarmonicDriver driver{theta, 0.4, 1.0, 0.0, {}};
  const Mechanism mechanism =
      loop_of({{a, alpha}, {b, beta}, {a, alpha}}, {theta, phi, -theta}, driver);
  const Chain chain(mechanism);
  CHECK(chain.loops()->equations() == 5);
  CHECK(chain.loops()->freedoms() == 2);
  CHECK(chain.loops()->repeating() == 3);
  for (int i = 0; i < 40; ++i) {
    const double time = 0.15 * i;
    const State state = chain.at(time);
    const double first = driver_at(driver, time).value;
    CHECK(std::tan(0.5 * state.coordinates[1].value) ==
          Approx(std::tan(0.5 * next_angle(first, alpha, beta))).epsilon(1e-7));
    CHECK(chain.loops()->residual_of(Tree(mechanism), state) < 1e-8);
  }
}

TEST_CASE("Goldberg's linkage moves as the two of Bennett's that it is made of") {
  // Both hold bars of length a and twist alpha, beside bars of b, beta and of c, gamma. In the loop
  // of the first, Z(t1) X(a) Z(p1) X(b) Z(-t1) X(a) Z(-p1) X(b) = 1, its first bar is what the
  // second makes of it, X(a) = Z(-t2) X(c)^-1 Z(p2) X(a)^-1 Z(t2) X(c)^-1 Z(-p2). Two of the hinges
  // then lie on one axis each time; one of these is made rigid, t1 - t2 = delta.
  constexpr double alpha = 0.6, beta = 1.1, gamma = 0.8, delta = 0.7, a = 0.5;
  const double b = a * std::sin(beta) / std::sin(alpha), c = a * std::sin(gamma) / std::sin(alpha);
  const HarmonicDriver driver{1.2, 0.3, 1.0, 0.0, {}};
  const auto angles_of = [&](double p2) {
    const double t2 = next_angle(p2, alpha, gamma), t1 = t2 + delta;
    const double p1 = next_angle(t1, alpha, beta);
    return std::vector<double>{p2, t2, p1 - p2, -t1};
  };
  const Mechanism mechanism = loop_of({{-a, -alpha}, {-c, -gamma}, {b, beta}, {a, alpha}},
                                      angles_of(driver_at(driver, 0.0).value), driver);
  const Chain chain(mechanism);
  CHECK(chain.loops()->equations() == 5);
  CHECK(chain.loops()->freedoms() == 3);
  CHECK(chain.loops()->repeating() == 2);
  for (int i = 0; i < 40; ++i) {
    const double time = 0.15 * i;
    const State state = chain.at(time);
    const std::vector<double> exact = angles_of(driver_at(driver, time).value);
    for (std::size_t k = 0; k < exact.size(); ++k)
      CHECK(std::abs(std::remainder(state.coordinates[k].value - exact[k], full_turn)) < 1e-7);
    CHECK(chain.loops()->residual_of(Tree(mechanism), state) < 1e-8);
  }
}

}  // namespace bennett_goldberg_test
