#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/point_stress.hpp"
#include "boxbeam/section/section.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/plate_materials.hpp"
#include "boxbeam/strength/section_use.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"

/// A box of four slender plates, judged by what of them works once they have buckled.
namespace boxbeam {

class Derivation;
class Traced;

/// One of the four plates between its neighbours.
struct BoxWall {
  Length low, high;  ///< ends of its clear width: y of a flange, z of a web
  Length middle;     ///< of its mid-line: z of a flange, y of a web
  Length thickness;
  Stress yield_strength;  ///< the least of its own and of its stiffeners'
  Stress class_strength;  ///< by which it buckles: of a web that of the stronger flange
  std::vector<FlatStiffener> stiffeners = {};  ///< on its inner face, by place
  StressLevel level = {};                      ///< at which it buckles, where it has no stiffeners

  Length clear() const { return high - low; }
};

/// Four plates around one cell: a box, or a rectangular tube.
struct FourWalls {
  AreaSums gross;
  std::array<BoxWall, 4> walls;  ///< by BoxPlate
  /// Between supports across all of them; nothing: so long that they do not help.
  std::optional<Length> length = {};

  const BoxWall& of(BoxPlate plate) const { return walls[static_cast<std::size_t>(plate)]; }
  BoxWall& of(BoxPlate plate) { return walls[static_cast<std::size_t>(plate)]; }
};

inline constexpr std::array box_plates{BoxPlate::top_flange, BoxPlate::bottom_flange,
                                       BoxPlate::left_web, BoxPlate::right_web};

const char* to_text(BoxPlate plate);  ///< "top flange", "left web", ...
bool is_flange(BoxPlate plate);       ///< else it is a web

/// A wall as a plate that buckles.
StiffenedPlate stiffened_plate_of(const BoxWall& wall, std::optional<Length> length);

/// The walls of a profile; nothing of one that has not four plates, or of which a plate is thicker
/// than its material's table goes. The length is left open.
std::optional<FourWalls> four_walls_of(const Profile& profile, const PlateMaterials& materials);

/// Normal stress at the ends of a plate's clear width.
struct PlateStress {
  Stress compression;  ///< at the end that is compressed more; 0 where none is
  Stress tension;      ///< likewise
  /// Smaller over larger stress, compression positive, at least -3, below which no buckling factor
  /// is given; 1 where nothing is compressed.
  double psi = 1.0;
  bool more_at_high = false;  ///< the end of the larger compression
};

/// The ends of a plate of a box, whose stress is that of a section.
class PlateEnds {
 public:
  PlateEnds(const FourWalls& box, BoxPlate plate, const AreaSums& section);
  PlateEnds(const StressInfluence& low, const StressInfluence& high) : low_(low), high_(high) {}
  PlateStress under(const CutForces& cut) const;
  const StressInfluence& at(bool high) const { return high ? high_ : low_; }
  /// Compression at the low and at the high end.
  std::array<Stress, 2> compression_under(const CutForces& cut) const;

 private:
  StressInfluence low_, high_;
};

/// What shear lag leaves of the widths of flanges, and of webs as the flanges of M_z, at the
/// ultimate limit state: beta^kappa >= beta. Source: EN 1993-1-5:2006, 3.3, note 3.
struct LagShares {
  double flanges = 1.0, webs = 1.0;
};

/// A plate in an effective section.
struct WallAlone {
  double psi = 1.0;      ///< smaller over larger edge stress, compression positive
  bool pressed = false;  ///< an edge is compressed; otherwise all of it works
  EffectiveWidth width;  ///< of its compressed width, where it is pressed and a bare plate
  /// Where it is pressed with stiffeners under compression.
  std::optional<StiffenedWidths> stiffened;
  Length idle;  ///< what of its width does not work, shear lag included; in mean over its thickness

  bool buckles() const { return pressed && (stiffened ? stiffened->reduced() : width.rho < 1.0); }
};

/// The section that is left where one cut force acts alone.
struct SectionAlone {
  std::array<WallAlone, 4> walls;  ///< by BoxPlate
  AreaSums sums;
  /// How often the stress distribution of the webs was taken from the section before; 1 is the
  /// standard's procedure.
  int passes = 1;

