#pragma once

#include <array>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"

namespace boxbeam {

/// What stands on a length of the beam.
struct OnLength {
  Length from, to;                 ///< of what is loaded
  std::array<double, 2> forces{};  ///< along the axis and against it, sizes [N]
  double turns = 0.0;              ///< the couple alone [N m]
  Length begin, end;               ///< the length itself
};

/// Loads along the beam that come into its webs along z or, along y, into its flanges, as they
/// stand on lengths of it.
class LinesAlong {
 public:
  /// `lines` stay; `end`: of the beam.
  LinesAlong(const std::vector<LineLoad>& lines, bool along_z, Length end)
      : lines_(&lines), along_z_(along_z), end_(end) {}

  /// What pushes most, and turns most [N/m, N].
  std::array<double, 2> largest() const;
  /// Where those that press begin and end.
  std::vector<Length> ends() const;
  /// Places all along them.
  std::vector<Length> inside() const;
  /// Places all along one that is not the same everywhere, but for weight and inertia.
  std::vector<Length> inside_if_uneven(const LineLoad& line) const;
  /// On a length of the beam that begins there, or as near as it fits.
  OnLength on(Length begin, Length depth) const;
  /// As heavy as it is at its heavier end, on a shorter length.
  OnLength drawn_to_heavier_end(OnLength of) const;

 private:
  bool presses(const LineLoad& line) const;

  const std::vector<LineLoad>* lines_;
  bool along_z_;
  Length end_;
};

/// What loads along the beam push between two places along the axis, or against it.
Force across_on(const std::vector<LineLoad>& lines, bool along_z, bool pushing, Length from,
                Length to);

}  // namespace boxbeam
