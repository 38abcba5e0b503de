#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/table_reader.hpp"
#include "readers.hpp"

/// Links between the case and the mechanism: read, not yet placed.
namespace boxbeam::readers {

/// How far lengths that must agree may differ, relative.
inline constexpr double agreement = 1e-6;

/// A place of the world, or a point of a link by name.
struct WrittenPlace {
  std::string_view key;
  std::string reference;  ///< "boom.P2"; "" for the world
  Eigen::Vector2d world = Eigen::Vector2d::Zero();
};

/// How a link is placed: by where its origin or a point of its own lies and its angle, or by where
/// its two ends lie.
struct Placing {
  std::string own_point;  ///< "": its origin
  WrittenPlace at;
  double angle = 0.0;
  std::optional<WrittenPlace> to;
};

/// A link as written. Its length may come from its placing, its profile waits for the length.
struct LinkDraft {
  TableReader table;
  flexible::Link link = {};
  Placing placing = {};
  std::optional<double> length = {};
  TaperedBeam profile = {};  ///< where sections give it; a single segment fills the whole length
  flexible::LinkStretch stiffness = {};
  double youngs_modulus = 0.0, shear_modulus = 0.0;
  double extra_mass = 0.0;
  bool lump = false;  ///< a rigid link whose mass is given as such
  bool placed = false;
};

/// Gives a link its length, notes points that stand off it, and names its ends. A length that could
/// not be read is NaN.
void take_length(LinkDraft& draft, double length);

/// Places one link after the other, those first that the others refer to.
void place_all(std::vector<LinkDraft>& drafts);

}  // namespace boxbeam::readers
