#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::charts {

/// One or two bodies whose place follows in closed form from bodies that are known.
struct DyadStep {
  enum class Kind {
    turned,       ///< pinned to a known point, at a known angle
    slid,         ///< on a known line at a known angle, one coordinate driven
    two_circles,  ///< pinned to a known point, at a distance from another
    circle_line,  ///< pinned to a known point, with a point on a known line
    own_line,     ///< pinned to a known point, with another known point on a line of its own
    pin_pin_pin,  ///< two bodies, pinned to each other and each to a known point
    pin_pin_line  ///< two bodies, pinned to each other, one to a known point, one on a known line
  };
  /// angle of a body = factor * angle of a known one + offset + (by driver) * its value.
  struct Turn {
    int body = planar::ground;
    double factor = 1.0, offset = 0.0;
    int driver = -1;
    double by_driver = 0.0;
  };

  Kind kind = Kind::turned;
  int first = planar::ground, second = planar::ground;  ///< the bodies that become known
  planar::Attachment from;                    ///< the known point that the first is pinned to
  planar::Attachment own;                     ///< the first body's point there
  planar::Attachment tip;                     ///< the first body's other point
  planar::Attachment to;                      ///< the known point or line at the other end
  planar::Attachment second_tip, second_own;  ///< the second body's points: at the tip and at `to`
  double direction = 0.0;                     ///< of a line in its body's axes [rad]
  double length = 0.0;                        ///< of a distance [m]
  int driver = -1;                            ///< of a distance or a coordinate
  planar::Coordinate coordinate = planar::Coordinate::x;
  Turn turn;
  int side = 1;  ///< which of two intersections
};

/// How a mechanism is put together body by body, or why that does not go.
struct DyadPlan {
  std::vector<DyadStep> steps;
  std::string failure;  ///< "" or: "no dyad: bar 1, bar 2"
};

/// Takes a mechanism apart into driven bodies and dyads, on the branch of a position. Planar
/// mechanisms of more entangled groups (triads) have no such plan, nor have gears and racks.
/// Source: Assur (1914); Erdman, Sandor, Mechanism Design (1984), chapter 3.
DyadPlan plan_dyads(const planar::Mechanism& mechanism, const Eigen::VectorXd& position);

}  // namespace boxbeam::charts
