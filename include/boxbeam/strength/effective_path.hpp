#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/section/wall_graph.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/path_plates.hpp"
#include "boxbeam/strength/section_use.hpp"

/// A thin-walled path of slender plates, judged by what of them works once they have buckled.
namespace boxbeam {

/// A path as plates.
struct PathSection {
  AreaSums gross;
  WallGraph graph;
  std::vector<PathPlate> plates;
  /// By wall of the graph: its number in the path, what reaches beyond a node being part of it.
  std::vector<std::size_t> numbers;
  std::vector<Stress> yield_strengths;  ///< likewise
  /// Between supports across all of them; nothing: so long that they do not help.
  std::optional<Length> length = {};
  /// By plate: what shear lag leaves of its width where the beam bends about y and about z at the
  /// ultimate limit state, beta^kappa >= beta; empty: all of it. Source: EN 1993-1-5:2006, 3.3,
  /// note 3.
  std::vector<std::array<double, 2>> lag = {};
};

/// Nothing where a wall is thicker than its material's table goes. The length is left open.
std::optional<PathSection> path_section_of(const ThinWalled& path, const PlateMaterials& materials);

/// c/t above the limit of class 3 in even compression.
bool may_buckle(const PathPlate& plate);

/// A plate in an effective section.
struct PlateAlone {
  double psi = 1.0;           ///< smaller over larger edge stress, compression positive
  bool pressed = false;       ///< an edge is compressed; otherwise all of it works
  bool more_at_high = false;  ///< the end of the larger compression
  EffectiveWidth width;       ///< of its compressed width, where it is pressed
  double lag = 1.0;           ///< what shear lag leaves of the width that would work
  double idle_low = 0.0, idle_high = 0.0;  ///< what does not work, along the plate [m]

  double idle() const { return idle_high - idle_low; }
};

/// What of a plate works under compression at the ends of its clear width.
///
/// An outstand by table 4.2, with its largest compression at the tip or at its support; below psi =
/// -3 and -1, where no buckling factor is given, those hold, on the safe side. Others by table 4.1
/// as the plates of boxes. `strength`: by which it buckles. Source: EN 1993-1-5:2006, 4.4.
PlateAlone plate_alone(const PathPlate& plate, Stress strength, std::optional<Length> length,
                       double at_low, double at_high);

/// The section that is left where one cut force acts alone.
struct PathAlone {
  std::vector<PlateAlone> plates;
  AreaSums sums;
  int passes = 1;  ///< how often the stress was taken from the section before
  bool settled = true;
};

/// The effective section of a path where one cut force acts alone.
///
///     compression: all plates with psi = 1
///     moments:     plates along the axis of bending (within 45 degrees) with the psi of the whole
///                  section, then the others with that of the section then left: the standard's
///                  pass. More passes take both from the section before, until no psi changes by
///                  more than 1e-10.
///
/// What shear lag takes of plates along the axis of bending, it takes beside what does not work, or
/// in the middle of an internal plate and from the free end of an outstand on. `coupled`: by the
/// stress of unsymmetric bending in place of that of each axis by itself. Source: EN
/// 1993-1-5:2006, 4.3, 4.4.
PathAlone path_alone(const PathSection& path, ActingAlone acting, bool coupled = false,
                     int most_passes = 60);

/// A place of a path: a node, or a free end.
struct PathPlace {
  std::string name;  ///< "end of wall 3", "node of walls 1, 2, 5"
  double y = 0.0, z = 0.0;
};

struct PathUse : SectionUse {
  std::size_t place = 0;
};

/// A path by its effective sections, as `EffectiveBox` a box:
///
///     eta_1 = |N/A_eff + (M_y + N e_z)/W_y,eff + (M_z + N e_y)/W_z,eff|/f_y
///
/// at its nodes and free ends, on the mid-lines (4.3(5)). Where y and z are no principal axes, each
/// section is found by the stress of bending about its axis by itself and of unsymmetric bending,
/// the worse one counts, and the parts add up by their sizes, on the safe side. The strength is the
/// least of the walls that meet, under compression of all. Source: EN 1993-1-5:2006, 4.6, equation
/// 4.15.
class EffectivePath {
 public:
  explicit EffectivePath(const PathSection& path);

  double use(const CutForces& cut) const { return worst_place(cut).use; }
  PathUse worst_place(const CutForces& cut) const;

  /// As `EffectiveBox::below_yield`. Source: EN 1993-1-5:2006, 4.4(4), annex E.
  std::optional<EffectivePath> below_yield(const CutForces& cut, bool annex_E) const;

  const PathSection& path() const { return path_; }
  /// By bending about each axis by itself.
  const PathAlone& alone(ActingAlone acting) const {
    return sections_[static_cast<std::size_t>(acting)];
  }
  const std::vector<PathPlace>& places() const { return places_; }
  const EffectiveCentroid& centroid() const { return centroid_; }
  bool settled() const;
  /// The least of all places and senses.
  SectionModulus least_modulus(bool about_y) const;

 private:
  struct Place : EffectivePlace {
    Stress yield_strength;
    std::vector<std::size_t> plates;  ///< that meet there
  };

  template <class Look>
  void look_at_places(const CutForces& cut, const Look& look) const;
  /// By plate the largest compression over f_y where the worst place yields.
  std::vector<double> compressed_shares(const CutForces& cut) const;

  PathSection path_;
  std::array<PathAlone, ways_of_acting> sections_;
  std::vector<PathAlone> coupled_;  ///< of the moments, in their order; none of principal axes
  std::vector<PathPlace> places_;
  std::vector<Place> resist_;  ///< by place
  EffectiveCentroid centroid_;
  Stress least_strength_;
};

/// The stress of the place used most, step by step, from the plates on.
Traced derive_path_stress(Derivation& steps, const EffectivePath& path, const CutForces& cut,
                          const PathUse& use);

}  // namespace boxbeam
