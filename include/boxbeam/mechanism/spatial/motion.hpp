#pragma once

#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"

namespace boxbeam::spatial {

/// The time that is looked at and the number of instants in it. The states themselves follow from
/// the time alone.
struct Motion {
  double begin = 0.0;   ///< [s]
  double period = 0.0;  ///< [s]
  bool closed = true;   ///< it repeats after the period; else it ends there
  std::size_t instants = 0;
  /// When a stop or a cable begins or ends to act, or a contact to stick, ascending: there loads
  /// bend or jump, however short that lasts between two instants.
  std::vector<double> changes = {};
};

/// Enough instants to bracket every peak: at least 96, eight to every turn of the fastest body and
/// to every wave of the fastest driver or load, doubled until every joint force and moment, in the
/// axes of the body that carries, is half-way between two instants what the cubic through their
/// neighbours says, within 1 % of its range.
/// Throws AnalysisError where 24 576 are not enough, where stops and cables change more than 1000
/// times, or where it is not known how long to look.
Motion motion_of(const Chain& chain);

/// Time of an instant [s].
double time_of(const Motion& motion, std::size_t instant);

}  // namespace boxbeam::spatial