  const WallAlone& of(BoxPlate plate) const { return walls[static_cast<std::size_t>(plate)]; }
};

/// The effective section of a box where one cut force acts alone.
///
///     compression: all plates with psi = 1
///     moments:     the compressed flange with psi = 1, then the webs with the psi that the
///                  effective flanges and whole webs have (of M_z the webs are the flanges)
///
/// `most_passes`: 1 by the standard; more repeat the second step with the section found, until no
/// psi changes by more than 1e-10. Below psi = -3, where no buckling factor is given, that of -3
/// holds, on the safe side. Plates with stiffeners as `stiffened_widths`; shear lag takes evenly
/// from all of such a flange. Source: EN 1993-1-5:2006, 4.3 to 4.5.
SectionAlone section_alone(const FourWalls& box, ActingAlone acting, const LagShares& lag = {},
                           int most_passes = 1);

/// A corner of the box: where the mid-lines of a flange and a web meet.
struct BoxCorner {
  BoxPlate flange = BoxPlate::top_flange, web = BoxPlate::left_web;
};

/// A corner and how far it is used.
struct CornerUse : SectionUse {
  BoxCorner corner;
};

/// A box by its effective sections.
///
///     eta_1 = |N/A_eff + (M_y + N e_z)/W_y,eff + (M_z + N e_y)/W_z,eff|/f_y
///
/// at the corners, W the smaller one of bending about one axis by itself and of unsymmetric
/// bending, about the mid-lines of the plates (4.3(5)): each term of the section where it acts
/// alone, M by its sign, N in tension by the gross section. e is the shift of the centroid under N
/// alone; a shift that relieves does not count, nor that A_eff in place of A relieves a stretched
/// corner. N is taken at the gross centroid, whatever the beam axis. Where plates are of unlike
/// strength, the flange's holds for M_y, that of flange and web where M_z acts, and the least of
/// all where N compresses. Source: EN 1993-1-5:2006, 4.6, equation 4.15.
class EffectiveBox {
 public:
  explicit EffectiveBox(const FourWalls& box, const LagShares& lag = {}, int most_passes = 1);

  /// eta_1 of the corner that is used most.
  double use(const CutForces& cut) const;
  CornerUse worst_corner(const CutForces& cut) const;

  /// The same box, its plates buckling by the stress that they have where all these cut forces grow
  /// until the worst corner yields: then, too, the use is proportional to the forces. Found step by
  /// step from yield on; nothing where that does not settle. Source: EN 1993-1-5:2006, 4.4(4).
  std::optional<EffectiveBox> below_yield(const CutForces& cut, bool annex_E) const;

  const FourWalls& box() const { return box_; }
  const SectionAlone& alone(ActingAlone acting) const {
    return sections_[static_cast<std::size_t>(acting)];
  }
  /// Of the centroid under compression alone.
  Length shift_y() const { return centroid_.shift_y; }
  Length shift_z() const { return centroid_.shift_z; }

 private:
  struct Corner : EffectivePlace {
    BoxCorner of;
    Stress flange_strength, least_strength;
  };
  CornerUse use_of(const Corner& corner, const CutForces& cut, const Shifts& shifts) const;
  template <class Look>
  void look_at_corners(const CutForces& cut, const Look& look) const;
  /// The largest compression of each plate over what it buckles by, where the worst corner yields.
  std::array<double, 4> compressed_shares(const CutForces& cut) const;

  FourWalls box_;
  LagShares lag_;
  int most_passes_;
  std::array<SectionAlone, ways_of_acting> sections_;
  std::array<Corner, 4> corners_;
  EffectiveCentroid centroid_;
  Stress least_strength_;  ///< of all plates
};

/// The stress of the corner used most, step by step, from the plates on.
Traced derive_corner_stress(Derivation& steps, const EffectiveBox& box, const CutForces& cut,
                            const CornerUse& corner);

}  // namespace boxbeam
