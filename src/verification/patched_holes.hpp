#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "patch_search.hpp"

namespace boxbeam {

/// Holes so near forces that come into webs that these press no whole webs: in the web within half
/// of its depth beside the loaded length, in the flange on that. Clause 6 is for webs without
/// openings (2.3). A force that comes into stout webs at a hole's own station, of which the case
/// says no more, is taken to come by a pin in it.
class PatchedHoles {
 public:
  explicit PatchedHoles(const Project& project) : project_(&project) {}

  /// `use`: of the webs, as if they were whole.
  void take(const Patch& patch, const PatchBasis& basis, double load_factor, double use);

  std::vector<Gate> gates() const;

 private:
  /// How far from a force a hole matters, from centre to centre.
  Length reach_of(const Patch& patch, const BeamHole& at);
  /// A hole that by itself does not count (2.3), with those in its row: has no verdict where webs
  /// would be used up by what they leave of the loaded length.
  void take_small(const Patch& patch, const BeamHole& at, double use);

  struct Pressed {
    Length s;
    std::string by;
    double use = 0.0;  ///< of the strip of the web, or of whole webs
    bool in_web = false, in_row = false;
  };
  const Project* project_;
  std::map<const BeamHole*, Pressed> worst_;
  /// Along an axis the clear depth of the webs where a hole stands, and what of the section is
  /// beside it: the same for all forces at all instants.
  struct Depth {
    Length clear, beside;
  };
  std::map<std::pair<const BeamHole*, bool>, Depth> depths_;
};

}  // namespace boxbeam
