// Rotations against their defining properties and long double evaluations of Rodrigues' formula.

#include "boxbeam/mechanism/spatial/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "support/moving.hpp"
#include "support/random_tree.hpp"

namespace rotation_test {

using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi;
const double angles[] = {0.0, 1e-300, 1e-12, 1e-8, 1e-4, 1.0, pi - 1e-4, pi - 1e-8, pi - 1e-12, pi};

double error_of(const Matrix3d& R) {
  return std::max((R.transpose() * R - Matrix3d::Identity()).cwiseAbs().maxCoeff(),
                  std::abs(R.determinant() - 1.0));
}

/// Coordinate axes and their opposites, the corners of a cube, and some by chance.
std::vector<Vector3d> axes() {
  std::vector<Vector3d> all;
  for (int k = 0; k < 3; ++k) {
    all.push_back(Vector3d::Unit(k));
    all.push_back(-Vector3d::Unit(k));
  }
  for (int corner = 0; corner < 8; ++corner) {
    all.push_back(Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1) /
                  std::sqrt(3.0));
  }
  test::Chance chance(31);
  for (int i = 0; i < 50; ++i) all.push_back(chance.direction());
  // Nearly a coordinate axis: two components hardly matter, and must not be lost.
  all.push_back(Vector3d(1.0, 1e-9, -1e-5).normalized());
  return all;
}

}  // namespace

TEST_CASE(
    "a rotation about a vector is Rodrigues' formula in long double, for angles of any size") {
  std::vector<double> sizes(std::begin(angles), std::end(angles));
  // About the border between the series and the formula.
  for (const double share : {0.5, 0.99, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.01, 2.0}) {
    sizes.push_back(1e-4 * share);
  }
  for (const double more : {2.0 * pi, 10.0, 300.0}) sizes.push_back(more);
  for (const Vector3d& axis : axes()) {
    for (const double angle : sizes) {
      const Vector3d turn = angle * axis;
      const Matrix3d R = rotation_about(turn);
      CAPTURE(axis.transpose(), angle);
      CHECK(error_of(R) < 1e-15 * std::max(4.0, angle));
      const test::Vector wide = turn.cast<test::Real>();
      const test::Real length = wide.norm();
      if (length == 0.0L) {
        CHECK(R == Matrix3d::Identity());
        continue;
      }
      const test::Matrix exact = test::turned(wide / length, {length, 0, 0}).value;
      const double worst =
          static_cast<double>((exact - R.cast<test::Real>()).cwiseAbs().maxCoeff());
      CHECK(worst < 1e-15 * std::max(1.0, angle));
      // The small parts too: relative to the angle, for off the diagonal is all that there is.
      if (angle > 1e-200 && angle < 1e-3) {
        const test::Matrix skew = (exact - exact.transpose()) / 2;
        const Matrix3d own = 0.5 * (R - R.transpose());
        CHECK(static_cast<double>((skew - own.cast<test::Real>()).cwiseAbs().maxCoeff()) <
              1e-15 * angle + 1e-20);
      }
    }
  }
}

TEST_CASE("the turn of a rotation about a vector is that vector, up to half a turn") {
  for (const Vector3d& axis : axes()) {
    for (const double angle : angles) {
      const Vector3d turn = angle * axis;
      const Vector3d found = turn_of(rotation_about(turn));
      CAPTURE(axis.transpose(), angle);
      // At half a turn, and within round-off of it, both senses are right.
      const double open = (found - turn).norm();
      const double other = angle > pi - 1e-11 ? (found - (angle - 2.0 * pi) * axis).norm() : open;
      CHECK(std::min(open, other) <= 4e-15 * angle);
      CHECK(found.norm() <= pi * (1.0 + 1e-15));
    }
  }
}

TEST_CASE("the turn of a rotation by chance turns as the rotation does") {
  test::Chance chance(32);
  for (int i = 0; i < 10000; ++i) {
    const Matrix3d R = rotation_about(chance.any(20.0) * chance.direction());
    const Vector3d turn = turn_of(R);
    CHECK(turn.norm() <= pi * (1.0 + 1e-15));
    CHECK((rotation_about(turn) - R).cwiseAbs().maxCoeff() < 4e-15);
  }
}

TEST_CASE("a million rotations in a row stay a rotation, and the one that they are") {
  // Back through all of them in reverse order: the identity again, but for the round-off of each.
  test::Chance chance(33);
  Matrix3d R = Matrix3d::Identity();
  double worst = 0.0;
  for (int i = 0; i < 1000000; ++i) {
    R = composed(R, rotation_about(chance.vector(3.0)));
    if (i % 1000 == 999) worst = std::max(worst, error_of(R));
  }
  CHECK(worst < 1e-15);
  CHECK(error_of(R) < 1e-15);

  // A millionth of a turn a million times is a whole turn.
  const Matrix3d step = rotation_about(2e-6 * pi * Vector3d(1.0, 2.0, -2.0) / 3.0);
  R = Matrix3d::Identity();
  for (int i = 0; i < 1000000; ++i) R = composed(R, step);
  CHECK((R - Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("one step towards the nearest rotation squares the error") {
  test::Chance chance(34);
  for (const double size : {1e-2, 1e-3, 1e-4, 1e-6}) {
    for (int i = 0; i < 100; ++i) {
      Matrix3d noise;
      for (int k = 0; k < 3; ++k) noise.col(k) = chance.vector(size);
      const Matrix3d R = chance.rotation() + noise;
      // Newton's step for the polar decomposition: E -> 3/4 E^2 + ..., E = R^T R - I.
      const double before = (R.transpose() * R - Matrix3d::Identity()).norm();
      const Matrix3d mended = orthonormalised(R);
      const double behind = (mended.transpose() * mended - Matrix3d::Identity()).norm();
      CHECK(behind < before * before + 2e-15);
    }
  }
}

}  // namespace rotation_test
