#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/shear_lag.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The axis about which the beam bends: y in the plane of a planar motion; z only in space, where
/// the webs are flanges.
enum class BendingAxis { y, z };

/// A stretch of the beam between two places of zero moment about one axis, at the instant when that
/// moment is largest in a situation, or the part of it where that situation counts.
struct BendingZone {
  Length from, to;
  /// Length between zero moments, for shear lag; twice the stretch where the moment is largest at
  /// an end of the beam, as at a clamped one. A smaller moment there, from a couple, adds nothing:
  /// the stretch is a little shorter than it would be without, on the safe side.
  Length effective_length;
  BendingRegion region = BendingRegion::sagging;  ///< hogging where a force makes a peak inside
  BendingAxis axis = BendingAxis::y;
};

/// The stretches of the beam of M_y and behind them, in space, of M_z; none where it is never bent,
/// or the case leaves shear lag out. First, in order, those of the situation with the largest
/// moment, then those of all others where their moment, with its load factor, is above a tenth of
/// the largest there: stretches of several situations overlap, and the one that leaves least of a
/// plate counts. Source: EN 1993-1-5:2006, 3.2.1, figure 3.1 (lengths between zero moments).
std::vector<BendingZone> bending_zones_of(const Project& project,
                                          const std::deque<SituationRun>& runs);

/// What shear lag leaves of the flanges at a place.
struct ShearLag : WidePlate {  ///< b_0: half of the width between the middles of the webs
  double kappa = 0.0;
  double beta = 1.0;
  double flange_part = 1.0;  ///< of the clear width, see properties_of
};

/// Shear lag of a box or rectangular tube at a station, of its flanges (bending about y) or its
/// webs (about z); nothing where it does not count (b_0 below L_e/50, other profiles, no bending).
/// Source: EN 1993-1-5:2006, 3.1, 3.2.1.
std::optional<ShearLag> shear_lag_at(const std::vector<BendingZone>& zones, const Section& section,
                                     const Station& station, BendingAxis axis = BendingAxis::y);

/// Shear lag of a plate of any profile at a station, where the beam bends about an axis; nothing
/// where it does not count. `flange_part` is left open.
std::optional<ShearLag> plate_lag_at(const std::vector<BendingZone>& zones, const Station& station,
                                     BendingAxis axis, Length b_0, Length thickness,
                                     Area stiffeners = {});

/// What it leaves at the ultimate limit state, beta^kappa >= beta. Source: EN 1993-1-5:2006, 3.3,
/// note 3.
double ultimate_share_of(const ShearLag& lag);

/// The least of it that any situation leaves at a station, of a plate and of a section's flanges
/// (webs); not always where beta is least, for kappa stands in the exponent. One where it does not
/// count.
double ultimate_share_at(const std::vector<BendingZone>& zones, const Station& station,
                         BendingAxis axis, Length b_0, Length thickness, Area stiffeners = {});
double ultimate_share_at(const std::vector<BendingZone>& zones, const Section& section,
                         const Station& station, BendingAxis axis);

/// Shear lag of both bendings at a place. One effective section serves both: what is idle in the
/// flanges under M_y and what is idle in the webs under M_z is left out of it together. Each plate
/// is the web of the other bending and would there be whole, and either reduction alone lowers both
/// moments of inertia: normal stresses of N, M_y and M_z come out at least as large as by either.
/// Source: EN 1993-1-5:2006, 3.1, 3.2.1 (one bending); the combination is ours, on the safe side.
struct ShearLags {
  std::optional<ShearLag> flanges, webs;

  bool count() const { return flanges || webs; }
};

ShearLags shear_lags_at(const std::vector<BendingZone>& zones, const Section& section,
                        const Station& station);

/// The section that shear lag and holes leave for normal stress.
SectionProperties effective_properties_of(const Section& section, const std::vector<Hole>& holes,
                                          const ShearLags& lags);

}  // namespace boxbeam
