#pragma once

#include <cstddef>
#include <deque>
#include <string_view>
#include <tuple>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A torque up to this is the rounding of sums [N m].
double least_torque(const SituationRun& run);

/// By what a torque comes into a beam.
struct TorqueSource {
  /// Forces beside the axis: F_z y by webs, -F_y z by flanges, all of one place together. Couples:
  /// of one joint or force by itself, by which plates is not known. A jump of T: no more is known.
  enum class Kind { by_webs, by_flanges, couple, jump };
  Kind kind = Kind::jump;
  std::string_view name = {};  ///< of a couple's joint or force
  std::size_t part = 0;        ///< of that

  friend bool operator==(const TorqueSource&, const TorqueSource&) = default;
  friend bool operator<(const TorqueSource& a, const TorqueSource& b) {
    return std::tie(a.kind, a.name, a.part) < std::tie(b.kind, b.name, b.part);
  }
};

/// A torque that comes in at one place from one source.
struct TorqueIn {
  double s = 0.0;       ///< [m]
  double torque = 0.0;  ///< about the beam's axis [N m]
  TorqueSource from = {};
};

/// All torques that come in at an instant, by places along the beam; no two of one source at one
/// place. Those that cancel there are all there: what they do to a cell adds up.
using TorquesIn = std::vector<TorqueIn>;

/// A line of force beside the axis: over which stretch, and its lever [m].
struct LineLever {
  double from = 0.0, to = 0.0, y = 0.0, z = 0.0;
};
std::vector<LineLever> line_levers_of(const Project& project);

/// Up to this far apart places are one [m].
double one_place_of(const TaperedBeam& beam);

/// Of loads of which each has its place and name; sums up to `least` [N m] are none. Lines are in
/// it only where some act with a lever along y and some along z, so that their torques may cancel:
/// then all that pushes along z by the largest lever y, and the other way round, on the safe side.
TorquesIn torques_in(const BeamLoads& loads, const std::vector<LineLever>& lines, double one_place,
                     double least);

/// Of cut forces alone.
TorquesIn torques_in(const CutForceDiagram& diagram, double least);

/// Of every run at its instants; of recorded cut forces by their jumps.
std::vector<std::vector<TorquesIn>> torques_in(const Project& project,
                                               const std::deque<SituationRun>& runs);

/// Those of a stretch of the beam [m], and what passes its ends; by their places, the ends
/// themselves for what stands there.
TorquesIn torques_between(const TorquesIn& all, const CutForceDiagram& diagram, double from,
                          double to, double one_place);

}  // namespace boxbeam
