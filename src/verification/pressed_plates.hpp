#pragma once

#include <limits>
#include <map>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// All forces across the beam that come in at one instant, by their sizes.
struct ForcesAcross {
  Force along_z, along_y;
  Moment couple;       ///< about the beam's axis
  bool again = false;  ///< cycles of them count

  Force along(bool z) const { return z ? along_z : along_y; }
};

/// What forces across the beam meet at a place.
struct PressedPlates {
  /// Plates that hardly feel a force: less than 0.3 of what a web of them bears (clause 6) as a
  /// force without length at an unstiffened end, 0.03 of a seam's strength, a tenth of what bends a
  /// flange across; where it comes again and again, less than the cut-off of its seams.
  struct Stout {
    Force hardly = si<Force>(std::numeric_limits<double>::infinity());
    Force hardly_again = hardly;
    double share = 0.5;  ///< that one web takes of a force in their middle
    Length apart = si<Length>(std::numeric_limits<double>::infinity());

    void add(const Stout& other);
    /// Whether forces that come in together, at any places, may be more than these feel.
    bool feels(Force force, Moment couple, bool again) const;
  };

  bool along_z = false, along_y = false;          ///< plates that may buckle bear forces along it
  bool path = false;                              ///< a thin-walled one that may buckle
  bool web_along_z = false, web_along_y = false;  ///< of it a web that may buckle in shear
  /// A force over a plate's depth that is far below what bears it.
  Force none = si<Force>(std::numeric_limits<double>::infinity());
  Length depth;         ///< the largest
  bool closed = false;  ///< a path that may buckle, around one rectangle
  Stout stout_z, stout_y;

  const Stout& stout(bool z) const { return z ? stout_z : stout_y; }
  /// Whether forces along an axis are to be looked at among all that come in.
  bool meet(bool z, const ForcesAcross& all) const {
    return (z ? along_z : along_y) || stout(z).feels(all.along(z), all.couple, all.again);
  }
  void add(const PressedPlates& other);
};

/// Looks them up along the beam.
class PressedPlatesAlong {
 public:
  explicit PressedPlatesAlong(const Project& project);

  /// Of both ends of each segment.
  const std::vector<PressedPlates>& of_segments() const { return of_segments_; }
  /// Anywhere within the depth of the plates on either side of a place, as far as a patch reaches.
  const PressedPlates& near(Length s);

 private:
  PressedPlates at(const Station& station) const;
  void look_at_walls(const Station& station, PressedPlates& of) const;
  void look_at_path(const Station& station, PressedPlates& of) const;

  const Project* project_;
  std::vector<PressedPlates> of_segments_;
  std::map<double, PressedPlates> near_;
};

}  // namespace boxbeam
