#pragma once

#include <cmath>
#include <string>

#include "boxbeam/mechanism/planar/mechanism.hpp"

/// Mechanisms of any size, for timing and growth.
namespace bench {

/// A ladder of parallelogram-like four-bars, 1 m high: each has its own crank on the ground and a
/// coupler from the crank before; the first crank is driven to and fro. 2 n + 1 bodies, 2 n + 1
/// cranks and couplers, one degree of freedom. Couplers differ a little from the ground lengths, so
/// that no position is singular.
inline boxbeam::planar::Mechanism chain_of_four_bars(int n) {
  using namespace boxbeam;
  using namespace boxbeam::planar;
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  const auto add_crank = [&](double x) {
    const int body = static_cast<int>(mechanism.bodies.size());
    mechanism.bodies.push_back(
        Body{"crank" + std::to_string(body), 10.0, 10.0 / 12.0, {}, {{x, 0.5}, std::acos(0.0)}});
    mechanism.joints.push_back(
        {"foot" + std::to_string(body), Pin{{body, {-0.5, 0.0}}, {ground, {x, 0.0}}}});
    return body;
  };
  int last = add_crank(0.0);
  for (int i = 1; i <= n; ++i) {
    const double x = 1.5 * i;
    const double length = 1.5;
    const int coupler = static_cast<int>(mechanism.bodies.size());
    mechanism.bodies.push_back(Body{"coupler" + std::to_string(coupler),
                                    5.0,
                                    5.0 * length * length / 12.0,
                                    {},
                                    {{x - 0.75, 1.0}, 0.0}});
    const int crank = add_crank(x);
    const Attachment top{crank, {0.5, 0.0}};
    mechanism.joints.push_back(
        {"left" + std::to_string(i), Pin{{coupler, {-0.5 * length, 0.0}}, {last, {0.5, 0.0}}}});
    mechanism.joints.push_back(
        {"right" + std::to_string(i), Pin{{coupler, {0.5 * length, 0.0}}, top}});
    last = crank;
  }
  mechanism.joints.push_back(
      {"motor", Driven{{0}, Coordinate::angle, HarmonicDriver{std::acos(0.0), 0.5, 6.0, 0.0}}});
  return mechanism;
}

}  // namespace bench
