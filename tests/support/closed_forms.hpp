#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/balance.hpp"

/// What planar motions are compared with closed forms by.
namespace test::closed_forms {

using namespace boxbeam;
using namespace boxbeam::planar;

inline constexpr double pi = std::numbers::pi;
inline constexpr double g = 9.81;

inline Eigen::Vector2d unit_of(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline Eigen::Vector2d left_of(const Eigen::Vector2d& p) { return {-p.y(), p.x()}; }
inline Eigen::Vector2d turned(double angle, const Eigen::Vector2d& p) {
  return p.x() * unit_of(angle) + p.y() * left_of(unit_of(angle));
}

inline double worst_imbalance(const Mechanism& mechanism, const Motion& motion) {
  double worst = 0.0;
  for (const State& state : motion.states) {
    worst = std::max(worst, imbalance_of(mechanism, state));
  }
  return worst;
}

/// What a joint does to a body.
inline Reaction reaction_on(const Mechanism& mechanism, const State& state, const char* joint,
                            int body) {
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (reaction.joint == joint_index(mechanism, joint) && reaction.on == body) return reaction;
  }
  FAIL("no reaction of joint " << joint);
  return {};
}

/// A bar of a length between its ends at (-length/2, 0) and (length/2, 0), lying from a point at an
/// angle.
inline Body bar(const char* name, double length, double mass, const Eigen::Vector2d& from,
                double angle) {
  return {
      name, mass, mass * length * length / 12.0, {}, {from + 0.5 * length * unit_of(angle), angle}};
}

/// Value and two derivatives by time.
struct Rates {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

/// Largest errors over a motion.
struct Errors {
  double q = 0.0, v = 0.0, a = 0.0;

  /// One coordinate of a state against its closed form, relative to `unit`.
  void add(const State& state, Eigen::Index coordinate, const Rates& exact, double unit = 1.0) {
    q = std::max(q, std::abs(state.q[coordinate] - exact.value) / unit);
    v = std::max(v, std::abs(state.v[coordinate] - exact.rate) / unit);
    a = std::max(a, std::abs(state.a[coordinate] - exact.acceleration) / unit);
  }
  void add_angle(const State& state, int body, const Rates& exact) {
    const Eigen::Index i = 3 * body + 2;
    q = std::max(q, std::abs(std::remainder(state.q[i] - exact.value, 2.0 * pi)));
    v = std::max(v, std::abs(state.v[i] - exact.rate));
    a = std::max(a, std::abs(state.a[i] - exact.acceleration));
  }
};

}  // namespace test::closed_forms
