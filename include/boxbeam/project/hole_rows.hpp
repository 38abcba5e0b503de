#pragma once

#include <optional>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// `holes_at` of these holes.
std::vector<Hole> holes_at(const std::vector<BeamHole>& holes, Length s);

/// What holes take out of the section at a station: `holes_at` and, on a side of a border or of a
/// jump of cut forces, those that reach over it, each as the chord that it takes there,
///
///     2 sqrt(d^2/4 - x^2),  x from its centre
///
/// Chords below a tenth of d are none. Source: geometry.
std::vector<Hole> holes_in_section(const Project& project, const Station& station);

/// A hole as a section cuts it.
struct CutHole {
  const BeamHole* of = nullptr;
  Hole hole;  ///< as wide as it counts
  /// None where that is less than half of it.
  std::optional<HoleCase> concentration;
};

/// Of these the holes that are judged there: of their own station, and those that reach over it.
std::vector<CutHole> holes_cut_at(const Project& project, const Station& station);

/// What stands between a hole and the next one along the beam in the same plates, the post: the
/// shear flow of its pitch s goes through what both leave of it,
///
///     q s/(t l),  l = s - d + p^2/(4 s), no less than the clear way from hole to hole
///
/// d the mean of both diameters, p the distance of their centres across the beam. Source: EN
/// 1993-1-1:2005, 6.2.6 on the section along the beam; 6.2.2.2(4) with both ways exchanged.
struct HolePost {
  const BeamHole* next = nullptr;
  Length pitch, left;  ///< s and l
  Length diameter;     ///< d
  bool faced = false;  ///< whether one place across the beam lies in both holes: the post bends

  double shear_raised() const { return pitch / left; }
  /// The largest stress on the edges of the post over the shear stress of the whole plate there: a
  /// beam from level to level, clamped in the plate, that q s bends,
  ///
  ///     sigma/(q/t) = max 6 s y/b(y)^2,  b = s - 2 sqrt(d^2/4 - y^2)
  ///
  /// Source: equilibrium of half of a post; SCI P355 (2011), web posts.
  double bending_per_shear() const;
};

/// The posts on either side of a hole, one for each other hole that leaves less than the pitch.
std::vector<HolePost> posts_beside(const Project& project, const BeamHole& at);

}  // namespace boxbeam
